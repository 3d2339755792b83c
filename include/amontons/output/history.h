// history.csv: a row per increment and mesh.
#pragma once

#include <amontons/output/summary.h>

namespace Amontons
{
  // Columns: increment, t, mesh, cells, dofs, iterations, krylov, residual; by pair PAIR.normal_force_x, ...,
  // PAIR.peak_pressure, PAIR.contact_size, PAIR.n_open, ...; error_bulk, error_contact, energy(,
  // external_work); by probe PROBE.u_x, ..., PROBE.stress_xx, ..., PROBE.von_mises (lines: PROBE[i].u_x,
  // ...). Rewritten whole each time. To be called on rank 0.
  void
  write_history(const std::string &file, const std::vector<MeshSummary> &meshes, const Kind kind);
} // namespace Amontons
