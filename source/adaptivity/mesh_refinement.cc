#include <amontons/adaptivity/mesh_coarsening.h>
#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/adaptivity/smallest_cells.h>
#include <amontons/adaptivity/squared_errors.h>
#include <amontons/base/gather.h>
#include <amontons/solver/load_program.h>

#include <deal.II/distributed/solution_transfer.h>

namespace Amontons
{
  void
  RefinementParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Refinement");
    prm.add_parameter("Cycles",
                      cycles,
                      "How often the mesh is refined after the first solution, from which the computation is "
                      "then repeated. -1: as often as 'Target error' takes.",
                      Patterns::Integer(-1));
    prm.add_parameter(
        "Maximum DoFs",
        max_dofs,
        "Refinement stops before the mesh gets more than about this many degrees of freedom, or "
        "once it could only grow by less than a tenth.",
        Patterns::Integer(1));
    prm.add_parameter("Target error",
                      target_error,
                      "Refinement stops once the estimated relative error of 'Target quantity' is below "
                      "this. 0: only Cycles and Maximum DoFs count. -1: 0 where Cycles are given, else "
                      "0.01, as far as 100000 DoFs take it (10000 with friction or finite strain).",
                      Patterns::Double(-1));
    prm.add_parameter(
        "Target quantity",
        target_quantity,
        "What 'Target error' is the relative error of: the contact pressure in the mean square (with "
        "friction the "
        "worse of pressure and tangential traction), or a number, whose error is estimated by its changes "
        "from "
        "mesh to mesh.",
        Patterns::Selection("contact pressure|peak pressure|contact size|stick size|total "
                            "force|approach|energy|dissipation"));
    prm.add_parameter(
        "Fraction",
        fraction,
        "Adaptive refinement takes the cells with the largest estimated errors that together make up "
        "this part of the squared error; 'Target error' of the contact pressure says itself which.",
        Patterns::Double(0, 1));
    prm.add_parameter(
        "Strategy",
        strategy,
        "adaptive: refine where the estimated error is large; uniform: refine all deformable bodies.",
        Patterns::Selection("adaptive|uniform"));
    prm.add_parameter(
        "Initial refinements",
        initial_refinements,
        "Before the first solution, refine at most this often where the surfaces of a contact pair are "
        "closest, so that the first solution sees the contact.",
        Patterns::Integer(0));
    prm.add_parameter(
        "History",
        history,
        "Scenes with friction: replay (the whole load program starts anew on each refined mesh) or "
        "transfer (meshes are refined as the load goes on, from interpolated displacements).",
        Patterns::Selection("replay|transfer"));
    prm.leave_subsection();
  }

  void
  RefinementParameters::check() const
  {
    if ((target_error < 0 && target_error != -1) || target_error >= 1)
      throw std::invalid_argument(
          "Target error: found " + Utilities::to_string(target_error) +
          "; allowed are -1 (chosen), 0 (none) and numbers between 0 and 1 (0.05 is 5 %)");
  }

  void
  RefinementParameters::choose_target(const bool has_history)
  {
    if (target_error >= 0)
      return;
    target_error    = cycles >= 0 ? 0 : 0.01;
    target_is_given = false;
    if (cycles < 0)
      max_dofs = std::min(max_dofs, has_history ? 10000u : 100000u);
  }

  double
  RefinementParameters::most_increments() const
  {
    return target_is_given ? 5 * LoadProgram::increments_by_default : LoadProgram::increments_by_default;
  }

  namespace
  {
    // Of the cells that may be refined.
    template <int dim>
    SquaredErrors
    squared_errors(const Discretization<dim> &discretization, const Vector<float> &indicators)
    {
      std::vector<double> squares;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (may_be_refined(discretization, cell))
          squares.push_back(std::pow(double(indicators[cell->active_cell_index()]), 2));
      return {std::move(squares), discretization.geometry.communicator};
    }

    // How many cells can be refined within max_dofs; none if the mesh would not be much finer.
    template <int dim>
    double
    affordable_cells(const Discretization<dim> &discretization, const unsigned int max_dofs)
    {
      constexpr double worth_a_solution = 0.1;
      const double     n_dofs           = discretization.dof_handler.n_dofs();
      const double     n_cells          = discretization.geometry.triangulation.n_global_active_cells();
      const double     growth           = max_dofs / n_dofs - 1;
      return growth < worth_a_solution ? 0
                                       : growth * n_cells / (GeometryInfo<dim>::max_children_per_cell - 1);
    }

    // Doerfler marking: the largest squared error from which on the cells make up the fraction, or the
    // smallest that can be afforded; `step` cells where these are few of them. Cells that differ by rounding
    // only (symmetric meshes) are marked together.
    double
    adaptive_threshold(const SquaredErrors &errors,
                       const double         fraction,
                       const double         affordable,
                       const double         step = 0)
    {
      constexpr double alike = 1 - 1e-4, few = 0.15;
      const double     wanted = fraction * errors.sum_above(0);
      const double     doerfler =
          alike * errors.largest_threshold([&](const double t) { return errors.sum_above(t) >= wanted; });
      if (const double n = errors.count_above(doerfler); n < few * step && step <= affordable)
        return alike *
               errors.largest_threshold([&](const double t) { return errors.count_above(t) >= step; });
      else if (n <= affordable)
        return doerfler;
      return errors.largest_threshold([&](const double t) { return errors.count_above(t) > affordable; }) /
             alike;
    }

    // How often a cell is refined.
    struct Levels
    {
      double       threshold = 0; // cells below stay
      double       share     = 0; // what a squared error is to fall to
      unsigned int most      = 3;

      unsigned int
      operator()(const double square) const
      {
        unsigned int levels = square >= threshold ? 1 : 0;
        for (double left = square / per_level; levels > 0 && levels < most && left > share; left /= per_level)
          ++levels;
        return levels;
      }
    };

    // Marks cells by their squared errors; deeper: as in mark_cells_for_target, of this rank.
    template <int dim>
    bool
    mark(const Discretization<dim> &discretization,
         Geometry<dim>             &geometry,
         const Vector<float>       &indicators,
         const Levels              &levels,
         DeeperCells               &deeper)
    {
      unsigned int n_marked = 0;
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (may_be_refined(discretization, cell))
          if (const unsigned int n = levels(std::pow(double(indicators[cell->active_cell_index()]), 2));
              n > 0)
            {
              cell->set_refine_flag();
              ++n_marked;
              if (n > 1)
                deeper[cell->id()] = n - 1;
            }
      return Utilities::MPI::sum(n_marked, geometry.communicator) > 0;
    }
  } // namespace

  template <int dim>
  bool
  mark_cells(const Discretization<dim>  &discretization,
             Geometry<dim>              &geometry,
             const RefinementParameters &parameters,
             const Vector<float>        &indicators,
             const double                step)
  {
    const double        affordable = affordable_cells(discretization, parameters.max_dofs);
    const SquaredErrors errors     = squared_errors(discretization, indicators);
    Levels              once;
    once.most = 1;
    if (parameters.strategy == "uniform")
      {
        if (errors.count_above(0) > affordable)
          return false;
      }
    else if (errors.largest > 0)
      once.threshold = adaptive_threshold(errors,
                                          parameters.fraction,
                                          affordable,
                                          step * geometry.triangulation.n_global_active_cells() /
                                              (GeometryInfo<dim>::max_children_per_cell - 1));
    else
      return false;
    DeeperCells none;
    return mark(discretization, geometry, indicators, once, none);
  }

  namespace
  {
    // As many as can be afforded, several at once while the mesh grows by `most_growth` at most: with that
    // the meshes on the way cost a fifteenth of the last one, so that larger steps, which go by what a
    // coarser mesh knows, save nothing. left: of the sum of the squares.
    Levels
    levels_for(const SquaredErrors &errors,
               const double         left,
               const double         affordable,
               const double         n_cells,
               const double         n_children)
    {
      constexpr double most_growth = 16; // in the plane all cells twice
      Levels           levels;
      levels.threshold     = adaptive_threshold(errors, 1 - left, affordable);
      levels.share         = left * errors.sum_above(0) / std::max(1., errors.count_above(levels.threshold));
      const double allowed = std::min(affordable * (n_children - 1), (most_growth - 1) * n_cells);
      const auto   new_cells = [&](const double square) { return std::pow(n_children, levels(square)) - 1; };
      while (levels.most > 1 && errors.sum(new_cells) > allowed)
        --levels.most;
      return levels;
    }

    // Of the squared error, by the cells that stay. At once: half of what may be left, and of coarse meshes,
    // which do not know more, a quarter; a load program that is repeated for little should not be once more.
    // Else the part l of them and the rest, refined once, leave l + (1 - l)/16. In space coarse meshes tell
    // shears several times too wrong, and what they ask for at once is far more than it takes.
    double
    part_that_stays(const double reduction, const unsigned int dim, const bool has_history)
    {
      constexpr double most_with_history = 0.7, largest_step = 0.4, safety = 0.93, least = 0.05;
      if (dim == 2 || (has_history && reduction > largest_step))
        return 0.5 * std::pow(std::clamp(reduction, 0.25, has_history ? most_with_history : 1.), 2);
      const double whole   = std::clamp(reduction, 1e-6, 1.),
                   n_steps = std::max(1., std::ceil(std::log(whole) / std::log(largest_step)));
      return std::max(least,
                      (per_level * std::pow(safety * std::pow(whole, 1 / n_steps), 2) - 1) / (per_level - 1));
    }
  } // namespace

  template <int dim>
  bool
  mark_cells_for_target(const Discretization<dim> &discretization,
                        Geometry<dim>             &geometry,
                        const unsigned int         max_dofs,
                        const Vector<float>       &indicators,
                        const double               reduction,
                        const bool                 has_history,
                        DeeperCells               &deeper)
  {
    const SquaredErrors errors = squared_errors(discretization, indicators);
    if (errors.largest == 0)
      return false;
    const Levels levels = levels_for(errors,
                                     part_that_stays(reduction, dim, has_history),
                                     affordable_cells(discretization, max_dofs),
                                     geometry.triangulation.n_global_active_cells(),
                                     GeometryInfo<dim>::max_children_per_cell);

    deeper.clear();
    const bool any = mark(discretization, geometry, indicators, levels, deeper);
    deeper         = of_all_ranks(geometry.communicator, deeper);
    return any;
  }

  template <int dim>
  void
  mark_children(const Discretization<dim> &discretization, Geometry<dim> &geometry, DeeperCells &deeper)
  {
    DeeperCells children;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      if (cell->level() > 0 && may_be_refined(discretization, cell))
        if (const auto parent = deeper.find(cell->parent()->id()); parent != deeper.end())
          {
            cell->set_refine_flag();
            if (parent->second > 1)
              children[cell->id()] = parent->second - 1;
          }
    deeper = of_all_ranks(geometry.communicator, children);
  }

  template <int dim>
  void
  refine_and_transfer(Discretization<dim>             &discretization,
                      Geometry<dim>                   &geometry,
                      const std::vector<LA::Vector *> &all_fields,
                      const std::function<void()>     &rebuild)
  {
    std::vector<LA::Vector *> fields;
    for (LA::Vector *field : all_fields)
      if (field->size() == discretization.dof_handler.n_dofs())
        fields.push_back(field);

    parallel::distributed::SolutionTransfer<dim, LA::Vector> transfer(discretization.dof_handler);
    prepare_refinement(geometry.triangulation);
    transfer.prepare_for_coarsening_and_refinement(
        std::vector<const LA::Vector *>(fields.begin(), fields.end()));
    geometry.triangulation.execute_coarsening_and_refinement();
    rebuild();

    std::vector<LA::Vector>   moved(fields.size());
    std::vector<LA::Vector *> targets;
    for (auto &vector : moved)
      {
        vector.reinit(discretization.locally_owned, geometry.communicator);
        targets.push_back(&vector);
      }
    transfer.interpolate(targets);
    for (unsigned int i = 0; i < fields.size(); ++i)
      {
        *fields[i] = discretization.make_relevant_vector();
        *fields[i] = moved[i];
      }
  }

  template bool
  mark_cells(const Discretization<2> &,
             Geometry<2> &,
             const RefinementParameters &,
             const Vector<float> &,
             const double);
  template bool
  mark_cells(const Discretization<3> &,
             Geometry<3> &,
             const RefinementParameters &,
             const Vector<float> &,
             const double);
  template bool
  mark_cells_for_target(const Discretization<2> &,
                        Geometry<2> &,
                        const unsigned int,
                        const Vector<float> &,
                        const double,
                        const bool,
                        DeeperCells &);
  template bool
  mark_cells_for_target(const Discretization<3> &,
                        Geometry<3> &,
                        const unsigned int,
                        const Vector<float> &,
                        const double,
                        const bool,
                        DeeperCells &);
  template void
  mark_children(const Discretization<2> &, Geometry<2> &, DeeperCells &);
  template void
  mark_children(const Discretization<3> &, Geometry<3> &, DeeperCells &);
  template void
  refine_and_transfer(Discretization<2> &,
                      Geometry<2> &,
                      const std::vector<LA::Vector *> &,
                      const std::function<void()> &);
  template void
  refine_and_transfer(Discretization<3> &,
                      Geometry<3> &,
                      const std::vector<LA::Vector *> &,
                      const std::function<void()> &);
} // namespace Amontons
