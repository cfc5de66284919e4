#!/usr/bin/env bash
# performance_tables.sh - measures frames beside Embree's and writes the tables as Markdown.
# Usage: performance_tables.sh PROGRAM [-o FILE] [OPTION OF `firsthit bench --baseline`]...
# FILE is docs/performance_tables.md by default; - is standard output. Takes ten minutes (an hour with --full, seconds with
# --quick, whose numbers say nothing and never replace the default file). Needs Python 3.
set -euo pipefail
usage="usage: performance_tables.sh PROGRAM [-o FILE] [OPTION OF firsthit bench --baseline]..."
program=$(realpath -- "${1:?$usage}")
shift
root=$(cd -- "$(dirname -- "$0")/.." && pwd)
output=$root/docs/performance_tables.md
if [ "${1:-}" = -o ]; then
    output=${2:?$usage}
    shift 2
elif [[ " $* " == *" --quick "* ]]; then
    echo "performance_tables.sh: with --quick, say where to write: -o FILE" >&2
    exit 2
fi

# The command without folders of this machine.
command="firsthit bench --baseline --json bench.json"
for word in "$@"; do
    case $word in */*) command+=" ${word##*/}" ;; *) command+=" $word" ;; esac
done

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$program" bench --baseline "$@" --json "$folder/bench.json" >/dev/null
python3 "$root/tools/markdown_tables.py" "$folder/bench.json" --command "$command" >"$folder/tables.md"
if [ "$output" = - ]; then cat "$folder/tables.md"; else cp -- "$folder/tables.md" "$output"; fi
