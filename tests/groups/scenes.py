# SPDX-License-Identifier: Apache-2.0
"""Scenes that know their answer: their `Expected results` must hold. All methods that a scene names on one rank, two of them
on each further number of ranks: other code runs there for all methods alike."""

import re

from case import SCENES, Case, Failed, header, method, scenes_in, short

# All methods in two and three dimensions, on one rank; hanging nodes and free bodies on two.
SANITIZED = {("hertz-axisymmetric", 1), ("patch-overhang-3d", 1), ("hertz-2d-force", 2), ("patch-inclined", 2),
             ("finite-stack-3d", 2), ("finite-turned-stack", 1)}


def solved(scene, sets, ranks):
    def body(test):
        results = test.results(scene, sets, ranks)
        if "expected" not in results:
            raise Failed("the scene expects nothing")
        for name, one in results["expected"].items():
            test.check(one["holds"], f"{name}: {one['value']:.9g} instead of {one['reference']:.9g}, "
                                     f"deviation {one['deviation']:.2g}, allowed {one['allowed']:.2g}")
    return body


def two_of(methods, number):
    """The first, and another one, in turn from scene to scene."""
    return methods[:1] + ([methods[1 + number % (len(methods) - 1)]] if len(methods) > 1 else [])


def cases():
    for number, scene in enumerate(scenes_in(SCENES)):
        methods = re.split(r" *; *", header(scene, "methods"))
        all_ranks = [int(n) for n in header(scene, "ranks").split()]
        label = header(scene, "labels")
        for ranks in all_ranks:
            for one in methods if ranks == min(all_ranks) else two_of(methods, number):
                labels = {label, "sanitized"} if (scene.stem, ranks) in SANITIZED else {label}
                yield Case("scenes", f"{scene.stem}/{short(one)}/np{ranks}", solved(scene, method(one), ranks), ranks, labels)
