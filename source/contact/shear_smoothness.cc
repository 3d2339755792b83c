#include <amontons/contact/face_lattice.h>
#include <amontons/contact/shear_smoothness.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    bool
    is_own(const SurfaceFace<dim> &face, const unsigned int j)
    {
      return face.unknowns[j] == face.nodes[j];
    }

    template <int fdim>
    bool
    is_corner(const Point<fdim> &xi)
    {
      for (unsigned int d = 0; d < fdim; ++d)
        if (xi[d] != 0 && xi[d] != 1)
          return false;
      return true;
    }

    // Of quadratic faces the nodes between vertices, with those.
    template <int dim>
    std::map<unsigned int, std::vector<unsigned int>>
    nodes_between(const ContactSurface<dim> &slave, const std::vector<bool> &linear)
    {
      std::map<unsigned int, std::vector<unsigned int>> result;
      if (slave.degree < 2)
        return result;
      const auto place = lattice<dim - 1>(slave.degree);
      for (const auto &face : slave.faces)
        for (unsigned int k = 0; k < place.size(); ++k)
          {
            // Beside a coarser face the place of a hanging node has an unknown of that one, which may lie
            // elsewhere. So the vertices around a node are of its own face or of coarser ones, and never
            // means of the node itself.
            if (!linear[face.unknowns[k]] || !is_own(face, k))
              continue;
            // Vertices of the smallest part of the face (edge, face) that the node is in the middle of.
            std::vector<unsigned int> around;
            bool                      all_linear = true;
            for (unsigned int j = 0; j < place.size(); ++j)
              {
                bool is_vertex = true;
                for (unsigned int d = 0; d < dim - 1; ++d)
                  is_vertex =
                      is_vertex && place[j][d] != 0.5 && (place[k][d] == 0.5 || place[j][d] == place[k][d]);
                if (is_vertex)
                  {
                    around.push_back(face.unknowns[j]);
                    all_linear = all_linear && is_own(face, j) && linear[face.unknowns[j]];
                  }
              }
            if (around.size() > 1 && all_linear)
              result[face.unknowns[k]] = around;
          }
      return result;
    }

    // One side of a vertex or edge: the vertices opposite of it in a face, and the way from there.
    template <int dim>
    struct Side
    {
      std::vector<unsigned int> opposite;
      Tensor<1, dim>            way;
    };

    template <int dim>
    Tensor<1, dim>
    centre_of(const ContactSurface<dim> &slave, const std::vector<unsigned int> &nodes)
    {
      Tensor<1, dim> centre;
      for (const unsigned int j : nodes)
        centre += Tensor<1, dim>(slave.nodes[j].X) / double(nodes.size());
      return centre;
    }

    // By the vertices of each vertex (in the plane) or edge, the sides where the function is linear.
    template <int dim>
    std::map<std::vector<unsigned int>, std::vector<Side<dim>>>
    linear_sides(const ContactSurface<dim> &slave, const std::vector<bool> &linear)
    {
      const auto                                                  place = lattice<dim - 1>(slave.degree);
      std::map<std::vector<unsigned int>, std::vector<Side<dim>>> result;
      for (const auto &face : slave.faces)
        {
          bool is_linear = true;
          for (unsigned int k = 0; k < place.size(); ++k)
            is_linear = is_linear && is_own(face, k) && linear[face.nodes[k]];
          for (unsigned int d = 0; is_linear && d < dim - 1; ++d)
            {
              std::array<std::vector<unsigned int>, 2> ends;
              for (unsigned int k = 0; k < place.size(); ++k)
                if (is_corner(place[k]))
                  ends[place[k][d] == 1].push_back(face.nodes[k]);
              const Tensor<1, dim> way = centre_of(slave, ends[1]) - centre_of(slave, ends[0]);
              for (const unsigned int end : {0, 1})
                {
                  auto edge = ends[end];
                  std::sort(edge.begin(), edge.end());
                  result[edge].push_back({ends[1 - end], end == 1 ? way : -way});
                }
            }
        }
      return result;
    }

    // Nodes that stick and closed after the first increment, and those that stick on a face with such a one.
    template <int dim>
    std::vector<bool>
    touched_alone(const ContactInterface<dim> &interface,
                  const SurfaceFields<dim>    &fields,
                  const std::vector<bool>     &was_open)
    {
      const auto sticks = [&](const unsigned int i) {
        return fields.state[i] == ContactStatus::stick && fields.area[i] > 0 &&
               interface.coupling.slivers.count(i) == 0;
      };
      const auto        alone = [&](const unsigned int i) { return was_open[i] && sticks(i); };
      std::vector<bool> result(fields.state.size(), false);
      if (was_open.empty() || interface.pair->tied)
        return result;
      for (const auto &face : interface.slave->faces)
        if (std::any_of(face.nodes.begin(), face.nodes.end(), alone))
          for (const unsigned int i : face.nodes)
            result[i] = sticks(i);
      return result;
    }
  } // namespace

  // With w the widths of the faces on both sides of e, A and B their other ends, t the means there:
  //   (w_A + w_B)/2 ((t_A - t_e)/w_A + (t_B - t_e)/w_B),   0 for linear functions.
  template <int dim>
  Smoothness
  smooth_on(const ContactSurface<dim> &slave, const std::vector<bool> &linear)
  {
    constexpr double straight = 0.9; // cosine of the angle by which the surface may turn
    Smoothness       result;
    result.means = nodes_between(slave, linear);
    for (const auto &[edge, sides] : linear_sides(slave, linear))
      if (sides.size() == 2 &&
          -(sides[0].way * sides[1].way) > straight * sides[0].way.norm() * sides[1].way.norm())
        {
          const double mean_width = (sides[0].way.norm() + sides[1].way.norm()) / 2;
          auto        &jump       = result.jumps.emplace_back();
          jump.edge               = edge;
          for (const auto &side : sides)
            {
              const double coefficient = mean_width / side.way.norm() / edge.size();
              for (const unsigned int j : side.opposite)
                jump.terms.emplace_back(j, coefficient);
              for (const unsigned int j : edge)
                jump.terms.emplace_back(j, -coefficient);
            }
        }
    return result;
  }

  template <int dim>
  Smoothness
  shear_smoothness(const ContactInterface<dim> &interface,
                   const SurfaceFields<dim>    &fields,
                   const std::vector<bool>     &was_open)
  {
    return smooth_on(*interface.slave, touched_alone(interface, fields, was_open));
  }

  template Smoothness
  smooth_on(const ContactSurface<2> &, const std::vector<bool> &);
  template Smoothness
  smooth_on(const ContactSurface<3> &, const std::vector<bool> &);
  template Smoothness
  shear_smoothness(const ContactInterface<2> &, const SurfaceFields<2> &, const std::vector<bool> &);
  template Smoothness
  shear_smoothness(const ContactInterface<3> &, const SurfaceFields<3> &, const std::vector<bool> &);
} // namespace Amontons
