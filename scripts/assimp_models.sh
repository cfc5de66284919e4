#!/usr/bin/env bash
# assimp_models.sh - what becomes of the FBX, COLLADA, 3MF and OFF files of Debian's assimp-testmodels, as a table.
# Usage: assimp_models.sh [PROGRAM] > docs/assimp_models.md. Needs the package: apt-get install assimp-testmodels
set -euo pipefail
cd -- "$(dirname -- "$0")/.."
program=$(realpath "${1:-build/release/bin/firsthit}")
models=/usr/share/assimp/models
[ -d "$models" ] || { echo "assimp_models.sh: apt-get install assimp-testmodels" >&2; exit 1; }
warnings=$(mktemp)
trap 'rm -f "$warnings"' EXIT

# number LINE-NAME TEXT : the number of a line of `firsthit info`.
number()
{
    sed -n "s/^$1 *\([0-9]*\).*/\1/p" <<<"$2" | head -n 1
}

cat <<HEAD
# Assimp's test models

What \`firsthit info\` says of the files of the Debian package assimp-testmodels that end in \`.fbx\`, \`.dae\`, \`.3mf\` and
\`.off\`, below \`$models\`. Written by \`scripts/assimp_models.sh\`. A file that is refused has its reason.

| file | triangles | vertices | clips | warnings | |
|---|---:|---:|---:|---:|---|
HEAD
cd "$models"
find . -iregex '.*\.\(fbx\|dae\|3mf\|off\)' -printf '%P\n' | LC_ALL=C sort | while read -r file; do
    if text=$(timeout 60 "$program" info "$file" 2>"$warnings"); then
        printf '| %s | %s | %s | %s | %s | |\n' "$file" "$(number triangles "$text")" \
            "$(number vertices "$text")" "$(number clips "$text")" "$(number warnings "$text")"
    else
        reason=$(head -n 1 "$warnings")
        printf "| %s | | | | | %s |\n" "$file" "$(sed "s|^:\([0-9]*\): |line \1: |; s|^: *||" <<<"${reason#firsthit: "$file"}")"
    fi
done
