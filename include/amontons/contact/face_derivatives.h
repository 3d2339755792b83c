// Derivatives of what one slave face adds to coupling rows and contact forces.
#pragma once

#include <amontons/contact/coupling_derivatives.h>
#include <amontons/contact/face_moments.h>

namespace Amontons
{
  // Bernstein polynomials and their moments over the covered part are those of the basis L (FaceMoments),
  // with B = R L and the traces of the unknowns B' = A^T B (see DualBasis). With Q = A^T R, D_r = sum_k Q_rk
  // G_k0 (L_0 = 1), W = Q^-T G^-1 and the shares S (S_ii = 1; nodes f without a multiplier leave S_if =
  // 1/n_carrying to each of the others) the dual functions are
  //   psi_i = sum_k C_ik L_k,   C = S diag(D) W,
  //   dC    = S diag(dD) W - C dG G^-1.
  // A single node that carries a multiplier has psi = 1.
  template <int dim>
  class FaceDerivatives
  {
  public:
    // rows: of the coupling, by unknown of the face; invalid without a multiplier. Normal gradients are added
    // where they are still unknown.
    using NormalGradients =
        std::map<unsigned int, std::vector<std::pair<types::global_dof_index, Tensor<1, dim>>>>;
    FaceDerivatives(const Discretization<dim>       &discretization,
                    const ContactInterface<dim>     &interface,
                    const PointsView<dim>           &points,
                    const std::vector<unsigned int> &rows,
                    NormalGradients                 &normal_gradients);

    // d(int psi_i (p . n + h . g n + a)), i: place among the unknowns; by place in `dofs`.
    std::vector<double>
    integral_gradient(const unsigned int    i,
                      const Tensor<1, dim> &p,
                      const Tensor<1, dim> &h,
                      const double          a) const;

    // d(forces); tractions by coupling row.
    LocalMatrix
    stiffness(const std::vector<Tensor<1, dim>> &tractions) const;

    std::vector<types::global_dof_index>
    master_dofs() const;

    // Moments that only rows need.
    void
    forget_rows();

    std::vector<unsigned int>            rows;
    std::vector<types::global_dof_index> dofs; // that anything here depends on, or that forces act on

  private:
    void
    make_coefficients(const FullMatrix<double> &subdivision);
    void
    make_dofs(const ContactSurface<dim> &slave, const unsigned int face, NormalGradients &normal_gradients);
    void
    chain(const double *by_variable, double *by_dof) const;

    using Line = std::vector<std::pair<unsigned int, double>>;
    FaceMoments<dim>   moments;
    bool               single; // one node carries all
    FullMatrix<double> Q, G_inverse, W, S, C;
    std::vector<Line>  columns; // by variable: places in `dofs` that it depends on
    std::vector<Line>  slave_forces,
        master_forces; // by (unknown or master node) dim + component: where it acts, as places in
                       // `forced_dofs`
    std::vector<types::global_dof_index> forced_dofs;
  };
} // namespace Amontons
