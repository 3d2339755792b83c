#include <amontons/elasticity/elasticity_operator.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim>
  ElasticityOperator<dim>::ElasticityOperator(const Discretization<dim> &discretization,
                                              const bool                 finite_strain)
      : discretization(discretization), is_finite(finite_strain),
        n_values(discretization.fe.n_dofs_per_cell() * (discretization.fe.n_dofs_per_cell() + 1) / 2)
  {
    for (const auto &body : discretization.scene.bodies)
      materials.emplace_back(body.material, discretization.scene.kind);
  }

  template <int dim>
  UpdateFlags
  ElasticityOperator<dim>::needed_flags()
  {
    return update_values | update_gradients | update_quadrature_points | update_JxW_values;
  }

  template <int dim>
  std::optional<InvertedCell<dim>>
  ElasticityOperator<dim>::assemble(const LA::Vector &)
  {
    clear();
    find_cells();
    Assert(!is_finite, ExcNotImplemented());
    assemble_small();
    return {};
  }

  template <int dim>
  void
  ElasticityOperator<dim>::find_cells()
  {
    const unsigned int n = discretization.fe.n_dofs_per_cell();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          cells.push_back({std::vector<types::global_dof_index>(n), cell->material_id()});
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
    FEValues<dim>       fe_values(discretization.mapping, fe, quadrature, needed_flags());
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
          for (unsigned int i = 0; i < n; ++i)
            for (unsigned int j = 0; j <= i; ++j)
              values.push_back(K(i, j));
        }
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
  LA::Vector
  ElasticityOperator<dim>::internal_forces(const LA::Vector &u) const
  {
    LA::Vector          result = discretization.make_owned_vector();
    std::vector<double> local(discretization.fe.n_dofs_per_cell()), force(local.size());
    const double       *value = values.data();
    for (const auto &cell : cells)
      {
        u.extract_subvector_to(cell.dofs, local);
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
        result.add(cell.dofs, force);
      }
    result.compress(VectorOperation::add);
    return result;
  }

  template <int dim>
  double
  ElasticityOperator<dim>::stored_energy(const LA::Vector &u) const
  {
    const LA::Vector force  = internal_forces(u);
    double           energy = 0;
    for (const auto dof : discretization.locally_owned)
      energy += 0.5 * force(dof) * u(dof);
    return Utilities::MPI::sum(energy, discretization.geometry.communicator);
  }

  template <int dim>
  double
  ElasticityOperator<dim>::rounding_scale(const LA::Vector &u) const
  {
    double sum = 0;
    for (unsigned int c = 0; c < cells.size(); ++c)
      for (unsigned int i = 0; i < cells[c].dofs.size(); ++i)
        sum += std::pow(diagonal(c, i) * u(cells[c].dofs[i]), 2);
    return std::sqrt(Utilities::MPI::sum(sum, discretization.geometry.communicator));
  }

  template <int dim>
  std::vector<Voigt<dim>>
  ElasticityOperator<dim>::stresses(const FEValues<dim>                                  &values,
                                    const typename DoFHandler<dim>::active_cell_iterator &cell,
                                    const LA::Vector                                     &u) const
  {
    const auto         &fe = discretization.fe;
    StrainOperator<dim> B(fe, discretization.scene.kind);
    B.reinit(values);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    cell->get_dof_indices(dofs);
    std::vector<Voigt<dim>> result(values.n_quadrature_points);
    for (unsigned int q = 0; q < result.size(); ++q)
      {
        Voigt<dim> strain;
        strain.fill(0);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const double value = u(dofs[i]);
            for (unsigned int k = 0; k < n_voigt<dim>; ++k)
              strain[k] += value * B.strain(i, q)[k];
          }
        result[q] = materials[cell->material_id()].stress(strain);
      }
    return result;
  }

  template class ElasticityOperator<2>;
  template class ElasticityOperator<3>;
} // namespace Amontons
