# SPDX-License-Identifier: Apache-2.0
"""Matplotlib without a screen. Importing this starts the script again with the Python of the system where that of the
path has no Matplotlib: scripts/setup installs it for the former."""

import os
import sys

try:
    import matplotlib
except ImportError:
    system = "/usr/bin/python3"
    if sys.executable == system or not os.path.exists(system):
        raise
    os.execv(system, [system, *sys.argv])

matplotlib.use("Agg")

# In each picture of a run, so that the next run in its directory knows it for one.
MADE_BY = {"Software": "Signorini scripts/plot"}
