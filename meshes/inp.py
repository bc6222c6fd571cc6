"""Parts of files in the format of Abaqus, for the scripts that make meshes here."""


def lines(*stations):
    """Positions from start, (end, cells), (end, cells), ..."""
    result = [stations[0]]
    for end, cells in stations[1:]:
        start = result[-1]
        result += [start + (end - start) * k / cells for k in range(1, cells + 1)]
    return result


def elements_of(parts, kind):
    """The elements of each part, which have the type `kind` and are in a set of the part's name."""
    text = ""
    for part in parts:
        text += f"*ELEMENT, TYPE={kind}, ELSET={part.name}\n"
        text += "".join(f"{e}, " + ", ".join(map(str, nodes)) + "\n" for e, nodes in part.elements.items())
    return text


def surface(name, faces):
    """A surface of faces: pairs of element and number of the side."""
    return f"*SURFACE, NAME={name}, TYPE=ELEMENT\n" + "".join(f"{e}, S{side}\n" for e, side in faces)
