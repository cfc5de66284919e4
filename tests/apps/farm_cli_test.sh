#!/usr/bin/env bash
# farm_cli_test.sh - frames by several processes: parts, exit codes, runs that are killed and completed, tiles that are
# joined, and the examples for farms. Usage: farm_cli_test.sh PROGRAM
# shellcheck source=tests/apps/cli_checks.sh
source "$(dirname "$0")/cli_checks.sh"
cluster=$scripts/../../examples/cluster

# same WHOLE PART : the folders hold the same files, byte for byte, and nothing else that one sees.
same()
{
    checks=$((checks + 1))
    diff -rq --exclude='.firsthit-*.tmp' "$1" "$2" >difference 2>&1 || fail "$2 is not $1: $(head -n 3 difference)"
}

turn=(builtin:torus --size 24x16 --turntable 20)

# --- which frames -------------------------------------------------------------------------------
mkdir whole parts only
writes render "${turn[@]}" -o whole/f_%03d.png --aov motion=whole/m_%03d.npy
for number in 1 2 3; do
    expect 0 '[67] of 20 frames are this run' render "${turn[@]}" -o parts/f_%03d.png --aov motion=parts/m_%03d.npy \
        --chunk $number/3 --verbose
done
same whole parts
expect 0 '' render "${turn[@]}" -o only/f_%03d.png --only 4-6,19
[ "$(echo only/*)" = "only/f_004.png only/f_005.png only/f_006.png only/f_019.png" ] || fail "--only makes $(echo only/*)"
for file in only/*; do cmp -s "$file" "whole/${file#only/}" || fail "--only: $file is another one"; done
expect 0 'part +2 frames of them' render "${turn[@]}" -o only/f_%03d.png --only 4-6,19 --chunk 2/2 --dry-run
expect 0 '2 frames are there already, 0 would' render "${turn[@]}" -o only/f_%03d.png --only 4-6,19 --chunk 2/2 \
    --resume --dry-run
# The camera frames the first frame of all, whichever part is made.
mkdir one
writes render builtin:robots --size 16x16 --view iso --frames 0-3 -o one/f_%d.png
cp one/f_3.png whole_3.png
expect 0 '' render builtin:robots --size 16x16 --view iso --frames 0-3 --chunk 4/4 -o one/f_%d.png
cmp -s one/f_3.png whole_3.png || fail "a part of the frames has another camera"

# --- nothing to do ------------------------------------------------------------------------------
expect 3 '' render "${turn[@]}" -o whole/f_%03d.png --resume
[ ! -s stderr ] || fail "nothing to do is no error: $(cat stderr)"
expect 3 'nothing to do' render "${turn[@]}" -o whole/f_%03d.png --skip-existing --chunk 2/3 --verbose
expect 3 '' render "${turn[@]}" -o whole/f_%03d.png --chunk 1/21
expect 3 '' render "${turn[@]}" -o whole/f_%03d.png --only 20-30
expect 3 '' render "${turn[@]}" -o whole/f_%03d.png --only 7 --chunk 1/2
for value in 0/3 4/3 3 a/b 1/0; do
    expect 2 'is no chunk: accepted is I/N' render "${turn[@]}" -o f_%03d.png --chunk $value
done
expect 2 'is no list of frames' render "${turn[@]}" -o f_%03d.png --only clip
expect 2 'are of several frames' render builtin:torus --size 8x8 -o f.png --chunk 1/2
expect 2 'a film is made at once' render "${turn[@]}" -o f.mp4 --only 1-2

# --- 1,000 frames, killed again and again ----------------------------------------------------------
thousand=(builtin:torus --size 24x16 --turntable 1000 --aa 1 --threads 1 --quiet)
mkdir calm killed
writes render "${thousand[@]}" -o calm/f_%04d.png
[ "$(find calm -name 'f_*.png' | wc -l)" -eq 1000 ] || fail "the calm run does not make 1,000 frames"
frames_in() { find "$1" -name 'f_*.png' | wc -l; }
interrupted=0
RANDOM=20061
for round in 1 2 3 4 5 6; do
    pids=()
    for number in 1 2 3; do
        "$program" render "${thousand[@]}" -o killed/f_%04d.png --chunk $number/3 --skip-existing >/dev/null 2>&1 &
        pids+=($!)
    done
    # Killed in the middle of their work: when they have made some more frames.
    enough=$(($(frames_in killed) + 10 + RANDOM % 100))
    for _ in {1..2000}; do
        [ "$(frames_in killed)" -lt "$enough" ] && kill -0 "${pids[@]}" 2>/dev/null || break
        sleep 0.01
    done
    kill -9 "${pids[$((round % 3))]}" 2>/dev/null
    kill -TERM "${pids[$(((round + 1) % 3))]}" "${pids[$(((round + 2) % 3))]}" 2>/dev/null
    wait "${pids[@]}" 2>/dev/null
    [ "$(frames_in killed)" -eq 1000 ] || interrupted=$((interrupted + 1))
    for file in killed/f_*.png; do
        [ -e "$file" ] || continue
        cmp -s "$file" "calm/${file#killed/}" || fail "after round $round: $file is not whole"
    done
done
[ "$interrupted" -gt 0 ] || fail "no round was killed before its end"
for number in 1 2 3; do
    code=0
    "$program" render "${thousand[@]}" -o killed/f_%04d.png --chunk $number/3 --skip-existing >/dev/null 2>&1 || code=$?
    [ "$code" -eq 0 ] || [ "$code" -eq 3 ] || fail "completing chunk $number: exit code $code"
done
same calm killed
expect 3 '' render "${thousand[@]}" -o killed/f_%04d.png --skip-existing

# --- names that a killed process, or another machine's, has left ----------------------------------
mkdir left
(
    for k in 0 1 2 3 4 5 6 7 8 9; do : >"left/.firsthit-$BASHPID-$k.tmp"; done
    exec "$program" render "${turn[@]}" -o left/f_%03d.png
) >stdout 2>stderr || fail "names that are taken stop it: $(cat stderr)"
[ -s left/f_019.png ] || fail "no left/f_019.png"

# --- tiles --------------------------------------------------------------------------------------
scene=(builtin:room --size 101x67 --time 3)
planes() { echo --aov "item=$1_i.npy" --aov "normal=$1_n.npy" --aov "depth=$1_d.png" --exr "$1.exr" -o "$1.png"; }
# shellcheck disable=SC2046
writes render "${scene[@]}" $(planes all)
tiles=(0,0,45,67 45,0,56,30 45,30,56,37)
for region in "${tiles[@]}"; do
    # shellcheck disable=SC2046
    writes render "${scene[@]}" --region "$region" $(planes "t_$region")
done
for kind in .png .exr _i.npy _n.npy _d.png; do
    expect 0 '' join "${tiles[0]}=t_${tiles[0]}$kind" "${tiles[1]}=t_${tiles[1]}$kind" "${tiles[2]}=t_${tiles[2]}$kind" \
        -o "joined$kind" --size 101x67
    cmp -s "joined$kind" "all$kind" || fail "joined$kind is not all$kind"
done
two=("${tiles[0]}=t_${tiles[0]}.png" "${tiles[1]}=t_${tiles[1]}.png")
expect 1 'no tile has pixel \(45, 30\)' join "${two[@]}" -o gap.png
expect 1 'both have pixel' join "${two[@]}" "0,30,101,37=t_${tiles[2]}.png" -o gap.png
expect 1 'and its region 56x31' join "${tiles[0]}=t_${tiles[0]}.png" "45,0,56,31=t_${tiles[1]}.png" \
    "45,31,56,36=t_${tiles[2]}.png" -o gap.png
expect 2 'the tiles reach to 101x67' join "${two[@]}" "${tiles[2]}=t_${tiles[2]}.png" --size 102x67 -o gap.png
expect 1 'different kinds' join "${tiles[0]}=t_${tiles[0]}.png" "${tiles[1]}=t_${tiles[1]}.exr" -o gap.png
expect 1 'none.png' join "0,0,8,8=none.png" -o gap.png
expect 2 'is no tile' join a.png -o gap.png
expect 2 'no region' join 0,0,8=a.png -o gap.png
expect 1 'all.png' join 0,0,101,67=all.png -o all.png
[ ! -e gap.png ] || fail "a join that fails leaves a file"

# --- the examples -------------------------------------------------------------------------------
small=(FRAMES=0-5 SIZE=16x12)
mkdir expected
writes render builtin:torus --frames 0-5 --size 16x12 -o expected/frame_%05d.png
if command -v make >/dev/null; then
    make -s -j2 -f "$cluster/Makefile" frames "FIRSTHIT=$program" SCENE=builtin:torus "${small[@]}" CHUNKS=4 OUT=made \
        >stdout 2>stderr || fail "make frames: $(cat stderr)"
    same expected made
    rm made/frame_00002.png
    make -s -f "$cluster/Makefile" frames "FIRSTHIT=$program" SCENE=builtin:torus "${small[@]}" CHUNKS=9 OUT=made \
        >stdout 2>stderr || fail "make frames again: $(cat stderr)"
    same expected made
    make -s -f "$cluster/Makefile" frames "FIRSTHIT=$program" SCENE=builtin:none "${small[@]}" OUT=made \
        >stdout 2>stderr && fail "make frames of no scene does not fail"
    make -s -j2 -f "$cluster/Makefile" picture "FIRSTHIT=$program" SCENE=builtin:torus WIDTH=90 HEIGHT=61 STRIPS=3 \
        OUT=strips >stdout 2>stderr || fail "make picture: $(cat stderr)"
    writes render builtin:torus --size 90x61 -o picture.png
    cmp -s strips/picture.png picture.png || fail "make picture makes another one"
fi
for task in 1 2 3 2; do
    FIRSTHIT=$program SCENE=builtin:torus FRAMES=0-5 SIZE=16x12 OUT=slurm CHUNKS=3 SLURM_ARRAY_TASK_ID=$task \
        bash "$cluster/frames.sbatch" >stdout 2>stderr || fail "frames.sbatch, task $task: $(cat stderr)"
done
same expected slurm
FIRSTHIT=$program SCENE=builtin:none OUT=slurm CHUNKS=3 SLURM_ARRAY_TASK_ID=1 bash "$cluster/frames.sbatch" \
    >stdout 2>stderr && fail "frames.sbatch of no scene does not fail"
if /usr/bin/python3 -c 'import distributed' 2>/dev/null; then
    mkdir calm_dask
    writes render builtin:torus --frames 0-59 --size 16x12 -o calm_dask/frame_%05d.png
    timeout 200 /usr/bin/python3 "$cluster/dask_frames.py" builtin:torus 0-59 --program "$program" --size 16x12 \
        --batch 5 --out dask --lose-worker >stdout 2>stderr || fail "dask_frames.py: $(tail -n 5 stderr)"
    grep -q 'killed a worker' stdout || fail "dask_frames.py kills no worker"
    same calm_dask dask
else
    echo "skipped: dask_frames.py, which needs python3-distributed"
fi

echo "$checks checks, $failures failures"
[ "$failures" -eq 0 ]
