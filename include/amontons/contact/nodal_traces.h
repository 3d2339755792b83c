// Middle nodes of quadratic faces whose multipliers belong to nodal values instead of control values.
#pragma once

#include <amontons/contact/contact_surface.h>

namespace Amontons
{
  // Where the surface is curved, the row of a node sees an average of n . [u] only up to
  //   e_i = n_i . int psi_i [u]/D_i - int psi_i n . [u]/D_i = - int psi_i (n - n_i) . ([u] - [u]_i)/D_i,
  // whatever n_i and [u]_i are constant. int psi_i f/D_i is, of a quadratic f, its control value at node i:
  // f(x_i) - f'' (h/2)^2/2 in the middle of a face with Bernstein traces, f(x_i) at corners, so that every
  // second gap is wrong by (h/2)^2 n' . [u]'. With Lagrange traces it is f(x_i) everywhere, and e_i = O(h^3).
  // The multipliers sum psi_i p_i then hold all linear functions, with Bernstein traces only constants.
  //
  // But Lagrange functions are negative in places. Hence they take the place of Bernstein's on curved faces
  // only, at nodes all of whose faces are covered so far that int N_j > 0 by a margin: see
  // Coverage::positive_faces.

  // By slave node. positive_faces: by face. None for linear elements, where there is no difference.
  template <int dim>
  std::vector<bool>
  find_nodal_traces(const ContactSurface<dim> &slave, const std::vector<bool> &positive_faces);

  // P of the coefficients c'' = P c' of the face's unknowns (see DualBasis): nodal values instead of control
  // values c' = S u at the nodes marked, u_i = sum_j (S^-1)_ij c'_j. Empty if there are none.
  template <int dim>
  FullMatrix<double>
  change_to_nodal(const ContactSurface<dim> &slave,
                  const SurfaceFace<dim>    &face,
                  const std::vector<bool>   &nodal);
} // namespace Amontons
