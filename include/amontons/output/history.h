// history.csv: a row per increment and mesh.
#pragma once

#include <amontons/output/summary.h>

namespace Amontons
{
  // Columns: increment, t, mesh, cells, dofs, iterations, krylov, residual; by pair PAIR.normal_force_x, ...,
  // PAIR.tangential_force_x, ..., PAIR.peak_pressure, PAIR.contact_size(, PAIR.stick_size), PAIR.n_open, ...;
  // error_bulk, error_contact, energy(, external_work, contact_work, dissipation,
  // contact_work_minus_dissipation); by probe PROBE.u_x, ..., PROBE.stress_xx, ..., PROBE.von_mises (lines:
  // PROBE[i].u_x, ...); in brackets: friction. nan: not known. All rows have the fields of the header.
  // Rewritten whole each time. To be called on rank 0.
  void
  write_history(const std::string &file, const std::vector<MeshSummary> &meshes, const ProblemType kind);
} // namespace Amontons
