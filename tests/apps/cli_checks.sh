# cli_checks.sh - what tests of the program share: a folder of their own, and a count of failures. Sourced, with
# the program as $1.
set -uo pipefail
program=$(realpath "$1")
scripts=$(realpath "$(dirname "$0")")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
checks=0
failures=0

fail()
{
    echo "FAILED: $1"
    failures=$((failures + 1))
}
