# SPDX-License-Identifier: Apache-2.0
"""The scenes of the gallery and of the tutorials: read by --check, solved, and compared with their expected results."""

from case import PRM, ROOT, Case, scenes_in
from scenes import solved


def checked(scene):
    def body(test):
        run = test.run(scene, check=True)
        test.check(run.code == 0, f"exit code {run.code}: {run.err}")
        test.check("nothing was solved" in run.out, "the report is missing")
    return body


def solved_on_two(scene):
    if "subsection Expected results" in scene.read_text():
        return solved(scene, [], 2)

    def body(test):
        results = test.results(scene, [], 2)
        test.check(results["load_steps"] != [], "no load step")
    return body


def cases():
    for scene in [*scenes_in(PRM), *(ROOT / "doc" / "tutorials").glob("*.prm")]:
        yield Case("gallery/check", scene.stem, checked(scene))
        yield Case("gallery/solve", scene.stem, solved_on_two(scene), ranks=2, labels={"full"})
