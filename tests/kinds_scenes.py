"""The scenes of kinds.py: shipped ones, made smaller, and own ones."""
import os

import scene_text

PARAMETERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "parameters")

UNITS = ((1e-6, 1e12), (1e6, 1e-12), (1e-3, 1.0), (1.0, 1e6))
Z, XYZ = (0, 0, 1), (1, 1, 1)
TURNS = ((Z, 90), (Z, 33), (Z, -145))
TURNS_3D = ((XYZ, 120), ((1, 2, -0.5), 77), ((-1, 0.3, 0.2), 161))
TURNINGS = ((Z, 33), (Z, -145))
TURNINGS_3D = ((XYZ, 40), ((1, 2, -0.5), 77))

ONE_MESH = {"Refinement/Cycles": "0"}
SCENES = {name: (name + ".prm", dict(ONE_MESH)) for name in (
    "capstan", "cattaneo_mindlin", "crossed_cylinders", "floating_slab", "half_plane_box_friction", "hertz_cylinder", "hertz_sphere",
    "hertz_sphere_axisymmetric", "incline", "microslip_bar", "nafems_roller", "nafems_roller_finite", "patch_test", "patch_test_3d", "three_blocks",
    "two_spheres", "verification/bulk_tension", "verification/cap_in_seat", "verification/cattaneo_mindlin_disks", "verification/cone", "verification/cross_point", "verification/declared_gap",
    "verification/disk_above_block", "verification/disk_platen", "verification/disk_weight", "verification/floating_slab_3d", "verification/growing_interference",
    "verification/just_touching", "verification/no_contact", "verification/objectivity", "verification/oblique_touch", "verification/patch_3d_punch",
    "verification/patch_finite_turned", "verification/patch_friction", "verification/patch_hanging_nodes", "verification/patch_pressure", "verification/patch_punch", "verification/pin_in_hole",
    "verification/piston", "verification/press_finite", "verification/pulled_strip", "verification/punch_moment", "verification/rings", "verification/rubber_indentation",
    "verification/shrink_fit", "verification/shrink_fit_spheres", "verification/shrink_fit_spheres_3d", "verification/simple_shear_finite", "verification/tension",
    "verification/tied_beam", "verification/tied_patch", "verification/turned_disk", "verification/turned_obstacle", "verification/turned_platens",
    "verification/turned_rigid_body", "verification/two_cylinders", "verification/two_punches", "verification/uniaxial_finite")}


def scene(name):
    path, changes = SCENES[name]
    result = scene_text.read(os.path.join(PARAMETERS, path))
    for key, value in changes.items():
        scene_text.change(result, key, value)
    return result
