# SPDX-License-Identifier: Apache-2.0
"""The figure of pairs with friction over the load steps: force, stick zone, hysteresis loop."""

import matplotlib.pyplot as plt
import numpy as np

import vtu
from figures import MADE_BY

FORCE, STICK, TRACTION = "#1f5fa8", "#2f9e77", "#e08e2b"


def plot_friction(results, solution, title, file):
    """Of each pair with friction: force and share that sticks over the time, and the force over the motion of the bodies.

    @param solution path of solution.pvd, which may not exist: then there is no motion, hence no loop
    """
    steps = results.get("load_steps", [])
    pairs = [name for name, pair in steps[-1]["pairs"].items() if "friction_force" in pair] if len(steps) > 1 else []
    if not pairs:
        return
    meshes = [vtu.read(path) for _, path in vtu.steps(solution)] if solution.exists() else []
    bodies = [mean_displacements(mesh) for mesh in meshes] if len(meshes) == len(steps) else []
    figure = plt.figure(figsize=(11, 0.5 + 4 * len(pairs)), layout="constrained")
    figure.suptitle(title, fontsize=11)
    for pair, part in zip(pairs, figure.subfigures(len(pairs), 1, squeeze=False)[:, 0]):
        slave = steps[-1]["pairs"][pair]["slave"]
        master = master_of(results, pair, slave)
        motion = relative_motion(steps, bodies, slave, master)
        part.suptitle(pair, fontsize=10)
        plot_pair(part, steps, pair, master, motion)
    figure.savefig(file, dpi=100, facecolor="white", metadata=MADE_BY)


def plot_pair(part, steps, pair, master, motion):
    over_time = [step["pairs"][pair] for step in steps]
    times = [step["time"] for step in steps]
    force, direction, resultant = friction_force(over_time)
    tractions = [found["max_tangential_traction"] for found in over_time]
    loop = resultant and motion is not None and np.ptp(motion @ direction) > 0
    left, *right = part.subplots(1, 2 if loop else 1, squeeze=False)[0]

    label = f"friction force on {master}, {in_words(direction)}" if resultant else "largest tangential traction"
    left.plot(times, force if resultant else tractions, "o-", color=FORCE, markersize=4, linewidth=1.4)
    left.set(xlabel="t", xlim=(0, None))
    left.set_ylabel(label, color=FORCE)
    share = stick_shares(over_time)
    other = left.twinx()
    other.plot(times, share, "s--", color=STICK, markersize=3, linewidth=1)
    other.fill_between(times, 0, share, color=STICK, alpha=0.12, linewidth=0)
    other.set(ylim=(-0.05, 1.05))
    other.set_ylabel("stick area / contact area", color=STICK)
    left.set_zorder(other.get_zorder() + 1)
    left.patch.set_visible(False)
    for ax in right:
        x = motion @ direction
        ax.plot(x, force, "o-", color=FORCE, markersize=4, linewidth=1.4)
        ax.plot(x[-1:], force[-1:], "o", color=TRACTION, markersize=7, label=f"t = {times[-1]:g}")
        ax.legend(fontsize=9, frameon=False)
        ax.set(xlabel=f"motion of {body_of(over_time[-1]['slave'])} relative to {body_of(master)}\n{in_words(direction)}, means of the bodies",
               ylabel=label)
        ax.set_title(f"work of friction {over_time[-1]['total_friction_work']:.4g}", fontsize=9)
    for ax in (left, *right):
        ax.axhline(0, color="black", linewidth=0.6, zorder=0)
        ax.grid(alpha=0.25)


def friction_force(over_time):
    """Of a pair over the load steps: friction force on the master along the direction in which it is largest, that direction, and
    whether there is a resultant: tractions of all directions cancel, as on a plane of symmetry or under torque."""
    force = -np.array([found["friction_force"] for found in over_time])
    largest = force[np.argmax(np.linalg.norm(force, axis=1))]
    bound = max(found["max_tangential_traction"] * found["area"] for found in over_time)
    direction = largest / (np.linalg.norm(largest) or 1)
    direction = direction * np.sign(direction[np.argmax(abs(direction))])
    return force @ direction, direction, bool(np.linalg.norm(largest) > 1e-3 * bound)


def stick_shares(over_time):
    """Stick area over contact area; NaN without contact."""
    return [found["stick_area"] / found["area"] if found["area"] else np.nan for found in over_time]


def master_of(results, pair, slave):
    """The other side of a pair, also where the program has exchanged the two."""
    sides = results.get("preflight", {}).get("pairs", {}).get(pair, {"master": "the master"})
    return sides["master"] if sides["master"] != slave else sides["slave"]


def in_words(direction):
    largest = int(np.argmax(abs(direction)))
    if abs(direction[largest]) > 0.9998:  # within a degree
        return f"along {'xyz'[largest]}"
    return f"along ({', '.join(f'{component:.4g}' for component in direction.round(2) + 0)})"


def body_of(boundary):
    return boundary.partition(".")[0]


def relative_motion(steps, bodies, slave, master):
    """Of the slave's body, in each load step, relative to the other one or to the obstacle; None where it is not known."""
    names = body_of(slave), body_of(master)
    if not bodies or names[0] not in bodies[0] or names[0] == names[1]:
        return None
    dimension = len(steps[-1]["pairs"][next(iter(steps[-1]["pairs"]))]["force"])
    still = {"displacement": np.zeros(dimension)}
    others = [of_bodies.get(names[1], step["obstacles"].get(names[1], still)["displacement"]) for of_bodies, step in zip(bodies, steps)]
    return np.array([of_bodies[names[0]][:dimension] - other[:dimension] for of_bodies, other in zip(bodies, others)])


def mean_displacements(mesh):
    """Body -> mean of the displacement over its cells."""
    corners = mesh.points[mesh.cells][..., : mesh.dimension]
    sizes = abs(np.linalg.det(corners[:, (1, 3, 4)[: mesh.dimension]] - corners[:, :1]))
    means = mesh.fields["displacement"][mesh.cells].mean(axis=1)
    body = mesh.fields["body"][mesh.cells[:, 0]].round().astype(int)
    return {name: np.average(means[body == number], axis=0, weights=sizes[body == number])
            for number, name in enumerate(mesh.names["body"]) if (body == number).any()}
