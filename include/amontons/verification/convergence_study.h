// `amontons study FILE`: a scene for all combinations of swept parameters; errors with observed orders.
// clang-format off
//
//   set Title      = Hertz cylinder, uniform refinement
//   set Scene      = ../hertz_cylinder.prm    # relative to this file
//   set Output     = studies/hertz            # relative to the working directory; default: name of this file
//   set Overrides  = Newton/Tolerance = 1e-12 | Output/VTU = false
//   set Quantities = reference.errors.contact_size, reference.errors.pressure_l2 # paths in summary.json
//   set Columns    = cells, dofs, finest_mesh_seconds, wall_seconds              # the default
//   set Against    = closed form              # the quantities are errors; finest: relative difference to the last run
//   set Per mesh   = false                    # true: one row per entry of the summary's array `meshes`
//   subsection Sweep                          # 1 to 4 parameters; the last one gives the rows (or `set Vary = 1`)
//     set 1 = Discretization/Degree: 1, 2
//     set 2 = Body lower/Refinements & Body upper/Refinements: 1, 2, 3
//   end
//
// clang-format on
// Values are separated by commas, or by | if one stands among them. With Per mesh, every combination is a
// series, of the meshes of the last increment. Numbers in a path count the elements of arrays:
// pairs.0.normal_force.
#pragma once

#include <boost/property_tree/ptree.hpp>

#include <mpi.h>

#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace Amontons
{
  // Runs a scene with overrides "Section/Name = value" and returns its summary.json; throws
  // std::runtime_error on failure.
  using Runner = std::function<boost::property_tree::ptree(const std::string              &scene_file,
                                                           const std::vector<std::string> &overrides)>;

  // Collective. Tables go to `out`, files to the study's directory; both from rank 0 only. A run that fails
  // is reported and left out. Returns 0, or 1 if a run failed or a file could not be written. Throws
  // InputError for errors in the study file and passes on those of the scene.
  int
  run_convergence_study(const std::string &study_file,
                        const Runner      &runner,
                        std::ostream      &out,
                        MPI_Comm           communicator);
} // namespace Amontons
