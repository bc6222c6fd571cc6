#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tests that run scenes: tables of cases, each table in one process.

    suite.py --list                            names of all cases
    suite.py [-k REGEX] [-v] [TEST...]         run those of these tests (patch, convergence/polynomial, ...), whose names match
    suite.py --ctest                           one line a test: name, ranks, labels, for tests/CMakeLists.txt

A table is a file in groups/ with a generator cases(); see case.py for what a case may do.
"""

import argparse
import importlib
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from case import Failed, TESTS, Test
from worker import Worker


def all_cases():
    sys.path.insert(0, str(TESTS / "groups"))
    cases = [case for file in sorted((TESTS / "groups").glob("*.py"))
             for case in importlib.import_module(file.stem).cases()]
    names = [f"{case.test}/{case.name}" for case in cases]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise SystemExit("two cases have the same name: " + ", ".join(sorted(twice)))
    return cases


def tests_of(cases):
    """The cases by what ctest starts: test, label, ranks."""
    tests = {}
    for case in cases:
        label = "full" if "full" in case.labels else "quick"
        tests.setdefault((case.test, label, case.ranks), []).append(case)
    return tests


def print_for_ctest(cases):
    for (test, label, ranks), members in tests_of(cases).items():
        print(test, label, ranks, len(members))
    sanitized = {case.ranks for case in cases if "sanitized" in case.labels}
    for ranks in sorted(sanitized):
        print("all", "sanitized", ranks, 0)


def run_case(case, test):
    test.start(f"{case.test}/{case.name}")
    start = time.monotonic()
    try:
        case.body(test)
        if test.n_checks == 0:
            test.problems.append("nothing was checked")
    except Failed as failure:
        test.problems.append(str(failure))
    except (KeyError, IndexError, OSError, ValueError, subprocess.TimeoutExpired) as error:
        test.problems.append(f"{type(error).__name__}: {error}")  # results that are not what the case looks for
    return time.monotonic() - start


def report(test, seconds, verbose):
    failed = bool(test.problems)
    print(f"{'FAILED' if failed else 'ok':6} {seconds:7.2f} s {test.n_checks:4} checks  {test.case}", flush=True)
    if failed or verbose:
        for line in test.lines:
            print("    " + line.rstrip().replace("\n", "\n    "))
    for problem in test.problems:
        print("    " + problem)
    if failed and test.last:
        scene, sets, ranks = test.last
        print(f"    last run, on {ranks} ranks: signorini {scene} " + " ".join(f'--set "{one}"' for one in sets))
    sys.stdout.flush()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tests", nargs="*", help="beginnings of names; all if none is given")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--ctest", action="store_true")
    parser.add_argument("-k", dest="pattern", default="", help="regular expression that the name of a case contains")
    parser.add_argument("-v", dest="verbose", action="store_true", help="print what the cases print")
    parser.add_argument("--label", help="only cases with this label: quick, full, sanitized")
    parser.add_argument("--ranks", type=int, help="only cases on this number of ranks")
    parser.add_argument("--worker", default=TESTS.parent / "build" / "release" / "tests" / "run_scenes")
    parser.add_argument("--program", default=TESTS.parent / "build" / "release" / "signorini")
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--directory", default=TESTS.parent / "output" / "tests")
    arguments = parser.parse_args()

    def chosen(case):
        return ((not arguments.tests or any((case.test + "/").startswith(t.rstrip("/") + "/") for t in arguments.tests))
                and (not arguments.label or arguments.label in case.labels)
                and (not arguments.ranks or arguments.ranks == case.ranks)
                and re.search(arguments.pattern, f"{case.test}/{case.name}"))

    cases = [case for case in all_cases() if chosen(case)]
    if arguments.ctest:
        return print_for_ctest(cases)
    if arguments.list:
        for case in cases:
            print(f"{case.test}/{case.name}  ({case.ranks} ranks, {', '.join(sorted(case.labels))})")
        return 0
    return run(cases, arguments)


def run(cases, arguments):
    workers = {}

    def worker(ranks):
        if ranks not in workers:
            workers[ranks] = Worker(arguments.worker, arguments.mpiexec, ranks)
        return workers[ranks]

    failed, n_checks = [], 0
    for (name, label, ranks), members in tests_of(cases).items():
        # Cases that are sanitized are in a test of their own too, which may run at the same time.
        directory = Path(arguments.directory) / (arguments.label or "all") / f"{name}-{label}-{ranks}"
        shutil.rmtree(directory, ignore_errors=True)
        test = Test(worker, directory)
        test.program, test.mpiexec = str(arguments.program), arguments.mpiexec
        for case in members:
            seconds = run_case(case, test)
            report(test, seconds, arguments.verbose)
            n_checks += test.n_checks
            if test.problems:
                failed.append(test.case)
    for one in workers.values():
        one.stop()
    print(f"{len(cases)} cases, {n_checks} checks, {len(failed)} failed")
    if not cases:
        print("no case has that name")
    for name in failed:
        print("  " + name)
    return 1 if failed or not cases else 0


if __name__ == "__main__":
    sys.exit(main())
