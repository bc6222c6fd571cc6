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


def has_friction(profile):
    return "stick" in profile.dtype.names


def sticks(profile):
    return profile["stick"] > 0.5


def tangential_traction(profile):
    """In 2D its component along the surface, in the order of the points: positive where it points to the next one."""
    n = normals(profile)
    along = np.stack([n[:, 1], -n[:, 0]], axis=1)
    onwards = np.einsum("ij,ij->", along[:-1] + along[1:], np.diff(positions(profile)[:, :2], axis=0))
    return (-1 if onwards < 0 else 1) * (along[:, 0] * profile["tangential_x"] + along[:, 1] * profile["tangential_y"])
