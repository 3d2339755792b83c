// Shape functions of the multiplier on one slave face, biorthogonal to its Bernstein traces.
#pragma once

#include <deal.II/base/point.h>
#include <deal.II/lac/full_matrix.h>

#include <vector>

namespace Amontons
{
  // On the covered part of a face, given by quadrature points and weights, with D_i = int B_i (> 0) and M_ij
  // = int B_i B_j,
  //   psi = D M^-1 B,   so that   int psi_i B_j = delta_ij D_i   and   sum_i psi_i = 1   on the covered part
  // (doc/introduction.md, (8); consistent dual basis; Cichosz and Bischoff 2011, Popp et al. 2013). A node f
  // without a multiplier (owned by supports) shares psi_f in equal parts among the others, so that the sum
  // stays 1: int psi_i B_f = D_f / n_others then. Small covered parts make M ill-conditioned; it is inverted
  // in the Legendre basis of the part's bounding box, which costs the square root of the condition number
  // only.
  //
  // Faces with hanging nodes have the traces B' = A^T B of their unknowns (A: subdivision of the control
  // values, see SurfaceFace). With D' = A^T D and M' = A^T M A,
  //   psi' = D' M'^-1 B' = D' A^-1 M^-1 B,
  // and the sum stays 1, for A 1 = 1 (doc/introduction.md, (10)). All results refer to the unknowns then.
  //
  // Multipliers may belong to other coefficients c'' = P c' of the same functions (P: `change`, rows of sum
  // 1; see nodal_traces.h). With B' = P^T B'' and D'' = P^-T D',
  //   psi'' = D'' P M'^-1 B',   int psi''_i B'_j = D''_i P_ij   (`traces`; D' where P is the identity):
  //   doc/introduction.md, (9).
  template <int fdim>
  struct DualBasis
  {
    dealii::FullMatrix<double> psi;    // (node, point); zero rows for nodes without a multiplier
    dealii::FullMatrix<double> traces; // (node, node): int psi_i B_j (the B of the control values)
    dealii::FullMatrix<double> mass;   // (node, node): int B_i B_j
  };

  template <int fdim>
  DualBasis<fdim>
  make_dual_basis(const unsigned int                      degree,
                  const std::vector<dealii::Point<fdim>> &points,
                  const std::vector<double>              &weights,
                  const std::vector<bool>                &carries_multiplier,
                  const dealii::FullMatrix<double>       &subdivision = dealii::FullMatrix<double>(),
                  const dealii::FullMatrix<double>       &change      = dealii::FullMatrix<double>());
} // namespace Amontons
