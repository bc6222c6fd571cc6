# SPDX-License-Identifier: Apache-2.0
"""The report of a run (scripts/report): its numbers, what it says of runs that failed, and that browsers draw it."""

import json
import subprocess
import sys

from case import PRM, ROOT, TESTS, VARIED, Case

sys.path.append(str(ROOT / "scripts"))
import report_check  # noqa: E402

PLANE, LAYER = PRM / "block-on-plane.prm", VARIED / "friction-layer.prm"
HERTZ = ROOT / "doc" / "tutorials" / "hertz.prm"
HOSTILE = '<script>document.title = "no"</script> & "quoted"'


def report_of(test, scene, sets=(), code=0, options=()):
    """A run with VTU files, and the report of it: its file, as read, and results.json."""
    folder = test.directory / test.case.replace("/", "-")
    command = [test.program, str(scene)]
    for one in (*sets, f"Output/Directory={folder}"):
        command += ["--set", one]
    run = subprocess.run(command, capture_output=True, text=True, timeout=300)
    test.check(run.returncode == code, f"exit code {run.returncode} instead of {code}: {run.stderr}")
    done = subprocess.run(
        [sys.executable, ROOT / "scripts" / "report", *options, folder], capture_output=True, text=True, timeout=300
    )
    test.print(done.stdout + done.stderr)
    test.check(done.returncode == 0, f"scripts/report: exit code {done.returncode}")
    file, results = folder / "report.html", json.loads((folder / "results.json").read_text())
    for problem in report_check.problems_of(file, results):
        test.check(False, problem)
    return file, report_check.read_report(file), results


def tells(scene, sets=(), entries=(), words=(), options=("--plain", "--no-plot"), code=0):
    """A report has these entries, whose numbers are compared with results.json, and says these words."""

    def body(test):
        _, report, results = report_of(test, scene, sets, code, options)
        paths = ["/".join(map(str, path)) for path, _, _ in report.numbers]
        for entry in entries:
            test.check(entry in paths, f"the entry {entry} is missing")
        said = " ".join(" ".join(report.words).split())
        for word in [*words, *([results["reason"]] if results["reason"] else [])]:
            test.check(word in said, f"'{word}' is not said")
        outcome = "failed" if code else results["verdict"]["outcome"]
        test.check(report.outcome == outcome, f"the outcome is {report.outcome} instead of {outcome}")

    return body


def hostile(test):
    """Names from the scene are text, whatever they contain."""
    file, report, results = report_of(test, PLANE, [f"Title={HOSTILE}"], options=["--plain", "--no-plot"])
    test.check(results["title"] == HOSTILE, f"the title is {results['title']}")
    test.check(f"block-on-plane: {HOSTILE}" in report.words, "the title is not shown as it is")
    test.check("<script" not in file.read_text(), "there is a script")


def drawn(test):
    """With the library: the view and the curves, in a browser if there is one."""
    file, report, _ = report_of(test, LAYER, ["Definitions/ground=0.05*max(t-1,0)"], options=["--no-plot"])
    if not {"view-data", "curve-data"} <= set(report.data):
        said = " ".join(report.words)
        return test.check("The library Plotly is not installed" in said, "there is no view, and no word about it")
    if report_check.browser() is None:
        return test.check(True, test.print("the page is not loaded, since there is no Chromium"))
    for problem in report_check.check_in_browser(file, 390):
        test.check(False, problem)


def cases():
    step = "load_steps/0"
    yield Case(
        "report",
        "plane",
        tells(
            PLANE,
            entries=[
                f"{step}/pairs/foot/normal_force",
                f"{step}/pairs/foot/force/1",
                f"{step}/pairs/foot/max_pressure",
                f"{step}/pairs/foot/area",
                f"{step}/supports/press/reaction/1",
                f"{step}/newton_iterations",
                "preflight/bodies/block/youngs_modulus",
            ],
            options=["--plain"],
            words=["Passed: all", "Error bars: not computed", "in the units of the scene", "Displacement = 0; -0.001*t"],
        ),
    )
    yield Case(
        "report",
        "bars",
        tells(
            HERTZ,
            ["Output/VTU=no"],
            entries=["cycles/0/dofs"],
            words=["There is no 3D view, since the run has written no meshes"],
        ),
    )
    yield Case("report", "hostile", hostile)
    failures = TESTS / "failures"
    yield Case(
        "report",
        "not-converged",
        tells(
            failures / "not-converged.prm",
            code=3,
            words=["The run did not finish", "No load step is solved", "Forces and pressures: not computed"],
        ),
    )
    yield Case(
        "report", "missed", tells(failures / "missed-result.prm", code=4, words=["An expected result of the scene is not met"])
    )
    yield Case(
        "report",
        "verdict-failed",
        tells(
            PLANE,
            ["Supports/press/Displacement=0; 10*t"],
            code=3,
            words=["Failed: this solution is not valid", "moves farther than the size of the model", "Advice:"],
        ),
    )
    yield Case("report", "drawn", drawn)
