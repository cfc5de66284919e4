#!/usr/bin/env bash
# view_random_input_test.sh - the window under seeded random input: it does not crash, and takes no more memory in the end
# than when it had warmed up. How long input waited at most is printed.
# Usage: view_random_input_test.sh PROGRAM. FIRSTHIT_RANDOM_INPUT_S: seconds, default 60; FIRSTHIT_RANDOM_INPUT_SEED;
# FIRSTHIT_LONGEST_WAIT_MS: input that waits longer is a failure, for machines that do nothing else.
source "$(dirname "$0")/cli_checks.sh"
source "$scripts/hidden_screen.sh"
seconds=${FIRSTHIT_RANDOM_INPUT_S:-60} seed=${FIRSTHIT_RANDOM_INPUT_SEED:-1}

python3 "$scripts/random_input.py" "$seconds" "$seed" >input.txt
checks=1
timeout $((seconds * 8 + 120)) "$program" view builtin:robots --size 640x480 --script input.txt >measured.txt 2>said.txt ||
    fail "random input, seed $seed, exit code $?: $(tail -c 500 said.txt)"
cat measured.txt
python3 - "${FIRSTHIT_LONGEST_WAIT_MS:-inf}" <<'PY' || fail "seed $seed: a stall, or memory grows"
import re
import sys

text = open('measured.txt').read()
stalls = [float(v) for v in re.findall(r'input waited at most ([\d.]+) ms', text)]
memory = [float(v) for v in re.findall(r'memory ([\d.]+) MB', text)]
if len(stalls) != 2 or len(memory) != 2:
    sys.exit('nothing was measured')
if max(stalls) > float(sys.argv[1]):
    sys.exit(f'input waited for {max(stalls)} ms')
if memory[1] > 1.1 * memory[0] + 20:
    sys.exit(f'memory grew from {memory[0]} to {memory[1]} MB')
PY

echo "$checks checks, $failures failures"
[ "$failures" = 0 ]
