// A body that crosses its clearance by d closes the gap n . d of curved surfaces everywhere. With quadratic
// elements the weighted gaps see the motion along the surface to the third order in the size of the faces at
// most, whichever side is the slave, with hanging nodes and on the axis, too; areas stay positive where faces
// are partly covered.
#include "contact/contact_scene.h"

namespace test_nodal_traces
{
BodyData
shell(const std::string &name, const std::string &shape, const double inner, const unsigned int refinements)
{
  BodyData body;
  body.name         = name;
  body.shape        = shape;
  body.inner_radius = inner;
  body.radius       = 2 * inner;
  body.refinements  = refinements;
  return body;
}

Scene
two_shells(const std::string &shape, const bool inner_is_slave, const unsigned int a, const unsigned int b)
{
  Scene scene;
  scene.bodies = {shell("inner", shape, 0.5, a), shell("outer", shape, 1, b)};
  const BoundaryName inner{"inner", "outer", {}}, outer{"outer", "inner", {}};
  scene.pairs = {inner_is_slave ? pair_of(inner, outer) : pair_of(outer, inner)};
  return scene;
}

// The largest of |gap - n . d|, relative to |d|.
template <int dim>
double
what_is_left(const Problem<dim> &problem, const Tensor<1, dim> &d)
{
  const double side = problem.slave().body == 0 ? 1 : -1; // [u] = d, or -d where the other body is the slave
  double       largest = 0;
  for (const auto &row : problem.coupling().rows)
    largest = std::max(largest, std::abs(row.gap - side * (row.normal * d)) / d.norm());
  return largest;
}

void
check_rings()
{
  const Tensor<1, 2> d({2e-3, 1e-3});
  for (const bool inner_is_slave : {true, false})
    for (const unsigned int finer : {0, 1})
      {
        double before = 0;
        for (unsigned int n = 2; n < 5; ++n)
          {
            Scene scene                = two_shells("quarter ring", inner_is_slave, n, n + finer);
            scene.pairs[0].initial_gap = Expression("(2e-3*x + 1e-3*y)/sqrt(x^2 + y^2)", {});
            const Problem<2> problem(scene, 2);
            check_weights(problem, "rings");
            const double left = what_is_left(problem, d);
            check::is_true(left < 0.02 / std::pow(8., n), "rings: what is left, " + std::to_string(left));
            check::is_true(n == 2 || left < before / 7, "rings: third order");
            before = left;
          }
      }
}

// On the axis there is no row.
void
check_axis()
{
  double before = 0;
  for (unsigned int n = 2; n < 5; ++n)
    {
      Scene scene                = two_shells("quarter ring", true, n, n);
      scene.kind                 = ProblemType::axisymmetric;
      scene.pairs[0].initial_gap = Expression("1e-3*y/sqrt(x^2 + y^2)", {});
      const Problem<2> problem(scene, 2);
      check_weights(problem, "axisymmetric");
      check::is_true(problem.coupling().rows.size() + 1 == problem.slave().nodes.size(),
                     "axisymmetric: one node without a row");
      const double left = what_is_left(problem, Tensor<1, 2>({0, 1e-3}));
      check::is_true(left < 0.02 / std::pow(8., n), "axisymmetric: what is left");
      check::is_true(n == 2 || left < before / 7, "axisymmetric: third order");
      before = left;
    }
}

// On two meshes, or on the coarse one with some cells refined.
void
check_spheres(const unsigned int n_local)
{
  const std::string what = "spheres, " + std::to_string(n_local) + " local refinements";
  for (const bool inner_is_slave : {true, false})
    {
      double before = 0;
      for (unsigned int n = 1; n < (n_local == 0 ? 3 : 2); ++n)
        {
          Scene scene                = two_shells("eighth hollow sphere", inner_is_slave, n, n);
          scene.pairs[0].initial_gap = Expression("(2e-3*x + 1e-3*y - 1.5e-3*z)/sqrt(x^2 + y^2 + z^2)", {});
          const Problem<3> problem(scene, 2, n_local);
          check_weights(problem, what);
          const double left = what_is_left(problem, Tensor<1, 3>({2e-3, 1e-3, -1.5e-3}));
          check::is_true(left < 0.02 / std::pow(8., n), what + ": what is left");
          check::is_true(n == 1 || left < before / 6, what + ": third order");
          before = left;
        }
    }
}

// The slave reaches beyond the master: the areas sum up to what is covered.
void
check_partly_covered()
{
  for (const double angle : {0., 5., 11.25, 20., 31.})
    {
      Scene scene                    = two_shells("quarter ring", false, 2, 3);
      scene.bodies[1].shape          = "half ring";
      scene.bodies[0].rotation_angle = angle;
      const Problem<2> problem(scene, 2);
      check_weights(problem, "partly covered");
      check::is_close(problem.total_area(), numbers::PI_2, 1e-6, "partly covered: area");
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_rings();
  check_axis();
  check_spheres(0);
  check_spheres(2);
  check_partly_covered();
  return check::result();
}
} // namespace test_nodal_traces
