# SPDX-License-Identifier: Apache-2.0
"""All forces and all moments add up to nothing: contact forces on slave and master, reactions of supports, loads.

Forces across curved interfaces balance on any mesh: rings with 24 cells against 37 around (PUB-03), a ball on a block. So do
the moments if cells are shaped by the functions of the displacement, and forces act on them, not on the sphere that they
stand for; otherwise the error falls with the mesh where curved faces have hanging nodes."""

from case import PRM, SCENES, Case

CHOICES = {"multiplier": "Method=Lagrange multiplier", "standard": "Pressure basis=standard",
           "quadrature": "Integration=quadrature", "augmented": "Method=augmented Lagrangian",
           "perturbed": "Method=perturbed Lagrangian", "penalty": "Method=penalty", "nitsche": "Method=Nitsche",
           "elimination": "Method=direct elimination"}
BALL = PRM / "ball-on-block.prm"
EXACT = ["Newton/Tolerance=1e-12", "Newton/Geometry tolerance=1e-12"]
ONE_MESH = ["Accuracy/Refinement cycles=0"]
NOTHING_HANGS = ["Mesh/Geometry degree=1", "Mesh/Refinement regions/wide/Inside=1", "Mesh/Refinement regions/near/Inside=1", "Mesh/Refinement regions/near/Levels=1",
                 "Mesh/Refinement regions/contact/Levels=0"]


def balanced(scene, sets, most_moment, most_force=1e-9):
    """Forces relative to the largest; moments relative to that force times the size of the scene."""
    def body(test):
        for step in test.results(scene, sets, 2)["load_steps"]:
            for name, one in {"all": step, **step["bodies"]}.items():
                forces, moments = one["force_balance"], one["moment_balance"]
                test.print(f"t = {step['time']:<8g} {name}: forces {forces:8.1e}, moments {moments:8.1e}")
                test.check(forces <= most_force, f"forces on {name} do not balance: {forces:.1e}")
                test.check(moments <= most_moment,
                           f"moments on {name} do not balance: {moments:.1e}, allowed {most_moment:g}")
    return body


def cases():
    def case(name, *what):
        return Case("balance", name, balanced(*what), ranks=2, labels={"full"})

    for name, choice in CHOICES.items():
        sets = [f"Contact method/{choice}"]
        yield case(f"shrink-fit/{name}", SCENES / "shrink-fit.prm",
                   EXACT + sets + ["Bodies/inner/Cells around=24", "Bodies/outer/Cells around=37"], 1e-9)
        if name != "standard":  # whose weights do not see contact at a single node
            yield case(f"ball/{name}", BALL, EXACT + sets + ONE_MESH + NOTHING_HANGS, 1e-9)
    # Regression: 8.9e-8 and 2.0e-8 when these bounds were set: forces act on the sphere, hanging nodes are at chords.
    yield case("ball/hanging", BALL, EXACT + ONE_MESH, 2e-7)
    yield case("ball/tolerances-by-default", BALL, ONE_MESH, 1e-6, 1e-6)
    yield case("ball/hanging-refined", BALL, EXACT + ONE_MESH + ["Mesh/Refinements=1"], 4e-8)
