#!/usr/bin/env python3
"""Renders every scene file below some folders and prints what became of each, as a Markdown table.

Usage: corpus_table.py PROGRAM FOLDER... [--ending .gltf --ending .glb] [--index FILE] [--seconds 60]
                       [--megabytes 4096]

Each file is rendered at 64 x 64 by a process of its own with limits on time and memory. Where a file
NAME.report.json of the Khronos glTF validator lies beside it, its number of errors is listed.

With --index, each file's triangles are counted by `firsthit info` instead, and listed beside those of a
table in FILE: lines of words between tabs, first the path from FILE's folder, third the triangles.
Exit code: 0 when no file crashed, hung or ran out of memory, else 1.
"""
import argparse
import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile


def errors_of(report):
    """The number of errors that the validator found; None without a report."""
    try:
        return json.loads(report.read_text())["issues"]["numErrors"]
    except (OSError, ValueError, KeyError):
        return None


def run(command, options):
    """Returns (result, message, output): the result is "shown", "refused" or what went wrong."""
    def limit():
        memory = options.megabytes << 20
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace",
                              timeout=options.seconds, preexec_fn=limit)
    except subprocess.TimeoutExpired:
        return "HUNG", "", ""
    lines = [line for line in done.stderr.splitlines() if line]
    if done.returncode == 0:
        return "shown", "; ".join(lines), done.stdout
    if done.returncode == 1:
        return "refused", lines[0] if lines else "", ""
    return f"CRASHED ({done.returncode})", lines[-1] if lines else "", ""


def render(program, path, options, folder):
    """Returns (result, message)."""
    picture = os.path.join(folder, "a.png")
    return run([program, "render", str(path), "--size", "64x64", "-o", picture], options)[:2]


def count(program, path, options):
    """Returns (result, message, triangles)."""
    result, message, output = run([program, "info", "--json", str(path)], options)
    return result, message, json.loads(output)["triangles"] if result == "shown" else 0


def read_index(file):
    """The triangles of each path as the index has them."""
    triangles = {}
    for line in file.read_text().splitlines():
        words = line.split("\t")
        if len(words) > 2:
            triangles[str(file.parent / words[0])] = words[2]
    return triangles


def counts_table(options, paths):
    """Prints triangles beside those of the index. Returns how many files each result has."""
    index = read_index(pathlib.Path(options.index))
    counts = {}
    print("| file | result | triangles | of the index | message |\n|---|---|---|---|---|")
    for top, path in paths:
        result, message, triangles = count(options.program, path, options)
        expected = index.get(str(path), "")
        same = expected in ("", str(triangles))
        kind = (result.split()[0], "" if same else "other count")
        counts[kind] = counts.get(kind, 0) + 1
        short = message.replace(str(path.parent) + "/", "").replace("|", "\\|")
        number = str(triangles) if same else f"**{triangles}**"
        print(f"| {path.relative_to(top)} | {result} | {number} | {expected} | {short[:300]} |")
    print("\n| result | beside the index | files |\n|---|---|---|")
    return counts


def renders_table(options, paths):
    """Prints what became of each picture. Returns how many files each result has."""
    counts = {}
    print("| file | validator's errors | result | message |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for top, path in paths:
            result, message = render(options.program, path, options, folder)
            errors = errors_of(pathlib.Path(str(path) + ".report.json"))
            valid = "-" if errors is None else str(errors)
            kind = (result.split()[0], "valid" if errors == 0 else "invalid" if errors else "unknown")
            counts[kind] = counts.get(kind, 0) + 1
            short = message.replace(str(path.parent) + "/", "").replace("|", "\\|")
            print(f"| {path.relative_to(top)} | {valid} | {result} | {short[:300]} |")
    print("\n| result | by the validator | files |\n|---|---|---|")
    return counts


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--ending", action="append")
    parser.add_argument("--index")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--megabytes", type=int, default=4096)
    options = parser.parse_args()
    endings = options.ending or [".gltf", ".glb"]

    paths = [(top, path) for top in options.folders for path in sorted(pathlib.Path(top).rglob("*"))
             if path.suffix.lower() in endings and path.is_file()]
    counts = counts_table(options, paths) if options.index else renders_table(options, paths)
    for (result, kind), number in sorted(counts.items()):
        print(f"| {result} | {kind} | {number} |")
    return 1 if any(result not in ("shown", "refused") for result, _ in counts) else 0


if __name__ == "__main__":
    sys.exit(main())
