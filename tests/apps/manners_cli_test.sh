#!/usr/bin/env bash
# manners_cli_test.sh - help, suggestions, what is said and what not, and ends of pipes that are closed.
# Usage: manners_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# in_terminal COLUMNS ARGUMENT... : what the program writes to a terminal of that width, into the file `seen`.
in_terminal()
{
    local columns=$1
    shift
    TERM=xterm timeout 120 script -qec "stty cols $columns rows 50; $program $*" /dev/null >seen </dev/null
}

# --- help -----------------------------------------------------------------------------------------
for command in render info mask visible compare occlusion bench; do
    expect 0 "Usage: firsthit $command" $command --help
    [ "$(wc -l <stdout)" -le 50 ] || fail "firsthit $command --help has $(wc -l <stdout) lines"
    [ "$(wc -L <stdout)" -le 80 ] || fail "firsthit $command --help is $(wc -L <stdout) columns wide"
    [ "$(grep -n '^Examples' stdout | cut -d: -f1)" -lt "$(grep -n '^Options' stdout | cut -d: -f1)" ] || \
        fail "firsthit $command --help does not begin with examples"
    cp stdout page
    expect 0 '' help $command
    cmp -s page stdout || fail "firsthit help $command is not its --help"
    expect 0 'Exit codes' $command --help-all
    [ "$(wc -l <stdout)" -gt "$(wc -l <page)" ] || fail "firsthit $command --help-all is not more"
done
expect 0 'Commands:' help
expect 0 'Commands:' --help
expect 2 'did you mean render' help rendr
if grep -qE '^  (completion|man) ' stdout; then fail "hidden commands are shown"; fi
expect 0 '^firsthit [0-9]+\.[0-9]+\.[0-9]+$' -V
expect 0 '^firsthit [0-9]+\.[0-9]+\.[0-9]+$' --version

# Every example of the first screens is accepted.
for command in render info mask visible compare occlusion bench; do
    "$program" $command --help | sed -n '/^Examples/,/^Options/s/^  firsthit //p' | sed 's/ > .*//' | \
        while read -r line; do
            # shellcheck disable=SC2086 # words
            timeout 60 "$program" $line --nonsense >stdout 2>stderr </dev/null
            grep -q -- 'not expected: --nonsense' stderr || echo "$line: $(head -n 1 stderr)"
        done >wrong
    checks=$((checks + 1))
    [ ! -s wrong ] || fail "examples that are not accepted: $(cat wrong)"
done

# --- did you mean -----------------------------------------------------------------------------------
expect 2 'there is no command .rendr.; did you mean render\?' rendr builtin:torus
expect 2 'did you mean --size\?' render builtin:torus -o a.png --siez 8x8
expect 2 'did you mean --size\?' render builtin:torus -o a.png --width 8
expect 2 'did you mean --turntable\?' render builtin:torus -o a.png --turn 8
expect 2 'not expected: --xyzzy$' render builtin:torus -o a.png --xyzzy
[ ! -e a.png ] || fail "wrong usage writes a file"

# --- what is said ------------------------------------------------------------------------------------
expect 0 'warning: .*nothing moves' render builtin:torus --size 8x8 --frames 0:1:2 -o a_%d.png
expect 0 '' render builtin:torus --size 8x8 --frames 0:1:2 -o a_%d.png --quiet
[ ! -s stderr ] || fail "--quiet says: $(cat stderr)"
expect 0 '' --quiet render builtin:torus --size 8x8 --frames 0:1:2 -o a_%d.png
[ ! -s stderr ] || fail "--quiet before the command says: $(cat stderr)"
expect 0 'firsthit: writes a.png' render builtin:torus --size 8x8 -o a.png --verbose
expect 0 'read builtin:torus: 1024 triangles' render builtin:torus --size 8x8 -o a.png -v
[ ! -s stdout ] || fail "--verbose says something on standard output"
expect 2 'excludes' render builtin:torus -o a.png -v -q
expect 0 'triangles' render builtin:torus --size 8x8 --stats
if grep -qE ' +0(\.00)?$' stdout; then fail "rows of zeros: $(grep -E ' +0(\.00)?$' stdout)"; fi
if grep -q $'\033' stdout stderr; then fail "colours in a pipe"; fi

# On a terminal.
if command -v script >/dev/null && command -v stty >/dev/null; then
    in_terminal 60 render --help
    [ "$(tr -d '\r' <seen | grep -v '^  firsthit ' | wc -L)" -le 60 ] || fail "help is wider than the terminal of 60 columns"
    grep -q 'Usage' seen || fail "no help on a terminal: $(head -c 300 seen)"
    in_terminal 80 render none.obj -o a.png
    grep -q $'\033\\[1;31mfirsthit:' seen || fail "no colour for an error on a terminal"
    NO_COLOR=1 in_terminal 80 render none.obj -o a.png
    if grep -q $'\033\\[1' seen; then fail "NO_COLOR is not respected"; fi
    in_terminal 80 render builtin:robots --size 200x200 --frames 0:1:30 -o f_%02d.png
    grep -q 'a second, [0-9:]* s left' seen || fail "no speed and time left on a terminal: $(head -c 600 seen)"
    in_terminal 80 render builtin:robots --size 100x100 --frames 0:1:9 -o f_%02d.png --quiet
    if grep -q 'frames \[' seen; then fail "a bar in spite of --quiet"; fi
else
    echo "skipped: 5 checks of terminals, as script is not here"
fi

# --- closed pipes --------------------------------------------------------------------------------------
# Nobody reads: the end is that of any program whose pipe is closed, and it says nothing.
closed()
{
    local code
    ( exec 3> >(exec 3>&-; exec true); sleep 0.3; timeout 120 "$program" "$@" >&3 2>stderr; echo $? >code )
    code=$(cat code)
    checks=$((checks + 1))
    [ "$code" -eq 141 ] || fail "firsthit $* into a closed pipe: exit code $code"
    [ ! -s stderr ] || fail "firsthit $* into a closed pipe says: $(cat stderr)"
    if find . -name '.firsthit-*' | grep -q .; then fail "firsthit $* into a closed pipe leaves a file"; fi
}
closed info builtin:robots --json
closed --help
closed visible builtin:robots --size 64x64
closed mask builtin:robots --size 64x64 -o -
# Standard error is closed: the work goes on.
"$program" render builtin:torus --size 8x8 --frames 0:1:2 -o e_%d.png --verbose 2> >(exec true)
[ -s e_1.png ] || fail "a closed standard error ends the work"

# --- completions and the manual ---------------------------------------------------------------------------
expect 0 'complete -F _firsthit firsthit' completion bash
bash -n stdout || fail "the completion for bash is no script of bash"
complete_words()
{
    bash -c 'source ./stdout; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=()
        _firsthit firsthit "${COMP_WORDS[COMP_CWORD]}" "${COMP_WORDS[COMP_CWORD-1]}" 2>/dev/null
        echo "${COMPREPLY[*]}"' completion firsthit "$@"
}
[ "$(complete_words ren)" = render ] || fail "completes ren to '$(complete_words ren)'"
case " $(complete_words render x.obj --s) " in
    *" --size "*" --samples "* | *" --samples "*" --size "*) ;;
    *) fail "completes --s to '$(complete_words render x.obj --s)'" ;;
esac
[ "$(complete_words render x.obj --engine hy)" = hybrid ] || fail "completes no values of --engine"
[ "$(complete_words render x.obj --aov dep)" = depth= ] || fail "completes no planes"
case " $(complete_words render '') " in *" page "*) ;; *) fail "completes no files" ;; esac
for shell in zsh fish; do
    expect 0 'firsthit' completion $shell
    if command -v $shell >/dev/null; then $shell -n stdout || fail "the completion for $shell is no script of it"; fi
done
expect 2 'bash, zsh and fish' completion tcsh
expect 0 '^\.TH FIRSTHIT 1' man
if command -v man >/dev/null; then
    man --warnings -E UTF-8 -l -Tutf8 ./stdout 2>wrong | sed 's/\x1b\[[0-9;]*m//g; s/.\x08//g' >page
    [ ! -s wrong ] || fail "the manual: $(head -n 3 wrong)"
    grep -q 'EXIT STATUS' page || fail "the manual is not whole"
fi

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
