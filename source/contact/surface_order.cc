#include <amontons/contact/surface_order.h>

#include <algorithm>
#include <numeric>

namespace Amontons
{
  namespace
  {
    template <int dim>
    bool
    lies_before(const Point<dim> &a, const Point<dim> &b)
    {
      return std::lexicographical_compare(a.begin_raw(), a.end_raw(), b.begin_raw(), b.end_raw());
    }

    // Faces of a curve, each visited once.
    class CurveWalk
    {
    public:
      CurveWalk(const std::size_t n_nodes, const std::vector<std::vector<unsigned int>> &faces)
          : faces(faces), faces_at(n_nodes), done(faces.size(), false), listed(n_nodes, false)
      {
        for (unsigned int f = 0; f < faces.size(); ++f)
          for (const unsigned int end : {faces[f].front(), faces[f].back()})
            faces_at[end].push_back(f);
      }

      bool
      is_free_end(const unsigned int node) const
      {
        return faces_at[node].size() == 1;
      }

      // Follows the curve from `node` to its end and appends the nodes not yet listed.
      void
      follow(unsigned int node, std::vector<unsigned int> &order)
      {
        for (;;)
          {
            const auto next = std::find_if(faces_at[node].begin(),
                                           faces_at[node].end(),
                                           [this](const unsigned int f) { return !done[f]; });
            if (next == faces_at[node].end())
              return;
            done[*next]                     = true;
            std::vector<unsigned int> nodes = faces[*next];
            if (nodes.front() != node)
              std::reverse(nodes.begin(), nodes.end());
            for (const unsigned int n : nodes)
              append(n, order);
            node = nodes.back();
          }
      }

      void
      append(const unsigned int node, std::vector<unsigned int> &order)
      {
        if (!listed[node])
          order.push_back(node);
        listed[node] = true;
      }

    private:
      const std::vector<std::vector<unsigned int>> &faces;
      std::vector<std::vector<unsigned int>>        faces_at;
      std::vector<bool>                             done, listed;
    };
  } // namespace

  template <int dim>
  std::vector<unsigned int>
  order_along_surface(const std::vector<Point<dim>>                &nodes,
                      const std::vector<std::vector<unsigned int>> &faces)
  {
    std::vector<unsigned int> sorted(nodes.size());
    std::iota(sorted.begin(), sorted.end(), 0u);
    std::sort(sorted.begin(), sorted.end(), [&](const unsigned int a, const unsigned int b) {
      return lies_before(nodes[a], nodes[b]);
    });
    if (dim == 3)
      return sorted;

    CurveWalk                 walk(nodes.size(), faces);
    std::vector<unsigned int> order;
    for (const bool from_free_ends : {true, false})
      for (const unsigned int node : sorted)
        if (!from_free_ends || walk.is_free_end(node))
          walk.follow(node, order);
    for (const unsigned int node : sorted)
      walk.append(node, order);
    return order;
  }

  template std::vector<unsigned int>
  order_along_surface(const std::vector<Point<2>> &, const std::vector<std::vector<unsigned int>> &);
  template std::vector<unsigned int>
  order_along_surface(const std::vector<Point<3>> &, const std::vector<std::vector<unsigned int>> &);
} // namespace Amontons
