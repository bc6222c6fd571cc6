# SPDX-License-Identifier: Apache-2.0
"""The two pictures of scripts/tradeoff: what accuracy costs by degree and mesh, and what other settings change."""

import math

import figures
import matplotlib.pyplot as plt
import numpy as np

COLOURS = {
    "degree 1, uniform": "#7aa8d8",
    "degree 1, adaptive": "#1f5fa8",
    "degree 2, uniform": "#e8a3ab",
    "degree 2, adaptive": "#d1495b",
}
CHOSEN, OTHERS = "#2f9e77", "#b9bec6"


def plot_cost(curves, chosen, quantity, file):
    """Error bars over seconds: a line for each degree and kind of mesh, named at its end; automatic choices as stars.

    @param curves objects with name, family, points; points are dictionaries with seconds, relative_bar, error
    @param chosen pairs of target and point
    """
    lines = [curve for curve in curves if curve.family == "degree and mesh" and curve.points]
    figure, axis = plt.subplots(figsize=(8, 5), layout="constrained")
    others = [point for curve in curves if curve.family != "degree and mesh" for point in curve.points]
    axis.loglog(
        [point["seconds"] for point in others],
        [point["relative_bar"] for point in others],
        ".",
        color=OTHERS,
        markersize=5,
        zorder=1,
    )
    labels = []
    for curve in lines:
        x, y = ([point[key] for point in curve.points] for key in ("seconds", "relative_bar"))
        axis.loglog(x, y, "o-", color=COLOURS.get(curve.name, "black"), linewidth=2, markersize=4, zorder=2)
        labels.append((x[-1], y[-1], curve.name, COLOURS.get(curve.name, "black")))
    for target, point in chosen:
        axis.loglog(point["seconds"], point["relative_bar"], "*", color=CHOSEN, markersize=13, zorder=3)
        name = f"auto, {target:g}" if target != chosen[0][0] else f"auto, target {target:g}"
        axis.annotate(
            name,
            (point["seconds"], point["relative_bar"]),
            (-8, -4),
            textcoords="offset points",
            color=CHOSEN,
            ha="right",
            va="top",
            fontsize=9,
        )
    axis.grid(True, which="major", alpha=0.25)
    axis.spines[["top", "right"]].set_visible(False)
    axis.set(xlabel="seconds", ylabel=f"error bar of {quantity}, relative")
    axis.set_title(message_of_cost(lines, quantity), fontsize=11, loc="left")
    axis.set_xlim(left=axis.get_xlim()[0] / 2)  # room for the names of the stars
    write_names(axis, labels)
    if others:
        figure.supxlabel(
            "grey: other methods and settings, see the other picture", fontsize=8, color="#7c8793", x=0.99, ha="right"
        )
    figure.savefig(file, dpi=110, facecolor="white", metadata=figures.MADE_BY)
    plt.close(figure)


def plot_digits(studies, file):
    """Error bars over seconds of automatic runs with targets, a line for each study.

    @param studies triples of name, quantity and points
    """
    figure, axis = plt.subplots(figsize=(9, 5), layout="constrained")
    colours = plt.get_cmap("tab10")
    labels = []
    for n, (name, quantity, points) in enumerate(studies):
        points = sorted((point for point in points if point["relative_bar"]), key=lambda point: point["seconds"])
        if not points:
            continue
        x, y = ([point[key] for point in points] for key in ("seconds", "relative_bar"))
        axis.loglog(x, y, "o-", color=colours(n), linewidth=2, markersize=5)
        labels.append((x[-1], y[-1], f"{name}: {quantity.split(' of ')[0]}", colours(n)))
    for bar in (1e-1, 1e-2, 1e-3):
        axis.axhline(bar, color=OTHERS, linewidth=0.8, zorder=0)
    axis.yaxis.set_major_formatter(plt.matplotlib.ticker.FuncFormatter(lambda y, _: f"{100 * y:g} %"))
    axis.xaxis.set_major_formatter(plt.matplotlib.ticker.FuncFormatter(lambda x, _: f"{x:g}"))
    axis.spines[["top", "right"]].set_visible(False)
    axis.set(xlabel="seconds", ylabel="error bar, relative")
    axis.set_title("What an error bar takes, with Method = auto and targets of 5 %, 1 % and 0.2 %", fontsize=11, loc="left")
    axis.set_xlim(right=axis.get_xlim()[1] * 6)
    write_names(axis, labels)
    figure.savefig(file, dpi=110, facecolor="white", metadata=figures.MADE_BY)
    plt.close(figure)


def write_names(axis, labels):
    """Right of the ends of lines, moved apart where they would overlap."""
    axis.figure.canvas.draw()
    to_pixels, least = axis.transData.transform, 15 * axis.figure.dpi / 72
    placed = []
    for x, y, words, colour in sorted(labels, key=lambda label: to_pixels(label[:2])[1]):
        at = to_pixels((x, y))
        up = max([at[1]] + [low + least for left, low in placed if abs(left - at[0]) < 12 * least])
        placed.append((at[0], up))
        axis.annotate(
            words,
            (x, y),
            (7, (up - at[1]) * 72 / axis.figure.dpi),
            textcoords="offset points",
            color=colour,
            va="center",
            fontsize=10,
            annotation_clip=False,
        )


def message_of_cost(lines, quantity):
    """Which line reaches an error bar first, for the least round bar that at least two of them reach."""
    least = sorted(min(point["relative_bar"] for point in line.points) for line in lines)
    if len(least) < 2:
        return f"Error bar of {quantity} over seconds"
    bar = next((bar for bar in (1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1) if bar >= least[1]), least[1])
    seconds = {line.name: time for line in lines if (time := seconds_to(line.points, bar)) is not None}
    if len(seconds) < 2:
        return f"Error bar of {quantity} over seconds"
    (first, quick), (second, slow), *_ = sorted(seconds.items(), key=lambda item: item[1])
    first, second = (name.replace(", ", " on ") + " meshes" for name in (first, second))
    words = f"an error bar of {100 * bar:.2g} %"
    if slow < 1.15 * quick:
        return f"{first[0].upper() + first[1:]} and {second}\ntake about the same time to {words}"
    return f"With {first} {words} takes {quick:.2g} s,\nwith {second} {slow:.2g} s"


def seconds_to(points, bar):
    """When a curve has come to a bar, between its meshes along straight lines in logarithms; None if it has not."""
    before = None
    for point in points:
        if point["relative_bar"] <= bar:
            if before is None or before["relative_bar"] <= bar:
                return point["seconds"]
            share = math.log(before["relative_bar"] / bar) / math.log(before["relative_bar"] / max(point["relative_bar"], 1e-300))
            return before["seconds"] * (point["seconds"] / before["seconds"]) ** share
        before = point
    return None


def plot_settings(curves, base, file):
    """What other methods and settings change on the same mesh: seconds and error bars as multiples of those of the base curve."""
    rows = [
        (curve.name.removesuffix(", " + base.name), *ratios)
        for curve in curves
        if curve.family != "degree and mesh" and (ratios := ratios_to(base, curve))
    ]
    if not rows:
        return
    rows.sort(key=lambda row: row[1], reverse=True)
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 1.5 + 0.3 * len(rows)), sharey=True, layout="constrained")
    places = np.arange(len(rows))
    for axis, column, name in ((axes[0], 1, "seconds"), (axes[1], 2, "error bar")):
        values = np.array([row[column] for row in rows])
        worse = values > 1.05
        axis.hlines(places, 1, values, color=OTHERS, linewidth=2)
        axis.plot(values[worse], places[worse], "o", color=COLOURS["degree 2, adaptive"], markersize=6)
        axis.plot(values[~worse], places[~worse], "o", color=COLOURS["degree 1, adaptive"], markersize=6)
        axis.axvline(1, color="black", linewidth=0.8)
        for place, value in zip(places, values):
            axis.annotate(
                f"{value:.2f}",
                (value, place),
                (7 if value >= 1 else -7, 0),
                textcoords="offset points",
                va="center",
                ha="left" if value >= 1 else "right",
                fontsize=8,
            )
        axis.set_xscale("log")
        low, high = min(values.min(), 0.8), max(values.max(), 1.25)
        axis.set_xlim(low / 1.35, high * 1.35)
        axis.xaxis.set_major_formatter(plt.matplotlib.ticker.FuncFormatter(lambda x, _: f"{x:g}"))
        axis.xaxis.set_minor_formatter(plt.matplotlib.ticker.NullFormatter())
        axis.set_xlabel(f"{name} / that of the default settings")
        axis.spines[["top", "right", "left"]].set_visible(False)
        axis.tick_params(axis="y", length=0)
    axes[0].set_yticks(places, [row[0] for row in rows], fontsize=9)
    seconds = [row[1] for row in rows]
    figure.suptitle(
        f"On the same mesh other settings take {min(seconds):.2f} to {max(seconds):.2f} times the seconds ({base.name})",
        fontsize=11,
        x=0.01,
        ha="left",
    )
    figure.savefig(file, dpi=110, facecolor="white", metadata=figures.MADE_BY)
    plt.close(figure)


def ratios_to(base, curve):
    """Of the last mesh that both have: seconds and bars over those of the base."""
    n = min(len(base.points), len(curve.points)) - 1
    if n < 0 or not base.points[n]["relative_bar"]:
        return None
    return tuple(curve.points[n][key] / base.points[n][key] for key in ("seconds", "relative_bar"))
