// How meshes and couplings follow the solution.
#include <amontons/contact/contact_edge.h>
#include <amontons/contact_problem.h>

namespace Amontons
{
  // Surfaces that touch in a small part of what faces each other are refined there before the first solve.
  template <int dim>
  void
  ContactProblem<dim>::refine_where_bodies_are_close()
  {
    for (unsigned int i = 0; i < parameters.refinement.initial_refinements; ++i)
      {
        TimerOutput::Scope scope(report.timer(), "mesh");
        if (mark_close_cells(*discretization, interfaces, 0.1) == 0)
          break;
        geometry.triangulation.execute_coarsening_and_refinement();
        rebuild();
      }
  }

  // Gaps that are far larger than what displacements close never matter. Of those of the nodes that are
  // closed and of what displacements closed elsewhere, the next meshes take twice the largest into account;
  // if that was not enough here, the surfaces are coupled again with more (returns true).
  template <int dim>
  bool
  ContactProblem<dim>::widen_reach()
  {
    if (finite_strain) // surfaces are searched wherever they are
      return false;
    bool too_short = false;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied || interfaces[i].pair->initial_gap)
          continue; // a declared gap says nothing about the distance of the meshes
        double needed     = 0;
        bool   any_closed = false;
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto &node   = history.state.contact[i][row.node];
            const bool  closed = node.state != ContactState::open;
            any_closed         = any_closed || closed;
            needed             = std::max(needed, closed ? std::abs(row.gap) : row.gap - node.gap);
          }
        if (!any_closed)
          continue;
        const bool short_here = reaches[i] > 0 && needed > 0.75 * reaches[i];
        if (short_here || reaches[i] == 0 || (!has_history && 4 * needed < reaches[i]))
          reaches[i] = 2 * needed + 1e-3 * interfaces[i].slave->mean_size;
        too_short = too_short || short_here;
      }
    if (too_short)
      {
        TimerOutput::Scope scope(report.timer(), "contact surfaces");
        for (unsigned int i = 0; i < interfaces.size(); ++i)
          interfaces[i].reach = reaches[i];
        integrate_couplings(*discretization, supports, interfaces);
      }
    return too_short;
  }

  template <int dim>
  bool
  ContactProblem<dim>::refine()
  {
    TimerOutput::Scope scope(report.timer(), "mesh");
    // Two aims: the stress everywhere, on which contact forces and sizes depend, and the pressure itself.
    const bool bulk = mark_cells(*discretization, geometry, parameters.refinement, error.cell_indicators);
    const bool contact =
        bulk && parameters.refinement.strategy == "adaptive" &&
        mark_cells(*discretization, geometry, parameters.refinement, error.contact_indicators);
    if (!bulk && !contact)
      {
        report.say("no further refinement: the limit of 'Maximum DoFs' is reached");
        return false;
      }
    make_traction_field();
    if (!finite_strain && parameters.refinement.history == "transfer")
      neglected.measure_gaps(*discretization, supports, interfaces);
    std::vector<LA::Vector *> moving = {
        &history.state.displacement, &history.state.traction, &history.state.committed};
    if (may_transfer())
      for (auto *vector : {&history.last_converged.displacement,
                           &history.last_converged.traction,
                           &history.last_converged.committed})
        moving.push_back(vector);
    else
      history.last_converged =
          SolutionState<dim>(); // there is none, or the history starts anew on the refined mesh
    for (auto &point : history.path)
      {
        moving.push_back(&point.displacement);
        moving.push_back(&point.traction);
      }
    refine_and_transfer(*discretization, geometry, moving, [&]() { rebuild(); });
    ++mesh_number;
    ++cycle;
    history.last_converged.contact.clear(); // of the nodes before, see go_back()
    move_surfaces();
    carry_active_set();
    return true;
  }

  // The states as a field, see SolutionState::traction. Next to the contact the trial shear is continued:
  // nodes that close there on the new mesh slip if their neighbours do.
  template <int dim>
  void
  ContactProblem<dim>::make_traction_field()
  {
    LA::Vector traction = discretization->make_owned_vector();
    history.state.peaks.clear();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto &slave = *interfaces[i].slave;
        history.state.peaks.push_back(fields[i].peak_pressure);
        const double scale = fields[i].peak_pressure > 0 ? std::pow(fields[i].peak_pressure, -2) : 0;
        const auto   edge  = signed_pressure_square(interfaces[i], fields[i]);
        std::vector<Tensor<1, dim>> shear(slave.nodes.size());
        for (const auto &row : interfaces[i].coupling.rows)
          shear[row.node] = history.state.contact[i][row.node].trial;
        auto continued = shear;
        for (const auto &face : slave.faces)
          for (const unsigned int n : face.nodes)
            if (shear[n].norm() == 0)
              for (const unsigned int other : face.nodes)
                if (shear[other].norm() > continued[n].norm())
                  continued[n] = shear[other];
        for (unsigned int n = 0; n < slave.nodes.size(); ++n)
          for (unsigned int c = 0; c < dim; ++c)
            if (const auto dof = slave.nodes[n].dofs[c]; discretization->locally_owned.is_element(dof))
              traction(dof) += scale * edge[n] * fields[i].normal[n][c] + continued[n][c];
      }
    traction.compress(VectorOperation::add);
    history.state.traction = discretization->make_relevant_vector();
    history.state.traction = traction;
  }

  // Nodes of the new mesh start closed where the old mesh's pressure, continued beyond its last node, is
  // positive; with friction they slip where the trial shear exceeds its bound.
  template <int dim>
  void
  ContactProblem<dim>::carry_active_set()
  {
    history.state.contact.clear();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        NodalContacts<dim> contact(interfaces[i].slave->nodes.size());
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto    &node = interfaces[i].slave->nodes[row.node];
            Tensor<1, dim> field;
            for (unsigned int c = 0; c < dim; ++c)
              field[c] = history.state.traction(node.dofs[c]);
            const double         edge  = field * node.normal;
            const Tensor<1, dim> shear = field - edge * node.normal;
            const bool           slips = !interfaces[i].pair->has_friction() || shear.norm() > 1;
            auto                &known = contact[row.node];
            known.has_multiplier       = true;
            known.state                = interfaces[i].pair->tied ? ContactState::stick
                                         : edge <= 0              ? ContactState::open
                                         : slips                  ? ContactState::slip
                                                                  : ContactState::stick;
            known.pressure             = history.state.peaks[i] * std::sqrt(std::max(0., edge));
            known.trial                = shear;
          }
        history.state.contact.push_back(contact);
      }
  }

  template bool
  ContactProblem<2>::widen_reach();
  template bool
  ContactProblem<3>::widen_reach();
  template bool
  ContactProblem<2>::refine();
  template bool
  ContactProblem<3>::refine();
  template void
  ContactProblem<2>::refine_where_bodies_are_close();
  template void
  ContactProblem<3>::refine_where_bodies_are_close();
} // namespace Amontons
