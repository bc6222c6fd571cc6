# SPDX-License-Identifier: Apache-2.0
"""Sections of the report with the numbers of results.json: forces, pressures, error bars, convergence."""

from report_model import outcome_mark, size_of
from report_page import MISSING, Markup, entry, entry_at, joined, paragraph, section, shown, table

MOST_STEPS = 60


def key_numbers(results):
    """What a reader looks for first: of each pair force, largest pressure and area; at most three pairs."""
    boxes = []
    for pair in list(last_step(results).get("pairs", {}))[:3]:
        at = ("load_steps", last_index(results), "pairs", pair)
        for name, words in (("normal_force", "normal force"), ("max_pressure", "largest pressure"), ("area", area_word(results))):
            boxes.append(f"<div><small>{joined(words, ', ', pair)}</small><b>{entry(results, *at, name)}</b></div>")
    return Markup(f'<div class="key-numbers">{"".join(boxes)}</div>') if boxes else Markup("")


def area_word(results):
    plane = results.get("dimension") == 2 and entry_at(results, ("preflight", "model")) != "axisymmetric"
    return "contact length" if plane else "contact area"


def last_index(results):
    return len(results.get("load_steps", [])) - 1


def last_step(results):
    steps = results.get("load_steps", [])
    return steps[-1] if steps else {}


def forces(results):
    step, number = last_step(results), last_index(results)
    if not step:
        return section(
            "forces", "Forces and pressures", paragraph(f"Forces and pressures: {MISSING}, since no load step is solved.")
        )
    at, rows, places, friction = ("load_steps", number), [], [], []
    force, size = step.get("largest_force", 0), size_of(results)
    for pair, found in step.get("pairs", {}).items():
        here = (*at, "pairs", pair)
        rows.append(
            (
                pair,
                found.get("slave", MISSING),
                entry(results, *here, "force", scale=force),
                entry(results, *here, "normal_force", scale=force),
                tangential(results, here, found, force),
                entry(results, *here, "moment", scale=force * size),
            )
        )
        places.append(
            (
                pair,
                entry(results, *here, "max_pressure"),
                entry(results, *here, "area"),
                entry(results, *here, "semi_axes"),
                entry(results, *here, "active_points"),
                entry(results, *here, "max_penetration", scale=size),
                entry(results, *here, "min_gap", scale=size),
            )
        )
        if "stick_area" in found:
            friction.append(
                (
                    pair,
                    *(
                        entry(results, *here, key)
                        for key in (
                            "stick_area",
                            "slip_area",
                            "max_tangential_traction",
                            "max_slip_since_contact",
                            "total_friction_work",
                        )
                    ),
                )
            )
    time = f"At the end of the last load step, t = {shown(step['time'])}."
    return section(
        "forces",
        "Forces and pressures",
        paragraph(time),
        table(
            (
                "contact pair",
                "on",
                "force",
                "integral of the pressure",
                "friction or tangential force",
                "moment about the origin",
            ),
            rows,
            "Forces of contact pairs, on the slave",
        ),
        table(
            (
                "contact pair",
                "largest pressure",
                area_word(results),
                "semi-axes",
                "points in contact",
                "deepest penetration",
                "least gap",
            ),
            places,
            "Pressures and contact areas",
        ),
        table(
            (
                "contact pair",
                "stick area",
                "slip area",
                "largest tangential traction",
                "largest slip since contact",
                "work of friction so far",
            ),
            friction,
            "Friction",
        ),
        supports(results, step, at),
        fluids(results, step, at),
        cross_sections(results, step, at),
        stresses(results, step, at),
        probes(results, step, at),
    )


def tangential(results, here, found, force):
    """A pair without friction has no tangential force by its law, which is not the same as one that is unknown."""
    for key in ("friction_force", "tangential_force"):
        if key in found:
            return entry(results, *here, key, scale=force)
    return Markup('<span class="missing">frictionless</span>')


def supports(results, step, at):
    force = step.get("largest_force", 0)
    rows = [
        (name, "support", entry(results, *at, "supports", name, "reaction", scale=force), "", "")
        for name in step.get("supports", {})
    ]
    for name in step.get("obstacles", {}):
        here = (*at, "obstacles", name)
        rows.append(
            (
                name,
                "obstacle",
                entry(results, *here, "force", scale=force),
                entry(results, *here, "displacement"),
                entry(results, *here, "rotation"),
            )
        )
    moving = bool(step.get("obstacles"))
    if not moving:
        rows = [row[:3] for row in rows]
    rows.append(("loads, resultant", "load", entry(results, *at, "total_load", scale=force)) + (("", "") if moving else ()))
    return table(
        ("name", "kind", "force on the bodies") + (("displacement", "rotation [rad]") if moving else ()),
        rows,
        "Reactions, obstacles and loads",
    )


def fluids(results, step, at):
    rows = []
    for name in step.get("fluids", {}):
        here = (*at, "fluids", name)
        rows.append((name, entry(results, *here, "wet_area"), entry(results, *here, "area")))
    return table(("fluid", "acts on an area of", "of"), rows, "Fluids, undeformed areas")


def cross_sections(results, step, at):
    force = step.get("largest_force", 0)
    rows = []
    for name in step.get("cross_sections", {}):
        here = (*at, "cross_sections", name)
        rows.append(
            (
                name,
                entry(results, *here, "force", scale=force),
                entry(results, *here, "normal_force", scale=force),
                entry(results, *here, "moment"),
                entry(results, *here, "uncertainty", scale=force),
            )
        )
    head = ("cross section", "force", "along its normal (tension positive)", "moment", "known up to a force of")
    return table(head, rows, "Cross sections")


def stresses(results, step, at):
    rows = []
    for body in step.get("bodies", {}):
        here = (*at, "bodies", body, "largest")
        for name, words in (
            ("von_mises", "von Mises stress"),
            ("shear", "shear stress (Tresca)"),
            ("principal_stress", "most tensile principal stress"),
        ):
            rows.append((body, words, entry(results, *here, name, "value"), entry(results, *here, name, "place")))
    return table(
        ("body", "largest", "value", "place, undeformed"), rows, "Largest stresses, at the superconvergent points of the cells"
    )


def probes(results, step, at):
    rows = []
    for name, found in step.get("probes", {}).items():
        if isinstance(found, list):
            continue  # along lines: a picture
        here = (*at, "probes", name)
        names = [key for key in ("pressure", "gap", "von_mises", "principal_stress", "displacement") if key in found]
        rows += [
            (
                name,
                key.replace("_", " ").replace("von mises", "von Mises stress"),
                entry(results, *here, key),
                entry(results, *here, "place"),
            )
            for key in names
        ]
    return table(("probe", "quantity", "value", "place, undeformed"), rows, "Probes")


def accuracy(results):
    """Error bars and the results that the scene expects."""
    rows = []
    for name, found in results.get("accuracy", {}).get("quantities", {}).items():
        at = ("accuracy", "quantities", name)
        better = (
            joined(
                entry(results, *at, "extrapolated", "value", digits=7),
                " ± ",
                entry(results, *at, "extrapolated", "error_bound", digits=2),
            )
            if "extrapolated" in found
            else ""
        )
        rows.append(
            (
                name,
                entry(results, *at, "value", digits=7),
                joined("± ", entry(results, *at, "error_bound", digits=2)),
                entry(results, *at, "relative_error_bound", digits=2),
                entry(results, *at, "target"),
                met_mark(found.get("met")),
                better,
            )
        )
    bars = table(
        ("quantity", "value", "error bar", "bar / value", "target", "target met", "extrapolated"),
        rows,
        "Error bars: the exact value is expected within value ± bar",
    )
    if not rows:
        bars = paragraph("Error bars: not computed, since the scene asks for none (Accuracy/Quantity).")
    reason = entry_at(results, ("accuracy", "reason"))
    rows = [
        (
            name,
            *(entry(results, "expected", name, key, digits=7) for key in ("value", "reference")),
            *(entry(results, "expected", name, key, digits=3) for key in ("deviation", "allowed")),
            met_mark(one.get("holds")),
            one.get("source", ""),
        )
        for name, one in results.get("expected", {}).items()
    ]
    expected = table(
        ("result", "value", "reference", "deviation", "allowed", "met", "source"),
        rows,
        "Expected results of the scene; deviations are relative, unless the scene sets an absolute tolerance",
    )
    return section("accuracy", "Accuracy", bars, paragraph(f"A target is not met: {reason}", "note") if reason else "", expected)


def met_mark(met):
    if met is None:
        return Markup(f'<span class="missing">{MISSING}</span>')
    return Markup(f'<span class="{"passed" if met else "failed"}">{"yes" if met else "no"}</span>')


def convergence(results):
    return section("convergence", "Convergence", newton(results), meshes(results), seconds(results))


def newton(results):
    steps = results.get("load_steps", [])
    chosen = range(len(steps)) if len(steps) <= MOST_STEPS else range(len(steps) - MOST_STEPS, len(steps))
    note = f"; the last {MOST_STEPS} of {len(steps)} load steps" if len(chosen) < len(steps) else ""
    rows = []
    for i in chosen:
        at = ("load_steps", i)
        krylov = entry_at(results, (*at, "krylov_iterations"))
        rows.append(
            (
                str(steps[i].get("step", i + 1)),
                entry(results, *at, "time"),
                entry(results, *at, "newton_iterations"),
                ", ".join(str(n) for n in krylov) if krylov else "none",
                entry(results, *at, "active_points"),
                entry(results, *at, "residual", digits=2),
                entry(results, *at, "force_balance", digits=2),
            )
        )
    return table(
        (
            "load step",
            "t",
            "Newton steps",
            "linear iterations of each",
            "points in contact",
            "residual at the end",
            "sum of all forces",
        ),
        rows,
        f"Newton's method{note}; residuals and sums are relative to the acting forces",
    )


def meshes(results):
    """One line a mesh; the values and bars of the quantities where there are any."""
    quantities = list(results.get("accuracy", {}).get("quantities", {}))
    rows = []
    for i, cycle in enumerate(results.get("cycles", [])):
        at = ("cycles", i)
        time = entry_at(results, (*at, "accuracy", "time"))
        rows.append(
            (
                f"{i}" + (f", for t = {shown(time)}" if time is not None else ""),
                entry(results, *at, "dofs"),
                entry(results, *at, "newton_iterations"),
                entry(results, *at, "multigrid_cycles"),
                entry(results, *at, "seconds", digits=3),
                entry(results, *at, "accuracy", "energy", digits=2),
                *value_and_bar(results, (*at, "accuracy"), quantities),
            )
        )
    if not rows:
        return paragraph("Meshes: one, which was not refined by an estimate of the error.")
    rows.append(
        (
            f"{len(rows)}, the last",
            entry(results, "dofs"),
            "",
            "",
            entry(results, "seconds", "total", digits=3),
            entry(results, "accuracy", "energy", digits=2),
            *value_and_bar(results, ("accuracy",), quantities),
        )
    )
    return table(
        ("mesh", "degrees of freedom", "Newton steps", "multigrid cycles", "seconds so far", "error in energy", *quantities),
        rows,
        "Meshes; the error is an estimate, relative to the energy norm of the solution",
    )


def value_and_bar(results, at, quantities):
    return [
        joined(
            entry(results, *at, "quantities", name, "value"),
            " ± ",
            entry(results, *at, "quantities", name, "error_bound", digits=2),
        )
        for name in quantities
    ]


def seconds(results):
    phases = {name: value for name, value in results.get("seconds", {}).items() if name != "total"}
    rows = [(name, entry(results, "seconds", name, digits=3)) for name, _ in sorted(phases.items(), key=lambda item: -item[1])]
    if not rows:
        return Markup("")
    memory = results.get("peak_memory_mb")
    return joined(
        Markup("<details><summary>Seconds and memory</summary>"),
        table(
            ("phase", "seconds"),
            rows + [("total", entry(results, "seconds", "total", digits=3))],
            "Wall time of the slowest rank",
        ),
        paragraph(f"Peak memory of a rank: {shown(max(memory))} MB.") if memory else "",
        Markup("</details>"),
    )
