// Where p^2 is linear, the error at the edge is that of interpolating its square root; elsewhere it is 0. In
// space this counts if the edge is parallel to the sides of the faces, and not at 45 degrees.
#include "contact/contact_scene.h"

#include <amontons/adaptivity/edge_error.h>

#include <deal.II/base/quadrature_lib.h>

namespace test_edge_error
{
// p^2 = end - 2 X, on faces of length h: nodal values of p in between are interpolated.
void
check_error(const double end, const double h)
{
  Scene scene;
  scene.bodies = {
      block("lower", {0, 0, 0}, {1, 1, 0}, {{1, 1, 1}}),
      block("upper", {0, 1, 0}, {1, 2, 0}, {{static_cast<unsigned int>(std::lround(1 / h)), 1, 1}})};
  scene.pairs = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<2> problem(scene, 1);
  SurfaceFields<2> fields;
  const auto       p     = [&](const double x) { return std::sqrt(std::max(0., end - 2 * x)); };
  const auto      &slave = problem.slave();
  for (const auto &node : slave.nodes)
    {
      fields.pressure.push_back(p(node.X[0]));
      fields.gap.push_back(0);
      fields.state.push_back(fields.pressure.back() > 0 ? ContactStatus::slip : ContactStatus::open);
    }
  const QIterated<1> quadrature(QGauss<1>(4), 100);
  const auto         errors = edge_errors(problem.interfaces[0], fields, scene, quadrature);
  const int          last   = static_cast<int>(end / 2 / h); // the face where the pressure ends
  for (unsigned int f = 0; f < errors.size(); ++f)
    {
      const double x     = slave.faces[f].centre[0] - h / 2;
      double       exact = 0;
      if (std::abs(std::lround(x / h) - last) < 2)
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            const double s = quadrature.point(q)[0];
            exact += quadrature.weight(q) * h * std::pow(p(x + s * h) - (1 - s) * p(x) - s * p(x + h), 2);
          }
      check::is_close(errors[f], exact, 1e-12, "error at the edge", h * end);
    }

  // If nothing is opposite of what does not press, the contact does not end there.
  for (unsigned int i = 0; i < fields.gap.size(); ++i)
    if (!(fields.pressure[i] > 0))
      fields.gap[i] = std::numeric_limits<double>::quiet_NaN();
  for (const double error : edge_errors(problem.interfaces[0], fields, scene, quadrature))
    check::is_true(error == 0, "no error at the edge of the other side");
}

// p^2 = 0.97 - 2 (X + slope Y)
void
check_in_space(const double slope)
{
  const unsigned int n = 8;
  Scene              scene;
  scene.kind   = ProblemType::three_dimensional;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 1}, {{1, 1, 1}}),
                  block("upper", {0, 0, 1}, {1, 1, 2}, {{n, n, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<3> problem(scene, 1);
  SurfaceFields<3> fields;
  const auto      &slave = problem.slave();
  for (const auto &node : slave.nodes)
    {
      fields.pressure.push_back(std::sqrt(std::max(0., 0.97 - 2 * (node.X[0] + slope * node.X[1]))));
      fields.gap.push_back(0);
      fields.state.push_back(fields.pressure.back() > 0 ? ContactStatus::slip : ContactStatus::open);
    }
  const QIterated<1> on_line(QGauss<1>(4), 100);
  const auto         p = [&](const double x) { return std::sqrt(std::max(0., 0.97 - 2 * x)); };
  const auto errors    = edge_errors(problem.interfaces[0], fields, scene, QIterated<2>(QGauss<1>(4), 100));
  double     sum = 0, exact = 0;
  for (const double error : errors)
    sum += error;
  for (const unsigned int cell : {2, 3, 4})
    for (unsigned int q = 0; q < on_line.size(); ++q)
      {
        const double s = on_line.point(q)[0], x = cell / 8., h = 1. / n;
        exact += on_line.weight(q) * h * std::pow(p(x + s * h) - (1 - s) * p(x) - s * p(x + h), 2);
      }
  check::is_close(sum, slope == 0 ? exact : 0., 1e-10, "error at an edge in space", exact);
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_error(0.97, 1. / 8);
  check_error(1.22, 1. / 8);
  check_in_space(0);
  check_in_space(1);
  return check::result();
}
} // namespace test_edge_error
