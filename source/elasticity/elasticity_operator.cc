#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/elasticity/kirchhoff.h>

#include <deal.II/base/quadrature_lib.h>

#include <limits>
#include <numeric>

namespace Amontons
{
  namespace
  {
    const double infinity = std::numeric_limits<double>::infinity();

    template <int dim>
    InvertedCell<dim>
    worst_of_all(const InvertedCell<dim> &mine, const MPI_Comm communicator)
    {
      const auto         extremes = Utilities::MPI::min_max_avg(mine.smallest_jacobian, communicator);
      InvertedCell<dim>  worst    = mine;
      const unsigned int rank     = extremes.min_index;
      worst.smallest_jacobian     = extremes.min;
      worst.centre                = Utilities::MPI::broadcast(communicator, mine.centre, rank);
      worst.body                  = Utilities::MPI::broadcast(communicator, mine.body, rank);
      return worst;
    }
  } // namespace

  template <int dim>
  ElasticityOperator<dim>::ElasticityOperator(const Discretization<dim> &discretization,
                                              const bool                 finite_strain)
      : discretization(discretization), is_finite(finite_strain),
        n_values(discretization.fe.n_dofs_per_cell() * (discretization.fe.n_dofs_per_cell() + 1) / 2),
        n_dilatations(!finite_strain || discretization.scene.kind == ProblemType::plane_stress
                          ? 0
                          : PressureProjection<dim>::n_coefficients(discretization.fe.degree))
  {
    for (const auto &body : discretization.scene.bodies)
      {
        materials.emplace_back(body.material, discretization.scene.kind);
        laws.push_back(make_law(body.material));
      }
  }

  template <int dim>
  UpdateFlags
  ElasticityOperator<dim>::needed_flags()
  {
    return update_values | update_gradients | update_quadrature_points | update_JxW_values;
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  ElasticityOperator<dim>::assemble(const LA::Vector &u, const std::vector<double> &dilatations)
  {
    clear();
    is_clear = false;
    find_cells();
    if (is_finite)
      return assemble_finite(u, dilatations, true);
    assemble_small();
    return {};
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  ElasticityOperator<dim>::update_forces(const LA::Vector &u, const std::vector<double> &dilatations)
  {
    cell_dilatations.clear();
    excesses.clear();
    return assemble_finite(u, dilatations, false);
  }

  template <int dim>
  void
  ElasticityOperator<dim>::find_cells()
  {
    const unsigned int n = discretization.fe.n_dofs_per_cell();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          cells.push_back({std::vector<types::global_dof_index>(n),
                           cell->material_id(),
                           cell->minimum_vertex_distance()});
          cell->get_dof_indices(cells.back().dofs);
        }
    values.reserve(cells.size() * n_values);
  }

  template <int dim>
  void
  ElasticityOperator<dim>::assemble_small()
  {
    const auto         &fe = discretization.fe;
    const QGauss<dim>   quadrature(fe.degree + 1);
    FEValues<dim>       fe_values(discretization.mapping(), fe, quadrature, needed_flags());
    StrainOperator<dim> B(fe, discretization.scene.kind);
    const unsigned int  n = fe.n_dofs_per_cell(), n_v = n_voigt<dim>;

    // Row q n_v + k: component k at point q.
    FullMatrix<double> strains(quadrature.size() * n_v, n), weighted(strains.m(), n), K(n, n);
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          fe_values.reinit(cell);
          B.reinit(fe_values);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            for (unsigned int i = 0; i < n; ++i)
              {
                const Voigt<dim> &strain = B.strain(i, q);
                const Voigt<dim>  stress = materials[cell->material_id()].stress(strain);
                for (unsigned int k = 0; k < n_v; ++k)
                  {
                    strains(q * n_v + k, i)  = strain[k];
                    weighted(q * n_v + k, i) = B.weight(q) * stress[k];
                  }
              }
          strains.Tmmult(K, weighted);
          pack(K);
        }
  }

  template <int dim>
  void
  ElasticityOperator<dim>::pack(const FullMatrix<double> &K)
  {
    for (unsigned int i = 0; i < K.m(); ++i)
      for (unsigned int j = 0; j <= i; ++j)
        values.push_back(K(i, j));
  }

  template <int dim>
  template <typename Action>
  void
  ElasticityOperator<dim>::for_each_deformed_cell(const LA::Vector &u,
                                                  const double     *dilatations,
                                                  const Action     &action) const
  {
    const auto           &fe = discretization.fe;
    FEValues<dim>         fe_values(discretization.mapping(), fe, QGauss<dim>(fe.degree + 1), needed_flags());
    FiniteStrainCell<dim> state(fe, discretization.scene.kind);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    std::vector<double>                  local(dofs.size());
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          fe_values.reinit(cell);
          cell->get_dof_indices(dofs);
          u.extract_subvector_to(dofs, local);
          action(cell, dofs, state, state.reinit(fe_values, laws[cell->material_id()], local, dilatations));
          if (dilatations != nullptr)
            dilatations += n_dilatations;
        }
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  ElasticityOperator<dim>::assemble_finite(const LA::Vector          &u,
                                           const std::vector<double> &dilatations,
                                           const bool                 with_tangent)
  {
    assembled_forces           = discretization.make_owned_vector();
    assembled_forces_of_excess = discretization.make_owned_vector();
    InvertedCell<dim>  worst   = {{}, 0, std::numeric_limits<double>::max()};
    FullMatrix<double> K(discretization.fe.n_dofs_per_cell(), discretization.fe.n_dofs_per_cell());
    for_each_deformed_cell(
        u,
        dilatations.empty() ? nullptr : dilatations.data(),
        [&](const auto &cell, const auto &dofs, auto &state, const double smallest) {
          if (!(smallest >= worst.smallest_jacobian))
            worst = {cell->center(), cell->material_id(), std::isnan(smallest) ? -infinity : smallest};
          if (worst.smallest_jacobian > 0)
            {
              assembled_forces.add(dofs, state.forces());
              if (n_dilatations > 0)
                {
                  assembled_forces_of_excess.add(dofs, state.forces_of_excess());
                  for (unsigned int k = 0; k < n_dilatations; ++k)
                    {
                      cell_dilatations.push_back(state.dilatation()[k]);
                      excesses.push_back(state.excess()[k]);
                    }
                }
              if (with_tangent)
                {
                  state.make_tangent(K);
                  pack(K);
                  keep_change_of_volume(state);
                }
            }
        });
    assembled_forces.compress(VectorOperation::add);
    assembled_forces_of_excess.compress(VectorOperation::add);
    worst = worst_of_all(worst, discretization.geometry.communicator);
    if (worst.smallest_jacobian > 0)
      return {};
    if (with_tangent)
      clear();
    return worst;
  }

  template <int dim>
  void
  ElasticityOperator<dim>::keep_change_of_volume(const FiniteStrainCell<dim> &cell)
  {
    if (n_dilatations > 0)
      {
        const auto &changes = cell.change_of_volume();
        for (unsigned int k = 0; k < n_dilatations; ++k)
          for (unsigned int i = 0; i < changes.n(); ++i)
            changes_of_volume.push_back(changes(k, i));
      }
  }

  // P J(u) - theta + P(J tr A)
  template <int dim>
  std::vector<double>
  ElasticityOperator<dim>::change_of_dilatations(const LA::Vector &step) const
  {
    std::vector<double> result = excesses, local(discretization.fe.n_dofs_per_cell());
    for (unsigned int c = 0; n_dilatations > 0 && c < cells.size(); ++c)
      {
        step.extract_subvector_to(cells[c].dofs, local);
        for (unsigned int k = c * n_dilatations; k < (c + 1) * n_dilatations; ++k)
          result[k] = std::inner_product(
              local.begin(), local.end(), changes_of_volume.begin() + k * local.size(), result[k]);
      }
    return result;
  }

  template <int dim>
  std::optional<std::vector<double>>
  ElasticityOperator<dim>::dilatations_after_refinement() const
  {
    bool any = false;
    for (unsigned int body = 0; body < laws.size(); ++body)
      any = any || is_nearly_incompressible(body);
    if (!any)
      return {};
    std::vector<double> result = cell_dilatations;
    for (unsigned int k = 0; k < result.size(); ++k)
      if (is_nearly_incompressible(cells[k / n_dilatations].body))
        result[k] = 0;
    return result;
  }

  template <int dim>
  FullMatrix<double>
  ElasticityOperator<dim>::matrix(const unsigned int c) const
  {
    const unsigned int n = cells[c].dofs.size();
    FullMatrix<double> K(n, n);
    const double      *value = &values[c * n_values];
    for (unsigned int i = 0; i < n; ++i)
      for (unsigned int j = 0; j <= i; ++j)
        K(i, j) = K(j, i) = *value++;
    return K;
  }

  template <int dim>
  CellMatrices
  ElasticityOperator<dim>::tangent() const
  {
    CellMatrices result;
    result.n      = n_cells();
    result.dofs   = [this](const unsigned int c) -> const auto   &{ return dofs(c); };
    result.matrix = [this](const unsigned int c) { return matrix(c); };
    return result;
  }

  template <int dim>
  LA::Vector
  ElasticityOperator<dim>::internal_forces(const LA::Vector &u) const
  {
    if (!is_finite)
      return multiply(u);
    LA::Vector result = discretization.make_owned_vector();
    for_each_deformed_cell(
        u, nullptr, [&](const auto &, const auto &dofs, const auto &state, const double smallest) {
          result.add(dofs,
                     smallest > 0
                         ? state.forces()
                         : std::vector<double>(dofs.size(), std::numeric_limits<double>::quiet_NaN()));
        });
    result.compress(VectorOperation::add);
    return result;
  }

  template <int dim>
  LA::Vector
  ElasticityOperator<dim>::multiply(const LA::Vector &u) const
  {
    LA::Vector                result = discretization.make_owned_vector();
    std::vector<unsigned int> all(cells.size());
    std::iota(all.begin(), all.end(), 0);
    add_internal_forces(all, u, result);
    return result;
  }

  template <int dim>
  std::vector<unsigned int>
  ElasticityOperator<dim>::cells_with(const std::set<types::global_dof_index> &dofs) const
  {
    std::vector<unsigned int> result;
    for (unsigned int c = 0; c < cells.size(); ++c)
      if (std::any_of(cells[c].dofs.begin(), cells[c].dofs.end(), [&](const auto dof) {
            return dofs.count(dof) > 0;
          }))
        result.push_back(c);
    return result;
  }

  template <int dim>
  void
  ElasticityOperator<dim>::add_internal_forces(const std::vector<unsigned int> &of_cells,
                                               const LA::Vector                &u,
                                               LA::Vector                      &forces) const
  {
    std::vector<double> local(discretization.fe.n_dofs_per_cell()), force(local.size());
    for (const unsigned int c : of_cells)
      {
        const double *value = &values[c * n_values];
        u.extract_subvector_to(cells[c].dofs, local);
        for (unsigned int i = 0; i < local.size(); ++i)
          {
            double sum = 0;
            for (unsigned int j = 0; j < i; ++j)
              {
                sum += value[j] * local[j];
                force[j] += value[j] * local[i];
              }
            force[i] = sum + value[i] * local[i];
            value += i + 1;
          }
        forces.add(cells[c].dofs, force);
      }
    forces.compress(VectorOperation::add);
  }

  template <int dim>
  double
  ElasticityOperator<dim>::stored_energy(const LA::Vector &u) const
  {
    double energy = 0;
    if (is_finite)
      for_each_deformed_cell(
          u, nullptr, [&](const auto &, const auto &, const auto &state, const double smallest) {
            energy += smallest > 0 ? state.energy() : infinity;
          });
    else
      {
        const LA::Vector force = multiply(u);
        for (const auto dof : discretization.locally_owned)
          energy += 0.5 * force(dof) * u(dof);
      }
    return Utilities::MPI::sum(energy, discretization.geometry.communicator);
  }

  template <int dim>
  double
  ElasticityOperator<dim>::rounding_scale(const LA::Vector &u) const
  {
    double sum = 0;
    for (unsigned int c = 0; c < cells.size(); ++c)
      {
        const double rounded = is_finite ? 0.02 * cells[c].size : 0.;
        for (unsigned int i = 0; i < cells[c].dofs.size(); ++i)
          sum += std::pow(diagonal(c, i) * (std::abs(u(cells[c].dofs[i])) + rounded), 2);
      }
    return std::sqrt(Utilities::MPI::sum(sum, discretization.geometry.communicator));
  }

  template <int dim>
  std::vector<Voigt<dim>>
  ElasticityOperator<dim>::stresses(const FEValues<dim>                                  &values,
                                    const typename DoFHandler<dim>::active_cell_iterator &cell,
                                    const LA::Vector                                     &u) const
  {
    const auto                          &fe = discretization.fe;
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    std::vector<double> local(dofs.size());
    u.extract_subvector_to(dofs, local);
    std::vector<Voigt<dim>> result(values.n_quadrature_points);
    if (is_finite)
      {
        FiniteStrainCell<dim> state(fe, discretization.scene.kind);
        const double          smallest = state.reinit(values, laws[cell->material_id()], local);
        for (unsigned int q = 0; q < result.size(); ++q)
          if (smallest > 0)
            result[q] = state.cauchy_stress(q);
          else
            result[q].fill(std::numeric_limits<double>::quiet_NaN());
        return result;
      }
    StrainOperator<dim> B(fe, discretization.scene.kind);
    B.reinit(values);
    for (unsigned int q = 0; q < result.size(); ++q)
      {
        Voigt<dim> strain;
        strain.fill(0);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            strain[k] += local[i] * B.strain(i, q)[k];
        result[q] = materials[cell->material_id()].stress(strain);
      }
    return result;
  }

  namespace
  {
    // Of the displacement whose nodal values of the cell are u.
    template <int dim>
    Tensor<2, 3>
    gradient(const FEValues<dim>       &values,
             const unsigned int         q,
             const std::vector<double> &u,
             const ProblemType          kind)
    {
      const auto  &fe = values.get_fe();
      Tensor<2, 3> H;
      for (unsigned int j = 0; j < fe.base_element(0).n_dofs_per_cell(); ++j)
        {
          const unsigned int   first = fe.component_to_system_index(0, j);
          const Tensor<1, dim> grad  = values.shape_grad(first, q);
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              H[c][d] += u[fe.component_to_system_index(c, j)] * grad[d];
          if (kind == ProblemType::axisymmetric)
            H[2][2] += u[first] * values.shape_value(first, q) / values.quadrature_point(q)[0];
        }
      return H;
    }

    // The stress with no more pressure than 3/4 |dev sigma| (of one stress in plane strain, nu = 1/2, it is
    // 0.71), or than there were with 2 mu for lambda. A larger one is that of confined matter, and where it
    // is even no force comes of it: the cofactors of 1 + H have no divergence.
    Tensor<2, 3>
    less_confined(const Tensor<2, 3> &sigma, const double lambda, const double mu)
    {
      const Tensor<2, 3> I    = unit_symmetric_tensor<3>();
      const double       mean = trace(sigma) / 3, most_lambda = std::min(lambda, 2 * mu),
                   most = std::max(0.75 * (sigma - mean * I).norm(),
                                   std::abs(mean) * (3 * most_lambda + 2 * mu) / (3 * lambda + 2 * mu));
      return sigma + (std::clamp(mean, -most, most) - mean) * I;
    }
  } // namespace

  template <int dim>
  double
  ElasticityOperator<dim>::energy_of_neglected_stress(
      const FEValues<dim>                                  &values,
      const typename DoFHandler<dim>::active_cell_iterator &cell,
      const LA::Vector                                     &u,
      const std::vector<Voigt<dim>>                        &stress,
      const Tensor<2, dim>                                 &turn) const
  {
    const auto       &fe           = discretization.fe;
    const ProblemType kind         = discretization.scene.kind;
    const auto       &law          = materials[cell->material_id()];
    const bool        plane_stress = kind == ProblemType::plane_stress;
    const bool        is_neo_hookean =
        discretization.scene.bodies[cell->material_id()].material.law == Law::neo_hookean;
    const double lambda    = std::min(law.lambda, 2 * law.mu);
    const double thickness = law.lambda / (2 * law.mu), // plane stress: lambda/(lambda + 2 mu)
        of_trace = plane_stress ? thickness / (1 + 2 * thickness) : lambda / (3 * lambda + 2 * law.mu);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    std::vector<double> local(dofs.size());
    u.extract_subvector_to(dofs, local);
    double energy = 0;
    for (const unsigned int q : values.quadrature_point_indices())
      {
        Tensor<2, 3> H = gradient<dim>(values, q, local, kind);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            H[c][d] -= turn[c][d];
        if (plane_stress)
          H[2][2] = -thickness * (H[0][0] + H[1][1]);
        const Tensor<2, 3> e       = 0.5 * (H + transpose(H)),
                           sigma   = plane_stress ? as_tensor(stress[q])
                                                  : less_confined(as_tensor(stress[q]), law.lambda, law.mu),
                           product = 0.5 * (sigma * e + e * sigma);
        Tensor<2, 3> quadratic     = 0.5 * transpose(H) * H;
        const double change        = is_neo_hookean ? trace(e) * trace(e) - scalar_product(e, e) : 0.;
        if (plane_stress) // no stress across
          quadratic[2][2] = -thickness * (quadratic[0][0] + quadratic[1][1] + change);
        const double pressure =
            plane_stress ? -2 * law.mu * quadratic[2][2] : lambda * (trace(quadratic) + change);
        const Tensor<2, 3> r = 2 * law.mu * quadratic + pressure * unit_symmetric_tensor<3>() +
                               (is_neo_hookean ? -1. : 1.) * product;
        energy += (r.norm_square() - of_trace * trace(r) * trace(r)) / (2 * law.mu) * values.JxW(q) *
                  measure<dim>(kind, values.quadrature_point(q));
      }
    return energy;
  }

  template class ElasticityOperator<2>;
  template class ElasticityOperator<3>;
} // namespace Amontons
