// Stiffness: constant strains and rigid motions exact on distorted cells in every kind, no spurious modes, no
// locking near incompressibility.
#include "check.h"

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/elasticity/hyperelastic.h>
#include <amontons/elasticity/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/lapack_full_matrix.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

#include <random>

namespace test_elasticity
{
using namespace Amontons;

template <int dim>
using Field = std::function<Tensor<1, dim>(const Point<dim> &)>;

Scene
block(const ProblemType kind, const double poisson)
{
  Scene scene;
  scene.kind = kind;
  BodyData body;
  body.name             = "it";
  body.lower            = {1, 0, 0};
  body.upper            = {3, 1, 1};
  body.cells            = {{4, 3, 3}};
  body.material.young   = 7;
  body.material.poisson = poisson;
  scene.bodies          = {body};
  return scene;
}

template <int dim>
struct Problem
{
  // distortion: of inner vertices, relative to the cell size.
  Problem(const Scene &s, const unsigned int degree, const double distortion)
      : scene(s), geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    move_inner_vertices(distortion);
    start(degree);
  }

  Problem(const Scene &s, const unsigned int degree, const std::function<Point<dim>(const Point<dim> &)> &map)
      : scene(s), geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    std::set<unsigned int> done;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (done.insert(cell->vertex_index(v)).second)
          cell->vertex(v) = map(cell->vertex(v));
    start(degree);
  }

  void
  move_inner_vertices(const double distortion)
  {
    std::mt19937                           generator(1);
    std::uniform_real_distribution<double> random(-distortion, distortion);
    std::set<unsigned int>                 boundary;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      for (const auto &face : cell->face_iterators())
        if (face->at_boundary())
          for (const unsigned int v : face->vertex_indices())
            boundary.insert(face->vertex_index(v));
    std::set<unsigned int> done = boundary;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (done.insert(cell->vertex_index(v)).second)
          for (unsigned int d = 0; d < dim; ++d)
            cell->vertex(v)[d] += random(generator) * cell->diameter() / std::sqrt(double(dim));
  }

  void
  start(const unsigned int degree)
  {
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, degree);
    discretization->distribute_dofs();
    elasticity = std::make_unique<ElasticityOperator<dim>>(*discretization);
    elasticity->assemble(discretization->make_relevant_vector());
    DoFTools::map_dofs_to_support_points(discretization->mapping(), discretization->dof_handler, points);
    std::vector<types::global_dof_index> dofs(discretization->fe.n_dofs_per_cell());
    for (const auto &cell : discretization->dof_handler.active_cell_iterators())
      {
        cell->get_dof_indices(dofs);
        for (unsigned int i = 0; i < dofs.size(); ++i)
          components[dofs[i]] = discretization->fe.system_to_component_index(i).first;
      }
  }

  LA::Vector
  interpolate(const Field<dim> &field) const
  {
    LA::Vector u = discretization->make_owned_vector();
    for (const auto &[dof, c] : components)
      u(dof) = field(points.at(dof))[c];
    u.compress(VectorOperation::insert);
    LA::Vector result = discretization->make_relevant_vector();
    result            = u;
    return result;
  }

  // Displacement under the scene's loads and supports, without contact.
  LA::Vector
  solve() const
  {
    const auto             supports = discretization->make_supports(1);
    const auto             loads    = assemble_loads<dim>(*discretization, 1, {});
    DynamicSparsityPattern dsp(discretization->dof_handler.n_dofs());
    DoFTools::make_sparsity_pattern(discretization->dof_handler, dsp, supports);
    SparsityPattern pattern;
    pattern.copy_from(dsp);
    SparseMatrix<double> matrix(pattern);
    Vector<double>       rhs(dsp.n_rows());
    for (const auto dof : discretization->locally_owned)
      supports.distribute_local_to_global(Vector<double>({loads(dof)}), {dof}, rhs);
    for (unsigned int c = 0; c < elasticity->n_cells(); ++c)
      supports.distribute_local_to_global(elasticity->matrix(c),
                                          Vector<double>(elasticity->dofs(c).size()),
                                          elasticity->dofs(c),
                                          matrix,
                                          rhs);
    SparseDirectUMFPACK solver;
    solver.initialize(matrix);
    solver.solve(rhs);
    LA::Vector u(discretization->locally_owned, MPI_COMM_WORLD);
    for (const auto dof : discretization->locally_owned)
      u(dof) = rhs(dof);
    u.compress(VectorOperation::insert);
    supports.distribute(u);
    return u;
  }

  // Value of component c at the node nearest to p.
  double
  value_at(const LA::Vector &u, const Point<dim> &p, const unsigned int c) const
  {
    double nearest = 1e300, value = 0;
    for (const auto &[dof, component] : components)
      if (component == c && p.distance(points.at(dof)) < nearest)
        {
          nearest = p.distance(points.at(dof));
          value   = u(dof);
        }
    return value;
  }

  bool
  is_inside(const Point<dim> &p) const
  {
    bool inside = p[0] > 1 + 1e-10 && p[0] < 3 - 1e-10;
    for (unsigned int d = 1; d < dim; ++d)
      inside = inside && p[d] > 1e-10 && p[d] < 1 - 1e-10;
    return inside;
  }

  Scene                                           scene;
  Geometry<dim>                                   geometry;
  std::unique_ptr<Discretization<dim>>            discretization;
  std::unique_ptr<ElasticityOperator<dim>>        elasticity;
  std::map<types::global_dof_index, Point<dim>>   points;
  std::map<types::global_dof_index, unsigned int> components;
};

std::string
name_of(const ProblemType kind, const unsigned int degree)
{
  static const std::vector<std::string> names = {"plane strain", "plane stress", "axisymmetric", "3D"};
  return names[static_cast<unsigned int>(kind)] + ", degree " + std::to_string(degree);
}

// Stress by hand from the strain of kind: 2 mu e + lambda tr e, with the strain energy density.
template <int dim>
double
energy_density(const ProblemType kind, const MaterialData &m, Voigt<dim> e)
{
  const double mu     = m.young / 2 / (1 + m.poisson),
               lambda = m.young * m.poisson / (1 + m.poisson) / (1 - 2 * m.poisson);
  if (kind == ProblemType::plane_stress)
    e[2] = -m.poisson / (1 - m.poisson) * (e[0] + e[1]);
  const double trace = e[0] + e[1] + e[2];
  double       w     = 0.5 * lambda * trace * trace;
  for (unsigned int k = 0; k < n_voigt<dim>; ++k)
    w += (k < 3 ? mu : 0.5 * mu) * e[k] * e[k];
  return w;
}

template <int dim>
void
check_patch(const ProblemType kind, const unsigned int degree, const double poisson)
{
  const std::string  what  = name_of(kind, degree);
  const Scene        scene = block(kind, poisson);
  const Problem<dim> problem(scene, degree, 0.25);
  // u = G X; axisymmetric: no shear, u_r = a r.
  Tensor<2, dim> G;
  for (unsigned int i = 0; i < dim; ++i)
    for (unsigned int j = 0; j < dim; ++j)
      if (kind != ProblemType::axisymmetric || i == j)
        G[i][j] = 0.1 * std::sin(1. + 2 * i + 5 * j);
  Voigt<dim> strain;
  strain.fill(0);
  for (unsigned int i = 0; i < dim; ++i)
    strain[i] = G[i][i];
  strain[3] = G[0][1] + G[1][0];
  if (dim == 3)
    {
      strain[4]                = G[0][dim - 1] + G[dim - 1][0];
      strain[n_voigt<dim> - 1] = G[1][dim - 1] + G[dim - 1][1];
    }
  if (kind == ProblemType::axisymmetric)
    strain[2] = G[0][0];

  const auto u       = problem.interpolate([&](const Point<dim> &X) { return G * X; });
  const auto force   = problem.elasticity->internal_forces(u);
  double     largest = 0, energy = 0;
  for (const auto &[dof, c] : problem.components)
    {
      largest = std::max(largest, std::abs(force(dof)));
      energy += 0.5 * force(dof) * u(dof);
    }
  for (const auto &[dof, c] : problem.components)
    if (problem.is_inside(problem.points.at(dof)))
      check::is_close(force(dof), 0, 1e-11, what + ": inner force of a constant strain", largest);
  const double volume = kind == ProblemType::axisymmetric ? numbers::PI * (9 - 1) : 2;
  check::is_close(energy,
                  volume * energy_density<dim>(kind, scene.bodies[0].material, strain),
                  1e-11,
                  what + ": energy of a constant strain");

  // Stresses at points
  FEValues<dim> values(problem.discretization->mapping(),
                       problem.discretization->fe,
                       QGauss<dim>(degree + 1),
                       ElasticityOperator<dim>::needed_flags());
  const auto    sigma = LinearElastic<dim>(scene.bodies[0].material, kind).stress(strain);
  for (const auto &cell : problem.discretization->dof_handler.active_cell_iterators())
    {
      values.reinit(cell);
      for (const auto &s : problem.elasticity->stresses(values, cell, u))
        for (unsigned int k = 0; k < n_voigt<dim>; ++k)
          check::is_close(s[k], sigma[k], 1e-10, what + ": stress of a constant strain", std::abs(sigma[0]));
    }
}

template <int dim>
void
check_rigid_motions(const ProblemType kind, const unsigned int degree)
{
  const Problem<dim>      problem(block(kind, 0.4), degree, 0.25);
  std::vector<Field<dim>> motions;
  for (unsigned int d = 0; d < dim; ++d)
    if (kind != ProblemType::axisymmetric || d == 1)
      motions.push_back([d](const Point<dim> &) {
        Tensor<1, dim> v;
        v[d] = 1;
        return v;
      });
  for (unsigned int a = 0; a < dim && kind != ProblemType::axisymmetric; ++a)
    for (unsigned int b = a + 1; b < dim; ++b)
      motions.push_back([a, b](const Point<dim> &X) {
        Tensor<1, dim> v;
        v[a] = -X[b];
        v[b] = X[a];
        return v;
      });
  for (const auto &motion : motions)
    check::is_close(problem.elasticity->internal_forces(problem.interpolate(motion)).linfty_norm(),
                    0,
                    1e-12,
                    name_of(kind, degree) + ": force of a rigid motion",
                    7);

  // Every cell: symmetric, and rigid motions are all that costs no energy.
  for (unsigned int c = 0; c < std::min(2u, problem.elasticity->n_cells()); ++c)
    {
      const auto              &K = problem.elasticity->matrix(c);
      LAPACKFullMatrix<double> matrix(K.m(), K.n());
      matrix = K;
      for (unsigned int i = 0; i < K.m(); ++i)
        for (unsigned int j = 0; j < i; ++j)
          check::is_close(K(i, j), K(j, i), 1e-14, name_of(kind, degree) + ": symmetry", K.linfty_norm());
      Vector<double>     eigenvalues;
      FullMatrix<double> vectors;
      const double       largest = K.linfty_norm();
      matrix.compute_eigenvalues_symmetric(-largest, 1e-8 * largest, 1e-14 * largest, eigenvalues, vectors);
      check::is_true(eigenvalues.size() == motions.size(),
                     name_of(kind, degree) + ": " + std::to_string(eigenvalues.size()) +
                         " modes without energy instead of " + std::to_string(motions.size()));
      check::is_close(
          eigenvalues.linfty_norm(), 0, 1e-12, name_of(kind, degree) + ": no negative eigenvalue", largest);
    }
}

ConditionData
symmetry(const std::vector<BoundaryName> &boundaries)
{
  ConditionData condition;
  condition.type       = ConditionData::Type::symmetry;
  condition.boundaries = boundaries;
  return condition;
}

// Thick-walled cylinder under inner pressure: u(r) = (1+nu)/E p a^2/(b^2-a^2) ((1-2nu) r + b^2/r).
void
check_cylinder(const unsigned int degree,
               const unsigned int refinements,
               const double       poisson,
               const double       tolerance)
{
  const double a = 1, b = 2, p = 0.3;
  Scene        scene;
  BodyData     body;
  body.name             = "it";
  body.shape            = "quarter ring";
  body.inner_radius     = a;
  body.radius           = b;
  body.refinements      = refinements;
  body.material.young   = 5;
  body.material.poisson = poisson;
  scene.bodies          = {body};
  ConditionData pressure;
  pressure.type       = ConditionData::Type::pressure;
  pressure.boundaries = {{"it", "inner", {}}};
  pressure.value[0]   = Expression(p);
  scene.conditions    = {symmetry({{"it", "cut x", {}}, {"it", "cut y", {}}}), pressure};
  const Problem<2> problem(scene, degree, 0.);
  const auto       u = problem.solve();
  for (const double r : {a, b})
    check::is_close(problem.value_at(u, Point<2>(r, 0), 0),
                    (1 + poisson) / 5 * p * a * a / (b * b - a * a) * ((1 - 2 * poisson) * r + b * b / r),
                    tolerance,
                    "cylinder under pressure, degree " + std::to_string(degree) + ", nu " +
                        std::to_string(poisson));
}

// Cook's membrane, plane strain, nearly incompressible: the literature gives the deflection 16.442 of the
// middle of the right side at E = 1.12499998125, nu = 0.499999975; here nu = 0.4999.
void
check_cook(const unsigned int degree, const unsigned int n, const double tolerance)
{
  Scene    scene;
  BodyData body;
  body.name             = "it";
  body.lower            = {0, 0, 0};
  body.upper            = {1, 1, 0};
  body.cells            = {{n, n, 1}};
  body.material.young   = 1.125;
  body.material.poisson = 0.4999;
  scene.bodies          = {body};
  ConditionData held, force;
  held.boundaries   = {{"it", "left", {}}};
  held.displacement = {{Expression(0.), Expression(0.), {}}};
  force.type        = ConditionData::Type::total_force;
  force.boundaries  = {{"it", "right", {}}};
  force.value[1]    = Expression(1.);
  scene.conditions  = {held, force};
  const Problem<2> problem(scene, degree, [](const Point<2> &p) {
    return Point<2>(48 * p[0], 44 * p[0] + p[1] * (44 - 28 * p[0]));
  });
  const auto       u = problem.solve();
  check::is_close(problem.value_at(u, Point<2>(48, 52), 1),
                  16.442,
                  tolerance,
                  "Cook's membrane, degree " + std::to_string(degree));
}

// A homogeneous displacement H X, H symmetric and small, against the law of finite strain itself: its first
// Piola-Kirchhoff stress tau(H) (1 + H)^-1 less that of small strain, per volume by r : C^-1 : r / |H|^4.
template <int dim>
void
check_neglected_stress(const ProblemType  kind,
                       const unsigned int degree,
                       const Law          type,
                       const double       poisson)
{
  const double a               = 1e-4;
  Scene        scene           = block(kind, poisson);
  scene.bodies[0].material.law = type;
  Tensor<2, 3> H;
  H[0][0] = a;
  H[1][1] = -0.5 * a;
  if (dim == 3)
    {
      H[2][2] = 0.2 * a;
      H[0][2] = H[2][0] = -0.4 * a;
      H[1][2] = H[2][1] = 0.7 * a;
    }
  if (kind == ProblemType::axisymmetric)
    H[2][2] = a;
  else
    H[0][1] = H[1][0] = 0.3 * a;
  const Problem<dim> problem(scene, degree, 0.);
  const LA::Vector   u = problem.interpolate([H](const Point<dim> &X) {
    Tensor<1, dim> v;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        v[c] += H[c][d] * X[d];
    return v;
  });

  const double          mu = 7. / 2 / (1 + poisson), lambda = 7 * poisson / (1 + poisson) / (1 - 2 * poisson);
  const auto            law    = make_law(scene.bodies[0].material);
  SymmetricTensor<2, 3> e      = symmetrize(2 * H + H * H);
  Tensor<2, 3>          strain = H;
  if (kind == ProblemType::plane_stress)
    {
      e[2][2]      = 0; // not known yet
      e[2][2]      = thickness_strain(law, e);
      H[2][2]      = std::sqrt(1 + e[2][2]) - 1;
      strain[2][2] = -lambda / (lambda + 2 * mu) * (H[0][0] + H[1][1]);
    }
  const Voigt<3> tau = kirchhoff_stress(law, e);
  Tensor<2, 3>   kirchhoff;
  for (unsigned int d = 0; d < 3; ++d)
    kirchhoff[d][d] = tau[d];
  kirchhoff[0][1] = kirchhoff[1][0] = tau[3];
  kirchhoff[0][2] = kirchhoff[2][0] = tau[4];
  kirchhoff[1][2] = kirchhoff[2][1] = tau[5];
  const Tensor<2, 3> I              = unit_symmetric_tensor<3>();
  const Tensor<2, 3> r = kirchhoff * invert(I + H) - 2 * mu * strain - lambda * trace(strain) * I;
  const double density = (r.norm_square() - lambda / (3 * lambda + 2 * mu) * trace(r) * trace(r)) / (2 * mu);
  const double volume  = kind == ProblemType::axisymmetric ? numbers::PI * (9 - 1) : 2;

  const QGauss<dim> gauss(degree + 1);
  FEValues<dim>     values(problem.discretization->mapping(),
                       problem.discretization->fe,
                       gauss,
                       ElasticityOperator<dim>::needed_flags());
  double            energy = 0;
  for (const auto &cell : problem.discretization->dof_handler.active_cell_iterators())
    {
      values.reinit(cell);
      energy += problem.elasticity->energy_of_neglected_stress(
          values, cell, u, problem.elasticity->stresses(values, cell, u));
    }
  check::is_close(energy / std::pow(a, 4),
                  density * volume / std::pow(a, 4),
                  1e-3,
                  name_of(kind, degree) + ": energy of the neglected stress, nu " + std::to_string(poisson));
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const unsigned int degree : {1, 2})
    {
      for (const ProblemType kind :
           {ProblemType::plane_strain, ProblemType::plane_stress, ProblemType::axisymmetric})
        {
          check_patch<2>(kind, degree, 0.3);
          check_patch<2>(kind, degree, kind == ProblemType::plane_stress ? 0.49 : 0.499);
          check_rigid_motions<2>(kind, degree);
          for (const double poisson : {-0.5, 0.3})
            for (const Law law : {Law::neo_hookean, Law::st_venant_kirchhoff})
              check_neglected_stress<2>(kind, degree, law, poisson);
        }
      check_neglected_stress<3>(ProblemType::three_dimensional, degree, Law::neo_hookean, 0.3);
      check_neglected_stress<3>(ProblemType::three_dimensional, degree, Law::st_venant_kirchhoff, -0.5);
      check_patch<3>(ProblemType::three_dimensional, degree, 0.3);
      check_rigid_motions<3>(ProblemType::three_dimensional, degree);
    }
  for (const double poisson : {0., 0.3, 0.4999})
    {
      check_cylinder(1, 3, poisson, 0.02);
      check_cylinder(2, 2, poisson, 1e-3);
    }
  check_cook(1, 32, 0.01);
  check_cook(2, 16, 0.002);
  return check::result();
}
} // namespace test_elasticity
