"""Puts the shared libraries that a wheel's modules need into the wheel, so that it needs none of the system's but
those of C and C++: libc, libm, libstdc++, libgcc_s and what belongs to libc.

    bundle_wheel.py WHEEL FOLDER

The libraries go to firsthit.libs/, under names of their own, so that other packages' copies do not get in the way, and the
texts of their licences with them. Needs patchelf. What a library opens while it runs (libepoxy: OpenGL) stays the system's.
"""

import base64
import hashlib
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

SYSTEM = re.compile(r"^(libc|libm|libdl|libpthread|librt|libstdc\+\+|libgcc_s|ld-linux-x86-64)\.so\.\d+$")
FOLDER = "firsthit.libs"


def run(*words):
    return subprocess.run(words, check=True, capture_output=True, text=True).stdout


def needed(file):
    """The names of libraries that a file is linked with, without those of the system."""
    return [name for name in run("patchelf", "--print-needed", str(file)).split() if not SYSTEM.match(name)]


def places(file):
    """Where the loader finds each library that a file needs, directly or not."""
    found = {}
    for line in run("ldd", str(file)).splitlines():
        match = re.match(r"\s*(\S+) => (\S+)", line)
        if match and match[2] == "not":
            raise SystemExit(f"bundle_wheel.py: {file.name} needs {match[1]}, which is not there")
        if match:
            found[match[1]] = pathlib.Path(match[2])
    return found


def licence_of(library):
    """Debian's text for the package that a library is of; None elsewhere."""
    for path in (library, library.resolve()):
        owner = subprocess.run(["dpkg", "-S", str(path)], capture_output=True, text=True).stdout.split(":")[0]
        text = pathlib.Path("/usr/share/doc") / owner / "copyright"
        if owner and text.is_file():
            return owner, text
    # /lib may be a link to /usr/lib, of which the packages know only one name.
    return None if str(library).startswith("/usr") else licence_of(pathlib.Path("/usr" + str(library)))


def bundle(root):
    """Copies the libraries below root, and has modules and libraries find each other. Returns their names."""
    modules = list(root.rglob("*.so"))
    paths = {}
    for module in modules:
        paths.update(places(module))
    names, queue = {}, [name for module in modules for name in needed(module)]
    folder = root / FOLDER
    folder.mkdir()
    while queue:
        name = queue.pop()
        if name in names:
            continue
        digest = hashlib.sha256(paths[name].read_bytes()).hexdigest()[:8]
        names[name] = re.sub(r"\.so", f"-{digest}.so", name, count=1)
        copy = folder / names[name]
        shutil.copy(paths[name], copy)
        copy.chmod(0o755)
        queue += needed(copy)
        licence = licence_of(paths[name])
        if licence:
            (folder / "licences").mkdir(exist_ok=True)
            shutil.copyfile(licence[1], folder / "licences" / f"{licence[0]}.txt")
    for copy in folder.glob("*.so*"):
        run("patchelf", "--set-soname", copy.name, str(copy))
        connect(copy, "$ORIGIN", names)
    for module in modules:
        up = "/".join([".."] * len(module.relative_to(root).parent.parts))
        connect(module, f"$ORIGIN/{up}/{FOLDER}", names)
    return sorted(names.values())


def connect(file, rpath, names):
    """Has a file look for its libraries by their new names."""
    # One after the other: patchelf 0.14 does the first of several changes alone.
    for name in needed(file):
        run("patchelf", "--replace-needed", name, names[name], str(file))
    run("patchelf", "--force-rpath", "--set-rpath", rpath, str(file))


def write_record(root):
    """The wheel's list of files (PEP 427)."""
    (info,) = root.glob("*.dist-info")
    lines = []
    for file in sorted(f for f in root.rglob("*") if f.is_file()):
        name = file.relative_to(root).as_posix()
        if name == f"{info.name}/RECORD":
            lines.append(f"{name},,")
            continue
        data = file.read_bytes()
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        lines.append(f"{name},sha256={digest},{len(data)}")
    (info / "RECORD").write_text("\n".join(lines) + "\n")


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    wheel, target = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        with zipfile.ZipFile(wheel) as archive:
            archive.extractall(root)
        names = bundle(root)
        write_record(root)
        target.mkdir(parents=True, exist_ok=True)
        made = target / wheel.name
        with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
            for file in sorted(f for f in root.rglob("*") if f.is_file()):
                archive.write(file, file.relative_to(root).as_posix())
    print(f"{made}: {made.stat().st_size >> 20} MiB with {', '.join(names)}")


if __name__ == "__main__":
    main()
