#!/usr/bin/env bash
# option_reference.sh - writes docs/options.md, all options of all commands, from what the program itself says.
# Usage: option_reference.sh PROGRAM [--check]
#   --check  writes nothing; exits with 1, and shows the difference, where the file is not what the program says
set -euo pipefail
[ $# -ge 1 ] || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
program=$1
file=$(dirname "$0")/../docs/options.md

reference()
{
    echo "# All options"
    echo
    echo "Made from the program's own help by \`scripts/option_reference.sh\`. What the options are for, with examples:"
    echo "[command line](command_line.md)."
    local command
    for command in $("$program" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z][a-z]*\) .*/\1/p'); do
        [ "$command" != help ] || continue
        printf '\n## %s\n\n```\n' "$command"
        env -u FIRSTHIT_ISA NO_COLOR=1 "$program" "$command" --help-all </dev/null | sed 's/ *$//'
        printf '```\n'
    done
}

if [ "${2:-}" = --check ]; then
    diff -u "$file" <(reference) || {
        echo "docs/options.md is not what the program says: run scripts/option_reference.sh $program" >&2
        exit 1
    }
else
    text=$(reference)
    printf '%s\n' "$text" >"$file"
fi
