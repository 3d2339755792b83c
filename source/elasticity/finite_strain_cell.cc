#include <amontons/elasticity/finite_strain_cell.h>

namespace Amontons
{
  namespace
  {
    double
    trace_of(const Voigt<3> &tau)
    {
      return tau[0] + tau[1] + tau[2];
    }

    // c:I + 2 tau
    Voigt<3>
    change_with_volume(const SpatialTangent &c, const Voigt<3> &tau)
    {
      Voigt<3> change;
      for (unsigned int k = 0; k < 6; ++k)
        change[k] = c[k][0] + c[k][1] + c[k][2] + 2 * tau[k];
      return change;
    }

    // Of tau + p I, the components that act in the space of the mesh.
    template <int dim>
    Tensor<2, dim>
    in_space(const Voigt<3> &tau, const double p)
    {
      Tensor<2, dim> result;
      for (unsigned int k = 0; k < 6; ++k)
        if (const auto [i, j] = voigt_indices[k]; j < dim)
          result[i][j] = result[j][i] = i == j ? tau[k] + p : tau[k];
      return result;
    }
  } // namespace

  template <int dim>
  FiniteStrainCell<dim>::FiniteStrainCell(const FiniteElement<dim> &fe, const ProblemType kind)
      : kinematics(fe, kind), projects(kind != ProblemType::plane_stress),
        stabilised(projects && fe.degree > 1)
  {
  }

  template <int dim>
  double
  FiniteStrainCell<dim>::reinit(const FEValues<dim>       &values,
                                const HyperelasticLaw     &law,
                                const std::vector<double> &u,
                                const double              *theta)
  {
    this->law             = &law;
    const double mu       = std::visit([](const auto &any) { return any.mu; }, law);
    const double smallest = kinematics.reinit(values, u, theta);
    if (!(smallest > 0))
      return smallest;
    const unsigned int n_q = kinematics.n_points();
    stabilisation.clear();
    strain.resize(n_q);
    stress.resize(n_q);
    pressure.resize(n_q);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        strain[q] = kinematics.strain(q);
        if (!projects)
          strain[q][2][2] = thickness_strain(law, strain[q]);
        if (const double b_33 = 1 + strain[q][2][2]; !(b_33 > 0))
          return b_33;
        stress[q]   = kirchhoff_stress(law, strain[q]);
        pressure[q] = trace_of(stress[q]) / 3;
        if (stabilised)
          {
            stabilisation.emplace_back(mu, kinematics.jacobian(q), kinematics.dilatation(q), strain[q]);
            pressure[q] -= stabilisation[q].pressure();
          }
      }
    if (projects)
      project_pressure(pressure);
    for (unsigned int q = 0; stabilised && q < n_q; ++q)
      pressure[q] += stabilisation[q].pressure();
    return smallest;
  }

  template <int dim>
  Voigt<3>
  FiniteStrainCell<dim>::all_stress(const unsigned int q) const
  {
    if (!stabilised)
      return stress[q];
    const auto &stable = stabilisation[q];
    Voigt<3>    sum    = as_voigt(stable.shear() * stable.unimodular);
    for (unsigned int k = 0; k < 6; ++k)
      sum[k] += stress[q][k];
    return sum;
  }

  // From tr tau/3 to J P(tr tau/(3 theta)).
  template <int dim>
  void
  FiniteStrainCell<dim>::project_pressure(std::vector<double> &pressure)
  {
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      pressure[q] /= kinematics.dilatation(q);
    kinematics.project(pressure);
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      pressure[q] *= kinematics.jacobian(q);
  }

  template <int dim>
  double
  FiniteStrainCell<dim>::energy() const
  {
    double sum = 0;
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      sum += kinematics.weight(q) *
             (Amontons::energy(*law, strain[q]) + (stabilised ? stabilisation[q].energy() : 0.));
    return sum;
  }

  template <int dim>
  std::vector<double>
  FiniteStrainCell<dim>::forces() const
  {
    std::vector<Voigt<3>> all(kinematics.n_points());
    for (unsigned int q = 0; q < all.size(); ++q)
      all[q] = all_stress(q);
    return forces_of(all, pressure);
  }

  // Of the stabilisation, with epsilon = e/theta and j = J/theta:
  //   d(m r^2) = -2 m r j epsilon,   ds = m phi (j - 2 j^2) epsilon,   d(s/theta) = (ds - s
  //   epsilon)/theta.
  template <int dim>
  std::vector<double>
  FiniteStrainCell<dim>::forces_of_excess()
  {
    std::vector<double>   of_stabilisation(stabilised ? kinematics.n_points() : 0);
    std::vector<double>   pressure;
    std::vector<Voigt<3>> change(kinematics.n_points());
    kinematics.evaluate_excess(pressure);
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      {
        const double epsilon = pressure[q] / kinematics.dilatation(q), alpha = epsilon / 3;
        change[q] = change_with_volume(spatial_tangent(*law, strain[q]), stress[q]);
        for (auto &component : change[q])
          component *= alpha;
        pressure[q] = trace_of(change[q]) / 3 - alpha * trace_of(stress[q]);
        if (stabilised)
          {
            const auto    &stable = stabilisation[q];
            const double   j      = stable.ratio;
            const Voigt<3> shear  = as_voigt(-2 * stable.m * stable.r * j * epsilon * stable.unimodular);
            for (unsigned int k = 0; k < 6; ++k)
              change[q][k] += shear[k];
            of_stabilisation[q] = stable.m * stable.phi * (j - 2 * j * j) * epsilon;
            pressure[q] -= of_stabilisation[q] - stable.pressure() * epsilon;
          }
      }
    project_pressure(pressure);
    for (unsigned int q = 0; q < of_stabilisation.size(); ++q)
      pressure[q] += of_stabilisation[q];
    return forces_of(change, pressure);
  }

  // int (dev tau + p I) : B dV0
  template <int dim>
  std::vector<double>
  FiniteStrainCell<dim>::forces_of(const std::vector<Voigt<3>> &stress,
                                   const std::vector<double>   &pressure) const
  {
    std::vector<double> f(kinematics.n_nodes * dim);
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      {
        const double         shift = pressure[q] - trace_of(stress[q]) / 3;
        const double         hoop  = kinematics.weight(q) * (stress[q][2] + shift);
        const Tensor<2, dim> tau   = kinematics.weight(q) * in_space<dim>(stress[q], shift);
        for (unsigned int m = 0; m < kinematics.n_nodes; ++m)
          {
            f[kinematics.index(0, m)] += hoop * kinematics.hoop(m, q);
            for (unsigned int c = 0; c < dim; ++c)
              for (unsigned int d = 0; d < dim; ++d)
                f[kinematics.index(c, m)] += tau[c][d] * kinematics.gradients()(q * dim + d, m);
          }
      }
    return f;
  }

  template <int dim>
  void
  FiniteStrainCell<dim>::make_tangent(FullMatrix<double> &K)
  {
    fill_strains();
    fill_material_stresses();
    strains.Tmmult(K, material_stresses);
    add_geometric(K);
    if (kinematics.kind == ProblemType::axisymmetric)
      add_hoop(K);
  }

  // Rows e_bar(B) and tr B of every point; the latter's projection first.
  template <int dim>
  void
  FiniteStrainCell<dim>::fill_strains()
  {
    const unsigned int n_q = kinematics.n_points(), n = kinematics.n_nodes * dim;
    const auto        &g = kinematics.gradients();
    divergences.reinit(n_q, n, true);
    dilatations.reinit(n_q, n, true);
    strains.reinit(n_q * n_rows, n);
    for (unsigned int q = 0; q < n_q; ++q)
      for (unsigned int m = 0; m < kinematics.n_nodes; ++m)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const unsigned int i    = kinematics.index(c, m);
            const double       hoop = c == 0 ? kinematics.hoop(m, q) : 0.;
            divergences(q, i)       = g(q * dim + c, m);
            dilatations(q, i)       = kinematics.jacobian(q) * (divergences(q, i) + hoop);

            strains(q * n_rows + c, i) = g(q * dim + c, m);
            if (dim == 2)
              strains(q * n_rows + 2, i) = hoop;
            for (unsigned int k = 3; k < n_voigt<dim>; ++k)
              if (const auto [a, b] = voigt_indices[k]; c == a || c == b)
                strains(q * n_rows + k, i) = g(q * dim + a + b - c, m);
          }
    if (projects)
      add_mean_dilatation();
  }

  template <int dim>
  void
  FiniteStrainCell<dim>::add_mean_dilatation()
  {
    kinematics.project(dilatations);
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      {
        const double  inverse  = 1 / kinematics.dilatation(q);
        const double *mean     = &dilatations(q, 0);
        double       *strain[] = {&strains(q * n_rows, 0),
                                  &strains(q * n_rows + 1, 0),
                                  &strains(q * n_rows + 2, 0),
                                  &strains(q * n_rows + n_voigt<dim>, 0)};
        for (unsigned int i = 0; i < dilatations.n(); ++i)
          {
            const double divergence = strain[0][i] + strain[1][i] + strain[2][i],
                         change     = (inverse * mean[i] - divergence) * (1. / 3);
            for (unsigned int k = 0; k < 3; ++k)
              strain[k][i] += change;
            strain[3][i] = divergence;
          }
      }
  }

  // All but the terms of B tau A^T and B A, as a form in (e_bar, tr B): with a(B) = (tr e_bar(B) - tr B)/3,
  //   e_bar:e_bar  c + 2/3 (dev tau x I + I x dev tau) - tr tau/9 I x I
  //   e_bar:tr     -2/3 dev tau
  //   tr:tr        J pi - 2/9 tr tau
  template <int dim>
  typename FiniteStrainCell<dim>::Matrix
  FiniteStrainCell<dim>::material_matrix(const unsigned int q) const
  {
    SpatialTangent c = spatial_tangent(*law, strain[q]);
    if (!projects)
      c = condense_thickness(c);
    Matrix M = {};
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      for (unsigned int l = 0; l < n_voigt<dim>; ++l)
        M[k][l] = c[k][l];
    if (!projects)
      return M;

    const double trace = trace_of(stress[q]);
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      {
        const double deviator = 2. / 3 * (k < 3 ? stress[q][k] - trace / 3 : stress[q][k]);
        for (unsigned int l = 0; l < 3; ++l)
          {
            M[k][l] += deviator - (k < 3 ? trace / 9 : 0.);
            M[l][k] += deviator;
          }
        M[k][n_voigt<dim>] = M[n_voigt<dim>][k] = -deviator;
      }
    M[n_voigt<dim>][n_voigt<dim>] = pressure[q] - 2. / 9 * trace;
    if (stabilised)
      add_stabilisation(q, M);
    return M;
  }

  // D(B) is tr e_bar(B), and d:B = d:e_bar(B):
  //   e_bar:e_bar  (2 s + m phi j^2) I x I - 2 m r j (d x I + I x d)
  //   e_bar:tr     2 m r j d - 2/3 m r^2 d - (s + m phi j^2) I
  //   tr:tr        m phi j^2 - 2/9 m r^2 tr (J^(-2/3) b)
  template <int dim>
  void
  FiniteStrainCell<dim>::add_stabilisation(const unsigned int q, Matrix &M) const
  {
    const auto  &stable = stabilisation[q];
    const double j = stable.ratio, s = stable.pressure(), stiffness = stable.m * stable.phi * j * j,
                 mixed          = 2 * stable.m * stable.r * j;
    const Voigt<3>     d        = as_voigt(deviator(stable.unimodular));
    const unsigned int of_trace = n_voigt<dim>;
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      {
        for (unsigned int l = 0; l < 3; ++l)
          {
            M[k][l] += (k < 3 ? 2 * s + stiffness : 0.) - mixed * d[k];
            M[l][k] -= mixed * d[k];
          }
        const double of_both = (mixed - 2. / 3 * stable.shear()) * d[k] - (k < 3 ? s + stiffness : 0.);
        M[k][of_trace] += of_both;
        M[of_trace][k] += of_both;
      }
    M[of_trace][of_trace] += stiffness - 2. / 9 * stable.shear() * trace(stable.unimodular);
  }

  template <int dim>
  void
  FiniteStrainCell<dim>::fill_material_stresses()
  {
    const unsigned int n = strains.n();
    material_stresses.reinit(strains.m(), n);
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      {
        const Matrix M = material_matrix(q);
        for (unsigned int k = 0; k < n_rows; ++k)
          for (unsigned int l = 0; l < n_rows; ++l)
            if (const double factor = kinematics.weight(q) * M[k][l]; factor != 0)
              {
                double       *to   = &material_stresses(q * n_rows + k, 0);
                const double *from = &strains(q * n_rows + l, 0);
                for (unsigned int i = 0; i < n; ++i)
                  to[i] += factor * from[i];
              }
      }
  }

  // Shape functions N_m e_c and N_n e_d, with gradients g:
  // int [ d_cd g_m.tau g_n + (tr tau/3 - J pi) g_m[d] g_n[c] ] dV0
  template <int dim>
  void
  FiniteStrainCell<dim>::add_geometric(FullMatrix<double> &K)
  {
    const unsigned int n_q = kinematics.n_points(), n_nodes = kinematics.n_nodes;
    const auto        &g = kinematics.gradients();
    stressed_gradients.reinit(n_q * dim, n_nodes);
    weighted_divergences.reinit(n_q, n_nodes * dim, true);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        const Voigt<3>       all   = all_stress(q);
        const Tensor<2, dim> tau   = kinematics.weight(q) * in_space<dim>(all, 0);
        const double         kappa = kinematics.weight(q) * (trace_of(all) / 3 - pressure[q]);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            for (unsigned int m = 0; m < n_nodes; ++m)
              stressed_gradients(q * dim + c, m) += tau[c][d] * g(q * dim + d, m);
        for (unsigned int i = 0; i < n_nodes * dim; ++i)
          weighted_divergences(q, i) = kappa * divergences(q, i);
      }
    of_nodes.reinit(n_nodes, n_nodes, true);
    of_components.reinit(n_nodes * dim, n_nodes * dim, true);
    g.Tmmult(of_nodes, stressed_gradients);
    divergences.Tmmult(of_components, weighted_divergences);
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        for (unsigned int m = 0; m < n_nodes; ++m)
          for (unsigned int n = 0; n < n_nodes; ++n)
            K(kinematics.index(c, m), kinematics.index(d, n)) +=
                of_components(kinematics.index(d, m), kinematics.index(c, n)) +
                (c == d ? of_nodes(m, n) : 0.);
  }

  // The same of the hoop components: int (tau_33 + tr tau/3 - J pi) N_m/r N_n/r dV0
  template <int dim>
  void
  FiniteStrainCell<dim>::add_hoop(FullMatrix<double> &K) const
  {
    for (unsigned int q = 0; q < kinematics.n_points(); ++q)
      {
        const Voigt<3> all    = all_stress(q);
        const double   factor = kinematics.weight(q) * (all[2] + trace_of(all) / 3 - pressure[q]);
        for (unsigned int m = 0; m < kinematics.n_nodes; ++m)
          for (unsigned int n = 0; n < kinematics.n_nodes; ++n)
            K(kinematics.index(0, m), kinematics.index(0, n)) +=
                factor * kinematics.hoop(m, q) * kinematics.hoop(n, q);
      }
  }

  template <int dim>
  Voigt<dim>
  FiniteStrainCell<dim>::cauchy_stress(const unsigned int q) const
  {
    const double J = std::sqrt(1 + change_of_determinant(strain[q]));
    Voigt<dim>   sigma;
    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
      sigma[k] = stress[q][k] / J;
    return sigma;
  }

  template class FiniteStrainCell<2>;
  template class FiniteStrainCell<3>;
} // namespace Amontons
