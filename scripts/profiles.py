# SPDX-License-Identifier: Apache-2.0
"""Read what a run left in its output directory, but for the meshes."""

import json

import numpy as np


def read_results(directory):
    file = directory / "results.json"
    return json.loads(file.read_text()) if file.exists() else {}


def read_profiles(directory, step=None):
    """Pair -> table with the columns that doc/guide/results.md names, of a load step by its number or of the last one."""
    profiles = {}
    for file in sorted(directory.glob("profiles/*.csv" if step is None else f"profiles/step-{step:04d}/*.csv")):
        table = np.atleast_1d(np.genfromtxt(file, delimiter=",", names=True))
        if table.size and table.dtype.names and {"pressure", "gap", "status"} <= set(table.dtype.names):
            profiles[file.stem] = table
    return profiles


def positions(profile):
    return np.stack([profile[axis] for axis in "xyz"], axis=1)


def in_contact(profile):
    return profile["status"] > 0.5


def normals(profile):
    """The direction of the force on the slave at each point."""
    return np.stack([profile["normal_" + axis] for axis in "xyz"], axis=1)
