// What lies between facets and round surfaces: of disks, rings, columns and balls, against closed forms.
#include "check.h"

#include <amontons/geometry/missing_volume.h>

#include <deal.II/base/numbers.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/tria.h>

namespace test_missing_volume
{
using namespace Amontons;
using namespace dealii;

template <int dim>
double
missing_volume_of(const Triangulation<dim> &triangulation)
{
  double sum = 0;
  for (const auto &face : triangulation.active_face_iterators())
    if (face->at_boundary())
      {
        Point<dim> middle;
        for (const unsigned int v : face->vertex_indices())
          middle += face->vertex(v) / double(face->n_vertices());
        sum += missing_volume<dim>(face, middle);
      }
  return sum;
}

// Against what the cells lack of the whole.
template <int dim>
void
check_against(const Triangulation<dim> &triangulation, const double volume, const std::string &what)
{
  const double lacking = volume - GridTools::volume(triangulation);
  check::is_close(missing_volume_of(triangulation), lacking, 0.03, what);
}

int
main(int, char **)
{
  Triangulation<2> disk, block, ring;
  GridGenerator::hyper_ball(disk, Point<2>(), 2);
  disk.refine_global(2);
  check_against(disk, 4 * numbers::PI, "a disk");
  GridGenerator::hyper_cube(block);
  block.refine_global(1);
  check::is_close(missing_volume_of(block), 0, 1e-14, "a block", 1);
  GridGenerator::hyper_shell(ring, Point<2>(), 1, 2, 16);
  const double chord = numbers::PI / 16;
  check::is_close(missing_volume_of(ring),
                  5 * (numbers::PI - 16 * std::sin(chord) * std::cos(chord)),
                  0.03,
                  "a ring: what the hole has too much counts as well");
  Triangulation<3> column, ball;
  GridGenerator::cylinder(column, 1, 3);
  column.refine_global(1);
  check_against(column, 6 * numbers::PI, "a column: its flat ends lack nothing, whatever their manifold");
  GridGenerator::hyper_ball(ball);
  ball.refine_global(3);
  check_against(ball, 4 * numbers::PI / 3, "a ball");
  return check::result();
}
} // namespace test_missing_volume
