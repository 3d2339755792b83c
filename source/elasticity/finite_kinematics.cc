#include <amontons/elasticity/finite_kinematics.h>
#include <amontons/elasticity/kirchhoff.h>

#include <algorithm>

namespace Amontons
{
  template <int dim>
  FiniteKinematics<dim>::FiniteKinematics(const FiniteElement<dim> &fe, const ProblemType kind)
      : kind(kind), n_nodes(fe.n_dofs_per_cell() / dim)
  {
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int m = 0; m < n_nodes; ++m)
        indices[c].push_back(fe.component_to_system_index(c, m));
  }

  template <int dim>
  double
  FiniteKinematics<dim>::reinit(const FEValues<dim>       &values,
                                const std::vector<double> &u,
                                const double              *theta)
  {
    const unsigned int n_q = values.n_quadrature_points;
    displacement.resize(n_q);
    weights.resize(n_q);
    volume_changes.resize(n_q);
    spatial_gradients.reinit(n_q * dim, n_nodes, true);
    if (kind == ProblemType::axisymmetric)
      hoops.resize(n_q * n_nodes);

    for (unsigned int q = 0; q < n_q; ++q)
      {
        weights[q]        = values.JxW(q) * measure<dim>(kind, values.quadrature_point(q));
        displacement[q]   = displacement_gradient(values, q, u);
        volume_changes[q] = change_of_determinant(displacement[q]);
        if (std::isnan(volume_changes[q]))
          return volume_changes[q];
      }
    // St. Venant-Kirchhoff bodies have equilibria with cells pressed to nothing, where rounding decides about
    // forces.
    constexpr double collapsed = 1e-6;
    const double     smallest  = 1 + *std::min_element(volume_changes.begin(), volume_changes.end());
    if (smallest <= collapsed)
      return std::min(smallest, 0.);
    for (unsigned int q = 0; q < n_q; ++q)
      push_forward(values, q);
    if (kind == ProblemType::plane_stress)
      dilatations = volume_changes;
    else
      set_dilatations(values, theta);
    return std::min(smallest, 1 + *std::min_element(dilatations.begin(), dilatations.end()));
  }

  template <int dim>
  void
  FiniteKinematics<dim>::set_dilatations(const FEValues<dim> &values, const double *theta)
  {
    projection.reinit(values, weights);
    const Vector<double> &of_volume = projection.project(volume_changes);
    if (theta == nullptr)
      theta = of_volume.begin();
    theta_coefficients.assign(theta, theta + of_volume.size());
    excess_coefficients.resize(of_volume.size());
    for (unsigned int k = 0; k < of_volume.size(); ++k)
      excess_coefficients[k] = of_volume[k] - theta[k];
    projection.evaluate(theta_coefficients.data(), dilatations);
  }

  template <int dim>
  Tensor<2, 3>
  FiniteKinematics<dim>::displacement_gradient(const FEValues<dim>       &values,
                                               const unsigned int         q,
                                               const std::vector<double> &u)
  {
    Tensor<2, 3> H;
    for (unsigned int m = 0; m < n_nodes; ++m)
      {
        const auto &gradient = values.shape_grad(index(0, m), q);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            H[c][d] += u[index(c, m)] * gradient[d];
      }
    if (kind == ProblemType::axisymmetric)
      for (unsigned int m = 0; m < n_nodes; ++m)
        {
          const unsigned int i = index(0, m);
          H[2][2] += u[i] * values.shape_value(i, q) / values.quadrature_point(q)[0];
        }
    return H;
  }

  // grad N = F^-T Grad N
  template <int dim>
  void
  FiniteKinematics<dim>::push_forward(const FEValues<dim> &values, const unsigned int q)
  {
    const Tensor<2, 3> inverse = invert(Tensor<2, 3>(unit_symmetric_tensor<3>()) + displacement[q]);
    for (unsigned int m = 0; m < n_nodes; ++m)
      {
        const unsigned int i        = index(0, m);
        const auto        &gradient = values.shape_grad(i, q);
        for (unsigned int d = 0; d < dim; ++d)
          {
            double sum = 0;
            for (unsigned int e = 0; e < dim; ++e)
              sum += inverse[e][d] * gradient[e];
            spatial_gradients(q * dim + d, m) = sum;
          }
        if (kind == ProblemType::axisymmetric)
          hoops[q * n_nodes + m] = values.shape_value(i, q) / values.quadrature_point(q)[0] * inverse[2][2];
      }
  }

  // (theta/J)^(2/3) (H + H^T + H H^T) + ((theta/J)^(2/3) - 1) I,  H = F - I
  template <int dim>
  SymmetricTensor<2, 3>
  FiniteKinematics<dim>::strain(const unsigned int q) const
  {
    const auto  &H      = displacement[q];
    const double change = (dilatations[q] - volume_changes[q]) / jacobian(q); // theta/J - 1
    const double scale  = std::expm1(2. / 3 * std::log1p(change));            // (theta/J)^(2/3) - 1
    return (1 + scale) * (2 * symmetrize(H) + symmetrize(H * transpose(H))) +
           scale * unit_symmetric_tensor<3>();
  }

  template class FiniteKinematics<2>;
  template class FiniteKinematics<3>;
} // namespace Amontons
