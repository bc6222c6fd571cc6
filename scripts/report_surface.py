# SPDX-License-Identifier: Apache-2.0
"""Surfaces of the deformed bodies for the 3D view of a report: outer faces, mesh lines and fields, as packed numbers."""

import base64

import numpy as np

import vtu
from bodies import COLOURS, contact_zone, outer_faces, places, viewpoint, visible_scale
from profiles import normals, positions

MOST_FACES = 60000  # of all surfaces: the file stays below about ten megabytes, and a phone can turn it
MOST_BYTES = 2e9  # of the VTU files of a load step

# Field of the bodies -> words. The first one is shown at first.
OF_BODIES = {
    "von_mises": "von Mises stress",
    "displacement": "displacement, length",
    "displacement_x": "displacement, x",
    "displacement_y": "displacement, y",
    "displacement_z": "displacement, z",
    "principal_stress_1": "most tensile principal stress",
    "principal_stress_3": "most compressive principal stress",
}
OF_CONTACT = {
    "pressure": "contact pressure",
    "gap": "gap",
    "tangential_traction": "tangential traction, length",
    "slip": "slip, length",
}


def view_of(mesh, contact, profiles, rigid):
    """What the script of the page draws: surfaces, fields and scales; and remarks for the reader.

    @param contact mesh of contact.pvd, or None
    @param rigid names of the pairs whose master is an obstacle
    """
    remarks, surfaces, extent = [], list(body_surfaces(mesh)), np.ptp(mesh.points, axis=0).max()
    if contact is not None:
        surfaces += contact_surfaces(contact, profiles, rigid)
    fields = {}
    for kind, names in (("body", OF_BODIES), ("contact", OF_CONTACT)):
        for name, words in names.items():
            if f := field_range([surface for surface in surfaces if surface["kind"] == kind], name):
                fields[name] = {"label": words, "of": kind, **f}
    n_faces = sum(len(surface["faces"]) for surface in surfaces)
    if n_faces > MOST_FACES:
        zone = mesh.points[contact_zone(mesh, profiles)]
        surfaces, size, kept = coarsened(surfaces, extent, zone)
        where = "outside of the contact zone " if kept else ""
        remarks.append(
            f"The surfaces have {n_faces:,} faces, which are too many for a page: {where}points within {size:.2g} "
            "of each other are drawn as one, with the mean of their values, and mesh lines are left out. The ranges of values "
            "are those of the whole surfaces."
        )
    towards, up = camera(mesh, profiles)
    scale = visible_scale(mesh.field("displacement"), profiles, extent)
    return {
        "flat": mesh.dimension == 2,
        "towards": towards,
        "up": up,
        "size": float(extent),
        "scale": float(scale),
        "colours": [[i / 15, "#%02x%02x%02x" % tuple(round(255 * c) for c in COLOURS(i / 15)[:3])] for i in range(16)],
        "fields": fields,
        "surfaces": [packed(surface) for surface in surfaces],
    }, remarks


def camera(mesh, profiles):
    """Direction to the viewer, as in bodies.png before planes of symmetry, and the axis that points up, that of the contact normal."""
    if mesh.dimension == 2:
        return [0, 0, 1], [0, 1, 0]
    turn = viewpoint(mesh, contact_zone(mesh, profiles))[0]
    up = [0, 0, 0]
    up[int(np.argmax(abs(turn[1])))] = 1
    return [float(x) for x in turn[2]], up


def field_range(surfaces, name):
    """Ends of the colours and of the values. Single peaks are beyond the colours, as in bodies.png."""
    values = [surface["fields"][name] for surface in surfaces if name in surface["fields"]]
    values = np.concatenate([one[np.isfinite(one)] for one in values]) if values else np.empty(0)
    if not values.size or (name == "displacement_z" and not values.any()):
        return None
    low, high = float(values.min()), float(values.max())
    top, bottom = (float(np.percentile(values, p)) for p in (99.5, 0.5))
    if high < 1.15 * top or not name.startswith(("von", "principal")):
        top = high
    if name.startswith("principal") and low < 1.15 * bottom < 0:
        bottom = low
    elif not name.startswith("principal"):
        bottom = min(low, 0)
    return {"least": low, "most": high, "from": bottom, "to": top if top > bottom else bottom + 1}


# Surfaces ------------------------------------------------------------------------------------------------------------


def body_surfaces(mesh):
    body = mesh.fields.get("body", np.zeros(len(mesh.points)))
    number = body[mesh.cells[:, 0]].round().astype(int)
    names = mesh.names.get("body", [])
    if mesh.dimension == 2:
        faces, owner = mesh.cells, number
    else:
        faces, cell = outer_faces(mesh.points, mesh.cells, number)
        owner = number[cell]
    fields = {name: scalar(mesh, name) for name in OF_BODIES if available(mesh, name)}
    for i in np.unique(owner):
        name = names[i] if i < len(names) else f"body {i}"
        yield surface("body", name, mesh.points, mesh.field("displacement"), faces[owner == i], fields)


def contact_surfaces(contact, profiles, rigid):
    """Slave surfaces, and beyond them, by the gap, the part of obstacles that is opposite."""
    pair = contact.fields.get("pair", np.zeros(len(contact.points)))
    number = pair[contact.cells[:, 0]].round().astype(int)
    names = contact.names.get("pair", [])
    fields = {name: scalar(contact, name) for name in OF_CONTACT if available(contact, name)}
    result = []
    for i in np.unique(number):
        name = names[i] if i < len(names) else f"pair {i}"
        slave = surface("contact", name, contact.points, contact.field("displacement"), contact.cells[number == i], fields)
        result.append(slave)
        if name in rigid and name in profiles and (opposite := obstacle(slave, profiles[name])):
            result.append(opposite)
    return result


def obstacle(slave, profile):
    """Where obstacles are, beyond the points of the slave: at rest by the initial gap, then moved as far as the gap tells.

    Nothing where contact points are no nodes of the slave, or where the gap is not known.
    """
    if "initial_gap" not in profile.dtype.names:
        return None
    x = positions(profile)
    both = np.concatenate([x, slave["points"]])
    keys = places(both, both, np.zeros(len(both), np.int64))
    order = np.argsort(keys[: len(x)])
    found = order[np.searchsorted(keys[: len(x)], keys[len(x) :], sorter=order).clip(max=len(x) - 1)]
    is_node = keys[found] == keys[len(x) :]
    normal, gap, at_first = (values[found] for values in (normals(profile), profile["gap"], profile["initial_gap"]))
    known = is_node & np.isfinite(gap) & np.isfinite(at_first)
    faces = slave["faces"][known[slave["faces"]].all(axis=1)]
    if not len(faces):
        return None
    points = np.where(known[:, None], slave["points"] - at_first[:, None] * normal, 0)
    motion = np.where(known[:, None], slave["displacement"] - (gap - at_first)[:, None] * normal, 0)
    return surface("obstacle", "obstacle of " + slave["name"], points, motion, faces, {})


def surface(kind, name, points, displacement, faces, fields):
    """Points of the same position become one, with the mean of the values that the cells have there."""
    used = np.unique(faces)
    key = places(points, points[used], np.zeros(len(used), np.int64))
    _, first, index, count = np.unique(key, return_index=True, return_inverse=True, return_counts=True)
    index = index.reshape(-1)
    renumbered = np.full(len(points), -1)
    renumbered[used] = index

    def mean(values):
        values = np.asarray(values, float)[used]
        return np.stack([np.bincount(index, column) / count for column in values.reshape(len(used), -1).T], axis=1)

    return {
        "kind": kind,
        "name": name,
        "points": points[used][first],
        "displacement": mean(displacement),
        "faces": renumbered[faces],
        "fields": {field: mean(values)[:, 0] for field, values in fields.items()},
        "lines": True,
    }


def available(mesh, name):
    plain = {key.lower().replace(" ", "_") for key in mesh.fields}
    return name in plain or (name[:-2] in plain and name[-2:] in ("_x", "_y", "_z"))


def scalar(mesh, name):
    """A field, of a vector its component or its length."""
    if name[-2:] in ("_x", "_y", "_z"):
        return mesh.field(name[:-2])[:, "xyz".index(name[-1])]
    values = mesh.field(name)
    return np.linalg.norm(values, axis=1) if values.ndim > 1 else values


def coarsened(surfaces, size, zone):
    """Points in the same cube of a grid become one. The largest number of cubes that leaves few enough faces.

    @param zone points of the contact zone, about which all faces are kept, unless these alone are too many
    """
    low, high = (zone.min(axis=0), zone.max(axis=0)) if len(zone) else (np.zeros(3), np.zeros(3))
    slack = 0.5 * np.max(high - low)
    nowhere = np.full(3, np.inf), np.full(3, -np.inf)
    for window in ((low - slack, high + slack), nowhere) if len(zone) else (nowhere,):
        for n in (200, 140, 100, 70, 50, 30):
            result = [cluster(one, size / n, window) for one in surfaces]
            if sum(len(one["faces"]) for one in result) <= MOST_FACES:
                return result, size / n, window is not nowhere
    return result, size / n, False


def cluster(one, step, window):
    points = one["points"]
    cube = np.rint(points / step).astype(np.int64)
    kept = np.all((points >= window[0]) & (points <= window[1]), axis=1)
    own = np.where(kept, 1 + np.arange(len(points)), 0)
    _, index, count = np.unique(np.column_stack([cube, own]), axis=0, return_inverse=True, return_counts=True)
    index = index.reshape(-1)

    def mean(values):
        return np.stack([np.bincount(index, column) / count for column in values.reshape(len(index), -1).T], axis=1)

    faces = index[one["faces"]]
    if faces.shape[1] == 4:  # of flat faces those that have kept an area
        faces = faces[(faces[:, 0] != faces[:, 2]) & (faces[:, 1] != faces[:, 3])]
    if faces.shape[1] == 2:
        faces = faces[faces[:, 0] != faces[:, 1]]
    faces = faces[np.unique(np.sort(faces, axis=1), axis=0, return_index=True)[1]]
    return {
        **one,
        "points": mean(points),
        "displacement": mean(one["displacement"]),
        "faces": faces,
        "lines": False,
        "fields": {field: mean(values)[:, 0] for field, values in one["fields"].items()},
    }


# Numbers -------------------------------------------------------------------------------------------------------------


def packed(one):
    """Numbers as base64 of 32 bits: half the size of text, and all the digits that a picture needs."""
    faces = one["faces"]
    sides = np.sort(np.concatenate([faces[:, [i, (i + 1) % faces.shape[1]]] for i in range(faces.shape[1])]), axis=1)
    return {
        "kind": one["kind"],
        "name": one["name"],
        "corners": faces.shape[1],
        "points": base64_of(one["points"], "<f4"),
        "displacement": base64_of(one["displacement"], "<f4"),
        "faces": base64_of(faces, "<u4"),
        "lines": base64_of(np.unique(sides, axis=0), "<u4") if one["lines"] else "",
        "fields": {name: base64_of(values, "<f4") for name, values in one["fields"].items()},
    }


def base64_of(values, kind):
    return base64.b64encode(np.ascontiguousarray(values, kind).tobytes()).decode()


def read_step(solution, step):
    """The mesh of a load step of a .pvd file, or of the last one; a sentence where there is none to show."""
    if not solution.exists():
        return None, "There is no 3D view, since the run has written no meshes (Output/VTU = no, or no load step is solved)."
    files = [file for _, file in vtu.steps(solution) if step is None or file.stem.endswith(f"_{step:04d}")]
    if not files:
        return None, f"There is no 3D view, since load step {step} is not in {solution.name}."
    size = sum(file.stat().st_size for file in files[-1].parent.glob(files[-1].stem + ".*"))
    if size > MOST_BYTES:
        words = f"the meshes are too large for a page ({size / 1e9:.1f} GB); ParaView opens {solution.name}"
        return None, f"There is no 3D view, since {words}."
    return vtu.read(files[-1]), ""
