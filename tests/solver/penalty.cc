// The penalty's stiffness is the derivative of its forces, and its tractions obey the laws, with and without
// multipliers of the augmented Lagrangian.
#include "contact/contact_scene.h"

#include <amontons/solver/fixed_contact.h>
#include <amontons/solver/penalty.h>

namespace test_penalty
{
template <int dim>
void
check_law(const ContactStatus status, const double friction, const bool has_multipliers)
{
  const std::string what = std::to_string(dim) + "D, " +
                           (friction == 0                    ? "frictionless"
                            : status == ContactStatus::stick ? "stick"
                                                             : "slip") +
                           (has_multipliers ? ", multipliers" : "");
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 1}, {{3, 1, 1}}),
                  block("upper", {0, 1, 0}, {1, 2, 1}, {{2, 1, 2}})};
  if (dim == 3)
    scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 1}, {{3, 2, 1}}),
                    block("upper", {0, 0, 1}, {1, 1, 2}, {{2, 1, 1}})};
  scene.pairs = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  if (friction > 0)
    scene.pairs[0].friction = Expression(friction);
  Problem<dim> problem(scene, 1);
  auto        &discretization = *problem.discretization;
  for (const auto *surface : {problem.interfaces[0].slave.get(), problem.interfaces[0].master_surface.get()})
    discretization.add_relevant(surface->dofs());

  // The upper block overlaps by 0.01 to 0.02 and has slid; before it bore a shear.
  const unsigned int up = dim - 1;
  std::mt19937       generator(1);
  const auto         random = [&]() { return generator() / double(generator.max()) - 0.5; };
  LA::Vector         u = discretization.make_owned_vector(), du = u;
  for (const auto &node : problem.slave().nodes)
    for (unsigned int c = 0; c < dim; ++c)
      u(node.dofs[c]) = (c == up ? -0.015 : 0.01) + 0.005 * random();
  for (const auto dof : discretization.locally_owned)
    du(dof) = random();
  u.compress(VectorOperation::insert);
  du.compress(VectorOperation::insert);

  SolutionState<dim> state;
  state.displacement = discretization.make_relevant_vector();
  state.displacement = u;
  state.contact      = {NodalContacts<dim>(problem.slave().nodes.size())};
  for (auto &node : state.contact[0])
    {
      node.has_multiplier = true;
      node.state          = friction == 0 ? ContactStatus::slip : status;
      node.pressure       = 1;
      node.trial[0]       = 2;
      node.shear[0]       = 0.01;
    }
  state.committed_contact            = state.contact;
  const auto                supports = discretization.make_supports(0);
  const FixedContact<dim>   contact(discretization, supports, problem.interfaces, state, 1);
  const FloatingBodies<dim> floating(discretization, supports, problem.interfaces);
  NodeStates<dim>           states(contact.nodes(), problem.interfaces, floating, 0);
  states.start(state, std::vector<bool>(contact.nodes().size(), true));
  const double                                   factor = 7;
  Penalty<dim>                                   penalty(factor, 1, contact, state);
  std::vector<typename Penalty<dim>::Multiplier> multipliers(contact.nodes().size());
  if (has_multipliers)
    {
      for (auto &multiplier : multipliers)
        {
          multiplier.pressure = 0.02;
          multiplier.shear[0] = 0.05; // instead of that before
        }
      penalty.keep(multipliers);
    }
  check::is_true(contact.nodes().size() > 2, what + ": contact nodes");

  const auto forces = [&](const unsigned int k, const double step) {
    LA::Vector moved(u), result = discretization.make_owned_vector();
    moved.add(step, du);
    state.displacement = moved;
    penalty.add_forces(k, states, result);
    result.compress(VectorOperation::add);
    state.displacement = u;
    return result;
  };
  for (unsigned int k = 0; k < contact.nodes().size(); ++k)
    {
      const auto  &node = contact.nodes()[k];
      const double eps  = factor * node.c;
      const auto   at   = penalty.answer(k, states);
      check::is_close(at.pressure,
                      multipliers[k].pressure - eps * contact.gap(k, state.displacement),
                      1e-12,
                      what + ": pressure of the overlap");
      if (friction > 0)
        {
          const Tensor<1, dim> v      = contact.slip(k, state.displacement);
          Tensor<1, dim>       before = v;
          before                      = 0;
          before[0]                   = has_multipliers ? 0.05 : 0.01;
          if (status == ContactStatus::stick)
            check::is_close((at.shear - before - eps * v).norm(), 0, 1e-12, what + ": elastic shear", 1);
          else
            {
              check::is_close(at.shear.norm(), friction * at.pressure, 1e-12, what + ": shear at its bound");
              check::is_close((at.shear - before - eps * (v - at.slip)).norm(),
                              0,
                              1e-10,
                              what + ": slip less its elastic part",
                              1);
              check::is_close(at.slip * at.shear,
                              at.slip.norm() * at.shear.norm(),
                              1e-10,
                              what + ": slip along the shear");
            }
        }
      const auto matrix  = penalty.stiffness(k, states);
      LA::Vector product = discretization.make_owned_vector(), difference = forces(k, -1e-6);
      for (unsigned int i = 0; i < matrix.rows.size(); ++i)
        for (unsigned int j = 0; j < matrix.columns.size(); ++j)
          product(matrix.rows[i]) += matrix.matrix(i, j) * du(matrix.columns[j]);
      product.compress(VectorOperation::add);
      difference -= forces(k, 1e-6);
      difference /= 2e-6;
      const double size = product.l2_norm();
      difference -= product;
      check::is_true(size > 0, what + ": stiffness");
      check::is_close(difference.l2_norm() / size, 0, 1e-7, what + ": derivative of the forces", 1);
    }
}

// An open node closes where the pressure of the overlap and the multiplier is positive.
void
check_open_node()
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {1, 1, 1}, {{3, 1, 1}}),
                  block("upper", {0, 1.01, 0}, {1, 2, 1}, {{2, 1, 2}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  Problem<2>       problem(scene, 1);
  SolutionState<2> state;
  state.displacement               = problem.discretization->make_relevant_vector();
  const auto              supports = problem.discretization->make_supports(0);
  const FixedContact<2>   contact(*problem.discretization, supports, problem.interfaces, state, 1);
  const FloatingBodies<2> floating(*problem.discretization, supports, problem.interfaces);
  NodeStates<2>           states(contact.nodes(), problem.interfaces, floating, 0);
  Penalty<2>              penalty(7, 1, contact, state);
  for (const double pressure : {0., 1., 2.}) // in units of eps times the gap
    {
      std::vector<Penalty<2>::Multiplier> multipliers(contact.nodes().size());
      for (unsigned int k = 0; k < multipliers.size(); ++k)
        multipliers[k].pressure = pressure * 7 * contact.nodes()[k].c * 0.01;
      penalty.keep(multipliers);
      for (unsigned int k = 0; k < multipliers.size(); ++k)
        {
          const auto at = penalty.answer(k, states);
          check::is_close(
              at.gap, 0.01 * (1 - pressure), 1e-12, "gap of an open node with a multiplier", 0.01);
          check::is_close(at.pressure, 0, 1e-14, "pressure of an open node", 1);
        }
    }
}

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  for (const bool has_multipliers : {false, true})
    {
      check_law<2>(ContactStatus::slip, 0, has_multipliers);
      check_law<3>(ContactStatus::slip, 0, has_multipliers);
      for (const auto status : {ContactStatus::stick, ContactStatus::slip})
        {
          check_law<2>(status, 0.3, has_multipliers);
          check_law<3>(status, 0.3, has_multipliers);
        }
    }
  check_open_node();
  return check::result();
}
} // namespace test_penalty
