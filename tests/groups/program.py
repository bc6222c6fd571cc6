# SPDX-License-Identifier: Apache-2.0
"""The program itself as users start it: exit codes, options, several ranks, messages that come once."""

import base64
import re
import resource
import signal
import struct
import subprocess
import zlib
from xml.etree import ElementTree

from case import PRM, SCENES, TESTS, VARIED, Case, Failed


def starts(words, code, ranks=1, out="", err="", largest_file=None):
    """`out` and `err` are found exactly once. No file gets larger than that: as on a disk that is full."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))

    def body(test):
        command = [test.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        folder = test.directory / test.case.replace("/", "-")
        words_here = [word.replace("FOLDER", str(folder)) for word in words]
        run = subprocess.run(command + [test.program, *words_here], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             timeout=300, restore_signals=largest_file is None, preexec_fn=limit if largest_file else None)
        test.print(run.stdout + run.stderr)
        test.check(run.returncode == code, f"exit code {run.returncode} instead of {code}")
        for text, stream in ((out, run.stdout), (err, run.stderr)):
            if text:
                test.check(stream.count(text) == 1, f"'{text}' is there {stream.count(text)} times, not once")
    return body


def steep(test):
    """Pressures that rise to an edge do not alternate."""
    checks = test.results(VARIED / "narrow-block.prm")["verdict"]["checks"]
    found = [one for one in checks if one["check"] == "pressure oscillation"]
    test.check([one["value"] for one in found] == [0], f"{found}")


def keywords_of_decks(test):
    """The table of the guide has each keyword that the reader knows."""
    reader = (TESTS.parent / "source" / "mesh_import" / "decks" / "deck_reader.cc").read_text()
    tables = reader[reader.index("DeckReader::registry"):reader.index("DeckReader::of_known_length")]
    known = re.findall(r'{"([A-Z -]+)",', tables)
    guide = (TESTS.parent / "doc" / "guide" / "decks.md").read_text()
    test.check(len(known) > 80, "the keywords are found")
    for keyword in known:
        test.check(f"`*{keyword}`" in guide, f"*{keyword} is in doc/guide/decks.md")


def arrays_of(file):
    """The fields of points of a VTU file, one tuple a point, and the positions."""
    piece, found = ElementTree.parse(file).getroot().find("UnstructuredGrid/Piece"), {}
    for array in [*piece.find("PointData"), *piece.find("Points")]:
        packed = array.text.strip()
        size = struct.unpack("<4I", base64.b64decode(packed[:24])[:16])[1]
        plain = zlib.decompress(base64.b64decode(packed[24:]))
        numbers = struct.unpack(f"<{size // 4}f", plain)
        width = int(array.get("NumberOfComponents"))
        found[array.get("Name", "positions")] = [numbers[i:i + width] for i in range(0, len(numbers), width)]
    return found


def fields_of_bodies(ranks):
    """Three cubes in a row: stresses are uniform; strains of the last, of degree 2 and 100 times as soft, jump within its body. Nodes
    are written once on each rank, but twice between the materials."""
    def body(test):
        folder = test.directory / f"fields-{ranks}"
        command = [test.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        run = subprocess.run(command + [test.program, str(SCENES / "layers.prm"), "--set", "Output/Strain=yes", "--set",
                                        f"Output/Directory={folder}"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        if run.returncode != 0:
            raise Failed(run.stderr)
        strain_of, n_points = {}, 0
        for file in folder.glob("solution_0001.*.vtu"):
            fields = arrays_of(file)
            n_points += len(fields["positions"])
            for x, stress, von_mises, strain in zip(*(fields[name] for name in ("positions", "stress", "von_mises", "strain"))):
                test.check(abs(stress[8] + 0.980392) < 1e-5 and abs(von_mises[0] - 0.980392) < 1e-5, f"stress {stress} at {x}")
                strain_of.setdefault(tuple(round(c, 5) for c in x), set()).add(round(strain[8], 5))
        values = set.union(*strain_of.values())
        test.check(values == {-0.00098, -0.09804}, f"strains {values}")
        test.check(sum(len(one) == 2 for one in strain_of.values()) > 0, "no point has a jump")
        if ranks == 1:
            test.check(n_points == sum(map(len, strain_of.values())), f"{n_points} points")
    return body


def cases():
    for ranks in (1, 2):
        yield Case("program", f"fields of bodies/np{ranks}", fields_of_bodies(ranks), ranks)

    def case(name, *arguments, ranks=1, **what):
        return Case("program", f"{name}/np{ranks}", starts(*arguments, ranks=ranks, **what), ranks)

    output = ["--set", "Output/VTU=no", "--set", "Output/Directory=FOLDER"]
    plane = [str(PRM / "block-on-plane.prm"), *output]
    yield case("version", ["--version"], 0, out="Signorini ")
    yield case("help", ["--help"], 0, out="--print-reference")
    yield case("template", ["--print-template", "3"], 0, out="Dimension")
    yield case("no-scene", [], 2, err="no scene is given")
    yield case("unknown-option", ["--chek", *plane], 2, err="unknown option '--chek'")
    yield case("check", ["--check", plane[0]], 0, out="nothing was solved")
    yield case("not-converged", [str(TESTS / "failures" / "not-converged.prm"), *output], 3, out="Not solved: ")
    yield case("expectation-missed", [str(TESTS / "failures" / "missed-result.prm"), *output], 4, out="MISSED")
    roller = [str(SCENES / "roller.prm"), "--set", "Mesh/Contact refinements=0", "--set", "Expected results/Names=", *output]
    for ranks in (1, 2):
        yield case("few-faces", roller, 0, ranks=ranks, out="WARNED  faces across the contact area, pair in: 1, limit 5, t = 1")
        yield case("strict", ["--strict", *roller], 3, ranks=ranks, out="No answer: faces across the contact area, pair in")
    yield case("strict-passed", ["--strict", *plane], 0, out="results in")
    apart = [plane[0], "--set", "Supports/press/Displacement=0; 0.001*t", *output]
    yield case("never-acts", apart, 0, out="the surfaces of this pair never touch")
    far = [plane[0], "--set", "Supports/press/Displacement=0; 10*t", *output]
    yield case("far-away", far, 3, out="No answer: displacement / model size: 'block' moves farther than the size of the model")
    wavy = [str(SCENES / "contrast.prm"), "--set", "Expected results/Names=", *output]
    named = ["--set", "Contact pairs/joint/Slave choice=as named"]
    yield case("sides", wavy, 0, out="slave and master are exchanged, since 'up.bottom' is 1e+06 times as stiff")
    yield case("sides-as-named", wavy + named, 0, out="WARNED  slave choice, pair joint: ")
    yield case("off-nodes", wavy + ["--set", "Contact method/Method=direct elimination"], 0,
               out="WARNED  non-matching nodes, pair joint: ")
    yield case("soft-penalty", plane + ["--set", "Contact method/Method=penalty", "--set", "Contact method/penalty/Factor=0.1"], 0,
               out="WARNED  penetration / deformation, pair ")
    yield case("stiff-penalty", plane + ["--set", "Contact method/Method=penalty", "--set", "Contact method/penalty/Factor=1e11"], 0,
               out="WARNED  penalty round-off / pressure, pair ")
    yield case("obstacle-overlap", [str(TESTS / "varied" / "obstacle-overlap.prm"), *output], 0, out="WARNED  undetected contact: ")
    yield case("alternating", wavy + named, 0, out="WARNED  pressure oscillation, pair joint: ")
    yield Case("program", "steep", steep)
    yield Case("program", "keywords of decks", keywords_of_decks)
    rubber = [str(SCENES / "nearly-incompressible.prm"), "--set", "Expected results/Names=", *output]
    displacement = ["--set", "Bodies/block/Formulation=displacement"]
    yield case("factorised", rubber + displacement, 0, out="the iterative solver does not converge: a direct solver is used from here on")
    yield case("locking", rubber + ["--set", "Mesh/Degree=1"], 0, out="WARNED  volumetric locking: ")
    sector = [str(VARIED / "sectors.prm")]
    for key, value in (("Bodies/Names", "ring"), ("Supports/Names", "bore, position"), ("Contact pairs/Names", "ring sectors"),
                       ("Contact pairs/ring sectors/Master rotation", "89.7")):
        sector += ["--set", f"{key}={value}"]
    yield case("angle of a sector", sector + output, 3, out="FAILED  gap of the image / face, pair ring sectors: ")
    jump = [str(PRM / "receding-layer.prm"), "--set", "Loads/strip/Pressure=if(x < 5.1, 10, 0)", "--set", "Expected results/Names=",
            *output]
    yield case("load-that-jumps", jump, 0, out="WARNED  load quadrature error, load strip: ")
    for size in (2000, 8000):  # the scene, the solution
        yield case(f"full-disk-{size}", plane[:1] + output[2:], 1, err="; is the disk full?", largest_file=size)
    for ranks in (1, 2, 4):
        yield case("solved", plane, 0, ranks=ranks, out="results in")
        yield case("misspelt-key", [str(TESTS / "failures" / "misspelt-key.prm")], 2, ranks=ranks, err="did you mean")
    former = [str(SCENES / "support-times.prm"), "--check", *output]
    for ranks in (1, 2):
        yield case("former-name", former, 0, ranks=ranks, out="support-times.prm:44: 'From' is now called 'Start time'; the former name")
    yield case("missing-file", [str(SCENES / "no-such-scene.prm")], 2, ranks=2, err="no-such-scene.prm")
