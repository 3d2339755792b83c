#include <amontons/adaptivity/smallest_cells.h>

namespace Amontons
{
  template <int dim>
  double
  error_of_smallest_cells(const Discretization<dim> &discretization, const Vector<float> &indicators)
  {
    double mine = 0;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()) &&
          cell->level() >= most_levels<dim>)
        mine += std::pow(double(indicators[cell->active_cell_index()]), 2);
    return std::sqrt(Utilities::MPI::sum(mine, discretization.geometry.communicator));
  }

  template double
  error_of_smallest_cells(const Discretization<2> &, const Vector<float> &);
  template double
  error_of_smallest_cells(const Discretization<3> &, const Vector<float> &);
} // namespace Amontons
