# SPDX-License-Identifier: Apache-2.0
"""Checks of a report: of its text alone, and in a headless browser."""

import base64
import json
import re
import shutil
import subprocess
import tempfile
from html.parser import HTMLParser
from pathlib import Path

SECTIONS = ("verdict", "model", "bodies", "forces", "accuracy", "curves", "convergence", "pictures", "origin")
VOID = {"meta", "img", "br", "input", "link", "hr"}
BROWSERS = ("chromium", "chromium-browser", "google-chrome")


class Reader(HTMLParser):
    """Sections, sources, numbers with their entries, and data of a report."""

    def __init__(self):
        super().__init__()
        self.sections, self.sources, self.numbers, self.data, self.problems = [], [], [], {}, []
        self.words, self.open, self.outcome = [], [], None

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "section":
            self.sections.append(attributes["id"])
        self.sources += [attributes[key] for key in ("src", "href", "srcset", "action") if key in attributes]
        self.outcome = attributes.get("data-outcome", self.outcome)
        if tag not in VOID:
            self.open.append((tag, attributes))

    def handle_endtag(self, tag):
        if not self.open or self.open[-1][0] != tag:
            self.problems.append(f"</{tag}> closes nothing at line {self.getpos()[0]}")
        else:
            self.open.pop()

    def handle_data(self, text):
        if not self.open:
            return
        tag, attributes = self.open[-1]
        if tag == "script":
            if attributes.get("type") == "application/json":
                self.data[attributes["id"]] = self.data.get(attributes["id"], "") + text
            return
        if tag != "style":
            self.words.append(text)
        if "data-entry" in attributes:
            self.numbers.append((json.loads(attributes["data-entry"]), text, float(attributes.get("data-scale", 0))))


def read_report(file):
    reader = Reader()
    reader.feed(Path(file).read_text(encoding="utf-8"))
    reader.close()
    return reader


def problems_of(file, results):
    """What is wrong with a report, read as text: beside the dictionary of results.json."""
    reader = read_report(file)
    problems = reader.problems + [f"<{tag}> is not closed" for tag, _ in reader.open]
    problems += [f"there is no section '{name}'" for name in SECTIONS if name not in reader.sections]
    problems += [
        f"a source outside of the file: {source[:80]}" for source in reader.sources if not re.match(r"data:image/|#", source)
    ]
    for path, words, scale in reader.numbers:
        value = results
        for key in path:
            value = value[key] if isinstance(value, list) or key in (value or {}) else None
        if not agrees(words, value, scale):
            problems.append(f"{'/'.join(map(str, path))} is {value}, the report says {words}")
    for name, written in reader.data.items():
        try:
            data = json.loads(written)
        except ValueError as error:
            problems.append(f"{name}: {error}")
            continue
        if name == "view-data":
            problems += [f"view: {problem}" for problem in problems_of_view(data)]
    return problems


def agrees(words, value, scale):
    """To the digits that are shown: at least two of them."""
    if words == "≈ 0":
        return abs(value) <= 1e-8 * scale
    if value is None or isinstance(value, bool):
        return words == {None: "not computed", True: "yes", False: "no"}[value]
    if isinstance(value, str):
        return words == value
    return abs(float(words.replace("−", "-").replace(",", "")) - value) <= 0.051 * abs(value)


def problems_of_view(view):
    """Sizes of the packed numbers."""
    for surface in view["surfaces"]:
        n = len(base64.b64decode(surface["points"])) // 12
        if len(base64.b64decode(surface["displacement"])) != 12 * n:
            yield f"{surface['name']}: points and displacements are of different number"
        faces = memoryview(base64.b64decode(surface["faces"])).cast("I")
        if not len(faces) or len(faces) % surface["corners"] or max(faces) >= n:
            yield f"{surface['name']}: faces are none of its points"
        for name, values in surface["fields"].items():
            if len(base64.b64decode(values)) != 4 * n:
                yield f"{surface['name']}: {name} has not a value a point"


# In a browser --------------------------------------------------------------------------------------------------------


def browser():
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def check_in_browser(file, width):
    """Load the file in headless Chromium, without a network, in a frame of that width: windows of Chromium are not so narrow.

    Errors of scripts, and what the page says of itself: whether all is drawn, and whether it is wider than the screen.
    """
    program = browser()
    if program is None:
        return ["There is no Chromium (scripts/setup --packages chromium installs it)."]
    with tempfile.TemporaryDirectory() as folder:
        frame = Path(folder) / "frame.html"
        frame.write_text(
            f'<iframe src="{Path(file).resolve().as_uri()}#check" width="{width}" height="600"></iframe>'
            "<script>onmessage = (event) => { document.body.dataset.drawn = event.data; };</script>"
        )
        command = [
            program,
            "--headless",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            "--host-resolver-rules=MAP * ~NOTFOUND",
            f"--window-size={width + 50},700",
            f"--user-data-dir={folder}/profile",
            "--enable-logging=stderr",
            "--virtual-time-budget=5000",
            "--dump-dom",
            frame.as_uri(),
        ]
        done = subprocess.run(command, capture_output=True, text=True, timeout=180)
    problems = [
        line[:300] for line in done.stderr.splitlines() if "CONSOLE" in line and re.search(r"error|Refused|Uncaught", line, re.I)
    ]
    drawn = re.search(r'<body[^>]* data-drawn="([^"]*)"', done.stdout)
    has_script = read_report(file).data
    if has_script and (not drawn or drawn[1] != "ready"):
        problems.append(f"{width} pixels wide: {drawn[1] if drawn else 'the script of the page has not ended'}")
    return problems
