#!/usr/bin/env python3
"""Do the packages work? package.py BUILD_DIR deb|example, in this order.

deb: makes both .deb of BUILD_DIR (cpack), looks at what they demand and hold, unpacks them (dpkg -x) under BUILD_DIR/tests/package/root, and runs the
unpacked program from another folder: a mesh file and a built-in mesh, against what the program of BUILD_DIR says. example: builds doc/example_library against
the unpacked library and runs it. Nothing is left out: what is not installed here is a failure that names the package.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent
# Of no session's, of no other test's; Open MPI without its daemon.
ENVIRONMENT = {**os.environ, "OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self"}
QUIET = ["--quiet", "--set", "Output/VTU = false", "--set", "Output/Report = false"]


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, env=ENVIRONMENT, **options)
    if done.returncode:
        sys.exit(f"{' '.join(map(str, command))} ended with {done.returncode}:\n{done.stdout[-3000:]}{done.stderr[-3000:]}")
    return done.stdout


def need(condition, what):
    if not condition:
        sys.exit(f"wrong: {what}")
    print(f"holds: {what}")


def cached(build, name):
    return re.search(rf"^{name}:\w+=(.*)$", (build / "CMakeCache.txt").read_text(), re.M).group(1)


def make(build, folder):
    for program, package in (("cpack", "cmake"), ("dpkg-shlibdeps", "dpkg-dev"), ("file", "file"), ("dpkg", "dpkg")):
        if not shutil.which(program):
            sys.exit(f"{program} is missing: ./setup.sh {package}")
    run("cpack", "-G", "DEB", "-B", folder, cwd=build)
    shutil.rmtree(folder / "_CPack_Packages")
    return {deb.name.split("_")[0]: deb for deb in sorted(folder.glob("*.deb"))}


def check_fields(build, debs):
    need(sorted(debs) == ["amontons", "libamontons-dev"], "two packages: " + ", ".join(deb.name for deb in debs.values()))
    fields = {name: dict(re.findall(r"^([\w-]+): (.*)$", run("dpkg-deb", "-f", deb), re.M)) for name, deb in debs.items()}
    program, library = fields["amontons"], fields["libamontons-dev"]
    avx2 = cached(build, "AMONTONS_AVX2") == "ON"
    need(program["Version"].endswith("+avx2") == avx2, f"the version {program['Version']} says whether AVX2 is needed")
    needed = ("needs a processor with AVX2" if avx2 else "runs on every processor")
    need(needed in run("dpkg-deb", "-f", debs["amontons"], "Description"), f"so does the description: '{needed}'")
    need(program["Section"] == "science" and "maintainers of Amontons" in program["Maintainer"], "section and maintainer")
    need(all(f" {name}" in " " + program["Depends"] for name in ("libdeal.ii-9.4", "libopenmpi3", "libtrilinos", "libc6 (>=")),
         f"dpkg-shlibdeps found {len(program['Depends'].split(','))} packages that the program needs")
    need("gmsh" in program["Recommends"] and "gnuplot" in program["Recommends"], "gmsh and gnuplot are recommended")
    need(f"amontons (= {program['Version']})" in library["Depends"] and "libdeal.ii-dev" in library["Depends"],
         "the library goes with its program and deal.II")


def check_files(build, root):
    files = {str(path.relative_to(root / "usr")) for path in root.rglob("*") if path.is_file()}
    for folder, installed in (("parameters", "share/amontons/parameters"), ("include/amontons", "include/amontons")):
        here = {f"{installed}/{path.relative_to(SOURCE / folder)}" for path in (SOURCE / folder).rglob("*") if path.is_file()}
        need(here <= files, f"all {len(here)} files of {folder} are in {installed}")
    for page in ("README.md", "LICENSE", "AUTHORS", "CITATION.cff", "copyright", "doc/introduction.md"):
        need(f"share/doc/amontons/{page}" in files, f"{page} is there")
    print(run("python3", SOURCE / "tests/check_links.py", root / "usr/share/doc/amontons").strip() + " in the installed pages")
    for path in root.rglob("*.cmake"):
        for folder in (SOURCE, build):
            need(f"{folder}/" not in path.read_text(), f"{path.name} does not name {folder.name}/")


def answer(program, scene, folder):
    """summary.json without what depends on time and place."""
    run(program, scene, "--output", folder, *QUIET, cwd=folder.parent)
    summary = json.loads((folder / "summary.json").read_text())
    return {name: summary[name] for name in ("status", "dofs", "newton", "pairs", "checks") if name in summary}


def deb(build, folder):
    shutil.rmtree(folder, ignore_errors=True)
    elsewhere, root = folder / "elsewhere", folder / "root"
    elsewhere.mkdir(parents=True)
    debs = make(build, folder)
    check_fields(build, debs)
    for package in debs.values():
        run("dpkg", "-x", package, root)
    check_files(build, root)
    program = root / "usr/bin/amontons"
    need(run(program, "--version", cwd=elsewhere).startswith("amontons " + cached(build, "CMAKE_PROJECT_VERSION")), "the program knows its version")
    for scene in ("patch_test.prm", "verification/patch_3d_irregular.prm"):
        now = answer(program, root / "usr/share/amontons/parameters" / scene, elsewhere / "installed")
        then = answer(build / "amontons", SOURCE / "parameters" / scene, elsewhere / "built")
        need(now["status"] == "converged" and now == then, f"{scene}: converged, as before it was packed")


def example(build, folder):
    root = folder / "root"
    installed = root / "usr/share/doc/amontons/doc/example_library"
    shutil.rmtree(folder / "example", ignore_errors=True)
    run("cmake", "-S", installed, "-B", folder / "example", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={root}/usr", "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON")
    command = json.loads((folder / "example/compile_commands.json").read_text())[0]["command"]
    need(("-march=x86-64-v3" in command) == (cached(build, "AMONTONS_AVX2") == "ON"), "the example is compiled for the processors of the library")
    need("-DNDEBUG" in command and "-DBOOST_NO_AUTO_PTR" in command, "and with the definitions of deal.II")
    run("cmake", "--build", folder / "example")
    force = run(folder / "example/contact_force", root / "usr/share/amontons/parameters/patch_test.prm", cwd=folder / "elsewhere").strip()
    pair = answer(root / "usr/bin/amontons", root / "usr/share/amontons/parameters/patch_test.prm", folder / "elsewhere/program")["pairs"][0]
    numbers = [float(word) for word in force.split(":")[1].split(",")]
    need(all(abs(a - b) < 1e-5 for a, b in zip(numbers, pair["normal_force"])), f"the example prints the program's force: {force}")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    {"deb": deb, "example": example}[sys.argv[2]](build, build / "tests/package")


if __name__ == "__main__":
    main()
