# SPDX-License-Identifier: Apache-2.0
"""Contact at the places at rest costs few Newton steps and few multigrid cycles;
neither depends on the clock. Krylov iterations on the saddle point are as good as independent of the mesh."""

from case import PRM, SCENES, Case, method, short

BALL = (PRM / "ball-on-block.prm", ["Accuracy/Refinement cycles=0", "Mesh/Refinements=1"])
NESTED = (PRM / "ball-on-block.prm", ["Accuracy/Refinement cycles=1", "Accuracy/Refine fraction=1",
                                      "Accuracy/Coarsen fraction=0"])
BLOCK = (PRM / "block-on-block.prm", [])


def cheap(scene, sets, newton, cycles):
    """At most `newton` steps in the last load step, and `cycles` of multigrid on the last mesh."""
    def body(test):
        results = test.results(scene, sets + ["Contact method/Contact geometry=reference", "Output/Linear reference=yes",
                                             "Newton/Tolerance=1e-8"], 2)
        step, linear = results["load_steps"][-1], results["linear_reference"]
        test.print(f"{results['dofs']} dofs, {step['newton_iterations']} Newton steps {step['krylov_iterations']}, "
                   f"{linear['contact_multigrid_cycles']} cycles, W = {linear['W']:.2f}, residual {step['residual']:.1e}")
        test.check(step["residual"] <= 1e-8, f"the residual is {step['residual']:.1e}")
        test.check(step["newton_iterations"] <= newton, f"{step['newton_iterations']} Newton steps, more than {newton}")
        test.check(linear["contact_multigrid_cycles"] <= cycles,
                   f"{linear['contact_multigrid_cycles']} cycles, more than {cycles}")
    return body


def few_updates(most):
    """Each update of the contact geometry costs a search, set-up and solution: the surfaces settle after few of them,
    also where open faces take part in the method."""
    def body(test):
        results = test.results(PRM / "ball-on-block.prm", ["Accuracy/Refinement cycles=2", *method("Nitsche")])
        steps = results["load_steps"][-1]["newton_iterations"]
        test.check(steps <= most, f"{steps} Newton steps on the last mesh, more than {most}")
    return body


def mesh_independent(gap, growth, levels=4, most=25):
    """Iterations of a Newton step: at most `most`, and on the finest mesh `growth` times those on the second (the first is
    hardly larger than its surface)."""
    def body(test):
        counts = []
        for level in range(levels):
            results = test.results(SCENES / "patch-3d.prm",
                                   ["Bodies/lower/Subdivisions=5,5,5", "Bodies/upper/Subdivisions=4,4,4",
                                    f"Contact pairs/interface/Initial gap={gap}", f"Mesh/Refinements={level}"])
            steps = [n for step in results["load_steps"] for n in step["krylov_iterations"]]
            counts.append(max(steps))
            test.print(f"{results['dofs']:10} dofs: {steps}")
        test.check(max(counts) <= most, f"more than {most} iterations: {counts}")
        test.check(counts[-1] <= growth * counts[1], f"the number of iterations grows by more than {growth:g}: {counts}")
    return body


def cases():
    def case(name, method_name, newton, cycles, scene, *sets):
        return Case("cost", f"{name}/{short(method_name)}", cheap(scene[0], scene[1] + list(sets) + method(method_name),
                                                                  newton, cycles), ranks=2, labels={"full"})

    # Regression: steps and cycles that the methods took when these bounds were set, and a little more.
    yield case("ball", "Lagrange multiplier", 5, 13, BALL)
    yield case("ball", "penalty", 6, 15, BALL)
    yield case("ball", "Nitsche", 6, 14, BALL)
    yield case("ball", "direct elimination", 6, 13, BALL)
    yield case("nested", "Lagrange multiplier", 4, 10, NESTED)
    yield case("block", "Lagrange multiplier", 3, 17, BLOCK)
    yield case("block", "augmented Lagrangian", 7, 28, BLOCK)
    yield case("block", "perturbed Lagrangian", 4, 20, BLOCK, "Contact method/perturbed Lagrangian/System=condensed")
    # It took 9 while each update changed the faces that take part, and takes 6.
    yield Case("cost", "updates/Nitsche", few_updates(7))
    # Regression: 13 in each refinement of the closed state; 12, 14, 15 in those of the half-open one.
    yield Case("cost/iterations", "closed", mesh_independent("closed", 1.2), labels={"full"})
    yield Case("cost/iterations", "half-open", mesh_independent("0.02*(x/10)^2", 1.3), labels={"full"})
