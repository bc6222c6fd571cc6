# SPDX-License-Identifier: Apache-2.0
"""Running the program from a study script."""

import json
import os
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXECUTABLE = ROOT / "build" / "release" / "signorini"


class Failed(Exception):
    """The program ended without a result; the text is its message."""


def environment():
    return {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMP_NUM_THREADS": "1", "DEAL_II_NUM_THREADS": "1"}


def run(scene, sets, ranks, folder, mpi_options=(), executable=EXECUTABLE, timeout=None):
    """The results file of a run as a dictionary. A missed expectation of the scene (exit code 4) is no failure. timeout: in seconds."""
    command = ["mpirun", "--oversubscribe", *mpi_options, "-np", str(ranks), executable, scene]
    if ranks == 1 and not mpi_options:
        command = command[4:]
    for key, value in {"Output/VTU": "no", **sets, "Output/Directory": folder}.items():
        command += ["--set", f"{key}={value}"]
    try:
        done = subprocess.run(command, env=environment(), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        raise Failed(f"no result within {timeout} s") from None
    if done.returncode not in (0, 4):
        message = [line for line in done.stdout.splitlines() if line.startswith("error:")]
        raise Failed(message[0] if message else f"exit code {done.returncode}")
    return json.loads((Path(folder) / "results.json").read_text())
