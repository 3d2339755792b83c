"""GetFEM as peers.py asks for it: getfem_run.py in a process of its own, by a Python that has GetFEM."""
import json
import os
import pathlib
import subprocess
import sys

import pressure

HERE = pathlib.Path(__file__).resolve().parent


class GetFEM:
    name = "GetFEM5.4.2"
    forms = {"ALM-Q1/Q1": (1, "contact", "linear/Q1"), "ALM-Q2/Q2": (2, "contact", "linear/Q2"), "linear/Q1": (1, "linear", ""), "linear/Q2": (2, "linear", "")}
    lot = {"H2": {"ALM-Q1/Q1": (20, 40, 80), "ALM-Q2/Q2": (10, 20, 40)}, "CM": {"ALM-Q1/Q1": (20, 40, 80), "ALM-Q2/Q2": (20,)},
           "HA": {"ALM-Q1/Q1": (20, 40, 80, 160), "ALM-Q2/Q2": (20, 80)}, "H3": {"ALM-Q1/Q1": (8, 16)},
           "PI": {"ALM-Q1/Q1": (20, 40, 80), "ALM-Q2/Q2": (10, 20, 40)}}

    def __init__(self):
        self.python = ""
        for python in sys.executable, "/usr/bin/python3":
            if not self.python and os.path.exists(python) and subprocess.run([python, "-c", "import getfem"], capture_output=True).returncode == 0:
                self.python = python

    def missing(self):
        return "" if self.python else "python3-getfem is not installed"

    def run(self, case, formulation, N, folder, measured):
        degree, kind, _ = self.forms[formulation]
        row = measured([self.python, str(HERE / "getfem_run.py"), case.name, str(N), str(degree), kind, os.path.join(folder, "answer.json")])
        with open(os.path.join(folder, "answer.json"), encoding="utf-8") as file:
            answer = json.load(file)
        row["dofs"], row["iterations"] = answer["dofs"], answer["iterations"] if kind == "contact" else "1"
        if kind == "contact":
            row["error"] = pressure.error(case, answer["samples"])
        return row
