#!/usr/bin/env python3
"""Do the tests see small changes of the source? mutation.py [--lot N] [--seed S] [--nets N] [--scratch DIR] [-j N] [--only NUMBER|NAME,...] [--unchecked] [--list]

Tries the changes below, one at a time: replaces the text in a copy of this tree, builds what the change's tests need, runs them until one fails, and says
which. A change that no test notices is a test to write. By hand; not part of ctest.

--lot:     instead of those below, so many that are drawn by lot from all of the source (mutation_lot.py); what does not compile is drawn again. All of ctest is
           thrown after a change, in nets: what sees the most first. --seed: of the lot (default 1); --nets: the first so many nets only.
--scratch: the copy, with its own build folder (default: amontons-mutation in the folder of temporary files). It is kept, so that the next run builds less.
           Files that differ are copied anew each time; the working tree is never touched.
-j:        jobs of ninja, and tests at a time (default 2).
--only:    some of the changes, by number (3, 7-9) or part of the name.
--unchecked: do not run the tests without any change first.
--list:    say what would be tried.
"""
import argparse
import concurrent.futures
import contextlib
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

import mutation_lot

TREE = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
# For one process, since a changed loop may not end: of the processor, whatever else runs on this machine, and of the clock, where it waits for ever.
SECONDS, PATIENCE = 300, 3000
MEMORY = 8 << 30
LATE = re.compile(rf"-{int(signal.SIGXCPU)}\b|signal {int(signal.SIGXCPU)}\b")  # how tests tell of a program that has used up its seconds

# Tests that much of the code stands behind: cheap scenes, each with closed forms.
PLANE = "scenes/(patch_q2_first_10_to_1|patch_q1_second_hanging_nodes|patch_q2_first_punch|two_punches_q1|tied_patch|disk_platen|half_plane_box)$"
FRICTION = "scenes/(patch_friction_q1_first_slips|patch_friction_3d_q1_second_slips|microslip_bar_q1|cattaneo_mindlin_75|floating_slab_mu_0.2|transfer_microslip_bar)$"
FINITE = "scenes/(patch_finite_q1_second_turned|patch_finite_q2_second_turned_sticking|objectivity_q1_second|simple_shear_.*|oblique_touch|slide_off_edge_first|slide_off_edge_friction_first)$"
RANKS = "scenes/(ranks_.*|tied_patch)$"
READ = "scenes/(sphere_2a|tied_patch|microslip_bar_q1|patch_friction_3d_q1_first_slips|transfer_microslip_bar|patch_finite_q2_second_turned_sticking)$"

# name, file in source/, text (exactly once in the file), what stands there instead, tests that should see it
CHANGES = [
    # ---- once unnoticed
    ("mean gaps of one rank only", "contact/mortar_integrator.cc", "        trace_gap += other.trace_gap;\n", "", RANKS),
    ("half a face is whole", "contact/covered_shares.cc", "covered_area > 0.999 * face_area", "covered_area > 0.5 * face_area", "^contact/mortar$"),
    ("all at once before the start", "scene/expression.cc", "std::max(0., 1 + t / growth)", "1.", "scenes/loads_at_start"),
    ("committed state not transferred", "load_history.cc", "&known->committed,", "", "scenes/transfer_.*"),
    ("von Mises' shear", "elasticity/linear_elastic.cc", "3 * shear);", "2 * shear);", "^elasticity/linear_elastic$"),
    ("sign of moments", "../include/amontons/output/nodal_forces.h", "c == 0 ? -X[1] * force", "c == 0 ? X[1] * force", "scenes/tied_beam"),
    ("current position", "output/contact_csv.cc", "nodes[i].X + fields.displacement[i], node.x", "nodes[i].X, node.x", "^output/contact_csv$"),
    ("stick and slip in the history", "output/history.cc", '".n_stick", pair.n_stick', '".n_stick", pair.n_slip', "^output/history$"),
    ("slip in contact.vtu", "output/contact_vtu.cc", "arrays.slip += vector(fields.slip[i]);", "arrays.slip += vector(fields.traction[i]);", "^output/contact_csv$"),
    ("percent", "output/answer.cc", "short_number(100 * fraction)", "short_number(fraction)", "^output/terminal$"),
    ("shifted radius", "scene/body_reader.cc", "body.lower[0] + body.shift[0] < 0", "body.lower[0] < 0", "^scene/wrong_scenes$"),
    ("open nodes beside steps", "contact/mortar_integrator.cc", "row.gap = std::max(row.gap, sums.smallest_gap);", ";", "^contact/mortar$"),
    ("slope of mu(p) p", "friction/shear_law.cc", "bound.slope = (bound_value(pair, X, t, p + step) - bound_value(pair, X, t, std::max(0., p - step))) /\n                  (step + std::min(p, step));", "bound.slope = bound.value / std::max(p, step);", "^friction/shear_law$"),
    # ---- scene
    ("tables after their last time", "scene/expression.cc", "std::string text = points.back().value;", "std::string text = points.front().value;", "^scene/scene_reader$|scenes/cattaneo_mindlin_75$"),
    ("tables' slope", "scene/expression.cc", '"))/(" << b.t - a.t', '"))/(" << b.t', "^scene/scene_reader$"),
    ("Poisson's ratio of 0.5", "scene/body_reader.cc", "material.poisson >= 0.5", "material.poisson > 0.5", "^scene/wrong_scenes$"),
    ("inner radius of the outer one", "scene/body_reader.cc", "!(body.inner_radius < body.radius)", "!(body.inner_radius <= body.radius)", "^scene/wrong_scenes$|wrong_input"),
    # ---- geometry
    ("sense of rotation", "geometry/placement.cc", "std::sin(angle) * cross_product_3d(axis, v) +", "-std::sin(angle) * cross_product_3d(axis, v) +", "^geometry/grids$|" + PLANE),
    ("shift before rotation", "geometry/placement.cc", "body.rotation_centre + rotate(p - body.rotation_centre, body) + body.shift", "body.rotation_centre + rotate(p - body.rotation_centre + body.shift, body)", "^geometry/grids$"),
    ("axis of turned cylinders", "geometry/placement.cc", "shape.axis   = rotate(shape.axis, body);", ";", "^geometry/grids$|^geometry/cad_manifold$|scenes/crossed_cylinders$"),
    ("paraboloid of twice the radius", "geometry/rigid_surface.cc", "line.t0 * line.t1 + radius * line.h1", "line.t0 * line.t1 + 2 * radius * line.h1", "^geometry/rigid_surface$"),
    ("normal of hollow cylinders", "geometry/rigid_surface.cc", "(hollow ? -1. : 1.) / radius * (line.t0 + g * line.t1)", "1. / radius * (line.t0 + g * line.t1)", "^geometry/rigid_surface$"),
    ("names of groups of the wrong dimension", "geometry/gmsh.cc", "group_names[d == dim][text.integer(fields[1])]", "group_names[d == dim - 1][text.integer(fields[1])]", "^geometry/grid_reader$"),
    # ---- discretization
    ("sense of the rotation about y", "discretization/supports.cc", "{1, 1, 2, -1., 3, 0}", "{1, 1, 2, 1., 3, 0}", "^discretization/supports$"),
    ("finite rotations of obstacles", "discretization/supports.cc", "rotation_matrix_3d(Point<3>(theta / angle), angle)", "rotation_matrix_3d(Point<3>(theta / angle), -angle)", "^discretization/supports$|" + FINITE),
    ("free rotations about other points", "discretization/discretization.cc", "(X[k] - carrier.motion.reference[k]) / carrier.size", "X[k] / carrier.size", "^discretization/supports$|scenes/disk_platen$"),
    # ---- elasticity
    ("body forces per radian", "elasticity/loads.cc", "force[d] = factor * weight(on.values, q) * on.load[q][d];", "force[d] = factor * on.values.JxW(q) * on.load[q][d];", "^elasticity/loads$"),
    ("area of one rank", "elasticity/loads.cc", "return Utilities::MPI::sum(area, discretization.geometry.communicator);", "return area;", RANKS),
    ("moments about y", "elasticity/loads.cc", "add_couple(1, dim - 1, -motion.moment[1]", "add_couple(1, dim - 1, motion.moment[1]", "^elasticity/loads$"),
    ("side of covered pressure", "elasticity/loads.cc", "(face % 2 == 1 ? 1 : -1) * values.jacobian(q)", "values.jacobian(q)", "^elasticity/loads$|^elasticity/follower_pressure$|scenes/patch_q2_first_punch$"),
    ("stored energy of one rank", "elasticity/elasticity_operator.cc", "    return Utilities::MPI::sum(energy, discretization.geometry.communicator);", "    return energy;", RANKS),
    ("dilatation in the pressure's moment", "elasticity/kinematics.cc", "k == 0 ? 1. : (values.quadrature_point(q)[k - 1] - centre[k - 1]) / size", "1. * (k == 0)+ (k > 0) * (values.quadrature_point(q)[0] - centre[0]) / size * k", "^elasticity/elasticity$|^elasticity/cook_membrane$"),
    ("energy of neo-Hookean bodies", "elasticity/neo_hookean.cc", "lambda / 4 * (change - ln_J2)", "lambda / 2 * (change - ln_J2)", "^elasticity/hyperelastic$"),
    ("energy of St. Venant's bodies", "elasticity/st_venant_kirchhoff.cc", "mu / 4 * (e * e)", "mu / 2 * (e * e)", "^elasticity/hyperelastic$"),
    ("thickness of St. Venant's bodies", "elasticity/st_venant_kirchhoff.cc", "(mu + lambda / 2);", "(2 * mu + lambda / 2);", "^elasticity/hyperelastic$|scenes/uniaxial_plane_stress_SVK_q1$"),
    ("stiffness of pressure on a growing radius", "elasticity/pressure_stiffness.cc", "change += 2 * numbers::PI * values.shape_value(j, q) * normal;", ";", "^elasticity/follower_pressure$"),
    # ---- contact
    ("size of round contacts", "contact/surface_fields.cc", "of_a_point ? 2.5 : 4;", "of_a_point ? 2 : 4;", "scenes/sphere_2a$|scenes/hertz_sphere$"),
    ("tangential force without area", "contact/surface_fields.cc", "fields.tangential_force -= row.area * node.shear;", "fields.tangential_force -= node.shear;", FRICTION),
    ("slip of hanging nodes", "contact/surface_fields.cc", "fields.slip[i] += weight * fields.slip[parent];", "fields.slip[i] -= weight * fields.slip[parent];", FRICTION + "|scenes/patch_friction_.*hanging_nodes.*"),
    ("gap of hanging nodes", "contact/surface_fields.cc", "gap += weight * fields.gap[parent];", "gap += fields.gap[parent];", "^contact/surface_fields$"),
    ("factor of symmetry planes", "contact/surface_fields.cc", "fields.symmetry_factor *= 2;", "fields.symmetry_factor = 2;", "scenes/(cylinders_1b|hertz_sphere|crossed_cylinders)$"),
    ("normal of forces on the slave", "contact/surface_fields.cc", "fields.normal_force -= row.area * node.pressure * row.normal;", "fields.normal_force += row.area * node.pressure * row.normal;", FRICTION + "|scenes/greco$"),
    ("trace masses of one rank", "contact/mortar_integrator.cc", "          add_to(sums.trace_mass, parts[rank].trace_mass);\n", "", RANKS),
    ("full turn of covered shares", "contact/covered_shares.cc", "gauss.weight(q) * jacobian * area_factor(axisymmetric, slave.position(f, gauss.point(q)))", "gauss.weight(q) * jacobian", "^contact/mortar$|scenes/sphere_2a$|scenes/.*axisymmetric.*"),
    ("share of held nodes", "contact/dual_basis.cc", "result.traces(i, f) = D[f];", "result.traces(i, f) = D[f] / n;", "^contact/dual_basis$|^contact/mortar$"),
    ("declared gaps of moved surfaces", "contact/declared_gap.cc", "moved ? p.gap + gap : gap", "moved ? p.gap - gap : gap", "^contact/coupling_derivatives$|" + FINITE),
    ("overlaps within Adjust", "contact/declared_gap.cc", "std::max(pair.adjust, 1e-10 * face_size)", "1e-10 * face_size", "^contact/mortar$"),
    ("steps opposite of a face", "contact/overlap_search.cc", "piece.kept = piece.gap <= beside + 0.5 * size;", "piece.kept = true;", "^contact/|scenes/patch_3d_q1_step$"),
    ("edge of the contact", "contact/contact_edge.cc", "std::min(0., extrapolate(slave, i, around, result))", "-largest", "^contact/contact_edge$"),
    # ---- friction
    ("friction of limit loads", "friction/limit_load.cc", "contact.friction / length : 0", "1 / length : 0", "^friction/limit_load$"),
    ("patience of the active set", "friction/active_set.cc", "single = true;", "single = false;", "^friction/active_set$"),
    # ---- algebra, solver
    ("weights of condensation", "algebra/eliminated_system.cc", "result(other) += weight * value;", "result(other) += value;", PLANE),
    ("increments after a cut", "solver/load_program.cc", "factor = std::min(1., 2 * factor);", "factor = 2 * factor;", "^solver/load_program$"),
    ("corners of the load", "solver/load_program.cc", "return t <= 0 || std::any_of(", "return std::any_of(", "^solver/load_program$"),
    ("turning slip", "solver/node_states.cc", "!first && slid && limit.value > 0 && q * laws[k].direction < 0", "false", FRICTION + "|scenes/iterations_.*|scenes/microslip_bar_back_at_0"),
    ("origin of sticking nodes", "../include/amontons/solver/fixed_contact.h", "result[k] = all[k].jump(start.committed);", "result[k] = all[k].jump(start.displacement);", FRICTION),
    ("slip that turns without a bound", "solver/node_states.cc", "!first && slid && limit.value > 0 && q", "!first && slid && q", "^solver/node_states$"),
    ("slip that rests without a bound", "solver/node_states.cc", "slid && (limit.value <= 0 || nodes", "slid && (nodes", "^solver/node_states$"),
    ("vertices of coarser faces", "contact/shear_smoothness.cc", "is_own(face, j) && linear[face.unknowns[j]]", "linear[face.unknowns[j]]", "^contact/hanging_nodes$"),
    ("all faces are close", "adaptivity/first_mesh.cc", "(everywhere && close.size()", "(close.size()", "scenes/ball_on_one_face_small"),
    ("increments that grow", "solver/load_program.cc", "constexpr double growth = 1.5;", "constexpr double growth = 1.;", "^solver/load_program$"),
    ("fewer increments, guided", "increments_for_target.cc", "repeat(load_program(lengths), false)", "repeat(load_program(lengths), true)", "scenes/wedge_self_lock_one_increment"),
    ("small obstacles", "geometry/small_obstacles.cc", "closest <= std::sqrt(2.) * radius ||", "closest > 0 ||", "scenes/thin_wire"),
    ("shear by increments", "adaptivity/increment_error.cc", "return std::max(sums.shear,\n", "return std::max(0. * sums.shear,\n", "^adaptivity/increment_choice$"),
    ("axes of a surface", "output/svg_mesh.cc", '(has_axes ? painter.axes(axes) : "")', '""', "^output/svg$"),
    ("stored states", "solver/node_states.cc", "contact.state          = states[k];", "contact.state          = answers[k].state;", FRICTION),
    ("states of nodes that had a row", "solver/node_states.cc", "auto &contact = result[nodes[k].interface][nodes[k].node];", "auto &contact = result[nodes[k].interface][nodes[k].row];", "^solver/node_states$"),
    ("shift along the surface that slip does not see", "solver/increment_slip.cc", "weights[c][dofs[c]] -= gamma * jump;", ";", "^solver/slip$"),
    ("motion that is lost goes on", "solver/pseudo_transient.cc", "!newton.put(start) || !steps->reject()", "!newton.put(start)", "scenes/(wall_buckling|snap_away).*"),
    # ---- adaptivity
    ("hoop strain that is left out", "elasticity/elasticity_operator.cc", "H[2][2] += u[first] *", "H[2][2] += 2 * u[first] *", "^elasticity/elasticity$"),
    ("stress of large strain", "elasticity/elasticity_operator.cc", "(is_neo_hookean ? -1. : 1.) * product", "(is_neo_hookean ? -1. : -1.) * product", "^elasticity/elasticity$"),
    ("volume of large strain", "elasticity/elasticity_operator.cc", "trace(e) * trace(e) - scalar_product(e, e) : 0.", "trace(e) * trace(e) : 0.", "^elasticity/elasticity$"),
    ("comparison where nothing is left", "load_stepping.cc", "evaluation.is_judged_by_history() && history.pressed_most.place.t > 0", "false", "scenes/unloaded_to_nothing"),
    ("stress of rounding", "evaluation.cc", "of_history && energy_norm < unloaded_part * error.energy_norm", "false", "scenes/unloaded_to_nothing"),
    ("kinematics of rounding", "adaptivity/model_selection.cc", "if (pressures && !is_unloaded(**place))", "if (pressures)", "scenes/unloaded_to_nothing"),
    ("measuring without cuts", "load_path.cc", "is_guided ? std::max(2u, history.record.n_increments / 20) : 0", "0", "scenes/ironing_measured_with_cuts"),
    ("passing of what is open on average", "solver/old_partners.cc", "&& !is_still_opposite(interfaces[i], n, *partners[i][n]))", ")", "scenes/ironing_open_on_average"),
    ("surfaces of symmetry", "adaptivity/slenderness.cc", "!is_mirror(face) && glued", "glued", "scenes/small_strain_of_a_quarter"),
    ("size of what is left", "load_stepping.cc", '!is_size(name) || sizes_are_seen', 'name != "contact size" || sizes_are_seen', "scenes/stick_size_of_what_is_left"),
    ("slip across planes", "solver/contact_nodes.cc", "result[a] = tangential(axis) - direction", "result[a] = axis - (axis * normal) / normal.norm_square() * normal - direction", "scenes/free_across_plane"),
    ("obstacles that leave planes", "run_notes.cc", "if (leaves_plane(answer, i))", "if (false)", "scenes/free_across_plane"),
    ("degree of plates", "discretization/degree.cc", "slenderness[b] > slender || ", "", "scenes/degree_of_plates"),
    ("degree of rubber", "discretization/degree.cc", " || body.material.poisson >= nearly_incompressible", "", "scenes/degree_of_rubber"),
    ("contact that was seen", "evaluation.cc", "interfaces.size() == 1 && has_touched && is_judged_by_history()", "false", "scenes/pressed_twice_and_unloaded"),
    ("halves that may buckle", "contact_problem.cc", "if (success && small_strain.may_lose_symmetry())", "if (false)", "scenes/half_of_what_buckles"),
    ("peaks that agree by chance", "evaluation.cc", "error.peak, error.contact / 3}", "error.peak}", "scenes/peak_by_chance"),
    ("stick size by small strain", "output/target_quantity.cc", "return 2;", "return 1;", "scenes/stick_size_by_finite_strain"),
    ("moments about bodies", "output/physics_checks.cc", "place.X - discretization.geometry.body_centres[place.body]", "place.X - Point<dim>()", "scenes/far_from_the_origin"),
    ("affordable cells", "adaptivity/mesh_refinement.cc", "growth * n_cells / (GeometryInfo<dim>::max_children_per_cell - 1)", "growth * n_cells / GeometryInfo<dim>::max_children_per_cell", "^adaptivity/"),
    ("errors of one rank", "../include/amontons/adaptivity/squared_errors.h", "      return dealii::Utilities::MPI::sum(mine, communicator);", "      return mine;", RANKS),
    ("shear of the estimate", "adaptivity/error_estimator.cc", "square += weight * (t - (common * t) * common - shear).norm_square();", ";", "^adaptivity/error_estimator$"),
    ("share of the master's cells", "adaptivity/error_estimator.cc", "const double share = point.weight / areas[point.slave_face] *", "const double share = point.weight *", "^adaptivity/error_estimator$"),
    ("levels for a target", "adaptivity/mesh_refinement.cc", "left > share; left /= per_level", "left > share && false; left /= per_level", "^adaptivity/error_estimator$"),
    ("stress for a target", "adaptivity/error_estimate.cc", "std::min(1., 2 * target)", "1", "^adaptivity/error_estimator$"),
    ("factors that grow", "adaptivity/mesh_difference.cc", "may_grow ? of_coarser / factors.of_coarser : 1.", "1.", "^adaptivity/mesh_difference$"),
    ("increments on the same mesh", "adaptivity/increment_choice.cc", "if (n <= at_first && mesh_is_last)", "if (mesh_is_last)", "^adaptivity/increment_choice$"),
    ("increments for a target", "adaptivity/increment_choice.cc", "std::min(std::ceil(error / allowed()), parameters.most_increments())", "parameters.most_increments()", "^adaptivity/increment_choice$"),
    ("worst of the increments", "evaluation.cc", "keep_largest(kept.contact_indicators, error.contact_indicators);", ";", "scenes/unloaded_two_cylinders$"),
    ("target error", "load_stepping.cc", "(estimate <= believed &&", "(estimate >= believed &&", "scenes/.*target.*"),
    # ---- output
    ("moments in space", "../include/amontons/output/nodal_forces.h", "m[(c + 2) % 3] -= X[(c + 1) % 3] * force;", "m[(c + 2) % 3] += X[(c + 1) % 3] * force;", "scenes/patch_friction_3d_q1_first_slips"),
    ("reactions of one rank", "output/quantities.cc", "            Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);\n            ReactionSummary", "            ReactionSummary", "scenes/tied_patch$|" + RANKS),
    ("shears beyond the cone", "output/physics_checks.cc", "excess             = std::max(excess, node.shear.norm() - bound);", ";", "^output/"),
    ("work of contact", "output/energy.cc", "half.contact -= 0.5 *", "half.contact += 0.5 *", FRICTION),
    ("work of one rank", "output/energy.cc", "    half.external               = Utilities::MPI::sum(half.external, communicator);\n", "", RANKS),
    ("points of long probes", "output/probes.cc", "double(i) / (probe.n_points - 1)", "double(i) / probe.n_points", "scenes/greco$"),
    ("stresses of probes", "output/probes.cc", "point.stress.assign(values + dim, values + dim + n_voigt<dim>);", "point.stress.assign(values, values + n_voigt<dim>);", READ),
    ("tangential force of the chart", "output/report_history.cc", "x /= std::copysign(length, largest);", "x /= length;", "^output/report$"),
    ("curves of work", "output/report_history.cc", 'add_curve(chart, "stored energy", pass, [](const MeshSummary &mesh) { return mesh.energy; });', 'add_curve(chart, "stored energy", pass, [](const MeshSummary &mesh) { return 2 * mesh.energy; });', READ + "|^output/report$"),
    ("room of a logarithmic axis", "output/svg_chart.cc", "std::max(std::pow(upper / lower, room), 1.3)", "std::min(std::pow(upper / lower, room), 1.3)", "^output/svg$"),
    ("chords in what passed through", "solver/old_partners.cc", "now.gap < -0.05 * h - partners[i][n]->of_facets", "now.gap < -0.05 * h", "scenes/ball_in_hollow_deeper$"),
    ("a turning point between two values", "scene/path_corners.cc", "slope(is_midway ? i + 1 : i)", "slope(i)", "^scene/path_corners$"),
    ("friction around one node", "model_reduction.cc", "return n == 0 || n >= enough_closed_nodes<dim>;", "return true;", "scenes/model_with_unseen_friction$"),
    ("contact that finite strain makes", "adaptivity/contact_change.cc", "return appears ? ContactChange{1, 1, 0, true} : ContactChange();", "return {};", "scenes/column_with_stop$"),
    ("what looks away from a round obstacle", "contact/overlap_search.cc", "return is_round && !obstacle.hollow && p.gap < 0 &&", "return false && is_round && !obstacle.hollow && p.gap < 0 &&", "scenes/disk_in_cradle$"),
    ("a beam behind an even pressure", "load_stepping.cc", "is_first ? std::max(mendable, error.bulk) : mendable", "mendable", "scenes/pad_below_beam$"),
    ("contact nearer than displacements are known", "evaluation.cc", "error.bulk * state.displacement.linfty_norm() : 0.);", "0 * state.displacement.linfty_norm() : 0.);", "scenes/floor_below_beam$"),
    ("the height of a body on one node", "evaluation.cc", "std::max(height_in_doubt(interfaces, fields),", "std::max(0 * height_in_doubt(interfaces, fields),", "scenes/beam_on_rollers$"),
    ("increments measured by more of them", "increments_for_target.cc", "record = repeat(halved, true);", ";", "scenes/rolled_disk$"),
    ("work of nodes that have opened", "output/energy.cc", "work += std::max(0., known->second.force * node.slip / 2);", ";", "scenes/slide_over_edges_friction_second$"),
    ("increments that were cut", "adaptivity/increment_choice.cc", "errors.scaled(taken / at_first)", "errors", "^adaptivity/increment_choice$"),
    ("cells around a contact by their length", "adaptivity/pollution_error.cc", "length = cell->diameter() / std::sqrt(dim)", "length = std::pow(cell->measure(), 1. / dim)", "scenes/flat_cell$"),
    ("pairs too light to count", "adaptivity/error_estimator.cc", "is_unresolved[i] && weights[i]", "false && weights[i]", "scenes/heavy_and_light$"),
    ("contact alone until it is seen", "model.cc", "!is_unseen && mark(error.cell_indicators, step)", "mark(error.cell_indicators, step)", "scenes/heavy_and_light_size$"),
    ("numbers before all that touches is seen", "load_stepping.cc", "history.quantity.add_unseen(values);", ";", "scenes/beam_on_three_rollers$"),
    ("a finer first mesh", "load_program_retries.cc", "return !is_finer && steps", "return false && steps", "scenes/swept_strip$"),
    ("scenes that turn as a whole", "load_path.cc", "model->finite_strain() && turn_along()", "false && turn_along()", "scenes/turned_with_friction_first$"),
    ("turns by reflection", "discretization/common_turn.cc", "determinant(proper) > 0 ? proper : rotation(-1)", "proper", "^discretization/common_turn$"),
    ("supports against the turn", "discretization/common_turn.cc", "if (Utilities::MPI::max(broken, comm) >", "if (false && broken >", "^discretization/common_turn$"),
    ("gaps on the mesh of then", "small_strain_check.cc", "    neglected.measure_gaps(model.discretization(),\n                           model.supports,\n                           model.interfaces,\n                           parameters.refinement.history == \"transfer\");\n", "", "scenes/hertz_with_output_time$"),
    ("kinks of arcs", "geometry/facets.cc", "face->manifold_id() == numbers::flat_manifold_id || is_curved(face)", "face->manifold_id() == numbers::flat_manifold_id", "scenes/kinks_of_second_order$"),
    ("images of facets", "geometry/facets.cc", "m   = n - 2 * (n * plane->second) * plane->second;", "m = n;", "^geometry/facets$"),
    ("rims of rigid bodies", "model.cc", "    refine_rims_of_rigid_bodies(scene, geometry);\n", "", "scenes/round_punch_3d$"),
    ("numbers that do not exist", "run_notes.cc", "error.quantity && ending.history.quantity.vanishes()", "false", "scenes/no_such_quantity$"),
    ("ties across gaps", "contact_problem.cc", "gap > 1e-2 * interface.slave", "gap > 1e2 * interface.slave", "scenes/tied_apart$"),
    ("pressure of uneven gaps", "small_strain_check.cc", "return pressures_are_known() && pressure > error_of_mesh &&", "return false &&", "scenes/sliding_pad$"),
    ("equal steps in space", "adaptivity/mesh_refinement.cc", "part_that_stays(reduction, dim, has_history)", "part_that_stays(reduction, 2, has_history)", "^adaptivity/error_estimator$"),
    ("depth of pixels", "output/rasteriser.cc", "if (!(depth > sample.depth))", "if (false)", "^output/rasteriser$"),
    ("where tetrahedra are cut", "output/body_section.cc", "const double s = da / (da - db);", "const double s = 0.5;", "^output/body_picture$"),
    ("faces of one rank", "output/body_surfaces.cc", "for (BodySurfaces &part : parts)", "for (BodySurfaces &part : std::vector<BodySurfaces>(1, parts.empty() ? BodySurfaces() : parts[0]))", "^same_pictures$"),
    ("pressures of the chart", "output/report_charts.cc", "curve.pressure.push_back(node.pressure);", "curve.pressure.push_back(node.gap);", READ),
    ("bodies and ranks in bodies.vtu", "output/vtu_output.cc", 'data_out.add_data_vector(labels[0], "body"', 'data_out.add_data_vector(labels[1], "body"', READ),
    ("stresses in bodies.vtu", "output/vtu_output.cc", "fields.recovery.stress()[c], \"stress_\" + names[c]", "fields.recovery.stress()[0], \"stress_\" + names[c]", READ),
    ("carriers in bodies.vtu", "output/vtu_output.cc", "data_out.set_cell_selection(first, next);", ";", "scenes/sphere_2a"),
    ("open and stick on the terminal", "output/terminal.cc", "                    l.n_open,\n                    l.n_stick,\n                    l.n_slip,\n                    l.changes,", "                    l.n_stick,\n                    l.n_open,\n                    l.n_slip,\n                    l.changes,", "^output/terminal$"),
    ("bulk and contact in summary.json", "output/summary.cc", '.add("centre", pair.centre)', '.add("centre", pair.normal_force)', "^output/summary$"),
    ("von Mises of the picture", "output/mesh_picture.cc", "outline.push_back(values.quadrature_point(q)[d] + u[q][d]);", "outline.push_back(values.quadrature_point(q)[d]);", READ),
    # ---- bodies that only nodes beyond an edge hold, corners, targets
    ("region beyond the edge", "solver/contact_region.cc", "centre + stretch * (points[i].x_slave - centre)", "centre + 2 * stretch * (points[i].x_slave - centre)", "scenes/tipping_falls_first$"),
    ("forces of the region on one side", "solver/contact_region.cc", "floating.velocity(motion, slave, point.x_slave) -", "floating.velocity(motion, slave, point.x_slave) +", "scenes/tipping_.*"),
    ("corners that enter", "solver/old_partners.cc", "depth > nothing && depth < moved + nothing", "depth < -nothing", "scenes/corner_.*"),
    ("error by the difference", "adaptivity/mesh_difference.cc", "difference / (eta_before * std::sqrt(1 - q * q))", "difference / eta_before", "^adaptivity/mesh_difference$"),
    ("difference of pressures", "adaptivity/mesh_difference.cc", "difference += N[i] * (now[node] - before[node]);", ";", "scenes/target_alone$"),
    ("error of the shear", "adaptivity/error_estimator.cc", "shear_error += shear_part;", ";", "scenes/target_of_shear$"),
    ("what is left of a number", "adaptivity/quantity_sequence.cc", "rho / (1 - rho)", "rho", "^adaptivity/mesh_difference$"),
    ("contact that is not resolved", "load_stepping.cc", "evaluation.touches() ? evaluation.resolves_contact() && is_resolved : error.data < 1", "true", "scenes/target_from_a_coarse_mesh$"),
    # ---- verification
    ("approach of elliptic contacts' radius", "verification/closed_forms.cc", "{P, a, 3 * P / (2 * pi * a * a), a * a / R}", "{P, a, 3 * P / (2 * pi * a * a), a * a / (2 * R)}", "^verification/closed_forms$|scenes/two_spheres_3d$"),
    ("Poisson's ratio of a bore", "verification/closed_forms_tubes.cc", "t.inner / t.E * ((o + i) / (o - i) + t.nu)", "t.inner / t.E * ((o + i) / (o - i) - t.nu)", "^verification/closed_forms$|scenes/shrink_fit_finer_slave$"),
    ("degrees of crossed axes", "verification/reference_builders.cc", 'get("angle") * dealii::numbers::PI / 180', 'get("angle")', "^verification/reference_solution$"),
    ("plane stress of tubes", "verification/reference_builders.cc", "return plane_stress ? Confinement::plane_stress : Confinement::plane_strain;", "return Confinement::plane_strain;", "^verification/reference_solution$|scenes/shrink_fit_plane_stress$"),
    ("error of gradients", "verification/reference_errors.cc", "std::sqrt(sums[2] / sums[3])", "std::sqrt(sums[2] / sums[1])", "scenes/half_plane_box_lengths$"),
    ("error of displacements", "verification/reference_errors.cc", "std::sqrt(sums[0] / sums[1])", "std::sqrt(sums[0] / sums[3])", "scenes/half_plane_box_lengths$"),
    ("motion of supports across", "output/approach.cc", "if (support->second && std::abs(values.normal_vector(0) * e) < 0.999)", "if (std::abs(values.normal_vector(0) * e) < 0)", "scenes/(two_spheres_3d|hertz_sphere)$"),
    ("refer to the last row", "verification/convergence_study.cc", "std::abs(r.errors[q] - last[q]) / (last[q]", "std::abs(r.errors[q] + last[q]) / (last[q]", "^verification/convergence_study$"),
    ("loads on facets", "discretization/discretization.cc", "load_mapping(std::max(2u, degree))", "load_mapping(degree)", "^elasticity/loads$"),
    ("covered pressure on facets", "elasticity/loads.cc", "covered[begin + q].weight / facets[q].norm() * area[q]", "covered[begin + q].weight / area[q].norm() * area[q]", "^elasticity/loads$"),
    ("mirror images that turn", "output/mirror_symmetry.cc", "!turns_obstacles(answer.discretization.scene, axis) &&", "", "scenes/twisted_ball$"),
    ("where slip starts", "output/energy.cc", "start > at_end ? std::clamp(known.shear.norm(), at_end, start) : start", "start", "scenes/loosened_(clamp|friction)$"),
    ("increments of the answer", "adaptivity/increment_error.cc", "if (n == now || n == 0 || now == 0)", "if (true)", "scenes/ring_in_turning_bore_increments$"),
    ("mirror images without pressures", "output/mirror_symmetry.cc", "return std::abs(entry.second[0]) <= allowed * entry.second[1];", "return allowed > 0 || std::abs(entry.second[0]) < 0;", "^scenes/model_"),
    ("modes of the mesh are followed", "solver/pseudo_transient.cc", "mode->shape) > 1)", "mode->shape) > 10)", "^scenes/tube_in_bore$"),
    ("common normal by the other compliance", "contact/common_normal.cc", "D > 0 ? D / (C + D) : 0", "D > 0 ? C / (C + D) : 0", "^scenes/sheared_half_disk|^scenes/shear_by"),
    ("gaps along the common normal", "contact/mortar_integrator.cc", "points[q].gap * points[q].ray", "points[q].gap * points[q].normal", "^scenes/touched_by_little"),
    ("the turn of forces", "adaptivity/model_selection.cc", "turned.norm() / force", "0 * turned.norm() / force", "^scenes/tilted_block"),
    ("reactions of pins", "solver/newton_residual.cc", "free(dof) = 0;", "free(dof) *= 1;", "^scenes/turned_rings"),
    ("spheres in units", "geometry/manifolds.cc", "std::ldexp(1., std::ilogb(radius))", "1 + 0 * radius", "^scenes/nanometres"),
    ("overtaken obstacle", "contact/shared_nodes.cc", "if (gap > -rounding ||", "if (true ||", "scenes/overtaken_finite$"),
    ("overlap behind", "contact/shared_nodes.cc", "std::max(most, -gap / interface.slave->mean_size)", "most", "scenes/pressed_by_two_on_one_slave$"),
    ("overtaken, whichever side", "contact/shared_nodes.cc", "gap - row.normal * jump(row, u)", "gap + row.normal * jump(row, u)", "scenes/overtaken_on_finer_meshes$"),
    ("overtaken on the next mesh", "model.cc", "  {\n    changed.clear();\n    std::vector", "  {\n    std::vector", "scenes/overtaken_on_finer_meshes$"),
    ("gaps that jump inside a face", "contact/declared_gap.cc", "if (!gap.may_jump())", "if (true)", "scenes/punch_by_gap"),
    ("gaps that jump beside hanging nodes", "contact/declared_gap.cc", "of.subdivision);", "FullMatrix<double>());", "scenes/punch_by_gap$"),
    ("edges of a gap are seen", "adaptivity/gap_error.cc", "if (declared.is_within_unknowns(f, unseen.least, unseen.most))", "if (false)", "scenes/punch_by_gap"),
    ("numbers against the largest pair", "adaptivity/quantity_sequence.cc", "least_of_largest * largest, ", "largest, ", "^adaptivity/mesh_difference$"),
    ("small contacts are believed", "adaptivity/unseen_contact.cc", "result.push_back(!is_single && presses[i]", "result.push_back(false && presses[i]", "scenes/target_of_three_contacts"),
    ("joints count as contact", "adaptivity/error_estimate.cc", "interfaces[i].pair->tied && of_others > 0 ? 0.", "interfaces[i].pair->tied && of_others > 0 ? 1.", "scenes/target_beside_a_joint"),
    ("first solution of a set", "solver/newton.cc", "lines[n - 2].n_changes == 0 &&", "true &&", "scenes/half_ring_below_lid$"),
    ("overlaps along a normal that misses", "contact/shared_nodes.cc", "std::max(row.gap, row.mean_gap);", "row.gap;", "scenes/ring_in_groove$"),
    ("held at the bound", "evaluation.cc", "left > 1e-8 * bound", "left > 0", "scenes/capstan_held_at_its_bound$"),
    ("sizes of a few nodes", "evaluation.cc", "!sizes_are_resolved(", "false && !sizes_are_resolved(", "scenes/target_size_by_chance$"),
    ("walls that both bodies end at", "solver/node_planes.cc", "result.insert(result.end(), node.walls.begin(), node.walls.end());", "", "scenes/v_joint_walls"),
    ("targets missed by the kinematics", "run_notes.cc", "by_kinematics <= std::max(left, target / 4)", "true", "scenes/half_ring_below_lid$"),
    ("springs on bodies that move", "solver/rigid_mode_stabilisation.cc", "&& !moving[floating.owner_of(dof)]", "&& false", "scenes/roller_bearing_without"),
    ("flights to the first contact", "solver/newton_step.cc", "if (!overlaps)", "if (true)", "scenes/roller_bearing$"),
    ("mesh and kinematics share the target", "small_strain_check.cc", "std::max(all / 4, all - of_mesh)", "all", "scenes/auto_shares_the_target"),
    ("small strain that gave way", "small_strain_check.cc", "return !has_given_way &&", "return", "scenes/auto_leaves_small_strain_for_good"),
    ("ends that no mesh refines", "adaptivity/quantity_sequence.cc", "now > enough * meshes[half].doubts[i]", "false", "scenes/stick_size_between_corners$|^adaptivity/mesh_difference$"),
    ("refined ends of sizes", "adaptivity/zone_ends.cc", "is_needed && i < interfaces.size()", "false && i < interfaces.size()", "scenes/stick_size_between_corners$"),
    ("slaves at corners", "contact/slave_choice.cc", "result[k] != result[i] && meet(all[k], all[i])", "false && meet(all[k], all[i])", "scenes/keyway$"),
    ("errors that swing", "adaptivity/mesh_sequence.cc", "(begin > 0 && !always_falls && trend() < least", "(false && trend() < least", "^adaptivity/mesh_difference$"),
    ("energy by small strain", "small_strain_check.cc", 'quantity == "energy" && energy > 0', 'quantity == "nothing" && energy > 0', "scenes/small_strain_of_an_energy$"),
    ("steps of curvature", "adaptivity/facet_error.cc", "2 * half_width > facet.size ?", "true ?", "scenes/curve_in_steps$"),
    ("rows of steps", "geometry/facets.cc", "row(f, k, -by, &Kinks::step)", "row(f, k, by, &Kinks::step)", "^geometry/facets$"),
    ("dissipation by the shear", "evaluation.cc", "std::pow(error.shear, 2) / 2", "0.", "scenes/dissipation_below_corners"),
    ("work without shear", "evaluation.cc", "safety * values.spread()", "1e9 * values.spread()", "scenes/dissipation_beside_edges"),
    ("cells on one side", "geometry/grid_reader.cc", "if (other)\n", "if (false)\n", "geometry/grid_reader"),
    ("gaps of meshes", "contact/contact_interface.cc", "if (finite_strain) // meshes", "if (false) // meshes", "scenes/approach_(adjusted|declared)"),
    ("slaves that contradict", "contact/slave_choice.cc", "slave(all[k]) != slave(all[i])", "false", "scenes/keyway_slaves"),
    ("size all around", "contact/surface_fields.cc", "second_moment < all_around * polar_moment", "second_moment < 0 * polar_moment", "scenes/size_of_a_shrink_fit$"),
    ("a first mesh that sees no edge", "adaptivity/mesh_sequence.cc", "meshes[begin + 1].error > meshes[begin].error ? begin + 1 : begin", "false ? begin + 1 : begin", "scenes/target_of_what_the_first"),
    ("peaks that rise for ever", "adaptivity/peak_error.cc", "fall(1) * of_power(0) < of_power(1) * fall(0)", "false", "scenes/kink_of_gap_at_0.7$"),
    ("peaks that are cusps", "adaptivity/peak_error.cc", "part * near / peak", "0 * near / peak", "scenes/cusp"),
    ("coarse cells around a contact", "adaptivity/pollution_error.cc", "constants[degree - 1] * modulus", "0 * modulus", "scenes/hertz_on_cantilever"),
    ("loads beside the contact", "elasticity/loads.cc", "covered->second < area / 2", "covered->second < 2 * area", "scenes/(patch_q2_second_punch|patch_3d_q1_first_punch)$"),
    ("an edge that is none", "adaptivity/edge_error.cc", "deforms ? fields.state[i] == ContactStatus::open && ", "deforms ? !presses(i) || ", "adaptivity/edge_error"),
    ("bound after a jump", "output/energy.cc", "state.committed_t + 1e-9 *", "state.committed_t - 1e-9 *", "scenes/coefficient_that_jumps"),
    ("where a node touches", "../include/amontons/solver/fixed_contact.h", "jumps[k] += before * (all[k].jump(start.earlier) - now);", "", "scenes/loaded_at_an_angle_small$"),
    ("three states of a node that touches", "../include/amontons/solver/first_touch.h", "!earlier || *earlier", "true || *earlier", "^solver/first_touch$"),
    ("increments that are measured again", "increments_for_target.cc", "? increments.wants_more() && (evaluation", "? false && (evaluation", "scenes/increments_of_a_contact_that_grows$"),
    ("an increment that begins the first one", "solver/load_program.cc", "is_begun_in_two(here) ? here.begin", "false ? here.begin", "^solver/load_program$"),
    ("increments where nothing closed", "increments_for_target.cc", "if (history.record.closes_beyond(measurement->closing))", "if (false)", "scenes/increments_where_nothing_closes_at_first_1$"),
    ("a tied pair on the same surface", "adaptivity/mesh_difference.cc", "weights[i] > 0 && n <", "n <", "scenes/target_beside_a_joint_on_the_same_surface"),
    ("nothing radial on the axis", "contact/surface_fields.cc", "radial.means[i] = {};", ";", "scenes/punch_friction_5_increments$"),
    ("gradients that jump little", "contact/pressure_projection.cc", "constexpr double weight = 0.25;", "constexpr double weight = 0.;", "^contact/surface_fields$"),
    ("the rest of the face of what touched alone", "contact/shear_smoothness.cc", "result[i] = sticks(i);", "result[i] = alone(i);", "scenes/increments_of_a_contact_that_grows$"),
    ("increments by what loads do", "solver/load_program.cc", "load_progress.empty() || ", "true || ", "scenes/microslip_bar_bound_dips$|^solver/load_program$"),
    ("jumps are no way of a load", "scene/path_corners.cc", "i > 0 && jump(i) ? 0.", "false ? 0.", "^scene/path_corners$"),
    ("height of panels", "verification/work_chart.cc", "<< \", \" << high / height", "<< \", \" << high * height", "^verification/run_study$"),
    ("single increments", "adaptivity/increment_choice.cc", "counted(change) / (part_of_allowed * allowed())", "counted(change) / (2 * part_of_allowed * allowed())", "^adaptivity/increment_choice$"),
    ("what closes within few increments", "adaptivity/load_record.cc", "kept.closed += square;", "kept.closed += 0 * square;", "^adaptivity/error_estimator$"),
    ("increments that count at the end", "adaptivity/increment_error.cc", "return is_loaded ? change.at_end() : change.largest();", "return change.largest();", "^adaptivity/increment_choice$"),
    ("as many increments as change little", "adaptivity/increment_choice.cc", "        n = std::ceil(too_large);\n", "        return false;\n", "^adaptivity/increment_choice$"),
    ("errors that add up as independent ones", "../include/amontons/base/independent_errors.h", "return std::hypot(a, b);", "return a + b;", "^adaptivity/increment_choice$"),
    ("forces of blunt edges", "load_stepping.cc", "name == \"total force\" ? corner_forces(answer()) : 0", "0.", "scenes/snap_hook$"),
    ("decimal commas", "scene/expression.cc", "    refuse_commas(source, variables, where);\n", "", "^scene/wrong_scenes$"),
    ("sizes of nothing", "adaptivity/unseen_contact.cc", "fields[i].contact_size > 0 || n_closed_nodes", "fields[i].contact_size > 0 || 1000 + n_closed_nodes", "scenes/size_of_what_is_left$"),
    ("errors of those that are divided", "adaptivity/increment_error.cc", "std::lround(left * n_increments)", "std::lround(n_increments)", "^adaptivity/increment_choice$"),
    ("friction between nodes", "model_reduction.cc", "return pair.bound_depends_on_place();", "return pair.tied;", "scenes/friction_between_nodes$"),
    ("carriers where finite strain is tried", "small_strain_check.cc", "      set_carriers(model.discretization(), finite.supports, trial.displacement);\n", "", "scenes/turning_shaft$"),
    ("forces that have a resultant", "small_strain_check.cc", "\"total force\" && contact.has_resultant", "\"total force\"", "scenes/torque_beyond_friction$"),
    ("ridges that no node sees", "adaptivity/error_estimator.cc", "if (total(gap_square) > pressure)", "if (false)", "scenes/narrow_ridge$"),
    ("jumps that no mesh sees", "adaptivity/gap_error.cc", "gap && !gap->may_jump() && ", "gap && ", "scenes/punch_by_gap$"),
    ("wedged nodes", "solver/node_states.cc", "          slide(k, answers[k]);\n", "          states[k] = ContactStatus::stick;\n", "scenes/held_on_incline_small_strain$"),
    ("what is opposite of wedged nodes", "solver/contact_nodes.cc", "if (dof != own && !is_given(dof))", "if (false)", "^solver/node_states$"),
    ("the way of wedged nodes", "solver/node_states.cc", "rests(k, answer, limit.value)\n", "true\n", "scenes/held_on_incline_small_strain$"),
    ("what small strain has shown", "contact_problem.cc", "    if (serves)\n", "    if (false)\n", "scenes/goes_on_with_what_is_known$"),
    ("single increments that are divided", "adaptivity/increment_choice.cc", "return remove(record.closing_beyond(part_that_closes * allowed()), few);", "return false;", "^adaptivity/increment_choice$"),
    ("where a node touches at finite strain", "solver/increment_slip.cc", "held * (before * z + earlier * z_2)", "0. * z", "scenes/loaded_at_an_angle_finite$"),
    ("continued pressures", "adaptivity/face_points.cc", "covered[point.slave_face] = true", "covered.assign(covered.size(), true)", "scenes/round_punch"),
    ("forces across planes of symmetry", "output/target_quantity.cc", "along -= (along * normal) * normal", "along -= 0 * (along * normal) * normal", "scenes/ball_in_hollow"),
    ("pairs that are not refined", "adaptivity/refined_pairs.cc", "factors[i] = doubt", "factors[i] = 1", "scenes/two_indenters"),
    ("guesses that fail are forgotten", "increment_retries.cc", "if (!history.at_once && forget_guess(program.next()))", "if (false)", "scenes/ring_between_walls"),
    ("the node at rest", "solver/node_states.cc", "if ((excess += 2 * slip.bound) >= 0)", "if (true)", "scenes/band_on_drum"),
    ("walls beside the contact", "algebra/contact_constraints.cc", "? choose_pivot(substituted, present, equation.others, 0.1)", "? choose_pivot(substituted, present, equation.candidates)", "scenes/guided_block"),
    ("walls of both bodies", "algebra/contact_constraints.cc", "           std::none_of(equation.others.begin(), equation.others.end(), is_held);", "           true;", "^algebra/contact_constraints$"),
    ("planes of one body", "solver/node_planes.cc", "return !is_shared(plane, interface, row);", "return false;", "scenes/guided_block_symmetry"),
    ("motions by inputs", "solver/contact_compliance.cc", "add(input, factor, all[0]);", "add(input, 0.5 * factor, all[0]);", "scenes/few_factorisations$"),
    ("order of responses", "solver/active_set_lookahead.cc", "responses.emplace(unknown[i], std::move(found[i]));", "responses.emplace(unknown[i], std::move(found[unknown.size() - 1 - i]));", "scenes/few_factorisations$"),
    ("columns from the first rank", "algebra/mumps.cc", "columns_of_all.Export(columns_on_first, to_first, Insert);", "columns_of_all.Update(1, columns_on_first, 0);", "scenes/ranks_greco"),
    ("values of a new factorisation", "algebra/mumps.cc", "*place++ = value; });", "*place = value; });", "^algebra/linear_solver$"),
    ("zones that stick are seen", "adaptivity/unseen_contact.cc", "sticking > enough_to_stick &&", "false &&", "scenes/sticking_middle$"),
    ("rest of an energy", "output/target_quantity.cc", "of_work * largest_work :", "0 :", "scenes/pressed_and_lifted_energy"),
    ("rest of a force", "output/target_quantity.cc", "of_force * largest_force :", "0 :", "scenes/pressed_and_lifted_total_force"),
    ("step by Adjust", "contact/declared_gap.cc", "p.gap < 2 * pair.adjust)", "p.gap < 0)", "scenes/step_by_adjust"),
    ("two signals at once", "base/stop_request.cc", "> at_once)", "> -1)", "^stopped$"),
    ("tip between the nodes", "adaptivity/gap_error.cc", "sum[f] / weights[f] - nearer", "sum[f] / weights[f]", "scenes/tip_by_displacement_small$"),
    ("round obstacle behind a side", "contact/overlap_search.cc", "return is_round &&", "return false &&", "scenes/round_obstacle_behind_a_side$"),
    ("a peak without limit", "adaptivity/quantity_sequence.cc", "change * before >= 0.8 * before * before", "false", "^adaptivity/mesh_difference$"),
    ("stick size by increments", "adaptivity/increment_error.cc", "return own_stick_size;", "return stick_size;", "^adaptivity/increment_choice$"),
    ("where the stick size is measured", "increments_for_target.cc", "history.record.resolves_stick()", "true", "scenes/stick_size_of_growing_contact_finite$"),
    ("view by rounding", "output/body_views.cc", "if (worth > most +", "if (most < 0 || worth > most +", "^output/body_picture$"),
    ("increments in the mesh's differences", "adaptivity/quantity_sequence.cc", "meshes.back().values[i] - before[i] : 0.", "0. : 0.", "^adaptivity/mesh_difference$"),
    ("shares of sent rows", "algebra/row_system.cc", ".emplace_back(dof, weight);", ".emplace_back(dof, 0.9 * weight);", "^scenes/ranks_"),
    ("cusps on the axis", "adaptivity/peak_error.cc", "far / near - 1.35", "far / near - 0.35", "scenes/cusp_on_the_axis_q2$"),
    ("steps of round bodies", "contact/overlap_search.cc", "keep_connected(*master, pieces);", ";", "scenes/steep_disks$"),
    ("pressures that no mesh knows", "small_strain_check.cc", "return pressures_are_known() && pressure > error_of_mesh &&", "return pressure > 0 &&", "scenes/sharp_punch_of_small_strain$"),
    ("the first gap", "contact/contact_interface.cc", "            first.size  = p.gap;\n", "            first.size  = 0 * p.gap;\n", "scenes/approach_across_a_gap_finite$"),
    ("chains of constraints", "discretization/elimination.cc", "line.coefficients[other] -= weight;", "line.coefficients[other] += weight;", "^algebra/contact_constraints$"),
    ("nodes of a pair beside", "contact/shared_nodes.cc", "claim->second.part > 0.5 * best &&", "claim->second.part > 2 * best &&", "scenes/split_slave_at_0.05$"),
    ("pairs behind", "contact/shared_nodes.cc", "both == 0 && are_beside(a, b, size)", "are_beside(a, b, size)", "scenes/overtaken_0$"),
    ("planes beside a contact", "contact/surface_fields.cc", "(interface.pair->tied || fields.multiplier[i] > 0) &&", "true &&", "scenes/pin_in_quarter_hole$"),
    ("gaps in another direction", "output/approach.cc", "return std::abs(normal * e) > along;", "return std::abs(normal * e) < along;", "scenes/(approach_of_passing_disks|pin_in_quarter_hole)$"),
    ("bodies that turn freely", "adaptivity/model_selection.cc", "/ (2 * sum[0]);", "/ (4 * sum[0]);", "scenes/small_strain_turned_freely$"),
    ("masters finer than slaves", "adaptivity/master_traction.cc", "finer / much), 4)", "finer / much), 0)", "scenes/master_finer_than_slave$"),
    ("cells as small as they can be", "adaptivity/mesh_sequence.cc", "lasting[1].error > 0.95 * lasting[0].error", "false", "scenes/sharp_punch_of_smallest_cells$"),
    ("meshes of small strain", "contact_problem.cc", "if (small_strain.keeps_meshes())", "if (false)", "scenes/two_indenters_change_late$"),
    ("contact that moves by kinematics", "contact_problem.cc", "if (small_strain.keeps_meshes())", "if (true)", "scenes/sliding_pad$"),
    ("errors of nothing", "adaptivity/mesh_sequence.cc", "error > 0 && std::isfinite(error)", "std::isfinite(error)", "(^adaptivity/mesh_difference|scenes/touched_late)$"),
    ("increments of the trial", "small_strain_check.cc", "constexpr unsigned int most_cut_backs = 4;", "constexpr unsigned int most_cut_backs = 0;", "scenes/small_strain_wrapped$"),
    ("middles of cubic edges", "geometry/gmsh.cc", "(9. * sum - nodes[i] - nodes[j]) / 16", "sum / 2", "^geometry/quadratic_faces$"),
    ("bounds of what opens", "solver/node_states.cc", "if (is_frozen && is_exhausted)", "if (false)", "scenes/thin_band_pulled_more_on_one_side$"),
    ("nodes without a bound", "solver/node_states.cc", "if (m.norm() < 1e-6 || limit <= 0)", "if (m.norm() < 1e-6)", "scenes/thin_band_pulled_more_on_one_side$"),
    ("obstacles in what changes", "small_strain_check.cc", "leave_out_carriers(model.discretization(), *v);", "(void)v;", "scenes/ring_in_turned_bore$"),
    ("supports through obstacles", "contact/supported_nodes.cc", "constexpr double        too_much = 0.1;", "constexpr double        too_much = 1e9;", "scenes/clamp_through_floor_small$"),
    ("methods without finite strain", "../include/amontons/small_strain_check.h", "rotations_are_held && !parameters.newton.collocates()", "rotations_are_held", "scenes/node_to_segment_with_large_strain$"),
    ("bodies behind planes", "contact/surface_search.cc", "return height < -0.1 *", "return height < -1e9 *", "^wrong_input$"),
    ("ends that move on", "contact/moving_states.cc", "parts.ends[e] += further * (parts.ends[e] - before.ends[e]);", "(void)further;", "^contact/moving_states$"),
    ("tractions at rest", "load_path.cc", "change.linfty_norm() > 1e-8 * old.linfty_norm()", "true", "scenes/wedge_self_lock$"),
    ("work of long increments", "run_notes.cc", "gap <= much * work.largest_work", "true", "scenes/wedge_self_lock$"),
    ("motion in the trial", "small_strain_check.cc", "FollowMotion::never", "FollowMotion::from_unstable", "scenes/column_of_disks$"),
    ("tractions that count as none", "solver/node_states.cc", "1e-4 * largest[nodes[k].interface])", "1e4 * largest[nodes[k].interface])", "^solver/node_states$"),
    ("pairs that stay", "adaptivity/mesh_difference.cc", "if (is_refined)", "if (true)", "scenes/three_shrunk_rings$"),
    ("hierarchies that lose", "algebra/linear_solver.cc", "amg_is_old = n_lost > new_hierarchy;", "amg_is_old = false;", "^algebra/linear_solver$"),
    ("tolerance for the target", "verification/run_scene.cc", "parameters.newton.suit_target(refinement.target_error);", ";", "scenes/target_and_tolerance$"),
    ("tolerance that is given", "solver/newton_step.cc", "!tolerance_is_given && method", "method", "scenes/target_and_given_tolerance$"),
    ("signed pressure about an edge", "contact/force_centre.cc", "all.spread > 0 && pushes.force > swings * all.force", "false", "scenes/target_half_punch$"),
    ("punches small beside faces", "contact/mortar_integrator.cc", "largest_share / 2", "1.", "scenes/target_narrow_punch$"),
    ("nodes beside edges of the slave", "output/physics_checks.cc", "surface.sharpest_edge > degrees && f", "false && f", "scenes/corner_tip_mean_normal$"),
    ("first meshes at small bodies", "model.cc", "times > 0 && i < most_times", "false && i < most_times", "scenes/small_stamp_"),
    ("steps of histories in space", "adaptivity/mesh_refinement.cc", "(has_history && reduction > largest_step)", "has_history", "scenes/steps_of_a_history_in_space$"),
    ("forces of corners", "run_notes.cc", "    note_corner_forces(ending);\n", "", "scenes/tilted_corner_finite_strain$"),
    ("pressures that were", "output/physics_checks.cc", "double largest = largest_so_far;", "double largest = 0;", "^output/quantities$"),
    ("factors that swing", "adaptivity/mesh_difference.cc", "may_grow ? of_coarser / factors.of_coarser : 1.", "of_coarser / factors.of_coarser", "^adaptivity/mesh_difference$"),
    ("facets of bodies in the stress", "adaptivity/bulk_error.cc", "if (degree == 1 && cell->at_boundary())", "if (false)", "scenes/round_column"),
    ("facets of bodies in the pressure", "adaptivity/error_estimator.cc", "const double square = std::pow(estimate.sections, 2) * pressure;", "const double square = 0 * pressure;", "scenes/round_column_linear$"),
    ("facets of bodies in forces", "evaluation.cc", "+ error.sections) / 2", ") / 2", "scenes/round_column_force_linear$"),
    ("facets that are given up", "load_program_retries.cc", "if (is_stopped() || !steps->wants_arcs())", "if (true)", "scenes/(round_column|twisted_columns)$"),
    ("hanging vertices on the circle", "discretization/discretization.cc", "if (mean.linfty_norm() <= 1e-14 * place.linfty_norm())", "if (true)", "^discretization/hanging_vertices$"),
    ("contact between the points", "adaptivity/unseen_contact.cc", "gaps.smallest = smallest_gap(interface, f, gaps, approach, interface.slave->moved);", "(void)may_be_near;", "scenes/wedge_between_nodes$"),
    ("second contact of a pair", "adaptivity/unseen_contact.cc", "!near[f] && may_touch && force > noteworthy", "false", "scenes/second_bump$"),
    ("obstacles that turn, near", "contact/surface_approach.cc", "(motion(y) - y)", "motion.b", "scenes/tilting_punch$"),
    ("approach of obstacles that turn", "output/approach.cc", "if (turned.A == shifted.A)", "if (true)", "scenes/tilting_punch$"),
    ("touched by the last mesh", "run_notes.cc", "return counts && mesh.pairs[i].touched;", "return mesh.pairs[i].touched;", "scenes/lifted_circle$"),
    ("unseen on the way", "evaluation.cc", "error.data = std::max(kept.data, error.data);", ";", "scenes/tilted_on_the_way$"),
    ("gaps of nodes are told", "output/summary.cc", "result.smallest_gap = smallest_gap_of(interface, fields, approach);", ";", "scenes/smooth_ring_between_walls$"),
    ("first gap at the points", "contact/contact_interface.cc", "gaps[f].range() > 1e-4 * size", "gaps[f].range() > 1e4 * size", "scenes/approach_from_first_gap$"),
    ("numbers at all increments", "load_stepping.cc", "(program.is_last() || refinement == Refinement::on_the_way)", "(true || program.is_last())", "scenes/size_of_growing_contact$"),
    ("heights behind facets", "../include/amontons/geometry/missing_volume.h", "2. / 3 * std::abs", "1. / 3 * std::abs", "^geometry/missing_volume$"),
    ("slender however turned", "discretization/degree.cc", "sum[dim + 1] / sum[0] - centre.square()", "sum[dim + 1] / sum[0]", "^discretization/degree$"),
    ("tension does not buckle", "adaptivity/model_selection.cc", "std::max(terms.buckling, most.by_compression)", "std::max(terms.buckling, most.any)", "scenes/half_strut"),
    ("corners on obstacles", "contact/contact_interface.cc", "      hold_end_normals(interface);\n", "      ;\n", "scenes/corner_tip$"),
    ("corners at small strain", "../include/amontons/contact/common_normal.h", "(end_presses(interface) ||", "(", "scenes/(corner_tip_small_strain|tilted_corner)$"),
    ("ends at planes of symmetry", "contact/common_normal.cc", "surface.nodes[i].symmetry_planes.empty()", "true", "scenes/(hertz|corner_tip)"),
    ("ends that lean on nothing", "contact/common_normal.cc", "leaning = 0.01,", "leaning = -1,", "scenes/short_roller$"),
    ("supports that turn", "output/approach.cc", "turn<dim>(sums) > noteworthy_turn", "false", "scenes/turned_blocks$"),
    ("small strain that is no answer", "small_strain_check.cc", "(is_no_answer || recovery", "(recovery", "scenes/passing_disks_friction$"),
    ("factors of nearly incompressible bodies", "algebra/linear_solver.cc", "purpose.nearly_incompressible ? 30000 : purpose", "purpose", "scenes/nearly_incompressible_in_space$"),
    ("cells that contact has left", "adaptivity/mesh_coarsening.cc", "child->set_coarsen_flag();", "(void)child;", "^adaptivity/error_estimator$"),
    ("cells of the first mesh", "adaptivity/mesh_coarsening.cc", "&& first.count(cell->id()) == 0)", "&& true)", "^adaptivity/error_estimator$"),
    ("meshes that follow", "model.cc", "    mark_cells_to_coarsen(", "    if (false) mark_cells_to_coarsen(", "scenes/followed_slide$"),
    ("flags of other ranks", "adaptivity/mesh_coarsening.cc", "coarse.count(cell->parent()->id()) > 0)", "false)", "scenes/ranks_followed_slide$"),
    ("meshes that measure increments", "error_of_increments.cc", "    replay.refinement.max_dofs = mesh->discretization->dof_handler.n_dofs();\n", "", "scenes/followed_and_let_go$"),
    ("numbers of whole histories", "contact_problem.cc", 'quantity != "contact pressure")', "false)", "scenes/followed_slide_force$"),
    ("flat contacts of numbers", "model.cc", "flat_too = dim == 2 || !always_converges(parameters.target_quantity)", "flat_too = false", "scenes/block_on_larger_slave$"),
    ("slivers without factors", "contact/pressure_projection.cc", "{0., 1e-10}", "{0.}", "^contact/surface_fields$"),
    ("arcs of a circle", "discretization/free_turns.cc", "if (geometry.of_second_order[body])", "if (false)", "^discretization/free_slides$"),
    ("seams of a mesh", "contact_problem.cc", "for (const auto &sentence : bodies_in_parts(scene, mesh->geometry))", "for (const std::string sentence : std::vector<std::string>())", "wrong_input"),
    ("lines of three nodes", "geometry/abaqus.cc", "        if (t.dim == 1)", "        if (false)", "^geometry/grid_reader$"),
    ("ovals beside circles", "discretization/free_turns.cc", "dim == 3 ? 0.1 : 1e-5;", "dim == 3 ? 0.1 : 5e-3;", "^discretization/free_slides$"),
    ("parts that hinge", "geometry/body_parts.cc", "of_vertex.at(other->second) != parts", "other->second != vertex && of_vertex.at(other->second).empty()", "wrong_input"),
    ("sizes of small contacts", "adaptivity/small_contacts.cc", "std::cbrt(0.75 * forces[f]", "std::cbrt(75 * forces[f]", "^adaptivity/small_contacts$"),
    ("numbers beside unseen ones", "adaptivity/quantity_sequence.cc", "      meshes = {*unseen};", "      ;", "scenes/plate_on_three_balls$"),
    ("the second tangent", "solver/active_set_lookahead.cc", "if ((dim == 3 || input == NodeInput::along) &&", "if (input == NodeInput::along &&", "scenes/plate_on_three_balls$"),
    ("shear across the slip", "solver/contact_compliance.cc", "unbalanced(dof) += node.area * q[c] * weight;", "(void)weight;", "scenes/twisted_ball$"),
    ("nodes on chords", "contact/smallest_gap.cc", "parents; parents.empty())", "parents; parents.empty() || true)", "scenes/pin_longer_than_its_seat$"),
    ("facets of declared gaps", "adaptivity/error_estimator.cc", "finite_strain || !interfaces[i].pair->initial_gap", "true", "scenes/shaft_and_hub$"),
    ("parts of a mesh file", "geometry/gmsh.cc", "if (t.dim == dim && !is_of_part(groups))", "if (t.dim == dim && !is_of_part(groups) && false)", "^geometry/grid_reader$"),
    ("parts of an assembly", "geometry/abaqus_names.cc", "return instances.count(upper) > 0 && upper != instance;", "return instances.count(upper) > 0;", "^geometry/grid_reader$"),
    ("works of overlaps", "run_notes.cc", "pair.initial_gap->value(Point<3>(), 0) < 0;", "pair.initial_gap->value(Point<3>(), 0) > 1e300;", "scenes/shaft_and_hub_finite$"),
    ("changes between meshes", "adaptivity/quantity_sequence.cc", "return meshes.empty() ? 0 : change_since(0);", "return 0;", "^adaptivity/mesh_difference$"),
    ("peaks of slivers", "contact/surface_fields.cc", "value = most < 0 ? value : std::min(value, most);", "(void)most;", "scenes/pin_longer_than_its_seat$"),
    ("carriers far away", "geometry/geometry.cc", "constexpr double far = 100;", "constexpr double far = 1e100;", "scenes/far_from_its_carrier$"),
    ("sections that are driven", "solver/symmetry_planes.cc", "is_driven = is_driven || (was_in_plane && is_beyond);", "(void)is_beyond;", "^solver/symmetry_planes$"),
    ("ends of lines", "adaptivity/unseen_contact.cc", "if (n_faces[i] == 1 &&", "if (n_faces[i] == 9 &&", "scenes/rough_leaves$"),
    ("ends on planes", "adaptivity/unseen_contact.cc", "n_faces[i] == 1 && !surface.nodes[i].is_on_plane", "n_faces[i] == 1", "^adaptivity/unseen_contact$"),
    ("edges at rest", "adaptivity/unseen_contact.cc", "centre += interface.slave->nodes[n].X /", "centre += interface.slave->nodes[n].x /", "scenes/rough_leaves"),
    ("gaps of rounding", "evaluation.cc", "(!was_seen && doubt > 0 && smallest", "(!was_seen && smallest", "scenes/rough_leaves_let_go$"),
]


def chosen(only, names):
    """Indices of the changes with these names that are wanted."""
    if not only:
        return list(range(len(names)))
    result = []
    for word in only.split(","):
        numbers = re.fullmatch(r"(\d+)(?:-(\d+))?", word.strip())
        if numbers:
            first, last = int(numbers.group(1)), int(numbers.group(2) or numbers.group(1))
            result += range(first - 1, min(last, len(names)))
        else:
            result += [i for i, name in enumerate(names) if word.strip() in name]
    return result


def synchronise(scratch):
    """Makes the files of this tree those of the scratch copy; files that are alike keep their time."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=TREE, stdout=subprocess.PIPE, check=True, universal_newlines=True).stdout
    names = [name for name in listed.split("\n") if name and os.path.exists(os.path.join(TREE, name))]
    for name in names:
        source, target = os.path.join(TREE, name), os.path.join(scratch, name)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        with open(source, "rb") as file:
            text = file.read()
        if os.path.exists(target):
            with open(target, "rb") as file:
                if file.read() == text:
                    continue
        shutil.copy(source, target)
    for top in "source", "include", "tests", "parameters":
        for folder, _, files in os.walk(os.path.join(scratch, top)):
            for file in files:
                name = os.path.relpath(os.path.join(folder, file), scratch)
                if name not in names and "__pycache__" not in name:
                    os.remove(os.path.join(scratch, name))


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS + 5))


class Scratch:
    def __init__(self, folder, jobs):
        self.folder, self.build, self.jobs = folder, os.path.join(folder, "build"), jobs

    def run(self, command, timeout=None, environment=()):
        """Exit code (None: not done in time) and output; nothing is left running."""
        process = subprocess.Popen(command, cwd=self.build, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True, env=dict(os.environ, **dict(environment)),
                                   preexec_fn=limit)
        try:
            text = process.communicate(timeout=timeout)[0]
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            process.communicate()
            return None, ""
        return process.returncode, text.decode(errors="replace")

    def tests(self, regex):
        """[(name, command, target, environment)], unit tests first."""
        with open(os.path.join(self.build, "tests", "CTestTestfile.cmake")) as stream:  # ctest itself says no commands of what is not built yet
            text = stream.read()
        environments = {name: [pair.split("=", 1) for pair in words.split(";")]
                        for name, words in re.findall(r'(?m)^set_tests_properties\((?:\[=\[)?(\S*?)(?:\]=\])? PROPERTIES  .*?\bENVIRONMENT "(.*?)"', text)}
        result = []
        for name, words in re.findall(r'(?m)^add_test\((?:\[=\[)?(.*?)(?:\]=\])? ("(?:[^"\\]|\\.)*"(?: "(?:[^"\\]|\\.)*")*)\)$', text):
            if not re.search(regex, name):
                continue
            command = [re.sub(r"\\(.)", r"\1", word) for word in re.findall(r'"((?:[^"\\]|\\.)*)"', words)]
            programs = [word for word in command if os.path.dirname(word) in (self.build, os.path.join(self.build, "tests"))]
            result.append((name, command, os.path.basename(programs[0]) if programs else None, environments.get(name, ())))
        return sorted(result, key=lambda test: (test[0].startswith("scenes/"), test[0]))

    def make(self, targets):
        return self.run(["ninja", f"-j{self.jobs}"] + sorted({t for t in targets if t}))

    def first_failure(self, tests):
        """Name of a test that fails, or None."""
        with concurrent.futures.ThreadPoolExecutor(self.jobs) as pool:
            running = {pool.submit(self.run, command, PATIENCE, environment): name for name, command, _, environment in tests}
            for done in concurrent.futures.as_completed(running):
                if not done.cancelled() and done.result()[0] != 0:
                    for other in running:
                        other.cancel()
                    code, text = done.result()
                    return running[done] + (" (not done in time)" if code is None or LATE.search(f"{code} {text}") else "")
        return None

    def objects(self):
        """(compiled file, where a copy of it is kept)."""
        for folder, _, files in os.walk(self.build):
            for path in (os.path.join(folder, file) for file in files if file.endswith(".o")):
                yield path, os.path.join(self.folder, "kept", os.path.relpath(path, self.build))

    def keep_objects(self):
        """What the unchanged tree was compiled to."""
        for path, kept in self.objects():
            if not os.path.exists(kept) or os.path.getmtime(kept) != os.path.getmtime(path):
                os.makedirs(os.path.dirname(kept), exist_ok=True)
                shutil.copy2(path, kept)

    def put_back_objects(self, since):
        """Those that were compiled since. ninja wants the times that it has noted; what was linked of them is to be linked again."""
        for path, kept in list(self.objects()):
            times = os.stat(path)
            if times.st_mtime >= since and os.path.exists(kept):
                shutil.copy(kept, path)
                os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            elif times.st_mtime >= since:
                os.remove(path)
        for folder in self.build, os.path.join(self.build, "tests"):
            for entry in list(os.scandir(folder)):
                if entry.is_file() and entry.stat().st_mtime >= since and (entry.name.endswith(".a") or os.access(entry.path, os.X_OK)):
                    os.remove(entry.path)

    @contextlib.contextmanager
    def changed(self, file, text):
        """The file, relative to the tree, reads so for a while; afterwards all is as it was, so that nothing but links is to be made again."""
        path, since = os.path.join(self.folder, file), time.time()
        times = os.stat(path)
        with open(path) as stream:
            before = stream.read()
        with open(path, "w") as stream:
            stream.write(text)
        try:
            yield
        finally:
            with open(path, "w") as stream:
                stream.write(before)
            os.utime(path, ns=(times.st_atime_ns, times.st_mtime_ns))
            self.put_back_objects(since)

    def first_noticed(self, parts):
        """(verdict, what) of the lists of tests, each built and thrown as long as those before notice nothing."""
        for part in parts:
            code, output = self.make(t[2] for t in part) if part else (0, "")
            if code != 0:
                return "does not compile", output[-1500:]
            failure = self.first_failure(part)
            if failure:
                return "noticed", failure
        return "unnoticed", f"{sum(len(part) for part in parts)} tests"


class Listed:
    """The changes above, each with its tests."""

    def __init__(self):
        self.names = [change[0] for change in CHANGES]

    def told(self, i):
        return f"{CHANGES[i][0]:45} {CHANGES[i][1]}"

    def tests(self, scratch, i):
        """Unit tests alone, as long as they notice."""
        tests = scratch.tests(CHANGES[i][4])
        return [[t for t in tests if not t[0].startswith("scenes/")], [t for t in tests if t[0].startswith("scenes/")]]

    def attempt(self, scratch, i):
        """(verdict, what): noticed, unnoticed, "does not compile", "no longer there", "no tests"."""
        _, file, old, new, regex = CHANGES[i]
        file = os.path.normpath(os.path.join("source", file))
        with open(os.path.join(scratch.folder, file)) as stream:
            text = stream.read()
        if text.count(old) != 1:
            return "no longer there", f"{text.count(old)} times in {file}"
        parts = self.tests(scratch, i)
        if not any(parts):
            return "no tests", regex
        with scratch.changed(file, text.replace(old, new)):
            return scratch.first_noticed(parts)


class Lot:
    """Changes that are drawn by lot, after which all tests are thrown; more of them than are wanted, since some do not compile."""

    def __init__(self, tree, seed, n_nets):
        self.tree, self.n_nets = tree, n_nets
        self.places = mutation_lot.drawn(tree, seed)
        self.names = [place.file for place in self.places]

    def text(self, i):
        with open(os.path.join(self.tree, self.places[i].file)) as stream:
            return stream.read()

    def told(self, i):
        return mutation_lot.told(self.places[i], self.text(i))

    def tests(self, scratch, i):
        return [tests for _, tests in mutation_lot.tests_of_nets(scratch.tests(""), mutation_lot.folder_of(self.places[i].file))][:self.n_nets]

    def attempt(self, scratch, i):
        place, text = self.places[i], self.text(i)
        with scratch.changed(place.file, text[:place.begin] + place.new + text[place.end:]):
            return scratch.first_noticed(self.tests(scratch, i))


def arguments_of_command():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--lot", type=int, default=0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--nets", type=int, default=None)
    parser.add_argument("--scratch", default=os.path.join(tempfile.gettempdir(), "amontons-mutation"))
    parser.add_argument("-j", type=int, default=2)
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--unchecked", action="store_true")
    return parser.parse_args()


def made_ready(folder, jobs):
    """The scratch copy, configured."""
    if os.path.exists(folder) and os.path.samefile(folder, TREE) or folder.startswith(TREE + os.sep):
        sys.exit("the scratch copy must lie outside of the working tree")
    scratch = Scratch(folder, jobs)
    os.makedirs(scratch.build, exist_ok=True)
    synchronise(folder)
    code, text = scratch.run(["cmake", "-S", folder, "-B", scratch.build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DAMONTONS_UNITY=OFF", "-DAMONTONS_OPTIMISATION=-O1"])
    if code != 0:
        sys.exit(text)
    return scratch


def prepare(scratch, changes, numbers, unchecked):
    """What is thrown after the changes is built, and must pass without them."""
    every = {test[0]: test for i in numbers for part in changes.tests(scratch, i) for test in part}
    code, text = scratch.make(test[2] for test in every.values())
    if code != 0:
        sys.exit(text)
    scratch.keep_objects()
    failure = None if unchecked else scratch.first_failure(list(every.values()))
    if failure:
        sys.exit(f"{failure} fails without any change")


def main():
    arguments = arguments_of_command()
    scratch = None if arguments.list else made_ready(os.path.abspath(arguments.scratch), arguments.j)
    # of the copy: the working tree may change meanwhile
    changes = Lot(scratch.folder if scratch else TREE, arguments.seed, arguments.nets) if arguments.lot else Listed()
    numbers = chosen(arguments.only, changes.names)
    wanted = min(arguments.lot or len(numbers), len(numbers))
    if arguments.list:
        for i in numbers[:wanted]:
            print(f"{i + 1:3} {changes.told(i)}")
        return
    prepare(scratch, changes, numbers[:wanted], arguments.unchecked)
    score = {}
    for i in numbers:
        start = time.time()
        verdict, what = changes.attempt(scratch, i)
        score.setdefault(verdict, []).append(i)
        print(f"{verdict.upper() if verdict != 'noticed' else verdict:16} {i + 1:3} {changes.told(i)} {what} ({time.time() - start:.0f} s)", flush=True)
        if arguments.lot and verdict == "does not compile":
            continue
        wanted -= 1
        if wanted == 0:
            break
    tried = len(score.get("noticed", [])) + len(score.get("unnoticed", []))
    print(f"\n{len(score.get('noticed', []))} of {tried} changes noticed" + "".join(f"; {len(v)} {k}" for k, v in score.items() if k not in ("noticed", "unnoticed")))
    sys.exit(0 if len(score.get("noticed", [])) == tried == sum(len(v) for k, v in score.items() if not arguments.lot or k != "does not compile") else 1)


if __name__ == "__main__":
    main()
