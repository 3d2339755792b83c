#include <amontons/elasticity/geometric_forces.h>
#include <amontons/elasticity/kinematics.h>
#include <amontons/elasticity/kirchhoff.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    // In the directions of the cell's coordinates, and along the circumference (third, in the plane).
    template <int dim>
    Tensor<2, 3>
    limited(const Voigt<dim> &stress, const double most)
    {
      const auto   sigma = as_tensor(stress);
      const double size  = sigma.norm();
      return size > most ? most / size * sigma : sigma;
    }

    // Of a cell, by its degrees of freedom; v: readable.
    template <int dim>
    std::vector<double>
    cell_forces(const FEValues<dim>           &values,
                const std::vector<Voigt<dim>> &stresses,
                const double                   most_stress,
                const LA::Vector              &v,
                const ProblemType              kind)
    {
      const FEValuesExtractors::Vector displacement(0);
      const unsigned int               n_q = values.n_quadrature_points;
      std::vector<Tensor<2, dim>>      gradients(n_q);
      std::vector<Tensor<1, dim>>      vs(n_q);
      std::vector<double>              forces(values.dofs_per_cell, 0.);
      values[displacement].get_function_gradients(v, gradients);
      values[displacement].get_function_values(v, vs);
      for (unsigned int q = 0; q < n_q; ++q)
        {
          const auto     sigma  = limited<dim>(stresses[q], most_stress);
          const auto    &X      = values.quadrature_point(q);
          const double   weight = values.JxW(q) * measure(kind, X);
          Tensor<2, dim> flux; // grad v sigma
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < dim; ++i)
              for (unsigned int j = 0; j < dim; ++j)
                flux[c][i] += weight * gradients[q][c][j] * sigma[j][i];
          for (unsigned int i = 0; i < forces.size(); ++i)
            {
              const unsigned int c = values.get_fe().system_to_component_index(i).first;
              forces[i] += flux[c] * values.shape_grad(i, q);
              if (kind == ProblemType::axisymmetric && c == 0)
                forces[i] += weight * sigma[2][2] * vs[q][0] * values.shape_value(i, q) / (X[0] * X[0]);
            }
        }
      return forces;
    }
  } // namespace

  template <int dim>
  LA::Vector
  geometric_forces(const ElasticityOperator<dim> &bodies,
                   const Discretization<dim>     &discretization,
                   const LA::Vector              &u,
                   const LA::Vector              &v,
                   const double                   most_strain)
  {
    const Scene      &scene = discretization.scene;
    const QGauss<dim> quadrature(discretization.fe.degree + 1);
    FEValues<dim>     values(
        discretization.mapping(), discretization.fe, quadrature, ElasticityOperator<dim>::needed_flags());
    std::vector<types::global_dof_index> dofs(discretization.fe.n_dofs_per_cell());
    LA::Vector                           result = discretization.make_owned_vector();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          const double most = most_strain * scene.bodies[cell->material_id()].material.young;
          const auto forces = cell_forces<dim>(values, bodies.stresses(values, cell, u), most, v, scene.kind);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            result(dofs[i]) += forces[i];
        }
    result.compress(VectorOperation::add);
    return result;
  }

  template LA::Vector
  geometric_forces(const ElasticityOperator<2> &,
                   const Discretization<2> &,
                   const LA::Vector &,
                   const LA::Vector &,
                   const double);
  template LA::Vector
  geometric_forces(const ElasticityOperator<3> &,
                   const Discretization<3> &,
                   const LA::Vector &,
                   const LA::Vector &,
                   const double);
} // namespace Amontons
