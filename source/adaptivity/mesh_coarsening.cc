#include <amontons/adaptivity/mesh_coarsening.h>
#include <amontons/adaptivity/mesh_refinement.h>

namespace Amontons
{
  template <int dim>
  std::set<CellId>
  deformable_cells(const Discretization<dim> &discretization)
  {
    std::vector<CellId> mine;
    std::set<CellId>    all;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        mine.push_back(cell->id());
    for (const auto &part : Utilities::MPI::all_gather(discretization.geometry.communicator, mine))
      all.insert(part.begin(), part.end());
    return all;
  }

  template <int dim>
  void
  mark_cells_to_coarsen(const Discretization<dim> &discretization,
                        Geometry<dim>             &geometry,
                        const std::set<CellId>    &first,
                        const Vector<float>       &indicators,
                        const double               target)
  {
    constexpr double part = 0.1; // of the square of the target
    std::map<CellId, std::pair<double, std::vector<typename Triangulation<dim>::active_cell_iterator>>>
        parents;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()) &&
          cell->level() > 0 && !cell->refine_flag_set() && first.count(cell->id()) == 0)
        {
          auto &[square, children] = parents[cell->parent()->id()];
          square += per_level * std::pow(double(indicators[cell->active_cell_index()]), 2);
          children.push_back(cell);
        }
    std::vector<double> squares;
    for (const auto &[id, parent] : parents)
      if (parent.second.size() == GeometryInfo<dim>::max_children_per_cell)
        squares.push_back(parent.first);
    const auto sum_below = [&](const double threshold) {
      double mine = 0;
      for (const double square : squares)
        mine += square <= threshold ? square : 0;
      return Utilities::MPI::sum(mine, geometry.communicator);
    };
    double       low = 0, high = part * target * target;
    const double allowed = high;
    for (unsigned int i = 0; i < 60; ++i)
      {
        const double middle                         = (low + high) / 2;
        (sum_below(middle) <= allowed ? low : high) = middle;
      }
    for (const auto &[id, parent] : parents)
      if (parent.second.size() == GeometryInfo<dim>::max_children_per_cell && parent.first <= low)
        for (const auto &child : parent.second)
          child->set_coarsen_flag();
  }

  template std::set<CellId>
  deformable_cells(const Discretization<2> &);
  template std::set<CellId>
  deformable_cells(const Discretization<3> &);
  template void
  mark_cells_to_coarsen(const Discretization<2> &,
                        Geometry<2> &,
                        const std::set<CellId> &,
                        const Vector<float> &,
                        const double);
  template void
  mark_cells_to_coarsen(const Discretization<3> &,
                        Geometry<3> &,
                        const std::set<CellId> &,
                        const Vector<float> &,
                        const double);
} // namespace Amontons
