#include <amontons/elasticity/boundary_faces.h>
#include <amontons/elasticity/kinematics.h>
#include <amontons/elasticity/load_values.h>
#include <amontons/elasticity/loads.h>

namespace Amontons
{
  // f_i = -int p N_i n m da/dA dA,  n da/dA = cof F N =: v,  m = measure(x):
  //   d f_i/du_j = -int p N_i [ (div N_j v - (grad N_j)^T v) m + dm/du_j v ] dA
  // with spatial gradients; dm/du_r = 2 pi N_j in axisymmetry, else 0.
  template <int dim>
  class PressureStiffness
  {
  public:
    PressureStiffness(const Discretization<dim> &discretization, const double t, const LA::Vector &u)
        : fe(discretization.fe), kind(discretization.scene.kind), t(t), u(u),
          values(discretization,
                 QGauss<dim - 1>(fe.degree + 2),
                 update_values | update_gradients | update_quadrature_points | update_JxW_values |
                     update_normal_vectors)
    {
    }

    template <typename ForEach>
    void
    measure_load(const std::array<Expression, 3> &load, const ForEach &for_each)
    {
      values.measure(load, t, for_each);
    }

    LocalMatrix
    matrix(const typename DoFHandler<dim>::active_cell_iterator &cell,
           const unsigned int                                    f,
           const std::array<Expression, 3>                      &load)
    {
      const auto         on_face = this->values.reinit(load, t, cell, f);
      const auto        &values  = on_face.values;
      const auto         face    = deform(values, &u);
      const unsigned int n       = fe.n_dofs_per_cell();
      LocalMatrix        result{std::vector<types::global_dof_index>(n), {}, FullMatrix<double>(n, n)};
      cell->get_dof_indices(result.rows);
      result.columns = result.rows;
      for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
        {
          const double p = on_face.load[q][0] * values.JxW(q);
          for (unsigned int j = 0; j < n; ++j)
            {
              const Tensor<1, dim> change = change_of_normal(values, face, q, j);
              for (unsigned int i = 0; i < n; ++i)
                result.matrix(i, j) -=
                    p * values.shape_value(i, q) * change[fe.system_to_component_index(i).first];
            }
        }
      return result;
    }

  private:
    Tensor<1, dim>
    change_of_normal(const FEFaceValues<dim> &values,
                     const DeformedFace<dim> &face,
                     const unsigned int       q,
                     const unsigned int       j) const
    {
      const unsigned int   c        = fe.system_to_component_index(j).first;
      const Tensor<1, dim> gradient = transpose(invert(face.gradients[q])) * values.shape_grad(j, q);
      const auto          &normal   = face.normals[q];
      Tensor<1, dim>       change =
          measure<dim>(kind, face.positions[q]) * (gradient[c] * normal - normal[c] * gradient);
      if (kind == ProblemType::axisymmetric && c == 0)
        change += 2 * numbers::PI * values.shape_value(j, q) * normal;
      return change;
    }

    const FiniteElement<dim> &fe;
    const ProblemType         kind;
    const double              t;
    const LA::Vector         &u;
    LoadFaceValues<dim>       values;
  };

  template <int dim>
  std::vector<LocalMatrix>
  pressure_stiffness(const Discretization<dim> &discretization, const double t, const LA::Vector &u)
  {
    PressureStiffness<dim>   stiffness(discretization, t, u);
    std::vector<LocalMatrix> matrices;
    for (const auto &condition : discretization.scene.conditions)
      if (condition.type == ConditionData::Type::pressure)
        for (const auto &name : condition.boundaries)
          {
            const auto id = discretization.geometry.boundary(name, discretization.scene).id;
            stiffness.measure_load(condition.value,
                                   [&](const auto &action) { for_each_face(discretization, id, action); });
            for_each_face(discretization, id, [&](const auto &cell, const unsigned int f) {
              matrices.push_back(stiffness.matrix(cell, f, condition.value));
            });
          }
    return matrices;
  }

  template std::vector<LocalMatrix>
  pressure_stiffness(const Discretization<2> &, const double, const LA::Vector &);
  template std::vector<LocalMatrix>
  pressure_stiffness(const Discretization<3> &, const double, const LA::Vector &);
} // namespace Amontons
