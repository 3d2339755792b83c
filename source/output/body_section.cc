// Cells cut by a plane: each as small cubes of six tetrahedra, linear in between.
#include <amontons/base/gather.h>
#include <amontons/output/body_surfaces.h>

#include <algorithm>
#include <iterator>

namespace Amontons
{
  namespace
  {
    // Where the plane meets the line from a (distance da) to b, on the other side.
    BodyPoint
    between(const BodyPoint &a, const double da, const BodyPoint &b, const double db)
    {
      const double s = da / (da - db);
      BodyPoint    p;
      for (unsigned int d = 0; d < 3; ++d)
        {
          p.X[d] = (1 - s) * a.X[d] + s * b.X[d];
          p.u[d] = (1 - s) * a.u[d] + s * b.u[d];
        }
      p.stress = (1 - s) * a.stress + s * b.stress;
      return p;
    }

    // Points on the lines between corners on the two sides; those of a quadrilateral in their order around
    // it: of the corners a, b before and c, d behind, ac, ad, bd, bc.
    template <std::size_t n>
    std::vector<BodyPoint>
    crossing(const std::array<BodyPoint, n> &corners, const CutPlane &plane)
    {
      std::vector<unsigned int> before, behind;
      std::array<double, n>     distance;
      for (unsigned int i = 0; i < n; ++i)
        {
          distance[i] = plane.distance(corners[i]);
          (distance[i] < 0 ? before : behind).push_back(i);
        }
      std::vector<BodyPoint> points;
      for (const unsigned int i : before)
        {
          for (const unsigned int j : behind)
            points.push_back(between(corners[i], distance[i], corners[j], distance[j]));
          std::reverse(behind.begin(), behind.end());
        }
      return points;
    }

    constexpr unsigned int n_parts = 2, n_line = n_parts + 1; // of an edge of a cell

    using Lattice = std::array<BodyPoint, n_line * n_line * n_line>;

    Quadrature<3>
    lattice_points()
    {
      std::vector<Point<3>> points;
      for (unsigned int k = 0; k < n_line; ++k)
        for (unsigned int j = 0; j < n_line; ++j)
          for (unsigned int i = 0; i < n_line; ++i)
            points.emplace_back(double(i) / n_parts, double(j) / n_parts, double(k) / n_parts);
      return Quadrature<3>(points);
    }

    const BodyPoint &
    at(const Lattice &lattice, const std::array<unsigned int, 3> &place)
    {
      return lattice[(place[2] * n_line + place[1]) * n_line + place[0]];
    }

    // Six tetrahedra around a diagonal: from the first corner along the axes in any order.
    void
    cut_cube(const Lattice                     &lattice,
             const std::array<unsigned int, 3> &first,
             const unsigned char                body,
             const CutPlane                    &plane,
             BodyCut                           &cut)
    {
      std::array<unsigned int, 3> axes = {{0, 1, 2}};
      do
        {
          std::array<unsigned int, 3> place   = first;
          std::array<BodyPoint, 4>    corners = {{at(lattice, place), {}, {}, {}}};
          for (unsigned int i = 0; i < 3; ++i)
            {
              ++place[axes[i]];
              corners[i + 1] = at(lattice, place);
            }
          cut_tetrahedron(corners, body, plane, cut);
        }
      while (std::next_permutation(axes.begin(), axes.end()));
    }

    // Of the faces of a cell: two triangles for each square of its lattice.
    void
    cut_faces(const Lattice &lattice, const CutPlane &plane, BodyCut &cut)
    {
      for (unsigned int across = 0; across < 3; ++across)
        for (const unsigned int side : {0u, n_parts})
          for (unsigned int j = 0; j < n_parts; ++j)
            for (unsigned int i = 0; i < n_parts; ++i)
              {
                const auto corner = [&](const unsigned int di, const unsigned int dj) {
                  std::array<unsigned int, 3> place;
                  place[across]           = side;
                  place[(across + 1) % 3] = i + di;
                  place[(across + 2) % 3] = j + dj;
                  return at(lattice, place);
                };
                cut_triangle({{corner(0, 0), corner(1, 0), corner(1, 1)}}, plane, cut);
                cut_triangle({{corner(0, 0), corner(0, 1), corner(1, 1)}}, plane, cut);
              }
    }

    void
    cut_cell(const Lattice &lattice, const unsigned char body, const CutPlane &plane, BodyCut &cut)
    {
      const auto before = [&](const BodyPoint &point) { return plane.distance(point) < 0; };
      const auto n      = std::count_if(lattice.begin(), lattice.end(), before);
      if (n == 0 || n == static_cast<long>(lattice.size()))
        return;
      for (unsigned int k = 0; k < n_parts; ++k)
        for (unsigned int j = 0; j < n_parts; ++j)
          for (unsigned int i = 0; i < n_parts; ++i)
            cut_cube(lattice, {{i, j, k}}, body, plane, cut);
      cut_faces(lattice, plane, cut);
    }

    // By the size of the cell and its largest displacement.
    bool
    may_be_cut(const DoFHandler<3>::active_cell_iterator &cell,
               const LA::Vector                          &displacement,
               const CutPlane                            &plane)
    {
      Vector<double> u(cell->get_fe().n_dofs_per_cell());
      if (plane.moved > 0)
        cell->get_dof_values(displacement, u);
      BodyPoint      middle;
      const Point<3> centre = cell->center();
      for (unsigned int d = 0; d < 3; ++d)
        middle.X[d] = centre[d];
      return std::abs(plane.distance(middle)) <= cell->diameter() + 2 * plane.moved * u.linfty_norm();
    }

    BodyCut
    own_cut(const Discretization<3> &discretization,
            const StressRecovery<3> &recovery,
            const LA::Vector        &displacement,
            const double             rounding,
            const CutPlane          &plane)
    {
      const Quadrature<3> points = lattice_points();
      FEValues<3>         values(
          discretization.mapping(), discretization.fe, points, update_values | update_quadrature_points);
      FEValues<3> stress_values(
          discretization.mapping(), recovery.dof_handler().get_fe(), points, update_values);
      std::vector<Vector<double>> u(points.size(), Vector<double>(3));
      BodyCut                     cut;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && !discretization.geometry.is_carrier(cell->material_id()) &&
            may_be_cut(cell, displacement, plane))
          {
            values.reinit(cell);
            values.get_function_values(displacement, u);
            stress_values.reinit(recovery.cell_of(cell));
            const auto stresses = recovery.values_at(stress_values);
            Lattice    lattice;
            for (unsigned int q = 0; q < points.size(); ++q)
              {
                for (unsigned int d = 0; d < 3; ++d)
                  {
                    lattice[q].X[d] = values.quadrature_point(q)[d];
                    lattice[q].u[d] = u[q][d];
                  }
                const double stress = von_mises<3>(stresses[q]);
                lattice[q].stress   = stress < rounding ? 0 : stress;
              }
            cut_cell(lattice, std::min<unsigned int>(cell->material_id(), 250), plane, cut);
          }
      return cut;
    }
  } // namespace

  void
  cut_tetrahedron(const std::array<BodyPoint, 4> &corners,
                  const unsigned char             body,
                  const CutPlane                 &plane,
                  BodyCut                        &cut)
  {
    const auto points = crossing(corners, plane);
    for (unsigned int i = 2; i < points.size(); ++i)
      cut.triangles.push_back({body, {{points[0], points[i - 1], points[i]}}});
  }

  void
  cut_triangle(const std::array<BodyPoint, 3> &corners, const CutPlane &plane, BodyCut &cut)
  {
    const auto points = crossing(corners, plane);
    if (points.size() == 2)
      cut.lines.push_back({{points[0], points[1]}});
  }

  BodyCut
  gather_body_cut(const Discretization<3> &discretization,
                  const StressRecovery<3> &recovery,
                  const LA::Vector        &displacement,
                  const double             rounding,
                  const CutPlane          &plane)
  {
    BodyCut              cut;
    std::vector<BodyCut> parts =
        gather_on_first(discretization.geometry.communicator,
                        own_cut(discretization, recovery, displacement, rounding, plane));
    for (BodyCut &part : parts)
      {
        std::move(part.triangles.begin(), part.triangles.end(), std::back_inserter(cut.triangles));
        std::move(part.lines.begin(), part.lines.end(), std::back_inserter(cut.lines));
      }
    return cut;
  }
} // namespace Amontons
