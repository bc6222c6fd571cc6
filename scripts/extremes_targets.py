# SPDX-License-Identifier: Apache-2.0
"""Axes of scripts/extremes with targets: scenes with a known answer at extreme parameters, value +- bar against the answer.

Parameters are drawn at random, with one seed for each run, so that no factor of a bar was fitted on them: targets from 10 % to
0.05 %, moduli and lengths in units from 1e-9 to 1e9, thin and thick rings, contrasts of moduli, Poisson's ratios up to 0.5, soft
penalties. A run is right if all quantities are within their bars, refused with exit code 2 or 3, and wrong otherwise.
"""

import math
import random

from accuracy_cases import (BEAM, SCENES, Lame, Layer, beam, hertz, lame_fit, lame_quantities, probe, smooth, tubes,
                            without)

METHODS = ("auto", "penalty", "Lagrange multiplier", "augmented Lagrangian", "perturbed Lagrangian", "Nitsche", "direct elimination")
PER_LENGTH = {"normal force": (1, 1), "force": (1, 1), "reaction": (1, 1), "displacement": (1, 0), "stress": (0, 1), "von Mises": (0, 1),
              "largest pressure": (0, 1), "pressure": (0, 1), "contact area": (1, 0), "half-width": (1, 0), "contact radius": (1, 0),
              "energy": (2, 1)}


def drawn(axis, number):
    """The random numbers of a run."""
    return random.Random(f"{axis} {number}")


def logarithmic(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def ratio_of(draw):
    return draw.choice((0.0, 0.1, 0.3, 0.45, 0.49, 0.499, 0.4999, 0.5))


def units_of(draw):
    """Length and stress; half of the runs have those of the scene."""
    return (1.0, 1.0) if draw.random() < 0.5 else (10.0**draw.randint(-9, 9), 10.0**draw.randint(-9, 9))


def in_units(quantities, length, stress, axisymmetric=False):
    """References in other units; forces of the plane are per depth."""
    result = {}
    for name, value in quantities.items():
        lengths, stresses = next(powers for what, powers in PER_LENGTH.items() if name.startswith(what))
        if axisymmetric and (lengths, stresses) in ((1, 1), (2, 1)) or axisymmetric and name.startswith("contact area"):
            lengths += 1
        result[name] = value * length**lengths * stress**stresses
    return result


def ring(body, inner, outer, modulus, ratio, around, through, length, stress):
    return {f"Bodies/{body}/Inner radius": inner * length, f"Bodies/{body}/Outer radius": outer * length,
            f"Bodies/{body}/Young's modulus": modulus * stress, f"Bodies/{body}/Poisson's ratio": ratio,
            f"Bodies/{body}/Cells around": around, f"Bodies/{body}/Cells through": through}


def shrunk_rings(draw):
    """Two rings of any thickness and contrast, by Lame."""
    length, stress = units_of(draw)
    radius, contrast = 1.0, logarithmic(draw, 1e-3, 1e3)
    inner, outer = 1 - logarithmic(draw, 0.03, 0.8), 1 + logarithmic(draw, 0.03, 2)
    overlap, ratios = 1e-3 * logarithmic(draw, 0.1, 3), (ratio_of(draw), ratio_of(draw))
    keys = {**ring("inner", inner, radius + overlap, 1000, ratios[0], draw.randint(4, 20), draw.randint(1, 4), length, stress),
            **ring("outer", radius, outer, 1000 * contrast, ratios[1], draw.randint(4, 20), draw.randint(1, 4), length, stress),
            **probe(bore=("inner", f"{inner * length!r}, 0"), rim=("outer", f"{outer * length!r}, 0"))}
    found = lame_quantities(*lame_fit(Lame(1000, ratios[0], inner, radius + overlap), Lame(1000 * contrast, ratios[1], radius, outer)))
    # The closed form has the force of both circles of the overlap, which differ.
    return "shrink-fit", keys, in_units(found, length, stress), 2 * overlap


def soft_tubes(draw):
    """Two tubes at finite strain with a large interference; plane strain, or the shells of a ball."""
    length, stress = units_of(draw)
    m, contrast = draw.choice((1, 2)), logarithmic(draw, 0.1, 10)
    ratios = (draw.choice((0.2, 0.3, 0.4, 0.49)), draw.choice((0.2, 0.3, 0.4, 0.49)))
    inner, radius = 1.0, draw.uniform(1.25, 1.7)
    overlap, outer = draw.uniform(0.02, 0.2), radius * draw.uniform(1.2, 1.8)
    layers = [Layer(1, ratios[0], inner, radius + overlap), Layer(contrast, ratios[1], radius, outer)]
    keys = {**ring("inner", inner, radius + overlap, 1, ratios[0], draw.randint(6, 16), draw.randint(2, 4), length, stress),
            **ring("outer", radius, outer, contrast, ratios[1], draw.randint(6, 16), draw.randint(2, 4), length, stress),
            **probe(bore=("inner", f"{inner * length!r}, 0"), rim=("outer", f"{outer * length!r}, 0"))}
    found = tubes(layers, 1 - 0.5 * overlap, m, math.pi / 2 if m == 1 else 2 * math.pi)
    scene = "finite-shrink-fit" if m == 1 else "finite-shell-fit"
    return scene, keys, in_units(found, length, stress, axisymmetric=m == 2), 1e-6


def roller(draw):
    """A roller or a ball on a block, any Poisson's ratio, by Hertz; the block is as large as in the scenes of the tests."""
    length, stress = units_of(draw)
    nu, is_ball = ratio_of(draw), draw.random() < 0.5
    if is_ball:
        scene, keys = "hertz-axisymmetric", hertz(nu, 300, 10, 0.003180527, 1000 / (100 * math.pi), "sphere")
        found = {"force of contact": 1000, "largest pressure of contact": 470.1859, "contact radius of contact": 1.007711}
        keys |= {"Bodies/block/Corners": f"0,{-10 * length!r} : {10 * length!r},0", "Obstacles/sphere/Radius": 300 * length,
                 "Mesh/Refinement regions/near/Inside": f"{1.5 * length!r}^2 - x^2 - y^2"}
        way = "sphere"
    else:
        scene, keys, way = "hertz-2d", hertz(nu, 300, 20, 0.006324108, 15, "cylinder"), "cylinder"
        found = {"force of contact": 300, "largest pressure of contact": 374.3187, "half-width of contact": 1.020446 / 2}
        length = 1.0  # the scene has other lengths of its own
    keys["Bodies/block/Young's modulus"] *= stress
    down = float(keys[f"Obstacles/{way}/Displacement"].split(";")[1])
    keys[f"Obstacles/{way}/Displacement"] = f"0; {down * length!r}"
    # The closed forms are those of half-spaces, from which the blocks differ by as much.
    return scene, keys, in_units(found, length, stress, axisymmetric=is_ball), 2e-3


def tied_beam(draw):
    """A cantilever of two bodies tied together, by Timoshenko, with meshes that do not match."""
    stress, nu = 10.0**draw.randint(-9, 9), draw.choice((0.0, 0.3, 0.45, 0.49, 0.4999, 0.5))
    keys = {"Definitions/nu": nu, "Definitions/E": f"{1000 * stress!r}*(1 - nu^2)",
            "Bodies/left/Subdivisions": f"{draw.randint(3, 8)},{draw.randint(1, 5)}",
            "Bodies/right/Subdivisions": f"{draw.randint(3, 8)},{draw.randint(1, 5)}",
            "Loads/end/Traction": f"0; {stress!r}*(y^2 - 1)/2"}
    return BEAM, keys, in_units(without(beam(nu), "von Mises") if nu == 0 else beam(nu), 1, stress), 1e-7


def polynomial(draw):
    """incompressible-smooth: the answer is known, and body forces and supports follow from it."""
    nu = draw.choice((0.1, 0.3, 0.45, 0.49, 0.499, 0.4999, 0.49999, 0.5))
    keys = {"Definitions/nu": nu, "Mesh/Refinements": draw.randint(0, 2), **probe(q=("square", "0.4,0.6"))}
    return "incompressible-smooth", keys, smooth(nu), 1e-7


def run(runs, axis, number, make):
    draw = drawn(axis, number)
    scene, keys, quantities, known_to = make(draw)
    method, target = draw.choice(METHODS), round(logarithmic(draw, 5e-4, 0.1), 5)
    if method in ("penalty", "perturbed Lagrangian") and draw.random() < 0.3:
        keys[f"Contact method/{method}/Factor"] = draw.choice((1e-2, 1, 1e6))
    some = draw.sample(sorted(quantities), draw.randint(1, min(3, len(quantities))))
    keys |= {"Contact method/Method": method, "Contact method/Contact geometry": "automatic", "Accuracy/Quantity": ", ".join(some),
             "Accuracy/Target error": target, "Accuracy/Time limit": 0.2, "Accuracy/Refinement cycles": 0, "Expected results/Names": ""}
    scene_lines = (SCENES / f"{scene}.prm").read_text()
    value = f"{number}, target {100 * target:.2g} %"
    code, reason, results = runs.start(scene_lines, keys, ranks=draw.choice((1, 1, 1, 2)))
    kept = scene_lines + "".join(f"# --set \"{key}={entry}\"\n" for key, entry in keys.items())
    if code in (2, 3) and reason and "internal" not in reason:
        return runs.add(axis, value, method, "refused", None, reason, scene=kept)
    if code != 0 or results is None:
        return runs.add(axis, value, method, "wrong", None, f"exit code {code}: {reason}", scene=kept)
    worst, largest, notes, missed = 0, 0, [], False
    for name in some:
        found = results["accuracy"]["quantities"][name]
        error, scale = abs(abs(found["value"]) - abs(quantities[name])), abs(quantities[name]) or 1
        largest = max(largest, error / scale)
        missed = missed or not found.get("met", True)
        if found["error_bound"] is None:
            continue
        outside = error / (found["error_bound"] + known_to * scale)
        worst = max(worst, outside)
        if outside > 1:
            notes.append(f"{name}: off by {error / scale:.1e}, bar {found['error_bound'] / scale:.1e}")
    runs.add(axis, value, method, "wrong" if worst > 1 else "right", largest, "; ".join(notes), scene=kept, outside=worst,
             met=not missed)


def random_targets(runs):
    for name, make, number in (("rings", shrunk_rings, 70), ("soft tubes", soft_tubes, 50), ("roller", roller, 40),
                               ("tied beam", tied_beam, 40), ("polynomial", polynomial, 30)):
        axis = f"target: {name}"
        for n in range(number):
            if not runs.skip(axis):
                run(runs, axis, n, make)


AXES = (random_targets,)
