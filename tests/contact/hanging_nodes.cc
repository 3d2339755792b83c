// On surfaces of random, locally refined meshes in space: control values and their subdivision give the trace
// of the finite elements back, dual functions are biorthogonal to the traces of the unknowns, coupling rows
// reproduce linear functions, and nodes lie in the middle of those that they are between.
#include "contact/contact_scene.h"

#include <amontons/contact/dual_basis.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/shear_smoothness.h>

#include <deal.II/base/quadrature_lib.h>

namespace test_hanging_nodes
{
std::mt19937 generator(1);

double
random_number(const double a, const double b)
{
  return std::uniform_real_distribution<double>(a, b)(generator);
}

// Values of all nodes for random values of those that do not hang.
std::vector<double>
random_values(const ContactSurface<3> &surface)
{
  std::vector<double> values;
  for (unsigned int i = 0; i < surface.nodes.size(); ++i)
    values.push_back(random_number(-1, 1));
  for (unsigned int i = 0; i < surface.nodes.size(); ++i)
    if (!surface.nodes[i].parents.empty())
      {
        values[i] = 0;
        for (const auto &[parent, weight] : surface.nodes[i].parents)
          {
            check::is_true(surface.nodes[parent].parents.empty(), "parents do not hang");
            values[i] += weight * values[parent];
          }
      }
  return values;
}

// Values at a point of the Bernstein traces of the face's unknowns.
std::vector<double>
traces_of_unknowns(const ContactSurface<3> &surface, const SurfaceFace<3> &face, const Point<2> &xi)
{
  const auto B = bernstein_values<2>(surface.degree, xi);
  if (face.subdivision.empty())
    return B;
  std::vector<double> traces(B.size(), 0.);
  for (unsigned int i = 0; i < B.size(); ++i)
    for (unsigned int j = 0; j < B.size(); ++j)
      traces[j] += B[i] * face.subdivision(i, j);
  return traces;
}

void
check_traces(const ContactSurface<3> &surface, const std::string &what)
{
  const auto          values = random_values(surface);
  std::vector<double> control(surface.nodes.size(), 0.);
  for (unsigned int i = 0; i < control.size(); ++i)
    for (const auto &[node, weight] : surface.nodes[i].control)
      {
        check::is_true(surface.nodes[node].parents.empty(),
                       what + ": control values refer to nodes that do not hang");
        control[i] += weight * values[node];
      }
  for (const auto &face : surface.faces)
    {
      for (unsigned int i = 0; i < face.subdivision.m(); ++i)
        {
          double sum = 0;
          for (unsigned int j = 0; j < face.subdivision.n(); ++j)
            {
              sum += face.subdivision(i, j);
              check::is_true(face.subdivision(i, j) > -1e-13,
                             what + ": subdivision weights are not negative");
            }
          check::is_close(sum, 1, 1e-13, what + ": subdivision weights sum to 1");
        }
      for (unsigned int sample = 0; sample < 3; ++sample)
        {
          const Point<2> xi(random_number(0, 1), random_number(0, 1));
          const auto     N        = lagrange_values<2>(surface.degree, xi);
          const auto     B        = traces_of_unknowns(surface, face, xi);
          double         expected = 0, found = 0;
          for (unsigned int k = 0; k < N.size(); ++k)
            {
              expected += N[k] * values[face.nodes[k]];
              found += B[k] * control[face.unknowns[k]];
            }
          check::is_close(found, expected, 1e-12, what + ": the trace from control values", 1);
        }
    }
}

// On a box that covers `fraction` of each side of the face.
void
check_dual_basis(const ContactSurface<3> &surface,
                 const unsigned int       f,
                 const double             fraction,
                 const std::string       &what)
{
  const auto           &face = surface.faces[f];
  const unsigned int    n    = face.unknowns.size();
  const QGauss<2>       gauss(surface.degree + 2);
  const Point<2>        lower(random_number(0, 1 - fraction), random_number(0, 1 - fraction));
  std::vector<Point<2>> points;
  std::vector<double>   weights;
  for (unsigned int q = 0; q < gauss.size(); ++q)
    {
      points.push_back(lower + fraction * gauss.point(q));
      double jacobian;
      surface.face_normal(f, points.back(), &jacobian);
      weights.push_back(gauss.weight(q) * fraction * fraction * jacobian);
    }
  std::vector<bool> carries(n, true);
  for (unsigned int k = 0; k < f % 3; ++k)
    carries[generator() % n] = false;
  const double n_carrying = std::count(carries.begin(), carries.end(), true);

  const auto          basis = make_dual_basis<2>(surface.degree, points, weights, carries, face.subdivision);
  FullMatrix<double>  traces(n, n);
  std::vector<double> D(n, 0.);
  double              area = 0;
  for (unsigned int q = 0; q < points.size(); ++q)
    {
      const auto B   = traces_of_unknowns(surface, face, points[q]);
      double     sum = 0;
      area += weights[q];
      for (unsigned int i = 0; i < n; ++i)
        {
          sum += basis.psi(i, q);
          D[i] += weights[q] * B[i];
          for (unsigned int j = 0; j < n; ++j)
            traces(i, j) += weights[q] * basis.psi(i, q) * B[j];
        }
      check::is_close(sum, 1, 1e-10, what + ": the sum of psi");
    }
  for (unsigned int i = 0; i < n; ++i)
    {
      check::is_true(D[i] > 0, what + ": positive D");
      for (unsigned int j = 0; j < n; ++j)
        {
          const double expected = !carries[i] ? 0 : i == j ? D[i] : !carries[j] ? D[j] / n_carrying : 0;
          check::is_close(traces(i, j), expected, 1e-10, what + ": int psi B", area);
          check::is_close(basis.traces(i, j), expected, 1e-12, what + ": the returned int psi B", area);
        }
    }
}

void
check_smoothness(const ContactSurface<3> &surface, const std::string &what)
{
  const auto smoothness = smooth_on(surface, std::vector<bool>(surface.nodes.size(), true));
  for (const auto &[node, around] : smoothness.means)
    {
      Point<3> middle;
      for (const unsigned int other : around)
        middle += surface.nodes[other].X / double(around.size());
      check::is_close(
          middle.distance(surface.nodes[node].X), 0, 1e-12, what + ": the middle of the vertices", 1);
    }
  check::is_true(surface.degree == 1 || smoothness.means.size() > surface.faces.size(),
                 what + ": nodes between vertices");
  for (const auto &jump : smoothness.jumps)
    {
      const auto linear = [](const Point<3> &X) { return 0.3 + X[0] - 2 * X[1]; };
      double     found = 0, largest = 0;
      for (const auto &[node, coefficient] : jump.terms)
        {
          found += coefficient * linear(surface.nodes[node].X);
          largest = std::max(largest, std::abs(coefficient));
        }
      check::is_close(found, 0, 1e-12, what + ": no jump of a linear function", 1);
      check::is_true(jump.edge.size() == 2 && largest >= 0.5, what + ": jumps across edges");
    }
  check::is_true(!smoothness.jumps.empty(), what + ": jumps from face to face");
}

unsigned int
check_blocks(const unsigned int degree, const unsigned int seed, const double gap)
{
  const std::string what = "degree " + std::to_string(degree) + ", mesh " + std::to_string(seed);
  Scene             scene;
  scene.bodies = {block("lower", {0, 0, 0}, {2, 1.5, 1}, {{3, 2, 1}}),
                  block("upper", {-0.3, 0.2, 1 + gap}, {1.7, 1.4, 2}, {{2, 3, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<3> problem(scene, degree, 3, seed);
  check_flat(problem, 1.7 * 1.2, gap, what);
  unsigned int n_hanging = 0;
  for (const ContactSurface<3> *surface :
       {problem.interfaces[0].slave.get(), problem.interfaces[0].master_surface.get()})
    {
      for (const auto &node : surface->nodes)
        n_hanging += !node.parents.empty();
      check_traces(*surface, what);
      check_smoothness(*surface, what);
      for (unsigned int f = 0; f < surface->faces.size(); ++f)
        for (const double fraction : {1., 0.3})
          check_dual_basis(*surface, f, fraction, what);
    }
  return n_hanging;
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      unsigned int n_hanging = 0;
      for (unsigned int seed = 1; seed <= 4; ++seed)
        n_hanging += check_blocks(degree, seed, seed % 2 * 0.1);
      check::is_true(n_hanging > 50, "meshes have hanging nodes on their surfaces");
    }
  return check::result();
}
} // namespace test_hanging_nodes
