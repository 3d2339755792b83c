#include <amontons/geometry/grids.h>
#include <amontons/geometry/round_grids.h>
#include <amontons/scene/scene_declarations.h>
#include <amontons/scene/text.h>

#include <algorithm>

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
          n[d] = body.cells[d];
        }
      check_cell_count<dim>(body, double(n[0]) * n[1] * n[2]);
      for (unsigned int d = 0; d < dim; ++d)
        {
          points[d] = graded_points(body.lower[d], body.upper[d], n[d], body.grading[d]);
          for (unsigned int i = 0; i < n[d]; ++i)
            if (!(points[d][i + 1] - points[d][i] > 1e-12 * (body.upper[d] - body.lower[d])))
              throw InputError(body.where,
                               "the grading makes cells that are too thin in direction " +
                                   std::string(1, "xyz"[d]),
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
  } // namespace

  template <int dim>
  CoarseMesh<dim>
  make_grid(const BodyData &body)
  {
    if (body.shape == "block")
      return make_block<dim>(body);

    const auto &shapes = built_in_shapes(dim);
    if (std::find(shapes.begin(), shapes.end(), body.shape) == shapes.end())
      throw InputError(body.where,
                       "unknown shape '" + body.shape + "' in " + std::to_string(dim) + "D",
                       join(shapes, ", ") + " or file");
    return make_round_grid<dim>(body);
  }

  template CoarseMesh<2>
  make_grid<2>(const BodyData &);
  template CoarseMesh<3>
  make_grid<3>(const BodyData &);
} // namespace Amontons
