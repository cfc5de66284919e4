#!/usr/bin/env python3
"""Renders the frames of an animation on the workers of a Dask cluster (Debian: python3-distributed).

    dask_frames.py builtin:room 0-599 --out frames                    # workers of this machine
    dask_frames.py walk.glb 0-599 --scheduler tcp://head:8786 --out /shared/walk

Each task is a run of frames, which a worker gives to the program `firsthit`. A worker that dies loses its task to
another one, which makes the frames that are still missing: files appear whole or not at all.
"""
import argparse
import os
import signal
import subprocess
import sys

from distributed import Client, LocalCluster, as_completed

NOTHING_TO_DO = 3  # the program's exit code where all frames are there


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scene")
    parser.add_argument("frames", help="first-last, as 0-599")
    parser.add_argument("--out", default="frames", help="a folder that all workers see")
    parser.add_argument("--size", default="1280x720")
    parser.add_argument("--program", default="firsthit")
    parser.add_argument("--batch", type=int, default=10, help="frames in a task")
    parser.add_argument("--scheduler", help="the address of a cluster's scheduler; else workers are started here")
    parser.add_argument("--workers", type=int, default=2, help="of this machine")
    parser.add_argument("--lose-worker", action="store_true",
                        help="kill a worker after the first task, to see that the others go on")
    return parser.parse_args()


def render(arguments, only):
    """Runs on a worker: makes the frames `only`, as "40-49", that are not there yet."""
    command = [arguments["program"], "render", arguments["scene"], "--frames", arguments["frames"], "--only", only,
               "--size", arguments["size"], "-o", os.path.join(arguments["out"], "frame_%05d.png"), "--skip-existing",
               "--threads", "1", "--quiet"]
    done = subprocess.run(command, stderr=subprocess.PIPE, text=True)
    if done.returncode not in (0, NOTHING_TO_DO):
        raise RuntimeError(f"frames {only}: {done.stderr.strip()}")
    return only


def main():
    arguments = parse_arguments()
    first, last = (int(number) for number in arguments.frames.split("-"))
    arguments.out = os.path.abspath(arguments.out)
    os.makedirs(arguments.out, exist_ok=True)
    batches = [f"{k}-{min(k + arguments.batch - 1, last)}" for k in range(first, last + 1, arguments.batch)]

    cluster = arguments.scheduler or LocalCluster(
        n_workers=arguments.workers, threads_per_worker=1, dashboard_address=None, silence_logs=50)
    with Client(cluster) as client:
        tasks = [client.submit(render, vars(arguments), batch, pure=False, retries=2) for batch in batches]
        killed = not arguments.lose_worker
        for done, task in enumerate(as_completed(tasks), 1):
            print(f"frames {task.result()}: {done} of {len(tasks)} tasks", flush=True)
            if not killed:
                pids = client.run(os.getpid)
                os.kill(next(iter(pids.values())), signal.SIGKILL)
                killed = True
                print("killed a worker", flush=True)
    if not arguments.scheduler:
        cluster.close()


if __name__ == "__main__":
    sys.exit(main())
