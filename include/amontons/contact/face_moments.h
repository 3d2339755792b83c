// Integrals over the covered part of one slave face, with their derivatives.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/contact/covered_basis.h>
#include <amontons/contact/covered_shares.h>

namespace Amontons
{
  // With the polynomials L_k of the CoveredBasis, k < n, and shape functions N_q of the other side:
  //   G_kl = int L_k L_l,   P_k = int L_k n,   H_k = int L_k g n,   N_kq = int L_k N_q.
  // Variables are the displacements of the slave face's nodes, the unit normals there (both node by node,
  // component by component), and the displacements of the master nodes.
  template <int dim>
  struct FaceMoments
  {
    unsigned int                n, n_variables;
    FullMatrix<double>          R;      // Bernstein polynomials B = R L
    std::vector<NodeDofs<dim>>  master; // nodes, or corners of the carrier
    FullMatrix<double>          G, N;
    std::vector<Tensor<1, dim>> P, H;
    // By variable (columns): rows n k + l, n_master k + q, dim k + c.
    FullMatrix<double> dG, dN, dP, dH;
  };

  // points: all of one slave face.
  template <int dim>
  FaceMoments<dim>
  make_face_moments(const Discretization<dim>   &discretization,
                    const ContactInterface<dim> &interface,
                    const PointsView<dim>       &points);
} // namespace Amontons
