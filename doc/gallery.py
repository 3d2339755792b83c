#!/usr/bin/env python3
"""Makes doc/gallery.md and its pictures: gallery.py AMONTONS [--keep FOLDER] [--only SCENE]

Runs every scene of parameters/ but the studies, one after the other, each for 60 s at most (all of them: 6 minutes), and takes a picture of each from its report. What a scene shows
is its title and the first sentence of its file. A scene that is new here belongs in a group of GROUPS; tests/check_gallery.py sees to that. FOLDER keeps the runs: begun
anew, it goes on from there. --only makes the picture of one scene, and leaves the page.
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from report_pictures import ROOT, pictures, slim

PAGE, FOLDER, LIMIT, SIZE = ROOT / "doc/gallery.md", ROOT / "doc/pictures/gallery", 60, 320

ROOM = 30 * "\u00a0"  # else pictures become as narrow as they can

GROUPS = [
    ("Hertz and other closed forms", "hertz_cylinder hertz_sphere_axisymmetric half_plane_box verification/half_space_box_axisymmetric verification/two_cylinders verification/cone "
     "verification/flat_punch_line verification/flat_punch_axisymmetric verification/punch_moment verification/pin_in_hole verification/pin_in_quarter_hole verification/rings verification/turned_rings "
     "verification/shrink_fit verification/shrink_fit_spheres verification/three_shrunk_rings verification/column_of_disks verification/growing_interference verification/cap_in_seat verification/disk_platen verification/disk_above_block "
     "verification/disk_weight verification/quarter_cylinder verification/two_equal_disks verification/receding_layer verification/ring_contact verification/three_point_bending verification/beam_on_floor verification/leaf_spring verification/rough_leaves verification/two_leaves verification/rubber_bush"),
    ("Friction", "half_plane_box_friction cattaneo_mindlin verification/cattaneo_mindlin_disks verification/sheared_half_disk verification/striped_floor verification/held_on_incline verification/tilted_block verification/bulk_tension microslip_bar capstan greco walk/pin_in_lug small_scene "
     "verification/klarbring verification/patch_friction verification/equal_blocks verification/clamped verification/tee verification/oblique_touch verification/opened_again verification/large_increment verification/wedge_self_lock verification/small_shear verification/keyway verification/pulled_from_jaws verification/pressed_and_sheared verification/dovetail"),
    ("Held by contact and friction alone", "floating_slab incline verification/leaning_weight verification/steep_slope verification/tipping verification/tipping_tower "
     "verification/far_gap verification/floating_slab_3d verification/tipping_3d verification/plate_on_three_balls verification/pin_longer_than_its_seat"),
    ("Finite strain", "ironing verification/followed_slide wall_buckling snap_away nafems_roller_finite verification/rubber_indentation verification/passing_disks verification/fluid_pressure verification/tube_in_bore verification/compressed_rubber verification/compressed_block_3d verification/o_ring verification/o_ring_half verification/ring_in_groove verification/thin_ring "
     "verification/press_finite verification/slide_off_edge verification/slide_over_edges verification/slid_block verification/ring_rolls verification/corner_on_corner verification/turned_disk "
     "verification/objectivity verification/turned_blocks verification/turned_rigid_body verification/turned_obstacle verification/turned_platens verification/turned_with_friction verification/ring_in_turned_bore verification/patch_finite "
     "verification/patch_finite_3d verification/patch_finite_turned verification/patch_finite_turned_3d verification/uniaxial_finite verification/simple_shear_finite "
     "verification/pulled_strip verification/punch_small_and_finite verification/deep_punch verification/punch_with_flanks verification/column_with_stop verification/squeezed_rod verification/sliding_pad verification/snap_hook verification/turning_shaft verification/torque_beyond_friction"),
    ("In space", "half_space_box hertz_sphere two_spheres crossed_cylinders mindlin_sphere ironing_3d walk/pin_in_lug_3d sphere_on_block_scaling verification/three_spheres "
     "verification/oblique_drag verification/lifted_off verification/round_punch_3d verification/patch_friction_3d verification/shrink_fit_spheres_3d verification/cap_in_seat_3d"),
    ("Surfaces of CAD, meshes of gmsh", "step_file verification/shaft_and_hub verification/polygon_roller verification/curve_in_steps verification/patch_3d_irregular verification/patch_3d_step"),
    ("Benchmarks, and scenes of other programs", "nafems_roller nafems_roller_friction nafems_punch nafems_punch_friction verification/peers_cylinder verification/peers_shear "
     "verification/peers_sphere verification/peers_sphere_3d"),
    ("Patch tests and stacks", "patch_test patch_test_3d three_blocks three_blocks_3d verification/patch_pressure verification/patch_confined verification/patch_hanging_nodes "
     "verification/patch_punch verification/two_punches verification/guided_block verification/stepped_punch verification/three_contacts verification/overtaken verification/pressed_by_two verification/split_slave verification/split_slave_3d verification/cross_point verification/declared_gap verification/punch_by_gap verification/patch_3d_pressure "
     "verification/patch_3d_punch verification/patch_3d_hanging_nodes"),
    ("Tied bodies", "verification/tied_patch verification/tied_patch_3d verification/tied_beam verification/beam_in_one_piece verification/tied_column verification/tied_bracket verification/tied_beside_contact"),
    ("Unusual input", "verification/no_contact verification/just_touching verification/tension verification/stiff_punch verification/gap_closes_on_incompressible verification/piston verification/narrow_load verification/thin_wire verification/edge_beyond_nodes verification/wavy_gap verification/two_loads verification/beam_on_stop verification/corner_on_plane verification/corner_tip verification/small_stamp verification/edge_on_plate_3d "
     "verification/cone_just_touching verification/touched_elsewhere verification/light_second_circle verification/second_bump verification/narrow_ridge verification/corner_between_nodes verification/tilting_punch verification/loosened_clamp verification/sticking_middle verification/pressed_and_lifted verification/twisted_ball verification/round_column verification/twisted_columns verification/half_strut verification/short_roller verification/tilted_corner verification/coated_block verification/touched_at_the_axis verification/rider verification/v_joint verification/disk_in_groove verification/disk_squeezed verification/stack_without_friction verification/ball_between_planes verification/half_ring_below_lid verification/friction_band verification/displaced_bump verification/growing_stick verification/growing_stick_3d verification/receding_layer_rough verification/tied_and_turned verification/tied_shear verification/light_beside_heavy verification/two_indenters verification/hertz_on_cantilever verification/round_punch verification/ball_in_hollow verification/shaft_in_longer_hub verification/roller_bearing verification/ring_between_walls verification/band_on_drum verification/disk_in_cradle verification/light_disk verification/pad_below_beam verification/beam_on_rollers verification/rolled_disk verification/flat_cell verification/heavy_and_light verification/swept_strip verification/floor_below_beam"),
]

# Where the bodies as a whole (in space: the pressure on the first surface) are not what is to be seen: the title of the picture; entries of a run for the picture.
AROUND, COARSE = ("Around the contact",), ("Deformed mesh", "Refinement/Cycles=1")
PICTURES = {name: AROUND for name in (
    "hertz_cylinder hertz_sphere_axisymmetric half_plane_box cattaneo_mindlin ironing nafems_roller_finite walk/pin_in_lug verification/bulk_tension verification/cone "
    "verification/peers_cylinder verification/peers_shear verification/peers_sphere verification/pin_in_hole verification/stepped_punch verification/thin_wire verification/sliding_pad verification/sticking_middle verification/curve_in_steps").split()}
PICTURES |= {name: ("Contact pressure",) for name in ("verification/hertz_on_cantilever", "verification/flat_punch_axisymmetric", "verification/flat_punch_line", "verification/punch_moment", "verification/tied_patch_3d")}
PICTURES |= {
    "greco": ("Shear traction",), "verification/pulled_from_jaws": ("Shear traction",), "microslip_bar": ("Hysteresis", "Increments=30"), "nafems_roller_friction": ("Shear traction",), "nafems_punch_friction": ("Shear traction",),
    "mindlin_sphere": ("States",), "verification/compressed_block_3d": ("Bodies",), "verification/split_slave_3d": ("Bodies",), "verification/oblique_drag": ("States",), "verification/turned_platens": ("Where the work goes",),
    "verification/rings": COARSE, "verification/wavy_gap": ("Contact pressure",), "verification/turned_rings": COARSE, "verification/peers_sphere_3d": ("Pressure on the surface", "Refinement/Cycles=3"),
    "verification/slide_off_edge": ("Deformed mesh", "End time=1.4"), "verification/slide_over_edges": ("Deformed mesh", "End time=0.3", "Increments=18"),
    "verification/roller_bearing": ("Deformed mesh", "Refinement/Target error=0", "Refinement/Cycles=0"),
    "verification/three_contacts": ("Deformed mesh", "Refinement/Cycles=12"),
    "verification/beam_on_rollers": ("Deformed mesh", "Refinement/Cycles=10"),
    "verification/opened_again": ("Deformed mesh", "End time=1"), "verification/lifted_off": ("States", "End time=1"),
}

HEAD = f"""# Gallery

All scenes that come with the program, but for [studies](studies.md). Made by

    python3 doc/gallery.py build/amontons

A name leads to the file; `build/amontons parameters/NAME.prm` runs it. Pictures are those of `report.html`: von Mises stress in the deformed bodies, whole or around the contact; in space the pressure on
the slave surface, seen along its normal; charts where they show more. Unknowns (DoFs) are those of the last mesh. Seconds are of the clock, without the start of the program (0.3 s), on a machine with two cores,
one run at a time; each run is stopped after {LIMIT} s. An arrow leads to what the program says where it does not say "converged"; some scenes are there to be refused.
"""


def first_sentence(comment):
    """A short one with the next."""
    parts = re.split(r"(?<=[^A-Z][.?!])(?<!St\.)\s+", comment)
    return " ".join(parts[: 2 if len(parts[0]) < 50 else 1])


def described(scene):
    """The title, and the first sentence of the comment that the file begins with."""
    text = (ROOT / "parameters" / f"{scene}.prm").read_text(encoding="utf-8")
    comment = " ".join(line.lstrip("# ") for line in re.match(r"(?:#.*\n)*", text).group(0).splitlines())
    title = re.search(r"^\s*set Title\s*=\s*(.*?)\s*(?:#.*)?$", text, re.M)
    if not comment or not title:
        sys.exit(f"parameters/{scene}.prm: say in 'Title' and in a comment at the top what it shows")
    sentence, head = first_sentence(comment), re.match(r"([^:]+): +", comment)
    if head and title.group(1).startswith(head.group(1)):  # no need to say it twice
        sentence = sentence[head.end()].upper() + sentence[head.end() + 1:]
    return title.group(1), sentence


def for_table(text):
    """Names of scenes are code; what would end a cell looks like it."""
    return re.sub(r"\b(\w+\.prm)\b", r"`\1`", " ".join(text.split())).replace("|", "\u2223")


def rounded(seconds):
    return f"{seconds:.0f}" if seconds > 9.5 else f"{seconds:.1f}" if seconds > 0.95 else f"{max(seconds, 0.01):.2f}"


def run(program, scene, folder, *entries):
    """Unless that was done before."""
    if not (folder / "report.html").exists():
        folder.mkdir(parents=True, exist_ok=True)
        command = [program, f"parameters/{scene}.prm", "--time-limit", f"{LIMIT}s", "--quiet", "--output", str(folder)]
        for entry in ("Output/VTU=false", "Output/Report=true", *entries):
            command += ["--set", entry]
        subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=20 * LIMIT, check=False)
    return json.loads((folder / "summary.json").read_text())


def name_of(scene):
    """Of its picture: no two of doc/pictures have one name, as doxygen puts all in one folder."""
    return "scene_" + scene.split("/")[-1] + ".svg"


def make_picture(program, scene, runs):
    """Writes the picture and returns the summary of the run as it is shipped."""
    summary = run(program, scene, runs / scene)
    title, *entries = PICTURES.get(scene, ("Pressure on the surface" if summary["dimension"] == 3 else "Deformed mesh",))
    report = runs / scene / "report.html"
    if entries:
        run(program, scene, runs / "picture" / scene, *entries)
        report = runs / "picture" / scene / "report.html"
    found = pictures(report)
    svg = next((svg for name, svg in found.items() if name.startswith(title)), None)
    if svg is None:
        sys.exit(f"{scene}: no picture '{title}', but {', '.join(found)}")
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / name_of(scene)).write_text(slim(svg, SIZE), encoding="utf-8")
    return summary


def row(scene, summary):
    title, sentence = described(scene)
    if summary["status"] != "converged":
        said = summary["message"]
        sentence += " → " + re.split(r"; (?:'amontons|say )", said)[0] + "."
    picture = f"![{title}](pictures/gallery/{name_of(scene)})"
    return f"| {picture} | [`{scene}`](../parameters/{scene}.prm) **{title}.** {for_table(sentence)} | {summary['dofs']:,} | {rounded(summary['wall_seconds'])} |"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=lambda path: str(pathlib.Path(path).resolve()))
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--only")
    options = parser.parse_args()
    grouped = [name for _, names in GROUPS for name in names.split()]
    shipped = [str(path.relative_to(ROOT / "parameters"))[:-4] for path in (ROOT / "parameters").rglob("*.prm") if path.parent.name != "studies"]
    if set(grouped) != set(shipped) or len(grouped) != len(set(grouped)):
        sys.exit("GROUPS and parameters/ differ (or a scene is there twice): " + " ".join(sorted(set(grouped) ^ set(shipped))))
    with tempfile.TemporaryDirectory(prefix="amontons-gallery-") as temporary:
        runs = (options.keep or pathlib.Path(temporary)).resolve()
        if options.only:
            make_picture(options.program, options.only, runs)
            return
        text = HEAD
        for heading, names in GROUPS:
            text += f"\n## {heading}\n\n| {ROOM}picture{ROOM} | scene | DoFs | seconds |\n|---|---|---|---|\n"
            for scene in names.split():
                text += row(scene, make_picture(options.program, scene, runs)) + "\n"
                print(scene, flush=True)
    PAGE.write_text(text, encoding="utf-8")
    for old in FOLDER.glob("*.svg"):
        if old.name not in map(name_of, grouped):
            old.unlink()


if __name__ == "__main__":
    main()
