#include <amontons/output/json.h>
#include <amontons/output/probes.h>

#include <deal.II/base/mpi.h>

namespace Amontons
{
  namespace
  {
    // Where a point of a body lies: distance from the unit cell, in cell sizes.
    template <int dim>
    struct Location
    {
      Point<dim>                                     X;
      typename DoFHandler<dim>::active_cell_iterator cell;
      Point<dim>                                     unit_point;
      double                                         distance = 1e300;
    };

    constexpr double tolerance = 1e-8, largest_distance = 0.01;

    template <int dim>
    void
    try_cell(const Mapping<dim>                                   &mapping,
             const typename DoFHandler<dim>::active_cell_iterator &cell,
             Location<dim>                                        &location)
    {
      try
        {
          const Point<dim> unit      = mapping.transform_real_to_unit_cell(cell, location.X);
          const Point<dim> projected = GeometryInfo<dim>::project_to_unit_cell(unit);
          double           distance  = unit.distance(projected);
          if (distance < tolerance)
            distance = 0;
          if (distance < location.distance)
            {
              location.cell       = cell;
              location.unit_point = projected;
              location.distance   = distance;
            }
        }
      catch (const typename Mapping<dim>::ExcTransformationFailed &)
        {
        }
    }

    template <int dim>
    std::vector<Location<dim>>
    locate(const Discretization<dim> &discretization, const ProbeData &probe, const unsigned int body)
    {
      std::vector<Location<dim>> locations(probe.n_points);
      for (unsigned int i = 0; i < probe.n_points; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          {
            const double s    = probe.n_points > 1 ? double(i) / (probe.n_points - 1) : 0.;
            locations[i].X[d] = (1 - s) * probe.from[d] + s * probe.to[d];
          }
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          {
            BoundingBox<dim> box = cell->bounding_box(); // of the vertices
            box.extend(0.3 * cell->diameter());
            for (Location<dim> &location : locations)
              if (location.distance > 0 && box.point_inside(location.X))
                try_cell(discretization.mapping(), cell, location);
          }
      return locations;
    }

    // The rank whose value counts, by point; n_ranks where nobody found it.
    template <int dim>
    std::vector<unsigned int>
    choose_ranks(const std::vector<Location<dim>> &locations, const MPI_Comm communicator)
    {
      const unsigned int  rank = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int  none = Utilities::MPI::n_mpi_processes(communicator);
      std::vector<double> mine, best(locations.size());
      for (const auto &location : locations)
        mine.push_back(location.distance);
      Utilities::MPI::min(mine, communicator, best);

      std::vector<unsigned int> candidates, chosen(locations.size());
      for (std::size_t i = 0; i < mine.size(); ++i)
        candidates.push_back(mine[i] == best[i] && best[i] <= largest_distance ? rank : none);
      Utilities::MPI::min(candidates, communicator, chosen);
      return chosen;
    }

    // Displacement, then stress.
    template <int dim>
    std::vector<double>
    values_at(const Discretization<dim> &discretization,
              const StressRecovery<dim> &recovery,
              const LA::Vector          &displacement,
              const Location<dim>       &location)
    {
      const Quadrature<dim> point(location.unit_point);
      FEValues<dim>         values(discretization.mapping(), discretization.fe, point, update_values);
      values.reinit(location.cell);
      std::vector<Vector<double>> u(1, Vector<double>(dim));
      values.get_function_values(displacement, u);

      FEValues<dim> stress_values(
          discretization.mapping(), recovery.dof_handler().get_fe(), point, update_values);
      stress_values.reinit(recovery.cell_of(location.cell));
      const Voigt<dim> stress = recovery.values_at(stress_values)[0];

      std::vector<double> result(u[0].begin(), u[0].end());
      result.insert(result.end(), stress.begin(), stress.end());
      return result;
    }

    template <int dim>
    ProbePoint
    make_probe_point(const Point<dim> &X, const bool found, const double *values)
    {
      ProbePoint point;
      point.point.assign(X.begin_raw(), X.end_raw());
      if (!found)
        return point;
      point.displacement.assign(values, values + dim);
      point.stress.assign(values + dim, values + dim + n_voigt<dim>);
      Voigt<dim> stress;
      std::copy(point.stress.begin(), point.stress.end(), stress.begin());
      point.von_mises = von_mises<dim>(stress);
      return point;
    }

    std::string
    text(const std::vector<double> &point)
    {
      std::string result;
      for (const double x : point)
        result += (result.empty() ? "" : ", ") + number_text(x);
      return "(" + result + ")";
    }

    template <int dim>
    ProbeSummary
    evaluate_probe(const Discretization<dim> &discretization,
                   const StressRecovery<dim> &recovery,
                   const LA::Vector          &displacement,
                   const ProbeData           &probe,
                   std::vector<std::string>  &notes)
    {
      const std::vector<BodyData> &bodies = discretization.scene.bodies;
      unsigned int                 body   = 0;
      while (body < bodies.size() && bodies[body].name != probe.body)
        ++body;

      const MPI_Comm                   communicator = discretization.geometry.communicator;
      const unsigned int               rank         = Utilities::MPI::this_mpi_process(communicator);
      const unsigned int               n_ranks      = Utilities::MPI::n_mpi_processes(communicator);
      const std::vector<Location<dim>> locations    = locate(discretization, probe, body);
      const std::vector<unsigned int>  ranks        = choose_ranks(locations, communicator);

      constexpr unsigned int n = dim + n_voigt<dim>;
      std::vector<double>    mine(n * locations.size(), 0.), all(mine.size());
      for (std::size_t i = 0; i < locations.size(); ++i)
        if (ranks[i] == rank)
          {
            const std::vector<double> values =
                values_at(discretization, recovery, displacement, locations[i]);
            std::copy(values.begin(), values.end(), mine.begin() + n * i);
          }
      Utilities::MPI::sum(mine, communicator, all);

      ProbeSummary result{probe.name, {}};
      for (std::size_t i = 0; i < locations.size(); ++i)
        {
          result.points.push_back(make_probe_point(locations[i].X, ranks[i] < n_ranks, &all[n * i]));
          if (ranks[i] == n_ranks)
            notes.push_back("probe " + probe.name + ": point " + text(result.points[i].point) +
                            " lies outside body " + probe.body);
        }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<ProbeSummary>
  evaluate_probes(const Discretization<dim> &discretization,
                  const StressRecovery<dim> &recovery,
                  const LA::Vector          &displacement,
                  std::vector<std::string>  &notes)
  {
    std::vector<ProbeSummary> result;
    for (const ProbeData &probe : discretization.scene.probes)
      result.push_back(evaluate_probe(discretization, recovery, displacement, probe, notes));
    return result;
  }

  template std::vector<ProbeSummary>
  evaluate_probes(const Discretization<2> &,
                  const StressRecovery<2> &,
                  const LA::Vector &,
                  std::vector<std::string> &);
  template std::vector<ProbeSummary>
  evaluate_probes(const Discretization<3> &,
                  const StressRecovery<3> &,
                  const LA::Vector &,
                  std::vector<std::string> &);
} // namespace Amontons
