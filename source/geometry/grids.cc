#include <amontons/geometry/coarse_mesh.h>
#include <amontons/geometry/grids.h>

#include <deal.II/base/numbers.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // n cells between a and b, whose lengths are a geometric progression with last/first = ratio.
    std::vector<double>
    graded_points(const double a, const double b, const unsigned int n, const double ratio)
    {
      const double        q = n > 1 ? std::pow(ratio, 1. / (n - 1)) : 1.;
      std::vector<double> lengths(n);
      double              sum = 0;
      for (unsigned int i = 0; i < n; ++i)
        sum += lengths[i] = std::pow(q, i);

      std::vector<double> points(n + 1, a);
      for (unsigned int i = 0; i < n; ++i)
        points[i + 1] = points[i] + lengths[i] * (b - a) / sum;
      points[n] = b;
      return points;
    }

    void
    check_block(const BodyData &body, const unsigned int d)
    {
      const std::string direction(1, "xyz"[d]);
      if (!(body.lower[d] < body.upper[d]))
        throw InputError(body.where,
                         "the block's upper corner is not above its lower corner in " + direction,
                         "lower < upper in every direction");
      if (body.cells[d] == 0)
        throw InputError(body.where, "the block has no cells in " + direction, "at least 1 cell");
      if (!(body.grading[d] > 0))
        throw InputError(
            body.where, "the block's grading in " + direction + " is not positive", "a ratio > 0");
    }

    template <int dim>
    CoarseMesh<dim>
    make_block(const BodyData &body)
    {
      std::array<std::vector<double>, 3> points{{{}, {}, {0.}}};
      std::array<unsigned int, 3>        n{{0, 0, 1}};
      for (unsigned int d = 0; d < dim; ++d)
        {
          check_block(body, d);
          n[d]      = body.cells[d];
        }
      check_cell_count<dim>(body, double(n[0]) * n[1] * n[2]);
      for (unsigned int d = 0; d < dim; ++d)
        {
          points[d] = graded_points(body.lower[d], body.upper[d], n[d], body.grading[d]);
          for (unsigned int i = 0; i < n[d]; ++i)
            if (!(points[d][i + 1] - points[d][i] > 1e-12 * (body.upper[d] - body.lower[d])))
              throw InputError(body.where,
                               "the grading makes cells that are too thin in direction " + std::string(1, "xyz"[d]),
                               "a grading closer to 1, or fewer cells");
        }

      CoarseMesh<dim> mesh;
      for (const double z : points[2])
        for (const double y : points[1])
          for (const double x : points[0])
            {
              const std::array<double, 3> p{{x, y, z}};
              mesh.vertices.emplace_back();
              for (unsigned int d = 0; d < dim; ++d)
                mesh.vertices.back()[d] = p[d];
            }

      for (unsigned int k = 0; k < n[2]; ++k)
        for (unsigned int j = 0; j < n[1]; ++j)
          for (unsigned int i = 0; i < n[0]; ++i)
            {
              CellData<dim> cell;
              for (unsigned int v = 0; v < cell.vertices.size(); ++v)
                cell.vertices[v] = i + v % 2 + (n[0] + 1) * (j + v / 2 % 2 + (n[1] + 1) * (k + v / 4));
              mesh.cells.push_back(cell);
            }

      const std::vector<std::array<const char *, 2>> names =
          dim == 2 ? std::vector<std::array<const char *, 2>>{{{"left", "right"}}, {{"bottom", "top"}}}
                   : std::vector<std::array<const char *, 2>>{
                         {{"left", "right"}}, {{"front", "back"}}, {{"bottom", "top"}}};
      for (unsigned int d = 0; d < dim; ++d)
        {
          name_boundary<dim>(mesh, names[d][0], [&](const Point<dim> &p) { return p[d] == body.lower[d]; });
          name_boundary<dim>(mesh, names[d][1], [&](const Point<dim> &p) { return p[d] == body.upper[d]; });
        }
      return mesh;
    }

    // The part of the unit ball with coordinates of the given signs: a cube at the centre and one cell
    // towards each axis. A vertex is named by the bits of its positive coordinates, all equal: inside[k] or
    // 1/sqrt(k) for k bits.
    template <int dim>
    void
    add_orthant(const Tensor<1, dim> &signs, CoarseMesh<dim> &mesh)
    {
      static const std::array<double, 4> inside{{0., 0.5, 0.4, 0.34}};

      std::vector<unsigned int> inner(1 << dim), outer(1 << dim);
      const auto                vertex = [&](const unsigned int bits, const bool is_inner) {
        unsigned int n = 0;
        for (unsigned int d = 0; d < dim; ++d)
          n += (bits >> d) & 1;
        Point<dim> p;
        for (unsigned int d = 0; d < dim; ++d)
          if ((bits >> d) & 1)
            p[d] = signs[d] * (is_inner ? inside[n] : 1. / std::sqrt(double(n)));
        for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
          if (mesh.vertices[v] == p)
            return v;
        mesh.vertices.push_back(p);
        return static_cast<unsigned int>(mesh.vertices.size() - 1);
      };
      for (unsigned int bits = 0; bits < inner.size(); ++bits)
        {
          inner[bits] = vertex(bits, true);
          outer[bits] = bits == 0 ? inner[0] : vertex(bits, false);
        }

      CellData<dim> cell;
      cell.vertices = inner;
      mesh.cells.push_back(cell);
      for (unsigned int d = 0; d < dim; ++d)
        {
          for (unsigned int v = 0; v < inner.size(); ++v)
            cell.vertices[v] = (v >> d) & 1 ? outer[v] : inner[v | (1u << d)];
          mesh.cells.push_back(cell);
        }
    }

    template <int dim>
    CoarseMesh<dim>
    make_ball(const BodyData &body)
    {
      constexpr unsigned int last = dim - 1;

      CoarseMesh<dim> mesh;
      for (unsigned int bits = 0; bits < (1u << dim); ++bits)
        {
          Tensor<1, dim> signs;
          for (unsigned int d = 0; d < dim; ++d)
            signs[d] = (bits >> d) & 1 ? -1 : 1;
          if ((body.shape != "disk" && signs[last] > 0) || (body.shape == "quarter disk" && signs[0] < 0))
            continue;
          add_orthant(signs, mesh);
        }
      orient_cells(mesh);

      name_boundary<dim>(mesh, "arc", [](const Point<dim> &p) { return p.norm() > 1 - 1e-10; });
      if (body.shape != "disk")
        name_boundary<dim>(mesh, "cut", [](const Point<dim> &p) { return p[last] == 0; });
      if (body.shape == "quarter disk")
        name_boundary<dim>(mesh, "axis", [](const Point<dim> &p) { return p[0] == 0; });

      for (auto &p : mesh.vertices)
        {
          p *= body.radius;
          for (unsigned int d = 0; d < dim; ++d)
            p[d] += body.centre[d];
        }
      mesh.geometry["arc"] = TrueGeometry{TrueGeometry::Type::circle, body.centre, {}};
      return mesh;
    }

    // One cell across; around, cells about as long as the ring is thick.
    CoarseMesh<2>
    make_ring(const BodyData &body)
    {
      const double       r = body.inner_radius, R = body.radius;
      const unsigned int n_quarters = body.shape == "ring" ? 4 : body.shape == "half ring" ? 2 : 1;
      const bool         closed     = n_quarters == 4;
      const double       cells_per_quarter = numbers::PI / 4 * (R + r) / (R - r);
      check_cell_count<2>(body, n_quarters * cells_per_quarter);
      const unsigned int n = n_quarters * std::max(2l, std::lround(cells_per_quarter));

      CoarseMesh<2> mesh;
      for (unsigned int i = 0; i < n + (closed ? 0 : 1); ++i)
        {
          const double       angle = n_quarters * numbers::PI_2 * i / n;
          const Tensor<1, 2> direction({std::cos(angle), std::sin(angle)});
          mesh.vertices.push_back(Point<2>(r * direction));
          mesh.vertices.push_back(Point<2>(R * direction));
        }
      for (unsigned int i = 0; i < n; ++i)
        {
          const unsigned int next = (i + 1) % (mesh.vertices.size() / 2);
          CellData<2>        cell;
          cell.vertices = {2 * i, 2 * i + 1, 2 * next, 2 * next + 1};
          mesh.cells.push_back(cell);
        }
      orient_cells(mesh);

      name_boundary<2>(mesh, "inner", [&](const Point<2> &p) { return std::abs(p.norm() - r) < 1e-10 * R; });
      name_boundary<2>(mesh, "outer", [&](const Point<2> &p) { return std::abs(p.norm() - R) < 1e-10 * R; });
      name_boundary<2>(mesh, "cut x", [&](const Point<2> &p) { return std::abs(p[1]) < 1e-10 * R; });
      name_boundary<2>(mesh, "cut y", [&](const Point<2> &p) { return std::abs(p[0]) < 1e-10 * R; });

      for (auto &p : mesh.vertices)
        p += Tensor<1, 2>({body.centre[0], body.centre[1]});
      for (const std::string name : {"inner", "outer"})
        mesh.geometry[name] = TrueGeometry{TrueGeometry::Type::circle, body.centre, {}};
      mesh.polar_centre = body.centre;
      return mesh;
    }
  } // namespace

  template <int dim>
  CoarseMesh<dim>
  make_grid(const BodyData &body)
  {
    if (body.shape == "block")
      return make_block<dim>(body);

    if (!(body.radius > 0))
      throw InputError(body.where, "the radius is not positive", "a radius > 0");
    if (body.shape == "disk" || body.shape == "half disk" || body.shape == "quarter disk")
      return make_ball<dim>(body);

    if (body.shape == "ring" || body.shape == "half ring" || body.shape == "quarter ring")
      {
        if (!(body.inner_radius > 0 && body.inner_radius < body.radius))
          throw InputError(body.where,
                           "the inner radius is not between 0 and the outer radius",
                           "0 < inner radius < radius");
        if constexpr (dim == 2)
          return make_ring(body);
        else
          throw InputError(body.where,
                           "there is no shape '" + body.shape + "' in three dimensions",
                           "block, disk, half disk, quarter disk or a mesh from a file");
      }
    throw InputError(body.where,
                     "unknown shape '" + body.shape + "'",
                     "block, disk, half disk, quarter disk, ring, half ring, quarter ring or file");
  }

  template CoarseMesh<2>
  make_grid<2>(const BodyData &);
  template CoarseMesh<3>
  make_grid<3>(const BodyData &);
} // namespace Amontons
