# SPDX-License-Identifier: Apache-2.0
"""What a test case is, and what its body may ask for."""

import json
import re
import shutil
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable

TESTS = Path(__file__).resolve().parent
ROOT = TESTS.parent
SCENES = TESTS / "scenes"
VARIED = TESTS / "varied"  # scenes that cases change; they expect nothing themselves
PRM = ROOT / "prm"

SHORT = {"Lagrange multiplier": "multiplier", "augmented Lagrangian": "augmented", "perturbed Lagrangian": "perturbed",
         "direct elimination": "elimination"}


def method(name, **keys):
    """The settings that choose a contact method; its own keys by name: method("penalty", Factor=10)."""
    return [f"Contact method/Method={name}"] + [f"Contact method/{name}/{key}={value}" for key, value in keys.items()]


def force_of(results, pair="contact"):
    return results["load_steps"][-1]["pairs"][pair]["normal_force"]


def short(name):
    return SHORT.get(name, name)


@dataclass
class Case:
    """`body(test)` runs scenes and checks what comes of them. Cases with the same `test` run one after the other in the
    same process, and share the results of equal runs."""

    test: str   # the name that ctest knows: GROUP/...
    name: str
    body: Callable
    ranks: int = 1  # at most
    labels: set = field(default_factory=lambda: {"quick"})


class Failed(Exception):
    """A case cannot go on."""


class Test:
    """What a body is given. Each check counts as one assertion; a case goes on after one that fails."""

    def __init__(self, workers, directory):
        self.workers, self.directory = workers, Path(directory)
        self.known = {}  # results of runs, by what makes them different
        self.n_runs = 0
        self.start("")

    def start(self, name):
        self.case, self.problems, self.n_checks, self.lines, self.last = name, [], 0, [], None

    def print(self, line):
        """A line for the log, shown if the case fails or if asked for."""
        self.lines.append(line)

    def check(self, holds, problem):
        self.n_checks += 1
        if not holds:
            self.problems.append(problem)

    def write(self, name, text):
        """A file beside the runs."""
        self.directory.mkdir(parents=True, exist_ok=True)
        file = self.directory / name
        file.write_text(text)
        return file

    def run(self, scene, sets=(), ranks=1, check=False):
        """A run in a folder of its own; the scene is not expected to be good."""
        self.n_runs += 1
        self.folder = self.directory / str(self.n_runs)
        shutil.rmtree(self.folder, ignore_errors=True)
        self.last = (scene, [*sets, "Output/VTU=no", f"Output/Directory={self.folder}"], ranks)
        return self.workers(ranks).run(*self.last[:2], check)

    def results(self, scene, sets=(), ranks=1, missed=True):
        """The results file of a run that must converge, as a dictionary; `folder` is its place.

        missed: the scene's own expected results may be missed, as coarse meshes do."""
        key = (str(scene), tuple(sets), ranks)
        if key not in self.known:
            run = self.run(scene, sets, ranks)
            if run.code not in ((0, 4) if missed else (0,)):
                self.print(run.out)
                raise Failed(f"exit code {run.code}: {run.err}")
            self.known[key] = json.loads((self.folder / "results.json").read_text())
        self.check(self.known[key]["converged"] is True, "not converged")
        return self.known[key]


def number(results, path):
    """The number at a path with slashes, of the last load step or of the whole file, as in `Expected results`."""
    for place in (results["load_steps"][-1], results):
        for part in path.split("/"):
            if isinstance(place, list) and part.isdigit() and int(part) < len(place):
                place = place[int(part)]
            elif isinstance(place, dict) and part in place:
                place = place[part]
            else:
                break
        else:
            return float(place)
    raise Failed(f"there is no number '{path}' in the results file")


def header(scene, key, default=None):
    """The words of the comment "# KEY: WORDS" at the top of a scene. Without it and without a default: an error, for a
    test must not vanish because of a slip of the pen."""
    for line in scene.read_text().splitlines():
        match = re.match(rf"# {key}: *(.*)", line)
        if match:
            return match[1].strip()
    if default is None:
        raise SystemExit(f"{scene}: the comment '# {key}: ...' is missing; see tests/scenes/patch-2d.prm")
    return default


def scenes_in(folder):
    """All files of a folder, which must be scenes."""
    for scene in sorted(folder.iterdir()):
        if scene.suffix != ".prm":
            raise SystemExit(f"{scene} is not a scene (.prm) and would not be tested")
        yield scene
