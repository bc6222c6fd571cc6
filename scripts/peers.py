# SPDX-License-Identifier: Apache-2.0
"""Two blocks (prm/block-on-block.prm) for other programs: decks with the same node coordinates, runs, forces."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

from ladder import block_cells

YOUNG, POISSON, CLOSING = 1000.0, 0.3, 0.01


class Box:
    """Trilinear cells; numbers count from `first_node` and `first_cell`."""

    def __init__(self, n, low, high, first_node=1, first_cell=1):
        nx, ny, nz = n
        def node(i, j, k):
            return first_node + (k * (ny + 1) + j) * (nx + 1) + i
        self.nodes = [tuple(a + (b - a) * i / m for a, b, i, m in zip(low, high, (i, j, k), n))
                      for k in range(nz + 1) for j in range(ny + 1) for i in range(nx + 1)]
        self.cells = [(node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k),
                       node(i, j, k + 1), node(i + 1, j, k + 1), node(i + 1, j + 1, k + 1), node(i, j + 1, k + 1))
                      for k in range(nz) for j in range(ny) for i in range(nx)]
        self.first_node, self.first_cell = first_node, first_cell
        layer, faces = (nx + 1) * (ny + 1), nx * ny
        self.bottom_nodes = range(first_node, first_node + layer)
        self.top_nodes = range(first_node + nz * layer, first_node + (nz + 1) * layer)
        self.bottom_cells = range(first_cell, first_cell + faces)
        self.top_cells = range(first_cell + (nz - 1) * faces, first_cell + nz * faces)


def blocks(n):
    lower_cells, upper_cells = block_cells(n)
    lower = Box(lower_cells, (0, 0, 0), (1, 1, 0.5))
    upper = Box(upper_cells, (0.25, 0.25, 0.5), (0.75, 0.75, 1), len(lower.nodes) + 1, len(lower.cells) + 1)
    return lower, upper


def timed(command, folder):
    """(seconds, peak memory in MB) of the whole process; its output goes to log.txt."""
    environment = {**os.environ, "OMP_NUM_THREADS": "2", "CCX_NPROC_EQUATION_SOLVER": "2", "CCX_NPROC_STIFFNESS": "2"}
    with open(folder / "log.txt", "w") as log:
        start = time.time()
        process = subprocess.Popen(command, cwd=folder, stdout=log, stderr=subprocess.STDOUT, env=environment)
        _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise RuntimeError(f"{command[0]} failed, see {folder}/log.txt")
    return time.time() - start, usage.ru_maxrss / 1024


class CalculiX:
    """Surface-to-surface penalty with a stiffness of 1e6 (a thousand times E per length) and the iterative solver."""
    name = "CalculiX"

    @staticmethod
    def available():
        return shutil.which("ccx") is not None

    @staticmethod
    def run(n, folder):
        lower, upper = blocks(n)
        with open(folder / "job.inp", "w") as f:
            f.write("*NODE,NSET=ALL\n")
            for i, x in enumerate(lower.nodes + upper.nodes, 1):
                f.write(f"{i}," + ",".join(f"{c:.13g}" for c in x) + "\n")  # longer numbers are cut in silence
            for name, box in (("LOWER", lower), ("UPPER", upper)):
                f.write(f"*ELEMENT,TYPE=C3D8,ELSET={name}\n")
                for e, cell in enumerate(box.cells, box.first_cell):
                    f.write(f"{e}," + ",".join(map(str, cell)) + "\n")
            f.write(f"*MATERIAL,NAME=M\n*ELASTIC\n{YOUNG},{POISSON}\n")
            f.write("*SOLID SECTION,ELSET=LOWER,MATERIAL=M\n*SOLID SECTION,ELSET=UPPER,MATERIAL=M\n")
            for name, nodes in (("BASE", lower.bottom_nodes), ("PRESS", upper.top_nodes)):
                f.write(f"*NSET,NSET={name}\n" + "".join(f"{i},\n" for i in nodes))
            for name, faces, side in (("SLAVE", upper.bottom_cells, 1), ("MASTER", lower.top_cells, 2)):
                f.write(f"*SURFACE,NAME={name},TYPE=ELEMENT\n" + "".join(f"{e},S{side}\n" for e in faces))
            f.write("*SURFACE INTERACTION,NAME=C\n*SURFACE BEHAVIOR,PRESSURE-OVERCLOSURE=LINEAR\n1e6\n"
                    "*CONTACT PAIR,INTERACTION=C,TYPE=SURFACE TO SURFACE\nSLAVE,MASTER\n*BOUNDARY\nBASE,1,3\n"
                    "*STEP,INC=200\n*STATIC,SOLVER=ITERATIVE SCALING\n1.,1.\n"
                    f"*BOUNDARY\nPRESS,1,2,0.\nPRESS,3,3,{-CLOSING}\n*NODE PRINT,NSET=PRESS,TOTALS=ONLY\nRF\n*END STEP\n")
        seconds, memory = timed(["ccx", "job"], folder)
        found = re.findall(r"total force.*?for set PRESS.*?\n\s*\n?\s*\S+\s+\S+\s+(\S+)", (folder / "job.dat").read_text())
        return {"seconds": seconds, "mb": memory, "force": -float(found[-1])}


class Kratos:
    """Augmented-Lagrangian mortar contact, AMGCL."""
    name = "Kratos"
    packages = ["KratosMultiphysics", "KratosStructuralMechanicsApplication", "KratosContactStructuralMechanicsApplication",
                "KratosLinearSolversApplication"]
    python = str(Path(__file__).resolve().parent.parent / "output" / "peers" / "python" / "bin" / "python")

    @classmethod
    def available(cls):
        return Path(cls.python).exists()

    @classmethod
    def run(cls, n, folder):
        lower, upper = blocks(n)
        with open(folder / "case.mdpa", "w") as f:
            f.write("Begin ModelPartData\nEnd ModelPartData\nBegin Properties 0\nEnd Properties\nBegin Nodes\n")
            for i, x in enumerate(lower.nodes + upper.nodes, 1):
                f.write(f"{i} " + " ".join(f"{c:.15g}" for c in x) + "\n")
            f.write("End Nodes\nBegin Elements SmallDisplacementElement3D8N\n")
            for e, cell in enumerate(lower.cells + upper.cells, 1):
                f.write(f"{e} 0 " + " ".join(map(str, cell)) + "\n")
            f.write("End Elements\n")
            def part(name, nodes, elements=()):
                f.write(f"Begin SubModelPart {name}\n Begin SubModelPartNodes\n" + "".join(f"{i}\n" for i in nodes)
                        + " End SubModelPartNodes\n Begin SubModelPartElements\n" + "".join(f"{e}\n" for e in elements)
                        + " End SubModelPartElements\nEnd SubModelPart\n")
            for name, box in (("Lower", lower), ("Upper", upper)):
                part(name, range(box.first_node, box.first_node + len(box.nodes)),
                     range(box.first_cell, box.first_cell + len(box.cells)))
            part("Base", lower.bottom_nodes)
            part("Press", upper.top_nodes)
            part("Contact_Part", list(upper.bottom_nodes) + list(lower.top_nodes))
        (folder / "materials.json").write_text(json.dumps({"properties": [
            {"model_part_name": f"Structure.{name}", "properties_id": i,
             "Material": {"constitutive_law": {"name": "LinearElastic3DLaw"},
                          "Variables": {"DENSITY": 1.0, "YOUNG_MODULUS": YOUNG, "POISSON_RATIO": POISSON}, "Tables": {}}}
            for i, name in enumerate(("Lower", "Upper"), 1)]}))

        def support(name, value):
            return {"python_module": "assign_vector_variable_process", "kratos_module": "KratosMultiphysics",
                    "Parameters": {"model_part_name": f"Structure.{name}", "variable_name": "DISPLACEMENT",
                                   "constrained": [True, True, True], "value": value, "interval": [0.0, "End"]}}
        contact = {"python_module": "alm_contact_process",
                   "kratos_module": "KratosMultiphysics.ContactStructuralMechanicsApplication",
                   "Parameters": {"model_part_name": "Structure", "contact_model_part": {"0": ["Contact_Part"]},
                                  "assume_master_slave": {"0": ["Upper"]}, "contact_type": "Frictionless",
                                  "search_parameters": {"search_factor": 3.5, "type_search": "in_radius_with_obb"}}}
        solver = {"solver_type": "amgcl", "smoother_type": "ilu0", "krylov_type": "gmres",
                  "coarsening_type": "aggregation", "max_iteration": 500, "tolerance": 1e-8, "scaling": False}
        (folder / "project.json").write_text(json.dumps({
            "problem_data": {"problem_name": "case", "parallel_type": "OpenMP", "start_time": 0.0, "end_time": 1.0,
                             "echo_level": 0},
            "solver_settings": {
                "solver_type": "Static", "model_part_name": "Structure", "domain_size": 3, "analysis_type": "non_linear",
                "time_stepping": {"time_step": 1.0000001},
                "model_import_settings": {"input_type": "mdpa", "input_filename": "case"},
                "material_import_settings": {"materials_filename": "materials.json"},
                "contact_settings": {"mortar_type": "ALMContactFrictionless", "use_mixed_ulm_solver": True},
                "convergence_criterion": "contact_residual_criterion", "max_iteration": 30, "compute_reactions": True,
                "residual_relative_tolerance": 1e-6, "linear_solver_settings": solver},
            "processes": {"constraints_process_list": [support("Base", [0.0, 0.0, 0.0]),
                                                       support("Press", [0.0, 0.0, f"{-CLOSING}*t"])],
                          "contact_process_list": [contact]}, "output_processes": {}}))
        (folder / "solve.py").write_text(KRATOS_SCRIPT)
        seconds, memory = timed([cls.python, "solve.py"], folder)
        return {"seconds": seconds, "mb": memory, "force": -float((folder / "force.txt").read_text())}


KRATOS_SCRIPT = """\
import KratosMultiphysics as KM
import KratosMultiphysics.LinearSolversApplication
import KratosMultiphysics.ContactStructuralMechanicsApplication
from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import StructuralMechanicsAnalysis


class Analysis(StructuralMechanicsAnalysis):
    def Finalize(self):
        nodes = self.model["Structure.Press"].Nodes
        with open("force.txt", "w") as f:
            f.write(str(sum(node.GetSolutionStepValue(KM.REACTION_Z) for node in nodes)))
        super().Finalize()


Analysis(KM.Model(), KM.Parameters(open("project.json").read())).Run()
"""

PEERS = (CalculiX, Kratos)


def install():
    """Needs the rights to install packages. What cannot be installed is left out."""
    for command in (["apt-get", "install", "-y", "--no-install-recommends", "calculix-ccx", "python3-venv"],
                    [sys.executable, "-m", "venv", str(Path(Kratos.python).parent.parent)],
                    [Kratos.python, "-m", "pip", "install", "--quiet", *Kratos.packages]):
        print(" ".join(command), flush=True)
        if subprocess.run(command, stdout=subprocess.DEVNULL).returncode != 0:
            print("  failed")
