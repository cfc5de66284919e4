"""Processes: Ctrl-C, fork, the end of the interpreter, where the package is found."""

import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

import firsthit as fh

HERE = pathlib.Path(fh.__file__).resolve().parent

BUSY = """
import threading
import firsthit as fh
world = fh.load("builtin:robots").pose(2)
camera = fh.scene_camera(world, size=(900, 700))
"""


def python(code, **words):
    return subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **words)


@pytest.mark.parametrize("call", ["fh.render(world, camera, sky=64, samples=8)",
                                  "fh.render_batch(world, [camera] * 200, sky=64, samples=8, threads=2)"])
def test_ctrl_c_stops_a_frame(call):
    process = python(BUSY + f"""
print("begin", flush=True)
try:
    {call}
except KeyboardInterrupt:
    print("stopped", flush=True)
print(fh.render(world, camera, ["depth"])["depth"].shape)
""")
    assert process.stdout.readline() == "begin\n"
    time.sleep(0.3)
    begin = time.monotonic()
    process.send_signal(signal.SIGINT)
    out, error = process.communicate(timeout=120)
    assert out == "stopped\n(700, 900)\n", error
    assert process.returncode == 0 and time.monotonic() - begin < 60


def test_the_interpreter_ends_while_a_thread_renders():
    for k in range(4):
        process = python(BUSY + f"""
import time
def work():
    while True:
        fh.render(world, camera, ["color", "depth"], progress=(lambda share: None) if {k} % 2 else None)
for _ in range(2):
    threading.Thread(target=work, daemon=True).start()
time.sleep({0.05 + 0.1 * k})
print("end", flush=True)
""")
        out, error = process.communicate(timeout=120)
        assert process.returncode == 0 and out == "end\n" and not error, (process.returncode, error)


def test_fork_after_use():
    process = python(BUSY.replace("900, 700", "90, 70") + """
import os, sys, warnings
warnings.simplefilter("ignore")
wanted = fh.render(world, camera, ["color", "item"]).hash()
kept = fh.Renderer(2)
fh.render(world, camera, ["item"], renderer=kept)
sys.stdout.flush()
child = os.fork()
if child == 0:
    # The renderers of before answer right or say why not; a new one answers.
    for renderer in (None, kept, fh.Renderer(2)):
        try:
            right = fh.render(world, camera, ["color", "item"], renderer=renderer).hash() == wanted
        except fh.Error:
            right = True
        print(right, flush=True)
    print(fh.occlusion(world, [[0, 0, 0]], directions=[[0, 0, 1]]).shape, flush=True)
    os._exit(0)
_, status = os.waitpid(child, 0)
print(status, fh.render(world, camera, ["color", "item"]).hash() == wanted)
""")
    out, error = process.communicate(timeout=120)
    assert out == "True\nTrue\nTrue\n(1, 1)\n0 True\n", (out, error)


def test_two_processes_by_multiprocessing(tmp_path):
    script = tmp_path / "pool.py"
    script.write_text("""
import multiprocessing
import firsthit as fh

def work(seconds):
    world = fh.load("builtin:robots").pose(seconds)
    return fh.render(world, fh.scene_camera(world, size=(60, 40)), ["item"]).hash()

if __name__ == "__main__":
    here = [work(t) for t in (1, 2, 3)]
    for kind in ("fork", "spawn"):
        with multiprocessing.get_context(kind).Pool(2) as pool:
            assert pool.map(work, (1, 2, 3)) == here
    print("equal")
""")
    process = subprocess.run([sys.executable, script], capture_output=True, text=True, timeout=300)
    assert process.stdout == "equal\n", process.stderr


def test_the_sources_folder_does_not_stand_before_the_package():
    sources = pathlib.Path(__file__).resolve().parents[1]
    done = subprocess.run([sys.executable, "-c", "import firsthit; print(firsthit.__file__)"], cwd=sources, capture_output=True,
                          text=True)
    assert done.returncode == 0 and pathlib.Path(done.stdout.strip()).resolve().parent == HERE, done.stderr


def test_without_its_module_the_package_says_what_to_do(tmp_path):
    sources = pathlib.Path(__file__).resolve().parents[1] / "src"
    done = subprocess.run([sys.executable, "-c", "import firsthit"], cwd=sources, capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(sources)})
    assert done.returncode != 0 and "build/release/python" in done.stderr and "pip install" in done.stderr


def test_memory_of_many_frames_is_constant(square):
    import resource

    world, camera = square.pose(), fh.look_at((0, 0, 3), (0, 0, 0), size=(8, 8))
    renderer = fh.Renderer(1)

    def frames(count):
        for _ in range(count):
            frame = fh.render(world, camera, ["color", "depth", "item"], aa=1, sky=0, renderer=renderer)
            assert frame["depth"].shape == (8, 8)

    frames(2000)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    frames(int(os.environ.get("FIRSTHIT_FRAMES", "5000")))
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 1024, "KiB more"
