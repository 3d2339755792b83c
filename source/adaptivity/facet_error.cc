#include <amontons/adaptivity/facet_error.h>

#include <deal.II/numerics/rtree.h>

namespace Amontons
{
  namespace
  {
    // The facet at a point of the surface, if there is one.
    template <int dim>
    class NearestFacet
    {
    public:
      explicit NearestFacet(const std::vector<Facet<dim>> &facets) : facets(facets)
      {
        std::vector<std::pair<Point<dim>, unsigned int>> centres;
        centres.reserve(facets.size());
        for (const auto &facet : facets)
          centres.emplace_back(facet.centre, centres.size());
        tree = pack_rtree(centres);
      }

      bool
      empty() const
      {
        return facets.empty();
      }

      const Facet<dim> *
      at(const Point<dim> &X) const
      {
        if (facets.empty())
          return nullptr;
        const auto &facet = facets[tree.qbegin(boost::geometry::index::nearest(X, 1))->second];
        return X.distance(facet.centre) <= 1.05 * facet.radius ? &facet : nullptr;
      }

    private:
      const std::vector<Facet<dim>> facets;
      boost::geometry::index::rtree<std::pair<Point<dim>, unsigned int>, boost::geometry::index::linear<16>>
          tree;
    };

    // At rest, of what the rows of the interface see of the other body; 0 where that has no surface.
    template <int dim>
    std::vector<Point<dim>>
    opposite_places(const ContactInterface<dim> &interface)
    {
      std::map<types::global_dof_index, Point<dim>> X;
      if (interface.master_surface)
        for (const auto &node : interface.master_surface->nodes)
          X[node.dofs[0]] = node.X;
      std::vector<Point<dim>> places;
      for (const auto &row : interface.coupling.rows)
        {
          places.emplace_back();
          for (const auto &[dofs, weight] : row.master)
            if (interface.master_surface)
              places.back() += weight * X.at(dofs[0]);
        }
      return places;
    }

    template <int dim>
    double
    step_of(const Facet<dim> &facet)
    {
      double largest = 0;
      for (const double step : facet.steps)
        largest = std::max(largest, std::abs(step));
      return largest;
    }

    // How far it lies off the curve. Quadratic arcs cross it in their middle: w^4 / (32 R^3) with half the
    // length w and kinks of (w / R)^3 / 2. At steps D of the curvature: D s (s^2 - w^2)/(12 w).
    template <int dim>
    double
    gap_of(const Facet<dim> &facet)
    {
      return std::max(facet.size * std::abs(facet.angle) / (facet.is_curved ? 32 : 8),
                      0.008 * facet.size * facet.size * step_of(facet));
    }

    // Of the curvature's error d = D s/h, in the place of kinks. A contact no wider than a face sees
    // another radius: of p = E*/(2 R) sqrt(a^2 - x^2) at the same force, (E* a d)^2/12 in the mean square
    // (the ends move by 1 %). In wider ones such errors cancel each other: as in (32), of the slopes
    // D (s^2/(2 h) - h/24).
    template <int dim>
    double
    steps_squared(const Facet<dim> &facet, const Point<dim> &X, const double half_width)
    {
      const double D = step_of(facet), s = X.distance(facet.centre);
      return 2 * half_width > facet.size ? std::pow(D * facet.size, 2) / 60
                                         : std::pow(2 * half_width * D * s / facet.size, 2);
    }

    // Mean square for (32) at a node. Off a circle, quadratic arcs have the fourth derivative of a curve of
    // fourth degree beside their kinks, which takes 1 - 12/(pi n)^2 of the n-th wave: 0.314 of the sum. A
    // contact that is shorter than a facet sees one kink, if any: a wedge, E* theta arcosh(a/x) / (2 pi),
    // less what its force takes from the rest. That has the mean square (E* theta)^2 / 59 at the same
    // half-width; this gets shorter, too, and at its ends pressures change most: 1/16 (seen: 1/20 where it
    // loses 5 %).
    template <int dim>
    double
    kinks_squared(const Facet<dim> *facet, const Point<dim> &X, const double half_width)
    {
      if (facet == nullptr)
        return 0;
      double wedge = 0;
      for (unsigned int k = 0; 2 * half_width < facet->size && k < facet->ridges.size(); ++k)
        {
          const Tensor<1, dim> across = facet->ridges[k] - facet->ridges[k ^ 1];
          if (std::abs((X - facet->ridges[k]) * across) <= half_width * across.norm())
            wedge += 3 * facet->kinks[k] * facet->kinks[k];
        }
      return std::max(wedge, (facet->is_curved ? 0.314 : 1) * facet->mean_square) +
             steps_squared(*facet, X, half_width);
    }

    // Of both sides, s and m. Polygons that fit into each other leave no gap, but where their kinks lie a
    // distance d apart, which for the n-th wave are 1 - exp(2 pi i n d/h):
    // sum (2 - 2 cos n x)/n^2 = pi x - x^2/2 with x = 2 pi d/h, against sum 1/n^2 = pi^2/6.
    template <int dim>
    double
    kinks_squared(const Facet<dim> *slave, const Facet<dim> *master, const double s, const double m)
    {
      const double apart =
          slave == nullptr || master == nullptr ? 1 : slave->centre.distance(master->centre) / slave->size;
      if (apart >= 0.1 || slave->angle * master->angle >= 0)
        return s + m;
      const double x = 2 * numbers::PI * apart;
      return std::pow(std::sqrt(s) - std::sqrt(m), 2) +
             std::min(s, m) * 6 / (numbers::PI * numbers::PI) * (numbers::PI * x - x * x / 2);
    }
  } // namespace

  template <int dim>
  FacetError
  facet_error(const ContactInterface<dim> &interface, const SurfaceFields<dim> &fields, const double modulus)
  {
    FacetError              error;
    const NearestFacet<dim> of_slave(interface.slave->facets);
    const NearestFacet<dim> of_master(interface.master_surface ? interface.master_surface->facets
                                                               : std::vector<Facet<dim>>());
    if ((of_slave.empty() && of_master.empty()) || interface.pair->tied)
      return error;
    const auto opposites = opposite_places(interface);
    const auto open      = [&](const Facet<dim> *facet) { // not closed by `Adjust`
      return facet != nullptr && gap_of(*facet) > interface.pair->adjust ? facet : nullptr;
    };
    double square = 0, pressure = 0, area = 0;
    for (const auto &row : interface.coupling.rows)
      {
        const double p = fields.multiplier[row.node];
        if (!(p > 0))
          continue;
        pressure += row.area * p * p;
        area += row.area;
        const Point<dim>              &opposite = opposites[&row - interface.coupling.rows.data()];
        const Facet<dim> *const        slave    = open(of_slave.at(interface.slave->nodes[row.node].X)),
                                *const master   = open(of_master.at(opposite));
        square += row.area *
                  kinks_squared(slave,
                                master,
                                kinks_squared(slave, interface.slave->nodes[row.node].X, fields.contact_size),
                                kinks_squared(master, opposite, fields.contact_size));
        for (const auto *facet : {slave, master})
          if (facet != nullptr && gap_of(*facet) > error.gap)
            {
              error.angle     = std::abs(facet->angle);
              error.step      = step_of(*facet);
              error.is_curved = facet->is_curved;
              error.size      = facet->size;
              error.gap       = gap_of(*facet);
            }
      }
    error.pressure = modulus * modulus / 48 * square;
    // a^2 / (2 R) of a Hertz contact: p0 = E* a / (2 R), and the mean square of p is 2/3 p0^2
    if (area > 0)
      error.closed_gap = std::sqrt(1.5 * pressure / area) * fields.contact_size / modulus;
    return error;
  }

  template FacetError
  facet_error(const ContactInterface<2> &, const SurfaceFields<2> &, const double);
  template FacetError
  facet_error(const ContactInterface<3> &, const SurfaceFields<3> &, const double);
} // namespace Amontons
