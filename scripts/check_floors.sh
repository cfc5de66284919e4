#!/usr/bin/env bash
# check_floors.sh - a folder includes only floors strictly below it, and itself (see ARCHITECTURE.md).
# Usage: check_floors.sh [ROOT]. Prints each violation as file:line and exits with 1 if there is one.
set -euo pipefail
root=${1:-$(dirname "$0")/..}
cd "$root"

list_files()
{
    for folder in src include apps examples tests/consumer; do
        [ -d "$folder" ] || continue
        find "$folder" -type f \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' -o -name '*.inl' -o -name '*.glsl' \) -print0
    done | sort -z
}

[ -d src ] || { echo "check_floors.sh: no folder src in $root" >&2; exit 1; }
list_files | xargs -0 -r awk '
BEGIN {
    split("base:0 glsl:0 io:0 exact:1 scene:1 film:1 samples:2 readers:3 visibility:2 rays:2 hits:3 irregular:3 shade:4 shadow:4 cpu:5 gl:5 baseline:6 render:7", pairs, " ")
    for (k in pairs) { split(pairs[k], pair, ":"); floor_of[pair[1]] = pair[2] + 0 }
}
function complain(why) { printf "%s:%d: %s: %s\n", FILENAME, FNR, $0, why; bad = 1 }
FNR == 1 {
    split(FILENAME, path, "/")
    room = path[1] == "src" ? path[2] : ""
    if (room != "" && !(room in floor_of)) {
        printf "%s: the folder src/%s has no floor: give it one in scripts/check_floors.sh and ARCHITECTURE.md\n", FILENAME, room
        bad = 1
    }
}
/^[ \t]*#[ \t]*include[ \t]*["<]/ {
    name = $0
    sub(/^[ \t]*#[ \t]*include[ \t]*/, "", name)
    quoted = substr(name, 1, 1) == "\""
    name = substr(name, 2)
    sub(/[">].*/, "", name)
    target = name
    sub(/\/.*/, "", target)
    if (name ~ /(^|\/)\.\.(\/|$)/ || name ~ /^\//) { complain("no path leads upwards or from the root"); next }
    if (path[1] == "src" && (room in floor_of)) {
        if (target == "firsthit") next
        if (target in floor_of) {
            if (target != room && floor_of[target] >= floor_of[room])
                complain(target " (floor " floor_of[target] ") is not below " room " (floor " floor_of[room] ")")
            if (!quoted) complain("a private header is included in quotes")
        } else if (quoted) complain("a private header is named from src/")
        next
    }
    # The others see the public headers only. An app also includes its own files, by their plain names or
    # as bench/....
    if (target in floor_of) { complain("only <firsthit/...> is seen from here"); next }
    if (quoted && !(path[1] == "apps" && (index(name, "/") == 0 || target ~ /^(bench|common|options)$/))) complain("only <firsthit/...> is seen from here")
}
END { exit bad }
' && echo "floors: every include goes down"
