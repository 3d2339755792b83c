#!/usr/bin/env python3
"""At small loads, finite strain gives what small strain gives: small_and_finite.py AMONTONS OUTPUT SCENE "Section/Name=text with %g" LOADS [--set X]...

Runs the scene with both kinematics at each of LOADS (a list that falls by the factor f). The relative differences of contact size, peak pressure, force and
first probe's displacement must fall by f with the strain, to within 30 %, from the second load on (the first may be large), and stay below STRAIN there.
"""
import json
import math
import os
import sys

import launch

STRAIN = 0.02


def answer(executable, output, scene, sets):
    command = [executable, scene, "--output", output, "--quiet", "--set", "Output/VTU=false", "--set", "Output/Report=false"]
    for text in sets:
        command += ["--set", text.replace("|", ";")]
    code = launch.run(command, timeout=1200).returncode
    if code != 0:
        sys.exit(f"{' '.join(command)}: exit code {code}")
    with open(os.path.join(output, "summary.json")) as file:
        summary = json.load(file)
    pair = summary["pairs"][0]
    result = {"contact size": pair["contact_size"], "peak pressure": pair["peak_pressure"], "force": math.hypot(*pair["normal_force"])}
    if summary["probes"]:
        result["displacement"] = math.hypot(*summary["probes"][0]["points"][0]["displacement"])
    return result


def main():
    executable, output, scene, load, levels = sys.argv[1:6]
    sets, levels = sys.argv[7::2], [float(v) for v in levels.split(",")]
    differences = []
    for level in levels:
        small, finite = (answer(executable, output, scene, sets + [load % level, "Kinematics=" + k]) for k in ("small strain", "finite strain"))
        differences.append({name: abs(finite[name] / small[name] - 1) for name in small})
        print(f"load {level:g}: " + ", ".join(f"{name} {value:.2e}" for name, value in differences[-1].items()))
    failed = 0
    factor = levels[1] / levels[2]
    for name in differences[0]:
        d = [entry[name] for entry in differences]
        good = d[1] <= STRAIN and d[2] <= 1.3 * d[1] / factor
        print(f"{'ok    ' if good else 'FAILED'} {name}")
        failed += not good
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
