# Scenes with the checks of their answers: add_scene_test(NAME name SCENE file RANKS n SET "Section/Name=value"... CHECK "path OP value"... [FAILS] [READ_BACK])
# and add_comparison_test(NAME name SCENE file SET ... RUN "ranks | Section/Name=value"... CHECK (of the first run) OPTIONS ...). Files are relative to
# parameters/. Starting the program costs as much as a small scene takes: one run is checked for all that it shows, and what varies (degree, side of the
# slave, angle, ...) is varied once for each thing that may depend on it, not in all combinations.
# READ_BACK: all that is written is read and compared with the summary (tests/read_back.py); else neither VTU nor report are written.
set(SCENE_QUIET "Output/VTU=false" "Output/Report=false")

function(add_scene_test)
  cmake_parse_arguments(T "FAILS;READ_BACK" "NAME;SCENE;RANKS" "SET;CHECK" ${ARGN})
  if(NOT T_RANKS)
    set(T_RANKS 1)
  endif()
  set(arguments)
  foreach(text IN LISTS T_SET)
    list(APPEND arguments --set "${text}")
  endforeach()
  foreach(text IN LISTS T_CHECK)
    list(APPEND arguments --check "${text}")
  endforeach()
  if(T_FAILS)
    list(APPEND arguments --fails)
  endif()
  if(T_READ_BACK)
    list(APPEND arguments --read-back)
  endif()
  add_test(NAME scenes/${T_NAME}
           COMMAND ${AMONTONS_PYTHON} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/run_scene.py $<TARGET_FILE:amontons> ${CMAKE_BINARY_DIR}/scenes/${T_NAME}
                   ${T_RANKS} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../parameters/${T_SCENE} ${arguments})
  set_tests_properties(scenes/${T_NAME} PROPERTIES PROCESSORS ${T_RANKS} TIMEOUT 400)
endfunction()

function(add_comparison_test)
  cmake_parse_arguments(T "" "NAME;SCENE" "SET;RUN;CHECK;OPTIONS" ${ARGN})
  set(arguments ${T_OPTIONS})
  foreach(text IN LISTS SCENE_QUIET T_SET)
    list(APPEND arguments --set "${text}")
  endforeach()
  foreach(text IN LISTS T_RUN)
    list(APPEND arguments --run "${text}")
  endforeach()
  foreach(text IN LISTS T_CHECK)
    list(APPEND arguments --check "${text}")
  endforeach()
  add_test(NAME scenes/${T_NAME}
           COMMAND ${AMONTONS_PYTHON} ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/compare_runs.py $<TARGET_FILE:amontons> ${CMAKE_BINARY_DIR}/scenes/${T_NAME}
                   ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../parameters/${T_SCENE} ${arguments})
  # One run after the other: two processors only where one of them has several ranks.
  set(processors 1)
  if(T_RUN MATCHES "(^|;)[2-9]")
    set(processors 2)
  endif()
  set_tests_properties(scenes/${T_NAME} PROPERTIES PROCESSORS ${processors} TIMEOUT 400 COST 5)
endfunction()

set(EXACT "reference.errors.pressure_l2 <= 1e-10" "reference.errors.nodal_peak_pressure <= 1e-10" "checks.force_balance <= 1e-8")
set(ITERATIONS "newton.0.iterations <= 12" "newton.1:.iterations <= 4")

# ---- Patch tests

foreach(degree 1 2)
  foreach(slave first second)
    set(both "Discretization/Degree=${degree}" "Contact interface/Slave=${slave}")
    # Ten faces on one, or one on ten, turned.
    set(ratio 1_to_10 "Body upper/Cells=1,3" "Body lower/Cells=10,5")
    if(degree EQUAL 2)
      set(ratio 10_to_1 "Body upper/Cells=10,3" "Body lower/Cells=1,5")
    endif()
    list(POP_FRONT ratio name)
    add_scene_test(NAME patch_q${degree}_${slave}_${name} SCENE verification/patch_pressure.prm
                   SET ${both} ${ratio} "Body upper/Rotate=17" "Body lower/Rotate=17" CHECK ${EXACT})
    # The error estimate of an exact solution is rounding: it refines here and there.
    add_scene_test(NAME patch_q${degree}_${slave}_hanging_nodes SCENE verification/patch_hanging_nodes.prm
                   SET ${both} "Refinement/Cycles=1" CHECK ${EXACT})
    add_scene_test(NAME patch_q${degree}_${slave}_punch SCENE verification/patch_punch.prm SET ${both}
                   CHECK ${EXACT} "error_estimate.contact <= 1e-10")
    # The punch ends a little beyond a node of the foundation.
    set(slivers 1.200000001 1.20001)
    if(slave STREQUAL first)
      math(EXPR k "${degree}-1")
      list(GET slivers ${k} slivers)
    endif()
    foreach(sliver ${slivers})
      add_scene_test(NAME patch_q${degree}_${slave}_sliver_${sliver} SCENE verification/patch_punch.prm
                     SET ${both} "Body punch/Lower corner=0.6,0" "Body punch/Upper corner=${sliver},1" "Body foundation/Cells=10,5"
                         "Reference/Solution=uniform(p=5,x=0.9,width=0.3)"
                     CHECK ${EXACT})
    endforeach()
  endforeach()
endforeach()
# Methods to compare with. Penalty: a uniform pressure p makes the overlap p (1 - nu^2) h/(factor E) (checks.penetration: over h, of the lower block, p = 5).
# Node to segment passes the patch test on matching meshes only.
add_scene_test(NAME patch_penalty SCENE verification/patch_pressure.prm
               SET "Contact solver/Method=penalty" "Contact solver/Penalty factor=20" "Contact interface/Slave=second"
               CHECK ${EXACT} "checks.penetration ~ 2.4e-3 1e-12")
add_scene_test(NAME patch_node_to_segment SCENE verification/patch_pressure.prm
               SET "Contact solver/Method=node-to-segment" "Body lower/Cells=5,5" CHECK ${EXACT})
add_scene_test(NAME patch_node_to_segment_other_mesh SCENE verification/patch_pressure.prm
               SET "Contact solver/Method=node-to-segment" CHECK "reference.errors.pressure_l2 >= 1e-3" "checks.force_balance <= 1e-8" "pairs.0.normal_force.1 ~ -10 1e-10")
# Finite strain is no alternative to these: what small strain leaves out is told, and nothing is tried (which ended as wrong input, the bodies overlapping by then).
add_scene_test(NAME node_to_segment_with_large_strain SCENE hertz_cylinder.prm FAILS
               SET "Contact solver/Method=node-to-segment" "Body block/Young modulus=1e3" "Refinement/Target error=0" "Refinement/Cycles=0"
               CHECK "failure has small strain" "message has finite strain needs another 'Contact solver/Method'")
# Augmented Lagrangian and the fixed point of friction have the answer of the mortar; the seed that of node-to-segment, where it has one.
add_scene_test(NAME patch_augmented_lagrangian SCENE verification/patch_pressure.prm
               SET "Contact solver/Method=augmented Lagrangian" CHECK ${EXACT} "checks.penetration <= 1e-10" "newton.0.outer_iterations == 2")
add_comparison_test(NAME augmented_lagrangian_hertz SCENE hertz_cylinder.prm SET "Refinement/Cycles=0" "Refinement/Initial refinements=5" OPTIONS --any-iterations
                    RUN 1 "1 | Contact solver/Method=augmented Lagrangian")
add_scene_test(NAME augmented_lagrangian_finite SCENE verification/press_finite.prm SET "Contact solver/Method=augmented Lagrangian"
               CHECK "reference.errors.nodal_peak_pressure <= 1e-9" "newton.:.outer_iterations <= 10")
foreach(method "augmented Lagrangian" "fixed-point friction")
  string(MAKE_C_IDENTIFIER "${method}" name)
  add_scene_test(NAME patch_friction_${name} SCENE verification/patch_friction.prm
                 SET "Contact solver/Method=${method}" CHECK ${EXACT} "checks.coulomb_cone <= 1e-9" "pairs.0.n_stick == 0" "pairs.0.n_open == 0")
  add_comparison_test(NAME greco_${name} SCENE greco.prm SET "Refinement/Cycles=0" OPTIONS --any-iterations RUN 1 "1 | Contact solver/Method=${method}")
  add_comparison_test(NAME floating_slab_3d_${name} SCENE verification/floating_slab_3d.prm
                      SET "Refinement/Cycles=0" "Contact base/Friction coefficient=0.2" OPTIONS --any-iterations RUN 1 "1 | Contact solver/Method=${method}")
endforeach()
# Klarbring's node slips from p = 1 to the fixed point of p = 1 - (r - mu p)/kappa: each bound leaves the part mu/kappa = 9/19 of the error, 28 for 1e-9.
# With mu = 2 it leaves 18/19, for which 60 are too few.
set(FIXED_POINT "Contact solver/Method=fixed-point friction")
add_scene_test(NAME fixed_point_klarbring SCENE verification/klarbring.prm SET ${FIXED_POINT}
               CHECK "newton.-1.outer_iterations >= 26" "newton.-1.outer_iterations <= 30" "pairs.0.normal_force.1 ~ 0.55 1e-8")
add_scene_test(NAME fixed_point_klarbring_unsettled SCENE verification/klarbring.prm FAILS
               SET ${FIXED_POINT} "Contact base/Friction coefficient=2" "Minimum increment=0.25" "Boundary condition push/Value=2.05*table(0.5: 0, 1: 1)|-table(0: 0, 0.5: 1)"
               CHECK "failure has bounds unsettled" "message has fixed-point friction: what the bounds of friction bear still changes by" "newton.-1.outer_iterations == 60")
add_comparison_test(NAME seed_floating_slab SCENE floating_slab.prm SET "Refinement/Cycles=0" "Contact base/Friction coefficient=0.2" OPTIONS --any-iterations
                    RUN "1 | Contact solver/Method=node-to-segment" "1 | Contact solver/Method=seed" "1 | Contact solver/Method=seed | Increments=20")
add_comparison_test(NAME seed_cattaneo_mindlin SCENE cattaneo_mindlin.prm SET "Refinement/Cycles=0" "Refinement/Initial refinements=7" OPTIONS --any-iterations
                    RUN "1 | Contact solver/Method=node-to-segment | Increments=16" "1 | Contact solver/Method=seed | Increments=16")
# Where it has none: sets that come back, whatever the increment; nodes that all slip; and slip that the load turns round.
add_scene_test(NAME seed_greco SCENE greco.prm FAILS SET "Contact solver/Method=seed" "Refinement/Cycles=0" "Increments=100" "Minimum increment=0.01"
               CHECK "failure has seed unsettled" "message has nodes still change")
add_scene_test(NAME seed_slides SCENE verification/floating_slab_3d.prm FAILS SET "Contact solver/Method=seed" "Refinement/Cycles=0" "Contact base/Friction coefficient=0.2"
               CHECK "failure has seed unsettled" "message has by its rules all nodes slip that could hold the rigid motion")
# A bar is unloaded to half of its load: u = F^2/(2 EA tau) (1 - (1/2)^2/2) = 0.04375 at its end (0.0439 here). The seed's nodes slip on, forward, and say so.
add_scene_test(NAME seed_microslip_turned SCENE microslip_bar.prm SET "Contact solver/Method=seed" "Refinement/Cycles=0" "End time=1.25" "Output times=1" "Increments=10"
               CHECK "status is converged" "probes.0.points.0.displacement.0 <= 0.035" "notes.1 has nodes slip against their friction" "checks.slip_direction >= 1")
add_scene_test(NAME penalty_friction_3d SCENE verification/patch_friction_3d.prm
               SET "Contact solver/Method=penalty" "Contact solver/Penalty factor=1e6" CHECK "reference.errors.pressure_l2 <= 1e-6" "checks.coulomb_cone <= 1e-9")
add_scene_test(NAME penalty_finite SCENE verification/press_finite.prm
               SET "Contact solver/Method=penalty" "Contact solver/Penalty factor=1e5" "Contact solver/Tolerance=1e-9"
               CHECK "reference.errors.nodal_peak_pressure <= 1e-5" "newton.0:.iterations <= 5")
# Both components of the normals are alike.
foreach(case "1;first" "2;second")
  list(GET case 0 degree)
  list(GET case 1 slave)
  add_scene_test(NAME patch_q${degree}_${slave}_turned_45 SCENE verification/patch_pressure.prm
                 SET "Discretization/Degree=${degree}" "Contact interface/Slave=${slave}" "Body upper/Rotate=45" "Body lower/Rotate=45" CHECK ${EXACT})
endforeach()
add_scene_test(NAME patch_q1_displacement SCENE patch_test.prm SET "Discretization/Degree=1" CHECK ${EXACT})
add_scene_test(NAME patch_q2_plane_stress SCENE verification/patch_pressure.prm SET "Kind=plane stress" "Discretization/Degree=2" CHECK ${EXACT})
add_scene_test(NAME patch_q2_confined SCENE verification/patch_confined.prm SET "Discretization/Degree=2" CHECK ${EXACT})
# Nodes lie on nodes: the wall holds the upper block through the lower one, whichever is the slave.
foreach(slave first second)
  set(guided SCENE verification/guided_block.prm)
  add_scene_test(NAME guided_block_${slave} ${guided} SET "Contact interface/Slave=${slave}"
                 CHECK "energy ~ 49.5846205664 1e-9" "meshes.-1.dissipation ~ 0.3773330506 1e-7" "pairs.0.n_stick == 8" "pairs.0.n_slip == 1")
  add_scene_test(NAME guided_block_symmetry_${slave} ${guided} SET "Contact interface/Slave=${slave}" "Boundary condition wall/Type=symmetry" "Boundary condition wall/Value="
                 CHECK "energy ~ 49.5846205664 1e-9" "meshes.-1.dissipation ~ 0.3773330506 1e-7")
  add_scene_test(NAME guided_block_finite_${slave} ${guided} SET "Contact interface/Slave=${slave}" "Kinematics=finite strain"
                 CHECK "energy ~ 48.695 1e-4" "pairs.0.n_stick == 8" "pairs.0.n_slip == 1")
  add_scene_test(NAME guided_block_tied_${slave} ${guided} SET "Contact interface/Slave=${slave}" "Contact interface/Friction coefficient=" "Contact interface/Tied=true"
                 CHECK "energy ~ 49.4164065871 1e-9")
  add_scene_test(NAME guided_block_tied_finite_${slave} ${guided} SET "Contact interface/Slave=${slave}" "Contact interface/Friction coefficient=" "Contact interface/Tied=true" "Kinematics=finite strain"
                 CHECK "energy ~ 48.306159179 1e-9")
  set(in_space "Kind=3D" "Body lower/Lower corner=0, 0, -5" "Body lower/Upper corner=10, 10, 0" "Body lower/Cells=3, 3, 1" "Body upper/Lower corner=0, 0, 0" "Body upper/Upper corner=10, 10, 5" "Body upper/Cells=3, 3, 1"
               "Boundary condition bottom/Value=0|0|0" "Boundary condition wall/Value=0|free|free" "Boundary condition load/Value=200*t|100*t|-3000*t" "End time=1")
  add_scene_test(NAME guided_block_3d_${slave} ${guided} SET ${in_space} "Contact interface/Slave=${slave}" "Boundary condition wall/Boundaries=upper/left" "Contact interface/Friction coefficient=0.3"
                 CHECK "energy ~ 534.365904507 1e-9")
  add_scene_test(NAME guided_block_tied_3d_${slave} ${guided} SET ${in_space} "Contact interface/Slave=${slave}" "Contact interface/Friction coefficient=" "Contact interface/Tied=true"
                 CHECK "energy ~ 540.37705984 1e-9")
endforeach()
add_scene_test(NAME two_punches_q1 SCENE verification/two_punches.prm SET "Discretization/Degree=1" CHECK ${EXACT})
add_scene_test(NAME three_blocks_q1 SCENE three_blocks.prm SET "Discretization/Degree=1" CHECK ${EXACT})
add_scene_test(NAME patch_stiffness_1e6 SCENE verification/patch_pressure.prm
               SET "Body upper/Young modulus=1e3" "Body lower/Young modulus=1e9" CHECK ${EXACT})
# The stiff body rides on the soft one by 1e7 of its own deformation, which a double knows to 2e-9: each difference across its cells is wrong by 2e-9, and a
# force adds up some ten of them (1.5e-8 measured).
add_scene_test(NAME patch_stiffness_1e-6 SCENE verification/patch_pressure.prm
               SET "Body upper/Young modulus=1e9" "Body lower/Young modulus=1e3"
               CHECK "reference.errors.pressure_l2 <= 4e-8" "reference.errors.nodal_peak_pressure <= 4e-8")

# ---- Patch tests in space

set(AXIS "Rotation axis=1,2,3")
set(TURNED_45 "Body upper/Rotate=45" "Body upper/${AXIS}" "Body lower/Rotate=45" "Body lower/${AXIS}")
# The nodal peak is a value of the projected pressure where nothing covers the face: it continues a pressure that is known on a small part of
# it, which magnifies rounding (2e-7 measured).
set(EXACT_WHERE_COVERED "reference.errors.pressure_l2 <= 1e-10" "reference.errors.nodal_peak_pressure <= 1e-5" "checks.force_balance <= 1e-8")
foreach(degree 1 2)
  foreach(slave first second)
    set(both "Discretization/Degree=${degree}" "Linear solver/Type=direct" "Contact interface/Slave=${slave}")
    set(name patch_3d_q${degree}_${slave})
    # 1e-12 to 7e-11 measured on meshes of this kind: the formula follows the distortion
    add_scene_test(NAME ${name}_irregular_turned_45 SCENE verification/patch_3d_irregular.prm SET ${both} ${TURNED_45} CHECK ${EXACT})
    if(degree EQUAL 1)
      add_scene_test(NAME ${name}_1_to_10 SCENE verification/patch_3d_pressure.prm
                     SET ${both} "Body upper/Cells=1,1,1" "Body lower/Cells=10,8,1" ${TURNED_45} CHECK ${EXACT})
    else()
      add_scene_test(NAME ${name}_10_to_1 SCENE verification/patch_3d_pressure.prm
                     SET ${both} "Body upper/Cells=10,8,1" "Body lower/Cells=1,1,1" CHECK ${EXACT})
    endif()
    add_scene_test(NAME ${name}_hanging_nodes SCENE verification/patch_3d_hanging_nodes.prm
                   SET ${both} "Refinement/Cycles=1" CHECK ${EXACT})
    # In the directions z, y and beyond two edges of the foundation.
    add_scene_test(NAME ${name}_punch SCENE verification/patch_3d_punch.prm SET ${both}
                   CHECK ${EXACT_WHERE_COVERED} "error_estimate.contact <= 1e-10")
    if("${degree} ${slave}" MATCHES "1 first|2 second")
      add_scene_test(NAME ${name}_punch_along_y SCENE verification/patch_3d_punch.prm
                     SET ${both} "Body punch/Lower corner=0.9,0,0.7" "Body punch/Upper corner=2.13,1,1.57" "Body punch/Cells=3,2,2"
                         "Body foundation/Lower corner=0,-2,0" "Body foundation/Upper corner=3,0,2" "Body foundation/Cells=5,2,4"
                         "Boundary condition load/Boundaries=punch/back, foundation/back"
                         "Boundary condition planes/Boundaries=punch/left, foundation/left, punch/bottom, foundation/bottom, foundation/front"
                         "Contact interface/First=punch/front" "Contact interface/Second=foundation/back"
                         "Reference/Solution=uniform(p = 5, x = 1.515, z = 1.135, width = 0.435)"
                     CHECK ${EXACT_WHERE_COVERED})
    else()
      # The lower sphere refines a corner far from the contact.
      add_scene_test(NAME ${name}_hanging_nodes_upper SCENE verification/patch_3d_hanging_nodes.prm
                     SET ${both} "Obstacle beside lower/Centre=0.7,2.1,-1.9" CHECK ${EXACT})
      add_scene_test(NAME ${name}_overhang SCENE verification/patch_3d_punch.prm
                     SET ${both} "Body foundation/Upper corner=1.6,1.2,0" "Boundary condition load/Boundaries=punch/top, foundation/top, punch/bottom"
                         "Reference/Solution=uniform(p = 5, x = 1.25, y = 0.95, width = 0.25)"
                     CHECK ${EXACT_WHERE_COVERED})
    endif()
  endforeach()
  add_scene_test(NAME patch_3d_q${degree}_step SCENE verification/patch_3d_step.prm SET "Discretization/Degree=${degree}" CHECK ${EXACT_WHERE_COVERED})
endforeach()
# Linear elements where a target of the pressure in space decides; not for a plate, rubber, or another quantity.
set(BY_TARGET "Refinement/Cycles=-1" "Refinement/Target error=0.1")
add_scene_test(NAME degree_by_target SCENE half_space_box.prm SET ${BY_TARGET}
               CHECK "status is converged" "dofs <= 9000" "reference.errors.pressure_l2 <= 0.1" "reference.errors.normal_force <= 0.03" "notes.0 has linear elements")
add_scene_test(NAME degree_of_sizes SCENE half_space_box.prm SET ${BY_TARGET} "Refinement/Target quantity=contact size"
               CHECK "status is converged" "reference.errors.normal_force <= 1e-3" "reference.errors.contact_size <= 2e-2" "count(notes) == 1" "notes.0 has symmetry planes cut the contact")
add_scene_test(NAME degree_of_rubber SCENE half_space_box.prm SET ${BY_TARGET} "Body upper/Poisson ratio=0.49" "Reference/Solution="
               CHECK "count(notes) == 1" "notes.0 has symmetry planes cut the contact")
add_scene_test(NAME degree_of_plates SCENE half_space_box.prm SET ${BY_TARGET} "Body upper/Upper corner=4,4,1" "Body upper/Cells=3,3,1" "Reference/Solution="
               CHECK "count(notes) == 1" "notes.0 has symmetry planes cut the contact")
# A block on a larger one: either slave takes the same (first: 38,640 unknowns), though the edge that ends the contact is the master's (it took more than 400,000).
add_scene_test(NAME block_on_larger_slave SCENE verification/patch_3d_pressure.prm
               SET "Body upper/Lower corner=0.5,0.5,0" "Body upper/Upper corner=1.5,1.5,1" "Body upper/Cells=3,3,3" "Body lower/Lower corner=0,0,-1"
                   "Body lower/Upper corner=2,2,0" "Body lower/Cells=5,5,3" "Body lower/Young modulus=1000" "Body lower/Poisson ratio=0.3"
                   "Boundary condition top/Type=displacement" "Boundary condition top/Value=0| 0| -0.001" "Boundary condition planes/Type=displacement"
                   "Boundary condition planes/Boundaries=lower/bottom" "Boundary condition planes/Value=0| 0| 0" "Contact interface/Slave=second"
                   "Refinement/Target error=0.1" "Discretization/Degree=2" "Refinement/Initial refinements=3" "Reference/Solution="
               CHECK "status is converged" "dofs <= 50000" "pairs.0.normal_force.2 ~ -0.6697 3e-3")
add_scene_test(NAME patch_3d_q1_displacement SCENE patch_test_3d.prm SET "Discretization/Degree=1" CHECK ${EXACT})
add_scene_test(NAME patch_3d_q2_interference SCENE patch_test_3d.prm
               SET "Discretization/Degree=2" "Boundary condition top/Type=symmetry" "Boundary condition top/Value=" "Contact interface/Initial gap=-0.01"
               CHECK ${EXACT})
add_scene_test(NAME patch_3d_q2_confined SCENE patch_test_3d.prm
               SET "Discretization/Degree=2"
                   "Boundary condition planes/Boundaries=upper/left, lower/left, upper/front, lower/front, upper/right, lower/right, upper/back, lower/back"
                   "Reference/Solution=two_block_patch(E1 = 1000, nu1 = 0.3, h1 = 1, E2 = 100, nu2 = 0.2, h2 = 2, delta = 0.01, width = 10, confined = 1)"
               CHECK ${EXACT})
add_scene_test(NAME tied_patch_3d_q2 SCENE verification/tied_patch_3d.prm SET "Discretization/Degree=2"
               CHECK "probes.0.points.0.displacement.0 ~ -0.0045 1e-10" "probes.0.points.0.displacement.1 ~ -0.003 1e-10"
                     "probes.0.points.0.displacement.2 ~ 0.015 1e-10")
add_scene_test(NAME patch_3d_stiffness_1e6 SCENE verification/patch_3d_pressure.prm
               SET "Body upper/Young modulus=1e3" "Body lower/Young modulus=1e9" CHECK ${EXACT})

# ---- Closed forms; the tolerances are the floors of the models

set(HERTZ ${ITERATIONS} "reference.errors.contact_size <= 0.003" "reference.errors.peak_pressure <= 0.003")
add_scene_test(NAME cylinders_1b SCENE verification/two_cylinders.prm SET "Refinement/Cycles=7" CHECK ${HERTZ} "reference.errors.pressure_l2 <= 0.02"
               "reference.errors.normal_force <= 1e-4")
add_scene_test(NAME cylinders_1b_slave_upper_finer SCENE verification/two_cylinders.prm
               SET "Contact line/Slave=first" "Body upper/Refinements=3" "Refinement/Cycles=4" CHECK ${HERTZ})
add_scene_test(NAME cylinders_1b_1_to_8 SCENE verification/two_cylinders.prm
               SET "Contact line/Slave=second" "Body lower/Refinements=3" "Refinement/Cycles=4" CHECK ${HERTZ})
add_scene_test(NAME cylinders_1b_8_to_1 SCENE verification/two_cylinders.prm
               SET "Contact line/Slave=second" "Body upper/Refinements=3" "Refinement/Cycles=4" CHECK ${HERTZ})
add_scene_test(NAME roller_1d SCENE nafems_roller.prm
               CHECK ${ITERATIONS} "pairs.0.contact_size ~ 6.197 0.002" "reference.values.peak_pressure.0 ~ 3595.5 0.002"
                     "probes.0.points.0.displacement.1 ~ -1.2812 0.001" "probes.1.points.0.displacement.1 ~ -1.5686 0.002")
add_scene_test(NAME sphere_2a SCENE hertz_sphere_axisymmetric.prm READ_BACK CHECK ${HERTZ} "reference.errors.pressure_l2 <= 0.01")
# In space, seen enlarged: the picture of the bodies.
add_scene_test(NAME sphere_2a_3d_report SCENE hertz_sphere.prm RANKS 2 READ_BACK SET "Refinement/Cycles=3" CHECK ${ITERATIONS} "pairs.0.normal_force.2 ~ -250 1e-8")
add_scene_test(NAME flat_punch_3a_fine SCENE verification/flat_punch_line.prm SET "Refinement/Cycles=10"
               CHECK ${ITERATIONS} "reference.errors.pressure_l2 <= 0.02" "reference.errors.normal_force <= 1e-8"
                     "meshes.6.reference.errors.pressure_l2 <= 0.02" "meshes.6.reference.errors.normal_force <= 1e-8")
add_scene_test(NAME flat_punch_3b_fine SCENE verification/flat_punch_axisymmetric.prm SET "Refinement/Cycles=10"
               CHECK ${ITERATIONS} "reference.errors.pressure_l2 <= 0.02" "reference.errors.normal_force <= 0.003"
                     "meshes.7.reference.errors.pressure_l2 <= 0.02" "meshes.7.reference.errors.normal_force <= 0.005")
add_scene_test(NAME cone_3c SCENE verification/cone.prm
               CHECK ${ITERATIONS} "reference.errors.pressure_l2 <= 0.01" "reference.errors.contact_size <= 0.003")
# Ten times as large: relative errors are those of the scene as it is (which says 0.0367113504313, 0.00128026496323 and 0.029794340845 after two cycles).
add_scene_test(NAME half_plane_box_lengths SCENE half_plane_box.prm
               SET "Refinement/Cycles=2" "Body lower/Lower corner=-40,-40" "Body lower/Upper corner=40,0" "Body upper/Lower corner=-40,0" "Body upper/Upper corner=40,40"
                   "Contact interface/Initial gap=x^2/1000" "Boundary condition far below/Value=halfplane_elliptic(P = 8.630749e-2, a = 10, side = -1)"
                   "Boundary condition far above/Value=halfplane_elliptic(P = 8.630749e-2, a = 10, side = 1)"
                   "Reference/Solution=half_plane_box(a = 10, R = 500, E1 = 1, nu1 = 0.3, E2 = 1, nu2 = 0.3)"
               CHECK "reference.errors.displacement_h1 ~ 0.0367113504313 1e-7" "reference.errors.displacement_l2 ~ 0.00128026496323 1e-7"
                     "reference.errors.pressure_l2 ~ 0.029794340845 1e-7")
add_scene_test(NAME half_plane_box SCENE half_plane_box.prm CHECK ${HERTZ} "reference.errors.normal_force <= 1e-3" "reference.errors.pressure_l2 <= 0.01")
foreach(slave first second)
  set(UNIFORM "newton.0:.iterations <= 4" "reference.errors.pressure_l2 <= 0.003" "reference.errors.nodal_peak_pressure <= 0.003")
  add_scene_test(NAME rings_${slave} SCENE verification/rings.prm SET "Contact interface/Slave=${slave}" CHECK ${UNIFORM})
endforeach()
add_scene_test(NAME shrink_fit_finer_slave SCENE verification/shrink_fit.prm SET "Contact interface/Slave=first" CHECK ${UNIFORM})
# With the coarser side as slave, too: quadratic elements have nodal traces on curved surfaces.
add_scene_test(NAME shrink_fit_coarser_slave_q1 SCENE verification/shrink_fit.prm
               SET "Contact interface/Slave=second" "Discretization/Degree=1" CHECK ${UNIFORM})
add_scene_test(NAME shrink_fit_coarser_slave_q2 SCENE verification/shrink_fit.prm
               SET "Contact interface/Slave=second" "Refinement/Cycles=3" CHECK ${UNIFORM})
# Both bodies of one file. The declared interference replaces the gap between arcs of second order: no kinks of theirs count (50 % were told, 0.01 were true), but at finite strain.
add_scene_test(NAME shaft_and_hub SCENE verification/shaft_and_hub.prm
               CHECK "status is converged" "meshes.-1.reference.errors.pressure_l2 <= 0.001" "error_estimate.facets == 0" "error_estimate.contact <= 0.001")
add_scene_test(NAME shaft_and_hub_finite SCENE verification/shaft_and_hub.prm SET "Kinematics=finite strain" "Refinement/Cycles=0"
               CHECK "error_estimate.facets >= 0.1" "error_estimate.facets <= 0.7" "count(notes.:) == 4")
add_scene_test(NAME shrink_fit_plane_stress SCENE verification/shrink_fit.prm SET "Kind=plane stress" CHECK ${UNIFORM})
add_scene_test(NAME shrink_fit_spheres SCENE verification/shrink_fit_spheres.prm CHECK ${UNIFORM})
# The pressures are off by 0.153 % in the mean square, 0.056 % were told where the unrefined pair counted as one that has converged.
add_scene_test(NAME three_shrunk_rings SCENE verification/three_shrunk_rings.prm
               CHECK "status is converged" "pairs.0.normal_force.0 ~ 603.510 1e-4" "pairs.1.normal_force.1 ~ 576.824 1e-4" "error_estimate.contact >= 0.00153" "error_estimate.contact <= 0.01")
add_scene_test(NAME punch_r0094_2 SCENE nafems_punch.prm CHECK ${ITERATIONS} "probes.0.points.0.displacement.1 ~ -0.13396 0.002"
               "pairs.0.peak_pressure <= 1000")
foreach(degree 1 2)
  add_scene_test(NAME nearly_incompressible_q${degree} SCENE hertz_cylinder.prm
                 SET "Discretization/Degree=${degree}" "Body block/Poisson ratio=0.4999"
                     "Reference/Solution=hertz_line(P=1000,R=10,E1=200e3,nu1=0.4999)"
                 CHECK ${ITERATIONS} "reference.errors.contact_size <= 0.01" "reference.errors.peak_pressure <= 0.01")
endforeach()

# ---- Closed forms in space

set(ITERATIONS_3D "newton.1:.iterations <= 4" "checks.force_balance <= 1e-8" "checks.tension <= 1e-6")
# The block is not a half space: the approach is smaller by 0.52 a/H.
add_scene_test(NAME hertz_sphere SCENE hertz_sphere.prm
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.003" "reference.errors.peak_pressure <= 0.005" "reference.errors.pressure_l2 <= 0.03"
                     "reference.values.approach.0 ~ 0.010343 0.01")
add_scene_test(NAME hertz_sphere_q2 SCENE hertz_sphere.prm SET "Discretization/Degree=2" "Refinement/Cycles=4"
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.001" "reference.errors.peak_pressure <= 0.002"
                     "reference.values.approach.0 ~ 0.010343 0.002")
add_scene_test(NAME two_spheres_3d SCENE two_spheres.prm SET "Refinement/Cycles=4"
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.005" "reference.errors.peak_pressure <= 0.01" "reference.errors.approach <= 0.02")
add_scene_test(NAME two_spheres_3d_q2 SCENE two_spheres.prm SET "Discretization/Degree=2" "Refinement/Cycles=3"
               CHECK "newton.1:.iterations <= 5" "checks.force_balance <= 1e-8" "checks.tension <= 1e-6" "reference.errors.contact_size <= 0.003" "reference.errors.peak_pressure <= 0.005" "reference.errors.approach <= 0.01")
add_scene_test(NAME crossed_cylinders SCENE crossed_cylinders.prm SET "Refinement/Cycles=4"
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.005" "reference.errors.contact_size_2 <= 0.005" "reference.errors.peak_pressure <= 0.01")
add_scene_test(NAME shrink_fit_spheres_3d SCENE verification/shrink_fit_spheres_3d.prm
               CHECK "reference.errors.pressure_l2 <= 0.01")
add_scene_test(NAME shrink_fit_spheres_3d_q1 SCENE verification/shrink_fit_spheres_3d.prm SET "Discretization/Degree=1"
               CHECK "reference.errors.pressure_l2 <= 0.01")
add_scene_test(NAME step_file SCENE step_file.prm SET "Refinement/Cycles=6"
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.005" "reference.errors.contact_size_2 <= 0.005" "reference.errors.peak_pressure <= 0.005")
add_scene_test(NAME half_space_box SCENE half_space_box.prm SET "Refinement/Cycles=2"
               CHECK ${ITERATIONS_3D} "reference.errors.normal_force <= 1e-3" "reference.errors.contact_size <= 1e-3" "reference.errors.pressure_l2 <= 0.06"
                     "reference.errors.energy <= 0.06")
add_scene_test(NAME half_space_box_axisymmetric SCENE verification/half_space_box_axisymmetric.prm
               CHECK ${ITERATIONS} "reference.errors.normal_force <= 2e-4" "reference.errors.contact_size <= 2e-4" "reference.errors.pressure_l2 <= 0.01"
                     "reference.errors.energy <= 0.02")
add_scene_test(NAME sphere_on_block_scaling SCENE sphere_on_block_scaling.prm SET "Refinement/Maximum DoFs=20000"
               CHECK ${ITERATIONS_3D} "reference.errors.contact_size <= 0.005" "reference.errors.peak_pressure <= 0.01")

# Nearly incompressible bodies of up to 30,000 unknowns are factorised: 1,005 steps of CG, 6.4 s instead of 1.8.
add_scene_test(NAME nearly_incompressible_in_space SCENE sphere_on_block_scaling.prm SET "Body block/Poisson ratio=0.4999" "Body block/Cells=12,12,12" "Refinement/Cycles=0"
               CHECK "status is converged" "dofs >= 5001" "newton.0.krylov_iterations <= 50")

# ---- Tied pairs

add_scene_test(NAME tied_patch SCENE verification/tied_patch.prm RANKS 2 READ_BACK
               CHECK "probes.0.points.0.displacement.0 ~ -0.00585 1e-10" "probes.0.points.0.displacement.1 ~ 0.01365 1e-10")
# The load of 0.01 at 9 from the wall, on which the forces across make a couple.
add_scene_test(NAME tied_beam SCENE verification/tied_beam.prm RANKS 2 SET "Boundary condition load/Type=total force"
               CHECK "probes.0.points.0.displacement.1 ~ -0.0267074 5e-4" "reactions.0.force.0 abs<= 1e-10" "reactions.0.force.1 ~ 0.01 1e-8"
                     "reactions.0.moment.0 ~ 0.09 1e-8")
add_scene_test(NAME beam_in_one_piece SCENE verification/beam_in_one_piece.prm CHECK "probes.0.points.0.displacement.1 ~ -0.0267074 5e-4")

# ---- Bodies that only contact holds, no contact

foreach(scene disk_above_block disk_platen)
  add_scene_test(NAME ${scene} SCENE verification/${scene}.prm CHECK ${ITERATIONS} "reference.errors.normal_force <= 1e-4"
                 "reference.errors.contact_size <= 0.005")
endforeach()
# The formula is that of a thin ring.
add_scene_test(NAME half_ring_below_lid SCENE verification/half_ring_below_lid.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.00529 0.01" "error_estimate.quantity <= 0.01"
               "error_estimate.kinematics >= 0.01" "notes.-1 has with what small strain leaves out (0.029) it is missed")
add_scene_test(NAME ring_in_groove SCENE verification/ring_in_groove.prm
               CHECK "status is converged" "cut_backs == 0" "pairs.0.normal_force.1 ~ 4.7008 1e-4" "pairs.1.normal_force.1 ~ -4.7008 1e-4" "pairs.2.normal_force.0 ~ 1.6305 1e-4" "pairs.3.normal_force.0 ~ -1.6305 1e-4")
# Rollers that nothing presses and nothing holds; without clearance the forces of a finer mesh (target 0.01).
add_scene_test(NAME roller_bearing SCENE verification/roller_bearing.prm CHECK "status is converged" ${ITERATIONS} "error_estimate.contact <= 0.1" "pairs.0.normal_force.0 ~ 20.711 5e-3" "pairs.0.normal_force.1 ~ -50 1e-8"
               "pairs.14.normal_force.0 ~ -20.711 5e-3" "pairs.6.normal_force.1 == 0")
foreach(i RANGE 7)
  list(APPEND NO_CLEARANCE "Body roller ${i}/Radius=5")
endforeach()
add_scene_test(NAME roller_bearing_without_clearance SCENE verification/roller_bearing.prm SET ${NO_CLEARANCE}
               CHECK "status is converged" "newton.:.iterations <= 12" "error_estimate.contact <= 0.1" "pairs.0.normal_force.1 ~ -43.18 5e-3" "pairs.2.normal_force.0 ~ 16.45 5e-3")
add_scene_test(NAME ring_between_walls SCENE verification/ring_between_walls.prm CHECK "status is converged" "cells >= 500" "pairs.0.normal_force.1 ~ 1.0587 2e-3" "checks.force_balance <= 1e-8")
# Without friction what walls do not hold is held; where both are touched, or one, it is not (without, facets drove rings aside, or found no equilibrium).
set(SMOOTH "Contact bottom/Friction coefficient=0" "Contact top/Friction coefficient=0")
add_scene_test(NAME smooth_ring_between_walls SCENE verification/ring_between_walls.prm SET ${SMOOTH} CHECK "status is converged" "newton.:.iterations <= 6" "pairs.0.normal_force.1 ~ 1.0583 2e-3"
               "pairs.2.smallest_gap ~ 0.10297 2e-4" "pairs.3.smallest_gap ~ 0.10297 2e-4")
add_scene_test(NAME smooth_ring_touches_walls SCENE verification/ring_between_walls.prm SET ${SMOOTH} "Obstacle right/Centre=22.15, 0" "Obstacle left/Centre=17.85, 0" "Obstacle top/Displacement=0|-0.8*t"
               CHECK "status is converged" "pairs.2.normal_force.0 ~ -0.7614 2e-3" "pairs.3.normal_force.0 ~ 0.7614 2e-3" "pairs.0.normal_force.1 ~ 3.7286 2e-3")
add_scene_test(NAME smooth_ring_touches_wall SCENE verification/ring_between_walls.prm SET ${SMOOTH} "Obstacle right/Centre=22.15, 0" "Obstacle left/Centre=17.5, 0" "Obstacle top/Displacement=0|-0.8*t"
               CHECK "status is converged" "pairs.2.normal_force.0 <= 1e-8" "pairs.2.normal_force.0 >= -1e-8" "pairs.0.normal_force.1 ~ 2.9895 2e-3")
add_scene_test(NAME just_touching SCENE verification/just_touching.prm CHECK "status is converged" ${ITERATIONS} "pairs.0.peak_pressure <= 1e-6")
add_scene_test(NAME no_contact SCENE verification/no_contact.prm CHECK "status is converged" ${ITERATIONS} "pairs.0.peak_pressure <= 1e-12")
add_scene_test(NAME lifted SCENE verification/tension.prm CHECK "status is converged" "newton.0.iterations <= 12" "pairs.0.peak_pressure <= 1e-12")

# ---- Friction

# What every run with friction keeps.
set(LAWS "checks.energy_balance <= 1e-6" "checks.negative_dissipation <= 1e-9" "checks.coulomb_cone <= 1e-6" "checks.force_balance <= 1e-8")

# The node at rest is in the middle of those that slip, or near an end: the pulls may differ by exp(0.3 pi) = 2.566.
add_scene_test(NAME band_on_drum SCENE verification/band_on_drum.prm CHECK "status is converged" ${LAWS} "newton.:.iterations <= 12" "pairs.0.normal_force.1 ~ 149.125 5e-3" "pairs.0.tangential_force.1 ~ 50.875 1e-2"
               "pairs.0.n_open == 0")
add_scene_test(NAME band_pulled_more_on_one_side SCENE verification/band_on_drum.prm SET "Boundary condition pull/Value=0|x > 0 ? -250*t : -100*t"
               CHECK "status is converged" ${LAWS} "newton.:.iterations <= 12" "pairs.0.n_open == 0")
# By Euler and Eytelwein 1.6 exp(-mu phi) of one end meets exp(-mu (pi - phi)) of the other: the drum pushes by (0.4433, 2.3630) without the friction. Single nodes opened
# by what friction did to them once closed, and the other way round, and no states were found in 60 iterations, twice.
add_scene_test(NAME thin_band_pulled_more_on_one_side SCENE verification/band_on_drum.prm
               SET "Body band/Inner radius=10" "Body band/Radius=10.1" "Body band/Refinements=0" "Body band/Young modulus=1e6" "Obstacle drum/Radius=10" "Contact hold/Friction coefficient=0.2"
                   "Boundary condition pull/Value=0|-(x > 0 ? 16 : 10)*t" "Increments=1"
               CHECK "status is converged" ${LAWS} "cut_backs == 0" "pairs.0.normal_force.0 ~ 0.4433 5e-3" "pairs.0.normal_force.1 ~ 2.3630 2e-3" "pairs.0.n_open == 0")
add_scene_test(NAME band_pulled_off SCENE verification/band_on_drum.prm FAILS SET "Boundary condition pull/Value=0|x > 0 ? -270*t : -100*t" CHECK "message has friction probably cannot hold")

# The bore's own way is no part of the answer that finite strain would change (it was 0.11, and the run was refused).
add_scene_test(NAME ring_in_turned_bore SCENE verification/ring_in_turned_bore.prm
               CHECK "status is converged" ${LAWS} "pairs.0.n_stick == 0" "pairs.0.peak_pressure ~ 5.641 1e-2" "reactions.0.moment.0 ~ -10.633 1e-3" "error_estimate.kinematics <= 0.02")
# 8 increments on the last mesh, after one that 20 were needed on: 42.5 of work where 66.6 are right. What was told was the error of the 20.
add_scene_test(NAME ring_in_turning_bore_increments SCENE verification/ring_in_turned_bore.prm
               SET "Kinematics=finite strain" "Increments=automatic" "Refinement/Target error=0.02" "Body ring/Refinements=0" "Obstacle bore/Rotation=2*pi*table(1: 0, 2: 1)"
               CHECK "increments.measured_with >= 12" "increments.number == 8" "increments.dissipation >= 0.4")
add_scene_test(NAME loosened_clamp SCENE verification/loosened_clamp.prm CHECK "status is converged" "meshes.-1.dissipation ~ 0.03036 0.005")
add_scene_test(NAME loosened_friction SCENE verification/loosened_clamp.prm
               SET "Contact joint/Friction coefficient=table(1: 1, 2: 1, 3: 0.05)" "Boundary condition clamp/Force=0|-40*table(0: 0, 1: 1)"
               CHECK "status is converged" "meshes.-1.dissipation ~ 0.02922 0.006")
add_scene_test(NAME twisted_ball SCENE verification/twisted_ball.prm CHECK "notes.0 has the pressure is known to" "linear_solves <= 40")

# Patch tests: at t = 1 all sticks, at t = 2 all slips. A turned scene turns the loads with it (c, s: cosine and sine of the angle).
set(STICKS "End time=1" "Output times=")
set(STUCK ${EXACT} ${LAWS} "pairs.0.n_slip == 0" "pairs.0.n_open == 0" "contact.:.slip_x abs<= 1e-12" "contact.:.slip_y abs<= 1e-12"
    "meshes.-1.dissipation abs<= 1e-12")
set(SLID ${EXACT} ${LAWS} "pairs.0.n_stick == 0" "pairs.0.n_open == 0" "newton.:.iterations <= 5" "meshes.-1.dissipation ~ 0.15 1e-9")
set(TO_MU "1.5*table(0: 0, 1: 0.9, 1.5: 0.999, 2: 1)")
foreach(degree 1 2)
  foreach(slave first second)
    set(both "Discretization/Degree=${degree}" "Contact interface/Slave=${slave}")
    set(name patch_friction_q${degree}_${slave})
    # the shear on the slave
    set(q 1.5)
    set(below 1.35)
    if(slave STREQUAL first)
      set(q -1.5)
      set(below -1.35)
    endif()
    # Each of the other cases with two of the four: one of either degree and with either slave.
    set(case "${degree} ${slave}")
    if(case MATCHES "1 first|2 second")
      add_scene_test(NAME ${name}_slips SCENE verification/patch_friction.prm SET ${both}
                     CHECK ${SLID} "contact.:.tx ~ ${q} 1e-10" "contact.:.slip_y abs<= 1e-12" "meshes.:2.pairs.0.n_slip == 0")
      add_scene_test(NAME ${name}_held_by_friction SCENE verification/patch_friction.prm
                     SET ${both} ${STICKS} "Boundary condition top/Type=traction" "Boundary condition top/Value=1.35*t|-5*t" CHECK ${STUCK})
    else()
      add_scene_test(NAME ${name}_sticks SCENE verification/patch_friction.prm SET ${both} ${STICKS} CHECK ${STUCK} "contact.:.tx ~ ${below} 1e-10")
    endif()
    if(degree EQUAL 1)
      add_scene_test(NAME ${name}_1_to_10 SCENE verification/patch_friction.prm SET ${both} "Body upper/Cells=1,3" "Body lower/Cells=10,5"
                     CHECK ${SLID} "contact.:.tx ~ ${q} 1e-10")
    else()
      add_scene_test(NAME ${name}_10_to_1 SCENE verification/patch_friction.prm SET ${both} "Body upper/Cells=10,3" "Body lower/Cells=1,5"
                     CHECK ${SLID} "contact.:.tx ~ ${q} 1e-10")
    endif()
    set(angle 17)
    if(slave STREQUAL second)
      set(angle 45)
    endif()
    set(c "cos(${angle}*pi/180)")
    set(s "sin(${angle}*pi/180)")
    set(U "table(0: 0, 1: 0.06831, 1.5: 0.0758241, 2: 0.1259)")
    set(V "table(0: 0, 1: 0.09371428571428571)")
    set(turned "Body upper/Rotate=${angle}" "Body lower/Rotate=${angle}" "Boundary condition top/Value=${c}*${U}+${s}*${V}|${s}*${U}-${c}*${V}"
        "Boundary condition right/Value=-${s}*${TO_MU}|${c}*${TO_MU}" "Boundary condition left/Value=${s}*${TO_MU}|-${c}*${TO_MU}")
    if(case MATCHES "1 first|2 second")
      add_scene_test(NAME ${name}_sticks_turned_${angle} SCENE verification/patch_friction.prm SET ${both} ${STICKS} ${turned} CHECK ${STUCK})
      set(history transfer)
    else()
      add_scene_test(NAME ${name}_slips_turned_${angle} SCENE verification/patch_friction.prm SET ${both} ${turned} CHECK ${SLID})
      set(history replay)
    endif()
    # The error estimate of an exact solution is rounding: it refines here and there.
    add_scene_test(NAME ${name}_hanging_nodes_${history} SCENE verification/patch_friction.prm
                   SET ${both} "Refinement/Cycles=2" "Refinement/History=${history}" CHECK ${SLID} "contact.:.tx ~ ${q} 1e-10")

    # In space; slip of 0.05 over an area of 3. The direction of slip makes the problem nonlinear: solved to 1e-12, since the tolerance of 1e-9
    # would leave 1e-9 in the pressure.
    set(both "Discretization/Degree=${degree}" "Contact interface/Slave=${slave}" "Contact solver/Tolerance=1e-12")
    # hanging nodes carry no traction of their own and have no slip
    set(collinear ${EXACT} ${LAWS} "pairs.0.n_stick == 0" "pairs.0.n_open == 0" "newton.:.iterations <= 7" "meshes.-1.dissipation ~ 0.225 1e-9")
    # the supports' forces, in the middle of top (1, 0.75, 1) and bottom (1, 0.75, -2), and their moments about the origin
    list(APPEND collinear "reactions.0.force.0 ~ 3.897114317029974 1e-8" "reactions.0.force.1 ~ 2.25 1e-8" "reactions.0.force.2 ~ -15 1e-8"
         "reactions.0.moment.0 ~ -13.5 1e-8" "reactions.0.moment.1 ~ 18.897114317029974 1e-8" "reactions.0.moment.2 ~ -0.6728357377724806 1e-7"
         "reactions.1.force.2 ~ 15 1e-8" "reactions.1.moment.0 ~ 6.75 1e-8" "reactions.1.moment.1 ~ -7.205771365940052 1e-8"
         "reactions.1.moment.2 ~ 0.6728357377724806 1e-7")
    if(slave STREQUAL first)
      list(APPEND collinear "contact.:.tx ~ -1.299038105676658 1e-9" "contact.:.ty ~ -0.75 1e-9" "contact.state=slip.slip_x ~ 0.04330127018922193 1e-9"
           "contact.state=slip.slip_y ~ 0.025 1e-9")
    else()
      list(APPEND collinear "contact.:.tx ~ 1.299038105676658 1e-9" "contact.:.ty ~ 0.75 1e-9" "contact.state=slip.slip_x ~ -0.04330127018922193 1e-9"
           "contact.state=slip.slip_y ~ -0.025 1e-9")
    endif()
    set(name patch_friction_3d_q${degree}_${slave})
    if(case MATCHES "1 first|2 second")
      add_scene_test(NAME ${name}_sticks SCENE verification/patch_friction_3d.prm SET ${both} ${STICKS} CHECK ${STUCK})
    endif()
    add_scene_test(NAME ${name}_slips SCENE verification/patch_friction_3d.prm READ_BACK SET ${both} CHECK ${collinear})
    if(degree EQUAL 1)
      add_scene_test(NAME ${name}_hanging_nodes SCENE verification/patch_friction_3d.prm SET ${both} "Refinement/Cycles=2" CHECK ${collinear})
    endif()
  endforeach()
endforeach()

# The last edges of open, slip and stick: no more than one node apart, on the finest faces of 0.04 to 0.16.
# doc/walk.md: loads and forces of the contact balance.
add_scene_test(NAME walk_pin_in_lug SCENE walk/pin_in_lug.prm SET "Refinement/Cycles=0" ${SCENE_QUIET}
               CHECK "checks.force_balance <= 1e-8" "checks.coulomb_cone <= 1e-9" "pairs.0.normal_force.0 ~ 478.11 1e-3" "pairs.0.tangential_force.0 ~ 21.87 1e-2")
add_scene_test(NAME walk_pin_in_lug_3d SCENE walk/pin_in_lug_3d.prm SET "Increments=8" "Contact solver/Tolerance=1e-11" ${SCENE_QUIET}
               CHECK "checks.force_balance <= 1e-8" "checks.coulomb_cone <= 1e-9" "pairs.0.normal_force.0 ~ 2914 1e-3" "pairs.0.tangential_force.0 ~ 85.7 2e-2")
# Its first increment is cut, which may not count in the estimate: the target of 10 % is not reached on the first mesh of 744 DoFs.
add_scene_test(NAME failed_increment_has_no_estimate SCENE walk/pin_in_lug.prm ${SCENE_QUIET}
               SET "Body pin/Shift=0,0" "Kinematics=finite strain" "Refinement/Maximum DoFs=1200"
               CHECK "cut_backs >= 1" "dofs >= 1000" "error_estimate.contact >= 0.01" "checks.force_balance <= 1e-8")
# The numbers are those of doc/small_scene.py, which does not know the program.
add_scene_test(NAME small_scene SCENE small_scene.prm
               CHECK "newton.0.iterations <= 3" "contact.X=0.state is open" "contact.X=1.state is slip" "contact.X=2.state is stick" "contact.X=1.fx ~ -0.375049100 1e-8"
                     "contact.X=2.fy ~ 1.090542052 1e-8" "contact.X=2.pressure ~ 1.143228039 1e-8" "checks.force_balance <= 1e-10")
add_scene_test(NAME greco SCENE greco.prm
               CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "pairs.0.normal_force.1 ~ 2000 1e-8"
                     "pairs.0.tangential_force.0 ~ -1405.37 1e-3" "probes.0.points.0.displacement.0 ~ 28.603e-3 3e-3"
                     "probes.0.points.1.displacement.0 ~ 27.226e-3 3e-3" "probes.0.points.4.displacement.0 ~ 22.868e-3 3e-3"
                     "probes.0.points.6.displacement.0 ~ 19.8075e-3 3e-3" "probes.0.points.9.displacement.0 ~ 15.414e-3 3e-3"
                     "contact.state=open.X <= 3.35" "contact.state=slip.X >= 3.25" "contact.state=slip.X <= 30" "contact.state=stick.X >= 29.6")
add_comparison_test(NAME greco_1_20_increments SCENE greco.prm SET "Refinement/Cycles=2" OPTIONS --any-iterations
                    RUN 1 "1 | Increments=20")
foreach(mu 0 0.1 0.5 2)
  add_scene_test(NAME greco_mu_${mu} SCENE greco.prm SET "Contact base/Friction coefficient=${mu}" "Refinement/Cycles=4"
                 CHECK "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "checks.force_balance <= 1e-8" "status is converged")
endforeach()

# The coefficient as a function of pressure and of place.
set(k 0)
foreach(mu "1/(1+p/50)" "0.2+p/100" "exp(-p/30)" "if(x<10, 0.2, 1)")
  math(EXPR k "${k}+1")
  add_scene_test(NAME greco_mu_expression_${k} SCENE greco.prm SET "Contact base/Friction coefficient=${mu}" "Refinement/Cycles=4" "Contact solver/Tolerance=1e-11"
                 CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "pairs.0.normal_force.1 ~ 2000 1e-8")
endforeach()

foreach(mu 0.15001 0.2 2)
  add_scene_test(NAME floating_slab_mu_${mu} SCENE floating_slab.prm SET "Contact base/Friction coefficient=${mu}"
                 CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "pairs.0.normal_force.1 ~ 800 1e-8"
                       "pairs.0.tangential_force.0 ~ -120 1e-8")
endforeach()
# The reference has four digits: half a unit of the last is 3e-4.
add_scene_test(NAME floating_slab_pressures SCENE floating_slab.prm SET "Refinement/Strategy=uniform"
               CHECK "contact.X=1.pressure ~ 184.2 3e-4" "contact.X=2.pressure ~ 186.45 3e-4" "contact.X=3.pressure ~ 196.4 3e-4")
foreach(mu 0.01 0.14999)
  add_scene_test(NAME floating_slab_mu_${mu} SCENE floating_slab.prm FAILS SET "Contact base/Friction coefficient=${mu}"
                 CHECK "status has not converged" "message has friction cannot hold the rigid motion along x")
endforeach()

foreach(mu 0.185 0.2 0.3 2)
  set(superlinear)
  if("${mu}" MATCHES "0.2|0.3")
    set(superlinear "slowdown <= 0.1")
  endif()
  add_scene_test(NAME floating_slab_3d_mu_${mu} SCENE verification/floating_slab_3d.prm
                 SET "Contact base/Friction coefficient=${mu}" "Refinement/Cycles=2"
                 CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "pairs.0.normal_force.2 ~ 2400 1e-8"
                       "pairs.0.tangential_force.0 ~ -360 1e-8" "pairs.0.tangential_force.1 ~ -240 1e-8" ${superlinear})
endforeach()
# 0.4 % above the limit: 11 iterations measured.
add_scene_test(NAME floating_slab_3d_mu_0.181 SCENE verification/floating_slab_3d.prm SET "Contact base/Friction coefficient=0.181"
               CHECK ${LAWS} "newton.0.iterations <= 12" "pairs.0.tangential_force.0 ~ -360 1e-8")
# From both sides of the limit 0.1802776, whatever the mesh and the rounding: what cannot be held is told after one iteration.
add_scene_test(NAME floating_slab_3d_mu_0.1803 SCENE verification/floating_slab_3d.prm SET "Contact base/Friction coefficient=0.1803"
               CHECK ${LAWS} "pairs.0.tangential_force.0 ~ -360 1e-8" "pairs.0.tangential_force.1 ~ -240 1e-8")
foreach(mu 0.01 0.1802)
  add_scene_test(NAME floating_slab_3d_mu_${mu} SCENE verification/floating_slab_3d.prm FAILS SET "Contact base/Friction coefficient=${mu}"
                 CHECK "status has not converged" "message has friction cannot hold the rigid motion along x" "newton.:.iterations <= 1")
endforeach()
# The same where the bodies may move far. Normals turn by the strain, at most p/E = 3.7e-4, and with them 2400 of normal force;
# so much the work of forces is known in one increment, too (energy balance 4e-5).
set(finite "Kinematics=finite strain" "Body slab/Young modulus=1e6")
add_scene_test(NAME floating_slab_3d_finite_mu_0.17 SCENE verification/floating_slab_3d.prm FAILS SET ${finite} "Body slab/Cells=3,2,1" "Contact base/Friction coefficient=0.17"
               CHECK "status has not converged" "message has friction cannot hold the rigid motion along x")
add_scene_test(NAME floating_slab_3d_finite_mu_0.19 SCENE verification/floating_slab_3d.prm SET ${finite} "Contact base/Friction coefficient=0.19"
               CHECK "checks.coulomb_cone <= 1e-6" "checks.force_balance <= 1e-8" "checks.negative_dissipation <= 1e-9"
                     "pairs.0.tangential_force.0 ~ -360 2e-3" "pairs.0.tangential_force.1 ~ -240 2e-3")
add_scene_test(NAME floating_slab_3d_below_on_3_ranks SCENE verification/floating_slab_3d.prm RANKS 3 FAILS
               SET "Contact base/Friction coefficient=0.1802" CHECK "message has friction cannot hold the rigid motion along x")
foreach(cells 3,2,1 8,6,4)
  set(mesh "Body slab/Cells=${cells}")
  string(REPLACE "," "x" name ${cells})
  add_scene_test(NAME floating_slab_3d_${name}_below SCENE verification/floating_slab_3d.prm FAILS
                 SET ${mesh} "Contact base/Friction coefficient=0.1795"
                 CHECK "message has friction cannot hold the rigid motion along x" "newton.:.iterations <= 1")
  add_scene_test(NAME floating_slab_3d_${name}_above SCENE verification/floating_slab_3d.prm SET ${mesh} "Contact base/Friction coefficient=0.181"
                 CHECK ${LAWS} "pairs.0.tangential_force.0 ~ -360 1e-8" "pairs.0.tangential_force.1 ~ -240 1e-8")
endforeach()
# Pushed off its middle, the slab turns as well. Friction at the best places would hold it with mu = 0.154, at those that elasticity chooses with 0.163.
set(off "Boundary condition push/Value=40*y" "Boundary condition push y/Value=0")
foreach(case "0.152 cannot" "0.158 probably cannot")
  string(REPLACE " " ";" words ${case})
  list(GET words 0 mu)
  string(REPLACE "${mu} " "" verdict ${case})
  add_scene_test(NAME floating_slab_3d_turning_mu_${mu} SCENE verification/floating_slab_3d.prm FAILS SET ${off} "Contact base/Friction coefficient=${mu}"
                 CHECK "status has not converged" "message has friction ${verdict} hold the rigid")
endforeach()
add_scene_test(NAME floating_slab_3d_turning_mu_0.17 SCENE verification/floating_slab_3d.prm SET ${off} "Contact base/Friction coefficient=0.17"
               CHECK ${LAWS} "newton.0.iterations <= 10" "pairs.0.tangential_force.0 ~ -360 1e-8" "pairs.0.tangential_force.1 abs<= 1e-6")

# Cattaneo and Mindlin: end of a whole cycle, and the way back at Q = 0, where the traction is the difference of three ellipses: the error is relative
# to a small norm. The dissipation is the whole one, of one and a quarter cycles.
set(CM "P = 1000, R = 10, E1 = 200e3, nu1 = 0.3, E2 = 200e3, nu2 = 0.3, friction = 0.3")
set(MINUS_P "-1000*table(0: 0, 1: 1)")
set(KEPT ${LAWS} "newton.0:5.iterations <= 10" "newton.5:.iterations <= 5")
foreach(case "75 0.866025 0.20" "270 0.316228 0.05")
  separate_arguments(case)
  list(GET case 0 Q)
  list(GET case 1 ratio)
  list(GET case 2 back)
  set(load "Boundary condition load/Force=${Q}*table(1: 0, 2: 1, 3: -1, 4: 1)|${MINUS_P}")
  add_scene_test(NAME cattaneo_mindlin_${Q} SCENE cattaneo_mindlin.prm
                 SET ${load} "Reference/Solution=cattaneo_mindlin(${CM}, Q = ${Q}, Q_max = ${Q}, reversals = 2)"
                 CHECK ${KEPT} "reference.errors.stick_size <= 0.005" "reference.errors.dissipation <= 0.01" "reference.errors.shear_l2 <= 0.03"
                       "reference.errors.contact_size <= 1e-3" "reference.errors.tangential_force <= 1e-8")
  if(Q EQUAL 270)
    add_scene_test(NAME cattaneo_mindlin_${Q}_back_at_0 SCENE cattaneo_mindlin.prm
                   SET ${load} "End time=2.5" "Increments=3" "Reference/Solution=cattaneo_mindlin(${CM}, Q = 0, Q_max = ${Q}, reversals = 1)"
                   CHECK ${LAWS} "reference.errors.shear_l2 <= ${back}")
  endif()
endforeach()
add_scene_test(NAME cattaneo_mindlin_disks SCENE verification/cattaneo_mindlin_disks.prm
               CHECK ${LAWS} "newton.:.iterations <= 5" "reference.errors.stick_size <= 0.005" "reference.errors.dissipation <= 0.01"
                     "reference.errors.contact_size <= 1e-3")

# Just below the limit of sliding, and just above it.
foreach(case "0.1 0.20202020202020204" "0.2 0.3061224489795919" "0.3 0.4123711340206186")
  separate_arguments(case)
  list(GET case 0 mu)
  list(GET case 1 limit)
  set(weight "-0.5*table(0: 0, 1: 1)")
  set(at_mu "Contact base/Friction coefficient=${mu}")
  if(mu EQUAL 0.2)
    # The load reaches the limit at t = 1.8: increments are cut back to 2e-4 there.
    add_scene_test(NAME incline_mu_${mu}_sought SCENE incline.prm FAILS
                   SET ${at_mu} "Body block/Body force=1.25*${limit}/2*table(1: 0, 2: 1)|${weight}"
                   CHECK "status has not converged" "message has friction cannot hold" "history.-1.t ~ 1.8 3e-4")
  else()
    add_scene_test(NAME incline_mu_${mu}_at_0.999 SCENE incline.prm
                   SET ${at_mu} "Body block/Body force=0.999*${limit}/2*table(1: 0, 2: 1)|${weight}"
                   CHECK ${LAWS} "newton.:.iterations <= 10" "pairs.0.n_slip >= 10" "pairs.0.n_stick >= 1")
    add_scene_test(NAME incline_mu_${mu}_at_1.001 SCENE incline.prm FAILS
                   SET ${at_mu} "Body block/Body force=1.001*${limit}/2*table(1: 0, 2: 1)|${weight}"
                   CHECK "status has not converged" "message has friction cannot hold the rigid motion along x")
  endif()
endforeach()

# The same by a weight that leans by 30 degrees: held above tan(30) = 0.57735. The map over angles and coefficients is a study.
add_scene_test(NAME leaning_weight SCENE verification/leaning_weight.prm SET "Contact base/Friction coefficient=0.578"
               CHECK ${LAWS} "pairs.0.normal_force.1 ~ 0.8660254 1e-6" "pairs.0.tangential_force.0 ~ -0.5 1e-6" "linear_solves >= 1")
add_scene_test(NAME leaning_weight_slides SCENE verification/leaning_weight.prm FAILS SET "Contact base/Friction coefficient=0.577"
               CHECK "status has not converged" "failure has friction beyond limit")
add_scene_test(NAME load_after_the_end SCENE verification/clamped.prm SET "End time=0.5" CHECK "notes.0 has but tables go on to t = 2" "pairs.0.normal_force.1 ~ -600 1e-6")
add_scene_test(NAME clamped_by_a_force SCENE verification/clamped.prm SET "Boundary condition pull/Value=350*table(1: 0, 2: 1)|0" CHECK "status is converged" "pairs.0.tangential_force.0 ~ 350 1e-6" "checks.force_balance <= 1e-8")
add_scene_test(NAME clamped_beyond_the_limit SCENE verification/clamped.prm FAILS SET "Boundary condition pull/Value=370*table(1: 0, 2: 1)|0" CHECK "status has not converged" "failure has friction")
add_scene_test(NAME clamped_beyond_the_limit_finite SCENE verification/clamped.prm FAILS SET "Kinematics=finite strain" Increments=4 "Boundary condition pull/Value=370*table(1: 0, 2: 1)|0" CHECK "status has not converged" "failure has friction")

# NAFEMS R0094-1 and -2 with mu = 0.1. The stick zone ends between two nodes, 0.2 apart; shear has its peak there, on one node.
add_scene_test(NAME roller_friction_20_increments SCENE nafems_roller_friction.prm
               CHECK ${LAWS} "newton.:20.iterations <= 10" "newton.22:.iterations <= 5" "pairs.0.peak_pressure ~ 3663 2e-3"
                     "peak(contact.pair=roller.tx) ~ 339 0.02" "contact.pair=roller,state=stick.X <= 2.2" "contact.pair=roller,state=slip.X >= 2.1"
                     "error_estimate.shear_kinematics >= 0.13" "error_estimate.shear_kinematics <= 0.78") # by finite strain 0.195
# One increment is wrong, as it is said to be.
add_scene_test(NAME roller_friction_1_increment SCENE nafems_roller_friction.prm SET "Increments=1"
               CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "contact.pair=roller,state=stick.X <= 1" "contact.pair=roller,state=slip.X >= 0.8")
# Nodes of the stick zone are 1.56 apart.
foreach(increments 5)
  add_scene_test(NAME punch_friction_${increments}_increments SCENE nafems_punch_friction.prm SET "Increments=${increments}"
                 CHECK ${LAWS} "newton.0:${increments}.iterations <= 10" "newton.${increments}:.iterations <= 5"
                       "probes.0.points.0.displacement.1 ~ -0.13178 1e-3" "contact.state=stick.X <= 17.2" "contact.state=slip.X >= 16.9" "contact.X=0.tx abs<= 1e-12")
endforeach()
# The edge of the punch is coarse here, the stick zone finer.
add_scene_test(NAME punch_friction_stick_zone SCENE nafems_punch_friction.prm
               SET "Increments=1" "Refinement/Strategy=uniform" "Refinement/Cycles=2"
               CHECK ${LAWS} "contact.state=stick.X <= 17.2" "contact.state=slip.X >= 16.9" "contact.X=0.tx abs<= 1e-12")

# A hysteresis loop; bar theory is 3e-4 (displacement) and 8e-4 (dissipation) off at this height.
set(BAR ${LAWS} "newton.:3.iterations <= 10" "newton.3:.iterations <= 5")
foreach(degree 1 2)
  add_scene_test(NAME microslip_bar_q${degree} SCENE microslip_bar.prm READ_BACK SET "Discretization/Degree=${degree}"
                 CHECK ${BAR} "probes.0.points.0.displacement.0 ~ 0.05 2e-3" "meshes.-1.dissipation ~ 0.833333 2e-3" "contact.state=slip.X >= 10"
                       "contact.state=stick.X <= 10.3")
endforeach()
add_scene_test(NAME microslip_bar_back_at_0 SCENE microslip_bar.prm SET "End time=1.5" "Increments=2"
               CHECK ${LAWS} "probes.0.points.0.displacement.0 ~ 0.025 2e-3" "pairs.0.tangential_force.0 abs<= 1e-6")
add_scene_test(NAME microslip_bar_coulomb SCENE microslip_bar.prm SET "Contact base/Tresca bound=" "Contact base/Friction coefficient=0.01"
               CHECK ${BAR} "probes.0.points.0.displacement.0 ~ 0.05 2e-3" "meshes.-1.dissipation ~ 0.833333 2e-3")

# Mindlin neglects slip across the force: exact for nu = 0, some percent otherwise.
foreach(nu 0 0.3)
  set(M "P = 1000, R = 10, E1 = 200e3, nu1 = ${nu}, E2 = 200e3, nu2 = ${nu}, friction = 0.3, Q = 150, Q_max = 150, reversals = 2")
  set(material "Body upper/Poisson ratio=${nu}" "Body lower/Poisson ratio=${nu}")
  add_scene_test(NAME mindlin_sphere_nu_${nu} SCENE mindlin_sphere.prm SET ${material} "Reference/Solution=mindlin_sphere(${M})"
                 CHECK ${LAWS} "newton.:4.iterations <= 10" "newton.4:.iterations <= 5" "reference.errors.stick_size <= 0.02"
                       "reference.errors.dissipation <= 0.03" "reference.errors.tangential_force <= 1e-8"
                       "checks.slip_direction <= 1e-6")
  # Superlinear is Newton's method, if linear systems are solved far enough: the last residual is theirs else.
  set(superlinear)
  set(tight)
  if(nu EQUAL 0)
    set(superlinear "newton.:.iterations <= 5" "slowdown <= 0.1")
    set(tight "Contact solver/Tolerance=1e-11" "Linear solver/Tolerance=1e-12")
  endif()
  # The traction of the skew is a projected one, for which the mean is exact and single nodes of the edge are not.
  add_scene_test(NAME oblique_drag_nu_${nu} SCENE verification/oblique_drag.prm SET ${material} ${tight}
                 CHECK ${LAWS} "newton.:2.iterations <= 10" "newton.2:.iterations <= 5" "pairs.0.n_stick == 0" "skew <= 1e-3" "checks.slip_direction <= 1e-9"
                       "pairs.0.tangential_force.0 ~ 259.808 1e-4" "pairs.0.tangential_force.1 ~ 150 1e-4" ${superlinear})
endforeach()

# Thickness and stiff ends of the strip: 1 %. Slip and peeling run along all of its 159 nodes in one increment.
foreach(case "0.1 0.854636 1.170089" "0.3 0.624228 1.601978")
  separate_arguments(case)
  list(GET case 0 mu)
  list(GET case 1 held)
  list(GET case 2 pulled)
  set(at_mu "Contact drum/Friction coefficient=${mu}")
  add_scene_test(NAME capstan_mu_${mu} SCENE capstan.prm SET ${at_mu}
                 CHECK ${LAWS} "newton.:.iterations <= 5" "reactions.0.force.1 ~ -${pulled} 0.01" "pairs.0.n_stick == 0")
  add_scene_test(NAME capstan_mu_${mu}_held SCENE capstan.prm SET ${at_mu} "End time=1" "Increments=1"
                 CHECK ${LAWS} "newton.:.iterations <= 5" "reactions.0.force.1 ~ -${held} 0.01")
endforeach()

# Iterations, for small and large coefficients, many increments and many nodes: at most 10 on the first mesh, at most 5 later; residuals fall
# superlinearly in the end. (The capstan with mu = 2 and 8 increments: states circle where the load turns, and that increment is cut.)
foreach(mu 0.05 2)
  add_scene_test(NAME iterations_capstan_mu_${mu} SCENE capstan.prm SET "Contact drum/Friction coefficient=${mu}" "Increments=20"
                 CHECK ${LAWS} "newton.:.iterations <= 10" "slowdown <= 0.01")
  add_scene_test(NAME iterations_punch_mu_${mu} SCENE nafems_punch_friction.prm SET "Contact punch/Friction coefficient=${mu}" "Refinement/Cycles=1"
                 CHECK ${LAWS} "newton.:20.iterations <= 10" "newton.20:.iterations <= 5" "slowdown <= 0.01")
endforeach()
add_scene_test(NAME iterations_punch_40_increments SCENE nafems_punch_friction.prm SET "Increments=40" "Refinement/Cycles=1"
               CHECK ${LAWS} "newton.:40.iterations <= 10" "newton.40:.iterations <= 5" "slowdown <= 0.01")
foreach(bound "Contact base/Tresca bound=1" "Contact base/Tresca bound= & Contact base/Friction coefficient=0.01")
  string(REPLACE " & " ";" bound "${bound}")
  list(LENGTH bound law)
  add_scene_test(NAME iterations_bar_law_${law} SCENE microslip_bar.prm SET ${bound} "Body bar/Cells=200,2" "Refinement/Cycles=1"
                 CHECK ${LAWS} "newton.0:3.iterations <= 10" "newton.3:.iterations <= 5" "slowdown <= 0.01")
endforeach()
# A whole load history on several ranks, in space as well.
add_comparison_test(NAME ranks_greco SCENE greco.prm SET "Refinement/Cycles=1" RUN 1 3)
add_comparison_test(NAME ranks_floating_slab SCENE floating_slab.prm RUN 1 3)
add_comparison_test(NAME ranks_microslip_bar SCENE microslip_bar.prm RUN 1 2)
add_comparison_test(NAME ranks_cattaneo_mindlin SCENE cattaneo_mindlin.prm SET "Refinement/Cycles=1" "End time=2.5" "Increments=3" "Output times=" RUN 1 3)
add_comparison_test(NAME ranks_nafems_roller_friction SCENE nafems_roller_friction.prm SET "Refinement/Cycles=1" "Increments=3" RUN 1 3)
add_comparison_test(NAME ranks_mindlin_sphere SCENE mindlin_sphere.prm
                    SET "Refinement/Initial refinements=3" "Refinement/Cycles=1" "Refinement/Fraction=0.9" "Linear solver/Type=direct" "End time=2" "Increments=2" RUN 1 2)
add_comparison_test(NAME ranks_patch_friction_3d SCENE verification/patch_friction_3d.prm RUN 1 3)
# What is coarsened does not depend on ranks either: 190 cells at the third mesh, 238 at the fifth.
add_comparison_test(NAME ranks_followed_slide SCENE verification/followed_slide.prm SET "End time=0.6" "Increments=12" RUN 1 2)
add_comparison_test(NAME ranks_transfer_cattaneo_mindlin SCENE cattaneo_mindlin.prm
                    SET "Refinement/History=transfer" "Refinement/Cycles=2" "End time=2" "Increments=2" "Output times=" RUN 1 2)

# Cattaneo without a model error.
foreach(case "1 10 2" "2 7 4")
  separate_arguments(case)
  list(GET case 0 degree)
  list(GET case 1 cycles)
  list(GET case 2 legs)
  add_scene_test(NAME half_plane_box_friction_q${degree}_${legs} SCENE half_plane_box_friction.prm
                 SET "Discretization/Degree=${degree}" "Refinement/Cycles=${cycles}" "End time=${legs}" "Increments=${legs}"
                 CHECK ${LAWS} "newton.:${legs}.iterations <= 10" "newton.${legs}:.iterations <= 5" "reference.errors.stick_size <= 1e-3"
                       "reference.errors.shear_l2 <= 0.02" "reference.errors.dissipation <= 0.005" "reference.errors.contact_size <= 1e-4")
endforeach()

# Histories carried over to refined meshes end where replayed ones do (4e-5 of the shear on GRECO, 8e-4 of c/a after Cattaneo's cycle measured).
add_scene_test(NAME transfer_greco SCENE greco.prm SET "Refinement/History=transfer" "Increments=4" "Refinement/Cycles=6"
               CHECK ${LAWS} "newton.0.iterations <= 10" "newton.1:.iterations <= 5" "pairs.0.tangential_force.0 ~ -1405.37 1e-3"
                     "probes.0.points.0.displacement.0 ~ 28.603e-3 3e-3" "checks.transfer_residual <= 0.02" "checks.transfer_residual >= 1e-4")
add_scene_test(NAME transfer_cattaneo_mindlin SCENE cattaneo_mindlin.prm SET "Refinement/History=transfer"
               CHECK ${LAWS} "newton.:.iterations <= 5" "reference.errors.stick_size <= 0.005" "reference.errors.dissipation <= 0.01"
                     "reference.errors.shear_l2 <= 0.05")
# A history moves to the refined mesh whole or not at all. With so few iterations the transferred state finds no equilibrium: no answer without it. (Where
# the history was dropped, this run "converged" to a dissipation of 17.5 instead of 9.3.)
add_scene_test(NAME transfer_without_equilibrium SCENE nafems_roller_friction.prm FAILS
               SET "Refinement/History=transfer" "Refinement/Cycles=2" "Increments=4" "Refinement/Fraction=0.9" "Contact solver/Maximum iterations=2"
               CHECK "status has not converged" "message has after refinement at t = 0.5")
# Here the solve after the refinement fails, and a shorter increment starts from the last converged state on the refined mesh (force as without limit).
add_scene_test(NAME refined_solve_fails SCENE verification/rubber_indentation.prm
               SET "Kinematics=finite strain" "Refinement/Cycles=1" "Contact solver/Maximum iterations=4"
               CHECK "pairs.0.normal_force.1 ~ -0.441564822412 1e-8" "meshes.-1.dofs == 936")
add_scene_test(NAME transfer_finite SCENE cattaneo_mindlin.prm
               SET "Kinematics=finite strain" "Refinement/History=transfer" "Refinement/Cycles=2" "End time=1.5" "Increments=3" "Output times="
               CHECK "checks.transfer_residual >= 1e-4" "checks.transfer_residual <= 0.2")
add_scene_test(NAME transfer_microslip_bar SCENE microslip_bar.prm READ_BACK SET "Refinement/History=transfer"
               CHECK ${LAWS} "probes.0.points.0.displacement.0 ~ 0.05 2e-3" "meshes.-1.dissipation ~ 0.833333 2e-3")
add_scene_test(NAME transfer_nafems_roller SCENE nafems_roller_friction.prm SET "Refinement/History=transfer" "Increments=5"
               CHECK ${LAWS} "pairs.0.peak_pressure ~ 3663 2e-3" "contact.pair=roller,state=stick.X <= 2.2"
                     "contact.pair=roller,state=slip.X >= 2.1")
# Nodes stick one after the other: no saw-tooth of vertices and middles of faces (kinks of 1.4, peak of 1.04 without means; degree 1 with h/8 and 160 increments: 0.562).
foreach(case "small 40 0.8" "finite 60 0.6")
  separate_arguments(case)
  list(GET case 0 kinematics)
  list(GET case 1 increments)
  list(GET case 2 kink)
  add_scene_test(NAME growing_stick_${kinematics} SCENE verification/growing_stick.prm SET "Kinematics=${kinematics} strain" "Increments=${increments}"
                 CHECK "status is converged" "kink(contact.state=stick.tx) <= ${kink}" "peak(contact.state=stick.tx) <= 0.7" "checks.coulomb_cone <= 1e-6")
endforeach()

# Nothing slips where a load at an angle grows: q = 0.15 p. Slip counts from where nodes touch (from where the increment began, they left rings of shear: 0.19 and 9e-5; finite strain 0.154 and 1.08e-4).
foreach(case "small 0.1 3e-5" "finite 0.14 5e-5")
  separate_arguments(case)
  list(GET case 0 kinematics)
  list(GET case 1 shear)
  list(GET case 2 dissipation)
  add_scene_test(NAME loaded_at_an_angle_${kinematics} SCENE cattaneo_mindlin.prm
                 SET "Kinematics=${kinematics} strain" "End time=1" "Output times=" "Increments=10" "Boundary condition load/Force=150*t| -1000*t" "Reference/Solution=" "Refinement/Cycles=2"
                 CHECK "status is converged" "error_estimate.shear <= ${shear}" "meshes.-1.dissipation <= ${dissipation}")
endforeach()
# A coefficient that jumps makes the work of one that was there before (half of it, with the mean of the bounds at both ends of the increment): without it, 7.1688e-3.
add_scene_test(NAME coefficient_that_jumps SCENE cattaneo_mindlin.prm
               SET "End time=2" "Output times=" "Increments=2" "Boundary condition load/Force=150*table(1: 0, 2: 1)| -1000*table(0: 0, 1: 1)" "Reference/Solution="
                   "Refinement/Cycles=2" "Contact line/Friction coefficient=t <= 1 ? 0 : 0.3"
               CHECK "status is converged" "meshes.-1.dissipation ~ 7.1688e-3 5e-3")

# In space beside hanging nodes, whose unknowns lie elsewhere. Reference: h/4.
add_scene_test(NAME growing_stick_3d SCENE verification/growing_stick_3d.prm
               CHECK "status is converged" "pairs.0.normal_force.2 ~ -0.15541 2e-3" "pairs.0.tangential_force.0 ~ 0.0185 3e-2" "pairs.0.tangential_force.1 ~ 0.0185 3e-2")
# What nodes in a plane of symmetry do across their slip resists no motion of the ball across the plane (20 turns).
add_scene_test(NAME free_across_plane SCENE verification/growing_stick_3d.prm
               SET "Obstacle ball/Displacement=0|free|free" "Obstacle ball/Force=0|0|-0.3*t" "Obstacle ball/Centre=0,0.01,1"
               CHECK "status is converged" "newton.0.iterations <= 10" "newton.1.iterations <= 6" "pairs.0.tangential_force.1 abs<= 1e-9"
                     "notes.-2 has free across a plane of symmetry that cuts its contact")

# All large faces of the slave touch where the ball does: they are refined at first nevertheless (else 306 unknowns, and 2.1 instead of 0.64 for a whole block).
foreach(kinematics small finite)
  add_scene_test(NAME ball_on_one_face_${kinematics} SCENE verification/growing_stick_3d.prm SET "Body block/Cells=1, 1, 1" "Kinematics=${kinematics} strain"
                 CHECK "status is converged" "dofs >= 1000" "pairs.0.normal_force.2 ~ -0.157 5e-2")
endforeach()

# What is smaller than the faces and lies between their nodes. In space: Hertz, 2.0721e-6.
add_scene_test(NAME thin_wire SCENE verification/thin_wire.prm
               CHECK "status is converged" "dofs <= 5000" "reference.errors.peak_pressure <= 0.01" "reference.errors.contact_size <= 0.01")
add_scene_test(NAME small_ball SCENE verification/growing_stick_3d.prm
               SET "Contact interface/Friction coefficient=" "Obstacle ball/Radius=0.02" "Obstacle ball/Centre=0.23, 0.31, 0.02" "Obstacle ball/Displacement=0| 0| -0.0001*t" "Increments=1"
                   "Refinement/Cycles=-1" "Refinement/Target error=0.3" "Discretization/Degree=2"
               CHECK "status is converged" "pairs.0.normal_force.2 ~ -2.072e-6 3e-2")

# Corner on corner: refused where no normal finds the other side, whichever is the slave; beside it nothing touches.
foreach(slave first second)
  add_scene_test(NAME corner_on_corner_${slave} SCENE verification/corner_on_corner.prm FAILS SET "Contact c/Slave=${slave}"
                 CHECK "status has not converged" "failure has entered" "message has corner" "history.-1.t >= 0.001" "history.-1.t <= 0.004") # a thousandth of a face deep
  add_scene_test(NAME corner_beside_corner_${slave} SCENE verification/corner_on_corner.prm SET "Contact c/Slave=${slave}" "Body upper/Shift=0.2, 1.0142"
                 CHECK "pairs.0.n_slip <= 0" "pairs.0.smallest_gap ~ 0.0707 1e-3")
endforeach()

# Statics: a block stands as long as its weight acts on what it lies on. Beyond it no force within the contact holds it, though nodes there may carry some.
foreach(slave first second)
  add_scene_test(NAME tipping_stands_${slave} SCENE verification/tipping.prm SET "Contact edge/Slave=${slave}" "Body block/Shift=0.97, 0" "Refinement/Cycles=2"
                 CHECK "checks.force_balance <= 1e-9" "checks.moment_balance <= 1e-8" "checks.coulomb_cone <= 1e-10")
  add_scene_test(NAME tipping_falls_${slave} SCENE verification/tipping.prm FAILS SET "Contact edge/Slave=${slave}" "Body block/Shift=-1.03, 0"
                 CHECK "message has hold" "message has rotation")
endforeach()
add_scene_test(NAME tipping_falls_finite SCENE verification/tipping.prm FAILS SET "Kinematics=finite strain" "Body block/Shift=1.03, 0")
add_scene_test(NAME tipping_stands_finite SCENE verification/tipping.prm SET "Kinematics=finite strain" "Body block/Shift=0.97, 0" CHECK "checks.force_balance <= 1e-9")
add_scene_test(NAME tipping_tower SCENE verification/tipping_tower.prm SET "Body block/Shift=-0.97, 0"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 60 1e-9" "pairs.1.normal_force.1 ~ 60 1e-9" "checks.moment_balance <= 1e-8")
add_scene_test(NAME tipping_stands_3d SCENE verification/tipping_3d.prm CHECK "checks.force_balance <= 1e-9" "checks.moment_balance <= 1e-8")
foreach(place "1.03, 0.5" "1.03, 1.03")
  string(MAKE_C_IDENTIFIER "${place}" name)
  add_scene_test(NAME tipping_falls_3d${name} SCENE verification/tipping_3d.prm FAILS SET "Body block/Shift=${place}, 0"
                 CHECK "message has within the contact" "failure has beyond edge")
endforeach()

# ---- Finite strain

# Every run: force and moment balance where the bodies are now, no tension, no overlap.
set(KEPT_FINITE "status is converged" "checks.force_balance <= 1e-8" "checks.tension <= 1e-6" "checks.penetration <= 1e-8")
set(EXACT_FINITE ${KEPT_FINITE} "reference.errors.pressure_l2 <= 1e-9" "reference.errors.nodal_peak_pressure <= 1e-9" "newton.:.iterations <= 8")

# One body against closed forms (the numbers come from the formulas in the scenes).
set(NEO neo-Hookean)
set(SVK "St. Venant-Kirchhoff")
foreach(case "plane strain;NEO;-0.386106830428142;508.036425861104;819.916517590936" "plane stress;NEO;-0.25153433922862;498.445007186297;761.906132449142"
        "axisymmetric;NEO;-0.25153433922862;498.445007186297;4787.19741676" "plane strain;SVK;-0.637229712261506;1511.94928373354;2060.43956043956"
        "plane stress;SVK;-0.41886116991581;1500;1875" "axisymmetric;SVK;-0.41886116991581;1500;11780.9724509617")
  list(GET case 0 kind)
  list(GET case 1 law)
  list(GET case 2 lateral)
  list(GET case 3 stress)
  list(GET case 4 force)
  string(REPLACE " " "_" name "uniaxial_${kind}_${law}")
  set(along yy)
  if(kind STREQUAL axisymmetric)
    set(along zz)
  endif()
  set(degree 2)
  if("${law}" STREQUAL "SVK")
    set(degree 1)
  endif()
  add_scene_test(NAME ${name}_q${degree} SCENE verification/uniaxial_finite.prm
                 SET "Kind=${kind}" "Body block/Law=${${law}}" "Discretization/Degree=${degree}" "Contact solver/Tolerance=1e-12"
                 CHECK "probes.0.points.0.displacement.0 ~ ${lateral} 1e-9" "probes.0.points.0.stress.${along} ~ ${stress} 1e-9"
                       "reactions.0.force.1 ~ ${force} 1e-9" "newton.:.iterations <= 6")
endforeach()
add_scene_test(NAME uniaxial_compression SCENE verification/uniaxial_finite.prm SET "Boundary condition top/Value=free|-0.3*t" "Contact solver/Tolerance=1e-12"
               CHECK "probes.0.points.0.displacement.0 ~ 0.26248314506838 1e-9" "reactions.0.force.1 ~ -867.81043453804 1e-9")
add_scene_test(NAME simple_shear_NEO SCENE verification/simple_shear_finite.prm SET "Body block/Law=${NEO}"
               CHECK "probes.0.points.0.stress.xx ~ 96.15384615384615 1e-9" "probes.0.points.0.stress.yy abs<= 1e-9"
                     "probes.0.points.0.stress.zz abs<= 1e-9" "probes.0.points.0.stress.xy ~ 192.30769230769232 1e-9"
                     "probes.0.points.0.von_mises ~ 346.6876226407682 1e-9")
add_scene_test(NAME simple_shear_SVK SCENE verification/simple_shear_finite.prm SET "Body block/Law=${SVK}"
               CHECK "probes.0.points.0.stress.xx ~ 306.49038461538458 1e-9" "probes.0.points.0.stress.yy ~ 168.26923076923077 1e-9"
                     "probes.0.points.0.stress.zz ~ 72.11538461538461 1e-9" "probes.0.points.0.stress.xy ~ 276.44230769230768 1e-9"
                     "probes.0.points.0.von_mises ~ 520.4826543791977 1e-9")

# Patch tests at 30 % compression.
# Under strong compression St. Venant-Kirchhoff bodies are unstable: the lower one is stiffer here, and the mixed ones are shortened by 25 %.
set(SVK_BOTH "Body upper/Law=${SVK}" "Body lower/Law=${SVK}" "Body lower/Young modulus=1200" "Reference/Solution=uniform(p = 238.7418558273413, width = 10)")
set(SVK_LOWER "Body lower/Law=${SVK}" "Body lower/Young modulus=1200" "Boundary condition top/Value=free|-0.75*t"
    "Reference/Solution=uniform(p = 236.3524519837246, width = 10)")
set(TURNED_40 "Body upper/Rotate=40" "Body lower/Rotate=40" "Boundary condition top/Value=0.9*t*sin(2*pi/9)|-0.9*t*cos(2*pi/9)")
# compressed and turned at once
set(S "sin(2*pi/9*t)")
set(C "cos(2*pi/9*t)")
set(U "(1-0.2366623531109516*t)")
set(L "(1-0.3316688234445242*t)")
set(AT_ONCE "End time=1" "Output times=" "Boundary condition upper/Value=${C}*x-${S}*y*${U}-x|${S}*x+${C}*y*${U}-y"
    "Boundary condition lower/Value=${C}*x-${S}*y*${L}-x|${S}*x+${C}*y*${L}-y")
# on the slave: p = 367.97 over a width of 2
set(NO_SHEAR "pairs.0.n_slip == 0" "pairs.0.tangential_force.0 abs<= 7e-7" "pairs.0.tangential_force.1 abs<= 7e-7" "peak(contact.:.slip_x) <= 1e-9"
    "peak(contact.:.slip_y) <= 1e-9" "meshes.-1.dissipation abs<= 1e-9")
foreach(degree 1 2)
  foreach(slave first second)
    set(both "Discretization/Degree=${degree}" "Contact interface/Slave=${slave}")
    set(name patch_finite_q${degree}_${slave})
    add_scene_test(NAME ${name} SCENE verification/patch_finite.prm SET ${both} CHECK ${EXACT_FINITE})
    # Each of the other cases with one of either degree and with either slave.
    if("${degree} ${slave}" MATCHES "1 first|2 second")
      add_scene_test(NAME ${name}_svk SCENE verification/patch_finite.prm SET ${both} ${SVK_BOTH} CHECK ${EXACT_FINITE})
      add_scene_test(NAME ${name}_mesh_turned SCENE verification/patch_finite.prm SET ${both} ${TURNED_40} CHECK ${EXACT_FINITE})
      add_scene_test(NAME ${name}_turned_at_once SCENE verification/patch_finite_turned.prm SET ${both} ${AT_ONCE} CHECK ${EXACT_FINITE})
      add_scene_test(NAME ${name}_turned_sticking SCENE verification/patch_finite_turned.prm READ_BACK SET ${both} "Contact interface/Friction coefficient=0.3"
                     CHECK ${EXACT_FINITE} ${NO_SHEAR})
    else()
      add_scene_test(NAME ${name}_axisymmetric SCENE verification/patch_finite.prm SET ${both} "Kind=axisymmetric" CHECK ${EXACT_FINITE})
      add_scene_test(NAME ${name}_mixed SCENE verification/patch_finite.prm SET ${both} ${SVK_LOWER} CHECK ${EXACT_FINITE})
      add_scene_test(NAME ${name}_turned SCENE verification/patch_finite_turned.prm SET ${both} CHECK ${EXACT_FINITE})
      add_scene_test(NAME objectivity_q${degree}_${slave} SCENE verification/objectivity.prm SET ${both}
                     CHECK ${KEPT_FINITE} "meshes.2:.energy ~ meshes.1.energy 1e-9" "meshes.2:.dissipation ~ meshes.1.dissipation 1e-8"
                           "meshes.2:.pairs.0.peak_pressure ~ meshes.1.pairs.0.peak_pressure 1e-9" "meshes.1.dissipation >= 0.015")
    endif()
  endforeach()
endforeach()
add_scene_test(NAME patch_finite_3d_q1_first SCENE verification/patch_finite_3d.prm SET "Discretization/Degree=1" "Contact interface/Slave=first" CHECK ${EXACT_FINITE})
add_scene_test(NAME patch_finite_3d_q2_second SCENE verification/patch_finite_3d.prm SET "Contact interface/Slave=second" CHECK ${EXACT_FINITE})
add_scene_test(NAME patch_finite_3d_q1_second_turned SCENE verification/patch_finite_turned_3d.prm
               SET "Discretization/Degree=1" "Contact interface/Slave=second" CHECK ${EXACT_FINITE})
add_scene_test(NAME patch_finite_3d_q1_first_turned_sticking SCENE verification/patch_finite_turned_3d.prm
               SET "Discretization/Degree=1" "Contact interface/Slave=first" "Contact interface/Friction coefficient=0.3"
               CHECK ${EXACT_FINITE} ${NO_SHEAR} "pairs.0.tangential_force.2 abs<= 7e-7")
add_scene_test(NAME patch_finite_3d_q2_turned_sticking SCENE verification/patch_finite_turned_3d.prm SET "Contact interface/Friction coefficient=0.3"
               CHECK ${EXACT_FINITE} ${NO_SHEAR})

# Over edges: without friction the force has no jumps larger than the first and the last touch of single nodes.
foreach(slave first second)
  add_scene_test(NAME slide_off_edge_${slave} SCENE verification/slide_off_edge.prm SET "Contact interface/Slave=${slave}"
                 CHECK "status is converged" "kink(history.:.interface.normal_force_y) <= 0.1" "newton.:.iterations <= 10" "pairs.0.normal_force.1 == 0"
                       "history.20.interface.normal_force_y abs<= 96" "history.29.interface.normal_force_y abs<= 48")
  set(coarser)
  if(slave STREQUAL second)
    set(coarser "Body slider/Refinements=1")
  endif()
  add_scene_test(NAME slide_over_edges_${slave} SCENE verification/slide_over_edges.prm SET "Contact interface/Slave=${slave}" ${coarser}
                 CHECK "status is converged" "kink(history.:.interface.normal_force_y) <= 0.17" "newton.:.iterations <= 10" "pairs.0.normal_force.1 == 0"
                       "peak(history.:.interface.normal_force_y) ~ 45.8 0.02")
endforeach()
# With friction, too, no increment is cut back.
add_scene_test(NAME slide_off_edge_friction_first SCENE verification/slide_off_edge.prm
               SET "Contact interface/Slave=first" "Contact interface/Friction coefficient=0.3"
               CHECK "status is converged" "newton.:.iterations <= 7" "kink(history.:.interface.normal_force_y) <= 0.1" "checks.negative_dissipation <= 1e-9"
                     "meshes.-1.dissipation ~ 48.19 0.01") # 49.5 with 160 increments
add_scene_test(NAME slide_over_edges_friction_second SCENE verification/slide_over_edges.prm
               SET "Contact interface/Slave=second" "Contact interface/Friction coefficient=0.3" "Increments=240"
               CHECK "status is converged" "newton.:.iterations <= 8" "kink(history.:.interface.normal_force_y) <= 0.2" "checks.negative_dissipation <= 1e-9"
                     "peak(history.:.interface.normal_force_y) ~ 45.8 0.02" "meshes.-1.dissipation ~ 49.05 0.001") # 49.74, 49.20, 49.09 with 60, 120, 240; where nodes that leave counted for nothing 47.5, 48.7, 48.97

# Small strain and finite strain agree to the order of the strain.
foreach(mu 0 0.3)
  add_test(NAME scenes/small_and_finite_mu_${mu}
           COMMAND ${AMONTONS_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/small_and_finite.py $<TARGET_FILE:amontons> ${CMAKE_BINARY_DIR}/scenes/small_and_finite_mu_${mu}
                   ${CMAKE_CURRENT_LIST_DIR}/../parameters/verification/punch_small_and_finite.prm "Boundary condition top/Value=0| -%g*t" 0.1,0.01,0.001
                   --set "Contact interface/Friction coefficient=${mu}")
endforeach()

# Hertz: a/R = 0.08. A node of the slave sticks on the symmetry plane.
foreach(mu 0 0.3)
  add_scene_test(NAME cylinders_finite_mu_${mu} SCENE verification/two_cylinders.prm
                 SET "Kinematics=finite strain" "Increments=4" "Refinement/Cycles=5" "Boundary condition load/Force=0|-1000*t"
                     "Contact line/Friction coefficient=${mu}" "Reference/Solution=hertz_line(P = 2000, R = 6.666666666666667, E1 = 210e3, nu1 = 0.3, E2 = 70e3, nu2 = 0.33)"
                 CHECK ${KEPT_FINITE} "newton.4:.iterations <= 8" "reference.errors.contact_size <= 0.015" "reference.errors.peak_pressure <= 0.02")
endforeach()

# Loads so small that the contact is within one face, in one step from the start: down to a millionth of the scene's. Between the spheres the first node to
# touch lets the upper body rise by 4e-4, a million times its deformation: forces are balanced to the rounding of that.
foreach(mu 0 0.3)
  foreach(degree 1 2)
    foreach(force -2.5e-4 -2.5)
      add_scene_test(NAME cylinders_finite_force_${force}_q${degree}_mu_${mu} SCENE verification/two_cylinders.prm
                     SET "Kinematics=finite strain" "Increments=1" "Refinement/Cycles=0" "Boundary condition load/Force=0|${force}" "Discretization/Degree=${degree}"
                         "Contact line/Friction coefficient=${mu}"
                     CHECK ${KEPT_FINITE} "meshes.0.t ~ 1 1e-12" "newton.:.iterations <= 16" "pairs.0.normal_force.1 ~ ${force} 0.01")
    endforeach()
  endforeach()
  add_scene_test(NAME spheres_finite_tiny_force_mu_${mu} SCENE two_spheres.prm
                 SET "Kinematics=finite strain" "Increments=1" "Refinement/Initial refinements=3" "Refinement/Cycles=1" "Boundary condition load/Force=0|0|-125e-6"
                     "Contact point/Friction coefficient=${mu}"
                 CHECK "status is converged" "checks.tension <= 1e-6" "checks.penetration <= 1e-8" "meshes.1.t ~ 1 1e-12" "newton.:.iterations <= 16"
                       "checks.force_balance <= 1e-6" "pairs.0.normal_force.2 ~ -125e-6 0.02")
  add_scene_test(NAME sphere_finite_tiny_force_mu_${mu} SCENE hertz_sphere.prm
                 SET "Kinematics=finite strain" "Increments=1" "Refinement/Cycles=2" "Obstacle sphere/Force=0|0|-250e-6" "Contact top/Friction coefficient=${mu}"
                 CHECK ${KEPT_FINITE} "meshes.2.t ~ 1 1e-12" "newton.:.iterations <= 16" "pairs.0.normal_force.2 ~ -250e-6 0.01")
endforeach()

# Code_Aster's test ssnp154 (St. Venant-Kirchhoff): -1.3069 with linear elements, -1.3080 with quadratic ones. The pressure is lower than at small strain.
add_scene_test(NAME roller_finite SCENE nafems_roller_finite.prm
               CHECK ${KEPT_FINITE} "newton.0.iterations <= 12" "newton.1:.iterations <= 6" "probes.0.points.0.displacement.1 ~ -1.3080 5e-4" "pairs.0.peak_pressure ~ 3513 0.01")
add_scene_test(NAME roller_finite_neo_hookean SCENE nafems_roller_finite.prm SET "Body cylinder/Law=${NEO}" "Body block/Law=${NEO}"
               CHECK ${KEPT_FINITE} "newton.:.iterations <= 10" "probes.0.points.0.displacement.1 ~ -1.2792 5e-4")

# Nearly incompressible: a closed form, then an indentation on coarse meshes.
foreach(degree 1 2)
  add_scene_test(NAME press_finite_q${degree} SCENE verification/press_finite.prm SET "Discretization/Degree=${degree}"
                 CHECK "reference.errors.pressure_l2 <= 1e-9" "newton.:.iterations <= 6" "probes.0.points.0.displacement.0 ~ 0.42827420472631 1e-9")
endforeach()
# Ten increments, none cut, as few iterations as for nu = 0.3; also on meshes refined under way.
set(TEN_INCREMENTS ${KEPT_FINITE} "newton.9.increment ~ 10 0" "meshes.9.t ~ 1 1e-12" "newton.:.iterations <= 6")
foreach(case "1 0.01" "2 0.03")
  separate_arguments(case)
  list(GET case 0 degree)
  list(GET case 1 coarse)
  add_scene_test(NAME rubber_indentation_refined_q${degree} SCENE verification/rubber_indentation.prm SET "Discretization/Degree=${degree}" "Refinement/Cycles=2"
                 CHECK ${TEN_INCREMENTS} "meshes.9.pairs.0.normal_force.1 ~ -0.443 ${coarse}" "meshes.11.t ~ 1 1e-12" "pairs.0.normal_force.1 ~ -0.443 0.01")
endforeach()
add_scene_test(NAME rubber_indentation_at_once SCENE verification/rubber_indentation.prm SET "Discretization/Degree=1" "Increments=1"
               CHECK ${KEPT_FINITE} "newton.0.iterations <= 8" "pairs.0.normal_force.1 ~ -0.443 0.01")

# Kinematics = auto: nothing to look at, a look that says no, and one that says yes.
add_scene_test(NAME auto_harmless SCENE verification/patch_finite.prm SET "Kinematics=auto" "Boundary condition top/Value=free|-1e-4"
               CHECK "checks.neglected_strain ~ 2.18e-5 0.05" "checks.neglected_contact <= 1e-12" "notes.0 has small strain is enough"
                     "pairs.0.normal_force.1 ~ -0.06682577565632486 1e-8")
add_scene_test(NAME auto_small SCENE hertz_cylinder.prm SET "Kinematics=auto"
               CHECK ${HERTZ} "checks.neglected_strain ~ 6.9e-3 0.1" "checks.neglected_contact ~ 7.2e-4 0.1" "notes.0 has small strain is enough")
add_scene_test(NAME auto_tried SCENE hertz_sphere_axisymmetric.prm SET "Kinematics=auto"
               CHECK "checks.neglected_strain ~ 0.0139 0.1" "checks.change_of_answer <= 0.01" "notes.0 has small strain is enough")
add_scene_test(NAME auto_finite SCENE verification/patch_finite.prm SET "Kinematics=auto"
               CHECK ${EXACT_FINITE} "checks.neglected_strain ~ 0.196 0.1" "checks.change_of_answer ~ 0.22 0.1" "notes.0 has finite strain is used")
# Slip is what motions differ by: small strain that is enough for a pressure to 15 % is not for the stick size.
add_scene_test(NAME stick_size_by_finite_strain SCENE nafems_roller_friction.prm
               SET Kinematics=auto Increments=3 "Refinement/Target error=0.15" "Refinement/Cycles=0" "Refinement/Target quantity=stick size"
               CHECK "checks.change_of_answer <= 0.05" "notes.0 has used")
# What sticks is off by more than the pressure, and a target is kept by both.
add_scene_test(NAME shear_by_finite_strain SCENE nafems_roller_friction.prm
               SET Kinematics=auto Increments=3 "Refinement/Target error=0.05" "Refinement/Cycles=0" CHECK "checks.neglected_strain <= 0.03" "notes.0 has used")
# One normal for both sides: the stick size and the work of friction of finite strain (2.17e-6, 2.20e-6) with either slave (2.04e-6 and 2.06e-6 with 40 increments).
foreach(slave first second)
  add_scene_test(NAME sheared_half_disk_${slave} SCENE verification/sheared_half_disk.prm SET "Contact sheared/Slave=${slave}"
                 CHECK "pairs.0.stick_size ~ 0.0261 0.005" "meshes.-1.dissipation ~ 2.085e-6 0.01" "error_estimate.shear_kinematics <= 0.05")
endforeach()
# Small strain leaves the force of a tilted block where it is: more than the shear.
foreach(slave first second)
  add_scene_test(NAME tilted_block_${slave} SCENE verification/tilted_block.prm SET "Contact tilted/Slave=${slave}"
                 CHECK "status is converged" "peak(pairs.0.tangential_force.0) ~ 1.5e-5 0.01")
endforeach()
# However small the load, normals of both sides leave as little out as those of the slave.
foreach(slave first second)
  add_scene_test(NAME touched_by_little_${slave} SCENE verification/sheared_half_disk.prm
                 SET "Contact sheared/Slave=${slave}" "Contact sheared/Friction coefficient=" "End time=1" "Increments=automatic" "Refinement/Cycles=0"
                     "Boundary condition load/Displacement=0|free" "Boundary condition load/Force=0|-1e-7*t"
                 CHECK "status is converged" "checks.neglected_contact <= 0.02")
endforeach()
# Spheres are refined in units of their size: nanometres in metres.
add_scene_test(NAME nanometres SCENE verification/two_equal_disks.prm
               SET "Body upper/Centre=0,1e-9" "Body upper/Radius=1e-9" "Body lower/Centre=0,-1e-9" "Body lower/Radius=1e-9"
                   "Body lower/Rotation centre=0,-1e-9" "Boundary condition press/Value=0|-0.04e-9"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 65.85818475901362 1e-6")
# Far from the origin moments are those about each body: of rounding in its forces the lever would make 4e-4.
add_scene_test(NAME far_from_the_origin SCENE verification/two_equal_disks.prm
               SET "Kinematics=finite strain" "Body upper/Shift=1e6,1e6" "Body lower/Shift=1e6,1e6" CHECK "status is converged" "checks.moment_balance <= 1e-6")
# The trial of auto turns platens exactly: with linearised rotations it found nothing to mend and the corner at (0.92, 1.08).
add_scene_test(NAME auto_turns SCENE verification/turned_platens.prm
               CHECK "probes.0.points.0.displacement.0 ~ -0.08311299 1e-6" "probes.0.points.0.displacement.1 ~ 0.07671640 1e-6" "checks.change_of_answer ~ 0.0410450 1e-4"
                     "energy <= 1e-20")
# auto ends where finite strain does: where surfaces move on (it once looked for them no farther than small strain had), and where stress stiffens a slender body.
add_comparison_test(NAME auto_slides_far SCENE verification/slid_block.prm RUN "1 | Kinematics=finite strain" "1 | Kinematics=auto" CHECK "pairs.0.normal_force.1 ~ 1.3195 1e-3"
                    OPTIONS --tolerance 1e-6 --any-iterations)
add_comparison_test(NAME auto_strip SCENE verification/pulled_strip.prm RUN "1 | Kinematics=finite strain" "1 | Kinematics=auto" CHECK "pairs.0.normal_force.1 ~ -2.5e-3 0.1"
                    OPTIONS --tolerance 1e-6 --any-iterations)
add_scene_test(NAME target_error SCENE hertz_cylinder.prm SET "Refinement/Cycles=9" "Refinement/Target error=0.03"
               CHECK "error_estimate.contact <= 0.03" "meshes.-2.error_estimate.contact >= 0.03" "meshes.-1.mesh <= 8")
# A target alone is enough, and is kept: of the pressure, and of the tangential traction where that is worse. Where a sharp edge presses nothing keeps it, and that is
# seen long before the mesh is large.
add_scene_test(NAME target_alone SCENE hertz_cylinder.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01"
               CHECK "error_estimate.contact <= 0.01" "meshes.-1.reference.errors.pressure_l2 <= 0.01" "dofs <= 3000")
# An answer that has just changed by 14 % is not known to 8 %.
add_scene_test(NAME estimate_after_a_change SCENE hertz_cylinder.prm SET "Refinement/Cycles=2" CHECK "meshes.2.error_estimate.contact >= 0.1")
add_scene_test(NAME target_of_shear SCENE half_plane_box_friction.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.1"
               CHECK "error_estimate.shear <= 0.1" "error_estimate.contact <= 0.03" "meshes.-1.reference.errors.shear_l2 <= 0.1"
                     "error_estimate.shear >= meshes.-1.reference.errors.shear_l2" "error_estimate.contact >= meshes.-1.reference.errors.pressure_l2")
# As many increments as the target asks for: one in each of five pieces where the path does not matter, five (in one piece, on the mesh that was enough) where it does.
add_scene_test(NAME target_of_increments SCENE cattaneo_mindlin.prm SET "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target error=0.1"
               CHECK "meshes.-1.increment == 5" "meshes.0.t == 0.015625" "meshes.1.t == 0.125" "error_estimate.shear <= 0.1" "reference.errors.shear_l2 <= 0.05" "reference.errors.stick_size <= 0.005")
add_scene_test(NAME target_of_more_increments SCENE nafems_roller_friction.prm SET "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target error=0.02"
               CHECK "meshes.-1.increment == 6" "meshes.0.t == 0.015625" "error_estimate.shear <= 0.015" "increments.shear <= 0.01" "newton.:.iterations <= 12")
# Few nodes see the increments wrong by far: 100 of them on each of several meshes (not done after 190 s) where 20 do. Shear of 4 % of the pressure.
add_scene_test(NAME increments_of_a_contact_that_grows SCENE verification/sheared_half_disk.prm
               SET "Kinematics=small strain" "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target quantity=contact pressure" "Refinement/Target error=0.1" "Body block/Young modulus=1000"
                   "Boundary condition load/Force=0|0" "Boundary condition load/Displacement=0.001*table(1: 0, 2: 1)|-0.02*table(0: 0, 1: 1)"
               CHECK "status is converged" "increments.number <= 30" "linear_solves <= 110" "error_estimate.shear <= 0.0866" "error_estimate.increments <= 0.05" "pairs.0.stick_size ~ 0.1023 0.01")
# What every mesh and increment would say is said once.
add_scene_test(NAME probe_outside_is_told_once SCENE nafems_roller_friction.prm SET "Refinement/Cycles=1" "Increments=3" "Probe cylinder centre/Point=0,500"
               CHECK "notes.0 has lies outside body cylinder" "count(notes.0:) <= 4")
# Pressed, then pressed and sheared in a ratio below the friction: all sticks, q = 0.2 (p(1200) - p(1000)) (Jaeger; Mindlin and Deresiewicz).
# No node of the first mesh closes in the second piece, whose increments do nothing there: what closes in a single one slips.
foreach(landing "1" "2")
  add_scene_test(NAME increments_where_nothing_closes_at_first_${landing} SCENE cattaneo_mindlin.prm
                 SET "End time=2" "Increments=automatic" "Output times=${landing}" "Boundary condition load/Force=40*max(0, t - 1)|-1000*min(t, 1) - 200*max(0, t - 1)"
                     "Reference/Solution=" "Refinement/Initial refinements=3" "Refinement/Cycles=-1" "Refinement/Target error=0.1"
                 CHECK "status is converged" "pairs.0.n_slip <= 0" "pairs.0.contact_size ~ 0.3729 0.01" "error_estimate.increments >= 1e-3" "error_estimate.increments <= 0.05" "linear_solves <= 120")
endforeach()
# Where pressures stay, single increments do: 11 instead of 20.
add_scene_test(NAME single_increments_where_pressures_stay SCENE verification/sheared_half_disk.prm
               SET "Kinematics=small strain" "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target quantity=contact pressure" "Refinement/Target error=0.05"
                   "Body block/Young modulus=1000" "Boundary condition load/Force=0|0" "Boundary condition load/Displacement=0.001*table(1: 0, 2: 1)|-0.02*table(0: 0, 1: 1)"
               CHECK "status is converged" "increments.number <= 20" "linear_solves <= 115" "notes.0 has up to t = 2, the load comes in single increments" "pairs.0.stick_size ~ 0.1023 0.01")
# Half of a punch whose edge cuts a face: the pressure swings about it (size sqrt 2 a, and the plane of symmetry is seen).
add_scene_test(NAME target_half_punch SCENE verification/flat_punch_line.prm
               SET "Body block/Lower corner=0, -400" "Body block/Upper corner=400, 0" "Body block/Cells=4, 4" "Body block/Grading=1, 1" "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Refinement/Target quantity=approach"
               CHECK "status is converged" "pairs.0.contact_size ~ 14.142 0.01" "notes.-1 has symmetry planes cut the contact")
# A punch that covers a thousandth of the first mesh's face: 2 E* a delta, and what the block is stiffer by than a half space (0.8 a/H).
add_scene_test(NAME target_narrow_punch SCENE verification/flat_punch_axisymmetric.prm
               SET "Body block/Lower corner=0, -1000" "Body block/Upper corner=1000, 0" "Body block/Cells=4, 4" "Body block/Grading=1, 1" "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Refinement/Target quantity=total force"
               CHECK "status is converged" "meshes.-1.reference.errors.normal_force <= 0.02")
# Systems are solved as far as the target in space needs, or as is asked for.
add_scene_test(NAME target_and_tolerance SCENE hertz_sphere.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.03"
               CHECK "status is converged" "newton.-1.residual <= 1e-6" "newton.-1.residual >= 1e-9" "pairs.0.normal_force.2 ~ -250 1e-6")
add_scene_test(NAME target_and_given_tolerance SCENE hertz_sphere.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Contact solver/Tolerance=1e-9"
               CHECK "status is converged" "newton.-1.residual <= 1e-9" "pairs.0.normal_force.2 ~ -250 1e-9")
add_scene_test(NAME target_at_a_sharp_edge SCENE verification/flat_punch_line.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01"
               CHECK "status is converged" "notes.1 has out of reach" "notes.1 has (10 " "dofs <= 5000" "pairs.0.normal_force.1 ~ -5000 1e-8")
# Numbers of each pair, whatever its load is beside that of others (from a run to 0.2 %).
foreach(quantity "total force" "contact size" "peak pressure" "approach")
  string(REPLACE " " "_" name ${quantity})
  add_scene_test(NAME target_of_three_contacts_${name} SCENE verification/three_contacts.prm SET "Refinement/Target quantity=${quantity}"
                 CHECK "error_estimate.quantity <= 0.02" "dofs <= 40000"
                       "pairs.0.normal_force.1 ~ -641.26 0.02" "pairs.1.normal_force.1 ~ -16.372 0.02" "pairs.2.normal_force.1 ~ -2.1188 0.02"
                       "pairs.0.contact_size ~ 0.19273 0.02" "pairs.1.contact_size ~ 0.030793 0.02" "pairs.2.contact_size ~ 0.011078 0.02"
                       "pairs.2.peak_pressure ~ 121.82 0.02" "pairs.2.approach ~ 2e-5 0.02")
endforeach()
# A size that one node makes is none: against it that of finer meshes counted as unknown, up to 131,000 unknowns (0.12693 by four meshes from 12,000 to 131,000 unknowns).
add_scene_test(NAME target_of_size_on_one_node SCENE verification/growing_stick_3d.prm SET "Increments=1" "Body block/Lower corner=-1,-1,-1" "Body block/Upper corner=1,1,0" "Body block/Cells=3,3,2" "Body block/Young modulus=1000"
               "Obstacle ball/Centre=0.17,0.17,10" "Obstacle ball/Radius=10" "Obstacle ball/Displacement=0|0|free" "Obstacle ball/Force=0|0|-0.3" "Boundary condition symmetry/Boundaries=block/bottom" "Contact interface/Friction coefficient=0"
               "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Refinement/Target quantity=contact size"
               CHECK "status is converged" "error_estimate.quantity <= 0.03" "error_estimate.quantity >= 5e-5" "pairs.0.contact_size ~ 0.12693 2e-3" "dofs <= 40000")
# Hertz; the traction of the tied joint is infinite.
foreach(quantity "contact pressure" "contact size" "approach")
  string(REPLACE " " "_" name ${quantity})
  add_scene_test(NAME target_beside_a_joint_${name} SCENE verification/tied_bracket.prm SET "Refinement/Target quantity=${quantity}"
                 CHECK "dofs <= 25000" "pairs.0.contact_size ~ 0.034039 0.01" "pairs.0.peak_pressure ~ 374.05 0.01")
endforeach()
add_scene_test(NAME target_beside_a_joint_on_the_same_surface SCENE verification/tied_beside_contact.prm SET "Refinement/Target error=-1"
               CHECK "status is converged" "error_estimate.contact <= 0.02" "error_estimate.shear <= 0.08" "dofs <= 12000" "pairs.1.contact_size ~ 0.272 0.01")
# A contact smaller than a cell is not one that does not converge.
add_scene_test(NAME target_from_a_coarse_mesh SCENE verification/two_cylinders.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Discretization/Degree=1" "Refinement/Initial refinements=0"
               CHECK "error_estimate.contact <= 0.03" "meshes.-1.reference.errors.pressure_l2 <= 0.03")
add_scene_test(NAME target_of_nothing SCENE verification/no_contact.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01" CHECK "notes.-1 has touched nothing" "error_estimate.bulk == 0" "dofs <= 1000")
# Numbers, against their closed forms.
add_scene_test(NAME target_stick_size SCENE half_plane_box_friction.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.003" "Refinement/Target quantity=stick size"
               CHECK "error_estimate.quantity <= 0.003" "meshes.-1.reference.errors.stick_size <= 0.003" "dofs <= 15000")
add_scene_test(NAME target_size_at_a_sharp_edge SCENE verification/flat_punch_line.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.001" "Refinement/Target quantity=contact size"
               CHECK "error_estimate.quantity <= 0.001" "meshes.-1.reference.errors.contact_size <= 0.001" "dofs <= 5000")
# Of the mesh's limit, 1.7067 % below the half space's (targets of 1e-3 and less).
add_scene_test(NAME target_approach SCENE hertz_sphere_axisymmetric.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.003" "Refinement/Target quantity=approach"
               CHECK "error_estimate.quantity <= 0.003" "meshes.-1.reference.errors.approach ~ 0.017067 0.003" "pairs.0.approach ~ reference.values.approach.0 1e-12" "dofs <= 3000")
add_scene_test(NAME target_dissipation SCENE half_plane_box_friction.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=dissipation"
               CHECK "error_estimate.quantity <= 0.01" "meshes.-1.reference.errors.dissipation <= 0.01" "dofs <= 15000")
# Two coarse meshes with 3 and 4 closed nodes agree to 0.5 % (3.4 % off); the size is that of targets of 0.1 and 0.3 %.
add_scene_test(NAME target_size_by_chance SCENE verification/quarter_cylinder.prm
               SET "Boundary condition cut/Value=free|-0.003" "Refinement/Initial refinements=3" "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=contact size"
               CHECK "error_estimate.quantity <= 0.01" "pairs.0.contact_size ~ 0.061173 0.01" "dofs <= 8000")
# Nothing said: 1 %. Should a mesh fail (here by lack of iterations), the answer is that of the one before.
add_scene_test(NAME target_by_default SCENE hertz_cylinder.prm SET "Refinement/Cycles=-1"
               CHECK "error_estimate.contact <= 0.01" "meshes.-2.error_estimate.contact >= 0.01" "meshes.-1.reference.errors.pressure_l2 <= 0.01")
add_scene_test(NAME target_of_a_mesh_that_fails SCENE verification/wavy_gap.prm
               SET "Kinematics=small strain" "Obstacle plate/Force=" "Obstacle plate/Displacement=0|-5e-5" "Contact face/Initial gap=1e-3*(1-exp(-((x-0.337)/0.01)^2))"
                   "Refinement/Target error=0.02" "Refinement/Target quantity=energy" "Contact solver/Maximum iterations=5"
               CHECK "status is converged" "notes.0 has the answer is that of the mesh before" "notes.-1 has as the finer mesh failed" "newton.-1.mesh == 3" "dofs <= 500")
# The seal is as exact as 10000 unknowns make it: on the finer mesh an increment finds its way from the one before, not from the coarser mesh.
add_scene_test(NAME target_of_a_seal SCENE verification/o_ring.prm SET "Refinement/Target error=-1"
               CHECK "status is converged" "dofs >= 10000" "pairs.0.normal_force.1 ~ 405.34 2e-4" "error_estimate.contact <= 0.01")
# What the target does not need is left out, and told. 1.3346: with the punch deformable.
add_scene_test(NAME model_rigid_punch SCENE verification/stiff_punch.prm SET "Body punch/Young modulus=1e5"
               CHECK "notes.0 has 'punch', 75 % of the unknowns, is taken for rigid" "notes.-2 has mirror image at x = 0" "dofs <= 5000" "pairs.0.normal_force.1 ~ -1.3346 1e-2")
# Gaps along the axes, and turned by 45 degrees: then neither half has the whole's answer, though corners of the bodies move alike.
set(PRESSED_ONCE "End time=1" Increments=1 "Contact point/Friction coefficient=0" "Refinement/Target error=0.15" "Refinement/Cycles=-1")
add_scene_test(NAME model_mirrored SCENE verification/oblique_drag.prm SET ${PRESSED_ONCE} CHECK "notes.-2 has mirror image at x = 0" "notes.-1 has mirror image at y = 0")
add_scene_test(NAME model_not_mirrored SCENE verification/oblique_drag.prm SET ${PRESSED_ONCE} "Contact point/Initial gap=(x^2+y^2)/20+x*y/15"
               CHECK "notes.-1 has after the end is not applied")
add_scene_test(NAME model_elastic_punch SCENE verification/stiff_punch.prm SET "Body punch/Young modulus=1e4" CHECK "dofs >= 6000" "pairs.0.normal_force.1 ~ -1.3271 1e-2")
add_scene_test(NAME model_full SCENE verification/stiff_punch.prm SET "Model=full" CHECK "dofs >= 6000" "pairs.0.normal_force.1 ~ -1.3354 1e-2")
# (The limit of uniform meshes is 2.25198.)
add_scene_test(NAME model_without_friction SCENE verification/equal_blocks.prm CHECK "notes.0 has friction, and with it the increments, is left out" "pairs.0.normal_force.1 ~ 2.25198 2e-4")
# What small strain does not see, or takes for a small change: contact that comes by what compression does to bending, and a force whose pressure stays.
add_scene_test(NAME column_with_stop SCENE verification/column_with_stop.prm CHECK "status is converged" "pairs.0.normal_force.0 ~ -3.166e-3 5e-3")
add_scene_test(NAME squeezed_rod SCENE verification/squeezed_rod.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -1.0511 1e-3")
# Nodes that look away from a round obstacle do not overlap with it. The weight is 4 pi/10, and what a flat mesh of few cells lacks of it.
add_scene_test(NAME disk_in_cradle SCENE verification/disk_in_cradle.prm
               CHECK "status is converged" "pairs.:.normal_force.1 ~ 0.62832 1e-3" "pairs.0.normal_force.0 ~ -0.5458 2e-3" "newton.:.iterations <= 10")
# To first order an end of the flat is a kink once the pad has slid; not moved, it has a peak of 1004 at finite strain.
add_scene_test(NAME sliding_pad SCENE verification/sliding_pad.prm SET "Refinement/Target error=0.1"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 1004 1e-2" "pairs.0.normal_force.0 <= 0.02" "pairs.0.normal_force.0 >= -0.02" "notes.0 has uneven gaps")
# What coarse meshes do not see: contact that they are too stiff for, and a beam behind an even pressure (0.0020127 on 40 x 4 cells).
add_scene_test(NAME floor_below_beam SCENE verification/floor_below_beam.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ 5.238e-5 1e-2")
add_scene_test(NAME pad_below_beam SCENE verification/pad_below_beam.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.0020127 3e-2" "dofs <= 1000")
# A body may stand as high as gaps vary over the faces below its only closed node; numbers of a mesh that does not see all that touches are not compared.
add_scene_test(NAME beam_on_rollers SCENE verification/beam_on_rollers.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ 3.675e-4 1e-3")
add_scene_test(NAME beam_on_three_rollers SCENE verification/beam_on_rollers.prm SET "Obstacle middle/Centre=0, -5.0180737578125"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 0.0060882 1e-3" "dofs <= 45000")
# Half as many increments do not converge, twice as many tell the error of the increments.
add_scene_test(NAME rolled_disk SCENE verification/rolled_disk.prm
               CHECK "increments.measured_with <= 8" "increments.repeated_with >= 14" "increments.number >= 50" "energy ~ 0.1548 1e-2" "probes.0.points.0.displacement.0 ~ 1 1e-6")
# Cells around a contact that are longer than their distance from it: 2122 and 0.0311 before they counted.
add_scene_test(NAME flat_cell SCENE verification/flat_cell.prm CHECK "status is converged" "pairs.0.peak_pressure ~ 1870 3e-2" "pairs.0.contact_size ~ 0.0340 2e-2" "dofs <= 12000")
# Facets longer than the way to the next state: on 20 cells the strip springs back through the pin, on 40 it is followed.
add_scene_test(NAME swept_strip SCENE verification/swept_strip.prm CHECK "status is converged" "pairs.0.normal_force.0 ~ 0.014302 1e-2" "pairs.0.normal_force.1 ~ -0.023894 1e-2")
# What is neglected on the way is measured on the mesh of then: the motion of the first increment was read on the last mesh.
add_scene_test(NAME hertz_with_output_time SCENE hertz_cylinder.prm SET "Output times=0.5" CHECK "status is converged" "checks.neglected_contact <= 2e-3" "checks.neglected_strain ~ 7.48e-3 1e-2")
add_scene_test(NAME hertz_that_comes_back SCENE hertz_cylinder.prm SET "Output times=0.5" "Obstacle cylinder/Force=0|-(500*sin(pi*t)+10)"
               CHECK "status is converged" "checks.neglected_contact <= 2e-3" "pairs.0.normal_force.1 ~ -10 1e-9")
# What has no meaning, and what ties do to a lever, is said.
add_scene_test(NAME tied_apart SCENE verification/tied_patch.prm SET "Body top/Lower corner=0, 2.3" "Body top/Upper corner=3, 3.3"
               CHECK "status is converged" "notes.0 has ties what lies up to 0.3 apart")
add_scene_test(NAME nothing_loaded SCENE verification/tied_patch.prm SET "Boundary condition load/Value=0" "Refinement/Target error=0.05" "Refinement/Target quantity=total force"
               CHECK "status is converged" "notes.0 has there is no total force, or it is 0")
add_scene_test(NAME no_such_quantity SCENE verification/tied_patch.prm SET "Refinement/Target error=0.05" "Refinement/Target quantity=approach"
               CHECK "status is converged" "notes.0 has there is no approach")
# The round end of a rigid punch is not that of its coarse mesh: 0.2538.
add_scene_test(NAME round_punch_3d SCENE verification/round_punch_3d.prm CHECK "status is converged" "pairs.0.normal_force.2 ~ -0.2597 0.015")
# Pairs that press lightly have to be resolved; meanwhile the rest of the mesh has time.
add_scene_test(NAME heavy_and_light SCENE verification/heavy_and_light.prm CHECK "status is converged" "pairs.0.peak_pressure ~ 591 1e-2" "pairs.1.peak_pressure ~ 1.870 5e-2")
add_scene_test(NAME heavy_and_light_size SCENE verification/heavy_and_light.prm SET "Refinement/Target quantity=contact size" "Refinement/Target error=0.03"
               CHECK "status is converged" "pairs.1.contact_size ~ 3.404e-4 1e-2" "dofs <= 20000")
# Friction is not left out where the first mesh cannot see that it matters: without it 0.01597 is the size.
add_scene_test(NAME model_with_unseen_friction SCENE verification/light_disk.prm
               CHECK "error_estimate.shear <= 0.03" "pairs.0.tangential_force.0 ~ 9.985e-6 3e-3" "pairs.0.contact_size ~ 0.015533 5e-3")
add_scene_test(NAME model_with_friction SCENE verification/equal_blocks.prm SET "Body upper/Young modulus=1100" CHECK "error_estimate.shear <= 0.011" "dofs >= 1000")
# In the end nothing touches, which coarse meshes get right. What does not exist, or is 0, is no target.
add_scene_test(NAME target_of_a_history_that_opens SCENE verification/opened_again.prm CHECK "dofs >= 1500" "error_estimate.contact >= 1e-3" "error_estimate.shear >= 1e-2" "error_estimate.shear <= 0.1")
# In the increments after t = 1 the iteration loses the contact and moves the ring by 1e9 times its size, where rounding hides all forces.
add_scene_test(NAME ring_rolls SCENE verification/ring_rolls.prm CHECK "status is converged" "probes.0.points.0.displacement.0 ~ 4.406 0.01" "checks.force_balance <= 1e-8")
add_scene_test(NAME all_opens_finite_3d SCENE verification/lifted_off.prm CHECK "newton.:.iterations <= 8" "checks.force_balance <= 1e-8" "pairs.0.normal_force.2 ~ 0 1e-12")
add_scene_test(NAME target_of_what_is_zero SCENE verification/opened_again.prm SET "Refinement/Target quantity=peak pressure" CHECK "notes.-1 has the target error has no meaning" "dofs <= 2000")
add_scene_test(NAME target_beyond_the_limit SCENE half_plane_box.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.001" "Refinement/Maximum DoFs=4000"
               CHECK "status is converged" "dofs <= 5000" "error_estimate.contact >= 0.001")
add_scene_test(NAME auto_target SCENE hertz_cylinder.prm SET "Kinematics=auto" "Refinement/Cycles=3" "Refinement/Target error=0.0005"
               CHECK "status is converged" "checks.change_of_answer >= 0.0005" "notes.0 has finite strain is used")

# The same on several ranks, in space too.
add_comparison_test(NAME ranks_objectivity SCENE verification/objectivity.prm SET "Contact interface/Slave=first" "End time=2" "Increments=2" "Discretization/Degree=1" RUN 1 3)
add_comparison_test(NAME ranks_patch_finite_turned_3d SCENE verification/patch_finite_turned_3d.prm
                    SET "Discretization/Degree=1" "Contact interface/Friction coefficient=0.2" "End time=2" "Increments=2" RUN 1 3)
# Open gaps, of which ranks know parts.
add_comparison_test(NAME ranks_ironing SCENE ironing.prm SET "End time=0.3" "Increments=20" "Body block/Cells=24,4" RUN 1 2)

# ---- The same answer: ranks, complementarity factor

# The first run of a comparison is also checked for what the scene pins down.
add_comparison_test(NAME ranks_three_blocks SCENE three_blocks.prm SET "Discretization/Degree=2" RUN 1 3 CHECK ${EXACT})
add_comparison_test(NAME ranks_hertz_cylinder SCENE hertz_cylinder.prm RUN 1 3 CHECK ${HERTZ} "reference.errors.pressure_l2 <= 0.02")
add_comparison_test(NAME ranks_two_punches SCENE verification/two_punches.prm SET "Discretization/Degree=2" RUN 1 2 CHECK ${EXACT})
add_comparison_test(NAME ranks_two_cylinders SCENE verification/two_cylinders.prm SET "Refinement/Cycles=3" RUN 1 3)
add_comparison_test(NAME ranks_patch_hanging_nodes SCENE verification/patch_hanging_nodes.prm
                    SET "Discretization/Degree=2" "Contact interface/Slave=first" RUN 1 2 4 CHECK ${EXACT})
add_comparison_test(NAME ranks_disk_weight SCENE verification/disk_weight.prm RUN 1 3
                    CHECK ${ITERATIONS} "reference.errors.normal_force <= 1e-4" "reference.errors.contact_size <= 0.005")
add_comparison_test(NAME ranks_three_blocks_3d SCENE three_blocks_3d.prm SET "Discretization/Degree=1" RUN 1 3 CHECK ${EXACT})
add_comparison_test(NAME ranks_patch_3d_hanging_nodes SCENE verification/patch_3d_hanging_nodes.prm
                    SET "Discretization/Degree=1" "Contact interface/Slave=second" "Linear solver/Type=direct" RUN 1 3 CHECK ${EXACT})
add_comparison_test(NAME ranks_hertz_sphere SCENE hertz_sphere.prm SET "Refinement/Cycles=2" RUN 1 3)
foreach(scene nafems_roller verification/disk_above_block)
  get_filename_component(name ${scene} NAME)
  add_comparison_test(NAME complementarity_${name} SCENE ${scene}.prm OPTIONS --iterations 2
                      RUN 1 "1 | Contact solver/Complementarity factor=1e-3" "1 | Contact solver/Complementarity factor=1e3")
endforeach()

# Ironing: pressed and drawn on a coarse mesh, with either side as slave; in 3D the first steps, with and without friction. At most 6 iterations per increment.
set(SOUND "checks.tension <= 1e-9" "checks.penetration <= 1e-9" "checks.force_balance <= 1e-8" "checks.moment_balance <= 1e-8")
add_scene_test(NAME ironing SCENE ironing.prm SET "End time=1.1" "Increments=110" "Body block/Cells=48,8" "Contact ironing/Slave=second"
               CHECK ${SOUND} "checks.coulomb_cone <= 1e-9" "newton.:.iterations <= 6" "pairs.0.n_slip >= 5" "pairs.0.normal_force.1 ~ -50.907 0.01"
                     "pairs.0.tangential_force.0 ~ 15.163 0.01")
# An open node beside the edge whose gap is negative at the node itself has not passed through the other side.
add_scene_test(NAME ironing_open_on_average SCENE ironing.prm SET "End time=1.1" "Increments=60" "Body block/Cells=48,8" "Contact ironing/Slave=second"
               CHECK ${SOUND} "cut_backs == 0" "linear_solves <= 450")
# Half as many increments, of which one is cut back: no more of them are needed to see what they are worth.
add_scene_test(NAME ironing_measured_with_cuts SCENE ironing.prm SET "End time=1.3" "Increments=80" "Body block/Cells=24,4"
               CHECK ${SOUND} "error_estimate.increments <= 0.02" "cut_backs == 0" "linear_solves <= 530")
add_scene_test(NAME ironing_stiff_slave SCENE ironing.prm SET "End time=1.05" "Increments=105" "Body block/Cells=48,8" "Contact ironing/Slave=first"
               CHECK ${SOUND} "checks.coulomb_cone <= 1e-9" "newton.:.iterations <= 8" "pairs.0.normal_force.1 ~ 48.285 0.01"
                     "pairs.0.tangential_force.0 ~ -14.228 0.01")
foreach(mu 0 0.3)
  add_scene_test(NAME ironing_3d_mu_${mu} SCENE ironing_3d.prm SET "End time=0.2" "Increments=4" "Contact ironing/Friction coefficient=${mu}"
                 CHECK ${SOUND} "newton.:.iterations <= 6" "newton.:.residual <= 1e-9")
endforeach()

# Either side as slave: the same forces while it begins to slide (quadratic elements, a shorter block).
add_comparison_test(NAME ironing_slaves SCENE ironing.prm SET "End time=1.05" "Increments=42" "Discretization/Degree=2" "Body block/Upper corner=4,0" "Body block/Cells=24,6"
                    RUN "1 | Contact ironing/Slave=second" "1 | Contact ironing/Slave=first" OPTIONS --tolerance 0.01 --history 1)

# The beam meets the wall and snaps along it; the arch leaves its indenter and is caught again.
foreach(scene wall_buckling snap_away)
  add_scene_test(NAME ${scene} SCENE ${scene}.prm CHECK "checks.tension <= 1e-9" "checks.penetration <= 1e-9" "checks.force_balance <= 1e-6"
                 "status is converged" "pairs.0.n_slip >= 1")
endforeach()

# Contact that grows with friction at finite strain: the target is kept with the increments' part (5 meshes and 4,126 unknowns; where nodes that close did not
# stick, the shear had a peak at the edge of each increment: 7 meshes, 7,204 unknowns, 14 %).
add_scene_test(NAME target_of_growing_contact SCENE verification/rubber_indentation.prm
               SET "Body block/Poisson ratio=0.3" "Contact top/Friction coefficient=0.3" "Obstacle cylinder/Displacement=0| -0.15*t" "Increments=automatic"
                   "Refinement/Target error=0.1" "Refinement/Initial refinements=3"
               CHECK ${KEPT_FINITE} "error_estimate.shear <= 0.0866" "error_estimate.increments <= 0.05" "dofs <= 5500" "meshes.-1.mesh <= 6")

# Pressure on a surface that a body is pressed into acts under the contact, on any mesh, and the estimate knows of it; not where bodies lie on each other from the
# start, wherever they slide. (Force: of a uniform mesh with 16 times as many cells as the first.)
add_scene_test(NAME fluid_pressure SCENE verification/fluid_pressure.prm
               CHECK ${KEPT_FINITE} "pairs.0.normal_force.1 ~ -55.953 1e-3" "error_estimate.contact <= 0.01" "dofs <= 3000")
add_scene_test(NAME fluid_pressure_small SCENE verification/fluid_pressure.prm SET "Kinematics=small strain"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -54.017 1e-3" "dofs <= 3000")
foreach(slave first second)
  add_scene_test(NAME patch_finite_punch_${slave} SCENE verification/patch_punch.prm SET "Kinematics=finite strain" "Contact interface/Slave=${slave}"
                 CHECK ${KEPT_FINITE} "reference.errors.nodal_peak_pressure <= 1e-9" "newton.:.iterations <= 10")
endforeach()

# What is there at t = 0 comes whole in the first increment, however short; where that fails it is applied before, with the same end.
add_scene_test(NAME loads_at_start SCENE verification/rubber_indentation.prm SET "Obstacle cylinder/Displacement=0| -0.5"
               CHECK ${KEPT_FINITE} "meshes.0.t ~ -0.9 1e-9" "meshes.-1.t == 1" "pairs.0.normal_force.1 ~ -0.43227 1e-5" "energy ~ 0.0914300 1e-5") # as with -0.5*t

# Nodes that close and slip in the same increment (closed forms in the scene).
add_scene_test(NAME oblique_touch SCENE verification/oblique_touch.prm
               CHECK ${KEPT_FINITE} "meshes.0.pairs.0.tangential_force.0 ~ -5 1e-5" "pairs.0.tangential_force.0 ~ -5 1e-5" "meshes.-1.dissipation ~ 1.5 1e-5")

# ---- Objectivity: what turns as a whole is not strained and does not slip

# Platen, obstacle and rigid body by their rotation vectors (all three, node by node: tests/discretization/supports.cc).
foreach(scene turned_obstacle turned_rigid_body)
  add_scene_test(NAME ${scene} SCENE verification/${scene}.prm CHECK ${EXACT_FINITE})
endforeach()

# ---- What the tables say

# Forces of nodes add up to the force of the pair; nothing presses where nothing is opposite.
add_scene_test(NAME punch_moment SCENE verification/punch_moment.prm
               CHECK "sum(contact.:.fy) ~ pairs.0.normal_force.1 1e-12" "contact.state=open.pressure == 0" "contact.X=0.pressure ~ 318.31 0.005"
                     "contact.X=-5.pressure ~ 275.66 0.01")
# Tied or stuck, the same solution has the same numbers.
add_comparison_test(NAME tied_or_stuck SCENE verification/flat_punch_axisymmetric.prm SET "Refinement/Cycles=3" "Refinement/Strategy=uniform" OPTIONS --any-iterations
                    RUN "1 | Contact top/Tied=true" "1 | Contact top/Friction coefficient=1000")
# The stick zone that bulk tension moves keeps its size.
add_scene_test(NAME bulk_tension SCENE verification/bulk_tension.prm
               CHECK ${LAWS} "newton.:.iterations <= 5" "pairs.0.stick_size ~ 0.2406915 0.002" "pairs.0.stick_centre.0 ~ 0.0510584 0.015" "pairs.0.centre.0 abs<= 5e-4"
                     "sum(contact.:.fx) ~ pairs.0.tangential_force.0 1e-10" "sum(contact.:.fy) ~ pairs.0.normal_force.1 1e-10")

# Pressed with friction, then turned in space about (1, 1, 1) and about the normal of the contact, on curved faces in the plane.
set(TURNED "status is converged" "checks.force_balance <= 1e-8" "newton.:.iterations <= 14")
set(ABOUT_Z "Boundary condition top/Displacement=0|0|-0.12*table(0: 0, 1: 1)" "Boundary condition top/Rotation=0|0|pi/2*table(1: 0, 2: 1)"
    "Boundary condition bottom/Rotation=0|0|pi/2*table(1: 0, 2: 1)")
foreach(slave first second)
  set(kept ${TURNED} "meshes.4:.energy ~ meshes.3.energy 1e-10" "meshes.4:.dissipation ~ meshes.3.dissipation 1e-9"
      "meshes.4:.pairs.0.peak_pressure ~ meshes.3.pairs.0.peak_pressure 1e-9" "meshes.3.dissipation >= 0.05" "pairs.0.n_slip == 0" "linear_solves <= 45")
  add_scene_test(NAME turned_with_friction_${slave} SCENE verification/turned_with_friction.prm SET "Contact interface/Slave=${slave}" CHECK ${kept})
  add_scene_test(NAME turned_with_friction_about_z_${slave} SCENE verification/turned_with_friction.prm SET "Contact interface/Slave=${slave}" ${ABOUT_Z}
                 CHECK ${kept})
  foreach(degree 1 2)
    add_scene_test(NAME turned_disk_q${degree}_${slave} SCENE verification/turned_disk.prm SET "Contact interface/Slave=${slave}" "Discretization/Degree=${degree}"
                   CHECK ${TURNED} "meshes.6:.energy ~ meshes.5.energy 1e-10" "meshes.6:.dissipation ~ meshes.5.dissipation 1e-9"
                         "meshes.6:.pairs.0.peak_pressure ~ meshes.5.pairs.0.peak_pressure 1e-9" "meshes.5.dissipation >= 3e-5")
  endforeach()
endforeach()

# ---- Finite strain: supports and closed nodes carry the forces of the answer

# Where the displacement is exact after one step, the dilatations of mean dilatation are not yet.
foreach(degree 1 2)
  add_scene_test(NAME cross_point_q${degree} SCENE verification/cross_point.prm SET "Discretization/Degree=${degree}"
                 CHECK "status is converged" "checks.force_balance <= 1e-10" "pairs.0.normal_force.0 ~ -9.09563554318478 1e-10"
                       "pairs.1.normal_force.0 ~ -9.09563554318478 1e-10" "pairs.2.normal_force.1 ~ 14.95562578914135 1e-10"
                       "reactions.4.force.0 ~ 9.09563554318478 1e-10" "newton.:.iterations <= 2")
endforeach()
# Nothing slips, so that rough and tied joints may stand for smooth ones: a node at the point cannot obey all of them.
set(CROSS "status is converged" "checks.force_balance <= 1e-10" "reactions.4.force.0 ~ 9.09563554318478 1e-10" "reactions.0.force.1 ~ -14.95562578914135 1e-10")
foreach(slave first second)
  add_scene_test(NAME cross_point_rough_${slave} SCENE verification/cross_point.prm CHECK ${CROSS}
                 SET "Contact upper/Friction coefficient=0.3" "Contact lower/Friction coefficient=0.3" "Contact left/Friction coefficient=1"
                     "Contact right/Friction coefficient=0.3" "Contact upper/Slave=${slave}" "Contact left/Slave=${slave}")
  add_scene_test(NAME cross_point_tied_${slave} SCENE verification/cross_point.prm CHECK ${CROSS}
                 SET "Contact upper/Tied=true" "Contact left/Friction coefficient=0.3" "Contact upper/Slave=${slave}" "Contact left/Slave=${slave}")
endforeach()
# Each part of a slave face under two masters keeps a node, whatever the mesh and the order of the pairs' names.
foreach(cells "4, 3" "5, 3" "7, 3" "9, 3")
  string(MAKE_C_IDENTIFIER "split_slave_${cells}" name)
  add_scene_test(NAME ${name} SCENE verification/split_slave.prm SET "Body base/Cells=${cells}"
                 CHECK "status is converged" "reactions.0.force.1 ~ -0.2333333333333333 1e-10" "reactions.1.force.1 ~ -0.2333333333333333 1e-10"
                       "pairs.1.peak_pressure ~ 0.2333333333333333 1e-9" "pairs.2.peak_pressure ~ 0.2333333333333333 1e-9")
endforeach()
add_scene_test(NAME split_slave_3d SCENE verification/split_slave_3d.prm
               CHECK "status is converged" "pairs.1.peak_pressure ~ 0.2333333333333333 1e-9" "pairs.2.peak_pressure ~ 0.2333333333333333 1e-9"
                     "pairs.1.normal_force.2 ~ -0.1633333333333333 1e-10")
# Next to nothing of a face below one of both: it lost every node to the other one, and was refused.
foreach(left 0.05 0.1)
  add_scene_test(NAME split_slave_at_${left} SCENE verification/split_slave.prm SET "Body base/Cells=1,1" "Body left/Upper corner=${left},1"
                     "Body right/Lower corner=${left},0"
                 CHECK "status is converged" "pairs.1.peak_pressure ~ 0.2333333333333333 1e-9" "pairs.2.peak_pressure ~ 0.2333333333333333 1e-9")
  add_scene_test(NAME split_slave_3d_at_${left} SCENE verification/split_slave_3d.prm SET "Body base/Cells=3,2,1" "Body left/Upper corner=${left},1,1"
                     "Body right/Lower corner=${left},0,0"
                 CHECK "status is converged" "pairs.1.peak_pressure ~ 0.2333333333333333 1e-9" "pairs.2.peak_pressure ~ 0.2333333333333333 1e-9")
endforeach()
foreach(which "left foot" "right foot")
  string(MAKE_C_IDENTIFIER "split_slave_tied_${which}" name)
  add_scene_test(NAME ${name} SCENE verification/split_slave.prm SET "Body base/Cells=1,1" "Body left/Upper corner=0.05,1" "Body right/Lower corner=0.05,0"
                     "Contact ${which}/Tied=true" "Kinematics=finite strain"
                 CHECK "status is converged" "reactions.0.force.1 ~ -0.01166667 1e-3")
endforeach()
foreach(degree 1 2)
  add_scene_test(NAME split_slave_finite_q${degree} SCENE verification/split_slave.prm SET "Kinematics=finite strain" "Discretization/Degree=${degree}"
                 CHECK "status is converged" "reactions.0.force.1 ~ -0.23333 1e-3" "reactions.1.force.1 ~ -0.23333 1e-3")
endforeach()
# Corners where two pairs meet, with friction: whichever sides are slaves, within 1 % of the forces of a mesh eight times as fine (10.467
# and -9.391 +- 0.001 across, with either slave).
foreach(side "wall/Slave=automatic" "wall/Slave=first" "wall/Slave=second" "left foot/Slave=second" "right foot/Slave=first")
  string(MAKE_C_IDENTIFIER "tee_${side}" name)
  add_scene_test(NAME ${name} SCENE verification/tee.prm SET "Contact ${side}"
                 CHECK "status is converged" "checks.force_balance <= 1e-9" "newton.:.iterations <= 4" "reactions.2.force.0 ~ 10.467 0.01" "reactions.3.force.0 ~ -9.391 0.01")
endforeach()

# ---- Friction that sets of states go in circles for

# Force of the slope (+-0.0202031 along its normal (-0.98995, 0.141421), 0.141421 along it): (0, 1/7), whatever the mesh.
foreach(cells "4, 1" "16, 2")
  string(MAKE_C_IDENTIFIER "steep_slope_${cells}" name)
  add_scene_test(NAME ${name} SCENE verification/steep_slope.prm SET "Body block/Cells=${cells}"
                 CHECK "status is converged" "pairs.0.normal_force.0 ~ -0.02 1e-9" "pairs.0.tangential_force.1 ~ 0.14 1e-9" "checks.coulomb_cone <= 1e-9"
                       "checks.force_balance <= 1e-8" "newton.:.iterations <= 25")
endforeach()
# Far beyond what holds the block everywhere.
foreach(friction 2 5 20)
  add_scene_test(NAME greco_friction_${friction} SCENE greco.prm SET "Contact base/Friction coefficient=${friction}" "Increments=1"
                 CHECK "status is converged" "checks.coulomb_cone <= 1e-9" "checks.slip_direction <= 1e-6" "checks.tension <= 1e-9" "checks.force_balance <= 1e-9")
endforeach()

# Klarbring's example in closed form: 5.5/10 of the pressure left where it slips; beyond a coefficient of 19/9 slip would be unstable. (Where three solutions
# stand side by side: parameters/studies/map_klarbring.prm.)
add_scene_test(NAME klarbring_slips SCENE verification/klarbring.prm CHECK "pairs.0.normal_force.1 ~ 0.55 1e-9" "pairs.0.tangential_force.0 ~ -0.55 1e-9")
add_scene_test(NAME klarbring_sticks SCENE verification/klarbring.prm SET "Contact base/Friction coefficient=4"
               CHECK "pairs.0.normal_force.1 ~ 1 1e-9" "pairs.0.tangential_force.0 ~ -1.5 1e-9" "pairs.0.n_stick >= 1")

# ---- Gaps that forces close

# The motion over 300 sizes leaves 300 x 1e-16 x the stiffness of rounding, some 1e-5 of the force.
foreach(gap 1 300)
  math(EXPR bottom "1 + ${gap}")
  math(EXPR top "2 + ${gap}")
  add_scene_test(NAME far_gap_${gap} SCENE verification/far_gap.prm
                 SET "Body upper/Lower corner=0, ${bottom}" "Body upper/Upper corner=2, ${top}" "Obstacle press/Centre=1, ${top}"
                 CHECK "status is converged" "pairs.:2.normal_force.1 ~ 0.2 2e-5" "newton.:.iterations <= 6")
endforeach()

# ---- Residuals that rounding holds up

# A displacement of 3e-4 is known to 5e-20, which E/(1 - 2 nu) = 5e12 times some ten DoFs turns into a force of 3e-6.
foreach(friction "10" "0.1")
  add_scene_test(NAME gap_closes_on_incompressible_${friction} SCENE verification/gap_closes_on_incompressible.prm SET "Contact joint/Friction coefficient=${friction}"
                 CHECK "status is converged" "pairs.0.normal_force.1 ~ -1 1e-5" "newton.:.iterations <= 8")
endforeach()
foreach(slave first second)
  add_scene_test(NAME turned_rings_${slave} SCENE verification/turned_rings.prm SET "Contact interface/Slave=${slave}"
                 CHECK "status is converged" "reference.errors.pressure_l2 <= 0.02" "newton.:.iterations <= 8")
endforeach()

# Where a law ends, the message says so. (One step, too large; it would fail at t = 0.8 in any.)
add_scene_test(NAME law_ends SCENE verification/rubber_indentation.prm FAILS
               SET "Body block/Law=St. Venant-Kirchhoff" "Body block/Poisson ratio=0.3" "Increments=1" "Minimum increment=1" "Refinement/Cycles=0"
               CHECK "message has takes no more load beyond a compression by 42 %")

# A body that is slave in two pairs takes both states to a finer mesh: all of its nodes began open there, 5 to 8 iterations.
add_scene_test(NAME three_spheres SCENE verification/three_spheres.prm CHECK "status is converged" "newton.:.iterations <= 3" "pairs.1.normal_force.2 ~ 250 1e-6")

# ---- Rubber between several walls, with friction

# To full squeeze, wherever a wall stands that the ring does not reach. On a mesh twice as fine with twice the increments: 405.047, and without any wall
# 405.05; the half: 439.4 on a mesh four times as fine with 20 increments.
foreach(wall 22.4 40)
  add_scene_test(NAME o_ring_wall_${wall} SCENE verification/o_ring.prm SET "Obstacle wall/Centre=${wall}, 0"
                 CHECK "status is converged" "pairs.0.normal_force.1 ~ 405.05 1e-3" "newton.:.iterations <= 20" "checks.coulomb_cone <= 1e-6"
                       "error_estimate.contact <= 0.1")
endforeach()
add_scene_test(NAME o_ring_half SCENE verification/o_ring_half.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 439.4 0.005" "pairs.1.peak_pressure >= 0.5" "checks.coulomb_cone <= 1e-6")

# A thin ring comes to lie on a plate, and leaves it from the middle on: half of the load of its elastica is
# P/2 = 1.43554/2 EI/H^2, H = 3, but for (0.1/3)^2 of shear and stretch. Node by node the set took up to 60 iterations and cuts.
add_scene_test(NAME thin_ring SCENE verification/thin_ring.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -6.6460 1e-3" "newton.:.iterations <= 20")

# ---- What faces what, growing interferences, facets

# A pair that touches nothing is told, also where surfaces may come to face each other later; what faces each other far away is found.
foreach(kinematics "small strain" "finite strain")
  string(REPLACE " " "_" name ${kinematics})
  add_scene_test(NAME untouched_${name} SCENE verification/no_contact.prm SET "Kinematics=${kinematics}" "Increments=1" "Refinement/Cycles=0"
                 CHECK "pairs.0.touched is False" "pairs.0.smallest_gap ~ 0.2 0.01" "notes.-1 has touched nothing at any time that was solved")
endforeach()
add_scene_test(NAME never_faced SCENE patch_test.prm SET "Kinematics=finite strain" "Increments=1" "Contact interface/Second=lower/bottom"
               CHECK "pairs.0.touched is False" "pairs.0.smallest_gap is None" "notes.-1 has nothing of one side is opposite")
add_scene_test(NAME piston SCENE verification/piston.prm FAILS # squeezed by its height: too much for small strain
               CHECK "message has kinematics" "pairs.0.n_slip >= 3" "pairs.0.touched is True" "pairs.0.normal_force.1 <= -20")
foreach(cycles 0 2)
  add_scene_test(NAME declared_gap_${cycles} SCENE verification/declared_gap.prm SET "Refinement/Cycles=${cycles}" CHECK ${EXACT})
endforeach()
# Gaps that jump inside of faces, with and without hanging nodes; the force of quadratic elements to 0.3 %.
add_scene_test(NAME punch_by_gap SCENE verification/punch_by_gap.prm
               CHECK "error_estimate.quantity <= 0.01" "pairs.0.normal_force.2 ~ -1.1772 0.01" "dofs <= 30000")
# The smallest gap is that of a node, not of one that hangs between closed and open ones.
add_scene_test(NAME smallest_gap_of_hanging_nodes SCENE verification/punch_by_gap.prm SET "Contact top/Initial gap=(x^2 + y^2)/20" "Obstacle punch/Displacement=0| 0| -0.1" "Discretization/Degree=2" "Refinement/Target error=0" "Refinement/Cycles=1" "Body block/Cells=3, 3, 3"
               CHECK "pairs.0.smallest_gap >= 0" "pairs.0.n_slip >= 10" "dofs >= 5000")
add_scene_test(NAME punch_by_gap_turned SCENE verification/flat_punch_axisymmetric.prm SET "Contact top/Initial gap=if(x<9, 0, 1)" "Obstacle punch/Half width=1e5" "Reference/Solution=flat_punch_axisymmetric(a = 9, delta = 0.01, E = 200e3, nu = 0.3)" "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=total force"
               CHECK "error_estimate.quantity <= 0.01" "error_estimate.contact <= 1" "reference.errors.normal_force <= 0.01" "reference.errors.contact_size <= 0.01" "dofs <= 6000")

# ---- What small strain leaves out

# Closed forms: r = (lambda/2, lambda/2, -lambda/2 - mu) s^2 of a uniaxial strain s, r:C^-1:r against (lambda + 2 mu) s^2: 0.7721 s; in simple shear g/2, with g = 1e-3; over a history its largest strain.
set(UNIAXIAL "Body upper/Young modulus=100" "Body lower/Poisson ratio=0.3" "Reference/Solution=")
add_scene_test(NAME small_strain_uniaxial SCENE verification/patch_confined.prm SET ${UNIAXIAL} "Boundary condition top/Value=free|-0.01"
               CHECK "checks.neglected_strain ~ 0.00257369998716 1e-9" "checks.neglected_contact <= 1e-9"
                     "error_estimate.kinematics ~ checks.neglected_strain 1e-12")
add_scene_test(NAME small_strain_shear SCENE verification/simple_shear_finite.prm SET "Kinematics=small strain" "Boundary condition sides/Value=1e-3*t*y|0"
               CHECK "checks.neglected_strain ~ 5e-4 1e-9")
add_scene_test(NAME small_strain_history SCENE verification/patch_confined.prm
               SET ${UNIAXIAL} "Boundary condition top/Value=free|-table(0: 0, 1: 0.03, 2: 0.01)" "End time=2" "Output times=1"
               CHECK "checks.neglected_strain ~ 0.00772109996149 1e-9" "meshes.-1.t == 2")
# Half of a cantilever, 2 thick, under 2.1 times Euler's load along it: it does not buckle, cut by its axis.
add_scene_test(NAME half_of_what_buckles SCENE verification/beam_on_floor.prm SET "Boundary condition sym/Boundaries=b/bottom" "Boundary condition p/Boundaries=b/right" "Boundary condition p/Value=100"
                   "Obstacle floor/Centre=0, 1.2" "Obstacle floor/Normal=0, -1" "Contact c/First=b/top"
               CHECK "status is converged" "notes.0 has shows in a run of the whole" "checks.neglected_stiffening <= 0.05")
# Behind planes of symmetry bodies go on: what is stout is stout when it is cut.
add_scene_test(NAME small_strain_of_a_quarter SCENE hertz_sphere.prm SET "Refinement/Cycles=2" "Refinement/Target error=0"
               CHECK "checks.neglected_stiffening == 0" "checks.neglected_strain >= 1e-3")
# The cylinder has moved to the left by s = 0.6: the nodes that carry it have gaps of (s^2/2 + s x)/R, whose work is F (s^2/2 + 4 a s/(3 pi))/R,
# against twice the energy of 3.030.
# Half of Euler's load; 3 (tan k - k)/k^3 3.64e-3 at the tip.
add_scene_test(NAME auto_column_of_blocks SCENE verification/tied_column.prm
               CHECK "status is converged" "checks.neglected_stiffening ~ 0.5 0.01" "probes.0.points.0.displacement.0 ~ 7.23e-3 0.01" "notes.0 has finite strain is used")
add_scene_test(NAME small_strain_of_a_column SCENE verification/tied_column.prm FAILS SET "Kinematics=small strain" CHECK "status has not converged" "message has kinematics")
add_scene_test(NAME tube_in_bore SCENE verification/tube_in_bore.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 4.7124993 1e-6" "energy ~ 27.4108354 1e-6" "notes.0 has mode of the mesh is unstable" "linear_solves <= 45")
# Finite strain changes the energy from 0.2700444 to 0.2697274, and the pressure, which the edges make infinite, by ten times as much.
add_scene_test(NAME small_strain_of_an_energy SCENE verification/two_leaves.prm
               SET "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=energy" "Boundary condition load/Value=0|-0.5"
               CHECK "status is converged" "error_estimate.quantity_kinematics ~ 0.001174 0.02" "energy ~ 0.2700444 1e-5" "checks.neglected_strain >= 2")
# Down and back: the arch has snapped through, which only the increments on the way show.
add_scene_test(NAME auto_of_a_way_back SCENE snap_away.prm SET Kinematics=auto Increments=automatic "Obstacle indenter/Displacement=0|table(0:0, 0.5:-4.5, 1:0)"
               CHECK "status is converged" "probes.0.points.0.displacement.1 ~ -4.288 1e-3" "notes.0 has on a way that comes back")
# Small strain leaves out 4.4 times what it keeps: finite strain from the first mesh on.
add_scene_test(NAME auto_leaves_small_strain SCENE verification/two_leaves.prm SET Kinematics=auto "Refinement/Cycles=-1" "Refinement/Target error=0.03"
               CHECK "status is converged" "probes.0.points.0.displacement.1 ~ -2.157 1e-3" "linear_solves <= 80")
# What gave way to finite strain on the first mesh stays with it, though what that changes there is less than the target.
add_scene_test(NAME auto_leaves_small_strain_for_good SCENE verification/two_leaves.prm SET Kinematics=auto "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Boundary condition load/Value=0|-0.6"
               CHECK "status is converged" "error_estimate.contact <= 0.03" "notes.-1 has is not small beside the rest")
# 0.5 % by the mesh and 0.9 % by the kinematics: together more than the target.
add_scene_test(NAME auto_shares_the_target SCENE verification/quarter_cylinder.prm SET Kinematics=auto "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Initial refinements=3"
                   "Boundary condition cut/Value=free|-0.006"
               CHECK "status is converged" "notes.0 has finite strain is used" "pairs.0.normal_force.1 ~ 1178.4 1e-3" "error_estimate.contact <= 0.01")
# Beyond Euler's load, and something turns freely, which finite strain does not have.
add_scene_test(NAME auto_without_alternative SCENE verification/tied_column.prm FAILS
               SET "Boundary condition load/Type=platen" "Boundary condition load/Value=" "Boundary condition load/Force=0.0001*t|-3*t" "Boundary condition load/Displacement=free|free"
                   "Boundary condition load/Rotation=free" "Boundary condition load/Reference point=0.5, 10"
               CHECK "status has not converged" "checks.neglected_stiffening >= 1")
# A cantilever (E I = 1042) wraps onto the parabola x^2/800 up to a = 40 - E I/(400 F) = 26.98 under F = 0.2. Its load is too much at once for the trial by finite strain, which was lost (870 %).
add_scene_test(NAME small_strain_wrapped SCENE verification/beam_on_floor.prm
               SET "Kind=plane stress" "Body b/Upper corner=40,0.5" "Body b/Cells=80,1" "Body b/Young modulus=1e5" "Body b/Poisson ratio=0" "Obstacle floor/Centre=0,0" "Boundary condition sym/Type=total force"
                   "Boundary condition sym/Value=0|-0.2" "Boundary condition p/Value=0" "Contact c/Initial gap=x^2/800" "Refinement/Target error=0.02" "Refinement/Target quantity=total force"
               CHECK "status is converged" "error_estimate.quantity_kinematics <= 0.01" "pairs.0.normal_force.1 ~ 0.2 1e-4")
# Nothing touches for three quarters of the way: errors of nothing stood still on meshes that did not resolve the contact later ("out of reach", 0.1003).
add_scene_test(NAME touched_late SCENE verification/disk_above_block.prm
               SET "Boundary condition load/Type=displacement" "Boundary condition load/Value=0|-table(0: 0, 0.75: 0.499, 1: 0.502)" "Contact line/Friction coefficient=0.2" "Increments=4"
                   "Refinement/Cycles=-1" "Refinement/Target error=0.05" "Reference/Solution="
               CHECK "status is converged" "error_estimate.shear <= 0.05" "pairs.0.peak_pressure ~ 2.277 5e-3")
# The last of the meshes, which ended by the smallest cells at the tips, closed two nodes at the clamp: a force of 1.6636 and a size of 15.7. 1.1034 on ten meshes, and with cells 8 times finer.
add_scene_test(NAME leaf_spring SCENE verification/leaf_spring.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 1.0400 1e-3" "pairs.1.normal_force.1 ~ 1.1034 1e-3" "pairs.1.contact_size <= 0.005" "dofs <= 30000")
# Two blocks turn on a soft one by 12 M L/(E' h^3) = 0.0524, which stretches them by half the square of that, 8.3 times the strain that there is, were the turn no rotation.
add_scene_test(NAME small_strain_turned_freely SCENE verification/tied_column.prm
               SET "Kinematics=small strain" "Boundary condition load/Type=platen" "Boundary condition load/Value=" "Boundary condition load/Force=0|0" "Boundary condition load/Displacement=free|free"
                   "Boundary condition load/Rotation=free" "Boundary condition load/Moment=0.012*t" "Boundary condition load/Reference point=0.5, 10" "Body lower/Young modulus=10"
               CHECK "status is converged" "checks.neglected_strain ~ 0.0749 0.02" "probes.0.points.0.displacement.0 ~ -0.4194 5e-3")
foreach(half_width 1.01 1.03)
  add_scene_test(NAME edge_beyond_nodes_${half_width} SCENE verification/edge_beyond_nodes.prm SET "Obstacle support/Half width=${half_width}"
                 CHECK "status is converged" "pairs.0.peak_pressure <= 5" "pairs.0.normal_force.1 ~ 1 1e-8")
endforeach()
add_scene_test(NAME auto_pinched SCENE verification/rubber_bush.prm CHECK "status is converged" "notes.0 has small strain is enough" "pairs.0.normal_force.1 ~ -15.83 0.02")
# From the answer of small strain Newton's method goes to another state, where one leaf has passed through the other.
add_scene_test(NAME small_strain_of_slender_bodies SCENE verification/two_leaves.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01"
               CHECK "status is converged" "checks.change_of_answer <= 0.5" "probes.0.points.0.displacement.1 ~ -2.16 5e-4" "notes.-2 has by 0.0" "notes.-1 has what small strain leaves out")
add_scene_test(NAME small_strain_moved_away SCENE hertz_cylinder.prm FAILS SET "Obstacle cylinder/Displacement=-0.6*t|free"
               CHECK "checks.neglected_contact ~ 1.991 0.02" "energy ~ 3.030 1e-3" "message has kinematics: small strain leaves out")

# A mesh that is too coarse for its contact says so (peak pressure 45 and 5 % off).
add_scene_test(NAME coarse_contact_warning SCENE hertz_sphere.prm SET "Refinement/Cycles=0"
               CHECK "status is converged" "notes.0 has warning: the pressure is known to" "reference.errors.peak_pressure >= 0.2")
add_scene_test(NAME fine_contact_no_warning SCENE hertz_sphere.prm SET "Refinement/Cycles=2" CHECK "status is converged" "notes.-1 has symmetry planes")

# Homogeneous: told 0.0578 of a force that is 0.0576 off (0.0453 were told); with nu = -0.5 told 0.11 of 0.082 (0.0385, so that 5 % were taken for kept).
set(SHORTENED "Body lower/Young modulus=1000" "Boundary condition top/Value=free|-0.225" "Reference/Solution=")
add_scene_test(NAME kinematics_of_blocks SCENE patch_test.prm SET ${SHORTENED} "Body lower/Poisson ratio=0.3"
               CHECK "status is converged" "error_estimate.kinematics ~ 0.0578 2e-3")
add_scene_test(NAME auto_of_widening_blocks SCENE patch_test.prm SET ${SHORTENED} "Body lower/Poisson ratio=-0.5" "Body upper/Poisson ratio=-0.5" Kinematics=auto "Refinement/Target error=0.05"
               CHECK "status is converged" "notes.0 has finite strain is used" "pairs.0.normal_force.1 ~ -212.885784 1e-8")
# Two meshes had a peak 0.9 % too high alike: 0.25 % were told.
add_scene_test(NAME peak_by_chance SCENE verification/sheared_half_disk.prm
               SET "Kinematics=small strain" "End time=1" "Contact sheared/Friction coefficient=0" "Body block/Young modulus=1000" "Body block/Lower corner=-1,-1" "Body block/Upper corner=1,0" "Body block/Cells=4,2"
                   "Body disk/Refinements=0" "Boundary condition load/Force=0|-4*t" "Boundary condition load/Rotation=0" "Refinement/Cycles=-1" "Refinement/Target quantity=peak pressure" "Refinement/Target error=0.003"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 26.548 4.5e-3")
# Above the target a warning, above 10 % no answer; 'auto' finds the one of finite strain.
add_scene_test(NAME small_strain_warning SCENE hertz_sphere_axisymmetric.prm
               CHECK "status is converged" "notes.0 has warning: small strain leaves out 0.013" "error_estimate.kinematics ~ 0.0128 0.02")
add_scene_test(NAME small_strain_compression SCENE patch_test.prm FAILS SET "Boundary condition top/Value=free|-0.9"
               CHECK "status has not converged" "message has kinematics: small strain leaves out" "pairs.0.normal_force.1 ~ -89.5 0.01")
add_scene_test(NAME small_strain_rubber SCENE verification/rubber_indentation.prm FAILS SET "Kinematics=small strain"
               CHECK "status has not converged" "message has finite strain changes the answer by 0.25" "checks.change_of_answer ~ 0.25 0.1")

# ---- The error of the increments

# The answer of these does not depend on them; that of cylinders pressed together does: the estimate falls with their number.
foreach(scene greco floating_slab)
  add_scene_test(NAME increments_${scene} SCENE ${scene}.prm SET "Refinement/Cycles=2"
                 CHECK "error_estimate.increments <= 1e-9" "increments.number == 1" "increments.repeated_with == 2" "meshes.-1.increment == 1")
endforeach()
# True errors of the shear with 1 and 5 increments: 57 and 13 % of it.
foreach(case "1 2 0.38 2.3" "5 3 0.09 0.53" "80 40 0.003 0.02")
  separate_arguments(case)
  list(GET case 0 n)
  list(GET case 1 repeated)
  list(GET case 2 least)
  list(GET case 3 most)
  add_scene_test(NAME increments_two_cylinders_${n} SCENE verification/two_cylinders.prm
                 SET "Contact line/Friction coefficient=0.3" "Refinement/Cycles=3" "Boundary condition load/Force=0|-250*t" "Increments=${n}"
                 CHECK "status is converged" "increments.number == ${n}" "increments.repeated_with == ${repeated}" "error_estimate.increments >= ${least}"
                       "error_estimate.increments <= ${most}" "increments.shear >= 0.002" "meshes.-1.increment == ${n}")
endforeach()

# The mesh is for the worst of the increments: it does not forget the contact where the load is taken off again (1484 unknowns with the load that stays, too; 996
# for a thousandth of the load alone).
add_scene_test(NAME unloaded_two_cylinders SCENE verification/two_cylinders.prm
               SET "Contact line/Friction coefficient=0.3" "Refinement/Cycles=3" "Increments=4" "Boundary condition load/Force=0|-250*table(0: 0, 0.5: 1, 1: 0.001)"
               CHECK "dofs == 1484" "checks.energy_balance <= 1e-6")

# ---- Found by independent tests (2026-11-24): each failed before

# Homogeneous, and stable: exact forces and energies at 35 and 40 % of compression.
add_scene_test(NAME compressed_rubber SCENE verification/compressed_rubber.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -2.98954 3.3e-06" "energy ~ 0.78904 1.3e-05" "cut_backs == 0")
add_scene_test(NAME compressed_rubber_more SCENE verification/compressed_rubber.prm SET "Obstacle plate/Displacement=0|-0.8*t" "Increments=10"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -4.0266 2.5e-05" "cut_backs == 0")
add_scene_test(NAME compressed_rubber_nu_0.4 SCENE verification/compressed_rubber.prm SET "Body block/Poisson ratio=0.4" "Obstacle plate/Displacement=0|-0.86*t"
               CHECK "status is converged" "error_estimate.contact <= 1e-8" "cut_backs == 0")
# Convex, and yet all nodes at once run in circles: the closed ones are found by pivoting.
add_scene_test(NAME receding_layer SCENE verification/receding_layer.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 0.66 7.6e-03" "pairs.0.normal_force.1 ~ 0.5 2.0e-05" "newton.:.iterations <= 25")
add_scene_test(NAME stiff_slave SCENE verification/two_cylinders.prm
               SET "Body upper/Young modulus=7e9" "Contact line/Slave=first" "Discretization/Degree=1" "Refinement/Initial refinements=0" "Refinement/Cycles=7"
               CHECK "status is converged" "newton.:.iterations <= 25" "pairs.0.normal_force.1 ~ 250 4.0e-07")
# A small face beside a large one, on surfaces that are inclined to each other (Hertz for the force that is found: 64.9).
add_scene_test(NAME two_equal_disks SCENE verification/two_equal_disks.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 65.3 2.0e-02" "error_estimate.contact <= 0.02" "dofs <= 20000")
add_scene_test(NAME narrow_load SCENE verification/narrow_load.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ 10 1.0e-05")
add_scene_test(NAME beam_on_stop SCENE verification/beam_on_stop.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 2.3634 8.5e-04" "checks.change_of_answer <= 0.01")
# Resultants around a ring are rounding: what the increments do to them counts against the forces of all nodes.
add_scene_test(NAME increments_closed_ring SCENE verification/turned_rings.prm SET "Contact interface/Friction coefficient=0.2" "Increments=4" "Refinement/Cycles=0"
               CHECK "status is converged" "error_estimate.increments <= 0.05")
# A corner presses along the normals of its own faces: no answer (13 % of the load would act sideways). A block that slides off is said to.
add_scene_test(NAME corner_on_plane SCENE verification/corner_on_plane.prm FAILS
               CHECK "failure has broken" "checks.normal_mismatch >= 0.4" "message has corner of the slave")

# 24,708 unknowns on the way of steps; at once 68,112, since the second mesh tells the shear 3 times too wrong.
add_scene_test(NAME steps_of_a_history_in_space SCENE mindlin_sphere.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.25"
               CHECK "status is converged" "dofs <= 40000" "meshes.-1.reference.errors.shear_l2 <= 0.25" "meshes.-1.reference.errors.stick_size <= 0.05")
# 1.267 from a target of 0.3 %; with the stamp as slave or master. (It was 2.77, told 6.7 % off, where nothing was refined at first.)
add_scene_test(NAME small_stamp_first SCENE verification/small_stamp.prm SET "Contact stamp/Slave=first"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 1.267 0.05" "error_estimate.quantity <= 0.1")
add_scene_test(NAME small_stamp_second SCENE verification/small_stamp.prm SET "Contact stamp/Slave=second"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -1.267 0.05" "error_estimate.quantity <= 0.1")
# Friction that no node of the first mesh sees is not left out: 10*8*0.15 = 12 (was 0, told 0.5 %).
add_scene_test(NAME friction_between_nodes SCENE verification/striped_floor.prm
               CHECK "status is converged" "pairs.0.tangential_force.0 ~ -12 0.01" "pairs.0.normal_force.1 ~ 80 1e-6")
# Finite strain is tried from obstacles as they are turned, not as small strain makes them grow: what it changes was all of the force.
add_scene_test(NAME turning_shaft SCENE verification/turning_shaft.prm
               CHECK "status is converged" "checks.change_of_answer <= 0.01" "pairs.0.normal_force.0 ~ 4.4536 0.003")
# Where forces balance by themselves they do not say that kinematics matter little (was "converged", with a ring that has turned by 0.3).
add_scene_test(NAME torque_beyond_friction SCENE verification/torque_beyond_friction.prm FAILS
               CHECK "failure has small strain" "message has pair 'fit' slips: see whether its friction" "checks.change_of_answer >= 0.3")
# Meshes that miss the same ridge agree (was 0.1676, told 1.8 %).
add_scene_test(NAME narrow_ridge SCENE verification/narrow_ridge.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.2684 0.01" "dofs <= 8000")
# A node with one way left by a support, oblique to the surface. Statics: 40 tan(20 - atan(0.2)) at the wall, 40/(cos 20 + 0.2 sin 20) on the wedge.
foreach(kinematics "small strain" "finite strain")
  string(REPLACE " " "_" name "held_on_incline_${kinematics}")
  add_scene_test(NAME ${name} SCENE verification/held_on_incline.prm SET "Kinematics=${kinematics}"
               CHECK "status is converged" "pairs.0.n_stick == 0" "reactions.0.force.0 ~ 6.114 1e-3" "pairs.0.normal_force.1 ~ 37.286 1e-4" "pairs.0.tangential_force.0 ~ 7.457 1e-3")
endforeach()
# Small strain ends on a mesh that finite strain starts on: what is known of that mesh stays, and so do the increments (12,040 unknowns and three times longer without).
add_scene_test(NAME goes_on_with_what_is_known SCENE verification/sheared_half_disk.prm
               SET "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target error=0.05" "Refinement/Target quantity=contact pressure" "Boundary condition load/Force=0.6*table(1: 0, 2: 1)| -4*table(0: 0, 1: 1)"
               CHECK "status is converged" "notes.1 has finite strain is used" "count(notes.:) == 2" "dofs <= 10000" "error_estimate.shear <= 0.05" "increments.shear <= 0.03")
# An edge of a slave may bear all on coarse meshes, along the mean of its normals, and meshes agree on a force that is not right: (-0.274, 0.812), told 0.4 %, for (-0.377, 0.825).
add_scene_test(NAME snap_hook SCENE verification/snap_hook.prm
               CHECK "status is converged" "dofs <= 15000" "pairs.0.normal_force.1 ~ 0.825 0.02" "pairs.0.normal_force.0 <= -0.32" "error_estimate.quantity >= 0.025")
# The corner of a slave has the normal of the obstacle: (0, -3.52), as where it is round or has a pair for each face (it was 6 % off, told 0.2, along that of its face). A mean normal is worse, and no answer on coarse meshes.
add_scene_test(NAME corner_tip SCENE verification/corner_tip.prm
               CHECK "status is converged" "checks.corner_forces <= 1e-3" "pairs.0.normal_force.0 abs<= 0.01" "pairs.0.normal_force.1 ~ -3.52 0.003")
add_scene_test(NAME corner_tip_small_strain SCENE verification/corner_tip.prm SET "Kinematics=small strain"
               CHECK "status is converged" "pairs.0.normal_force.0 abs<= 1e-9" "pairs.0.normal_force.1 ~ -3.52 0.03")
add_scene_test(NAME tilted_corner SCENE verification/tilted_corner.prm
               CHECK "status is converged" "pairs.0.normal_force.0 abs<= 1e-6" "pairs.0.normal_force.1 ~ 161.0 0.02")
add_scene_test(NAME tilted_corner_other_slave SCENE verification/tilted_corner.prm SET "Contact corner/Slave=second"
               CHECK "status is converged" "pairs.0.normal_force.0 abs<= 0.5" "pairs.0.normal_force.1 ~ -161.0 0.02")
add_scene_test(NAME tilted_corner_finite_strain SCENE verification/tilted_corner.prm SET "Kinematics=finite strain" "Refinement/Cycles=0" "Body upper/Rotate=10"
               CHECK "status is converged" "checks.corner_forces ~ 0.0738 0.02" "checks.normal_mismatch ~ 0.0738 0.02" "notes.-1 has along a wrong direction")
add_scene_test(NAME corner_tip_mean_normal SCENE verification/corner_tip.prm FAILS SET "Contact tip/First=beam/top, beam/right" "Refinement/Cycles=2"
               CHECK "failure has broken" "checks.corner_forces >= 0.3" "message has corner of the slave")
# With cells smaller than the contact it is one (as the error of the force, 0.36 aside, was not counted: not converged, (1.40, -3.31), told 0.09 %).
add_scene_test(NAME corner_tip_mean_normal_to_its_target SCENE verification/corner_tip.prm SET "Contact tip/First=beam/top, beam/right"
               CHECK "status is converged" "dofs <= 8000" "pairs.0.normal_force.0 abs<= 0.05" "pairs.0.normal_force.1 ~ -3.52 0.003" "error_estimate.quantity >= 0.005")
# Small strain is refined once; earlier output times have a note.
add_scene_test(NAME passing_disks SCENE verification/passing_disks.prm CHECK "status is converged" "pairs.0.normal_force.1 abs<= 1e-9" "notes.-1 has those of the first mesh")
add_scene_test(NAME passing_disks_friction SCENE verification/passing_disks.prm SET "Contact pair/Friction coefficient=0.2" "Increments=12" "Refinement/Target error=0.3"
               CHECK "status is converged" "notes.1 has is not small beside the rest" "newton.:.dofs <= 6000")

# Their platens' mean motions along the force, which the turn moves apart, are no approach.
add_scene_test(NAME turned_blocks SCENE verification/turned_blocks.prm
               CHECK "status is converged" "pairs.0.approach is None" "pairs.0.peak_pressure ~ 25.3205128 1e-6" "pairs.0.normal_force.0 ~ -50.6410256 1e-6" "pairs.0.normal_force.1 abs<= 1e-6")
add_scene_test(NAME short_roller SCENE verification/short_roller.prm CHECK "status is converged" "dofs <= 25000" "pairs.0.normal_force.2 ~ 10383 0.01")
# What is pulled does not buckle; a layer that is glued on is not slender (0.0038 by the layer alone).
add_scene_test(NAME half_strut_pressed SCENE verification/half_strut.prm CHECK "status is converged" "notes.0 has bear more than a cantilever")
add_scene_test(NAME half_strut_pulled SCENE verification/half_strut.prm SET "Boundary condition load/Value=-10" CHECK "status is converged" "count(notes.:) == 0")
add_scene_test(NAME coated_block SCENE verification/coated_block.prm CHECK "status is converged" "checks.neglected_stiffening abs<= 0")
# Facets of linear elements: 2.2 % off and told 0.9 %, and 13 % of the torque (G J theta/L = 0.6283) told 7 %, as nothing at the contact shows them.
add_scene_test(NAME round_column SCENE verification/round_column.prm
               CHECK "status is converged" "notes.0 has facets of linear ones leave out 0.1" "dofs <= 6000" "meshes.-1.reference.errors.pressure_l2 <= 0.01")
add_scene_test(NAME round_column_linear SCENE verification/round_column.prm SET "Discretization/Degree=1"
               CHECK "status is converged" "meshes.0.error_estimate.contact >= 0.1" "meshes.-1.reference.errors.pressure_l2 <= 0.02" "dofs <= 20000")
add_scene_test(NAME round_column_force_linear SCENE verification/round_column.prm
               SET "Discretization/Degree=1" "Boundary condition load/Force=0|0|0" "Boundary condition load/Displacement=0|0|-0.00625" "Refinement/Target quantity=total force"
               CHECK "status is converged" "pairs.0.normal_force.2 ~ 9.99 0.03" "error_estimate.quantity <= 0.03")
add_scene_test(NAME twisted_columns SCENE verification/twisted_columns.prm
               CHECK "status is converged" "reactions.0.moment.2 ~ -0.6283 0.005" "reactions.1.moment.2 ~ 0.6283 0.005" "dofs <= 10000")
# Hanging vertices on the circle while their displacement is the mean of their parents': -0.5404 and 0.5639.
add_scene_test(NAME twisted_columns_linear SCENE verification/twisted_columns.prm SET "Discretization/Degree=1" "Refinement/Target error=0" "Refinement/Initial refinements=0" "Refinement/Cycles=2"
               CHECK "status is converged" "dofs <= 5000" "reactions.0.moment.2 ~ -0.5518 1e-3" "reactions.1.moment.2 ~ 0.5518 1e-3")

# Contact that no point of integration sees: 0 and "converged" at both kinematics.
add_scene_test(NAME cone_just_touching SCENE verification/cone_just_touching.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -5.03e-5 0.01" "dofs <= 3000")
add_scene_test(NAME cone_just_touching_small SCENE verification/cone_just_touching.prm SET "Kinematics=small strain" CHECK "status is converged" "pairs.0.normal_force.1 ~ -4.985e-5 0.01")
add_scene_test(NAME wedge_between_nodes SCENE verification/cone_just_touching.prm SET "Kind=plane strain" "Kinematics=small strain" "Obstacle cone/Centre=0.623, 0" CHECK "status is converged" "pairs.0.normal_force.1 <= -0.01" "meshes.-1.error_estimate.contact <= 0.1")
add_scene_test(NAME touched_elsewhere SCENE verification/touched_elsewhere.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.3493 0.01" "pairs.0.normal_force.0 abs<= 1e-4")
add_scene_test(NAME touched_elsewhere_moving SCENE verification/touched_elsewhere.prm SET "End time=1" "Obstacle circle/Displacement=0.5*t| -0.001*t" CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.3493 0.01")
add_scene_test(NAME corner_between_nodes_first SCENE verification/corner_between_nodes.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -3.57e-4 0.02" "pairs.0.approach ~ 1e-5 1e-6")
add_scene_test(NAME corner_between_nodes_second SCENE verification/corner_between_nodes.prm SET "Contact corner/Slave=second" CHECK "status is converged" "pairs.0.normal_force.1 ~ 3.57e-4 0.05" "pairs.0.approach ~ 1e-5 1e-6")
# The first gap is 0 at the circle's lowest point, 9e-6 at the nearest point of integration: -7.6e-6, "exactly".
add_scene_test(NAME approach_from_first_gap SCENE verification/touched_elsewhere.prm SET "End time=1" "Obstacle circle/Displacement=0| -1e-6*t" "Refinement/Target quantity=approach" CHECK "status is converged" "pairs.0.approach ~ 1e-6 1e-6")
add_scene_test(NAME tilting_punch SCENE verification/tilting_punch.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -1.3345e-3 0.03" "pairs.0.approach is None")
# It tilts back: what was unseen at t = 0.5 alone ended the run with a force of 0 "on all meshes".
add_scene_test(NAME tilted_on_the_way SCENE verification/tilting_punch.prm
               SET "Obstacle punch/Displacement=0| -0.01001*table(0: 0, 0.5: 1, 1: 0)" "Obstacle punch/Rotation=0.1*table(0: 0, 0.5: 1, 1: 0)" "Contact punch/Friction coefficient=0.3"
               CHECK "status is converged" "pairs.0.touched is True" "dofs >= 600")
add_scene_test(NAME untilted_punch SCENE verification/tilting_punch.prm SET "Obstacle punch/Rotation=0" "Obstacle punch/Displacement=0| -0.0201*t" CHECK "status is converged" "pairs.0.approach ~ 1e-4 1e-9")
# The first mesh held the node at the circle's lowest point closed.
add_scene_test(NAME lifted_circle SCENE verification/touched_elsewhere.prm SET "End time=1" "Kinematics=small strain" "Obstacle circle/Centre=-1.07, 0.5" "Obstacle circle/Displacement=0| 1e-5*t" CHECK "status is converged" "pairs.0.touched is False" "pairs.0.smallest_gap ~ 1e-5 0.005")
# Contacts at the ends of lines are as small as those at sharp edges: no number was told before meshes of 10,000 unknowns; where bodies touch with nothing in
# the end, a gap of -1e-166 was taken for one that hides a contact, and meshes grew beyond 170,000 unknowns.
add_scene_test(NAME rough_leaves SCENE verification/rough_leaves.prm
               CHECK "status is converged" "dofs <= 3000" "error_estimate.quantity <= 0.05" "pairs.0.normal_force.1 ~ 5.475 0.005" "pairs.1.normal_force.1 ~ 4.753 0.005")
add_scene_test(NAME rough_leaves_let_go SCENE verification/rough_leaves.prm SET "End time=2" "Boundary condition load/Value=free| table(0: 0, 1: 1, 2: 0)" "Refinement/Target quantity=dissipation"
               CHECK "status is converged" "dofs <= 5000" "meshes.-1.dissipation ~ 0.0798 0.02")
add_scene_test(NAME followed_slide SCENE verification/followed_slide.prm
               CHECK "status is converged" "dofs <= 5000" "dofs >= 1500" "pairs.0.normal_force.1 ~ -2.930 3e-3" "pairs.0.tangential_force.0 ~ 0.879 3e-3" "error_estimate.shear <= 0.1")
# Let go in the end, where no mesh sees slip: what measures the error of the increments refined as often as the run had done (29 times).
add_scene_test(NAME followed_and_let_go SCENE verification/followed_slide.prm
               SET "End time=2" "Increments=20" "Obstacle cylinder/Centre=2, 1.01" "Obstacle cylinder/Displacement=0| table(0: 0, 1: -0.05, 2: 0.05)"
               CHECK "status is converged" "pairs.0.n_slip == 0" "pairs.0.n_stick == 0" "error_estimate.contact <= 0.1")
# Numbers are compared between whole histories: it refined without end (240,594 unknowns at t = 0.25, told 93 % where the force is off by 1e-5).
add_scene_test(NAME followed_slide_force SCENE verification/followed_slide.prm SET "Refinement/Target quantity=total force" "Increments=20"
               CHECK "status is converged" "dofs <= 4000" "pairs.0.normal_force.1 ~ -2.930 0.05" "notes.0 has 'Refinement/History = replay' instead of 'transfer'")
add_scene_test(NAME light_second_circle SCENE verification/light_second_circle.prm CHECK "status is converged" "pairs.1.normal_force.1 ~ -0.0085 0.02")

# The first bump alone: -0.3486 (small strain sees both: -0.3626).
add_scene_test(NAME second_bump SCENE verification/second_bump.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.3623 0.004" "dofs <= 5000")
add_scene_test(NAME second_bump_small SCENE verification/second_bump.prm SET "Kinematics=small strain" CHECK "status is converged" "pairs.0.normal_force.1 ~ -0.3623 0.004")
# The tip of a tilted wedge is at rest at the surface: its approach was -3e-5 to 8e-6 by the mesh.
add_scene_test(NAME approach_of_tip SCENE verification/cone_just_touching.prm SET "Kind=plane strain" "Obstacle cone/Centre=0.623, 0" "Refinement/Target quantity=approach" CHECK "status is converged" "pairs.0.approach ~ 1e-4 1e-4")
# Numbers of meshes were compared at increments whose contact is a node wide, too, and forgotten there: 13,226 DoFs, sizes by displacements over a minute.
add_scene_test(NAME size_of_growing_contact SCENE verification/touched_elsewhere.prm
               SET "Refinement/Target quantity=contact size" "Refinement/Target error=0.01" "Contact bump/Friction coefficient=1" "Kinematics=small strain" "End time=1" "Obstacle circle/Displacement=0| -0.01*t"
               CHECK "status is converged" "dofs <= 8000" "error_estimate.quantity <= 1e-3")

# What takes longest is started first.
foreach(name ironing_slaves half_space_box two_spheres_3d_q2 wall_buckling snap_away cattaneo_mindlin_75 cattaneo_mindlin_270 mindlin_sphere_nu_0 mindlin_sphere_nu_0.3
        slide_over_edges_first iterations_punch_40_increments)
  set_tests_properties(scenes/${name} PROPERTIES COST 10)
endforeach()

# ---- Curved surfaces that move along each other, quadratic elements: no saw-tooth (doc/introduction.md, "Curved slave surfaces")

# A cap that has crossed its clearance and turned in its seat: the pressure stays uniform.
add_scene_test(NAME cap_in_seat_first SCENE verification/cap_in_seat.prm SET "Contact seat/Slave=first" "Refinement/Cycles=1"
               CHECK "reference.errors.pressure_l2 <= 0.006" "reference.errors.nodal_peak_pressure <= 0.05")
add_scene_test(NAME cap_in_seat_second SCENE verification/cap_in_seat.prm SET "Contact seat/Slave=second" "Refinement/Cycles=2"
               CHECK "reference.errors.pressure_l2 <= 0.016" "reference.errors.nodal_peak_pressure <= 0.035")
foreach(slave first second)
  add_scene_test(NAME cap_in_seat_3d_${slave} SCENE verification/cap_in_seat_3d.prm SET "Contact seat/Slave=${slave}" "Refinement/Cycles=1"
                 CHECK "reference.errors.pressure_l2 <= 0.045")
endforeach()

# Persson's pin with a wide contact (69.7 degrees) and a narrow one (27.1): closed forms at 0, 11.25, 22.5 and 33.75 degrees. (The nodes of the
# hole are listed from its other end.)
set(at_first 0 4 8 12)
set(at_second -1 -5 -9 -13)
foreach(slave first second)
  list(GET at_${slave} 0 a)
  list(GET at_${slave} 1 b)
  list(GET at_${slave} 2 c)
  list(GET at_${slave} 3 d)
  add_scene_test(NAME pin_in_hole_70_${slave} SCENE verification/pin_in_hole.prm SET "Contact hole/Slave=${slave}" "Contact hole/Initial gap=0.000455"
                 CHECK "contact.${a}.pressure ~ 0.65084 0.01" "contact.${b}.pressure ~ 0.63998 0.01" "contact.${c}.pressure ~ 0.60713 0.01"
                       "contact.${d}.pressure ~ 0.55119 0.01")
  add_scene_test(NAME pin_in_hole_27_${slave} SCENE verification/pin_in_hole.prm
                 SET "Contact hole/Slave=${slave}" "Contact hole/Initial gap=0.0091" "Body pin/Refinements=4" "Body plate/Refinements=4"
                 CHECK "contact.${a}.pressure ~ 1.38384 0.02" "contact.${c}.pressure ~ 1.25846 0.02")
endforeach()

# A strip that slides around a drum: neighbouring nodes have the pressure exp(mu phi)/10 of their angles.
# All nodes are held at their bound after t = 2, but for rounding: no stick size that increments could change.
add_scene_test(NAME capstan_held_at_its_bound SCENE capstan.prm SET "End time=3" "Increments=12" CHECK "pairs.0.stick_size == 0" "pairs.0.n_stick >= 100" "error_estimate.increments <= 1e-8")
# Factors serve several increments, with the responses made by them: 38 solves; 64 with two systems for each.
add_scene_test(NAME few_factorisations SCENE cattaneo_mindlin.prm CHECK "linear_solves <= 42" "meshes.-1.reference.errors.dissipation <= 0.002")
add_scene_test(NAME capstan_pressure SCENE capstan.prm
               CHECK "contact.59.pressure ~ 0.119236 0.01" "contact.60.pressure ~ 0.119591 0.01")

# The pressure of a growing interference is that of the interference reached, also on meshes that are refined on the way or replayed, in any number of
# increments; nothing slips, and the work put in is stored.
set(GROWN "status is converged" "reference.errors.pressure_l2 <= 0.003" "checks.negative_dissipation <= 1e-9" "meshes.-1.external_work ~ 6.98 0.001")
foreach(increments 1 4)
  add_scene_test(NAME growing_interference_${increments} SCENE verification/growing_interference.prm SET "Increments=${increments}"
                 CHECK ${GROWN} "checks.energy_balance <= 1e-8" "pairs.0.peak_pressure ~ 22.2838014 1e-6")
endforeach()
foreach(history replay transfer)
  add_scene_test(NAME growing_interference_${history} SCENE verification/growing_interference.prm RANKS 2 SET "Refinement/Cycles=1" "Refinement/History=${history}"
                 CHECK ${GROWN} "checks.energy_balance <= 1e-8")
endforeach()
# (The reference is that of small strain.)
string(REPLACE "0.003" "0.004" GROWN "${GROWN}")
add_scene_test(NAME growing_interference_finite SCENE verification/growing_interference.prm SET "Kinematics=finite strain" CHECK ${GROWN} "checks.energy_balance <= 1e-4")

# A polygon in place of a circle: the estimate has its error, refined or not. As a mesh of second order, or with the circle declared, there are no facets.
foreach(cycles 0 3)
  add_scene_test(NAME facets_${cycles} SCENE verification/polygon_roller.prm SET "Refinement/Cycles=${cycles}"
                 CHECK "error_estimate.facets ~ reference.errors.pressure_l2 0.15" "error_estimate.contact >= 0.1" "notes.0 has touches on facets")
endforeach()
# Long arcs of second order meet at kinks, too: 2.3 % were told of a half disk where 9.2 were true.
add_scene_test(NAME kinks_of_second_order SCENE verification/polygon_roller.prm SET "Body roller/Mesh=coarse_round_roller.geo" "Refinement/Cycles=6"
               CHECK "error_estimate.facets ~ reference.errors.pressure_l2 0.25" "notes.0 has touches on arcs of second order")
set(ROUND "error_estimate.facets == 0" "reference.errors.nodal_peak_pressure <= 0.01" "error_estimate.contact <= 0.02" "reference.errors.pressure_l2 <= 0.015")
add_scene_test(NAME second_order_mesh SCENE verification/polygon_roller.prm SET "Body roller/Mesh=round_roller.geo" CHECK ${ROUND})
add_scene_test(NAME declared_circle SCENE verification/polygon_roller.prm SET "Body roller/Curved boundaries=arc = circle(0, 10)" CHECK ${ROUND})
# One increment would take the block through the beam.
add_comparison_test(NAME large_increment SCENE verification/large_increment.prm RUN "1 | Increments=1" "1 | Increments=12" OPTIONS --tolerance 1e-8 --history 1)

# Bodies that move by far more than their size leave nothing but rounding of their strain: the program's own checks say so.
add_scene_test(NAME lost_in_rounding SCENE hertz_cylinder.prm FAILS SET "Refinement/Cycles=1" "Boundary condition bottom/Value=0|1e12"
               CHECK "status has not converged" "message has equilibrium of forces" "checks.force_balance >= 1e-2")

# ---- What a tester found who had not seen the program (2026-11-24)

# Loads that turn without a table: 1/6 + 1/3 + 1/24 of work, and none where only zeros of the load are seen.
set(SINE "End time=2" "Boundary condition end/Value=if(t > 1, 10*sin(2*pi*(t - 1)), 0)|0")
add_scene_test(NAME microslip_bar_sine SCENE microslip_bar.prm SET ${SINE} "Increments=automatic" CHECK ${LAWS} "meshes.-1.dissipation ~ 0.541667 2e-3")
add_scene_test(NAME microslip_bar_sine_target SCENE microslip_bar.prm
               SET ${SINE} "Increments=automatic" "Refinement/Target error=0.05" "Contact base/Tresca bound=" "Contact base/Friction coefficient=0.01"
               CHECK ${LAWS} "meshes.-1.dissipation ~ 0.541667 5e-3")
# The bound falls to a half and rises again while the force stays: F^3/(6 E A tau) and twice that. Two and four equal increments passed the dip.
add_scene_test(NAME microslip_bar_bound_dips SCENE microslip_bar.prm
               SET "End time=2" "Increments=automatic" "Boundary condition end/Value=table(0: 0, 1: 6)|0" "Contact base/Tresca bound=1 - 0.5*exp(-((t-1.37)/0.05)^2)"
                   "Refinement/Target quantity=dissipation" "Refinement/Target error=0.03" "Refinement/Cycles=-1"
               CHECK "status is converged" "meshes.-1.dissipation ~ 0.108 0.01" "increments.number <= 20")
# Unstable: the trial by finite strain followed the motion on the finest mesh, and four increments did on the first one (2,334 solves).
add_scene_test(NAME column_of_disks SCENE verification/column_of_disks.prm
               CHECK "status is converged" "linear_solves <= 800" "pairs.2.normal_force.1 ~ -100 1e-6" "pairs.2.peak_pressure ~ 1874.8 2e-3" "notes.1 has finite strain failed" "error_estimate.kinematics ~ 0.00896 0.02")
# Sharp corners at finite strain, where cells turn inside out: refined at corners alone meshes are too alike for an estimate, and what is known is said.
add_scene_test(NAME deep_punch SCENE verification/deep_punch.prm
               CHECK "status is converged" "notes.-1 has the target error was not reached, as the finer mesh failed (the meshes before it are too alike to estimate one: total force changed by")
# Increments that were never tried: two of them, where eight tell another story. Finer meshes began each increment with the states of the mesh before, and the
# wedge jumped out when nothing pulled at it any more.
add_scene_test(NAME wedge_self_lock SCENE verification/wedge_self_lock.prm SET "Refinement/Target error=0.1"
               CHECK ${LAWS} "pairs.0.normal_force.0 ~ -18.375 1e-3" "pairs.0.tangential_force.1 ~ -3.675 1e-3" "notes.1 has the external work or that of friction is off by about")
# One increment for the way out finds this answer if it starts from it, and no tension at all if not: no reason to take one (it was, and let go on the third mesh).
add_scene_test(NAME wedge_self_lock_one_increment SCENE verification/wedge_self_lock.prm SET "Refinement/Target error=0.03" "Refinement/Cycles=3"
               CHECK "pairs.0.normal_force.0 ~ -18.375 1e-3" "meshes.-1.increment >= 4")
# Friction that does not matter, but holds.
# Loaded and unloaded: what was compared between meshes was what rounding leaves in the end (shear off by 1e11, 92,042 DoFs and more), stress and kinematics were told relative to it.
add_scene_test(NAME unloaded_to_nothing SCENE verification/small_shear.prm
               SET "Boundary condition load/Force=0|-1000*table(0:0, 1:1, 2:0)" "Boundary condition load/Displacement=0|free" "Body l/Young modulus=60000" "Refinement/Target error=0.2"
               CHECK "status is converged" "dofs <= 10000" "error_estimate.shear <= 0.2" "error_estimate.bulk <= 0.05" "error_estimate.kinematics <= 0.02" "notes.1 has less than 5 %" "pairs.0.normal_force.1 abs<= 1e-9")
# Twice, and to where both just touch: what is left there is no contact that meshes do not see.
add_scene_test(NAME pressed_twice_and_unloaded SCENE verification/small_shear.prm
               SET "End time=4" "Boundary condition load/Force=" "Boundary condition load/Displacement=0.002*table(0:0, 1:1, 2:-1, 3:1, 4:-1)|-0.01*table(0:0, 1:1, 2:0, 3:1, 4:0)" "Body l/Young modulus=60000" "Refinement/Target error=0.2"
               CHECK "status is converged" "dofs <= 10000" "error_estimate.shear <= 0.2")
# Mesh, increments and small strain keep their shares, their sum does not: the warning named the largest alone.
add_scene_test(NAME parts_miss_together SCENE verification/small_shear.prm
               SET "Boundary condition load/Force=" "Boundary condition load/Displacement=0.01*table(0:0, 1:1, 2:0)|-0.03*table(0:0, 1:1, 2:0.5)" "Refinement/Target error=0.1"
                   "Body l/Young modulus=70000" "Contact c/Initial gap=x^2/20"
               CHECK "status is converged" "notes.-1 has and small strain leaves out (0.03" "notes.-1 has and so does finite strain")
# What is left of a contact that was ten times as large (and more) is smaller than cells: no size of it is known there (the
# stick size was 0, and told right to 3.8 %).
add_scene_test(NAME stick_size_of_what_is_left SCENE verification/small_shear.prm
               SET "End time=3" "Boundary condition load/Force=150*table(1:0, 2:1, 3:0)|-1000*table(0:0, 1:1, 2:1, 3:0.01)" "Contact c/Initial gap=x^2/20"
                   "Refinement/Target error=0.1" "Refinement/Target quantity=stick size"
               CHECK "status is converged" "pairs.0.stick_size ~ 0.0341 0.1")
add_scene_test(NAME size_of_what_is_left SCENE verification/small_shear.prm
               SET "End time=3" "Boundary condition load/Force=150*table(1:0, 2:1, 3:0)|-1000*table(0:0, 1:1, 2:1, 3:0.001)" "Contact c/Initial gap=x^2/20" "Refinement/Target error=0.1"
               CHECK "status is converged" "notes.0 has smaller than cells then, and its size is not known")
add_scene_test(NAME small_shear SCENE verification/small_shear.prm CHECK ${LAWS} "status is converged" "pairs.0.tangential_force.0 ~ 0.03 1e-6")
# The way there was far beyond small strain, the end is not.
add_scene_test(NAME auto_comes_back SCENE verification/press_finite.prm
               SET "Kinematics=auto" "End time=2" "Contact above/Friction coefficient=0.05" "Obstacle above/Displacement=0|-0.1*table(0: 0, 1: 1, 2: 0.02)"
               CHECK "status is converged" "notes.0 has on a way that comes back: finite strain is used")
# A small contact may lie a little beside; it was refused for 0.85.
add_scene_test(NAME three_point_bending SCENE verification/three_point_bending.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 20 1e-9" "checks.change_of_answer <= 0.05" "probes.0.points.0.displacement.1 ~ -0.711 2e-3")
# The clamp drives the corner of the contact face through the floor: weighted gaps of its neighbours do not see it.
foreach(kinematics small finite)
  add_scene_test(NAME clamp_through_floor_${kinematics} SCENE verification/beam_on_floor.prm FAILS SET "Kinematics=${kinematics} strain" "Boundary condition clamp/Value=0|-0.3*t"
                 CHECK "failure has driven through" "message has through a rigid obstacle, at (0, 0)")
endforeach()
# Stress is singular where nothing touches; it took 87,000 unknowns, and an estimate of 6.6 % stayed.
add_scene_test(NAME beam_on_floor SCENE verification/beam_on_floor.prm CHECK "status is converged" "error_estimate.contact <= 0.01" "dofs <= 10000")
# Volumes that the projection does not see, in space: the force was half of it.
add_scene_test(NAME compressed_block_3d SCENE verification/compressed_block_3d.prm CHECK "status is converged" "reactions.0.force.2 ~ -4.8359 1e-3")
# Its edge has the plate's normal; what is beside it on the cube's face has not, and the run says so (46 % of the force went aside, and it was refused).
add_scene_test(NAME edge_on_plate_3d SCENE verification/edge_on_plate_3d.prm CHECK "status is converged" "checks.corner_forces ~ 0.0175 0.05" "notes.-1 has along a wrong direction")
# The first mesh says 1.2 %, and is off by 5.3 %.
add_scene_test(NAME target_not_on_first_mesh SCENE verification/pin_in_hole.prm
               SET "Refinement/Cycles=-1" "Refinement/Target error=0.03" "Discretization/Degree=2" CHECK "status is converged" "meshes.-1.mesh >= 1" "pairs.0.peak_pressure ~ 0.8064 0.015")
# A ring: about its mean radius, with Hertz's half-width of a line.
add_scene_test(NAME ring_contact SCENE verification/ring_contact.prm CHECK "status is converged" "pairs.0.contact_size ~ 0.23489 2e-3" "pairs.0.peak_pressure ~ 1355.1 5e-3" "pairs.0.centre.0 ~ 50 1e-3")

# ---- Found by independent tests (2026-11-25): each failed before

# Waves, and a bump that stands proud, narrower than the faces of the first mesh.
add_scene_test(NAME wavy_gap SCENE verification/wavy_gap.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 0.0025 2e-3" "pairs.0.normal_force.1 ~ -0.0015 1e-6" "error_estimate.contact <= 0.01")
foreach(place 0.1234 0.33)
  add_scene_test(NAME bump_at_${place} SCENE verification/wavy_gap.prm
                 SET "Contact face/Initial gap=x^2/20-1.2*${place}^2/20*exp(-((x-${place})/0.003)^2)" "Obstacle plate/Force=0|-1e-8"
                 CHECK "status is converged" "pairs.0.centre.0 ~ ${place} 1e-3")
endforeach()
# A tip of the gap between the nodes, with displacements: nothing touched. The force is that of a circle of the tip's radius of 0.05 in its place (1.0929e-5).
foreach(kinematics small finite)
  add_scene_test(NAME tip_by_displacement_${kinematics} SCENE verification/wavy_gap.prm
                 SET "Kinematics=${kinematics} strain" "Obstacle plate/Force=" "Obstacle plate/Displacement=0|-5e-5" "Contact face/Initial gap=1e-3*(1-exp(-((x-0.337)/0.01)^2))"
                 CHECK "status is converged" "pairs.0.normal_force.1 ~ -1.0929e-5 1e-2" "error_estimate.contact <= 0.01")
endforeach()
# The same whatever is asked for.
foreach(quantity "total force" energy)
  string(REPLACE " " "_" name "${quantity}")
  add_scene_test(NAME tip_by_displacement_${name} SCENE verification/wavy_gap.prm
                 SET "Obstacle plate/Force=" "Obstacle plate/Displacement=0|-5e-5" "Contact face/Initial gap=1e-3*(1-exp(-((x-0.337)/0.01)^2))"
                     "Refinement/Target error=0.02" "Refinement/Target quantity=${quantity}"
                 CHECK "status is converged" "pairs.0.normal_force.1 ~ -1.0929e-5 1e-2")
endforeach()
# One obstacle behind the other: the first pair had no nodes, and was refused. The force is 1446.7 by 1e5 DoFs.
add_scene_test(NAME stepped_punch SCENE verification/stepped_punch.prm
               CHECK "status is converged" "sum(pairs.0:.normal_force.1) ~ -1446.7 1e-2" "pairs.0.normal_force.1 <= -1200" "pairs.1.normal_force.1 <= -100")
# The one behind came through, and through the body: it had no nodes (0 for 80).
foreach(friction 0 0.3)
  # (Of twelve iterations in one increment rounding may make thirteen.)
  add_comparison_test(NAME overtaken_${friction} SCENE verification/overtaken.prm SET "Contact first/Friction coefficient=${friction}" "Contact second/Friction coefficient=${friction}"
                      OPTIONS --iterations 1 RUN 1 2 CHECK "status is converged" "meshes.t=1.pairs.0.normal_force.1 ~ 40 1e-9" "pairs.0.normal_force.1 abs<= 1e-9" "pairs.1.normal_force.1 ~ 80 1e-9")
endforeach()
# Both press at the same nodes, which obey one: 20 for 80/3 was "converged". With the other sides as slaves it is right.
add_scene_test(NAME pressed_by_two SCENE verification/pressed_by_two.prm
               CHECK "status is converged" "pairs.0.normal_force.1 abs<= 13.3334" "sum(pairs.0:.normal_force.1) ~ -26.6667 1e-5" "checks.overlap_behind <= 1e-9")
add_scene_test(NAME pressed_by_two_on_one_slave SCENE verification/pressed_by_two.prm SET "Contact one/Slave=first" "Contact other/Slave=first"
               CHECK "failure has broken laws" "message has no overlap with a master behind" FAILS)
# All in one increment, which is where the mesh is refined.
add_scene_test(NAME overtaken_on_finer_meshes SCENE verification/overtaken.prm SET "Increments=1" "Refinement/Cycles=2" "Refinement/Strategy=uniform"
               CHECK "status is converged" "meshes.-1.mesh == 2" "pairs.0.normal_force.1 abs<= 1e-9" "pairs.1.normal_force.1 ~ 80 1e-9")
add_scene_test(NAME overtaken_finite SCENE verification/overtaken.prm SET "Kinematics=finite strain"
               CHECK "status is converged" "pairs.0.normal_force.1 abs<= 1e-9" "pairs.1.normal_force.1 ~ 80.816 1e-4")
# A side that faces away from the roller, which is behind it, through the block: "overlapped by 4.3". The same as without it.
add_comparison_test(NAME round_obstacle_behind_a_side SCENE verification/growing_stick.prm
                    SET "Body block/Lower corner=-5,-1" "Body block/Upper corner=1,0" "Body block/Cells=8,4" "Obstacle roller/Centre=-3,1" "Obstacle roller/Radius=1"
                        "Obstacle roller/Displacement=0|-0.01*t" "Increments=2"
                    RUN "1 | Contact interface/First=block/top" "1 | Contact interface/First=block/top, block/right" OPTIONS --tolerance 1e-6 --forces-only --any-iterations CHECK "status is converged" "pairs.0.normal_force.1 <= -0.5")
# A peak that has no limit: what was claimed fell with the error of the pressure, of which it was thrice as much.
add_scene_test(NAME peak_of_a_cone SCENE verification/cone.prm SET "Refinement/Cycles=-1" "Refinement/Target quantity=peak pressure" "Refinement/Target error=0.03"
               CHECK "status is converged" "error_estimate.quantity >= 0.5" "meshes.-1.dofs <= 20000")
# Increments were measured where nothing stuck yet: 0.0314 came, one increment of which the stick size was known exactly; 0.03715 with 16 of them at 1 %.
foreach(case "small 0.03715" "finite 0.04233") # a mesh with few sticking nodes said 0.0357 at finite strain, with 5 %
  separate_arguments(case)
  list(GET case 0 kinematics)
  list(GET case 1 size)
  add_scene_test(NAME stick_size_of_growing_contact_${kinematics} SCENE verification/growing_stick.prm
                 SET "Body block/Cells=8,4" "Body block/Poisson ratio=0" "Contact interface/Friction coefficient=0.3" "Increments=automatic"
                     "Refinement/Cycles=-1" "Refinement/Target quantity=stick size" "Refinement/Target error=0.1" "Kinematics=${kinematics} strain"
                 CHECK "status is converged" "pairs.0.stick_size ~ ${size} 0.1" "meshes.-1.increment >= 4")
endforeach()
# Pairs count alike: the light cylinder was answered by three nodes, its peak a twelfth of Hertz's.
add_scene_test(NAME two_loads SCENE verification/two_loads.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 1870.3 1e-2" "pairs.1.peak_pressure ~ 187.03 1e-2" "pairs.1.contact_size ~ 0.034038 2e-3")
# `Adjust` that is no small part of the gap between the bodies makes a step there, whose peaks were told as those of a sharp edge.
foreach(adjust 1e-4 1e-3)
  add_scene_test(NAME step_by_adjust_${adjust} SCENE verification/two_equal_disks.prm SET "Kinematics=small strain" "Contact line/Adjust=${adjust}"
                 CHECK "notes.-1 has makes a step in the contact")
endforeach()
add_scene_test(NAME step_by_adjust_none SCENE verification/two_equal_disks.prm SET "Kinematics=small strain" "Contact line/Adjust=1e-7"
               CHECK "status is converged" "count(notes.:) == 3")
# `Adjust` on finer meshes: the surfaces were not found again.
add_scene_test(NAME adjusted_overlap SCENE verification/equal_blocks.prm
               SET "Body upper/Lower corner=-0.5,-0.001" "Contact face/Adjust=0.002" "Refinement/Target error=0" "Refinement/Cycles=2"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 2.2510 1e-3" "meshes.-1.mesh == 2")
# Finite strain leaves gaps open that `Adjust` closes, and adds declared ones: `approach` begins where the bodies touch (it took none away).
add_scene_test(NAME approach_adjusted SCENE verification/two_equal_disks.prm
               SET "Kinematics=finite strain" "Body upper/Centre=0, 1.005" "Contact line/Adjust=0.01"
               CHECK "status is converged" "pairs.0.approach ~ 0.035 1e-9")
add_scene_test(NAME approach_declared SCENE verification/two_equal_disks.prm
               SET "Kinematics=finite strain" "Body upper/Centre=0, 1.005" "Contact line/Initial gap=0.002"
               CHECK "status is converged" "pairs.0.approach ~ 0.033 1e-6")
add_scene_test(NAME approach_of_growing_gap SCENE verification/two_equal_disks.prm
               SET "Kinematics=finite strain" "Body upper/Centre=0, 1.005" "Contact line/Initial gap=0.002*t" "Increments=3"
               CHECK "status is converged" "pairs.0.approach ~ 0.033 1e-6")
# Flanks that lean away by more than 72 degrees are not opposite: without them in the list the force is the same.
foreach(sides "punch/bottom" "punch/bottom, punch/left, punch/right")
  string(REGEX REPLACE "[^a-z]+" "_" name "${sides}")
  add_scene_test(NAME flanks_of_${name} SCENE verification/punch_with_flanks.prm SET "Contact punch/Second=${sides}"
                 CHECK "status is converged" "pairs.0.normal_force.1 ~ -88.616 1e-4" "cut_backs == 0")
endforeach()

# ---- Found by independent tests (2026-11-25, later): each failed before

# Round bodies without friction: facets keep them from turning, where nothing else does; the iteration went in circles for minutes, or did not settle.
# (With small strain the disk sinks as seen from where it was: the load is a hundredth.)
foreach(case "small strain;0.01" "finite strain;1" "auto;1")
  list(GET case 0 kinematics)
  list(GET case 1 load)
  string(MAKE_C_IDENTIFIER "${kinematics}" name)
  add_scene_test(NAME disk_in_groove_${name} SCENE verification/disk_in_groove.prm SET "Kinematics=${kinematics}" "Body disk/Body force=0|-10*${load}*t"
                 CHECK "status is converged" "pairs.0.normal_force.0 ~ pairs.0.normal_force.1 2e-3" "newton.:.iterations <= 12"
                       "checks.force_balance <= 1e-8" "notes.-1 has nothing keeps it from turning")
endforeach()
# Its weight works along the way down: the forces at the start of an increment are lost with the mesh, their work is not (it was 10 % off).
add_scene_test(NAME disk_in_groove_refined SCENE verification/disk_in_groove.prm SET "Refinement/Cycles=2" "Body disk/Refinements=1"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 15.708 1e-4" "meshes.-1.external_work ~ energy 0.01" "newton.:.iterations <= 12")
add_scene_test(NAME ball_between_planes SCENE verification/ball_between_planes.prm
               CHECK "status is converged" "newton.:.iterations <= 10" "pairs.0.normal_force.2 ~ 5 1e-9" "checks.force_balance <= 1e-8"
                     "pairs.0.peak_pressure ~ pairs.1.peak_pressure 1e-6")
# Finite strain: facets push it aside on a plane, always the same way (it was moved by 1e7 times its size, or by 1.36 R with "converged"); far nodes, whose
# gaps along their normals grow without bound, were closed in the first guess.
set(on_plane "Obstacle upper/Displacement=0|t" "Body disk/Body force=0|-1*t")
add_scene_test(NAME disk_squeezed SCENE verification/disk_squeezed.prm
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 2.2331 5e-3" "pairs.1.normal_force.1 ~ -2.2331 5e-3" "pairs.0.centre.0 abs<= 0.01"
                     "linear_solves <= 60" "checks.force_balance <= 1e-8" "notes.-1 has no motion along them changes anything else")
# A centre of five digits: the overlap was allowed by the first mesh and refused by finer ones, after their answers.
add_scene_test(NAME disk_squeezed_five_digits SCENE verification/disk_squeezed.prm SET "Kinematics=small strain" "Refinement/Target error=0.01" "Obstacle upper/Centre=0,1.99999" "Obstacle upper/Displacement=0|-0.00999*t"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 2.2331 5e-3")
add_scene_test(NAME disk_squeezed_by_force SCENE verification/disk_squeezed.prm SET "Obstacle upper/Displacement=0|free" "Obstacle upper/Force=0|-2*t"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 2 1e-8" "pairs.1.centre.0 abs<= 0.01" "linear_solves <= 60")
add_scene_test(NAME disk_on_plane_finite SCENE verification/disk_squeezed.prm SET ${on_plane}
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 3.14159 1e-3" "pairs.0.centre.0 abs<= 0.01" "pairs.0.contact_size ~ 0.0603 0.02" "linear_solves <= 60")
# Held off their middles the blocks came apart as they grew wider.
add_scene_test(NAME stack_without_friction SCENE verification/stack_without_friction.prm
               CHECK "status is converged" "pairs.:.normal_force.1 ~ 1 1e-8" "pairs.:.centre.0 ~ 0.5 1e-6" "newton.:.iterations <= 6")
# What small strain has shown of its meshes counts after the change to finite strain: refined to 9,092 unknowns. 0.0247858 and 0.00495893 on those.
add_scene_test(NAME two_indenters_change_late SCENE verification/two_indenters.prm
               SET "Kinematics=auto" "Obstacle heavy/Displacement=0|free" "Obstacle heavy/Force=0|-20" "Obstacle light/Force=0|-2" "Refinement/Target quantity=approach"
                   "Refinement/Target error=0.01"
               CHECK "status is converged" "error_estimate.quantity <= 0.01" "dofs <= 5000" "pairs.0.approach ~ 0.0247858 2e-3" "pairs.1.approach ~ 0.00495893 2e-3")
# Long faces of the slave had the master refined below all of them: 61 % after 9,866 unknowns, seven nodes closed (shear 210 %).
add_scene_test(NAME master_finer_than_slave SCENE verification/sheared_half_disk.prm
               SET "End time=1" "Increments=1" "Kinematics=small strain" "Body disk/Centre=0,50" "Body disk/Radius=50" "Body disk/Refinements=0" "Body block/Lower corner=-30,-30" "Body block/Upper corner=30,0"
                   "Body block/Cells=10,5" "Body block/Young modulus=3000" "Boundary condition load/Force=0|-2.9*t" "Boundary condition load/Rotation=0" "Contact sheared/Slave=first" "Refinement/Cycles=-1"
                   "Refinement/Target quantity=contact pressure" "Refinement/Target error=0.02" "Refinement/Maximum DoFs=10000"
               CHECK "status is converged" "error_estimate.contact <= 0.06" "error_estimate.shear <= 0.3" "dofs <= 12000")
# The other plane of symmetry was taken to cut the contact: its size was 7e-5 and nothing approached.
add_scene_test(NAME pin_in_quarter_hole SCENE verification/pin_in_quarter_hole.prm CHECK "status is converged" "pairs.0.contact_size ~ 0.94697 0.01" "pairs.0.approach ~ 0.06217 2e-3")
add_scene_test(NAME pin_in_quarter_hole_approach SCENE verification/pin_in_quarter_hole.prm SET "Refinement/Target quantity=approach" "Obstacle pin/Force=0|0.04"
               CHECK "status is converged" "error_estimate.quantity <= 0.01" "pairs.0.contact_size ~ 0.9451 0.01")
# Surfaces that pass each other: the gap of the start, in another direction, was taken off the motion (-0.29).
add_scene_test(NAME approach_of_passing_disks SCENE verification/two_equal_disks.prm SET "Kinematics=finite strain" "Body upper/Centre=-1.2,0.95" "Boundary condition press/Value=1.2*t|0" "Refinement/Target error=0.1"
               CHECK "status is converged" "pairs.0.approach is None" "pairs.0.normal_force.1 ~ 15.73 0.01")
# One estimate for both: the light one was not resolved (0.146).
add_scene_test(NAME two_indenters SCENE verification/two_indenters.prm CHECK "status is converged" "error_estimate.contact <= 0.1" "pairs.0.peak_pressure ~ 23.37 5e-3"
               "pairs.1.peak_pressure ~ 1.0254 0.03" "dofs <= 5000")
# Kinks of the gap within faces, whose pressure rises as log 1/r: two meshes had their highest node alike by chance (14 % estimated after 206,804 and 188,668 unknowns).
foreach(x 0.55 0.7)
  add_scene_test(NAME kink_of_gap_at_${x} SCENE verification/wavy_gap.prm SET "Contact face/Initial gap=0.01*abs(x-${x})" "Refinement/Target error=0.15" "Refinement/Target quantity=peak pressure"
                 CHECK "status is converged" "error_estimate.quantity >= 0.5" "notes.-1 has the target error is out of reach" "notes.-1 has (${x} -" "dofs <= 20000")
endforeach()
# Crests that a few nodes know were called sharp edges (at 54 %, after 11,440 unknowns): 2 sqrt(p_mean p*), p* = pi E* 0.001/0.1 (Westergaard).
add_scene_test(NAME peaks_of_crests SCENE verification/wavy_gap.prm SET "Body block/Lower corner=0,-3" "Body block/Upper corner=4,0" "Body block/Cells=5,3" "Body block/Young modulus=1000" "Obstacle plate/Force=0|-17.2"
               "Contact face/Initial gap=0.001*(1-cos(20*pi*x))" "Refinement/Target error=0.1" "Refinement/Target quantity=peak pressure"
               CHECK "status is converged" "error_estimate.quantity <= 0.1" "pairs.0.peak_pressure ~ 24.367 0.005" "dofs <= 80000")
# A cusp: p_0 - c |x - 0.55|^(1/2), 0.00665 by meshes of targets down to 0.1 %; two meshes had it alike by chance (0.006555, 0.6 % estimated).
add_scene_test(NAME cusp SCENE verification/wavy_gap.prm SET "Contact face/Initial gap=0.01*abs(x-0.55)^1.5" "Refinement/Target error=0.01" "Refinement/Target quantity=peak pressure"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 0.00665 0.005" "error_estimate.quantity <= 0.01" "dofs <= 40000")
# A cusp on the axis: 5/(2 pi) P (r^1.5 punch by Sneddon); the disk of its node fell short by 8.5 %, 1.9 % estimated (degree 1, whose first drop is another: 5.9 and 0.8).
foreach(degree 1 2)
  add_scene_test(NAME cusp_on_the_axis_q${degree} SCENE verification/cone.prm SET "Discretization/Degree=${degree}" "Obstacle cone/Flank angle=1e-9" "Obstacle cone/Force=0|-947.979087" "Contact top/Initial gap=0.002*x^1.5"
                 "Body block/Lower corner=0,-40" "Body block/Upper corner=40,0" "Refinement/Initial refinements=0" "Refinement/Cycles=20" "Refinement/Target error=0.03" "Refinement/Target quantity=peak pressure" "Reference/Solution="
                 CHECK "status is converged" "pairs.0.peak_pressure ~ 754.378 0.03" "error_estimate.quantity <= 0.03" "dofs <= 12000")
endforeach()
# What finite strain changes beside a sharp edge, where no mesh knows the pressure, decided for it: 384 solves, cells turned inside out.
add_scene_test(NAME sharp_punch_of_small_strain SCENE verification/wavy_gap.prm SET "Kinematics=auto" "Body block/Lower corner=0,-40" "Body block/Upper corner=40,0" "Body block/Cells=6,6" "Body block/Young modulus=1000"
               "Obstacle plate/Force=0|-5" "Obstacle plate/Half width=1" "Contact face/Initial gap=0" "Refinement/Maximum DoFs=5000"
               CHECK "status is converged" "pairs.0.contact_size ~ 1.41421 2e-3" "error_estimate.kinematics <= 0.01" "linear_solves <= 40")
# Cells at the edge came to the smallest that there are, after which all others were refined (98,288 unknowns, 7.7e9 said to be needed).
add_scene_test(NAME sharp_punch_of_smallest_cells SCENE verification/wavy_gap.prm SET "Body block/Lower corner=0,-40" "Body block/Upper corner=40,0" "Body block/Cells=6,6" "Body block/Young modulus=1000"
               "Obstacle plate/Force=0|-5" "Obstacle plate/Half width=1" "Contact face/Initial gap=0" "Refinement/Target error=0.02"
               CHECK "status is converged" "pairs.0.contact_size ~ 1.41421 2e-3" "dofs <= 12000" "notes.-2 has the target error is out of reach" "notes.-2 has as small as they can be" "notes.-2 has (1 -")
# A crack that closes: slopes grow without bound at its tip (19 of the pressure were said to be left out), and the pressure beside it, as 1/sqrt(r).
add_scene_test(NAME closed_crack SCENE verification/wavy_gap.prm SET "Body block/Lower corner=0,-20" "Body block/Upper corner=20,0" "Body block/Cells=10,10" "Body block/Young modulus=1000"
               "Obstacle plate/Force=0|-24.17582418" "Contact face/Initial gap=0.002*sqrt(max(0,1-x^2))" "Refinement/Target error=0.05"
               CHECK "status is converged" "dofs <= 6000" "error_estimate.kinematics <= 0.3" "notes.-2 has the target error is out of reach")
# A round peak between steep flanks was taken for one without limit once finite strain was used: refined for more than 150 s. 86.36 by a target of 0.2 %.
add_scene_test(NAME rounded_edge SCENE verification/wavy_gap.prm SET "Kinematics=auto" "Body block/Lower corner=0,-40" "Body block/Upper corner=40,0" "Body block/Cells=6,6" "Body block/Young modulus=1000"
               "Obstacle plate/Force=0|-10.3449842073" "Contact face/Initial gap=x < 0.99 ? 0 : (x - 0.99)^2/0.1" "Refinement/Target error=0.02" "Refinement/Target quantity=peak pressure"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 86.36 5e-3" "error_estimate.quantity <= 0.02" "linear_solves <= 80")
# The gap of 0.2 at first counted as approach at finite strain: 0.2087 for 0.0087.
foreach(strain small finite)
  add_scene_test(NAME approach_across_a_gap_${strain} SCENE verification/touched_at_the_axis.prm SET "Kinematics=${strain} strain" "Obstacle plane/Centre=0,-5.2" "Obstacle plane/Displacement=0|0.25*t"
                 "Refinement/Target error=0.05" "Refinement/Target quantity=approach"
                 CHECK "status is converged" "pairs.0.approach ~ 0.05 5e-3" "error_estimate.quantity <= 0.05")
endforeach()
# Parts of faces counted where a round body is steep (0.3): the pressure swung from node to node (320 at the highest, 45 % estimated). 117.9 by a target of 0.1 %.
add_scene_test(NAME steep_disks SCENE verification/two_equal_disks.prm SET "Boundary condition press/Value=0|-0.1"
               CHECK "status is converged" "pairs.0.peak_pressure ~ 117.9 0.01" "error_estimate.contact <= 0.01" "dofs <= 12000")
# Coarse cells around it moved the surface: 56.04 with 0.5 % estimated.
add_scene_test(NAME hertz_on_cantilever SCENE verification/hertz_on_cantilever.prm CHECK "status is converged" "pairs.0.peak_pressure ~ 52.93 0.01" "error_estimate.contact <= 0.01"
               "dofs <= 25000")
# Continued pressures beyond the rim told where to refine (0.5365 for a target of 10 %, 3 % estimated); the force across the plane of symmetry hid the change of the other (106.3).
add_scene_test(NAME round_punch SCENE verification/round_punch.prm CHECK "status is converged" "pairs.0.normal_force.2 ~ -0.46764 0.05" "error_estimate.quantity <= 0.05" "dofs <= 12000")
add_scene_test(NAME ball_in_hollow SCENE verification/ball_in_hollow.prm CHECK "status is converged" "pairs.0.normal_force.2 ~ 127.32 0.05" "error_estimate.quantity <= 0.05")
# Nodes that come near a hollow sphere are within it, by the sagitta of their faces, while the weighted gap is open: they were said to have passed through, and the coarse mesh was the answer.
add_scene_test(NAME ball_in_hollow_deeper SCENE verification/ball_in_hollow.prm SET "Boundary condition moved/Value=0|0|-0.1" "Refinement/Target error=0.03"
               CHECK "status is converged" "pairs.0.normal_force.2 ~ 176.94 0.03" "error_estimate.quantity <= 0.03")
add_scene_test(NAME target_of_what_the_first_mesh_does_not_see SCENE verification/shaft_in_longer_hub.prm CHECK "status is converged" "error_estimate.contact <= 0.01" "dofs <= 12000")
add_scene_test(NAME light_beside_heavy SCENE verification/light_beside_heavy.prm
               CHECK "status is converged" "pairs.0.peak_pressure ~ 1.884 0.02" "pairs.0.normal_force.1 ~ -0.01 1e-6" "dofs <= 8000")
add_comparison_test(NAME ranks_disk_on_plane_finite SCENE verification/disk_squeezed.prm RUN 1 2 OPTIONS --any-iterations SET ${on_plane})
add_comparison_test(NAME ranks_disk_in_groove SCENE verification/disk_in_groove.prm RUN 1 2 OPTIONS --any-iterations)
# Tied surfaces that turn, and thickness that changes: tractions were compared with stresses that are per other areas, and by their normal part alone.
foreach(kind "plane strain" "plane stress")
  string(MAKE_C_IDENTIFIER "${kind}" name)
  add_scene_test(NAME tied_and_turned_${name} SCENE verification/tied_and_turned.prm SET "Kind=${kind}"
                 CHECK "error_estimate.contact <= 1e-10" "error_estimate.bulk <= 1e-10")
endforeach()
# Tied surfaces in pure shear: the meshes' pressures, both rounding, were compared with each other (91 % and 28,150 unknowns).
add_scene_test(NAME tied_shear SCENE verification/tied_shear.prm
               CHECK "status is converged" "pairs.0.tangential_force.0 ~ 2.46154 5e-4" "error_estimate.contact <= 0.01" "dofs <= 4000")
# Rounding of a rigid motion was refined to 680,000 unknowns: tied or touching blocks that turn or move, disks a little short of touching.
foreach(kind "plane strain" "plane stress")
  string(MAKE_C_IDENTIFIER "${kind}" name)
  add_scene_test(NAME tied_and_only_turned_${name} SCENE verification/tied_and_turned.prm
                 SET "Kind=${kind}" "Refinement/Target error=0.01" "Boundary condition all/Value=cos(pi/2*t)*x-sin(pi/2*t)*y-x|sin(pi/2*t)*x+cos(pi/2*t)*y-y"
                 CHECK "status is converged" "error_estimate.contact == 0" "error_estimate.bulk == 0" "dofs <= 200")
endforeach()
add_scene_test(NAME disk_short_of_touching SCENE verification/disk_above_block.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Boundary condition load/Type=displacement" "Boundary condition load/Value=0|-0.499"
               CHECK "status is converged" "pairs.0.normal_force.1 == 0" "dofs <= 2000")
# Friction's work of a load that grows from nothing was (1 + 1/n) times too large with n increments, and the estimate for it as a target said nothing of that.
foreach(n 1 5)
  add_scene_test(NAME proportional_dissipation_${n} SCENE verification/receding_layer_rough.prm SET "Increments=${n}"
                 CHECK "status is converged" "meshes.-1.dissipation ~ 5.1727e-6 0.01" "meshes.-1.contact_work ~ meshes.-1.dissipation 1e-6")
endforeach()
# Stick size 0.0006 to 0.8 %, where one node of the middle stuck on all meshes; and what rounding leaves of an energy or a force was refined without end.
add_scene_test(NAME sticking_middle SCENE verification/sticking_middle.prm CHECK "status is converged" "pairs.0.stick_size ~ 0.1648 0.05" "error_estimate.quantity <= 0.05")
foreach(quantity energy total_force)
  string(REPLACE "_" " " name ${quantity})
  add_scene_test(NAME pressed_and_lifted_${quantity} SCENE verification/pressed_and_lifted.prm SET "Refinement/Target quantity=${name}"
                 CHECK "status is converged" "dofs <= 2000" "notes.-1 has has no meaning")
endforeach()
# Where sticking ends inside, no mesh was refined: 0.5455 to 1.9 %, and 0.5460 to 0.5 %.
add_scene_test(NAME stick_size_between_corners SCENE verification/pulled_from_jaws.prm
               CHECK "status is converged" "pairs.0.stick_size ~ 0.5677 0.03" "error_estimate.quantity <= 0.03" "pairs.0.tangential_force.0 ~ -180 1e-8")
# Corners of key and shaft were each slave in one pair and master in the other: no state converged.
add_scene_test(NAME keyway SCENE verification/keyway.prm
               CHECK "status is converged" "reactions.0.moment.0 ~ 20000 1e-10" "pairs.1.normal_force.0 ~ 888.04 0.01" "pairs.1.tangential_force.1 ~ 88.804 0.01" "linear_solves <= 60")
# Where the scene itself says so of both, that is told before anything is tried.
add_scene_test(NAME keyway_slaves_contradict SCENE verification/keyway.prm FAILS
               SET "Contact floor/Slave=first" "Contact left of shaft/Slave=second" "Minimum increment=1"
               CHECK "notes.0 has and 'floor' meet at a corner of both bodies")
add_scene_test(NAME keyway_slaves_beside_automatic SCENE verification/keyway.prm FAILS
               SET "Contact right of shaft/Slave=first" "Contact left of shaft/Slave=second" "Minimum increment=1"
               CHECK "notes.0 has meet at a corner of both bodies")
# Half-widths of 1e-5 around a ring, which the mesh makes of nothing, were refined to 650,000 unknowns.
add_scene_test(NAME size_of_a_shrink_fit SCENE verification/rings.prm SET "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=contact size"
               CHECK "status is converged" "pairs.0.contact_size == 0" "dofs <= 10000" "notes.0 has has no meaning")
# Size 1.7 % and peak 1.9 % off, as arcs of second order follow a curvature that changes in steps: 0.38 % were told.
add_scene_test(NAME curve_in_steps SCENE verification/curve_in_steps.prm
               CHECK "status is converged" "error_estimate.facets >= 0.018" "error_estimate.facets <= 0.04" "pairs.0.contact_size ~ 0.1964 2e-3" "notes.0 has curvatures that change by"
                     "notes.-1 has facets alone make a larger one")
add_scene_test(NAME curve_in_steps_size SCENE verification/curve_in_steps.prm SET "Refinement/Target quantity=contact size"
               CHECK "status is converged" "error_estimate.quantity <= 0.01" "notes.-1 has facets do not")
# 7.6 % off, told 4, where two meshes agreed by chance; and "out of reach" at 2 %.
add_scene_test(NAME dissipation_below_corners SCENE verification/pressed_and_sheared.prm CHECK "status is converged" "meshes.-1.dissipation ~ 2.654e-5 0.05" "error_estimate.quantity <= 0.05")
add_scene_test(NAME dissipation_below_corners_2 SCENE verification/pressed_and_sheared.prm SET "Refinement/Target error=0.02"
               CHECK "status is converged" "meshes.-1.dissipation ~ 2.654e-5 0.02" "error_estimate.quantity <= 0.02")
# Where the shear has no limit but does no work there: over 60 s and 48,000 unknowns for a number that is the same on all meshes.
add_scene_test(NAME dissipation_beside_edges SCENE verification/dovetail.prm SET "Refinement/Maximum DoFs=8000"
               CHECK "status is converged" "meshes.-1.dissipation ~ 1.5653 2e-3" "error_estimate.quantity <= 0.05" "dofs <= 6000")
# The stick zone is smaller than the faces of the first mesh.
add_scene_test(NAME target_stick_size_unseen_at_first SCENE verification/receding_layer_rough.prm
               SET "Increments=automatic" "Refinement/Cycles=-1" "Refinement/Target error=0.01" "Refinement/Target quantity=stick size"
               CHECK "status is converged" "pairs.0.stick_size ~ 0.0935 0.01" "error_estimate.quantity <= 0.01")

# A slope that ends at a plane of symmetry: the normal of its last node was that of a surface that crosses the plane (14 % of the push).
foreach(kinematics "small strain" "finite strain")
  string(MAKE_C_IDENTIFIER "${kinematics}" name)
  add_scene_test(NAME rider_${name} SCENE verification/rider.prm SET "Kinematics=${kinematics}" "Obstacle slope/Displacement=0.0005*t|0"
                 CHECK "status is converged" "pairs.0.normal_force.0 ~ 5.7735 1e-4" "pairs.0.normal_force.1 ~ 10 1e-8")
endforeach()
# What the support takes at the tip of a V cannot be told from shear: friction was not found within 60 iterations, and tied 0.87 to 2.17 for 1.9231.
foreach(case "free:Kinematics=small strain" "rough:Contact joint/Friction coefficient=0.3" "tied:Contact joint/Tied=true")
  string(REPLACE ":" ";" case "${case}")
  list(GET case 0 name)
  list(GET case 1 entry)
  foreach(kinematics "small strain" "finite strain")
    string(MAKE_C_IDENTIFIER "v_joint_${name}_${kinematics}" test)
    add_scene_test(NAME ${test} SCENE verification/v_joint.prm SET "Kinematics=${kinematics}" "${entry}"
                   CHECK "status is converged" "pairs.0.normal_force.0 ~ -1.92308 1e-3" "pairs.0.normal_force.1 ~ 3.84615 1e-3" "pairs.0.tangential_force.: abs<= 1e-8"
                         "error_estimate.contact <= 1e-9" "newton.:.iterations <= 6")
  endforeach()
endforeach()
# Walls along an axis, for both bodies, are planes as well: no states were found.
foreach(kinematics "small strain" "finite strain")
  string(MAKE_C_IDENTIFIER "v_joint_walls_${kinematics}" test)
  add_scene_test(NAME ${test} SCENE verification/v_joint.prm
                 SET "Kinematics=${kinematics}" "Contact joint/Friction coefficient=0.3" "Boundary condition symmetry/Type=displacement" "Boundary condition symmetry/Value=0|free"
                 CHECK "status is converged" "pairs.0.normal_force.0 ~ -1.92308 1e-3" "pairs.0.normal_force.1 ~ 3.84615 1e-3" "pairs.0.tangential_force.: abs<= 1e-8" "newton.:.iterations <= 6")
endforeach()
add_scene_test(NAME rider_friction SCENE verification/rider.prm SET "Contact interface/Friction coefficient=0.2"
               CHECK "status is converged" "pairs.0.normal_force.0 ~ 6.5269 1e-3" "pairs.0.normal_force.1 ~ 11.305 1e-3" "pairs.0.tangential_force.0 ~ 2.261 1e-3" "pairs.0.n_stick == 0")
# What lies between nodes: a band of friction (0.4 came out), a bump of a prescribed displacement (80), a sphere that touches at its axis alone (0).
foreach(quantity "contact pressure" "total force")
  string(MAKE_C_IDENTIFIER "${quantity}" name)
  add_scene_test(NAME friction_band_${name} SCENE verification/friction_band.prm SET "Refinement/Target error=0.01" "Refinement/Target quantity=${quantity}"
                 CHECK "status is converged" "pairs.0.tangential_force.0 ~ -2.4 0.01")
endforeach()
add_scene_test(NAME displaced_bump SCENE verification/displaced_bump.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ 90.6347 1e-3" "dofs <= 5000")
add_scene_test(NAME touched_at_the_axis SCENE verification/touched_at_the_axis.prm CHECK "status is converged" "pairs.0.normal_force.1 ~ 1.5376 2e-3" "error_estimate.contact <= 0.01")
# Contacts in space of a fiftieth of the faces that carry them, with friction: refined to their size at once; forces by statics. (Over 100 s, and not resolved on the fourth mesh.)
add_scene_test(NAME plate_on_three_balls SCENE verification/plate_on_three_balls.prm
               CHECK "status is converged" "pairs.0.normal_force.2 ~ 1.52 0.005" "pairs.1.normal_force.2 ~ 1.68 0.005" "pairs.2.normal_force.2 ~ 3.2 0.005" "meshes.-1.mesh <= 2" "error_estimate.quantity <= 0.1" "linear_solves <= 40")
# Approach without what hanging nodes of a round master seem to be nearer by (0.105 came out); no peak of the sliver that the master's end covers (519).
add_scene_test(NAME pin_longer_than_its_seat SCENE verification/pin_longer_than_its_seat.prm
               CHECK "status is converged" "meshes.:.pairs.0.approach <= 0.01" "pairs.0.approach ~ 0.0087 0.01" "pairs.0.peak_pressure <= 200")
# Bodies 2,500 of their sizes away from the reference of what they touch ("nothing holds the rigid motion along y").
add_scene_test(NAME far_from_its_carrier SCENE verification/displaced_bump.prm SET "Body block/Shift=1e4, 0" "Boundary condition top/Type=traction" "Boundary condition top/Value=0|-1" "Refinement/Target error=0"
               CHECK "status is converged" "pairs.0.normal_force.1 ~ 4 1e-6")
