// Surfaces moved by given displacements, and the derivatives of their coupling against central differences.
#pragma once

#include "contact/contact_scene.h"

#include <amontons/contact/coupling_derivatives.h>

#include <chrono>

// A coupling of the first pair that is integrated where a displacement puts the surfaces.
template <int dim>
class Moved
{
public:
  Moved(Problem<dim> &problem) : problem(problem), u(problem.discretization->locally_owned, MPI_COMM_WORLD)
  {
    const auto &interface = problem.interfaces[0];
    for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
      if (surface != nullptr)
        {
          problem.discretization->add_relevant(surface->dofs());
          for (const auto &node : surface->nodes)
            dofs.insert(node.dofs.begin(), node.dofs.end());
        }
    if (interface.master_surface == nullptr)
      for (const auto &corner : problem.discretization->carrier_dofs[interface.master.carrier])
        dofs.insert(corner.begin(), corner.end());
    supports = problem.discretization->make_supports(0);
  }

  static void
  add(LA::Vector &displacement, const types::global_dof_index dof, const double value)
  {
    if (displacement.in_local_range(dof))
      displacement(dof) += value;
  }

  // Hanging nodes follow.
  void
  displace_at_random(const double amplitude, std::mt19937 &generator)
  {
    std::uniform_real_distribution<double> number(-amplitude, amplitude);
    for (const auto dof : dofs)
      add(u, dof, number(generator));
    u.compress(VectorOperation::add);
    problem.discretization->hanging_nodes.distribute(u);
  }

  LA::Vector
  readable(const LA::Vector &displacement) const
  {
    auto result = problem.discretization->make_relevant_vector();
    result      = displacement;
    return result;
  }

  const ContactInterface<dim> &
  at(LA::Vector displacement)
  {
    displacement.compress(VectorOperation::add);
    move_interface(*problem.discretization, readable(displacement), problem.interfaces[0]);
    integrate_couplings(*problem.discretization, supports, problem.interfaces, true);
    return problem.interfaces[0];
  }

  Problem<dim>                     &problem;
  LA::Vector                        u;
  std::set<types::global_dof_index> dofs; // of both sides

private:
  Constraints supports;
};

// Forces with fixed tractions (by row), by DoF.
template <int dim>
Gradient
contact_forces(const Coupling<dim> &coupling, const std::vector<Tensor<1, dim>> &tractions)
{
  Gradient forces;
  for (unsigned int r = 0; r < coupling.rows.size(); ++r)
    {
      const auto &row = coupling.rows[r];
      for (unsigned int c = 0; c < dim; ++c)
        {
          for (const auto &[dofs, weight] : row.slave)
            forces[dofs[c]] += row.area * tractions[r][c] * weight;
          for (const auto &[dofs, weight] : row.master)
            forces[dofs[c]] -= row.area * tractions[r][c] * weight;
        }
    }
  return forces;
}

// Largest deviations by kind, relative to the largest derivative of that kind.
struct Deviation
{
  void
  compare(const double derivative, const double difference)
  {
    scale    = std::max(scale, std::abs(difference));
    absolute = std::max(absolute, std::abs(derivative - difference));
  }

  double
  relative() const
  {
    return absolute / scale;
  }

  double scale = 0, absolute = 0;
};

inline double
along(const Gradient &gradient, const Coefficients &direction)
{
  double sum = 0;
  for (const auto &[dof, value] : direction)
    if (const auto entry = gradient.find(dof); entry != gradient.end())
      sum += value * entry->second;
  return sum;
}

// Along `n_single` single DoFs chosen at random (0: all) and three random directions.
template <int dim>
void
check_derivatives(Moved<dim>        &moved,
                  const double       length,
                  const unsigned int n_single,
                  std::mt19937      &generator,
                  const std::string &what,
                  const double       tolerance = 1e-6)
{
  std::uniform_real_distribution<double> number(-1, 1);
  const auto                            &interface = moved.at(moved.u);
  const Coupling<dim>                    coupling  = interface.coupling;
  std::vector<Tensor<1, dim>>            tractions(coupling.rows.size());
  for (auto &t : tractions)
    for (unsigned int c = 0; c < dim; ++c)
      t[c] = number(generator);
  const auto                     begin = std::chrono::steady_clock::now();
  const CouplingDerivatives<dim> derivatives(
      *moved.problem.discretization, interface, std::vector<bool>(coupling.rows.size(), true));
  std::map<types::global_dof_index, Gradient> mine, stiffness; // by DoF of the force
  for (const auto &part : derivatives.stiffness(tractions))
    for (unsigned int i = 0; i < part.rows.size(); ++i)
      for (unsigned int j = 0; j < part.columns.size(); ++j)
        if (part.matrix(i, j) != 0)
          mine[part.rows[i]][part.columns[j]] += part.matrix(i, j);
  for (const auto &part : Utilities::MPI::all_gather(MPI_COMM_WORLD, mine))
    for (const auto &[dof, row] : part)
      for (const auto &[column, value] : row)
        stiffness[dof][column] += value;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();

  std::vector<bool> first_only(coupling.rows.size(), false);
  first_only[0] = true;
  const CouplingDerivatives<dim> of_one(*moved.problem.discretization, interface, first_only);
  check::is_true(of_one.rows()[0].gap == derivatives.rows()[0].gap, what + ": a row on its own");
  for (unsigned int r = 1; r < coupling.rows.size(); ++r)
    check::is_true(of_one.rows()[r].gap.empty() && of_one.rows()[r].area.empty(), what + ": rows not wanted");

  std::vector<types::global_dof_index> singles(moved.dofs.begin(), moved.dofs.end());
  std::shuffle(singles.begin(), singles.end(), generator);
  if (n_single > 0)
    singles.resize(std::min<std::size_t>(n_single, singles.size()));
  std::vector<Coefficients> directions;
  for (const auto dof : singles)
    directions.push_back({{dof, 1.}});
  for (unsigned int i = 0; i < 3; ++i)
    {
      directions.emplace_back();
      for (const auto dof : moved.dofs)
        directions.back()[dof] = number(generator);
    }

  Deviation    gaps, normals, areas, forces;
  const double h = 2e-6 * length;
  for (const auto &direction : directions)
    {
      std::array<Coupling<dim>, 2> sides;
      for (const unsigned int side : {0, 1})
        {
          LA::Vector u = moved.u;
          for (const auto &[dof, value] : direction)
            moved.add(u, dof, (side == 0 ? -h : h) * value);
          sides[side] = moved.at(u).coupling;
        }
      const auto difference = [&](const double above, const double below) {
        return (above - below) / (2 * h);
      };
      for (unsigned int r = 0; r < coupling.rows.size(); ++r)
        {
          const auto &row = derivatives.rows()[r];
          const auto &a = sides[0].rows.at(r), &b = sides[1].rows.at(r);
          check::is_true(a.node == coupling.rows[r].node && b.node == a.node, what + ": the same rows");
          // without the lower bound of gaps that are open all around
          gaps.compare(along(row.gap, direction),
                       difference(b.normal * b.gap_vector, a.normal * a.gap_vector));
          areas.compare(along(row.area, direction), difference(b.area, a.area));
          for (unsigned int c = 0; c < dim; ++c)
            normals.compare(along(row.normal[c], direction), difference(b.normal[c], a.normal[c]));
        }
      const auto below = contact_forces(sides[0], tractions), above = contact_forces(sides[1], tractions);
      for (const auto dof : moved.dofs)
        {
          const auto value = [&](const Gradient &f) { return f.count(dof) > 0 ? f.at(dof) : 0.; };
          forces.compare(stiffness.count(dof) > 0 ? along(stiffness[dof], direction) : 0,
                         difference(value(above), value(below)));
        }
    }
  std::set<unsigned int> faces;
  for (const auto &p : coupling.points)
    faces.insert(p.slave_face);
  std::cout << what << ": " << coupling.rows.size() << " rows, deviations of gaps " << gaps.relative()
            << ", normals " << normals.relative() << ", areas " << areas.relative() << ", forces "
            << forces.relative() << "; " << 1e3 * seconds / faces.size() << " ms per slave face" << std::endl;
  for (const auto &[kind, deviation] : std::map<std::string, Deviation>{
           {"gap", gaps}, {"normal", normals}, {"area", areas}, {"force", forces}})
    {
      check::is_true(deviation.scale > 0, what + ": the " + kind + " changes");
      check::is_close(deviation.relative(), 0, tolerance, what + ": derivative of the " + kind, 1);
    }
}

// Gaps, areas and weights do not change with a rigid rotation by 40 degrees; normals turn.
template <int dim>
void
check_rotation(Moved<dim> &moved, const double length, const std::string &what)
{
  const Coupling<dim> before = moved.at(moved.u).coupling;
  const double        angle  = 40 * numbers::PI / 180;
  Tensor<2, dim>      R      = unit_symmetric_tensor<dim>();
  for (unsigned int axis = 0; axis < dim - 1; ++axis) // about z, in space then about x
    {
      Tensor<2, dim> turn = unit_symmetric_tensor<dim>();
      turn[axis][axis] = turn[axis + 1][axis + 1] = std::cos(angle);
      turn[axis + 1][axis]                        = std::sin(angle);
      turn[axis][axis + 1]                        = -std::sin(angle);
      R                                           = turn * R;
    }
  const auto      &interface = moved.problem.interfaces[0];
  const LA::Vector old       = moved.readable(moved.u);
  LA::Vector       u         = moved.u;
  const auto       turn      = [&](const NodeDofs<dim> &dofs, const Point<dim> &X) {
    Point<dim> x;
    for (unsigned int c = 0; c < dim; ++c)
      x[c] = X[c] + old(dofs[c]);
    const Tensor<1, dim> change = R * x - x;
    for (unsigned int c = 0; c < dim; ++c)
      moved.add(u, dofs[c], change[c]);
  };
  for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
    if (surface != nullptr)
      for (const auto &node : surface->nodes)
        turn(node.dofs, node.X);
  if (interface.master_surface == nullptr)
    {
      const auto &carrier = moved.problem.geometry.carriers[interface.master.carrier];
      const auto &dofs    = moved.problem.discretization->carrier_dofs[interface.master.carrier];
      Point<dim>  corner;
      for (unsigned int d = 0; d < dim; ++d)
        corner[d] = carrier.motion.reference[d];
      for (unsigned int k = 0; k <= dim; ++k)
        turn(dofs[k], k == 0 ? corner : corner + carrier.size * Point<dim>::unit_vector(k - 1));
    }
  u.compress(VectorOperation::add);
  const Coupling<dim> after = moved.at(u).coupling;
  check::is_true(after.rows.size() == before.rows.size() && !before.rows.empty(), what + ": turned rows");
  for (unsigned int r = 0; r < before.rows.size(); ++r)
    {
      const auto &a = before.rows[r], &b = after.rows[r];
      check::is_close(b.gap, a.gap, 1e-12, what + ": turned gap", length);
      check::is_close(b.area, a.area, 1e-12, what + ": turned area", std::pow(length, dim - 1));
      check::is_close((b.normal - R * a.normal).norm(), 0, 1e-12, what + ": turned normal", 1);
      check::is_true(b.slave.size() == a.slave.size() && b.master.size() == a.master.size(),
                     what + ": turned weights");
      for (unsigned int k = 0; k < a.slave.size(); ++k)
        check::is_close(b.slave[k].second, a.slave[k].second, 1e-12, what + ": turned slave weights", 1);
      for (unsigned int k = 0; k < a.master.size(); ++k)
        check::is_close(b.master[k].second, a.master[k].second, 1e-12, what + ": turned master weights", 1);
    }
}
