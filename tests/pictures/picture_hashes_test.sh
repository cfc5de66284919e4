#!/usr/bin/env bash
# picture_hashes_test.sh - planes of the built-in scenes have the bits that they have always had.
# Usage: picture_hashes_test.sh PROGRAM SOURCE_FOLDER. A change that alters them on purpose writes the file anew:
# scripts/picture_hashes.sh PROGRAM exact > tests/pictures/exact_hashes.txt
set -euo pipefail
found=$("$2/scripts/picture_hashes.sh" "$1" exact)
[ "$(wc -l <<<"$found")" -gt 40 ] || { echo "too few hashes: $found"; exit 1; }
diff <(echo "$found") "$2/tests/pictures/exact_hashes.txt" && echo "every plane has its bits"
