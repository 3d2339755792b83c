#include <amontons/geometry/round_grids.h>

#include <deal.II/base/numbers.h>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    // The number of cuts that make the piece: 0 for the whole, 1 for a half, ...
    unsigned int
    n_cuts(const std::string &shape)
    {
      const std::string first = shape.substr(0, shape.find(' '));
      return first == "half" ? 1 : first == "quarter" ? 2 : first == "eighth" ? 3 : 0;
    }

    // The signs of the coordinates in the orthants of a piece. The first cut leaves the lower half, the
    // others x >= 0 and y >= 0.
    template <int dim>
    std::vector<Tensor<1, dim>>
    orthants(const unsigned int n_cuts)
    {
      std::vector<Tensor<1, dim>> all;
      for (unsigned int bits = 0; bits < (1u << dim); ++bits)
        {
          Tensor<1, dim> signs;
          for (unsigned int d = 0; d < dim; ++d)
            signs[d] = (bits >> d) & 1 ? -1 : 1;
          if ((n_cuts < 1 || signs[dim - 1] < 0) && (n_cuts < 2 || signs[0] > 0) &&
              (n_cuts < 3 || signs[1] > 0))
            all.push_back(signs);
        }
      return all;
    }

    template <int dim>
    void
    scale_and_shift(const double factor, const Point<3> &shift, CoarseMesh<dim> &mesh)
    {
      for (auto &p : mesh.vertices)
        for (unsigned int d = 0; d < dim; ++d)
          p[d] = factor * p[d] + shift[d];
    }

    template <int dim>
    void
    name_plane(CoarseMesh<dim>   &mesh,
               const std::string &name,
               const unsigned int d,
               const double       position = 0)
    {
      name_boundary<dim>(mesh, name, [&](const Point<dim> &p) { return p[d] == position; });
    }

    template <int dim>
    void
    name_round(CoarseMesh<dim>    &mesh,
               const std::string  &name,
               const double        radius,
               const TrueGeometry &geometry)
    {
      name_boundary<dim>(mesh, name, [&](const Point<dim> &p) {
        const double r = geometry.type == TrueGeometry::Type::circle ? p.norm() : std::hypot(p[0], p[1]);
        return std::abs(r - radius) < 1e-10 * radius;
      });
      mesh.geometry[name] = geometry;
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

    // A piece of the unit ball, without names.
    template <int dim>
    CoarseMesh<dim>
    ball(const unsigned int n_cuts)
    {
      CoarseMesh<dim> mesh;
      for (const auto &signs : orthants<dim>(n_cuts))
        add_orthant(signs, mesh);
      orient_cells(mesh);
      return mesh;
    }

    // From r to R, each by the same factor larger than the one before, so that cells that take `angle` are
    // about as long as they are thick, at either end of a thick ring.
    std::vector<double>
    radii(const double r, const double R, const double angle)
    {
      const unsigned int  n = std::max(1l, std::lround(std::log(R / r) / angle));
      std::vector<double> result;
      for (unsigned int k = 0; k < n; ++k)
        result.push_back(r * std::pow(R / r, double(k) / n));
      result.push_back(R);
      return result;
    }

    // A piece of a ring that begins at `first_quarter` right angles from the x axis, without names. Cells are
    // about as long as they are thick; a ring is one cell thick up to R = 3.2 r.
    CoarseMesh<2>
    ring(const BodyData &body, const int first_quarter)
    {
      const double       r = body.inner_radius, R = body.radius;
      const unsigned int n_quarters        = 4 >> n_cuts(body.shape);
      const bool         closed            = n_quarters == 4;
      const double       cells_per_quarter = numbers::PI / 4 * (R + r) / (R - r);
      check_cell_count<2>(body, n_quarters * cells_per_quarter);
      const unsigned int        n       = std::max(2l, std::lround(cells_per_quarter));
      const std::vector<double> circles = radii(r, R, numbers::PI_2 / n);
      const unsigned int        m       = circles.size(); // vertices on a ray

      CoarseMesh<2> mesh;
      for (unsigned int i = 0; i < n_quarters * n + (closed ? 0 : 1); ++i)
        {
          const double angle = numbers::PI_2 * (i % n) / n;
          Tensor<1, 2> direction({std::cos(angle), std::sin(angle)});
          for (int turn = (first_quarter + int(i / n) + 4) % 4; turn > 0; --turn)
            direction = Tensor<1, 2>({-direction[1], direction[0]});
          for (const double radius : circles)
            mesh.vertices.push_back(Point<2>(radius * direction));
        }
      for (unsigned int i = 0; i < n_quarters * n; ++i)
        for (unsigned int k = 0; k + 1 < m; ++k)
          {
            const unsigned int here = i * m + k, next = (i + 1) * m % mesh.vertices.size() + k;
            CellData<2>        cell;
            cell.vertices = {here, here + 1, next, next + 1};
            mesh.cells.push_back(cell);
          }
      orient_cells(mesh);
      return mesh;
    }

    CoarseMesh<2>
    make_disk(const BodyData &body)
    {
      const unsigned int cuts = n_cuts(body.shape);
      CoarseMesh<2>      mesh = ball<2>(cuts);
      name_round(mesh, "arc", 1, {TrueGeometry::Type::circle, body.centre, {}});
      name_plane(mesh, "cut", 1);
      name_plane(mesh, "axis", 0);
      scale_and_shift(body.radius, body.centre, mesh);
      return mesh;
    }

    CoarseMesh<2>
    make_ring(const BodyData &body)
    {
      const TrueGeometry circle{TrueGeometry::Type::circle, body.centre, {}};
      CoarseMesh<2>      mesh = ring(body, 0);
      name_round(mesh, "inner", body.inner_radius, circle);
      name_round(mesh, "outer", body.radius, circle);
      name_plane(mesh, "cut x", 1);
      name_plane(mesh, "cut y", 0);
      scale_and_shift(1, body.centre, mesh);
      mesh.polar = circle;
      return mesh;
    }

    void
    name_cuts(CoarseMesh<3> &mesh)
    {
      name_plane(mesh, "plane x", 0);
      name_plane(mesh, "plane y", 1);
      name_plane(mesh, "plane z", 2);
    }

    CoarseMesh<3>
    make_sphere(const BodyData &body)
    {
      CoarseMesh<3> mesh = ball<3>(n_cuts(body.shape));
      name_round(mesh, "surface", 1, {TrueGeometry::Type::circle, body.centre, {}});
      name_cuts(mesh);
      scale_and_shift(body.radius, body.centre, mesh);
      return mesh;
    }

    // The rays through a lattice on the surface of the cube [-n, n]^3 at equal angles make cells about as
    // long as they are thick.
    CoarseMesh<3>
    make_hollow_sphere(const BodyData &body)
    {
      const double r = body.inner_radius, R = body.radius;
      const double cells_per_half_edge = numbers::PI / 8 * (R + r) / (R - r);
      const auto   pieces              = orthants<3>(n_cuts(body.shape));
      check_cell_count<3>(body, 3 * pieces.size() * std::pow(cells_per_half_edge, 2));
      const int                 n       = std::max(1l, std::lround(cells_per_half_edge));
      const std::vector<double> spheres = radii(r, R, numbers::PI_4 / n);

      CoarseMesh<3> mesh;
      std::map<std::array<int, 3>, unsigned int>
                 rays; // by the lattice point: the vertex inside, the next ones are further out
      const auto ray = [&](const std::array<int, 3> &lattice_point) {
        const auto [entry, is_new] = rays.emplace(lattice_point, mesh.vertices.size());
        if (is_new)
          {
            Point<3> p;
            for (unsigned int d = 0; d < 3; ++d)
              p[d] = std::tan(numbers::PI_4 * lattice_point[d] / n);
            for (const double radius : spheres)
              mesh.vertices.push_back(radius / p.norm() * p);
          }
        return entry->second;
      };
      for (const auto &signs : pieces)
        for (unsigned int d = 0; d < 3; ++d)
          for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j)
              for (unsigned int k = 0; k + 1 < spheres.size(); ++k)
                {
                  CellData<3> cell;
                  for (unsigned int v = 0; v < 8; ++v)
                    {
                      std::array<int, 3> p;
                      p[d]             = int(signs[d]) * n;
                      p[(d + 1) % 3]   = int(signs[(d + 1) % 3]) * (i + int(v) % 2);
                      p[(d + 2) % 3]   = int(signs[(d + 2) % 3]) * (j + int(v) / 2 % 2);
                      cell.vertices[v] = ray(p) + k + v / 4;
                    }
                  mesh.cells.push_back(cell);
                }
      orient_cells(mesh);

      const TrueGeometry sphere{TrueGeometry::Type::circle, body.centre, {}};
      name_round(mesh, "inner", r, sphere);
      name_round(mesh, "outer", R, sphere);
      name_cuts(mesh);
      scale_and_shift(1, body.centre, mesh);
      mesh.polar = sphere;
      return mesh;
    }

    // The plane mesh `section`, swept along z in n layers.
    CoarseMesh<3>
    sweep(const CoarseMesh<2> &section, const double length, const unsigned int n)
    {
      const unsigned int n_vertices = section.vertices.size();
      CoarseMesh<3>      mesh;
      for (unsigned int k = 0; k <= n; ++k)
        for (const auto &p : section.vertices)
          mesh.vertices.emplace_back(p[0], p[1], length * (double(k) / n));
      for (unsigned int k = 0; k < n; ++k)
        for (const auto &plane : section.cells)
          {
            CellData<3> cell;
            for (unsigned int v = 0; v < 8; ++v)
              cell.vertices[v] = plane.vertices[v % 4] + (k + v / 4) * n_vertices;
            mesh.cells.push_back(cell);
          }
      orient_cells(mesh);
      return mesh;
    }

    // Solid or hollow; layers about as thick as the cells of the section are wide.
    CoarseMesh<3>
    make_cylinder(const BodyData &body)
    {
      const bool         hollow  = body.shape.find("hollow") != std::string::npos;
      const unsigned int cuts    = n_cuts(body.shape);
      CoarseMesh<2>      section = hollow ? ring(body, cuts == 0 ? 0 : cuts == 1 ? 2 : 3) : ball<2>(cuts);
      if (!hollow)
        scale_and_shift(body.radius, Point<3>(), section);
      const double width    = hollow ? body.radius - body.inner_radius : body.radius / 2;
      const double n_layers = std::max(1., std::round(body.length / width));
      check_cell_count<3>(body, n_layers * section.cells.size());
      CoarseMesh<3> mesh = sweep(section, body.length, n_layers);

      const TrueGeometry cylinder{TrueGeometry::Type::cylinder, body.centre, Tensor<1, 3>({0, 0, 1})};
      if (hollow)
        name_round(mesh, "inner", body.inner_radius, cylinder);
      name_round(mesh, hollow ? "outer" : "surface", body.radius, cylinder);
      name_plane(mesh, "bottom", 2);
      name_plane(mesh, "top", 2, body.length);
      name_plane(mesh, "plane x", 0);
      name_plane(mesh, "plane y", 1);
      scale_and_shift(1, body.centre, mesh);
      if (hollow)
        mesh.polar = cylinder;
      return mesh;
    }

    void
    check_radii(const BodyData &body)
    {
      const auto has = [&](const char *word) { return body.shape.find(word) != std::string::npos; };
      if (!(body.radius > 0))
        throw InputError(body.where, "the radius is not positive", "a radius > 0");
      if ((has("ring") || has("hollow")) && !(body.inner_radius > 0 && body.inner_radius < body.radius))
        throw InputError(body.where,
                         "the inner radius is not between 0 and the outer radius",
                         "0 < inner radius < radius");
      if (has("cylinder") && !(body.length > 0))
        throw InputError(body.where, "the length is not positive", "a length > 0");
    }
  } // namespace

  template <>
  CoarseMesh<2>
  make_round_grid<2>(const BodyData &body)
  {
    check_radii(body);
    return body.shape.find("ring") != std::string::npos ? make_ring(body) : make_disk(body);
  }

  template <>
  CoarseMesh<3>
  make_round_grid<3>(const BodyData &body)
  {
    check_radii(body);
    if (body.shape.find("cylinder") != std::string::npos)
      return make_cylinder(body);
    return body.shape.find("hollow") != std::string::npos ? make_hollow_sphere(body) : make_sphere(body);
  }
} // namespace Amontons
