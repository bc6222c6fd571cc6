# SPDX-License-Identifier: Apache-2.0
"""The installed library, used by another program as doc/tutorials/library.md says: package.py BUILD PROGRAM_FOLDER."""

import os
import subprocess
import sys
import tempfile
from pathlib import Path

build, program = (Path(word).resolve() for word in sys.argv[1:3])


def run(*words, cwd=None):
    print("+", *words, flush=True)
    subprocess.run([str(word) for word in words], check=True, cwd=cwd)


with tempfile.TemporaryDirectory() as folder:
    there = Path(folder)
    run("cmake", "--install", build, "--prefix", there / "installed")
    cache = dict(line.split("=", 1) for line in (build / "CMakeCache.txt").read_text().splitlines() if "=" in line)
    kind = cache["CMAKE_BUILD_TYPE:STRING"]
    run("cmake", "-S", program, "-B", there / "build", "-G", "Ninja", f"-DCMAKE_BUILD_TYPE={kind}",
        f"-DCMAKE_PREFIX_PATH={there / 'installed'}", f"-Ddeal.II_DIR={cache['deal.II_DIR:PATH']}")
    run("cmake", "--build", there / "build")
    os.chdir(there)  # where its results go
    run(there / "build" / "wavy_ground")
