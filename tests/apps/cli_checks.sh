# cli_checks.sh - what tests of the program share: a folder of their own, checks, and a count of failures. Sourced, with
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

: >stdout
: >stderr

# expect CODE PATTERN ARGUMENT... : runs the program; that exit code, and the pattern (none where it is empty) in what it
# prints. An error begins with the program's name.
expect()
{
    local code=$1 pattern=$2 actual=0
    shift 2
    timeout 300 "$program" "$@" >stdout 2>stderr </dev/null || actual=$?
    checks=$((checks + 1))
    [ "$actual" -eq "$code" ] || fail "firsthit $*: exit code $actual, not $code: $(head -c 300 stderr)"
    [ -z "$pattern" ] || grep -qE -- "$pattern" stdout stderr || \
        fail "firsthit $*: no '$pattern' in: $(head -c 300 stdout stderr)"
    if [ "$code" -ne 0 ] && [ "$code" -lt 100 ] && [ -s stderr ]; then
        head -n 1 stderr | grep -q '^firsthit: ' || fail "firsthit $*: an error without 'firsthit: '"
    fi
}

# writes ARGUMENT... : exit code 0.
writes() { expect 0 "" "$@"; }

# What is in the folder: names, kinds, modes, links and contents.
state()
{
    find . ! -name stdout ! -name stderr -printf '%P %y %m %l\n' | sort
    find . -type f ! -name stdout ! -name stderr -exec md5sum {} + | sort
}

# refuses CODE PATTERN ARGUMENT... : that exit code, the message, and no file that appeared or changed.
refuses()
{
    local before
    before=$(state)
    expect "$@"
    shift 2
    [ "$(state)" = "$before" ] || fail "firsthit $*: files changed: $(diff <(echo "$before") <(state))"
}

# same FILE FILE [WHAT] : equal bytes.
same()
{
    checks=$((checks + 1))
    cmp -s "$1" "$2" || fail "$1 and $2 differ${3:+: $3}"
}

# starts FILE HEX : the file's first bytes.
starts()
{
    checks=$((checks + 1))
    [ "$(od -An -tx1 -N $((${#2} / 2)) "$1" | tr -d ' \n')" = "$2" ] || fail "$1 does not start with $2"
}

# npy FILE TYPE SHAPE HEX : a file of NumPy.
npy()
{
    local header="{'descr': '$2', 'fortran_order': False, 'shape': $3, }"
    { printf '\x93NUMPY\x01\x00%b' "\\x$(printf %02x $((${#header} + 1)))\\x00"
      printf '%s\n' "$header"; printf '%b' "$(printf %s "$4" | sed 's/../\\x&/g')"; } >"$1"
}
