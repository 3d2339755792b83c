// Small bodies of distorted cells with finite strain, and derivatives along displacements by differences.
#pragma once

#include <amontons/elasticity/elasticity_operator.h>

#include <deal.II/dofs/dof_tools.h>

#include <random>
#include <set>

namespace Amontons
{
struct Case
{
  ProblemType  kind;
  unsigned int degree;
  double       poisson;
  Law          law;

  std::string
  name() const
  {
    static const std::vector<std::string> kinds = {"plane strain", "plane stress", "axisymmetric", "3D"};
    return kinds[static_cast<unsigned int>(kind)] + ", degree " + std::to_string(degree) + ", nu " +
           std::to_string(poisson) + (law == Law::neo_hookean ? ", neo-Hookean" : ", St. Venant-Kirchhoff");
  }
};

inline Scene
blocks(const Case &c, const std::array<unsigned int, 3> &cells)
{
  Scene scene;
  scene.kind = c.kind;
  BodyData body;
  body.name             = "it";
  body.lower            = {1, 0, 0};
  body.upper            = {1. + cells[0], 1. * cells[1], 1. * cells[2]};
  body.cells            = cells;
  body.material.young   = 7;
  body.material.poisson = c.poisson;
  body.material.law     = c.law;
  scene.bodies          = {body};
  return scene;
}

inline double
random(const double size)
{
  static std::mt19937 generator(1);
  return std::uniform_real_distribution<double>(-size, size)(generator);
}

// Cells of size one with moved vertices.
template <int dim>
struct Problem
{
  Problem(const Case &c, const std::array<unsigned int, 3> &cells)
      : scene(blocks(c, cells)), geometry(MPI_COMM_WORLD)
  {
    make_geometry(scene, geometry);
    std::set<unsigned int> done;
    for (const auto &cell : geometry.triangulation.active_cell_iterators())
      for (const unsigned int v : cell->vertex_indices())
        if (done.insert(cell->vertex_index(v)).second)
          for (unsigned int d = 0; d < dim; ++d)
            cell->vertex(v)[d] += random(0.15);
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, c.degree);
    discretization->distribute_dofs();
    elasticity = std::make_unique<ElasticityOperator<dim>>(*discretization, true);
    DoFTools::map_dofs_to_support_points(discretization->mapping(), discretization->dof_handler, points);
    const auto masks = DoFTools::locally_owned_dofs_per_component(discretization->dof_handler);
    for (unsigned int d = 0; d < dim; ++d)
      for (const auto dof : masks[d])
        components[dof] = d;
  }

  // value(X, c) on component c of the node at X
  LA::Vector
  field(const std::function<double(const Point<dim> &, const unsigned int)> &value) const
  {
    LA::Vector u = discretization->make_owned_vector();
    for (const auto &[dof, c] : components)
      u(dof) = value(points.at(dof), c);
    u.compress(VectorOperation::insert);
    return u;
  }

  LA::Vector
  random_field(const double size) const
  {
    return field([&](const Point<dim> &, const unsigned int) { return random(size); });
  }

  LA::Vector
  times_tangent(const LA::Vector &v) const
  {
    LA::Vector     result = discretization->make_owned_vector();
    Vector<double> local(discretization->fe.n_dofs_per_cell()), force(local.size());
    for (unsigned int c = 0; c < elasticity->n_cells(); ++c)
      {
        v.extract_subvector_to(elasticity->dofs(c).begin(), elasticity->dofs(c).end(), local.begin());
        elasticity->matrix(c).vmult(force, local);
        result.add(elasticity->dofs(c), force);
      }
    result.compress(VectorOperation::add);
    return result;
  }

  Scene                                           scene;
  Geometry<dim>                                   geometry;
  std::unique_ptr<Discretization<dim>>            discretization;
  std::unique_ptr<ElasticityOperator<dim>>        elasticity;
  std::map<types::global_dof_index, Point<dim>>   points;
  std::map<types::global_dof_index, unsigned int> components;
};

// (f(-2h) - 8 f(-h) + 8 f(h) - f(2h))/(12 h) = f'(0) of f(s)
template <typename Function>
auto
derivative(const Function &f)
{
  const double h   = 1e-4; // cells that are nearly inverted have large higher derivatives
  auto         sum = f(-2 * h);
  sum -= f(2 * h);
  auto inner = f(h);
  inner -= f(-h);
  inner *= 8;
  sum += inner;
  sum *= 1 / (12 * h);
  return sum;
}

// The same of f at u + s v
template <typename Function>
auto
derivative(const Function &f, const LA::Vector &u, const LA::Vector &v)
{
  return derivative([&](const double s) {
    LA::Vector w = u;
    w.add(s, v);
    return f(w);
  });
}
} // namespace Amontons
