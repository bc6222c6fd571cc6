# SPDX-License-Identifier: Apache-2.0
"""Parts of the page that scripts/report writes: escaped text, numbers with the entry that they come from, tables."""

import html
import json
import math
import re
from pathlib import Path

FILES = Path(__file__).resolve().parent / "report_files"
MISSING = "not computed"
ROUNDING = 1e-8  # relative: smaller numbers are those of round-off and of the tolerance of solvers
# The program recognises a report of its own by this mark in its first 1000 bytes, and removes it with the other files of a run.
MARK = "<!-- Written by Signorini scripts/report -->"


def text(words):
    return html.escape(str(words), quote=True)


class Markup(str):
    """Text that is HTML already. All other text is escaped where it enters a table or a paragraph."""


def markup(value):
    return value if isinstance(value, Markup) else Markup(text(value))


def shown(value, digits=5):
    """A number of results.json as it is printed: five significant digits, a proper minus sign."""
    if value is None or (isinstance(value, float) and not math.isfinite(value)):
        return MISSING
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, int):
        return f"{value:,}".replace("-", "−")
    if isinstance(value, float):
        whole = value.is_integer()
        return (f"{value:.0f}" if whole and abs(value) < 1e7 else f"{value:.{digits}g}").replace("-", "−")
    return str(value)


def entry_at(results, path):
    """What results.json has at a path, a tuple of keys and indices; None where there is nothing."""
    for key in path:
        if isinstance(results, list) and isinstance(key, int) and -len(results) <= key < len(results):
            results = results[key]
        elif isinstance(results, dict) and key in results:
            results = results[key]
        else:
            return None
    return results


def entry(results, *path, digits=5, scale=0):
    """A number with the path of its entry, by which a test compares the two. A vector becomes its components.

    What is smaller than ROUNDING times the scale (of a vector at least its largest component) is shown as about zero."""
    value = entry_at(results, path)
    if isinstance(value, list):
        if not value:
            return Markup('<span class="missing">none</span>')
        scale = max([scale] + [abs(one) for one in value if isinstance(one, (int, float))])
        parts = [entry(results, *path, i, digits=digits, scale=scale) for i in range(len(value))]
        return Markup('<span class="vector">(' + "; ".join(parts) + ")</span>")
    name = f'data-entry="{text(json.dumps(path))}"'
    if value is None:
        return Markup(f'<span class="missing" {name}>{MISSING}</span>')
    if isinstance(value, float) and 0 < abs(value) <= ROUNDING * scale:
        return Markup(f'<span {name} data-scale="{scale!r}" title="{text(value)}">≈ 0</span>')
    return Markup(f'<span {name} title="{text(value)}">{text(shown(value, digits))}</span>')


def table(head, rows, caption=""):
    """The first cell of each row is its name. The table scrolls in a box of its own where the screen is narrow."""
    if not rows:
        return Markup("")
    parts = ['<div class="scroll"><table>']
    if caption:
        parts.append(f"<caption>{markup(caption)}</caption>")
    if head:
        parts.append("<thead><tr>" + "".join(f'<th scope="col">{markup(cell)}</th>' for cell in head) + "</tr></thead>")
    parts.append("<tbody>")
    for name, *cells in rows:
        parts.append(f'<tr><th scope="row">{markup(name)}</th>' + "".join(f"<td>{markup(cell)}</td>" for cell in cells) + "</tr>")
    parts.append("</tbody></table></div>")
    return Markup("".join(parts))


def paragraph(words, kind=""):
    attribute = f' class="{kind}"' if kind else ""
    return Markup(f"<p{attribute}>{markup(words)}</p>")


def section(identifier, title, *parts):
    """A section with a heading, or nothing where it has no contents."""
    contents = "".join(markup(part) for part in parts if part)
    if not contents:
        return Markup("")
    return Markup(f'<section id="{identifier}"><h2>{text(title)}</h2>{contents}</section>')


def joined(*parts):
    return Markup("".join(markup(part) for part in parts if part))


def list_of(words):
    return Markup("<ul>" + "".join(f"<li>{markup(word)}</li>" for word in words) + "</ul>") if words else Markup("")


def data(identifier, value):
    """JSON for the script of the page. No text in it can end the element."""
    written = json.dumps(value, separators=(",", ":"), allow_nan=False).replace("<", "\\u003c")
    return Markup(f'<script type="application/json" id="{identifier}">{written}</script>')


def page(title, sections, library):
    """The whole file. `library` is the text of a script, or nothing."""
    names = re.findall(r'<section id="([^"]+)"><h2>(.*?)</h2>', "".join(sections))
    contents = Markup(
        '<nav aria-label="contents">' + " ".join(f'<a href="#{name}">{words}</a>' for name, words in names) + "</nav>"
    )
    frame = (FILES / "page.html").read_text()
    scripts = ""
    if library:
        scripts = f"<script>{library}</script>\n<script>{(FILES / 'page.js').read_text()}</script>"
    # One pass over the frame, so that nothing in the contents is taken for a place of the frame.
    values = {
        "MARK": MARK,
        "TITLE": text(title),
        "STYLE": (FILES / "page.css").read_text(),
        "CONTENTS": contents,
        "SECTIONS": "\n".join(sections),
        "SCRIPTS": scripts,
    }
    pieces = frame.split("@@")
    pieces[1::2] = [values[name] for name in pieces[1::2]]
    return "".join(pieces)
