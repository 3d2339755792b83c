#include <amontons/elasticity/boundary_faces.h>

namespace Amontons
{
  template <int dim>
  DeformedFace<dim>
  deform(const FEFaceValues<dim> &values, const LA::Vector *u)
  {
    const unsigned int n_q = values.n_quadrature_points;
    DeformedFace<dim>  face{values.get_quadrature_points(),
                           std::vector<Tensor<2, dim>>(n_q, unit_symmetric_tensor<dim>()),
                           values.get_normal_vectors()};
    if (u == nullptr)
      return face;

    const FEValuesExtractors::Vector all(0);
    std::vector<Tensor<1, dim>>      displacements(n_q);
    std::vector<Tensor<2, dim>>      gradients(n_q);
    values[all].get_function_values(*u, displacements);
    values[all].get_function_gradients(*u, gradients);
    for (unsigned int q = 0; q < n_q; ++q)
      {
        face.positions[q] += displacements[q];
        face.gradients[q] += gradients[q];
        face.normals[q] = cofactor(face.gradients[q]) * face.normals[q];
      }
    return face;
  }

  template DeformedFace<2>
  deform(const FEFaceValues<2> &, const LA::Vector *);
  template DeformedFace<3>
  deform(const FEFaceValues<3> &, const LA::Vector *);
} // namespace Amontons
