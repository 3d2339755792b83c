// Small scenes for the contact tests: bodies, pairs, and the coupling of the first pair.
#pragma once

#include "check.h"

#include <amontons/contact/contact_interface.h>

#include <deal.II/base/mpi.h>

#include <random>

using namespace Amontons;

inline BodyData
block(const std::string                 &name,
      const Point<3>                    &lower,
      const Point<3>                    &upper,
      const std::array<unsigned int, 3> &cells)
{
  BodyData body;
  body.name  = name;
  body.lower = lower;
  body.upper = upper;
  body.cells = cells;
  return body;
}

inline PairData
pair_of(const BoundaryName &slave, const BoundaryName &master)
{
  PairData pair;
  pair.name   = "pair";
  pair.first  = slave;
  pair.second = master;
  pair.slave  = PairData::Slave::first;
  return pair;
}

// A body that faces an obstacle.
inline Scene
scene_with_obstacle(const BodyData &body, const std::string &boundary, ObstacleData obstacle)
{
  Scene scene;
  obstacle.name = obstacle.motion.name = "obstacle";
  scene.bodies                         = {body};
  scene.obstacles                      = {obstacle};
  scene.pairs                          = {pair_of({body.name, boundary, {}}, {})};
  scene.pairs[0].second                = {};
  scene.pairs[0].obstacle              = "obstacle";
  return scene;
}

// The coupling of the first pair of the scene, on a mesh of which some cells may be refined at random.
template <int dim>
struct Problem
{
  Problem(const Scene       &s,
          const unsigned int degree,
          const unsigned int n_refinements = 0,
          const unsigned int seed          = 1)
      : scene(s), geometry(MPI_COMM_WORLD)
  {
    scene.kind = dim == 3 ? ProblemType::three_dimensional : scene.kind;
    make_geometry(scene, geometry);
    std::mt19937 generator(seed);
    for (unsigned int i = 0; i < n_refinements; ++i)
      {
        for (const auto &cell : geometry.triangulation.active_cell_iterators())
          if (cell->material_id() < scene.bodies.size() && generator() % 4 == 0)
            cell->set_refine_flag();
        geometry.triangulation.execute_coarsening_and_refinement();
      }
    discretization = std::make_unique<Discretization<dim>>(scene, geometry, degree);
    discretization->distribute_dofs();
    interfaces = make_interfaces(*discretization, choose_slaves(*discretization));
    integrate_couplings(*discretization, discretization->make_supports(0), interfaces);
    for (const auto *surface : {interfaces[0].slave.get(), interfaces[0].master_surface.get()})
      if (surface != nullptr)
        for (const auto &node : surface->nodes)
          positions[node.dofs] = node.X;
  }

  const ContactSurface<dim> &
  slave() const
  {
    return *interfaces[0].slave;
  }

  const Coupling<dim> &
  coupling() const
  {
    return interfaces[0].coupling;
  }

  double
  total_area() const
  {
    double area = 0;
    for (const auto &row : coupling().rows)
      area += row.area;
    return area;
  }

  // int g dA = sum over the rows
  double
  gap_integral() const
  {
    double sum = 0;
    for (const auto &row : coupling().rows)
      sum += row.area * row.gap;
    return sum;
  }

  // Mean position of one side of a row.
  Tensor<1, dim>
  mean(const std::vector<std::pair<NodeDofs<dim>, double>> &side) const
  {
    Tensor<1, dim> sum;
    for (const auto &[dofs, weight] : side)
      sum += weight * Tensor<1, dim>(positions.at(dofs));
    return sum;
  }

  Scene                                scene;
  Geometry<dim>                        geometry;
  std::unique_ptr<Discretization<dim>> discretization;
  std::vector<ContactInterface<dim>>   interfaces;
  std::map<NodeDofs<dim>, Point<dim>>  positions;
};

template <int dim>
void
check_weights(const Problem<dim> &problem, const std::string &what)
{
  check::is_true(!problem.coupling().rows.empty(), what + ": there are rows");
  for (const auto &row : problem.coupling().rows)
    {
      double slave = 0, master = 0;
      for (const auto &entry : row.slave)
        slave += entry.second;
      for (const auto &entry : row.master)
        master += entry.second;
      check::is_close(slave, 1, 1e-9, what + ": slave weights");
      if (problem.interfaces[0].master.surface != nullptr)
        check::is_close(master, 1, 1e-9, what + ": master weights");
      check::is_true(row.area > 0, what + ": area");
    }
}

// On flat parallel surfaces at the distance `gap`, slave above: the mean positions lie opposite of each
// other, so that rigid translations and rotations change no gap.
template <int dim>
void
check_flat(const Problem<dim> &problem, const double area, const double gap, const std::string &what)
{
  check_weights(problem, what);
  check::is_close(problem.total_area(), area, 1e-12, what + ": total area");
  Tensor<1, dim> up;
  up[dim - 1] = 1;
  for (const auto &row : problem.coupling().rows)
    {
      const Tensor<1, dim> jump = problem.mean(row.slave) - problem.mean(row.master);
      check::is_close(row.gap, gap, 1e-10, what + ": gap", 1);
      check::is_close((row.normal + up).norm(), 0, 1e-10, what + ": normal", 1);
      check::is_close((jump - gap * up).norm(), 0, 1e-8, what + ": jump of the positions", 1);
    }
}
