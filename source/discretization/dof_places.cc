#include <amontons/discretization/dof_places.h>

namespace Amontons
{
  template <int dim>
  std::vector<DofPlace<dim>>
  places_of_dofs(const Discretization<dim> &discretization, const LA::Vector *displacement)
  {
    const auto                &relevant = discretization.relevant;
    std::vector<DofPlace<dim>> places(relevant.n_elements());
    for_each_node(discretization, [&](const auto &cell, const auto &node, Point<dim> X) {
      for (unsigned int c = 0; displacement != nullptr && c < dim; ++c)
        X[c] += (*displacement)(node[c]);
      for (unsigned int c = 0; c < dim; ++c)
        places[relevant.index_within_set(node[c])] = {cell->material_id(), c, X};
    });
    return places;
  }

  template std::vector<DofPlace<2>>
  places_of_dofs(const Discretization<2> &, const LA::Vector *);
  template std::vector<DofPlace<3>>
  places_of_dofs(const Discretization<3> &, const LA::Vector *);
} // namespace Amontons
