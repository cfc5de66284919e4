#!/usr/bin/env bash
# package_test.sh - the Debian package, installed into a root that has nothing but Debian: it runs there. Skipped (exit code 77) where cpack, debootstrap, Debian's archive or the
# rights to change the root are missing.
# Usage: package_test.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")

skip()
{
    echo "skipped: $1"
    exit 77
}

for program in cpack dpkg-deb dpkg-shlibdeps debootstrap chroot; do
    command -v $program >/dev/null || skip "there is no $program"
done
[ "$(id -u)" -eq 0 ] || skip "only root can install into another root"
grep -q '^VERSION_CODENAME=bookworm' /etc/os-release || skip "the package is of Debian 12, and this is another system"

work=$(mktemp -d)
cleanup()
{
    rm -rf --one-file-system "$work"
}
trap cleanup EXIT
cd "$work"
(cd "$build" && cpack -G DEB -B "$work/packages" >"$work/cpack.log" 2>&1) || { tail "$work/cpack.log"; exit 1; }
program=$(ls packages/firsthit_*.deb)
development=$(ls packages/libfirsthit-dev_*.deb)

# What the packages say and have.
dpkg-deb -f "$program" Depends | tee depends
grep -q 'libc6' depends
grep -q 'libopenexr' depends
dpkg-deb -c "$program" >files
for file in usr/bin/firsthit usr/share/man/man1/firsthit.1 usr/share/bash-completion/completions/firsthit \
    usr/share/zsh/vendor-completions/_firsthit usr/share/fish/vendor_completions.d/firsthit.fish; do
    grep -q "\./$file" files || { echo "FAILED: the package has no $file"; exit 1; }
done
dpkg-deb -c "$development" >files
for file in usr/include/firsthit/render.h usr/lib/.*pkgconfig/firsthit.pc usr/lib/.*firsthit-config.cmake; do
    grep -q "\./$file" files || { echo "FAILED: the package has no $file"; exit 1; }
done
if grep -q usr/bin files; then echo "FAILED: the program is in both packages"; exit 1; fi

# A bare Debian, and the program in it.
mirror=$(cat /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | \
    sed -n 's/^\(deb\|URIs:\) *\(\[[^]]*\] *\)\?\(http[^ ]*\).*/\3/p' | grep -v security | head -n 1 || true)
debootstrap --variant=minbase bookworm root "${mirror:-http://deb.debian.org/debian}" >debootstrap.log 2>&1 || {
    tail -n 3 debootstrap.log
    skip "debootstrap cannot make a root here"
}
cp "$program" root/tmp/
cp /etc/resolv.conf root/etc/ 2>/dev/null || true
cp -r /etc/apt/apt.conf.d/. root/etc/apt/apt.conf.d/ 2>/dev/null || true
# What the program needs is not in a bare root: apt finds it by the package's dependencies.
chroot root apt-get update -q >apt.log 2>&1 || { tail -n 3 apt.log; skip "Debian's archive cannot be reached"; }
chroot root env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends \
    "/tmp/$(basename "$program")" >apt.log 2>&1 || { tail apt.log; echo "FAILED: it cannot be installed"; exit 1; }
chroot root firsthit --version
chroot root firsthit render builtin:torus -o /tmp/torus.png --size 64x64
[ "$(od -An -tx1 -N 4 root/tmp/torus.png | tr -d ' ')" = 89504e47 ]
"$build/bin/firsthit" render builtin:torus -o here.png --size 64x64
cmp here.png root/tmp/torus.png
chroot root firsthit mask builtin:robots -o /tmp/masks.json --size 64x64
chroot root firsthit render builtin:torus -o /tmp/a.mp4 --turntable 2 2>error && { echo "FAILED: a film without ffmpeg"; exit 1; }
grep -q 'apt-get install ffmpeg' error
chroot root dpkg -r firsthit >/dev/null
if [ -e root/usr/bin/firsthit ]; then echo "FAILED: what is removed stays"; exit 1; fi
echo "the package installs and runs in a bare Debian"
