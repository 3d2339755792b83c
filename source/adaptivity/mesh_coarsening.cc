#include <amontons/adaptivity/mesh_coarsening.h>
#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/adaptivity/squared_errors.h>
#include <amontons/base/gather.h>

#include <deal.II/grid/grid_tools.h>

namespace Amontons
{
  template <int dim>
  std::set<CellId>
  deformable_cells(const Discretization<dim> &discretization)
  {
    std::set<CellId> mine;
    for (const auto &cell : discretization.dof_handler.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
        mine.insert(cell->id());
    return of_all_ranks(discretization.geometry.communicator, mine);
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
    struct Parent
    {
      double                                                         square = 0; // once coarsened
      std::vector<typename Triangulation<dim>::active_cell_iterator> children;
    };
    std::map<CellId, Parent> parents;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()) &&
          cell->level() > 0 && !cell->refine_flag_set() && first.count(cell->id()) == 0)
        {
          Parent &parent = parents[cell->parent()->id()];
          parent.square += per_level * std::pow(double(indicators[cell->active_cell_index()]), 2);
          parent.children.push_back(cell);
        }
    std::vector<double> squares;
    for (auto parent = parents.begin(); parent != parents.end();)
      if (parent->second.children.size() == GeometryInfo<dim>::max_children_per_cell)
        squares.push_back((parent++)->second.square);
      else
        parent = parents.erase(parent);
    const SquaredErrors errors(std::move(squares), geometry.communicator);
    const double        threshold = errors.largest_threshold(
        [&](const double t) { return errors.sum_below(t) <= part * target * target; });
    for (const auto &[id, parent] : parents)
      if (parent.square < threshold)
        for (const auto &child : parent.children)
          child->set_coarsen_flag();
  }

  namespace
  {
    // Whether a cell is to be refined goes to the ranks where it is a ghost; which are to be coarsened, as
    // parents, to all: the neighbours of ghosts count, too, of which there are artificial cells there.
    template <int dim>
    void
    exchange_flags(parallel::distributed::Triangulation<dim> &triangulation)
    {
      using Cell = typename Triangulation<dim>::active_cell_iterator;
      std::set<CellId> coarse;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_locally_owned())
          {
            cell->clear_refine_flag();
            cell->clear_coarsen_flag();
          }
        else if (cell->coarsen_flag_set())
          coarse.insert(cell->parent()->id());
      coarse = of_all_ranks(triangulation.get_communicator(), coarse);
      GridTools::exchange_cell_data_to_ghosts<bool, Triangulation<dim>>(
          triangulation,
          [](const Cell &cell) { return std_cxx17::optional<bool>(bool(cell->refine_flag_set())); },
          [](const Cell &cell, const bool is_refined) {
            if (is_refined)
              cell->set_refine_flag();
          });
      for (const auto &cell : triangulation.active_cell_iterators())
        if (!cell->is_locally_owned() && cell->level() > 0 && !cell->refine_flag_set() &&
            coarse.count(cell->parent()->id()) > 0)
          cell->set_coarsen_flag();
    }
  } // namespace

  template <int dim>
  void
  prepare_refinement(parallel::distributed::Triangulation<dim> &triangulation)
  {
    const auto flags = [&]() {
      std::vector<int> all;
      for (const auto &cell : triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          all.push_back(cell->refine_flag_set() - cell->coarsen_flag_set());
      return all;
    };
    std::vector<int> before;
    do // each turn takes coarsening back or refines more
      {
        before = flags();
        exchange_flags(triangulation);
        triangulation.prepare_coarsening_and_refinement();
      }
    while (Utilities::MPI::logical_or(flags() != before, triangulation.get_communicator()));
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
  template void
  prepare_refinement(parallel::distributed::Triangulation<2> &);
  template void
  prepare_refinement(parallel::distributed::Triangulation<3> &);
} // namespace Amontons
