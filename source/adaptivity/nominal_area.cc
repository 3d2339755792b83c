#include <amontons/adaptivity/nominal_area.h>

#include <cmath>

namespace Amontons
{
  template <int dim>
  NominalArea<dim>::NominalArea(const Discretization<dim>     &discretization,
                                const std::vector<Point<dim>> &points,
                                const LA::Vector              &displacement)
      : discretization(discretization), displacement(displacement),
        values(discretization.mapping(),
               discretization.fe,
               Quadrature<dim>(points),
               update_values | update_gradients | update_quadrature_points),
        gradients(points.size()), motions(points.size())
  {
    for (const auto &of_body : discretization.scene.bodies)
      laws.push_back(make_law(of_body.material));
  }

  template <int dim>
  void
  NominalArea<dim>::reinit(const typename DoFHandler<dim>::active_cell_iterator &cell)
  {
    const FEValuesExtractors::Vector u(0);
    values.reinit(cell);
    values[u].get_function_gradients(displacement, gradients);
    values[u].get_function_values(displacement, motions);
    body = cell->material_id();
  }

  template <int dim>
  Tensor<1, dim>
  NominalArea<dim>::vector(const unsigned int q, const Tensor<1, dim> &normal, const bool tied) const
  {
    const ProblemType    kind      = discretization.scene.kind;
    const Tensor<2, dim> F         = gradients[q] + Tensor<2, dim>(unit_symmetric_tensor<dim>());
    double               thickness = 1;
    if (kind == ProblemType::plane_stress)
      {
        SymmetricTensor<2, 3> e; // F F^T - I
        for (unsigned int i = 0; i < dim; ++i)
          for (unsigned int j = i; j < dim; ++j)
            {
              e[i][j] = gradients[q][i][j] + gradients[q][j][i];
              for (unsigned int k = 0; k < dim; ++k)
                e[i][j] += gradients[q][i][k] * gradients[q][j][k];
            }
        thickness = std::sqrt(1 + thickness_strain(laws[body], e));
      }
    if (kind == ProblemType::axisymmetric && tied) // of the hoop
      thickness = 1 + motions[q][0] / values.quadrature_point(q)[0];
    return thickness * (tied ? determinant(F) * transpose(invert(F)) * normal : normal);
  }

  template class NominalArea<2>;
  template class NominalArea<3>;
} // namespace Amontons
