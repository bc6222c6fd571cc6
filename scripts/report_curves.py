# SPDX-License-Identifier: Apache-2.0
"""Curves of a report over the load steps and over the meshes, as data for Plotly. Each says one thing."""

import numpy as np

import vtu
from friction_figure import body_of, friction_force, in_words, master_of, mean_displacements, relative_motion, stick_shares

MOST_BYTES = 3e8  # of the VTU files of all load steps, which motions of the bodies are read from
BLUE, RED, GREEN, ORANGE, VIOLET = COLOURS = ("#3b82c4", "#d1495b", "#2f9e77", "#e08e2b", "#8a63c9")


def curves_of(results, solution):
    """Curves as dictionaries, and remarks on what is left out."""
    steps, remarks = results.get("load_steps", []), []
    result = over_meshes(results)
    if len(steps) < 2:
        return result, remarks
    bodies, remark = motions(solution, len(steps))
    remarks += [remark] if remark else ["Motions and approaches are those of the means of the bodies."]
    result = (
        over_time(steps)
        + over_motion(results, steps, bodies)
        + of_friction(results, steps, bodies)
        + of_obstacles(steps)
        + result
    )
    result.append(
        curve(
            "Newton steps of each load step",
            "load step",
            "Newton steps",
            [
                {
                    "type": "bar",
                    "x": [step.get("step", i + 1) for i, step in enumerate(steps)],
                    "y": [step["newton_iterations"] for step in steps],
                    "marker": {"color": BLUE},
                }
            ],
            zero=True,
        )
    )
    return result, remarks


def curve(title, x, y, lines, **more):
    for line in lines:
        for axis in ("x", "y"):
            if axis in line:
                line[axis] = [None if value is None or not np.isfinite(value) else float(value) for value in line[axis]]
    return {"title": title, "x": x, "y": y, "lines": lines, **more}


def line(x, y, name="", number=0, **more):
    return {
        "type": "scatter",
        "mode": "lines+markers",
        "x": list(x),
        "y": list(y),
        "name": name,
        "marker": {"size": 5},
        "line": {"color": COLOURS[number % len(COLOURS)], "width": 2},
        **more,
    }


def motions(solution, n_steps):
    """Means of the displacement of the bodies in each load step."""
    if not solution.exists():
        return [], "Forces over motions are not computed: the run has written no meshes (Output/VTU = no)."
    files = [file for _, file in vtu.steps(solution)]
    size = sum(part.stat().st_size for file in files for part in file.parent.glob(file.stem + ".*"))
    if len(files) != n_steps:
        return [], "Forces over motions are not computed: there is not a mesh for each load step."
    if size > MOST_BYTES:
        return [], f"Forces over motions are not computed: the meshes of all load steps are too large ({size / 1e9:.1f} GB)."
    return [mean_displacements(vtu.read(file)) for file in files], ""


def over_time(steps):
    times = [step["time"] for step in steps]
    lines = [
        line(times, [step["pairs"].get(pair, {}).get("normal_force") for step in steps], pair, i)
        for i, pair in enumerate(steps[-1]["pairs"])
    ]
    return [curve("Normal force of contact pairs over the time", "t", "normal force", lines, zero=True)] if lines else []


def over_motion(results, steps, bodies):
    """Of each pair the force along its normal over the approach of the two bodies in that direction."""
    result = []
    for i, pair in enumerate(steps[-1]["pairs"]):
        found = [step["pairs"].get(pair) for step in steps]
        if not bodies or None in found:
            continue
        slave = found[-1]["slave"]
        master = master_of(results, pair, slave)
        motion = relative_motion(steps, bodies, slave, master)
        force = np.array([np.subtract(one["force"], one.get("friction_force", np.zeros(len(one["force"])))) for one in found])
        largest = force[np.argmax(np.linalg.norm(force, axis=1))]
        size = np.linalg.norm(largest)
        if motion is None or size == 0 or size < 1e-3 * max(one["normal_force"] for one in found):
            continue
        direction = largest / size
        approach = -(motion @ direction)
        if changes(approach) or changes(force @ direction):
            result.append(
                curve(
                    f"Force over approach, pair {pair}",
                    f"approach of {body_of(slave)} and {body_of(master)} {in_words(direction)}",
                    "normal force",
                    [line(approach, force @ direction, pair, i)],
                    zero=True,
                )
            )
    return result


def changes(values):
    """By more than a twentieth: a force that is held while others change is no curve."""
    return np.ptp(values) > 0.05 * abs(values).max()


def of_friction(results, steps, bodies):
    result, times = [], [step["time"] for step in steps]
    for pair, last in steps[-1]["pairs"].items():
        found = [step["pairs"].get(pair) for step in steps]
        if "friction_force" not in last or None in found:
            continue
        master = master_of(results, pair, last["slave"])
        force, direction, resultant = friction_force(found)
        motion = relative_motion(steps, bodies, last["slave"], master)
        if resultant and motion is not None and np.ptp(motion @ direction) > 0:
            result.append(
                curve(
                    f"Friction loop, pair {pair}",
                    f"motion of {body_of(last['slave'])} relative to {body_of(master)} " f"{in_words(direction)}",
                    f"friction force on {master}",
                    [line(motion @ direction, force, pair, 1)],
                )
            )
        elif resultant:
            result.append(
                curve(
                    f"Friction force over the time, pair {pair}",
                    "t",
                    f"friction force on {master}, {in_words(direction)}",
                    [line(times, force, pair, 1)],
                )
            )
        result.append(
            curve(
                f"Share of the contact area that sticks, pair {pair}",
                "t",
                "stick area / contact area",
                [line(times, stick_shares(found), pair, 2)],
                zero=True,
            )
        )
    return result


def of_obstacles(steps):
    """Of obstacles that move: the force on the bodies over the displacement, in the direction in which they move farthest."""
    result = []
    for i, name in enumerate(steps[-1].get("obstacles", {})):
        found = [step["obstacles"].get(name) for step in steps]
        if None in found:
            continue
        displacement = np.array([one["displacement"] for one in found])
        axis = int(np.argmax(np.ptp(displacement, axis=0)))
        force = np.array([one["force"][axis] for one in found])
        least = 1e-3 * max(np.linalg.norm(one["force"]) for one in found)  # less is what is left of a force across the motion
        if np.ptp(displacement[:, axis]) > 0 and abs(force).max() > least:
            result.append(
                curve(
                    f"Force over displacement, obstacle {name}",
                    f"displacement of {name} along {'xyz'[axis]}",
                    f"force on the bodies, {'xyz'[axis]}",
                    [line(displacement[:, axis], force, name, i)],
                )
            )
    return result


def over_meshes(results):
    """Values with their error bars over the size of the mesh, as far as meshes were refined for the last load step."""
    last = results.get("accuracy", {}).get("quantities", {})
    end = results["load_steps"][-1]["time"] if results.get("load_steps") else None
    cycles = [cycle for cycle in results.get("cycles", []) if cycle.get("accuracy", {}).get("time", end) == end]
    result = []
    for i, (name, found) in enumerate(last.items()):
        points = [
            (cycle["dofs"], cycle["accuracy"]["quantities"][name])
            for cycle in cycles
            if name in cycle["accuracy"].get("quantities", {})
        ]
        points.append((results["dofs"], found))
        if len(points) > 1:
            bars = {
                "type": "data",
                "array": [one["error_bound"] for _, one in points],
                "visible": True,
                "color": COLOURS[i % len(COLOURS)],
            }
            result.append(
                curve(
                    f"{name} with its error bar, mesh by mesh",
                    "degrees of freedom",
                    name,
                    [line([dofs for dofs, _ in points], [one["value"] for _, one in points], name, i, error_y=bars)],
                    log=True,
                )
            )
    return result
