#include <amontons/elasticity/elasticity_operator.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  template <int dim>
  ElasticityOperator<dim>::ElasticityOperator(const Discretization<dim> &discretization)
      : discretization(discretization)
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
  void
  ElasticityOperator<dim>::assemble()
  {
    cells.clear();
    const auto         &fe = discretization.fe;
    const QGauss<dim>   quadrature(fe.degree + 1);
    FEValues<dim>       values(discretization.mapping, fe, quadrature, needed_flags());
    StrainOperator<dim> B(fe, discretization.scene.kind);
    const unsigned int  n = fe.n_dofs_per_cell();

    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          values.reinit(cell);
          B.reinit(values);
          const LinearElastic<dim> &material = materials[cell->material_id()];
          cells.push_back(
              {std::vector<types::global_dof_index>(n), FullMatrix<double>(n, n), cell->material_id()});
          CellStiffness &K = cells.back();
          cell->get_dof_indices(K.dofs);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            for (unsigned int j = 0; j < n; ++j)
              {
                Voigt<dim> sigma = material.stress(B.strain(j, q));
                for (double &s : sigma)
                  s *= B.weight(q);
                for (unsigned int i = 0; i <= j; ++i)
                  {
                    const Voigt<dim> &b   = B.strain(i, q);
                    double            sum = 0;
                    for (unsigned int k = 0; k < n_voigt<dim>; ++k)
                      sum += b[k] * sigma[k];
                    K.matrix(i, j) += sum;
                  }
              }
          for (unsigned int j = 0; j < n; ++j)
            for (unsigned int i = 0; i < j; ++i)
              K.matrix(j, i) = K.matrix(i, j);
        }
  }

  template <int dim>
  LA::Vector
  ElasticityOperator<dim>::apply(const LA::Vector &u) const
  {
    LA::Vector     result = discretization.make_owned_vector();
    Vector<double> local(discretization.fe.n_dofs_per_cell()), force(local.size());
    for (const auto &cell : cells)
      {
        for (unsigned int i = 0; i < local.size(); ++i)
          local[i] = u(cell.dofs[i]);
        cell.matrix.vmult(force, local);
        result.add(cell.dofs, std::vector<double>(force.begin(), force.end()));
      }
    result.compress(VectorOperation::add);
    return result;
  }

  template <int dim>
  double
  ElasticityOperator<dim>::rounding_scale(const LA::Vector &u) const
  {
    double sum = 0;
    for (const auto &cell : cells)
      for (unsigned int i = 0; i < cell.dofs.size(); ++i)
        sum += std::pow(cell.matrix(i, i) * u(cell.dofs[i]), 2);
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
