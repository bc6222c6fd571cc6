# SPDX-License-Identifier: Apache-2.0
"""The picture of the deformed bodies: flat cells in 2D, a shaded view of the outer faces in 3D.

Matplotlib draws polygons, but does not know which of them hides which. So the faces of a 3D model are projected here,
those that face away are left out, and the rest is drawn from back to front, in pieces small enough for that order to
be right.
"""

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.collections import PolyCollection
from matplotlib.colors import ListedColormap, Normalize
from PIL import Image  # which Matplotlib needs anyway

from figures import MADE_BY
from profiles import in_contact, normals, positions

# Pale where there is little stress, so that the mesh can be seen; not down to black, so that it can be seen elsewhere.
COLOURS = ListedColormap(plt.get_cmap("magma_r")(np.linspace(0, 0.8, 256)))
LINE, FRAME, OBSTACLE = np.array([0.07, 0.07, 0.1]), "#d1495b", "#b9bec6"
# The faces of a hexahedron by its corners in VTK's order, anticlockwise seen from outside.
FACES = np.array([[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])


class Picture:
    """The deformed bodies of a mesh, coloured by a field, to be drawn into axes with one displacement factor or another."""

    def __init__(self, mesh, profiles, field="von_mises", from_below=False):
        self.mesh, self.profiles, self.field = mesh, profiles, field
        self.values, self.displacement = mesh.field(field), mesh.field("displacement")
        if self.values.ndim > 1:
            self.values = np.linalg.norm(self.values, axis=1)
        self.body = mesh.fields.get("body", np.zeros(len(mesh.points)))
        self.size = np.ptp(mesh.points, axis=0).max()
        self.zone = contact_zone(mesh, profiles)

        # What is drawn: quadrilaterals, in coordinates that point right, up and towards the viewer.
        if mesh.dimension == 2:
            self.turn, self.remark = np.eye(3), ""
            self.faces, owner = mesh.cells, np.arange(len(mesh.cells))
        else:
            self.turn, cells, self.remark = viewpoint(mesh, self.zone, from_below)
            self.faces, owner = outer_faces(mesh.points, cells, self.body[cells[:, 0]])
        self.lines = is_cell_edge(self.faces, owner, len(mesh.points))

        # Single peaks are clipped, but not the contact zone, however small a part of the points it is.
        samples = [self.values, self.values[self.zone]] if self.zone.any() else [self.values]
        most = max(np.percentile(sample, 99.5) for sample in samples)
        if self.values.max() < 1.15 * most:
            most = self.values.max()
        self.norm = Normalize(min(0, np.percentile(self.values, 0.5)), most or 1)

    def visible_scale(self):
        return visible_scale(self.displacement, self.profiles, self.size)

    def positions(self, factor):
        return (self.mesh.points + factor * self.displacement) @ self.turn.T

    def draw(self, ax, factor, window, mirror=False, axes=True):
        """The part in the window, and with `mirror` its image on the other side of x = 0."""
        flat = self.mesh.dimension == 2
        for sign in (1, -1) if mirror else (1,):
            x = self.positions(factor) * (sign, 1, 1)
            for part in np.unique(self.body) if flat else [None]:
                chosen = slice(None) if part is None else self.body[self.faces[:, 0]] == part
                corners = self.faces[chosen]
                paint(ax, x[corners], self.values[corners], self.lines[chosen], window, self.norm, shaded=not flat)
        ax.set(xlim=window[0], ylim=window[1], aspect="equal")
        if not flat and axes:
            triad(ax, self.turn)

    def colour_bar(self, figure, axes, **style):
        beyond = (self.values.max() > self.norm.vmax) + 2 * (self.values.min() < self.norm.vmin)
        beyond = ("neither", "max", "min", "both")[beyond]
        bar = figure.colorbar(ScalarMappable(self.norm, COLOURS), ax=axes, extend=beyond, **style)
        bar.set_label(self.legend())
        return bar

    def legend(self):
        """What the colours mean, and where the bar ends below the values, how far they go."""
        words = "von Mises stress" if self.field == "von_mises" else self.field.replace("_", " ")
        if self.mesh.field(self.field).ndim > 1:
            words += ", length" if self.mesh.field(self.field).shape[1] == 3 else ", norm"
        if self.values.max() > self.norm.vmax:
            words += f", at most {self.values.max():.4g}"
        if self.values.min() < self.norm.vmin:
            words += f", at least {self.values.min():.4g}"
        return words


def plot_bodies(mesh, profiles, field, scale, title, file, rigid=(), axes_names=("x", "y")):
    """@param rigid names of the pairs whose master is an obstacle"""
    picture = Picture(mesh, profiles, field)
    zone = picture.zone
    scales = [picture.visible_scale() if scale is None else scale]
    x = mesh.points @ picture.turn.T
    if zone.any() and np.ptp(close_up(x, zone), axis=1).max() < 0.6 * np.ptp(whole(x), axis=1).max():
        # Magnified displacements show gaps and overlaps that are none, which is plain to see from close by.
        scales.append(1 if scale is None else scale)

    figure, axes = panels(x, len(scales))
    for ax, factor in zip(axes, scales):
        x = picture.positions(factor)
        window = whole(x) if ax is axes[0] else close_up(x, zone)
        obstacles = [draw_obstacle(ax, picture, profiles[pair], factor, window) for pair in rigid if pair in profiles]
        picture.draw(ax, factor, window)
        if mesh.dimension == 2:
            ax.set(xlabel=axes_names[0], ylabel=axes_names[1])
        name = "" if ax is axes[0] else "contact zone, "
        remark = picture.remark + (", obstacles grey" if any(obstacles) else "")
        ax.set_title(f"{name}displacement × {factor:g}{remark}", fontsize=10)
    if len(axes) == 2:
        frame(axes, close_up(picture.positions(scales[0]), zone))

    figure.suptitle(title, fontsize=11)
    picture.colour_bar(figure, list(axes), shrink=0.85, aspect=28, pad=0.02)
    figure.savefig(file, dpi=100, facecolor="white", metadata=MADE_BY)


def plot_film(meshes, field, scale, title, folder):
    """All load steps in the same window, from the same side and in the same colours, as pictures and one animated picture.

    @param meshes pairs of time and mesh
    """
    pictures = [Picture(mesh, {}, field) for _, mesh in meshes]
    factor = pictures[-1].visible_scale() if scale is None else scale
    colours = Normalize(min(picture.norm.vmin for picture in pictures), max(picture.norm.vmax for picture in pictures))
    windows = np.array([whole(picture.positions(factor)) for picture in pictures])
    window = np.stack([windows[:, :, 0].min(axis=0), windows[:, :, 1].max(axis=0)], axis=1)
    (folder / "film").mkdir(exist_ok=True)
    frames = []
    for number, ((time, _), picture) in enumerate(zip(meshes, pictures), 1):
        picture.norm = colours
        figure, ax = plt.subplots(figsize=(8, 1 + 6.5 * np.clip(np.ptp(window[1]) / np.ptp(window[0]), 0.3, 1.2)), layout="constrained")
        picture.draw(ax, factor, window)
        ax.set_title(f"{title}, t = {time:.4g}, displacement × {factor:g}", fontsize=10)
        picture.colour_bar(figure, [ax], shrink=0.85, aspect=28, pad=0.02)
        frames.append(folder / "film" / f"{number:04d}.png")
        figure.savefig(frames[-1], dpi=80, facecolor="white", metadata=MADE_BY)
        plt.close(figure)
    images = [Image.open(frame).convert("P", palette=Image.Palette.ADAPTIVE) for frame in frames]
    images[0].save(folder / "film.gif", save_all=True, append_images=images[1:], duration=[150] * (len(images) - 1) + [1500], loop=0,
                   comment=b"Signorini scripts/plot")


def draw_obstacle(ax, picture, profile, factor, window):
    """In 2D the surface of the obstacle, a piece before each point of the slave. Returns whether there is one to see.

    It lies beyond the slave by the gap, which is magnified as the displacement is: as far as it has changed.
    """
    if picture.mesh.dimension == 3 or "initial_gap" not in profile.dtype.names:
        return False
    x, normal = positions(profile), normals(profile)
    nearest = np.array([int(np.argmin(((picture.mesh.points - point) ** 2).sum(axis=1))) for point in x])
    gap = profile["initial_gap"] + factor * (profile["gap"] - profile["initial_gap"])
    at = (x + factor * picture.displacement[nearest] - gap[:, None] * normal)[:, :2]
    along = np.stack([-normal[:, 1], normal[:, 0]], axis=1)
    between = np.linalg.norm(x[:, None] - x, axis=2) + np.diag(np.full(len(x), np.inf))
    half = 0.6 * (between.min(axis=1) if len(x) > 1 else np.array([0.02 * picture.size]))[:, None] * along
    below = 0.02 * np.ptp(window, axis=1).max() * normal[:, :2]
    # Behind the bodies, so that what lies on the obstacle hides its rim.
    areas = np.stack([at - half, at + half, at + half - below, at - half - below], axis=1)
    ax.add_collection(PolyCollection(areas, facecolors=OBSTACLE, edgecolors=OBSTACLE, linewidths=0.5, zorder=0.5), autolim=False)
    return bool(np.all((at >= window[:, 0]) & (at <= window[:, 1]), axis=1).any())


# What to look at -----------------------------------------------------------------------------------------------------


def contact_zone(mesh, profiles):
    """Which points of the mesh lie about the contact zone: that of the pair with the largest pressure."""
    zones = [profile[profile["status"] > 0.5] for profile in profiles.values()]
    zones = [zone for zone in zones if zone.size]
    if not zones:
        return np.zeros(len(mesh.points), bool)
    zone = max(zones, key=lambda zone: zone["pressure"].max())
    zone = np.stack([zone[axis] for axis in "xyz"], axis=1)
    low, high = zone.min(axis=0), zone.max(axis=0)
    slack = 0.1 * (high - low).max()
    inside = np.all((mesh.points >= low - slack) & (mesh.points <= high + slack), axis=1)
    if len(np.unique(mesh.points[inside], axis=0)) < 2:  # the zone is smaller than a cell: take the cells about it
        distance = np.linalg.norm(mesh.points - (low + high) / 2, axis=1)
        inside[mesh.cells[(distance[mesh.cells] <= 1.001 * distance.min()).any(axis=1)]] = True
    return inside


def visible_scale(displacement, profiles, size):
    """A round factor with which the displacement is seen: 1 if it is seen anyway.

    Where a gap of g0 has become g, magnified displacements show g0 + factor * (g - g0): bodies that touch would overlap, or
    where they overlapped at first, part. The factor is such that this is not seen.
    """
    largest = np.linalg.norm(displacement, axis=1).max()
    if largest == 0 or largest > 0.02 * size:
        return 1
    scale, seen = 0.04 * size / largest, 0.004 * size
    for profile in profiles.values():
        if "initial_gap" in profile.dtype.names:
            gap, change, touching = profile["gap"], profile["gap"] - profile["initial_gap"], in_contact(profile)
            # Points in touch stay so, open ones do not overlap.
            room = seen + np.where(touching, 0, np.maximum(gap, 0))
            limited = touching & (change != 0) | (change < 0)
            scale = min(scale, 1 + (room[limited] / abs(change[limited])).min(initial=np.inf))
    power = 10 ** np.floor(np.log10(scale))
    return max(1, power * max(digit for digit in (1, 2, 5) if digit * power <= scale * 1.0001))


def viewpoint(mesh, zone, from_below=False):
    """Rotation into coordinates of the picture, the cells to be drawn, and a remark if these are not all.

    The contact normal points up, and the viewer stands where the contact zone is closest to the rim: before the
    symmetry planes of a quarter model. Where the zone is inside all the same, the quadrant in front of it is cut away, unless it
    is looked at from below.
    """
    corners = np.stack([mesh.points.min(axis=0), mesh.points.max(axis=0)])
    size = np.ptp(corners, axis=0).max()
    seen = mesh.points[zone] if zone.any() else corners
    middle = seen.mean(axis=0) if zone.any() else corners[0]
    up = int(np.argmin(np.ptp(seen, axis=0))) if zone.any() else 2
    plane = [(up + 1) % 3, (up + 2) % 3]
    side = np.where(middle - corners[0] <= (corners[1] - middle) * 1.01, -1, 1)

    towards = np.zeros(3)
    towards[plane] = side[plane] * [0.62, 0.8]
    towards[up] = -0.45 if from_below else 0.45
    towards /= np.linalg.norm(towards)
    right = np.cross(np.eye(3)[up], towards)
    right /= np.linalg.norm(right)
    turn = np.stack([right, np.cross(towards, right), towards])

    hidden = np.full(len(mesh.cells), not from_below)
    for axis in plane:
        rim, nearest = corners[(side[axis] + 1) // 2, axis], (seen[:, axis] * side[axis]).max()
        hidden &= (mesh.points[mesh.cells, axis].mean(axis=1) - middle[axis]) * side[axis] > 0
        hidden &= rim * side[axis] - nearest > 0.02 * size
    return turn, mesh.cells[~hidden], ", one quadrant cut away" if hidden.any() else ""


# Faces and edges -----------------------------------------------------------------------------------------------------


def middle(points, faces):
    """The mean of the corners of each face; corners of triangles that coincide count once."""
    faces = np.sort(faces, axis=1)
    is_new = np.concatenate([np.full((len(faces), 1), True), faces[:, 1:] != faces[:, :-1]], axis=1)
    return (points[faces] * is_new[..., None]).sum(axis=1) / is_new.sum(axis=1)[:, None]


def outer_faces(points, cells, body):
    """The faces (n, 4) of hexahedra that no other cell of the same body shares, and the cell that each belongs to."""
    body = np.unique(body, return_inverse=True)[1]
    keys = np.stack([places(points, middle(points, cells[:, face]), body) for face in FACES], axis=1)
    _, inverse, count = np.unique(keys, return_inverse=True, return_counts=True)
    owner, face = np.nonzero((count[inverse] == 1).reshape(keys.shape))
    faces, own, body = cells[owner[:, None], FACES[face]], keys[owner, face], body[owner]

    # At hanging nodes a face meets its own four quarters. What escapes this test, on curved cells, lies inside the body
    # and is painted over.
    quarters = [np.roll([9, 3, 1, 3], k) @ points[faces] / 16 for k in range(4)]
    quarters = np.stack([places(points, centre, body) for centre in quarters], axis=1)
    coarse = np.isin(quarters, own).any(axis=1)
    inside = coarse | np.isin(own, quarters[coarse])
    return faces[~inside], owner[~inside]


def places(points, x, body):
    """One integer for each position x in a numbered body: equal for positions that differ by rounding only."""
    # The step is no round number, so that coordinates, which often are, do not lie where rounding up and down part.
    step = np.pi * 1e-6 * np.ptp(points, axis=0).max()
    return np.rint((x - points.min(axis=0)) / step).astype(np.int64) @ (1, 1 << 19, 1 << 38) + (body << 57)


def is_cell_edge(faces, owner, n_points):
    """(n, 4): is the side from corner i to i+1 an edge of a cell? If not, it divides a cell written in parts."""
    # Parts of one cell share the points between them, different cells do not.
    other = np.roll(faces, -1, axis=1)
    _, side = np.unique(np.minimum(faces, other) * n_points + np.maximum(faces, other), return_inverse=True)
    side = side.reshape(-1)
    pairs = np.unique(np.stack([side, np.repeat(owner, 4)]), axis=1)
    return (np.bincount(pairs[0]) == 1)[side].reshape(-1, 4)


# Painting ------------------------------------------------------------------------------------------------------------


def paint(ax, x, values, lines, window, norm, shaded):
    """Draw quadrilaterals: corners x (n, 4, 3), values there (n, 4), and which sides get a line (n, 4)."""
    low, high = x.min(axis=1), x.max(axis=1)
    chosen = np.all((high[:, :2] >= window[:, 0]) & (low[:, :2] <= window[:, 1]), axis=1)
    normal = np.cross(x[:, 2] - x[:, 0], x[:, 3] - x[:, 1])
    if shaded:
        chosen &= normal[:, 2] > 0
    x, values, lines, normal = x[chosen], values[chosen], lines[chosen], normal[chosen]
    if not len(x):
        return
    light = np.ones(len(x))
    if shaded:
        light = 0.87 + 0.13 * np.clip(normal @ (-0.35, 0.75, 0.56) / np.linalg.norm(normal, axis=1), 0, 1)

    # An outline: wide lines about everything, of which the faces drawn above leave only the outer half.
    ax.add_collection(PolyCollection(x[:, :, :2], facecolors="none", edgecolors=[LINE], linewidths=2.4))

    size, piece = (high - low)[chosen].max(axis=1), np.ptp(window, axis=1).max() / 80
    parts = 2 ** np.clip(np.ceil(np.log2(size / piece)), 0, 5).astype(int)
    # Edges of cells too small to be told apart fade, so that they do not blacken the picture.
    strength = 0.65 * np.clip(1.5 * (high - low)[chosen, :2].max(axis=1) / piece - 0.5, 0, 1)[:, None] * lines
    groups = [(parts == n, n) for n in np.unique(parts)]
    pieces = [divide(x[i], norm(values[i]), strength[i], light[i], size[i], n) for i, n in groups]
    depth, polygons, fill, edge = (np.concatenate(column) for column in zip(*pieces))
    order = np.argsort(depth, kind="stable")
    # Areas that are smoothed at their rims would show seams between them.
    style = dict(facecolors=fill[order], edgecolors=edge[order], linewidths=0.5, antialiaseds=edge[order, 3] > 0)
    ax.add_collection(PolyCollection(polygons[order], **style), autolim=False)


def divide(x, values, strength, light, size, n):
    """Faces in n*n parts, and their sides in n: depth, polygon, colours of the area and of the line."""
    s = np.linspace(0, 1, n + 1)
    a, b = s[None, :], s[:, None]
    bilinear = np.stack([(1 - a) * (1 - b), a * (1 - b), a * b, (1 - a) * b], axis=2)
    x, values = np.einsum("ijc,fcx->fijx", bilinear, x), np.einsum("ijc,fc->fij", bilinear, values)

    def corners(grid):
        return np.stack([grid[:, :-1, :-1], grid[:, :-1, 1:], grid[:, 1:, 1:], grid[:, 1:, :-1]], axis=3)

    areas = corners(x).reshape(-1, 4, 3)
    fill = COLOURS(corners(values).mean(axis=3)).reshape(-1, 4)
    fill[:, :3] *= np.repeat(light, n * n)[:, None]

    sides = np.stack([x[:, 0], x[:, :, -1], x[:, -1, ::-1], x[:, ::-1, 0]], axis=1)
    lines = np.stack([sides[:, :, :-1], sides[:, :, 1:], sides[:, :, 1:], sides[:, :, :-1]], axis=3).reshape(-1, 4, 3)
    ink = np.concatenate([np.tile(LINE, (len(lines), 1)), np.repeat(strength.reshape(-1, 1), n, axis=0)], axis=1)
    nearer = np.repeat(size, 4 * n) / n  # so that a line is drawn after the areas on both sides of it
    lines, ink, nearer = lines[ink[:, 3] > 0], ink[ink[:, 3] > 0], nearer[ink[:, 3] > 0]
    return (
        np.concatenate([areas[:, :, 2].mean(axis=1), lines[:, :, 2].mean(axis=1) + nearer]),
        np.concatenate([areas, lines])[:, :, :2],
        np.concatenate([fill, np.zeros_like(ink)]),
        np.concatenate([np.zeros_like(fill), ink]),
    )


# Layout --------------------------------------------------------------------------------------------------------------


def panels(x, n):
    span = np.ptp(x[:, :2], axis=0)
    width = np.clip(4.8 * span[0] / span[1], 3.2, 7.5)
    size = (width + 1.6, min(5.4, 4.2 * width * span[1] / span[0] / 4 + 1.6)) if n == 1 else (width + 6, 5.4)
    figure, axes = plt.subplots(1, n, squeeze=False, layout="constrained", figsize=size, width_ratios=[width, 4.8][:n])
    figure.get_layout_engine().set(w_pad=0.08, h_pad=0.08)
    return figure, axes[0]


def whole(x):
    low, high = x[:, :2].min(axis=0), x[:, :2].max(axis=0)
    margin = 0.03 * (high - low).max()
    return np.stack([low - margin, high + margin], axis=1)


def close_up(x, zone):
    """Window four times as large as the contact zone, shifted and cut where it would show mere emptiness."""
    limits = whole(x)
    low, high = x[zone, :2].min(axis=0), x[zone, :2].max(axis=0)
    half = max(2 * (high - low).max(), 0.02 * np.ptp(limits))
    centre, middle = (low + high) / 2, limits.mean(axis=1)
    centre = np.clip(centre, np.minimum(limits[:, 0] + half, middle), np.maximum(limits[:, 1] - half, middle))
    window = np.stack([centre - half, centre + half], axis=1)
    return np.stack([np.maximum(window[:, 0], limits[:, 0]), np.minimum(window[:, 1], limits[:, 1])], axis=1)


def frame(axes, window):
    """Show in the first panel what the second one magnifies."""
    (left, right), (bottom, top) = window
    axes[0].plot([left, right, right, left, left], [bottom, bottom, top, top, bottom], color=FRAME, linewidth=1)
    plt.setp(axes[1].spines.values(), color=FRAME, visible=True)


def triad(ax, turn):
    """Instead of scales, which a projection has not: the directions of the axes, small, in the lower left corner."""
    ax.set(xticks=[], yticks=[])
    ax.spines[:].set_visible(False)
    where = dict(xycoords="axes pixels", textcoords="axes pixels")
    for axis, direction in zip("xyz", turn.T[:, :2]):
        ax.annotate("", 30 + 24 * direction, (30, 30), arrowprops=dict(arrowstyle="-"), **where)
        ax.annotate(axis, 30 + 31 * direction, 30 + 31 * direction, ha="center", va="center", fontsize=8, **where)
