// Condensation gives the solution and the multipliers of the full saddle point system: chains of pairs,
// corners with two rows, oblique supports, nodes that supports own, friction.
#include "check.h"

#include <amontons/algebra/eliminated_system.h>
#include <amontons/algebra/contact_constraints.h>

#include <deal.II/base/mpi.h>

#include <random>

namespace test_contact_constraints
{
using namespace Amontons;

using Matrix = FullMatrix<double>;
using Dofs   = std::vector<types::global_dof_index>;

const unsigned int n = 12;
std::mt19937       generator(1);

double
random_number()
{
  return std::uniform_real_distribution<double>(-1, 1)(generator);
}

ContactEquation
make(const Coefficients &coefficients, const double value, const Dofs &candidates)
{
  return {{coefficients, value}, candidates};
}

LA::Vector
as_vector(const std::vector<double> &values)
{
  LA::Vector v(complete_index_set(n), MPI_COMM_SELF);
  for (unsigned int i = 0; i < n; ++i)
    v(i) = values[i];
  v.compress(VectorOperation::insert);
  return v;
}

// u = C x + k, x: all DoFs (those that are constrained do not matter).
void
dense(const Constraints &constraints, Matrix &C, std::vector<double> &k)
{
  C.reinit(n, n);
  k.assign(n, 0.);
  for (unsigned int i = 0; i < n; ++i)
    if (!constraints.is_constrained(i))
      C(i, i) = 1;
    else
      {
        for (const auto &[j, weight] : *constraints.get_constraint_entries(i))
          C(i, j) = weight;
        k[i] = constraints.get_inhomogeneity(i);
      }
}

std::vector<double>
times(const Matrix &A, const std::vector<double> &x, const bool transpose = false)
{
  std::vector<double> y(transpose ? A.n() : A.m(), 0.);
  for (unsigned int i = 0; i < A.m(); ++i)
    for (unsigned int j = 0; j < A.n(); ++j)
      if (transpose)
        y[j] += A(i, j) * x[i];
      else
        y[i] += A(i, j) * x[j];
  return y;
}

std::vector<double>
solve(const Matrix &A, const std::vector<double> &b)
{
  Matrix inverse(A.m(), A.n());
  inverse.invert(A);
  return times(inverse, b);
}

// supports: equations with one candidate each, eliminated in their order. has_pivot: by equation.
void
check_case(const std::string                  &what,
           const std::vector<ContactEquation> &supports_as_equations,
           const std::vector<ContactEquation> &equations,
           const std::vector<bool>            &has_pivot)
{
  Matrix              K(n, n), A(n, n);
  std::vector<double> f;
  for (unsigned int i = 0; i < n; ++i)
    {
      f.push_back(random_number());
      for (unsigned int j = 0; j < n; ++j)
        A(i, j) = random_number();
    }
  A.mTmult(K, A);
  for (unsigned int i = 0; i < n; ++i)
    K(i, i) += 0.5;

  Constraints supports(complete_index_set(n));
  for (const auto &e : supports_as_equations)
    eliminate(e.equation, e.candidates[0], supports);
  supports.close();
  const ContactConstraints contact(supports, equations);

  // K u + sum_c b_c mu_c = f, a_c . u = value_c, over supports and equations; b: force coefficients
  std::vector<const ContactEquation *> all;
  for (const auto &e : supports_as_equations)
    all.push_back(&e);
  for (unsigned int i = 0; i < equations.size(); ++i)
    if (has_pivot[i])
      all.push_back(&equations[i]);
  const unsigned int  m = n + all.size();
  Matrix              saddle(m, m);
  std::vector<double> right = f;
  for (unsigned int i = 0; i < n; ++i)
    for (unsigned int j = 0; j < n; ++j)
      saddle(i, j) = K(i, j);
  for (unsigned int c = 0; c < all.size(); ++c)
    {
      right.push_back(all[c]->equation.value);
      for (const auto &[dof, coefficient] : all[c]->equation.coefficients)
        saddle(n + c, dof) = coefficient;
      for (const auto &[dof, coefficient] : all[c]->force_coefficients())
        saddle(dof, n + c) = coefficient;
    }
  const auto expected = solve(saddle, right);

  // B^T K C x = B^T (f - K k), with ones on the diagonal of constrained DoFs; C: trial, B: test functions
  Matrix              C, B, KC(n, n), CKC(n, n);
  std::vector<double> k, zero;
  dense(contact.test(), B, zero);
  dense(contact.trial(), C, k);
  K.mmult(KC, C);
  B.Tmmult(CKC, KC);
  for (unsigned int i = 0; i < n; ++i)
    if (contact.trial().is_constrained(i))
      CKC(i, i) = 1;
  auto       r  = f;
  const auto Kk = times(K, k);
  for (unsigned int i = 0; i < n; ++i)
    r[i] -= Kk[i];
  auto u = times(C, solve(CKC, times(B, r, true)));
  for (unsigned int i = 0; i < n; ++i)
    {
      u[i] += k[i];
      check::is_close(u[i], expected[i], 1e-8, what + ": solution", 1);
    }

  // Multipliers
  auto raw = times(K, u);
  for (unsigned int i = 0; i < n; ++i)
    raw[i] -= f[i];
  const auto          on_supports = condense(as_vector(raw), supports, as_vector(raw));
  std::vector<double> at_pivots(equations.size(), 0.);
  for (unsigned int i = 0; i < equations.size(); ++i)
    {
      check::is_true(contact.pivots()[i].has_value() == has_pivot[i],
                     what + ": pivot of equation " + std::to_string(i));
      if (contact.pivots()[i])
        at_pivots[i] = on_supports(*contact.pivots()[i]);
    }
  const auto   mu    = contact.recover_multipliers(at_pivots);
  unsigned int place = n + supports_as_equations.size();
  for (unsigned int i = 0; i < equations.size(); ++i)
    check::is_close(
        mu[i], has_pivot[i] ? expected[place++] : 0, 1e-8, what + ": multiplier " + std::to_string(i), 1);

  // condense() is C^T
  for (const Constraints *constraints : {&std::as_const(supports), &contact.trial(), &contact.test()})
    {
      dense(*constraints, C, k);
      const auto from_dense = times(C, raw, true);
      const auto condensed  = condense(as_vector(raw), *constraints, as_vector(raw));
      for (unsigned int i = 0; i < n; ++i)
        check::is_close(condensed(i), from_dense[i], 1e-12, what + ": condensed vector", 1);
    }
}

// Nodes have the DoFs (0, 1), (2, 3), ...
void
check_cases()
{
  const double s = std::sqrt(0.5);
  check_case("no equation", {}, {}, {});
  const auto simple = make({{1, -1.}, {3, 0.4}, {5, 0.6}}, 0.1, {0, 1});
  check_case("one node", {}, {simple}, {true});

  // node 1 (2, 3) is a master of node 0 and a slave on nodes 2, 3; either may come first
  const auto chained = make({{3, -1.}, {5, 0.3}, {7, 0.7}}, 0.2, {2, 3});
  check_case("chain", {}, {simple, chained}, {true, true});
  check_case("chain, from its end", {}, {chained, simple}, {true, true});
  const auto third = make({{4, 0.1}, {5, -1.}, {9, 0.25}, {11, 0.75}}, -0.1, {4, 5});
  check_case("three links", {}, {simple, chained, third}, {true, true, true});
  check_case("three links, from the end", {}, {third, chained, simple}, {true, true, true});
  check_case("three links, from the middle", {}, {chained, third, simple}, {true, true, true});

  // two rows at the corner (0, 1), which also refer to the mid-side node of their face
  const auto first  = make({{0, 0.9}, {1, -0.2}, {4, -0.8}, {5, 0.1}, {2, 0.1}}, 0.1, {0, 1});
  const auto second = make({{0, 0.3}, {1, 1.}, {7, -1.}, {6, -0.3}}, -0.3, {0, 1});
  check_case("corner", {}, {first, second}, {true, true});
  check_case(
      "corner and chain", {}, {second, first, make({{2, 1.}, {8, -1.}}, 0, {2, 3})}, {true, true, true});
  check_case("two parallel rows at a node",
             {},
             {first, second, make({{0, 1.}, {1, 1.}}, 0, {0, 1})},
             {true, true, false});

  // two slaves that refer to each other's node through quadratic traces
  check_case("neighbours",
             {},
             {make({{1, -1.}, {3, -0.2}, {9, 1.2}}, 0.1, {0, 1}), make({{3, -1.}, {11, 1.}}, 0.05, {2, 3})},
             {true, true});

  // oblique plane through the slave node, then also through the master
  const auto plane        = make({{0, s}, {1, s}}, 0, {0});
  const auto master_plane = make({{2, 0.6}, {3, 0.8}}, 0, {3});
  check_case("oblique support", {plane}, {simple}, {true});
  check_case("oblique supports", {plane, master_plane}, {simple, third}, {true, true});
  check_case("oblique supports in a chain", {master_plane}, {simple, chained, third}, {true, true, true});

  // prescribed displacements of the slave node and of the master; a node that supports own whole
  const auto held = make({{1, 1.}}, 0.4, {1});
  check_case("held component", {held}, {first}, {true});
  check_case("node that supports own", {make({{0, 1.}}, 0.1, {0}), held}, {first, third}, {false, true});
  check_case("moved master", {make({{3, 1.}}, 0.2, {3}), make({{5, 1.}}, -0.1, {5})}, {simple}, {true});

  // tied: a row for each component
  check_case("tied",
             {},
             {make({{0, 1.}, {2, -0.5}, {4, -0.5}}, 0, {0}), make({{1, 1.}, {3, -0.5}, {5, -0.5}}, 0, {1})},
             {true, true});
}

// A node that a support keeps from moving along an axis: what is opposite of it is held.
void
check_others()
{
  const auto held   = make({{0, 1.}}, 0.1, {0});
  auto       along  = make({{0, 1.}, {2, -0.8}, {4, -0.2}}, 0, {0});
  along.others      = {2, 4};
  const auto across = make({{1, 1.}, {3, -0.8}, {5, -0.2}}, 0, {1});
  check_case("held by a support", {held}, {along, across}, {true, true});
  check_case("not held", {}, {along, across}, {true, true});
  check_case(
      "what is opposite is held, too", {held, make({{2, 1.}}, 0.3, {2})}, {along, across}, {false, true});
  auto far   = make({{0, 1.}, {2, -0.05}, {4, -0.95}}, 0, {0});
  far.others = {2};
  check_case("by what hardly moves it", {held}, {far}, {false});
  auto next   = make({{6, 1.}, {2, -0.1}, {4, -0.9}}, 0, {6});
  next.others = {2, 4};
  check_case(
      "beside another one", {held, make({{6, 1.}}, 0, {6})}, {along, next, across}, {true, true, true});
  check_case("beside a free one", {held}, {next, along, across}, {true, true, true});
}

// A slipping node: test functions obey (n + mu d) . Delta = 0.
ContactEquation
slipping(ContactEquation equation, const Coefficients &along, const double mu)
{
  equation.test = equation.equation.coefficients;
  for (const auto &[dof, weight] : along)
    equation.test[dof] += mu * weight;
  equation.candidates = {equation.candidates[0] / 2 * 2, equation.candidates[0] / 2 * 2 + 1};
  return equation;
}

void
check_friction()
{
  const double       s      = std::sqrt(0.5);
  const auto         simple = make({{1, -1.}, {3, 0.4}, {5, 0.6}}, 0.1, {0, 1});
  const Coefficients along  = {{0, 1.}, {2, -0.4}, {4, -0.6}};
  for (const double mu : {0.1, 1., -3.})
    {
      const std::string what = "slip, mu = " + std::to_string(mu) + ": ";
      const auto        slip = slipping(simple, along, mu);
      check_case(what + "one node", {}, {slip}, {true});
      const auto chained =
          slipping(make({{3, -1.}, {5, 0.3}, {7, 0.7}}, 0.2, {2, 3}), {{2, 1.}, {4, -0.3}, {6, -0.7}}, -mu);
      const auto third = make({{4, 0.1}, {5, -1.}, {9, 0.25}, {11, 0.75}}, -0.1, {4, 5});
      check_case(what + "chain", {}, {slip, chained, third}, {true, true, true});
      check_case(what + "chain from its end", {}, {third, chained, slip}, {true, true, true});
      check_case(what + "oblique support", {make({{2, 0.6}, {3, 0.8}}, 0, {3})}, {slip, third}, {true, true});
      check_case(what + "moved master", {make({{3, 1.}}, 0.2, {3})}, {slip}, {true});
      check_case(what + "dragged node", {make({{0, 1.}}, 0.3, {0})}, {slip, chained}, {true, true});
      // a normal of 45 degrees, where mu = -1 along (1, -1) leaves one component of the test functions only
      const auto inclined = slipping(
          make({{0, s}, {1, s}, {2, -s}, {3, -s}}, 0.1, {0, 1}), {{0, s}, {1, -s}, {2, -s}, {3, s}}, mu);
      check_case(what + "inclined", {}, {inclined, chained}, {true, true});
      // stick beside slip
      check_case(what + "beside stick",
                 {},
                 {make({{2, 1.}, {8, -1.}}, 0.1, {2}), make({{3, 1.}, {9, -1.}}, 0.2, {3}), slip},
                 {true, true, true});
    }
}

// Each eliminated DoF depends on the next three, 80 times: entry by entry these were 3^80 terms.
void
check_long_chain()
{
  const unsigned int           n_eliminated = 80, n_dofs = n_eliminated + 3;
  const std::vector<double>    weights = {0.5, 0.3, -0.4};
  std::vector<ContactEquation> equations;
  for (unsigned int i = 0; i < n_eliminated; ++i)
    {
      Coefficients coefficients = {{i, 1.}};
      for (unsigned int k = 0; k < 3; ++k)
        coefficients[i + 1 + k] = -weights[k];
      equations.push_back(make(coefficients, 0.1, {i}));
    }
  Constraints none(complete_index_set(n_dofs));
  none.close();
  const ContactConstraints contact(none, equations);

  std::vector<double> u(n_dofs, 0.), expected(n_dofs, 0.);
  for (unsigned int k = 0; k < 3; ++k)
    u[n_eliminated + k] = expected[n_eliminated + k] = random_number();
  for (unsigned int i = n_eliminated; i-- > 0;)
    {
      expected[i] = 0.1;
      for (unsigned int k = 0; k < 3; ++k)
        expected[i] += weights[k] * expected[i + 1 + k];
      u[i] = contact.trial().get_inhomogeneity(i);
      for (const auto &[free, weight] : *contact.trial().get_constraint_entries(i))
        u[i] += weight * u[free];
      check::is_close(u[i], expected[i], 1e-12, "long chain", 1);
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_cases();
  check_others();
  check_friction();
  check_long_chain();
  return check::result();
}
} // namespace test_contact_constraints
