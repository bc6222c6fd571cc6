# SPDX-License-Identifier: Apache-2.0
"""What the program says of its errors, against closed forms: estimates, bars, targets; and the refusals."""

import math

from case import PRM, SCENES, TESTS, VARIED, Case, method, short

PUNCH = ("punch-axisymmetric.prm", "force of contact", 460.396)
SPHERE = ("hertz-axisymmetric.prm", "force of contact", 1000)
RINGS = ("shrink-fit.prm", "normal force of fit", 84.717379 * 30 * math.pi / 2)
FREE_BOUNDARY = ("polynomial.prm", "force of foot", 1 / 120)
# At finite strain closed forms are those of radial equilibrium (scripts/accuracy_cases.py).
RUBBER_FIT = ("finite-shrink-fit.prm", "normal force of fit", 0.189106163900)
RUBBER_ENERGY = ("finite-inflated-tube.prm", "energy", 0.0123606229135)
RUBBER_STRESS = ("finite-inflated-tube.prm", "stress yy of bore", 0.187954661694)
RUBBER_PEAK = ("finite-inflated-tube.prm", "largest von Mises of inner", 0.234727692282)
INCOMPRESSIBLE_FIT = ("finite-shrink-fit.prm", "normal force of fit", 0.255312205261)
INCOMPRESSIBLE_FOOT = ("incompressible-smooth.prm", "force of foot", 0.0362867532959)
CAVITY_ENERGY = ("finite-cavity.prm", "energy", 0.0711891650053)
PARTIAL_SLIP = ("friction-mindlin.prm", "friction force of interface", 89.93)
PRESSED_THEN_PULLED = ["Load steps/Times=1, 2", "Expected results/Names="]


def wanted(quantity, *more):
    return [f"Accuracy/Quantity={quantity}", *more]


def estimated(known, low, high, ranks, *sets):
    """On each mesh, what is estimated to be missing is between low and high times what is missing."""
    scene, quantity, exact = known

    def body(test):
        results = test.results(SCENES / scene, wanted(quantity, "Accuracy/Refinement cycles=2") + list(sets), ranks)
        for accuracy in [cycle["accuracy"] for cycle in results["cycles"]] + [results["accuracy"]]:
            found = accuracy["quantities"][quantity]
            missing = exact - found["value"]
            said = sum(part for name, part in found["parts"].items() if name != "model")
            test.print(f"{found['value']:.6g}: {missing:.3g} is missing, {said:.3g} is estimated")
            test.check(low <= said / missing <= high, f"{said:.3g} estimated of {missing:.3g}")
            test.check(abs(missing) <= found["error_bound"], f"{missing:.3g} is outside of the bar {found['error_bound']:.3g}")
    return body


def unsolved(method_sets):
    """The part of the solver is what further steps of it change."""
    scene, quantity, _ = SPHERE

    def body(test):
        rough, good = (test.results(SCENES / scene, wanted(quantity, f"Newton/Tolerance={tolerance}") + method_sets)
                       for tolerance in (1e-3, 1e-11))
        before, after = (results["accuracy"]["quantities"][quantity] for results in (rough, good))
        change, said = after["value"] - before["value"], before["parts"]["algebraic"]
        test.print(f"changes by {change:.3g}, {said:.3g} was estimated")
        test.check(abs(change - said) <= 0.05 * abs(change) + 1e-7 * abs(after["value"]), f"{said:.3g} of {change:.3g}")
    return body


def soft_penalty(test):
    """The part of a soft penalty is what a stiff one changes; a target makes it stiffer."""
    scene, quantity, exact = SPHERE
    soft, stiff = (test.results(SCENES / scene, wanted(quantity) + method("penalty", Factor=factor)) for factor in (30, 1e6))
    before, after = (results["accuracy"]["quantities"][quantity] for results in (soft, stiff))
    change, said = after["value"] - before["value"], before["parts"]["enforcement"]
    test.print(f"changes by {change:.3g}, {said:.3g} was estimated")
    test.check(abs(change - said) <= 0.1 * abs(change), f"{said:.3g} of {change:.3g}")
    results = test.results(SCENES / scene, wanted(quantity, "Accuracy/Target error=5e-3") + method("penalty", Factor=30), 2)
    reached(test, results, quantity, exact)


def reached(test, results, quantity, exact):
    found = results["accuracy"]["quantities"][quantity]
    test.print(f"{found['value']:.7g} +- {found['error_bound']:.2g}, {len(results['cycles']) + 1} meshes, {results['dofs']} dofs")
    test.check(found["met"], f"the target is not met: {results['accuracy']['reason']}")
    test.check(abs(found["value"] - exact) <= found["error_bound"], f"{exact} is outside")
    return found


def aimed_at(known, target, most_dofs, ranks, *sets):
    scene, quantity, exact = known

    def body(test):
        results = test.results(SCENES / scene, wanted(quantity, f"Accuracy/Target error={target}") + list(sets), ranks)
        found = reached(test, results, quantity, exact)
        test.check(found["error_bound"] <= target * abs(found["value"]), "the bar is larger than the target")
        test.check(abs(found["parts"]["algebraic"]) <= 0.1 * found["error_bound"], "the solver's part is more than a tenth")
        test.check(results["dofs"] <= most_dofs, f"{results['dofs']} degrees of freedom, more than {most_dofs}")
    return body


def quadratic_where_it_pays(test):
    """Method = auto starts with degree 1, and raises that of the body that the error comes from alone."""
    scene, quantity, exact = SPHERE
    soft = ["Bodies/Names=block, pad", "Bodies/pad/Mesh=box", "Bodies/pad/Corners=30,0 : 31,1", "Bodies/pad/Young's modulus=1",
            "Bodies/pad/Poisson's ratio=0", "Supports/Names=sides, pad", "Supports/pad/Boundaries=pad.bottom",
            "Supports/pad/Displacement=0; 0"]
    results = test.results(SCENES / scene, wanted(quantity, "Accuracy/Target error=2e-3", "Contact method/Method=auto") + soft, 2)
    reached(test, results, quantity, exact)
    test.check(results["degrees"] == {"block": 2, "pad": 1}, f"the degrees are {results['degrees']}")
    # With any method: three rings need few large cells of degree 2, or many of degree 1.
    rings = test.results(SCENES / "spun-rings.prm", ["Accuracy/Target error=1e-3"])
    test.check(set(rings["degrees"].values()) == {2} and rings["dofs"] < 4000, f"{rings['degrees']}, {rings['dofs']} degrees of freedom")
    rough = test.results(SCENES / scene, wanted(quantity, "Accuracy/Target error=5e-2", "Contact method/Method=auto"))
    test.check(rough["degrees"] == {"block": 1}, f"the degrees are {rough['degrees']}")


def held_cell(test):
    """Between prescribed nodes nothing is known: the bar says so, and with a target the mesh gets nodes there."""
    scene, quantity = VARIED / "held-layer.prm", "von Mises of q"
    fine = test.results(scene, wanted(quantity, "Bodies/b/Subdivisions=64,8", "Bodies/b/Degree=2"))["accuracy"]["quantities"][quantity]["value"]
    coarse = test.results(scene, wanted(quantity))["accuracy"]["quantities"][quantity]
    test.check(coarse["error_bound"] >= coarse["value"] > 0, f"{coarse}")
    reached(test, test.results(scene, wanted(quantity, "Accuracy/Target error=0.02")), quantity, fine)


def nitsche_energy(test):
    """The energy is no functional that Nitsche's method treats consistently: the gaps that it leaves are most of the error."""
    scene, quantities, exact = SCENES / "shrink-fit-axisymmetric.prm", ("normal force of fit", "energy"), {}
    fine = test.results(scene, wanted(", ".join(quantities), "Mesh/Degree=2", "Mesh/Refinements=2", "Expected results/Names="))
    for quantity in quantities:
        exact[quantity] = fine["accuracy"]["quantities"][quantity]["value"]
    for theta in (1, 0, -1):
        found = test.results(scene, wanted(", ".join(quantities), "Expected results/Names=") + method("Nitsche", Theta=theta))
        for quantity, one in found["accuracy"]["quantities"].items():
            missing = exact[quantity] - one["value"]
            test.print(f"Theta {theta}: {quantity} {one['value']:.7g} +- {one['error_bound']:.2g}, {missing:.2g} is missing")
            test.check(abs(missing) <= one["error_bound"] <= 12 * abs(missing), f"{quantity}, Theta {theta}")


def beyond_buckling(test):
    """Where the tangent is not positive definite no linearisation tells the error: no bar, and the reason."""
    results = test.results(SCENES / "finite-block.prm",
                           wanted("force of top", "Obstacles/plate/Displacement=0; -0.6*t", "Bodies/block/Subdivisions=8,8",
                                  "Accuracy/Target error=1e-2", "Load steps/Number=3"))
    bars = [step["accuracy"]["quantities"]["force of top"]["error_bound"] for step in results["load_steps"]]
    test.check(bars[0] < 1e-6 and bars[1] < 1e-6 and bars[2] is None, f"{bars}")
    test.check("not positive definite" in results["accuracy"]["reason"], results["accuracy"]["reason"])


def nothing_there(test):
    """A quantity that is zero has no relative bound: the refinement ends and says so."""
    results = test.results(SCENES / RINGS[0], wanted("reaction y of symmetry y", "Accuracy/Target error=1e-2"))
    test.check("is zero, as far as" in results["accuracy"]["reason"], results["accuracy"]["reason"])
    test.check(results["dofs"] < 20000, f"{results['dofs']} degrees of freedom")


def each_load_step(test):
    """With friction too each load step has bars, which contain what finer meshes and shorter load steps find."""
    names = ("friction force of interface", "stick area of interface")
    scene, coarse = SCENES / PARTIAL_SLIP[0], ["Mesh/Refinement regions/contact/Levels=1", "Load steps/Times=1, 2, 3", "Expected results/Names="]
    steps, fine = (test.results(scene, wanted(", ".join(names), *coarse, *more), 2)["load_steps"]
                   for more in ([], ["Mesh/Refinement regions/contact/Levels=3", "Accuracy/Load steps=last"]))
    for step, better in zip(steps[1:], fine[1:]):
        pair = better["pairs"]["interface"]
        exact = {names[0]: math.hypot(*pair["friction_force"]), names[1]: pair["stick_area"]}
        for name in names:
            found = step["accuracy"]["quantities"][name]
            test.print(f"t = {step['time']}: {name} {found['value']:.5g} +- {found['error_bound']:.2g}, better {exact[name]:.5g}")
            test.check(abs(found["value"] - exact[name]) <= found["error_bound"], f"{name} at {step['time']}")
    test.check(fine[1]["accuracy"] is None and fine[2]["accuracy"] is not None, "Load steps = last")


def without_limit(test):
    quantity = "largest pressure of contact"
    results = test.results(SCENES / PUNCH[0], wanted(quantity, "Accuracy/Target error=1e-2"))
    test.check(not results["accuracy"]["met"], "the pressure under a sharp edge has no limit")
    test.check("grows with every refinement" in results["accuracy"]["reason"], results["accuracy"]["reason"])
    test.check(results["verdict"]["outcome"] == "warned", results["verdict"]["outcome"])


def clamped_edge(test):
    """Stresses at the end of a clamped edge have no limit, those elsewhere have bars; so have those on a plane of symmetry."""
    clamped = ["Supports/side/Type=displacement", "Supports/side/Displacement=0; 0", "Output/Probes/Names=edge, near",
               "Output/Probes/edge/Body=block", "Output/Probes/edge/Point=0,1", "Output/Probes/near/Body=block", "Output/Probes/near/Point=0.3,0.8",
               "Mesh/Degree=2", "Loads/press/Pressure=0", "Loads/shear/Traction=0; 1"]
    names = "von Mises of edge, von Mises of near, largest von Mises of block"
    for supports, unlimited in ((clamped, (True, False, True)), (clamped[2:-2], (False, False, False))):
        results = test.results(VARIED / "block.prm", wanted(names, *supports), ranks=2)
        for name, is_unlimited in zip(names.split(", "), unlimited):
            found = results["accuracy"]["quantities"][name]
            test.print(f"{name} {found['value']:.4g} +- {found['error_bound']}")
            test.check(found["singular"] == is_unlimited and (found["error_bound"] is None) == is_unlimited, f"{name}: {found['error_bound']}")
        warned = [check["check"] for check in results["verdict"]["checks"] if check["outcome"] == "warned"]
        test.check(("stress without limit" in warned) == any(unlimited), f"warnings: {warned}")


def peak_within_a_face(sets):
    """The first mesh does not see how high the peak is, and says so; the bar holds there and at the end."""
    def body(test):
        quantity, exact, warned = "largest pressure of c", 62.9, []
        for more in (["Accuracy/Refinement cycles=0"], ["Accuracy/Target error=0.1"]):
            results = test.results(TESTS / "varied" / "rounded-edge.prm", wanted(quantity, *more) + sets)
            found = results["accuracy"]["quantities"][quantity]
            test.print(f"{found['value']:.4g} +- {found['error_bound']:.2g}")
            test.check(abs(found["value"] - exact) <= found["error_bound"], f"{exact} is outside of {found['value']} +- {found['error_bound']}")
            warned.append("pressure peak resolution" in [check["check"] for check in results["verdict"]["checks"]
                                                      if check["outcome"] == "warned"])
        test.check(warned[0], "the peak of the first mesh is not warned of")
    return body


def tip_on_one_face(sets):
    """Nobody knows where on its face a tip presses; the reference is the scene's with a target of 1e-4."""
    def body(test):
        quantity = "force of tip"
        results = test.results(PRM / "leaf-spring.prm", wanted(quantity) + sets, 2)
        found = results["accuracy"]["quantities"][quantity]
        test.print(f"{found['value']:.6g} +- {found['error_bound']:.2g}")
        test.check(abs(found["value"] - 11.7948) <= found["error_bound"], "11.7948 is outside of the bar")
        test.check(found["error_bound"] <= 0.02 * found["value"], f"the bar is as large as {found['error_bound']:.2g}")
    return body


def on_the_axis(test):
    """Of degree 2 the node there has no area: its pressure is what the others say."""
    for sets in (method("Lagrange multiplier"), method("Nitsche")):
        results = test.results(SCENES / SPHERE[0], ["Mesh/Degree=2", "Output/Probes/Names=axis", "Output/Probes/axis/Pair=contact",
                                                    "Output/Probes/axis/Point=0,0"] + sets)
        pressure = results["load_steps"][-1]["probes"]["axis"]["pressure"]
        test.check(abs(pressure - 470.1859) <= 2e-3 * 470.1859, f"{pressure} instead of 470.1859")


def there_and_back(test):
    """Meshes that are made for other load steps than the last one say nothing of its bars. The references are those of the end alone
    with a target of 0.2 %."""
    results = test.results(SCENES / "history-with-target.prm", [
        "Bodies/a/Corners=-2,-1 : 2,0", "Bodies/a/Subdivisions=32,8", "Obstacles/o/Center=0,1", "Obstacles/o/Displacement=-1.2 + 1.2*t; -0.01",
        "Load steps/End time=2", "Accuracy/Target error=0.03", "Expected results/Names="])
    for quantity, exact in (("largest pressure of c", 43.006), ("force of c", 5.3263)):
        reached(test, results, quantity, exact)
    test.check(results["verdict"]["outcome"] == "passed", f"the verdict is {results['verdict']['outcome']}")


def no_time(test):
    results = test.results(SCENES / PUNCH[0], wanted(PUNCH[1], "Accuracy/Target error=1e-4", "Accuracy/Time limit=1e-4"))
    found = results["accuracy"]["quantities"][PUNCH[1]]
    test.check(not found["met"] and "Time limit" in results["accuracy"]["reason"], results["accuracy"]["reason"])
    test.check(abs(found["value"] - PUNCH[2]) <= found["error_bound"], "the exact value is outside of the bar")


def path_of_friction(test):
    """A hard block is pressed down and pulled at the same time: the stick zone of one load step is too small by a third. Bars hold for
    twenty load steps, by their part of the path. Pressed first and pulled then, load steps do not matter, and that part is nothing."""
    together = ["Definitions/q=0.002905292*t", "Bodies/upper/Young's modulus=1e6", "Bodies/lower/Subdivisions=10,5",
                "Bodies/upper/Subdivisions=10,5", "Mesh/Refinement regions/contact/Levels=2", "Expected results/Names="]
    names = {"friction force of interface": lambda pair: math.hypot(*pair["friction_force"]),
             "stick area of interface": lambda pair: pair["stick_area"],
             "friction work of interface": lambda pair: pair["total_friction_work"]}
    scene, quantities = SCENES / PARTIAL_SLIP[0], wanted(", ".join(names))
    twenty = ", ".join(f"{n / 20}" for n in range(1, 21))
    in_twenty = test.results(scene, [*together, f"Load steps/Times={twenty}"], 2)["load_steps"][-1]["pairs"]["interface"]
    in_one, then = (test.results(scene, [*quantities, *sets], 2)["accuracy"]["quantities"]
                    for sets in ([*together, "Load steps/Times=1"], [*together[2:], *PRESSED_THEN_PULLED]))
    for name, value in names.items():
        found, exact = in_one[name], value(in_twenty)
        change, path = abs(found["value"] - exact), found["parts"]["path"]
        test.print(f"{name}: {found['value']:.4g} +- {found['error_bound']:.2g} (path {path:.2g}), in twenty steps {exact:.4g}; "
                   f"then {then[name]['value']:.4g}, path {then[name]['parts']['path']:.2g}")
        test.check(change <= found["error_bound"], f"{name}: {exact} is outside of {found['value']} +- {found['error_bound']}")
        test.check(name != "stick area of interface" or change > found["error_bound"] - path, f"{name} needs no part of the path")
        test.check(then[name]["parts"]["path"] <= 1e-5 * then[name]["value"], f"{name}: there is no path")


def halves_that_agree(test):
    """In this turn of slip one and two parts of a load step have the same tractions, and four have not: two histories tell nothing.
    With a target load steps are divided until bars contain the tractions of infinitely many."""
    names = {"friction force x of interface": 0.3208384848, "friction force y of interface": -0.5070134778}
    scene = [*wanted(", ".join(names), "Accuracy/Target error=0.2"), *method("Nitsche"), "Contact method/Contact geometry=reference",
             "Expected results/Names="]
    results = test.results(SCENES / "friction-patch.prm", scene)
    for name, exact in names.items():
        found = results["accuracy"]["quantities"][name]
        test.print(f"{name}: {found['value']:.6g} +- {found['error_bound']:.2g}, path {found['parts']['path']:.2g}")
        test.check(found["met"] and abs(found["value"] - exact) <= found["error_bound"], f"{exact} is outside, or the target is not met")


def full_slip(test):
    """Where all points slip, also about nodes whose normal displacement is prescribed, errors of pressure and traction cancel in the
    force of friction: its mesh part is not as large as the force."""
    results = test.results(SCENES / "friction-cycles.prm", wanted("friction force of foot", "Expected results/Names="))
    for step in results["load_steps"][1:]:
        found = step["accuracy"]["quantities"]["friction force of foot"]
        test.check(abs(found["parts"]["discretisation"]) < 1e-3 * found["value"], f"t = {step['time']}: {found['parts']}")


def layers(test):
    """Bodies that are one cell thick bend too stiffly, and the samples of one cell do not show it; a displacement between nodes
    misses what no dual solution shows. A cantilever of two tied bodies, by Timoshenko."""
    k = 3 / 7  # nu/(1 - nu)
    exact = {"displacement y of tip": -1e-3 * (8**3 / 3 + (1 + k) * 8), "energy": 1e-3 * (8**3 / 3 * 2 / 3 / 2 + (1 + k) / 4 * 8 * 16 / 15)}
    for subdivisions, target in ((("5,1", "8,3"), 0.05), (("6,3", "4,1"), 0.01), (("4,1", "4,1"), None)):
        sets = [f"Bodies/{body}/Subdivisions={one}" for body, one in zip(("left", "right"), subdivisions)]
        sets += [f"Accuracy/Target error={target}"] if target else []
        results = test.results(VARIED / "tied-beam.prm", wanted(", ".join(exact), *sets))
        for name, value in exact.items():
            found = results["accuracy"]["quantities"][name]
            test.print(f"{subdivisions}: {name} {found['value']:.5g} +- {found['error_bound']:.2g}, exact {value:.5g}")
            test.check(abs(found["value"] - value) <= found["error_bound"], f"{value} is outside")


def gauss(center, width, end):
    """Its integral from zero to the end."""
    return width * math.sqrt(math.pi) / 2 * (math.erf((end - center) / width) + math.erf(center / width))


# A block on a plane, with what bars did not see: (quantity, value, what is known of that; target; changes of the scene).
UNSEEN = {
    "load within a cell": ("force of foot", 5 + 100 * gauss(1.23, 0.2, 4) * gauss(0.6, 0.2, 1), 0, 1e-2,
                           ["Loads/weight/Body force=0; -100*exp(-((x - 1.23)/0.2)^2 - ((y - 0.6)/0.2)^2)"]),
    # All of the block slips, 0.4 times its load of 5.
    "friction at a plane of symmetry": ("friction force x of foot", 2, 0, 1e-2,
                                        ["Bodies/block/Thermal expansion=1e-3", "Load steps/Times=1, 2, 3", "Contact pairs/foot/Friction=0.4",
                                         "Bodies/block/Temperature=table(t, 0,0, 1,0, 2,10, 3,-5)*(1 + 0.3*x/4)",
                                         "Loads/shear/Traction=0.3*table(t, 1,0, 2,0.5, 3,-1); 0"]),
    "support within a cell": ("force of foot", 44.92992, 1e-4, 6e-2,
                              ["Supports/Names=side, top", "Supports/top/Boundaries=block.top", "Loads/press/Pressure=0",
                               "Supports/top/Displacement=free; -0.01*(1 + exp(-((x - 1.23)/0.05)^2))"]),
    # The law of the layer is that of nodes.
    "compliant interface": ("displacement y of corner", -0.03084076, 1e-8, 2e-2,
                            ["Contact pairs/foot/Pressure-overclosure=linear", "Contact pairs/foot/Normal stiffness=50"]),
    "pressure at a point": ("pressure of under", 0.8971686, 4e-6, 3e-2, ["Loads/press/Pressure=1 + 0.5*cos(pi*x)"]),
    # A linear temperature that is free to bend the block, by degree 2.
    "temperature within a cell": ("displacement y of corner", 0.0506385996, 1e-9, 1e-2,
                                  ["Bodies/block/Thermal expansion=1e-3", "Bodies/block/Temperature=10*x", "Mesh/Degree=1"]),
}


def unseen(quantity, exact, known_to, target, sets):
    def body(test):
        found = reached(test, test.results(VARIED / "block.prm", wanted(quantity, f"Accuracy/Target error={target}", *sets), 2), quantity, exact)
        test.check(abs(found["value"] - exact) <= target * abs(exact) + known_to, "the target is missed")
    return body


def soft_layer(test):
    """A soft layer of one cell between a wall and a stiff body cannot bulge; the value is that of degree 2 on a fine mesh."""
    name, exact, known_to = "displacement y of corner", -0.0115068, 1.4e-5
    for sets in (["Accuracy/Target error=1e-2"], []):
        results = test.results(VARIED / "soft-layer.prm", wanted(name, *sets))
        found = results["accuracy"]["quantities"][name]
        test.print(f"{found['value']:.6g} +- {found['error_bound']:.2g}")
        test.check(abs(found["value"] - exact) <= found["error_bound"] + known_to, f"{exact} is outside")


def between_nodes(test):
    """A displacement at a point that is no node: the scene's A, B, m0 and E = 1."""
    x, y, name = 0.4, 0.6, "displacement y of q"
    for nu in (0.3, 0.5):
        c = (1 + nu) * (1 - 2 * nu) / nu
        exact = -0.006 * math.cos(3 * x) * math.sin(2 * y) + c * (-0.003 * math.cos(2 * x) * math.sin(3 * y) - 0.015 * y)
        probe = ["Output/Probes/Names=q", "Output/Probes/q/Body=square", f"Output/Probes/q/Point={x},{y}"]
        reached(test, test.results(SCENES / INCOMPRESSIBLE_FOOT[0], wanted(name, f"Definitions/nu={nu}", "Accuracy/Target error=4e-3", *probe)),
                name, exact)


def same_on_ranks(test):
    """Bars do not depend on the number of ranks; cells that are joined do a little, since they may be on different ranks."""
    for cycles, tolerance in ((0, 2e-3), (2, 0.02)):
        one, four = (test.results(SCENES / PUNCH[0], wanted(PUNCH[1], f"Accuracy/Refinement cycles={cycles}"), ranks)
                     for ranks in (1, 4))
        for name in ("value", "error_bound", "absolute"):
            a, b = (results["accuracy"]["quantities"][PUNCH[1]][name] for results in (one, four))
            test.check(abs(a - b) <= tolerance * abs(a), f"{name}: {a} on one rank, {b} on four")


def cases():
    for name in ("Lagrange multiplier", "penalty", "Nitsche"):
        yield Case("accuracy", f"solver/{short(name)}", unsolved(method(name)))
        yield Case("accuracy", f"sphere/{short(name)}", estimated(SPHERE, 0.9, 1.35, 2, *method(name)), ranks=2)
        yield Case("accuracy", f"punch/{short(name)}", estimated(PUNCH, 0.75, 1.25, 1, *method(name)))
    yield Case("accuracy", "solver/unsymmetric", unsolved(method("Nitsche", Theta=0)))
    yield Case("accuracy", "solver/saddle point", unsolved(["Solver/Preconditioner=block triangular"]))
    yield Case("accuracy", "punch/direct", estimated(PUNCH, 0.75, 1.25, 1, "Solver/Preconditioner=direct", *method("Nitsche", Theta=0)))
    yield Case("accuracy", "rings", estimated(RINGS, 0.9, 1.3, 2), ranks=2)
    yield Case("accuracy", "held corner", estimated(FREE_BOUNDARY, 0.6, 1.2, 2, "Mesh/Degree=2"), ranks=2)
    yield Case("accuracy", "finite/fit", estimated(RUBBER_FIT, 0.9, 1.2, 2), ranks=2)
    yield Case("accuracy", "finite/energy", estimated(RUBBER_ENERGY, 0.8, 2, 1))
    yield Case("accuracy", "finite/stress", estimated(RUBBER_STRESS, 0.6, 1.6, 2), ranks=2)
    yield Case("accuracy", "finite/largest stress", estimated(RUBBER_PEAK, 0.5, 1.5, 2), ranks=2)
    yield Case("accuracy", "finite/strips", estimated(CAVITY_ENERGY, 0.9, 1.1, 1))
    yield Case("accuracy", "finite/target", aimed_at(RUBBER_FIT, 1e-3, 8000, 2), ranks=2)
    yield Case("accuracy", "finite/beyond buckling", beyond_buckling)
    yield Case("accuracy", "mixed/finite", aimed_at(INCOMPRESSIBLE_FIT, 1e-4, 8000, 1, "Bodies/inner/Poisson's ratio=0.5",
                                                    "Bodies/outer/Poisson's ratio=0.5"))
    yield Case("accuracy", "mixed/smooth", aimed_at(INCOMPRESSIBLE_FOOT, 1e-3, 8000, 1, "Definitions/nu=0.5", "Mesh/Refinements=1"))
    yield Case("accuracy", "Nitsche's energy", nitsche_energy)
    yield Case("accuracy", "zero", nothing_there)
    yield Case("accuracy", "friction/each load step", each_load_step, ranks=2)
    yield Case("accuracy", "axis", on_the_axis)
    for name in ("Lagrange multiplier", "Nitsche"):
        yield Case("accuracy", f"tip/{short(name)}", tip_on_one_face(method(name)), ranks=2)
        yield Case("accuracy", f"peak/{short(name)}", peak_within_a_face(method(name)))
    yield Case("accuracy", "soft penalty", soft_penalty, ranks=2)
    yield Case("accuracy", "target/punch", aimed_at(PUNCH, 2e-3, 12000, 2), ranks=2)
    yield Case("accuracy", "target/degrees", quadratic_where_it_pays, ranks=2)
    yield Case("accuracy", "target/degree 2", aimed_at(PUNCH, 2e-4, 30000, 2, "Mesh/Degree=2"), ranks=2)
    yield Case("accuracy", "target/rings", aimed_at(RINGS, 2e-3, 3000, 1))
    yield Case("accuracy", "target/free boundary", aimed_at(FREE_BOUNDARY, 2e-3, 8000, 1))
    yield Case("accuracy", "target/chosen method", aimed_at(PUNCH, 2e-4, 30000, 2, *method("auto")), ranks=2)
    yield Case("accuracy", "friction/path", path_of_friction, ranks=2)
    yield Case("accuracy", "friction/target", aimed_at(PARTIAL_SLIP, 2e-2, 12000, 2, "Mesh/Refinement regions/near/Levels=0",
                                                       "Mesh/Refinement regions/contact/Levels=0", *PRESSED_THEN_PULLED), ranks=2)
    yield Case("accuracy", "friction/halves that agree", halves_that_agree)
    yield Case("accuracy", "friction/full slip", full_slip)
    yield Case("accuracy", "layers", layers)
    yield Case("accuracy", "soft layer", soft_layer)
    for name, (quantity, exact, known_to, target, sets) in UNSEEN.items():
        yield Case("accuracy", name, unseen(quantity, exact, known_to, target, sets), ranks=2)
    yield Case("accuracy", "between nodes", between_nodes)
    yield Case("accuracy", "without limit", without_limit)
    yield Case("accuracy", "clamped edge", clamped_edge, ranks=2)
    yield Case("accuracy", "held cell", held_cell)
    yield Case("accuracy", "history", there_and_back)
    yield Case("accuracy", "no time", no_time)
    yield Case("accuracy", "ranks", same_on_ranks, ranks=4)
