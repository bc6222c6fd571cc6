# SPDX-License-Identifier: Apache-2.0
"""Sections of the report about the outcome of a run and about what was modelled."""

from report_page import MISSING, Markup, entry, entry_at, joined, list_of, markup, paragraph, section, shown, table, text
from scene_file import named

# Keys whose value changes nothing, so that a table of what was modelled is not a list of defaults.
NOTHING = {"", "0", "no", "none", "infinity", "hard", "0,0", "0,0,0"}
FIRST_TOLD = ("failed", "warned")


def verdict(results, directory, numbers=Markup("")):
    """The outcome in words, each check that did not pass with its advice, and the numbers that a reader looks for first."""
    outcome, headline, words = in_words(results, running=(directory / "run.lock").exists())
    banner = Markup(
        f'<div class="verdict {outcome}" data-outcome="{outcome}"><strong>{text(headline)}</strong>'
        + "".join(f"<p>{markup(one)}</p>" for one in words)
        + "</div>"
    )
    checks = results.get("verdict", {}).get("checks", [])
    noted = sorted(
        (check for check in checks if check["outcome"] in FIRST_TOLD), key=lambda check: FIRST_TOLD.index(check["outcome"])
    )
    parts = [banner]
    for check in noted:
        where = f", {check['where']}" if check.get("where") else ""
        parts.append(Markup(f"<h3>{outcome_mark(check['outcome'])} {text(check['check'] + where)}</h3>"))
        parts.append(
            paragraph(f"{shown(check['value'])}; the limit is {shown(check['limit'])}; worst at t = {shown(check.get('time'))}.")
        )
        if check.get("message"):
            parts.append(paragraph(sentence(check["message"])))
        if check.get("advice"):
            parts.append(paragraph(joined(Markup("<b>Advice:</b> "), sentence(check["advice"]))))
    if numbers and outcome == "failed" and not results.get("converged"):
        parts.append(paragraph("These numbers are not those of a valid solution:", "note"))
    parts.append(numbers)
    passed = [
        (
            check["check"] + (f", {check['where']}" if check.get("where") else ""),
            shown(check["value"]),
            shown(check["limit"]),
            outcome_mark(check["outcome"]),
        )
        for check in checks
    ]
    if passed:
        parts.append(
            Markup(
                f"<details><summary>All {len(checks)} checks</summary>"
                + table(("check", "value", "limit", "outcome"), passed)
                + "</details>"
            )
        )
    return section("verdict", "Verdict", *parts)


def sentence(words):
    return words[:1].upper() + words[1:] + ("" if words.endswith((".", "!", "?")) else ".")


def in_words(results, running=False):
    """Class of the outcome (passed, warned, failed), headline and further sentences."""
    reason, told = results.get("reason") or "", results.get("verdict", {})
    outcome, checks = told.get("outcome"), told.get("checks", [])
    reason = "" if reason == "unfinished" else reason
    missed = [name for name, one in results.get("expected", {}).items() if one.get("holds") is False]
    solved = (
        [f"Load steps up to t = {shown(results['load_steps'][-1]['time'])} are solved; the tables below are about these."]
        if results.get("load_steps")
        else ["No load step is solved."]
    )
    if not results:
        return "failed", "No results", ["There is no results.json: the run has not finished its first load step."]
    if not results.get("complete", results.get("converged", False)):
        if running and results.get("reason") == "unfinished":
            return "failed", "The run has not finished yet", solved
        failed = results.get("failed_step")
        where = [f"Load step {failed['step']}, which ends at t = {shown(failed['time'])}, is not solved."] if failed else []
        chattering = [
            f"Contact pair {one['pair']}: the contact status of {one['chattering_points']} points alternates."
            for one in (failed or {}).get("pairs", [])
            if one.get("chattering_points")
        ]
        return (
            "failed",
            "The run did not finish",
            [sentence(f"Reason: {reason or 'not known; the run was killed, or it lasts still'}")] + where + chattering + solved,
        )
    if not results.get("converged"):
        return "failed", "Failed: this solution is not valid", [sentence(f"Reason: {reason or MISSING}")]
    if missed:
        return "failed", "An expected result of the scene is not met", [", ".join(missed) + verdict_words(outcome, checks)]
    if outcome is None:
        return "failed", "There is no verdict", ["The results file has no verdict: the solution has not been checked."]
    count = sum(check["outcome"] == "warned" for check in checks)
    if outcome == "warned":
        return (
            "warned",
            f"Warned: {count} of {len(checks)} checks did not pass",
            ["The solution converged; read the advice below before it is used."],
        )
    if outcome != "passed":
        return "failed", "Failed: this solution is not valid", [f"Verdict: {outcome}"]
    return "passed", f"Passed: all {len(checks)} checks", []


def verdict_words(outcome, checks):
    if outcome is None:
        return "; the solution has not been checked"
    passed = sum(check["outcome"] == "passed" for check in checks)
    return f"; of the checks of the solution {passed} of {len(checks)} passed"


def outcome_mark(outcome):
    return Markup(f'<span class="{text(outcome)}">{text(outcome)}</span>')


def model(results, scene):
    parts = [
        paragraph(summary(results, scene)),
        paragraph(
            "All numbers are in the units of the scene, which may be any that are consistent: stresses and pressures are "
            "forces by area. Pressure is positive in compression, stress in tension, a gap where it is open; forces of a pair act on its "
            f"slave. {per_what(results)}",
            "note",
        ),
        bodies(results),
        pairs(results, scene),
        obstacles(results, scene),
        definitions(scene),
        keys_of(scene, "Supports", "Supports", "support"),
        keys_of(scene, "Loads", "Loads", "load"),
    ]
    return section("model", "What was modelled", *parts)


def per_what(results):
    kind = entry_at(results, ("preflight", "model"))
    if kind == "axisymmetric":
        return "Forces and areas are those of the whole circumference."
    return "Forces are by unit of thickness, and contact areas are lengths." if results.get("dimension") == 2 else ""


def summary(results, scene):
    kind = entry_at(results, ("preflight", "model")) or scene.get("Model") or MISSING
    finite = entry_at(results, ("deformation", "finite"))
    updated = entry_at(results, ("contact_geometry", "updated"))
    words = [
        f"{results.get('dimension') or scene.get('Dimension', '?')}D, {kind}",
        {True: "finite strain", False: "small strain"}.get(finite, f"deformation {scene.get('Deformation', MISSING)}"),
        f"contact by the method {results.get('method') or scene.get('Contact method', {}).get('Method', MISSING)}",
    ]
    if updated is not None:
        words.append("evaluated on the deformed surfaces" if updated else "evaluated on the undeformed surfaces")
    if not results:
        return ", ".join(words) + "."
    size = [
        f"{shown(results.get('cells'))} cells and {shown(results.get('dofs'))} degrees of freedom on the last mesh",
        f"{shown(results['multiplier_dofs'])} unknown pressures" if results.get("multiplier_dofs") else "",
        counted(len(results.get("load_steps", [])), "load step"),
        counted(results.get("ranks"), "rank"),
        f"{shown(entry_at(results, ('seconds', 'total')), 4)} seconds of wall time",
    ]
    return f"{', '.join(words)}. {', '.join(word for word in size if word)}."


def counted(number, word):
    return f"{shown(number)} {word}" + "s" * (number != 1)


def size_of(results):
    """The largest side of a box around all bodies."""
    boxes = (entry_at(results, ("preflight", "bodies")) or {}).values()
    corners = [(body["from"], body["to"]) for body in boxes if "from" in body and "to" in body]
    if not corners:
        return 0
    low, high = ([choose(column) for column in zip(*side)] for choose, side in zip((min, max), zip(*corners)))
    return max(b - a for a, b in zip(low, high))


def bodies(results):
    rows, size = [], size_of(results)
    for name, body in (entry_at(results, ("preflight", "bodies")) or {}).items():
        at = ("preflight", "bodies", name)
        law = body.get("law", MISSING)
        material = joined(
            Markup("E "),
            entry(results, *at, "youngs_modulus"),
            ", ν ",
            entry(results, *at, "poissons_ratio"),
            f"; {'linear elastic' if law == 'linear' else law}",
            "; mixed formulation" if body.get("formulation") == "mixed" else "",
        )
        if body.get("thermal"):
            material = joined(
                material,
                "; thermal strain, ",
                entry(results, *at, "thermal", "from"),
                " to ",
                entry(results, *at, "thermal", "to"),
            )
        degree = entry(results, "degrees", name) if name in results.get("degrees", {}) else entry(results, *at, "degree")
        rows.append(
            (
                name,
                material,
                joined(entry(results, *at, "from", scale=size), " to ", entry(results, *at, "to", scale=size)),
                degree,
                entry(results, *at, "cells"),
            )
        )
    return table(("body", "material", "extent", "degree", "cells at first"), rows, "Bodies")


def pairs(results, scene):
    known, asked = entry_at(results, ("preflight", "pairs")) or {}, named(scene, "Contact pairs")
    # Pairs that the program has found between all surfaces have names of their own, and the law of the pair that asks for them.
    general = [name for name, keys in asked.items() if known and name not in known and not keys.get("Slave")]
    rows = []
    for name in dict.fromkeys([*asked, *known]):
        if name in general:
            continue
        pair, at = known.get(name, {}), ("preflight", "pairs", name)
        keys = asked.get(name) or (asked[general[0]] if len(general) == 1 else {})
        rows.append(
            (
                name,
                pair.get("slave") or keys.get("Slave") or MISSING,
                pair.get("master") or keys.get("Master") or MISSING,
                law_of(keys, pair),
                joined(entry(results, *at, "gap", "least"), " to ", entry(results, *at, "gap", "largest")),
                entry(results, *at, "slave_faces"),
            )
        )
    found = paragraph(f"Pairs were found by the program ({', '.join(general)}).", "note") if general else ""
    return joined(table(("contact pair", "slave", "master", "law", "initial gap", "slave faces"), rows, "Contact pairs"), found)


def law_of(keys, pair):
    """The law of a pair in words of the scene."""
    if not keys:
        return "see the scene"
    words = [keys.get("Law", "contact")]
    if words[0] != "tied":
        friction = keys.get("Friction", "0")
        words.append("frictionless" if friction == "0" else f"friction {friction}")
        words += ["no separation"] if pair.get("separates") is False else []
    optional = ("Friction limit", "Pressure-overclosure", "Tangential stiffness", "Initial gap")
    words += [f"{key.lower()} {keys[key]}" for key in optional if key in keys and keys[key] not in NOTHING | {"from geometry"}]
    return ", ".join(words)


def obstacles(results, scene):
    rows = [
        (name, keys.get("Shape", MISSING), words_of(keys, {"Shape"}, {"Point", "Center"}))
        for name, keys in named(scene, "Obstacles").items()
    ]
    return table(("obstacle", "shape", "given by"), rows, "Rigid obstacles")


def definitions(scene):
    """Names that formulas of the scene use."""
    rows = [(name, value) for name, value in scene.get("Definitions", {}).items() if not isinstance(value, dict)]
    return table(("name", "value"), rows, "Definitions of the scene, which its formulas use")


def keys_of(scene, part, caption, word):
    rows = [
        (
            name,
            keys.get("Boundaries") or keys.get("Bodies") or keys.get("Point") or keys.get("Nodes") or "",
            words_of(keys, {"Boundaries"}),
        )
        for name, keys in named(scene, part).items()
    ]
    return table((word, "where", "given by"), rows, caption)


def words_of(keys, but, always=()):
    """All keys that change something, and those of `always`, in the words of the scene."""
    told = [
        f"{key} = {value}"
        for key, value in keys.items()
        if not isinstance(value, dict) and key not in but and (value and key in always or value.replace(" ", "") not in NOTHING)
    ]
    return "; ".join(told)


def not_imported(results):
    """What the scene or the deck holds and this run does not."""
    checks = [
        check
        for check in results.get("verdict", {}).get("checks", [])
        if check["check"] == "not imported" and check.get("message")
    ]
    words = [f"{check['where']}: {check['message']}" if check.get("where") else check["message"] for check in checks]
    skipped = list(dict.fromkeys(results.get("skipped", []) + (entry_at(results, ("preflight", "skipped")) or [])))
    warnings = entry_at(results, ("preflight", "warnings")) or []
    parts = []
    for title, these in (
        ("Not imported", words),
        ("Warnings before the solution", warnings),
        ("Not needed by this scene", skipped),
    ):
        if these:
            parts += [Markup(f"<h3>{title}</h3>"), list_of(these)]
    return section("not-imported", "Not imported or skipped", *parts)
