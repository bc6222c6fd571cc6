# SPDX-License-Identifier: Apache-2.0
"""Runs that end before their end, and go on: killed, interrupted by signals, at the limit of their time, at a load step that
cannot be solved."""

import json
import re
import signal
import subprocess
import sys
import time

from case import PRM, ROOT, TESTS, Case

WAVY = [str(PRM / "wavy-surfaces.prm"), "--set", "Accuracy/Refinement cycles=1"]


def start(test, words, ranks=1):
    launcher = [test.mpiexec, "-n", str(ranks)] if ranks > 1 else []
    return subprocess.Popen(launcher + [test.program, *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                            text=True)


def ends(test, words, code, text="", ranks=1):
    """Runs to its end with that exit code, having said that text once."""
    process = start(test, words, ranks)
    output = process.communicate(timeout=300)[0]
    test.print(output)
    test.check(process.returncode == code, f"exit code {process.returncode} instead of {code}")
    if text:
        test.check(output.count(text) == 1, f"'{text}' is there {output.count(text)} times, not once")


def folder_of(test):
    return test.directory / ("restart-" + re.sub(r"\W", "-", test.case))


def results_in(folder):
    return json.loads((folder / "results.json").read_text())


def check_same(test, folder, undisturbed):
    """All load steps are there, with the same forces and pressures."""
    steps, expected = results_in(folder)["load_steps"], results_in(undisturbed)["load_steps"]
    test.check([step["time"] for step in steps] == [step["time"] for step in expected], "there are other load steps")
    largest = expected[-1]["largest_force"]
    highest = max(pair["max_pressure"] for pair in expected[-1]["pairs"].values())
    for a, b in zip(steps, expected):
        for name, pair in a["pairs"].items():
            other = b["pairs"][name]
            test.check(abs(pair["normal_force"] - other["normal_force"]) <= 1e-7 * largest, f"force at t = {a['time']:g}")
            for x, y in zip(pair.get("friction_force", []), other.get("friction_force", [])):
                test.check(abs(x - y) <= 1e-6 * largest, f"friction at t = {a['time']:g}")
            test.check(abs(pair["max_pressure"] - other["max_pressure"]) <= 1e-6 * highest, f"pressure at t = {a['time']:g}")


def kills(ranks, number, scene=PRM / "wavy-surfaces.prm", sets=("Accuracy/Refinement cycles=2",), tolerance=1e-6):
    def body(test):
        keys = [word for one in sets for word in ("--set", one)]
        run = subprocess.run([sys.executable, ROOT / "scripts" / "kills", scene, *keys, "-np", ranks, "--kills", str(number),
                              "--tolerance", str(tolerance), "--program", test.program, "--mpiexec", test.mpiexec],
                             stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=600)
        test.print(run.stdout)
        test.check(run.returncode == 0, "not all runs have ended as the undisturbed one")
        test.check(f"{number} kills" in run.stdout, f"there were not {number} kills")
    return body


def interrupted(number, ranks):
    """Launchers hand SIGUSR1 on, but end their processes soon after SIGTERM."""
    def body(test):
        folder, whole = folder_of(test), folder_of(test) / "whole"
        ends(test, [*WAVY, "--set", f"Output/Directory={whole}"], 0, ranks=ranks)
        # Two directories: nobody knows how far the run gets.
        process = start(test, [*WAVY, "--set", f"Output/Directory={folder}"], ranks)
        seen = ""
        for line in process.stdout:
            seen += line
            if "load step 3" in line:
                process.send_signal(number)
                break
        seen += process.stdout.read()
        process.wait(timeout=60)
        test.print(seen)
        test.check(process.returncode == 5, f"exit code {process.returncode} instead of 5")
        results = results_in(folder)
        test.check(results["reason"] == f"interrupted by {signal.Signals(number).name}", f"the reason is {results['reason']}")
        test.check(results["exit_code"] == 5 and not results["complete"], "results.json does not tell that it is not complete")
        test.check(2 <= len(results["load_steps"]) <= 4, "results.json has not the load steps that were solved")
        test.check(len(list(folder.glob("checkpoint-*/head"))) == 1, "there is no checkpoint")
        ends(test, ["--restart", folder], 0, "Restart from", ranks=3 - ranks if number == signal.SIGUSR1 else ranks)
        check_same(test, folder, whole)
        test.check(not list(folder.glob("checkpoint-*")), "checkpoints are left")
        test.check(len(results_in(folder)["restarts"]) == 1, "results.json does not tell of the restart")
        # As after a kill between the last results and the end of the process.
        (folder / "checkpoint-0009").mkdir()
        ends(test, ["--restart", folder], 0, "is finished, with exit code 0: nothing was done")
        test.check(not list(folder.glob("checkpoint-*")), "checkpoints are left by the restart of a finished run")
    return body


def time_limit(test):
    folder, whole = folder_of(test), folder_of(test) / "whole"
    ends(test, [*WAVY, "--set", f"Output/Directory={whole}"], 0)
    ends(test, [*WAVY, "--set", f"Output/Directory={folder}", "--set", "Output/Time limit=1e-6"], 5,
         "there is no checkpoint to restart from")
    # The reserve for a checkpoint is a second.
    limit = ["--set", f"Output/Time limit={1.6 / 60}"]
    code, runs = 5, 0
    while code == 5 and runs < 20:
        process = start(test, ["--restart", folder, *limit])
        test.print(process.communicate(timeout=60)[0])
        code, runs = process.returncode, runs + 1
        if "there is no checkpoint" in results_in(folder)["reason"]:  # a slow machine
            limit = ["--set", f"Output/Time limit={2 ** runs / 60}"]
    test.check(code == 0, f"exit code {code} after {runs} restarts")
    check_same(test, folder, whole)


def refused(test):
    folder = folder_of(test)
    folder.mkdir(parents=True, exist_ok=True)
    ends(test, ["--restart"], 2, "--restart needs the output directory of a run")
    ends(test, ["--restart", folder], 2, "has no file restart.scene")
    scene = [str(TESTS / "failures" / "missed-result.prm"), "--set", f"Output/Directory={folder}"]
    ends(test, scene, 4)
    ends(test, ["--restart", folder], 4, "is finished, with exit code 4: nothing was done")
    ends(test, ["--restart", folder, scene[0]], 2, "continues the scene of that directory")
    ends(test, ["--restart", folder, "--set", "Mesh/Degree=2"], 2, "would change the problem")
    ends(test, ["--restart", folder, "--set", "Load steps/Number=7"], 2, "set a later Load steps/End time")
    origin = folder / "restart.scene"
    origin.write_bytes(origin.read_bytes()[:-1])
    ends(test, ["--restart", folder], 2, "does not have the length that it records")


def failed_step(test):
    """A load step that is not solved leaves the last good state, and goes on from there with other settings."""
    folder, whole = folder_of(test), folder_of(test) / "whole"
    scene = [*WAVY, "--set", "Accuracy/Refinement cycles=0"]
    ends(test, [*scene, "--set", f"Output/Directory={whole}"], 0)
    few = ["--set", "Newton/Maximum steps=4", "--set", "Load steps/Cut-backs=0"]
    ends(test, [*scene, *few, "--set", f"Output/Directory={folder}"], 3)
    results = results_in(folder)
    failed, n = results["failed_step"], len(results["load_steps"])
    test.check(n > 0, "already the first load step failed")
    test.check(failed["step"] == n + 1, f"step {failed['step']} failed after {n}")
    test.check(failed["body"] in ("flat", "wavy"), "no body is named")
    test.check(failed["pairs"][0]["pair"] == "contact", "no pair is named")
    drawn = folder / f"failed_{n + 1:04}.pvtu"
    test.check(drawn.exists(), "its surfaces are not drawn")
    ends(test, ["--restart", folder, "--set", "Newton/Maximum steps=30"], 0)
    check_same(test, folder, whole)
    test.check(not drawn.exists() and "failed_step" not in results_in(folder), "the failure is still told")


PULLED_BLOCK = """set Dimension = 2
subsection Bodies
  set Names = block
  subsection block
    set Mesh            = box
    set Corners         = 0,0 : 2,1
    set Subdivisions    = 8,4
    set Young's modulus = 1000
    set Poisson's ratio = 0.3
  end
end
subsection Obstacles
  set Names = ground
end
subsection Loads
  set Names = press, pull
  subsection press
    set Boundaries = block.top
    set Pressure   = 10*min(4*t, 1)
  end
  subsection pull
    set Boundaries = block.right
    set Traction   = 3*t; 0
  end
end
subsection Contact pairs
  set Names = foot
  subsection foot
    set Slave    = block.bottom
    set Master   = ground
    set Friction = 0.4
  end
end
subsection Load steps
  set Number = 4
end
"""


def further_steps(test):
    """Load steps after a finished run, with other loads: as in one run with all of them, also if that is interrupted."""
    folder, whole = folder_of(test), folder_of(test) / "whole"
    scene = folder_of(test) / "block.prm"
    scene.parent.mkdir(parents=True, exist_ok=True)
    scene.write_text(PULLED_BLOCK)
    pulled, keep = "Loads/pull/Traction=if(t <= 1, 3*t, 6 - 3*t); 0", ["--set", "Output/Keep checkpoint=yes"]
    end, number = "Load steps/End time=2", "Load steps/Number=8"
    ends(test, [scene, "--set", end, "--set", number, "--set", pulled, "--set", f"Output/Directory={whole}"], 0)
    ends(test, [scene, "--set", "Load steps/Number=4", "--set", f"Output/Directory={folder}"], 0)
    more = ["--restart", folder, "--set", end, "--set", number, "--set", pulled, "--set", "Supports/Names="]
    ends(test, more, 2, "which has left no checkpoint")
    ends(test, [scene, *keep, "--set", "Load steps/Number=4", "--set", f"Output/Directory={folder}"], 0)
    ends(test, ["--restart", folder, "--set", pulled], 2, "set a later Load steps/End time")
    ends(test, ["--restart", folder, "--set", "Bodies/block/Young's modulus=1", "--set", end], 2, "would change the problem")
    ends(test, ["--restart", folder], 0, "nothing was done")
    # What contradicts the past is refused, after which the right keys are accepted.
    ends(test, ["--restart", folder, "--set", end, "--set", number, "--set", "Loads/pull/Traction=5*t; 0"], 2,
         "Loads have another resultant")
    held = ["Supports/Names=new", "Supports/new/Boundaries=block.right", "Supports/new/Displacement=0.1*t; free"]
    ends(test, ["--restart", folder, "--set", end, *(word for one in held for word in ("--set", one))], 2,
         "Supports prescribe other displacements")
    # Before the first of the further steps is done, and after one of them.
    ends(test, [*more, "--set", "Output/Time limit=1e-6"], 5)
    ends(test, ["--restart", folder, "--set", "Output/Time limit=0"], 0, "Restart from", ranks=2)
    check_same(test, folder, whole)


def added_later(scene):
    def run(test):
        """Ties and fluids of further load steps, with all of them in the scene from the beginning."""
        folder, whole = folder_of(test), folder_of(test) / "whole"
        path = TESTS / "scenes" / scene
        expected = ["--set", "Expected results/Names="]
        ends(test, [path, *expected, "--set", f"Output/Directory={whole}"], 0)
        times = re.search(r"set Times = (.*)", path.read_text()).group(1)
        before = times.split(", ")
        before = before[:len(before) // 2]
        ends(test, [path, *expected, "--set", "Output/Keep checkpoint=yes", "--set", f"Load steps/End time={before[-1]}", "--set",
                    f"Load steps/Times={', '.join(before)}", "--set", f"Output/Directory={folder}"], 0)
        ends(test, ["--restart", folder, "--set", f"Load steps/End time={times.split(', ')[-1]}", "--set",
                    f"Load steps/Times={times}"], 0, "Restart from", ranks=2)
        check_same(test, folder, whole)

    return run


def cases():
    yield Case("restart", "kills/np1", kills("1", 4))
    yield Case("restart", "kills/np4", kills("4,1,2", 4), 4, {"full"})
    # Where the degree changes on the way; on the way to a target, meshes may differ by what solutions leave to the next one.
    yield Case("restart", "kills/degrees",
               kills("1", 3, TESTS / "scenes" / "hertz-axisymmetric.prm",
                     ["Contact method/Method=auto", "Accuracy/Quantity=force of contact", "Accuracy/Target error=1e-3"], 1e-2))
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGUSR1):
        yield Case("restart", f"{number.name}/np1", interrupted(number, 1))
    yield Case("restart", "SIGUSR1/np2", interrupted(signal.SIGUSR1, 2), 2)
    yield Case("restart", "time-limit", time_limit)
    yield Case("restart", "refused", refused)
    yield Case("restart", "kills/locked", kills("1,2", 2, PRM / "bolted-joint.prm", []), 2, {"full"})
    yield Case("restart", "further-steps", further_steps, 2)
    yield Case("restart", "further-steps/tie", added_later("late-tie.prm"), 2)
    yield Case("restart", "further-steps/fluid", added_later("uplift.prm"), 2)
    yield Case("restart", "failed-step", failed_step)
