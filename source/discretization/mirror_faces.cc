#include <amontons/discretization/mirror_faces.h>

#include <set>

namespace Amontons
{
  template <int dim>
  IsMirror<dim>
  planes_of_symmetry(const Discretization<dim> &discretization)
  {
    const auto                  &scene = discretization.scene;
    std::set<types::boundary_id> boundaries;
    for (const auto &condition : scene.conditions)
      if (condition.type == ConditionData::Type::symmetry)
        for (const auto &name : condition.boundaries)
          boundaries.insert(discretization.geometry.boundary(name, scene).id);
    return [boundaries, on_axis = scene.kind == ProblemType::axisymmetric](const auto &face) {
      return boundaries.count(face->boundary_id()) > 0 ||
             (on_axis && std::abs(face->center()[0]) < 1e-10 * face->diameter());
    };
  }

  template IsMirror<2>
  planes_of_symmetry(const Discretization<2> &);
  template IsMirror<3>
  planes_of_symmetry(const Discretization<3> &);
} // namespace Amontons
