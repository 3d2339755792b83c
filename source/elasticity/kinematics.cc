#include <amontons/elasticity/kinematics.h>

namespace Amontons
{
  // Least squares in the cell: P f = sum_k m_k a_k with  sum_k (m_j, m_k) a_k = (m_j, f),  m = 1 (, xi_1,
  // ..., xi_dim about the centre).
  template <int dim>
  void
  PressureProjection<dim>::reinit(const FEValues<dim> &values, const std::vector<double> &weights)
  {
    const unsigned int n_q = weights.size(), n_m = n_coefficients(values.get_fe().degree);
    const Point<dim>   centre = values.get_cell()->center();
    const double       size   = values.get_cell()->diameter();
    FullMatrix<double> mass(n_m, n_m);
    polynomials.reinit(n_q, n_m);
    weighted.reinit(n_q, n_m);
    for (unsigned int q = 0; q < n_q; ++q)
      for (unsigned int k = 0; k < n_m; ++k)
        {
          polynomials(q, k) = k == 0 ? 1. : (values.quadrature_point(q)[k - 1] - centre[k - 1]) / size;
          weighted(q, k)    = weights[q] * polynomials(q, k);
        }
    for (unsigned int q = 0; q < n_q; ++q)
      for (unsigned int j = 0; j < n_m; ++j)
        for (unsigned int k = 0; k < n_m; ++k)
          mass(j, k) += weighted(q, j) * polynomials(q, k);
    inverse_mass.reinit(n_m, n_m);
    inverse_mass.invert(mass);
    moment.reinit(n_m);
    coefficient.reinit(n_m);
  }

  template <int dim>
  void
  PressureProjection<dim>::apply(std::vector<double> &f)
  {
    evaluate(project(f).begin(), f);
  }

  template <int dim>
  const Vector<double> &
  PressureProjection<dim>::project(const std::vector<double> &f)
  {
    moment = 0;
    for (unsigned int q = 0; q < f.size(); ++q)
      for (unsigned int k = 0; k < moment.size(); ++k)
        moment[k] += weighted(q, k) * f[q];
    inverse_mass.vmult(coefficient, moment);
    return coefficient;
  }

  template <int dim>
  void
  PressureProjection<dim>::evaluate(const double *coefficients, std::vector<double> &f) const
  {
    f.resize(polynomials.m());
    for (unsigned int q = 0; q < f.size(); ++q)
      {
        f[q] = 0;
        for (unsigned int k = 0; k < polynomials.n(); ++k)
          f[q] += polynomials(q, k) * coefficients[k];
      }
  }

  template <int dim>
  void
  PressureProjection<dim>::apply(FullMatrix<double> &f)
  {
    moments.reinit(weighted.n(), f.n());
    coefficients.reinit(weighted.n(), f.n());
    weighted.Tmmult(moments, f);
    inverse_mass.mmult(coefficients, moments);
    polynomials.mmult(f, coefficients);
  }

  template <int dim>
  StrainOperator<dim>::StrainOperator(const FiniteElement<dim> &fe, const ProblemType kind)
      : kind(kind), n_dofs(fe.n_dofs_per_cell())
  {
    for (unsigned int i = 0; i < n_dofs; ++i)
      component.push_back(fe.system_to_component_index(i).first);
  }

  template <int dim>
  void
  StrainOperator<dim>::reinit(const FEValues<dim> &values)
  {
    const unsigned int n_q = values.n_quadrature_points;
    B.resize(n_q * n_dofs);
    weights.resize(n_q);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        const double r = values.quadrature_point(q)[0];
        weights[q]     = values.JxW(q) * measure<dim>(kind, values.quadrature_point(q));
        for (unsigned int i = 0; i < n_dofs; ++i)
          {
            Voigt<dim> &b = B[q * n_dofs + i];
            b.fill(0);
            const auto        &g = values.shape_grad(i, q);
            const unsigned int c = component[i];
            b[c]                 = g[c];
            if (dim == 2)
              {
                b[3] = g[1 - c];
                if (kind == ProblemType::axisymmetric && c == 0)
                  b[2] = values.shape_value(i, q) / r;
              }
            else
              {
                // shears xy, xz, yz
                if (c == 0)
                  {
                    b[3] = g[1];
                    b[4] = g[dim - 1];
                  }
                else if (c == 1)
                  {
                    b[3]                = g[0];
                    b[n_voigt<dim> - 1] = g[dim - 1];
                  }
                else
                  {
                    b[4]                = g[0];
                    b[n_voigt<dim> - 1] = g[1];
                  }
              }
          }
      }
    if (kind != ProblemType::plane_stress)
      project_dilatation(values);
  }

  template <int dim>
  void
  StrainOperator<dim>::project_dilatation(const FEValues<dim> &values)
  {
    projection.reinit(values, weights);
    std::vector<double> divergence(weights.size()), projected;
    for (unsigned int i = 0; i < n_dofs; ++i)
      {
        for (unsigned int q = 0; q < weights.size(); ++q)
          {
            const Voigt<dim> &b = B[q * n_dofs + i];
            divergence[q]       = b[0] + b[1] + b[2];
          }
        projected = divergence;
        projection.apply(projected);
        for (unsigned int q = 0; q < weights.size(); ++q)
          for (unsigned int k = 0; k < 3; ++k)
            B[q * n_dofs + i][k] += (projected[q] - divergence[q]) / 3;
      }
  }

  template class PressureProjection<2>;
  template class PressureProjection<3>;
  template class StrainOperator<2>;
  template class StrainOperator<3>;
} // namespace Amontons
