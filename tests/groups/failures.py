# SPDX-License-Identifier: Apache-2.0
"""Scenes that must be refused, or end without a result: exit code and message are as the comments at their top say.

    # exit: 2                        the exit code
    # expect: REGEX                  found exactly once: in the errors for exit code 2, else in the output
    # reason: REGEX                  found in the reason in results.json, which must say "converged": false (optional)
    # arguments: --set "A/B=c"       further settings, or --check (optional)
    # ranks: 1 2                     (optional)
"""

import json
import re
import shlex

from case import TESTS, Case, header, scenes_in


def refused(scene, ranks):
    code, message = int(header(scene, "exit")), header(scene, "expect")
    reason = header(scene, "reason", "")
    words = shlex.split(header(scene, "arguments", ""))
    check, sets = "--check" in words, [word for word in words if word not in ("--set", "--check")]

    def body(test):
        run = test.run(scene, sets, ranks, check)
        test.print(run.out + run.err)
        test.check(run.code == code, f"exit code {run.code} instead of {code}")
        found = len(re.findall(message, run.err if code == 2 else run.out))
        test.check(found == 1, f"'{message}' is there {found} times, not once")
        if reason:
            results = json.loads((test.folder / "results.json").read_text())
            test.check(results["converged"] is False, "results.json says that the run has converged")
            test.check(re.search(reason, results["reason"]), f"'{reason}' is not the reason: '{results['reason']}'")
    return body


def cases():
    for scene in scenes_in(TESTS / "failures"):
        for ranks in header(scene, "ranks", "1").split():
            yield Case("failures", f"{scene.stem}/np{ranks}", refused(scene, int(ranks)), int(ranks))
