# SPDX-License-Identifier: Apache-2.0
"""The script of the library Plotly, which reports embed: found where Debian or pip install it, or installed by scripts/setup."""

import importlib.util
import os
import shutil
import subprocess
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGES = ("python3-plotly", "esbuild")
# Debian's package has the whole script here, without a minified one.
OF_DEBIAN = Path("/usr/share/python3-plotly/plotly.js")
SETUP = ROOT / "scripts" / "setup"  # not part of an installed program
HOW = ("scripts/setup --packages " if SETUP.exists() else "apt-get install ") + " ".join(PACKAGES)


def plotly_script():
    """The text of the script and, where there is none, why."""
    file = installed()
    if file is None and may_install():
        done = subprocess.run(
            [SETUP, "--packages", *PACKAGES], stdin=subprocess.DEVNULL, capture_output=True
        )
        file = installed() if done.returncode == 0 else None
    if file is None:
        return "", f"The library Plotly is not installed ({HOW} installs it)"
    script = file.read_text(encoding="utf-8")
    if not file.name.endswith(".min.js"):
        script = smaller(script)
    if "</script" in script or "<!--" in script:
        return "", f"The script of Plotly in {file} cannot be embedded"
    return script, ""


def installed():
    """That of pip is minified, hence preferred."""
    module = importlib.util.find_spec("plotly")
    folders = list(module.submodule_search_locations or []) if module else []
    files = [Path(folder) / "package_data" / "plotly.min.js" for folder in folders] + [OF_DEBIAN]
    return next((file for file in files if file.is_file()), None)


def may_install():
    """Only where nobody has to be asked for a password: a report is made at the end of a long run, where nobody waits."""
    return os.geteuid() == 0 and shutil.which("apt-get") is not None and SETUP.exists()


def smaller(script):
    """Minified by esbuild, where that is installed: half as long. The licence at its beginning stays."""
    program = shutil.which("esbuild")
    if program is None:
        return script
    options = ["--minify", "--charset=utf8", "--legal-comments=inline", "--loader=js"]
    done = subprocess.run([program, *options], input=script, capture_output=True, text=True, encoding="utf-8")
    if done.returncode or "Plotly" not in done.stdout:
        return script
    licence = script[: script.index("*/") + 2] + "\n" if script.startswith("/*") else ""
    return licence + done.stdout
