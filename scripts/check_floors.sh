#!/usr/bin/env bash
# check_floors.sh - a folder includes only floors strictly below it, and itself (see ARCHITECTURE.md).
# Of the public headers, floors below render/ see data (scenes, films, ...) and options, and the engines the
# settings as a whole; the classes that users call are above them. Shaders name the texts that they include by
# file name alone.
# Usage: check_floors.sh [ROOT]. Prints each violation as file:line and exits with 1 if there is one.
set -euo pipefail
root=${1:-$(dirname "$0")/..}
cd "$root"

list_files()
{
    for folder in src include apps examples tests/consumer; do
        [ -d "$folder" ] || continue
        find "$folder" -type f \( -name '*.h' -o -name '*.hpp' -o -name '*.cpp' -o -name '*.inl' \
            -o -name '*.glsl' -o -name '*.vert' -o -name '*.frag' -o -name '*.geom' -o -name '*.comp' \) -print0
    done | sort -z
}

[ -d src ] || { echo "check_floors.sh: no folder src in $root" >&2; exit 1; }
list_files | xargs -0 -r awk '
BEGIN {
    split("base:0 glsl:0 io:0 exact:1 scene:1 film:1 frame:1 samples:2 readers:3 visibility:2 rays:2 hits:3 irregular:3 material:3 shade:4 shadow:4 cpu:5 gl:5 baseline:6 render:7", pairs, " ")
    for (k in pairs) { split(pairs[k], pair, ":"); floor_of[pair[1]] = pair[2] + 0 }
    split("animation camera_file environment error file file_pattern film film_data framing frame_control ground join light material mesh normals npy npz picture ray scene scene_builder sequence stats sun texture view world", names, " ")
    for (k in names) is_data["firsthit/" names[k] ".h"] = 1
    text_room["models.glsl"] = "material" # made when the program runs, from src/material/models.h
    for (k = 1; k < ARGC; ++k) {
        if (!is_shader(ARGV[k])) continue
        n = split(ARGV[k], path, "/")
        if (path[n] in text_room) {
            printf "%s: there is another shader text of that name in %s\n", ARGV[k], text_file[path[n]]
            bad = 1
        }
        text_room[path[n]] = path[1] == "src" ? path[2] : ""
        text_file[path[n]] = ARGV[k]
    }
}
function is_shader(file) { return file ~ /\.(glsl|vert|frag|geom|comp)$/ }
function is_option(name) { return name ~ /^firsthit\/options\/[^\/]+$/ }
function check_floor(target)
{
    if (target != room && floor_of[target] >= floor_of[room])
        complain(target " (floor " floor_of[target] ") is not below " room " (floor " floor_of[room] ")")
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
    if (is_shader(FILENAME)) {
        # A text is found by its file name, also where it is included with its folder, as C++ needs it.
        sub(/.*\//, "", name)
        if (!(name in text_room)) complain("no shader text has this name")
        else if (!(text_room[name] in floor_of)) complain("this text is not in src/")
        else check_floor(text_room[name])
        next
    }
    if (path[1] == "src" && (room in floor_of)) {
        if (target == "firsthit") {
            if (room == "render" || name in is_data || is_option(name)) next
            if (name == "firsthit/settings.h" && floor_of[room] >= floor_of["cpu"]) next
            complain(name == "firsthit/settings.h" ? "below the engines only options are seen" : "below render only data and options are seen")
            next
        }
        if (target in floor_of) {
            check_floor(target)
            if (!quoted) complain("a private header is included in quotes")
        } else if (quoted) complain("a private header is named from src/")
        next
    }
    # Data is made of data, options of options and data.
    if (path[1] == "include" && target == "firsthit" && !(name in is_data)) {
        own = substr(FILENAME, length("include/") + 1)
        if (own in is_data) { complain("a header of data sees only such"); next }
        if (is_option(own) && !is_option(name)) { complain("a header of options sees only options and data"); next }
    }
    # The others see the public headers only. An app also includes its own files, by their plain names or
    # as bench/....
    if (target in floor_of) { complain("only <firsthit/...> is seen from here"); next }
    if (quoted && !(path[1] == "apps" && (index(name, "/") == 0 || target ~ /^(bench|common|films|help|inputs|masks|options|outputs|view)$/))) complain("only <firsthit/...> is seen from here")
}
END { exit bad }
' && echo "floors: every include goes down"
