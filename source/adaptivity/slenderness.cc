#include <amontons/adaptivity/slenderness.h>

#include <set>

namespace Amontons
{
  namespace
  {
    // By body: its volume and surface, and the integral of the squared stress. Collective.
    struct Sums
    {
      double volume = 0, surface = 0, square = 0;

      double
      thickness() const
      {
        return 2 * volume / surface;
      }
    };

    template <int dim>
    std::vector<Sums>
    sums_by_body(const Discretization<dim> &discretization, const StressRecovery<dim> &recovery)
    {
      const unsigned int  n = discretization.scene.bodies.size();
      std::vector<double> sums(3 * n, 0.);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            double *const sum    = &sums[3 * cell->material_id()];
            const double  volume = cell->measure();
            const auto   &points = recovery.unsmoothed(cell->active_cell_index());
            double        square = 0;
            for (const auto &stress : points)
              for (unsigned int k = 0; k < n_voigt<dim>; ++k)
                square += (k < 3 ? 1 : 2) * stress[k] * stress[k];
            sum[0] += volume;
            sum[2] += volume * square / points.size();
            for (const auto &face : cell->face_iterators())
              if (face->at_boundary())
                sum[1] += face->measure();
          }
      Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
      std::vector<Sums> result(n);
      for (unsigned int b = 0; b < n; ++b)
        result[b] = {sums[3 * b], sums[3 * b + 1], sums[3 * b + 2]};
      return result;
    }

    // Vertices and centres of the coarse faces of a body that are held in all directions.
    template <int dim>
    std::vector<Point<dim>>
    supported_points(const Discretization<dim> &discretization, const unsigned int body)
    {
      const Scene                 &scene = discretization.scene;
      std::set<types::boundary_id> held;
      for (const auto &condition : scene.conditions)
        if (condition.type == ConditionData::Type::displacement &&
            (condition.field || std::all_of(condition.displacement.begin(),
                                            condition.displacement.begin() + dim,
                                            [](const auto &value) { return value.has_value(); })))
          for (const auto &name : condition.boundaries)
            held.insert(discretization.geometry.boundary(name, scene).id);
      std::vector<Point<dim>> result;
      for (const auto &cell : discretization.geometry.triangulation.cell_iterators_on_level(0))
        if (cell->material_id() == body)
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary() && held.count(face->boundary_id()) > 0)
              {
                result.push_back(face->center());
                for (unsigned int v = 0; v < face->n_vertices(); ++v)
                  result.push_back(face->vertex(v));
              }
      return result;
    }

    // Closed nodes with another one opposite, on the other side of the body. Of many closed nodes some.
    template <int dim>
    std::vector<Point<dim>>
    pinched_points(const std::vector<ContactInterface<dim>> &interfaces,
                   const std::vector<NodalContacts<dim>>    &contact,
                   const unsigned int                        body,
                   const double                              thickness)
    {
      struct Closed
      {
        Point<dim>     X;
        Tensor<1, dim> normal; // out of the body
      };
      std::vector<Closed> closed;
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        {
          const auto &slave    = *interfaces[i].slave;
          const auto &master   = interfaces[i].master_surface;
          const bool  is_slave = slave.body == body, is_master = master && master->body == body;
          for (unsigned int n = 0; (is_slave || is_master) && n < slave.nodes.size(); ++n)
            if (contact[i][n].state != ContactStatus::open)
              closed.push_back({slave.nodes[n].X, (is_slave ? 1. : -1.) * slave.nodes[n].normal});
        }
      constexpr unsigned int  enough = 500;
      std::vector<Point<dim>> result;
      for (unsigned int k = 0; k < closed.size(); k += 1 + closed.size() / enough)
        if (std::any_of(closed.begin(), closed.end(), [&](const Closed &other) {
              return closed[k].normal * other.normal < -0.5 && closed[k].X.distance(other.X) <= 2 * thickness;
            }))
          result.push_back(closed[k].X);
      return result;
    }

    // Of the coarse mesh.
    template <int dim>
    double
    farthest_from(const std::vector<Point<dim>> &held,
                  const Discretization<dim>     &discretization,
                  const unsigned int             body)
    {
      double     largest = 0;
      const auto look    = [&](const Point<dim> &x) {
        double nearest = std::numeric_limits<double>::max();
        for (const auto &y : held)
          nearest = std::min(nearest, x.distance_square(y));
        largest = std::max(largest, nearest);
      };
      for (const auto &cell : discretization.geometry.triangulation.cell_iterators_on_level(0))
        if (cell->material_id() == body)
          {
            look(cell->center());
            for (unsigned int v = 0; v < cell->n_vertices(); ++v)
              look(cell->vertex(v));
          }
      return std::sqrt(largest);
    }
  } // namespace

  template <int dim>
  double
  stress_stiffening(const Discretization<dim>                &discretization,
                    const StressRecovery<dim>                &recovery,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const std::vector<NodalContacts<dim>>    &contact,
                    const double                              at_least)
  {
    double     result = at_least;
    const auto sums   = sums_by_body(discretization, recovery);
    for (unsigned int b = 0; b < sums.size(); ++b)
      if (sums[b].volume > 0)
        {
          const double h = sums[b].thickness();
          const double strain =
              std::sqrt(sums[b].square / sums[b].volume) / discretization.scene.bodies[b].material.young;
          const auto of_length = [&](const double length) {
            return 48 / std::pow(numbers::PI, 2) * strain * std::max(0., std::pow(length / h, 2) - 25);
          };
          double value = of_length(discretization.geometry.body_sizes[b]);
          if (value > result)
            {
              auto       held    = supported_points(discretization, b);
              const auto pinched = pinched_points(interfaces, contact, b, h);
              held.insert(held.end(), pinched.begin(), pinched.end());
              if (!held.empty())
                value = of_length(farthest_from(held, discretization, b));
            }
          result = std::max(result, value);
        }
    return result;
  }

  template double
  stress_stiffening(const Discretization<2> &,
                    const StressRecovery<2> &,
                    const std::vector<ContactInterface<2>> &,
                    const std::vector<NodalContacts<2>> &,
                    const double);
  template double
  stress_stiffening(const Discretization<3> &,
                    const StressRecovery<3> &,
                    const std::vector<ContactInterface<3>> &,
                    const std::vector<NodalContacts<3>> &,
                    const double);
} // namespace Amontons
