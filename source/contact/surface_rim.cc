#include <amontons/contact/surface_rim.h>

#include <map>
#include <set>

namespace Amontons
{
  namespace
  {
    // Faces by the points that they have there, to within a millionth of a face.
    template <int dim>
    class FacesAtPoints
    {
    public:
      explicit FacesAtPoints(const double size) : size(1e-6 * size) {}

      void
      add(const Point<dim> &x, const unsigned int face)
      {
        for_each_cell(x, [&](const Cell &cell) { faces[cell].insert(face); });
      }

      bool
      any_but(const Point<dim> &x, const unsigned int face) const
      {
        bool any = false;
        for_each_cell(x, [&](const Cell &cell) {
          if (const auto found = faces.find(cell); found != faces.end())
            any = any || found->second.size() > 1 || *found->second.begin() != face;
        });
        return any;
      }

    private:
      using Cell = std::array<long long, dim>;

      // The same point, with other rounding, may be in the next one.
      template <typename Action>
      void
      for_each_cell(const Point<dim> &x, const Action &action) const
      {
        for (unsigned int corner = 0; corner < (1u << dim); ++corner)
          {
            Cell cell;
            for (unsigned int d = 0; d < dim; ++d)
              cell[d] = std::llround(std::floor(x[d] / size)) + ((corner >> d) & 1);
            action(cell);
          }
      }

      const double                           size;
      std::map<Cell, std::set<unsigned int>> faces;
    };

    // The point s of side k of the unit interval (its end, whatever s) or square.
    template <int dim>
    Point<dim - 1>
    on_side(const unsigned int k, const double s)
    {
      Point<dim - 1> xi;
      xi[k / 2] = k % 2;
      if constexpr (dim == 3)
        xi[1 - k / 2] = s;
      return xi;
    }
  } // namespace

  template <int dim>
  std::vector<bool>
  rim_nodes(const ContactSurface<dim> &surface)
  {
    constexpr unsigned int n_sides = 2 * (dim - 1);
    FacesAtPoints<dim>     faces(surface.mean_size);
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      for (unsigned int k = 0; k < n_sides; ++k)
        for (const double s : {0., 0.25, 0.5, 0.75, 1.})
          faces.add(surface.position(f, on_side<dim>(k, s)), f);
    std::vector<bool> result(surface.nodes.size(), false);
    for (unsigned int f = 0; f < surface.faces.size(); ++f)
      for (unsigned int k = 0; k < n_sides; ++k)
        if (!faces.any_but(surface.position(f, on_side<dim>(k, 0.5)), f))
          for (const unsigned int node : surface.faces[f].unknowns)
            for (const double s : {0., 0.5, 1.})
              if (surface.position(f, on_side<dim>(k, s)).distance(surface.nodes[node].x) <
                  1e-6 * surface.faces[f].size)
                result[node] = true;
    return result;
  }

  template std::vector<bool>
  rim_nodes(const ContactSurface<2> &);
  template std::vector<bool>
  rim_nodes(const ContactSurface<3> &);
} // namespace Amontons
