#!/usr/bin/env bash
# check_format.sh - every C++ file is formatted as .clang-format says. With --fix, formats them.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

formatter=${CLANG_FORMAT:-clang-format-14}
command -v "$formatter" >/dev/null || {
    echo "check_format.sh: $formatter is missing: apt-get install clang-format-14" >&2
    exit 1
}
case "${1:-}" in
    "") mode=(--dry-run --Werror) ;;
    --fix) mode=(-i) ;;
    *) echo "usage: check_format.sh [--fix]" >&2; exit 2 ;;
esac
for folder in src include apps tests bench examples python; do
    [ ! -d "$folder" ] || find "$folder" -type f \( -name '*.h' -o -name '*.cpp' \) -print0
done | xargs -0 -r -n 32 "$formatter" --style=file "${mode[@]}" || {
    echo "check_format.sh: run scripts/check_format.sh --fix" >&2
    exit 1
}
echo "format: as it should be"
