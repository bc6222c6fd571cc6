# SPDX-License-Identifier: Apache-2.0
"""Over which coordinate the pressure of a contact surface is drawn: x, y or z, the distance from a centre, or an angle."""

from dataclasses import dataclass
from typing import Callable

import numpy as np

from profiles import in_contact, normals, positions

ARC = np.radians(20)  # contact whose normals differ by more lies on an arc


@dataclass
class Abscissa:
    of: Callable  # profile -> coordinate of each of its points
    label: str


@dataclass
class Arc:
    """The cylinder (circle) about which the contact lies: its axis, and the two directions between which angles run."""

    centre: np.ndarray
    axes: np.ndarray  # rows: the direction of the angle zero, that of 90 degrees, the axis
    middle: float  # of the contact zone [degrees]; angles are within 180 degrees of it
    label: str

    def angle(self, profile):
        x = (positions(profile) - self.centre) @ self.axes[:2].T
        angle = np.degrees(np.arctan2(x[:, 1], x[:, 0]))
        return self.middle + (angle - self.middle + 180) % 360 - 180

    def height(self, profile):
        return (positions(profile) - self.centre) @ self.axes[2]


def along_surface(profile, planar, choice=None):
    """The coordinate to draw over, or None where it takes two of them."""
    if choice == "map":
        return None
    if choice in ("x", "y", "z"):
        return Abscissa(lambda table: table[choice], choice)
    arc = arc_of(profile)
    if choice == "angle" and arc is None:
        raise SystemExit("--abscissa angle: the contact does not lie on an arc")
    if choice == "angle" or choice is None and arc:
        over_angle = Abscissa(arc.angle, arc.label)
        return over_angle if planar or choice or is_function(profile, over_angle) else None
    if planar and choice is None:
        extent = np.ptp(positions(profile), axis=0)
        axis = "x" if extent[0] > 1e-6 * extent[1] else "y"
        return Abscissa(lambda table: table[axis], axis)
    over_radius = radius(profile, planar)
    return over_radius if planar or choice or is_function(profile, over_radius) else None


def in_plane(profile):
    """Two coordinates of each point on the surface, and their names."""
    arc = arc_of(profile)
    if arc:
        return np.stack([arc.angle(profile), arc.height(profile)], axis=1), (arc.label, "along the axis")
    x = positions(profile)
    plane = plane_of(profile)
    return x[:, plane], tuple("xyz"[k] for k in plane)


def contact_window(s, active):
    """The part of the abscissa worth showing: the contact zone and as much again around it."""
    low, high = s.min(), s.max()
    if active.any():
        zone = s[active]
        margin = max(0.6 * np.ptp(zone), 0.05 * (high - low))
        low, high = max(low, zone.min() - margin), min(high, zone.max() + margin)
    if 0 < low < 0.2 * high:  # zero is near enough to begin there
        low = 0
    margin = 0.02 * (high - low) or 1
    return low - margin, high + margin


def arc_of(profile):
    """The arc on which the contact lies, if its normals turn about one axis, and its points lie about that."""
    active = in_contact(profile)
    if active.sum() < 3 or "normal_x" not in profile.dtype.names:
        return None
    x, n = positions(profile)[active], normals(profile)[active]
    _, sizes, directions = np.linalg.svd(n, full_matrices=False)
    if sizes[2] > 0.02 * sizes[0] or sizes[1] <= 1e-3 * sizes[0]:  # about no axis, or all the same
        return None
    axis = directions[-1]
    k = int(np.argmax(abs(axis)))
    axis = axis * np.sign(axis[k])
    first = np.eye(3)[(k + 1) % 3]
    first = first - (first @ axis) * axis
    first /= np.linalg.norm(first)
    axes = np.stack([first, np.cross(axis, first), axis])

    a, b = (x @ axes[:2].T).T
    solution = np.linalg.lstsq(np.stack([2 * a, 2 * b, np.ones_like(a)], axis=1), a**2 + b**2, rcond=None)[0]
    centre = solution[:2] @ axes[:2]
    radius = np.hypot(a - solution[0], b - solution[1])
    angle = np.arctan2(n @ axes[1], n @ axes[0])
    mean = np.array([np.cos(angle).mean(), np.sin(angle).mean()])
    middle = np.arctan2(*mean[::-1])
    spread = np.ptp((angle - middle + np.pi) % (2 * np.pi))
    if spread < ARC or np.ptp(radius) > 0.02 * radius.mean():
        return None
    names = "xyz"[(k + 1) % 3], "xyz"[(k + 2) % 3]
    arc = Arc(centre, axes, 0.0, f"angle from {names[0]} towards {names[1]} [degrees]")
    around = np.radians(arc.angle(profile)[active])
    mean = np.array([np.cos(around).mean(), np.sin(around).mean()])
    arc.middle = 0.0 if np.linalg.norm(mean) < 0.1 else float(np.degrees(np.arctan2(*mean[::-1])))
    return arc


def plane_of(profile):
    """The axes that span the surface best: all but that of its smallest extent."""
    return sorted(np.argsort(np.ptp(positions(profile), axis=0), kind="stable")[1:])


def radius(profile, planar):
    """Distances in the plane of the surface, from a centre.

    Where the surface contains the origin, that is the better centre: models are posed around it, quarter models have their axis
    there, and the point of largest pressure jumps from one point to the next under refinement.
    """
    x = positions(profile)
    plane = [int(np.argmax(np.ptp(x, axis=0)))] if planar else plane_of(profile)
    low, high = x[:, plane].min(axis=0), x[:, plane].max(axis=0)
    slack = 0.1 * (high - low)  # contact points may be quadrature points, inside their faces
    if np.all(low <= slack) and np.all(high >= -slack) or not profile["pressure"].any():
        centre, label = np.zeros(len(plane)), "r, distance from the origin"
    else:
        centre = np.average(x[:, plane], axis=0, weights=abs(profile["pressure"]))
        label = "r, distance from the centre of pressure"
    return Abscissa(lambda table: np.linalg.norm(positions(table)[:, plane] - centre, axis=1), label)


def is_function(profile, abscissa):
    """Whether the pressure depends on that coordinate alone, more or less."""
    active = in_contact(profile)
    if active.sum() < 4:
        return True
    order = np.argsort(abscissa.of(profile)[active], kind="stable")
    pressure = profile["pressure"][active][order]
    # The mean jump from point to point, beside what a smooth curve would have.
    return abs(np.diff(pressure)).sum() <= 4 * np.ptp(pressure) + 1e-9 * abs(pressure).max()
