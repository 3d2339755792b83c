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

    // How far it lies off the curve.
    template <int dim>
    double
    gap_of(const Facet<dim> &facet)
    {
      return facet.size * std::abs(facet.angle) / 8;
    }

    // Those of both sides; polygons that fit into each other leave no gap.
    template <int dim>
    double
    kinks_squared(const Facet<dim> *slave, const Facet<dim> *master)
    {
      const double s = slave == nullptr ? 0 : slave->mean_square,
                   m = master == nullptr ? 0 : master->mean_square;
      const bool fit = slave != nullptr && master != nullptr && slave->angle * master->angle < 0 &&
                       slave->centre.distance(master->centre) < 0.1 * slave->size;
      return fit ? std::pow(std::sqrt(s) - std::sqrt(m), 2) : s + m;
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
    std::map<types::global_dof_index, Point<dim>> X_master;
    if (interface.master_surface)
      for (const auto &node : interface.master_surface->nodes)
        X_master[node.dofs[0]] = node.X;
    const auto open = [&](const Facet<dim> *facet) { // not closed by `Adjust`
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
        Point<dim> opposite;
        for (const auto &[dofs, weight] : row.master)
          if (interface.master_surface)
            opposite += weight * X_master.at(dofs[0]);
        const Facet<dim> *const        slave  = open(of_slave.at(interface.slave->nodes[row.node].X)),
                                *const master = open(of_master.at(opposite));
        square += row.area * kinks_squared(slave, master);
        for (const auto *facet : {slave, master})
          if (facet != nullptr && std::abs(facet->angle) > error.angle)
            {
              error.angle = std::abs(facet->angle);
              error.size  = facet->size;
              error.gap   = gap_of(*facet);
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
