#!/usr/bin/env bash
# film_cli_test.sh - films and numbered pictures: what ffmpeg makes of them, what goes wrong with it, and frames that
# are there already. Usage: film_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"

# nothing_left NAME : neither the film nor a part of it.
nothing_left()
{
    checks=$((checks + 1))
    [ ! -e "$1" ] || fail "$1 is there"
    if find . -name '.firsthit-*' | grep -q .; then fail "a part of $1 is left"; fi
}

small=(builtin:torus --size 32x24)

# --- which frames -------------------------------------------------------------------------------
expect 0 '' render builtin:robots --size 8x8 --frames 4-6 -o n_%02d.png
for number in 04 05 06; do [ -s n_$number.png ] || fail "no n_$number.png"; done
expect 0 '' render builtin:robots --size 8x8 --time 0.25 -o one.png # frame 6 of 24 a second
cmp -s one.png n_06.png || fail "frame 6 is another one than at its time"
expect 0 '' render builtin:robots --size 8x8 --frames 3 --fps 12 -o n_%02d.png
cmp -s one.png n_03.png || fail "frame 3 of 12 a second is another one than at its time"
expect 0 '301 frames, 0 s to 10 s' render builtin:robots --frames clip -o n_%03d.png --dry-run
expect 0 '11 frames, 0 s to 10 s' render builtin:robots --frames clip --fps 1 -o n_%03d.png --dry-run
[ ! -e n_000.png ] || fail "a dry run writes a file"
for value in 5-3 1- -1 1,,2 0-1000000 1.5 Clip; do
    expect 2 "no choice of frames" render "${small[@]}" "--frames=$value" -o n_%d.png
done
expect 2 '--fps is of numbered files' render "${small[@]}" --fps 5 -o a.png
expect 1 "folder 'none' does not exist" render "${small[@]}" --frames clip -o none/n_%d.png

# --- what is there already ----------------------------------------------------------------------
rm -f n_*.png
expect 0 '' render builtin:robots --size 8x8 --frames 0-4 -o n_%02d.png --aov motion=m_%02d.npy
mkdir all
cp n_*.png m_*.npy all
rm n_02.png m_04.npy
printf x >n_01.png
expect 0 '3 frames are there already, 2 would be rendered' render builtin:robots --size 8x8 --frames 0-4 --resume \
    -o n_%02d.png --aov motion=m_%02d.npy --dry-run
expect 0 '3 of 5 frames were there' render builtin:robots --size 8x8 --frames 0-4 --skip-existing \
    -o n_%02d.png --aov motion=m_%02d.npy --verbose
[ "$(cat n_01.png)" = x ] || fail "a frame that is there is rendered again"
cp all/n_01.png .
for file in all/*; do cmp -s "$file" "$(basename "$file")" || fail "resumed, $file is another one"; done
expect 3 '' render builtin:robots --size 8x8 --frames 0-4 --resume -o n_%02d.png --stats
expect 2 '--resume is of several frames' render "${small[@]}" --resume -o a.png
expect 2 'a film is made at once' render "${small[@]}" --resume --turntable 3 -o a.mp4

# --- one file of all planes ----------------------------------------------------------------------
expect 0 '' render "${small[@]}" --exr all.exr --manifest ids.json
for channel in R G B Z N.X P.Z instance albedo.R lit.0 item; do
    grep -qa "$channel" <(head -c 4000 all.exr) || fail "all.exr has no channel $channel"
done
expect 0 '' render "${small[@]}" --exr some.exr --planes depth,normal
if grep -qa 'albedo' <(head -c 4000 some.exr); then fail "some.exr has albedo"; fi
expect 2 "no plane|unknown plane|'deep'" render "${small[@]}" --exr some.exr --planes deep
expect 2 '--planes' render "${small[@]}" -o a.png --planes depth
expect 2 'accepted is .exr' render "${small[@]}" --exr all.png
expect 1 "folder 'none' does not exist" render "${small[@]}" --exr none/all.exr

# --- films without ffmpeg --------------------------------------------------------------------------
mkdir bin
PATH=$PWD/bin
export PATH
without=$("$program" render "${small[@]}" --turntable 3 -o a.mp4 2>&1) && without="exit code 0"
PATH=/usr/local/bin:/usr/bin:/bin
checks=$((checks + 1))
case $without in
    *"films need the program ffmpeg"*"apt-get install ffmpeg"*) ;;
    *) fail "without ffmpeg: $without" ;;
esac
nothing_left a.mp4

# --- an ffmpeg that fails --------------------------------------------------------------------------
failing()
{
    printf '#!/bin/bash\n%s\n' "$1" >bin/ffmpeg
    chmod +x bin/ffmpeg
    PATH=$PWD/bin:$PATH expect 1 "$2" render builtin:torus --size 200x200 --turntable 9 -o a.mp4
    nothing_left a.mp4
}
failing 'echo "Unknown encoder: libx264" >&2; exit 1' 'a.mp4: cannot write: ffmpeg failed: Unknown encoder: libx264'
failing 'head -c 1000 >/dev/null; echo "half way" >&2; exit 3' 'ffmpeg failed: half way'
failing 'cat >/dev/null; exit 4' 'ffmpeg failed: it ended with exit code 4'
failing 'head -c 1000 >/dev/null; kill -9 $$' 'ffmpeg failed: it was ended by signal 9'
failing 'cat >/dev/null; for k in $(seq 20000); do echo "line $k of many" >&2; done; exit 1' 'line 20000 of many'
[ "$(wc -c <stderr)" -lt 1000 ] || fail "all that ffmpeg said is repeated"
failing 'cat >/dev/null; exit 0' 'a.mp4: cannot write: No such file'
printf old >old.mp4
printf '#!/bin/bash\nexit 1\n' >bin/ffmpeg
PATH=$PWD/bin:$PATH expect 1 'ffmpeg failed' render "${small[@]}" --turntable 3 -o old.mp4
[ "$(cat old.mp4)" = old ] || fail "a film that fails spoils the old one"
rm -r bin

# --- films -----------------------------------------------------------------------------------------
expect 2 'nothing moves in builtin:torus' render "${small[@]}" -o a.gif
expect 2 'accepted are' render "${small[@]}" -o a.avi
if command -v ffmpeg >/dev/null && command -v ffprobe >/dev/null; then
    PATH=/usr/local/bin:/usr/bin:/bin
    # frames FILE : how many a film has.
    frames()
    {
        ffprobe -v error -count_frames -show_entries stream=nb_read_frames -of csv=p=0 "$1" | tr -d ',\n'
    }
    for ending in mp4 webm gif; do
        expect 0 '' render "${small[@]}" --turntable 5 -o "a.$ending"
        [ "$(frames "a.$ending")" = 5 ] || fail "a.$ending has $(frames "a.$ending") frames"
    done
    expect 0 '' render "${small[@]}" --turntable 5 -o a.webp
    [ "$(grep -ao ANMF a.webp | wc -l)" -eq 5 ] || fail "a.webp has another number of frames"
    expect 0 '' render builtin:robots --size 33x25 -o odd.mp4 --frames 0:1:13
    [ "$(frames odd.mp4)" = 13 ] || fail "odd.mp4 has $(frames odd.mp4) frames"
    [ "$(ffprobe -v error -show_entries stream=r_frame_rate -of csv=p=0 odd.mp4)" = 12/1 ] || \
        fail "odd.mp4 is not as fast as the scene"
    # The pixels are those of the pictures, as far as the format keeps them.
    expect 0 '' render builtin:robots --size 64x48 --frames 0:0:2 -o still.webm
    expect 0 '' render builtin:robots --size 64x48 -o still.png
    difference=$(ffmpeg -v info -i still.webm -i still.png -frames:v 1 -filter_complex \
        '[0]format=gbrp[a];[1]format=gbrp[b];[a][b]psnr' -f null - 2>&1 | grep -o 'average:[0-9.]*' | tail -1)
    checks=$((checks + 1))
    [ "$(echo "$difference" | sed 's/average:\([0-9]*\).*/\1/')" -ge 25 ] 2>/dev/null || \
        fail "still.webm is another picture: $difference"
    expect 2 'too small' render builtin:torus --size 1x9 --turntable 2 -o tiny.mp4
    nothing_left tiny.mp4
    expect 1 "folder 'none' does not exist" render "${small[@]}" --turntable 2 -o none/a.mp4
    # Stopped, it leaves nothing.
    "$program" render builtin:robots --size 300x200 --frames 0:10:100000 -o long.mp4 2>stderr &
    child=$!
    for _ in $(seq 100); do
        find . -name '.firsthit-*' | grep -q . && break
        sleep 0.1
    done
    kill -TERM $child
    wait $child 2>/dev/null
    [ $? -eq 143 ] || fail "a stopped film does not end by its signal"
    nothing_left long.mp4
    # Its ffmpeg killed, too.
    "$program" render builtin:robots --size 300x200 --frames 0:10:100000 -o long.mp4 2>stderr &
    child=$!
    for _ in $(seq 100); do
        find . -name '.firsthit-*' | grep -q . && break
        sleep 0.1
    done
    kill -KILL "$(ps -o pid= --ppid $child | tr -d ' ')"
    wait $child 2>/dev/null
    [ $? -eq 1 ] || fail "a film whose ffmpeg is killed does not fail"
    grep -q 'long.mp4: cannot write: ffmpeg failed: it was ended by signal 9' stderr || fail "killed: $(cat stderr)"
    nothing_left long.mp4
    ( ulimit -f 8; "$program" render builtin:robots --size 300x200 --turntable 9 -o large.gif 2>stderr )
    [ $? -eq 1 ] || fail "a film beyond the limit on sizes does not fail"
    nothing_left large.gif
else
    echo "skipped: films, as ffmpeg is not here"
fi

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
