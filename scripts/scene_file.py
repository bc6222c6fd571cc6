# SPDX-License-Identifier: Apache-2.0
"""Read a scene as the program writes it (scene.prm of an output directory): sections and keys, nothing evaluated."""


def read_scene(file):
    """Nested dictionaries: sections by their names, keys with their texts. Empty where there is no such file."""
    scene = {}
    if not file.exists():
        return scene
    path = [scene]
    for line in file.read_text(errors="replace").splitlines():
        word, _, rest = line.strip().partition(" ")
        if word == "subsection":
            path.append(path[-1].setdefault(rest.strip(), {}))
        elif word == "end" and len(path) > 1:
            path.pop()
        elif word == "set":
            key, _, value = rest.partition("=")
            path[-1][key.strip()] = value.strip()
    return scene


def named(scene, section):
    """Name -> keys of what a section lists under Names."""
    contents = scene.get(section, {})
    names = [name.strip() for name in contents.get("Names", "").split(",") if name.strip()]
    return {name: contents.get(name, {}) for name in names}
