#include <amontons/contact/surface_rim.h>

#include <algorithm>
#include <array>

namespace Amontons
{
  namespace
  {
    // Faces by the points that they have there, to within a millionth of a face. They are sorted along a
    // direction across which few of a mesh lie.
    template <int dim>
    class FacesAtPoints
    {
    public:
      explicit FacesAtPoints(const double size) : distance(1e-6 * size)
      {
        constexpr std::array<double, 3> across = {{0.5772, 0.2113, 0.7887}};
        for (unsigned int d = 0; d < dim; ++d)
          direction[d] = across[d];
      }

      void
      add(const Point<dim> &x, const unsigned int face)
      {
        entries.push_back({direction * x, x, face});
      }

      void
      sort()
      {
        std::sort(
            entries.begin(), entries.end(), [](const Entry &a, const Entry &b) { return a.key < b.key; });
      }

      bool
      any_but(const Point<dim> &x, const unsigned int face) const
      {
        const double key   = direction * x;
        const auto   first = std::lower_bound(entries.begin(),
                                            entries.end(),
                                            key - distance,
                                            [](const Entry &a, const double least) { return a.key < least; });
        for (auto entry = first; entry != entries.end() && entry->key <= key + distance; ++entry)
          if (entry->face != face && entry->x.distance_square(x) <= distance * distance)
            return true;
        return false;
      }

    private:
      struct Entry
      {
        double       key;
        Point<dim>   x;
        unsigned int face;
      };

      const double       distance;
      Tensor<1, dim>     direction;
      std::vector<Entry> entries;
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
    faces.sort();
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
