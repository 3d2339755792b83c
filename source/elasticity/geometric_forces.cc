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
      Tensor<2, 3> sigma;
      for (unsigned int k = 0; k < n_voigt<dim>; ++k)
        {
          const auto [i, j] = voigt_indices[k];
          sigma[i][j] = sigma[j][i] = stress[k];
        }
      const double size = sigma.norm();
      return size > most ? most / size * sigma : sigma;
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
    const auto       &fe = discretization.fe;
    const QGauss<dim> quadrature(fe.degree + 1);
    FEValues<dim>     values(discretization.mapping, fe, quadrature, ElasticityOperator<dim>::needed_flags());
    const FEValuesExtractors::Vector     displacement(0);
    std::vector<Tensor<2, dim>>          gradients(quadrature.size());
    std::vector<Tensor<1, dim>>          vs(quadrature.size());
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    const auto                           kind   = discretization.scene.kind;
    LA::Vector                           result = discretization.make_owned_vector();
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        {
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          values[displacement].get_function_gradients(v, gradients);
          values[displacement].get_function_values(v, vs);
          const auto   stresses = bodies.stresses(values, cell, u);
          const double most = most_strain * discretization.scene.bodies[cell->material_id()].material.young;
          std::vector<double> forces(dofs.size(), 0.);
          for (unsigned int q = 0; q < quadrature.size(); ++q)
            {
              const auto     sigma  = limited<dim>(stresses[q], most);
              const auto    &X      = values.quadrature_point(q);
              const double   weight = values.JxW(q) * measure(kind, X);
              Tensor<2, dim> flux; // grad v sigma
              for (unsigned int c = 0; c < dim; ++c)
                for (unsigned int i = 0; i < dim; ++i)
                  for (unsigned int j = 0; j < dim; ++j)
                    flux[c][i] += weight * gradients[q][c][j] * sigma[j][i];
              for (unsigned int i = 0; i < dofs.size(); ++i)
                {
                  const unsigned int c = fe.system_to_component_index(i).first;
                  forces[i] += flux[c] * values.shape_grad(i, q);
                  if (kind == ProblemType::axisymmetric && c == 0)
                    forces[i] += weight * sigma[2][2] * vs[q][0] * values.shape_value(i, q) / (X[0] * X[0]);
                }
            }
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
