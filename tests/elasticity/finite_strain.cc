// Finite strain in every kind and degree: forces are the derivative of the stored energy and the tangent that
// of the forces, also where the dilatations of cells are not yet those of u, rotations cost nothing,
// homogeneous deformations are exact, inverted cells are found, and the undeformed tangent is the stiffness
// of small strain.
#include "check.h"
#include "deformed_blocks.h"

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/physics/transformations.h>

namespace test_finite_strain
{
using namespace Amontons;

namespace
{
  // Of random displacements: large, but not beyond where St. Venant-Kirchhoff finds a thickness.
  double
  size_of(const Case &c)
  {
    return (c.kind == ProblemType::plane_stress ? 0.08 : 0.2) / c.degree;
  }

  template <int dim>
  void
  check_derivatives(const Case &c)
  {
    const Problem<dim> problem(c, {{2, 1, 1}});
    auto              &elasticity = *problem.elasticity;
    const LA::Vector   u          = problem.random_field(size_of(c));
    check::is_true(!elasticity.assemble(u), c.name() + ": the random displacement inverts a cell");
    const LA::Vector forces = elasticity.internal_forces(u);
    for (unsigned int direction = 0; direction < 3; ++direction)
      {
        const LA::Vector v = problem.random_field(1. / c.degree);
        check::is_close(forces * v,
                        derivative([&](const LA::Vector &w) { return elasticity.stored_energy(w); }, u, v),
                        1e-8,
                        c.name() + ": derivative of the energy",
                        0.1 * forces.l2_norm() * v.l2_norm());
        LA::Vector difference =
            derivative([&](const LA::Vector &w) { return elasticity.internal_forces(w); }, u, v);
        const double scale = difference.linfty_norm();
        difference -= problem.times_tangent(v);
        check::is_close(difference.linfty_norm(), 0, 1e-8, c.name() + ": derivative of the forces", scale);
      }
  }

  Vector<double>
  as_vector(const std::vector<double> &values)
  {
    return Vector<double>(values.begin(), values.end());
  }

  // theta + change, on the way to a solution
  std::vector<double>
  moved(std::vector<double> theta, const double s, const std::vector<double> &change)
  {
    for (unsigned int k = 0; k < theta.size(); ++k)
      theta[k] += s * change[k];
    return theta;
  }

  // With theta beside P J(u): the change of theta is that of P J, and takes it there; the tangent is the
  // derivative of the forces along v and this change, what the excess adds to them that along the excess.
  template <int dim>
  void
  check_dilatations(const Case &c)
  {
    const Problem<dim> problem(c, {{2, 1, 1}});
    auto              &elasticity = *problem.elasticity;
    const LA::Vector   u = problem.random_field(size_of(c)), v = problem.random_field(1. / c.degree);
    const auto         of_volume = [&](const LA::Vector &w) {
      elasticity.assemble(w);
      return as_vector(elasticity.dilatations());
    };
    const auto forces = [&](const double s, const std::vector<double> &theta) {
      LA::Vector w = u;
      w.add(s, v);
      elasticity.assemble(w, theta);
      return elasticity.forces();
    };
    const Vector<double> volume = of_volume(u), change_of_volume = derivative(of_volume, u, v);
    std::vector<double>  theta(volume.begin(), volume.end());
    for (auto &coefficient : theta)
      coefficient += random(0.05);
    check::is_true(!elasticity.assemble(u, theta) && elasticity.dilatations() == theta,
                   c.name() + ": dilatations are taken");

    std::vector<double> excess = elasticity.change_of_dilatations(LA::Vector(
                            problem.field([](const Point<dim> &, const unsigned int) { return 0.; }))),
                        change = elasticity.change_of_dilatations(v);
    const LA::Vector tangent = problem.times_tangent(v), correction = elasticity.forces_of_excess();
    for (unsigned int k = 0; k < theta.size(); ++k)
      {
        change[k] -= excess[k];
        check::is_close(theta[k] + excess[k], volume[k], 1e-12, c.name() + ": excess");
        check::is_close(change[k], change_of_volume[k], 1e-9, c.name() + ": change of the dilatation", 1);
      }

    LA::Vector   difference = derivative([&](const double s) { return forces(s, moved(theta, s, change)); });
    const double scale      = difference.linfty_norm();
    difference -= tangent;
    check::is_close(difference.linfty_norm(), 0, 1e-8, c.name() + ": tangent beside P J", scale);
    difference = derivative([&](const double s) { return forces(0, moved(theta, s, excess)); });
    difference -= correction;
    check::is_close(difference.linfty_norm(), 0, 1e-8, c.name() + ": forces of the excess", scale);
  }

  template <int dim>
  void
  check_undeformed(const Case &c)
  {
    const Problem<dim>      problem(c, {{2, 1, 1}});
    ElasticityOperator<dim> small(*problem.discretization);
    const LA::Vector        zero = problem.discretization->make_relevant_vector();
    small.assemble(zero);
    problem.elasticity->assemble(zero);
    for (unsigned int cell = 0; cell < small.n_cells(); ++cell)
      {
        const FullMatrix<double> expected   = small.matrix(cell);
        FullMatrix<double>       difference = problem.elasticity->matrix(cell);
        difference.add(-1, expected);
        check::is_close(difference.linfty_norm(),
                        0,
                        1e-11,
                        c.name() + ": tangent of the undeformed body",
                        expected.linfty_norm());
        check::is_close(problem.elasticity->internal_forces(zero).linfty_norm(),
                        0,
                        1e-13,
                        c.name() + ": forces of the undeformed body",
                        expected.linfty_norm());
      }
  }
  // x = Q X with a rotation about an axis of no preference.
  template <int dim>
  Tensor<2, dim>
  rotation(const double angle)
  {
    if constexpr (dim == 2)
      return Physics::Transformations::Rotations::rotation_matrix_2d(angle);
    else
      return Physics::Transformations::Rotations::rotation_matrix_3d(Tensor<1, 3>({2. / 7, 3. / 7, 6. / 7}),
                                                                     angle);
  }

  template <int dim>
  void
  check_rotation(const Case &c)
  {
    const Problem<dim>   problem(c, {{2, 1, 1}});
    const Tensor<2, dim> Q = rotation<dim>(40 * numbers::PI / 180);
    const LA::Vector     u = problem.random_field(size_of(c));
    // Q f, and Q (X + u) - X, node by node
    const auto rotated = [&](const LA::Vector &f, const bool positions) {
      std::map<std::array<double, dim>, Tensor<1, dim>> nodes;
      const auto                                        key = [&](const Point<dim> &X) {
        std::array<double, dim> k;
        for (unsigned int d = 0; d < dim; ++d)
          k[d] = std::round(1e8 * X[d]);
        return k;
      };
      for (const auto &[dof, component] : problem.components)
        nodes[key(problem.points.at(dof))][component] =
            f(dof) + (positions ? problem.points.at(dof)[component] : 0.);
      return problem.field([&](const Point<dim> &X, const unsigned int component) {
        return (Q * nodes.at(key(X)))[component] - (positions ? X[component] : 0.);
      });
    };
    const LA::Vector turned = rotated(u, true);
    check::is_close(problem.elasticity->stored_energy(turned),
                    problem.elasticity->stored_energy(u),
                    1e-10,
                    c.name() + ": energy after a rotation");
    LA::Vector   difference = rotated(problem.elasticity->internal_forces(u), false);
    const double scale      = difference.linfty_norm();
    difference -= problem.elasticity->internal_forces(turned);
    check::is_close(difference.linfty_norm(), 0, 1e-10, c.name() + ": forces turn with the body", scale);
  }

  // b - I of kind, from the part of F in the space of the mesh.
  template <int dim>
  SymmetricTensor<2, 3>
  strain(const ProblemType kind, const HyperelasticLaw &law, const Tensor<2, dim> &F)
  {
    SymmetricTensor<2, 3> e;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = i; j < dim; ++j)
        e[i][j] = (F * transpose(F))[i][j] - double(i == j);
    if (kind == ProblemType::plane_stress)
      e[2][2] = thickness_strain(law, e);
    if (kind == ProblemType::axisymmetric)
      e[2][2] = e[0][0];
    return e;
  }

  // x = F X: stress of the law at every point, no forces inside. Axisymmetric: F diagonal.
  template <int dim>
  void
  check_homogeneous(const Case &c)
  {
    const Problem<dim> problem(c, {{3, 3, dim == 3 ? 3u : 1u}});
    Tensor<2, dim>     F = unit_symmetric_tensor<dim>();
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int j = 0; j < dim; ++j)
        if (c.kind != ProblemType::axisymmetric || i == j)
          F[i][j] += 0.15 * std::sin(1. + 2 * i + 5 * j);
    LA::Vector u = problem.discretization->make_relevant_vector();
    u            = problem.field(
        [&](const Point<dim> &X, const unsigned int component) { return (F * X - X)[component]; });

    const HyperelasticLaw law = make_law(problem.scene.bodies[0].material);
    const auto            e   = strain(c.kind, law, F);
    const Voigt<3>        tau = kirchhoff_stress(law, e);
    const double          J   = std::sqrt(1 + change_of_determinant(e));
    FEValues<dim>         values(problem.discretization->mapping(),
                         problem.discretization->fe,
                         QGauss<dim>(c.degree + 1),
                         ElasticityOperator<dim>::needed_flags());
    for (const auto &cell : problem.discretization->dof_handler.active_cell_iterators())
      {
        values.reinit(cell);
        for (const auto &sigma : problem.elasticity->stresses(values, cell, u))
          for (unsigned int k = 0; k < n_voigt<dim>; ++k)
            check::is_close(sigma[k],
                            tau[k] / J,
                            1e-9,
                            c.name() + ": stress of a homogeneous deformation",
                            std::abs(tau[0]));
      }

    const LA::Vector forces = problem.elasticity->internal_forces(u);
    for (const auto &[dof, component] : problem.components)
      {
        const Point<dim> &X      = problem.points.at(dof);
        bool              inside = std::abs(X[0] - 2.5) < 0.6;
        for (unsigned int d = 1; d < dim; ++d)
          inside = inside && std::abs(X[d] - 1.5) < 0.6;
        if (inside)
          check::is_close(forces(dof),
                          0,
                          1e-10,
                          c.name() + ": inner force of a homogeneous deformation",
                          forces.linfty_norm());
      }
  }

  // Cells pressed to next to nothing count as inverted.
  template <int dim>
  void
  check_collapse(const Case &c)
  {
    for (const double left : {1e-5, 1e-7})
      {
        const Problem<dim> problem(c, {{2, 1, 1}});
        const LA::Vector   u = problem.field([&](const Point<dim> &X, const unsigned int component) {
          return component == dim - 1 ? (left - 1) * X[component] : 0.;
        });
        check::is_true(problem.elasticity->assemble(u).has_value() == (left < 1e-6),
                       c.name() + ": collapse is found");
      }
  }

  // The second of two cells folded over.
  template <int dim>
  void
  check_inversion(const Case &c)
  {
    const Problem<dim> problem(c, {{2, 1, 1}});
    const LA::Vector   u        = problem.field([](const Point<dim> &X, const unsigned int component) {
      return component == 0 && X[0] > 2.5 ? -1.6 : 0.;
    });
    const auto         inverted = problem.elasticity->assemble(u);
    check::is_true(inverted.has_value() && problem.elasticity->n_cells() == 0,
                   c.name() + ": inversion is found");
    if (inverted)
      {
        check::is_true(inverted->smallest_jacobian <= 0 && inverted->body == 0, c.name() + ": det F");
        check::is_close(inverted->centre[0], 2.5, 0.1, c.name() + ": place of the inverted cell");
      }
    check::is_true(std::isinf(problem.elasticity->stored_energy(u)), c.name() + ": energy of inversion");
    check::is_true(std::isnan(problem.elasticity->internal_forces(u).l1_norm()),
                   c.name() + ": forces of inversion");
  }

  template <int dim>
  void
  check_all(const Case &c)
  {
    check_undeformed<dim>(c);
    check_derivatives<dim>(c);
    if (c.kind != ProblemType::plane_stress)
      check_dilatations<dim>(c);
    check_homogeneous<dim>(c);
    check_inversion<dim>(c);
    check_collapse<dim>(c);
    if (c.kind != ProblemType::axisymmetric)
      check_rotation<dim>(c);
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const Law law : {Law::neo_hookean, Law::st_venant_kirchhoff})
    for (const unsigned int degree : {1, 2})
      for (const double poisson : {0.3, 0.4999})
        {
          for (const ProblemType kind :
               {ProblemType::plane_strain, ProblemType::plane_stress, ProblemType::axisymmetric})
            check_all<2>({kind, degree, poisson, law});
          check_all<3>({ProblemType::three_dimensional, degree, poisson, law});
        }
  return check::result();
}
} // namespace test_finite_strain
