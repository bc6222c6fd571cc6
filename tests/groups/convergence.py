# SPDX-License-Identifier: Apache-2.0
"""Errors fall at the rates of theory: the rate from the last mesh but one to the last is asserted, and the last error.

What was measured stands in the scenes. Bounds are the orders of theory less a tenth (that far from the limit are meshes that
a test can afford), or two tenths where the rim of the contact, at another place within a cell in each mesh, makes them vary."""

import math

from case import SCENES, Case, method, number, short


def converges(scene, values, quantity, least, last_error=math.inf, reference=None, reference_sets=None, sets=(), key=None,
              text="{:g}", since=-2):
    """values: numbers to which 1/h (or what the error falls with) is proportional, put into `key`; without key, numbers of
    refinements, each of which halves h. reference: None if the quantity is the relative error itself. since: the place of
    the value from which on the rate is taken, to the last one."""
    def body(test):
        path = SCENES / f"{scene}.prm"
        target = reference
        if reference_sets:
            target = number(test.results(path, [*sets, *reference_sets]), quantity)
        errors = []
        for value in values:
            setting = f"{key}={text.format(value)}" if key else f"Mesh/Refinements={value}"
            found = number(test.results(path, [*sets, setting]), quantity)
            error = abs(found) if target is None else abs(found / target - 1)
            # Where the error is nothing but rounding, its logarithm must exist all the same.
            errors.append(max(error, 1e-15))
            rate = f"{rate_of(values, errors, key):6.2f}" if len(errors) > 1 else ""
            test.print(f"{setting:>45} {found:16.9g} {errors[-1]:12.2e} {rate}")
        if least is not None:
            rate = rate_of(values, errors, key, since)
            test.check(rate >= least, f"the last rate is {rate:.2f}, at least {least:g} is wanted")
        test.check(errors[-1] <= last_error, f"the last error is {errors[-1]:.2e}, larger than {last_error:g}")
    return body


def rate_of(values, errors, key, since=-2):
    """From the value at place `since` to the last, of those that have an error."""
    now, before = values[len(errors) - 1], values[:len(errors)][since]
    ratio = math.log(now / before) if key else (now - before) * math.log(2)
    return math.log(errors[since] / errors[-1]) / ratio


BOTH = ("penalty", "Lagrange multiplier")


def per_method(test, name, methods=BOTH, label="full", **what):
    for one in methods:
        arguments = {**what, "sets": [*what.get("sets", ()), *method(one)]}
        yield Case(f"convergence/{test}", f"{name}/{short(one)}", converges(**arguments), labels={label})


def cases():
    yield from closed_forms()
    yield from polynomials()
    yield from half_space()
    yield from conditions()
    yield from penalty_factor()
    # The error of quadrature on whole faces, where meshes do not match, falls with the number of points, in leaps: it
    # depends on where the kinks lie between points.
    yield from per_method("quadrature", "patch-2d", label="quick", scene="patch-2d", values=(2, 4, 8, 16),
                          key="Contact method/Quadrature points", quantity="pairs/interface/max_pressure",
                          reference=115.7407, least=1.2, since=0,
                          sets=["Contact method/Integration=quadrature", "Contact method/penalty/Factor=1e6"])


def closed_forms():
    """References are explained in the scenes."""
    def table(name, scene, levels, quantity, reference, least, last, label="full", sets=(), since=-2):
        return per_method("closed-forms", name, BOTH, label, scene=scene, values=range(levels), quantity=quantity,
                          reference=reference, least=least, last_error=last, sets=sets, since=since)

    stiff = ["Contact method/penalty/Factor=1e5"]
    yield from table("shrink-fit-force", "shrink-fit", 4, "pairs/fit/force/0", 2541.52136, 1.9, 1e-4, "quick")
    yield from table("shrink-fit-rim", "shrink-fit", 4, "probes/rim/displacement/0", 0.0277534133, 1.9, 5e-5, "quick")
    yield from table("hertz-2d-force", "hertz-2d", 4, "pairs/contact/force/1", -300, 1.8, 4e-4)
    yield from table("hertz-2d-pressure", "hertz-2d", 4, "pairs/contact/max_pressure", 374.3187, 1.8, 3e-4)
    yield from table("hertz-axisymmetric-force", "hertz-axisymmetric", 4, "pairs/contact/force/1", -1000, 1.9, 4e-4)
    # The order of degree 2 shows in half-space(): here the reference, of a cylinder, has four to five digits.
    yield from table("hertz-axisymmetric-degree-2", "hertz-axisymmetric", 3, "pairs/contact/force/1", -1000, 1.9, 5e-5,
                     sets=["Mesh/Degree=2", *stiff])
    yield from table("shrink-fit-axisymmetric", "shrink-fit-axisymmetric", 3, "pairs/fit/normal_force", 31937.7, 1.9, 1e-4,
                     "quick", stiff)
    yield from table("hertz-2d-indentation", "hertz-2d-force", 4, "obstacles/cylinder/displacement/1", -0.006324108, 1.8,
                     3e-4)
    # Both bodies curved, meshes that do not match, an approach of several cells. The references are those of degree 2 with
    # 320 cells, to four or five digits.
    degree_1 = ["Mesh/Degree=1"]
    yield from table("two-curved-force", "two-curved", 4, "pairs/faces/force/1", 129700, 1.8, 1e-3, sets=degree_1)
    yield from table("two-curved-pressure", "two-curved", 4, "pairs/faces/max_pressure", 19441, 1.8, 1.5e-3, sets=degree_1)
    yield from table("two-curved-degree-2", "two-curved", 2, "pairs/faces/force/1", 129700, 2.5, 2e-4)
    coarse = ["Definitions/n=8", "Definitions/m=7"]
    yield from table("two-curved-3d-force", "two-curved-3d", 3, "pairs/faces/force/2", 1.89397e6, 1.7, 3e-3, sets=coarse)
    yield from table("two-curved-3d-pressure", "two-curved-3d", 3, "pairs/faces/max_pressure", 31660, 1.8, 1e-3, sets=coarse)
    # Between nodes: a fifth of a face.
    yield from table("layer-length", "layer", 3, "pairs/contact/area", 10.07782, -1, 2e-3, since=0)
    # A penalty stiff enough not to hide it behind its own penetration, which is of order one.
    yield from table("hertz-2d-between-nodes", "hertz-2d", 4, "pairs/contact/at_points/max_penetration", None, 1.9, 1e-6,
                     sets=stiff)


def polynomials():
    """On meshes where the rim of the contact is never at a node: O(h) in energy for degree 1; for degree 2 O(h^1.5), or
    O(h^2) where the solution is smoother; O(h^1.5) in the pressure. Penalties of E/h lose the latter, those that grow keep it."""
    methods = {f"multiplier-{basis}": [*method("Lagrange multiplier"), f"Contact method/Pressure basis={basis}"]
               for basis in ("standard", "dual")}
    methods.update({f"nitsche-theta={theta}": method("Nitsche", Theta=theta) for theta in (1, 0, -1)})
    methods.update({"augmented": method("augmented Lagrangian"), "elimination": method("direct elimination"),
                    "growing-penalty": method("penalty", **{"Factor": 10, "Mesh size exponent": 1})})
    for scene, degree, quantity, least in (("polynomial", 1, "energy", 0.9), ("polynomial", 1, "pressure", 1.4),
                                           ("polynomial", 2, "energy", 1.4), ("polynomial", 2, "pressure", 1.4),
                                           ("polynomial-smooth", 2, "energy", 1.9)):
        for name, sets in methods.items():
            yield Case(f"convergence/{scene}-{degree}", f"{quantity}/{name}", labels={"full"}, body=converges(
                scene, (5, 9, 17, 33), f"errors/{quantity}", least, key="Bodies/square/Subdivisions", text="{0:g},{0:g}",
                sets=[*sets, "Mesh/Refinements=0", f"Mesh/Degree={degree}"]))


def half_space():
    """PUB-06, which has no error but the mesh's. The stress has infinite slope at the edge of the contact, so that degree 2
    gains half an order alone: h^1 and h^1.5 in energy; h^2 and h^2.5 in the displacement, h^2 and h^3 in the force. The
    error of the force changes its sign between meshes with degree 2: over the last two refinements it has its order."""
    for degree, quantity, least, last, since in (
            (1, "errors/energy", 0.9, 1.4e-2, -2), (1, "errors/displacement", 1.8, 1e-4, -2),
            (1, "pairs/contact/force/1", 1.8, 3e-4, -2), (2, "errors/energy", 1.4, 4e-4, -2),
            (2, "errors/displacement", 2.4, 1e-6, -2), (2, "pairs/contact/force/1", 2.8, 1e-6, -3)):
        reference = -1000 if "force" in quantity else None
        yield Case("convergence/half-space", f"degree-{degree}/{quantity.replace('/', '-')}", labels={"full"},
                   body=converges("hertz-half-space", range(4), quantity, least, last, reference,
                                  sets=[f"Mesh/Degree={degree}"], since=since))


def conditions():
    """The conditions of Hertz, Signorini and Moreau: fulfilled up to rounding where a method samples them, or else with the
    order of theory; on a curved obstacle also between the nodes."""
    def case(name, quantity, least, last, sets):
        return Case("convergence/conditions", f"{name}/{quantity}", labels={"full"}, body=converges(
            "polynomial", range(4), f"pairs/foot/{quantity}", least, last, sets=sets))

    for one in ("Lagrange multiplier", "augmented Lagrangian", "direct elimination"):
        for quantity in ("max_penetration", "max_tension", "complementarity"):
            yield case(short(one), quantity, None, 1e-11, method(one))
    yield case("Nitsche", "max_penetration", 1.9, 1e-3, method("Nitsche"))
    yield case("Nitsche", "complementarity", 1.9, 1e-3, method("Nitsche"))
    yield case("penalty", "max_penetration", 0.9, 1e-3,
               [*method("penalty", Factor=100), "Bodies/square/Subdivisions=16,16"])


def penalty_factor():
    """The error of the penalty is proportional to 1/factor; the multiplier is the limit."""
    for scene, quantity in (("patch-2d", "pairs/interface/force/1"), ("shrink-fit", "pairs/fit/force/0"),
                            ("hertz-2d", "pairs/contact/force/1")):
        yield Case("convergence/penalty-factor", scene, converges(
            scene, (10, 100, 1000, 10000), quantity, 0.95, key="Contact method/penalty/Factor", sets=method("penalty"),
            reference_sets=method("Lagrange multiplier")))
