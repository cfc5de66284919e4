# hidden_screen.sh - a screen that nobody sees, for tests of the window. Sourced after cli_checks.sh. Ends the test with 77,
# which ctest counts as skipped, where Xvfb or the window is missing.
command -v Xvfb >/dev/null || { echo "skipped: no Xvfb (apt-get install xvfb)"; exit 77; }
if grep -q "built without a window" <<<"$(DISPLAY= WAYLAND_DISPLAY= "$program" view builtin:torus 2>&1)"; then
    echo "skipped: this firsthit was built without a window"
    exit 77
fi
# The server chooses a free display and tells it. It is not reset between two programs, when it would hear neither.
Xvfb -displayfd 3 -noreset -screen 0 1280x1024x24 -nolisten tcp 3>display.txt 2>xvfb.txt &
server=$!
trap 'kill $server 2>/dev/null; rm -rf "$folder"' EXIT
for _ in $(seq 100); do
    [ -s display.txt ] && break
    sleep 0.1
done
[ -s display.txt ] || { echo "skipped: Xvfb does not start: $(cat xvfb.txt)"; exit 77; }
DISPLAY=:$(cat display.txt)
export DISPLAY LIBGL_ALWAYS_SOFTWARE=1
unset WAYLAND_DISPLAY
export XDG_STATE_HOME=$folder/state # not that of whoever runs the test
