#!/usr/bin/env bash
# bench_cli_test.sh - `firsthit bench` as a user meets it. Usage: bench_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# expect_files NAME... : exactly these beside what expect() writes, and removes them.
expect_files()
{
    local found
    found=$(find . -mindepth 1 ! -name stdout ! -name stderr -type f -printf '%P\n' | sort | tr '\n' ' ')
    checks=$((checks + 1))
    [ "$found" = "${*:+$* }" ] || fail "files: '$found', not '$*'"
    find . -mindepth 1 ! -name stdout ! -name stderr -delete
}

# with_python SCRIPT FILE : Python's own readers.
with_python()
{
    checks=$((checks + 1))
    python3 -c "$1" "$2" >python.log 2>&1 || fail "$2: $(tail -n 1 python.log)"
    rm -f python.log
}

# expect_page FILE : well-formed, and needs nothing beside itself; the one address is the name of SVG's elements.
expect_page()
{
    with_python 'import sys, xml.dom.minidom; xml.dom.minidom.parse(sys.argv[1])' "$1"
    checks=$((checks + 1))
    sed 's|xmlns="http://www.w3.org/2000/svg"||g' "$1" |
        grep -oE 'http|<script|<link|url\(|src="[^d].{20}| is missing\)' >needs && fail "$1 needs: $(head -n 1 needs)"
    rm -f needs
}

quick=(--quick --size 48x32 --scenes 'no & <where>')

expect 0 'Robert and Schoepke' bench --help
expect 2 'nothing is asked for: say --paper, --baseline or both' bench
expect 2 'Run firsthit bench --help' bench --paper --fast
expect 2 '--rounds' bench --paper --rounds 0
expect 1 'nothing/Robot.aff: cannot be read' bench --paper --bart nothing/Robot.aff
expect 1 'x.json' bench --paper --json nothing/x.json
: >file
expect 1 'is no folder' bench --paper -o file
expect 1 'is no folder' bench --paper -o file/below
expect_files file
echo x >broken.aff
for mode in --paper --baseline; do
    expect 1 'broken.aff:2:' bench "$mode" "${quick[@]}" --bart broken.aff -o new/deep
    checks=$((checks + 1))
    [ ! -e new ] || fail "bench $mode leaves an empty folder behind"
    mkdir -p old
    expect 1 'broken.aff:2:' bench "$mode" "${quick[@]}" --bart broken.aff -o old/deep
    checks=$((checks + 1))
    [ -d old ] && [ ! -e old/deep ] || fail "bench $mode removes a folder that was there, or leaves its own"
done
expect_files broken.aff

expect 0 'The page is out/deep/index.html' bench --paper "${quick[@]}" -o out/deep/
grep -q 'Table 4' stdout || fail "the tables are not printed"
grep -q 'no & <where>/bunny.stl is missing' stdout || fail "the missing bunny is not told"
[ ! -s stderr ] || fail "a run that goes well prints on stderr: $(head -c 300 stderr)"
with_python 'import json, sys; json.load(open(sys.argv[1]))["paper"]["table4"]' out/deep/bench.json
expect_page out/deep/index.html
checks=$((checks + 1))
for figure in 2 4 7 8 9 10; do
    grep -q "Figure $figure" out/deep/index.html || fail "the page has no figure $figure"
done
# Figure 10 is of the bunny, which is missing; 4 needs OpenGL.
find out -name 'figure4-[12].png' -delete
expect_files out/deep/bench.json out/deep/figure2-1.png out/deep/figure2-2.png out/deep/figure7-1.png \
    out/deep/figure7-2.png out/deep/index.html out/deep/scenes-1.png out/deep/scenes-2.png

# Without Python everything but the page is there, and the page can be drawn later.
mkdir none
code=0
timeout 300 env PATH="$folder/none" "$program" bench --paper "${quick[@]}" -o out >stdout 2>stderr || code=$?
checks=$((checks + 1))
[ "$code" -eq 0 ] || fail "without Python: exit code $code"
grep -q 'Table 4' stdout || fail "without Python the tables are not printed"
grep -q 'The page is' stdout && fail "without Python a page is promised"
[ "$(grep -c . stderr)" -eq 1 ] &&
    grep -q 'warning: out/index.html is not written (python3: .*run python3 out/report.py out/bench.json$' stderr ||
    fail "without Python: $(head -c 300 stderr)"
[ -e out/bench.json ] && [ ! -e out/index.html ] || fail "without Python: $(ls out)"
python3 -I out/report.py out/bench.json 2>python.log || fail "report.py: $(cat python.log)"
expect_page out/index.html
find . -mindepth 1 -delete

# JSON alone makes no page; without OpenGL the reason takes the numbers' place.
export __EGL_VENDOR_LIBRARY_DIRS=/nonexistent
expect 0 '"unavailable": ".*OpenGL' bench --paper "${quick[@]}" --json -
unset __EGL_VENDOR_LIBRARY_DIRS
with_python 'import json, sys; json.load(open(sys.argv[1]))["paper"]["table4"]' stdout
expect_files

# Beside Embree.
expect 0 'Asked and measured' bench --baseline "${quick[@]}" -o baseline
grep -q "Whole frames, milliseconds: 48x32, 1 thread" stdout || fail "no table of frames is printed"
with_python 'import json, sys
for row in json.load(open(sys.argv[1]))["baseline"]["rows"]:
    if row["threads"] == 1 and "embree_unavailable" not in row:
        assert row["pictures"]["exact"]["pixels"] == 48 * 32' baseline/bench.json
expect_page baseline/index.html
expect_files baseline/bench.json baseline/index.html

# Stopped in the middle, no half page is left.
"$program" bench --paper --size 512x512 --scenes nowhere -o out >stdout 2>stderr &
child=$!
sleep 2
kill -TERM "$child" 2>/dev/null
wait "$child" 2>/dev/null && fail "a bench that is stopped exits with 0"
expect_files

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
