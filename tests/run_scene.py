"""What the study scripts share: run the program on a scene, read its results file."""

import json
import os
import shutil
import subprocess
import sys


def add_arguments(parser):
    parser.add_argument("scene")
    parser.add_argument("--executable", default="signorini", help="the program")
    parser.add_argument("--mpiexec", default="mpirun")
    parser.add_argument("--directory", default="output", help="where the results of the runs go")
    parser.add_argument("--set", action="append", default=[], metavar="SECTION/KEY=VALUE", help="for all runs")


class Runner:
    """Runs of one scene, each in a folder of its own."""

    def __init__(self, arguments):
        self.arguments = arguments
        self.count = 0
        self.last_folder = None

    def results(self, overrides=(), ranks=1, scene=None):
        """The results file of a run; ends the script if the program does not converge.

        Exit code 4, a missed expected result, is no failure here: a coarse mesh may miss it.
        """
        self.count += 1
        folder = os.path.join(self.arguments.directory, str(self.count))
        self.last_folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(os.path.dirname(folder) or ".", exist_ok=True)
        command = [self.arguments.mpiexec, "-n", str(ranks)] if ranks > 1 else []
        command += [self.arguments.executable, scene or self.arguments.scene]
        for one in [*self.arguments.set, *overrides, "Output/VTU=no", "Output/Directory=" + folder]:
            command += ["--set", one]
        run = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if run.returncode not in (0, 4):
            print(run.stdout)
            sys.exit(f"exit code {run.returncode} of: " + " ".join(command))
        with open(os.path.join(folder, "results.json")) as file:
            return json.load(file)


def number(results, path):
    """The number at a path with slashes, of the last load step or of the whole file, as in `Expected results`."""
    for place in (results["load_steps"][-1], results):
        for part in path.split("/"):
            if isinstance(place, list) and part.isdigit() and int(part) < len(place):
                place = place[int(part)]
            elif isinstance(place, dict) and part in place:
                place = place[part]
            else:
                break
        else:
            return float(place)
    sys.exit(f"there is no number '{path}' in the results file")
