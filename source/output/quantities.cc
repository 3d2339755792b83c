#include <amontons/algebra/eliminated_system.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/friction/shear_law.h>
#include <amontons/output/quantities.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int no_body = numbers::invalid_unsigned_int;

    template <int dim>
    struct Place
    {
      unsigned int body = no_body, component;
      Point<dim>   X;
    };

    // Of the owned DoFs, in their order; those of rigid bodies and carriers have no body. Finite strain:
    // where they are now.
    template <int dim>
    std::vector<Place<dim>>
    locate_dofs(const Answer<dim> &answer)
    {
      const auto                          &discretization = answer.discretization;
      const bool                           moved          = answer.elasticity.finite_strain();
      const auto                          &fe             = discretization.fe;
      const auto                          &base           = fe.base_element(0);
      const IndexSet                      &owned          = discretization.locally_owned;
      std::vector<Place<dim>>              places(owned.n_elements());
      std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
      FEValues<dim>                        values(discretization.mapping,
                           fe,
                           Quadrature<dim>(base.get_unit_support_points()),
                           update_quadrature_points);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (!cell->is_artificial() && discretization.is_deformable(cell->material_id()))
          {
            values.reinit(cell);
            cell->get_dof_indices(dofs);
            for (unsigned int i = 0; i < dofs.size(); ++i)
              if (owned.is_element(dofs[i]))
                {
                  const auto [c, node] = fe.system_to_component_index(i);
                  Point<dim> X         = values.quadrature_point(node);
                  for (unsigned int d = 0; moved && d < dim; ++d)
                    X[d] += answer.state.displacement(dofs[fe.component_to_system_index(d, node)]);
                  places[owned.index_within_set(dofs[i])] = {cell->material_id(), c, X};
                }
          }
      return places;
    }

    // Moment X x F: one component in 2D, three in 3D.
    template <int dim>
    std::vector<double>
    moment_of(const Point<dim> &X, const unsigned int c, const double force)
    {
      if (dim == 2)
        return {c == 0 ? -X[1] * force : X[0] * force};
      std::vector<double> m(3, 0.);
      m[(c + 1) % 3] += X[(c + 2) % 3] * force;
      m[(c + 2) % 3] -= X[(c + 1) % 3] * force;
      return m;
    }

    // internal - external - contact forces, on the owned DoFs in their order, what hanging nodes carry on
    // their parents; 0 where no body is
    template <int dim>
    std::vector<double>
    support_forces(const Answer<dim> &answer, const std::vector<Place<dim>> &places)
    {
      const IndexSet &owned = answer.discretization.locally_owned;
      LA::Vector      raw   = answer.elasticity.internal_forces(answer.state.displacement);
      raw -= answer.loads;
      for (const auto &[dof, force] : contact_forces(answer))
        if (owned.is_element(dof))
          raw(dof) -= force;
      raw.compress(VectorOperation::add);
      const LA::Vector condensed =
          condense(raw, answer.discretization.hanging_nodes, answer.discretization.make_owned_vector());
      std::vector<double> forces(owned.n_elements());
      unsigned int        i = 0;
      for (const auto dof : owned)
        {
          if (places[i].body != no_body)
            forces[i] = condensed(dof);
          ++i;
        }
      return forces;
    }

    // Whether the condition can exert a force along component c at a face: displacements where they are
    // prescribed, symmetry planes along their normal, platens in every direction.
    template <int dim>
    bool
    holds_component(const ConditionData                                  &condition,
                    const typename DoFHandler<dim>::active_cell_iterator &cell,
                    const unsigned int                                    f,
                    const unsigned int                                    c)
    {
      if (condition.type == ConditionData::Type::displacement)
        return condition.field || condition.displacement[c];
      if (condition.type == ConditionData::Type::platen)
        return true;
      double extent = 0, along_c = 0; // a plane normal to an axis has no extent along it
      for (unsigned int v = 1; v < cell->face(f)->n_vertices(); ++v)
        {
          const auto edge = cell->face(f)->vertex(v) - cell->face(f)->vertex(0);
          extent          = std::max(extent, edge.norm());
          along_c         = std::max(along_c, std::abs(edge[c]));
        }
      const bool axis_aligned_along_c = along_c < 1e-8 * extent;
      bool       oblique              = true;
      for (unsigned int d = 0; d < dim; ++d)
        {
          double along_d = 0;
          for (unsigned int v = 1; v < cell->face(f)->n_vertices(); ++v)
            along_d = std::max(along_d, std::abs((cell->face(f)->vertex(v) - cell->face(f)->vertex(0))[d]));
          oblique = oblique && along_d >= 1e-8 * extent;
        }
      return axis_aligned_along_c || oblique;
    }

    // How far shears exceed the bound of friction, relative to the largest bound.
    template <int dim>
    double
    cone_excess(const Answer<dim> &answer, const unsigned int i)
    {
      const auto &interface = answer.interfaces[i];
      double      excess = 0, largest = 0;
      for (unsigned int n = 0; interface.pair->has_friction() && n < interface.slave->nodes.size(); ++n)
        if (const auto &node = answer.state.contact[i][n]; node.state != ContactState::open)
          {
            const auto   X     = as_3d(interface.slave->nodes[n].X);
            const double bound = shear_bound(*interface.pair, X, answer.state.t, node.pressure).value;
            excess             = std::max(excess, node.shear.norm() - bound);
            largest            = std::max(largest, bound);
          }
      return largest > 0 ? excess / largest : 0.;
    }

    // |q/|q| - v/|v|| of the nodes that slip; slips that are nothing beside the others have no direction.
    template <int dim>
    double
    slip_misalignment(const Answer<dim> &answer, const unsigned int i)
    {
      const auto &interface = answer.interfaces[i];
      double      largest = 0, misalignment = 0;
      if (!interface.pair->has_friction())
        return 0;
      for (const auto &node : answer.state.contact[i])
        if (node.state == ContactState::slip)
          largest = std::max(largest, node.slip.norm());
      const double least = std::max(1e-3 * largest, 1e-9 * interface.slave->mean_size);
      for (const auto &node : answer.state.contact[i])
        if (node.state == ContactState::slip && node.slip.norm() > least && node.shear.norm() > 0)
          misalignment =
              std::max(misalignment, (node.shear / node.shear.norm() - node.slip / node.slip.norm()).norm());
      return misalignment;
    }

    template <int dim>
    std::string
    label(const Answer<dim> &answer, const Boundary &boundary)
    {
      return answer.discretization.scene.bodies[boundary.body].name + "/" + boundary.name;
    }
  } // namespace

  template <int dim>
  std::map<types::global_dof_index, double>
  contact_forces(const Answer<dim> &answer)
  {
    std::map<types::global_dof_index, double> forces;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      for (const auto &row : answer.interfaces[i].coupling.rows)
        {
          const auto &node = answer.state.contact[i][row.node];
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double lambda = node.pressure * row.normal[c] + node.shear[c];
              for (const auto &[dofs, weight] : row.slave)
                forces[dofs[c]] -= row.area * lambda * weight;
              for (const auto &[dofs, weight] : row.master)
                forces[dofs[c]] += row.area * lambda * weight;
            }
        }
    return forces;
  }

  template <int dim>
  std::vector<PairSummary>
  summarize_pairs(const Answer<dim> &answer)
  {
    std::vector<PairSummary> pairs;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      pairs.push_back(summarize_pair(answer.interfaces[i], answer.fields[i]));
    return pairs;
  }

  template <int dim>
  double
  stored_energy(const Answer<dim> &answer)
  {
    return answer.elasticity.stored_energy(answer.state.displacement);
  }

  template <int dim>
  std::vector<ReactionSummary>
  compute_reactions(const Answer<dim> &answer)
  {
    const auto                  &discretization = answer.discretization;
    const auto                  &fe             = discretization.fe;
    const IndexSet              &owned          = discretization.locally_owned;
    const auto                   places         = locate_dofs(answer);
    const auto                   forces         = support_forces(answer, places);
    std::vector<bool>            counted(places.size(), false);
    std::vector<ReactionSummary> reactions;

    // In the order in which discretization/supports.cc lets them take DoFs.
    using Type = ConditionData::Type;
    std::vector<const ConditionData *> conditions;
    for (const auto type : {Type::displacement, Type::symmetry, Type::platen})
      for (const auto &condition : discretization.scene.conditions)
        if (condition.type == type)
          conditions.push_back(&condition);
    for (const ConditionData *pointer : conditions)
      {
        const ConditionData &condition = *pointer;
        for (const auto &name : condition.boundaries)
          {
            const Boundary     &boundary = discretization.geometry.boundary(name, discretization.scene);
            std::vector<double> sums(dim + (dim == 2 ? 1 : 3), 0.);
            std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
            for (const auto &cell : discretization.dof_handler.active_cell_iterators())
              if (!cell->is_artificial() && cell->at_boundary())
                for (const auto f : cell->face_indices())
                  if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary.id)
                    {
                      cell->get_dof_indices(dofs);
                      for (const unsigned int i : nodes_on_face(fe.base_element(0), f))
                        for (unsigned int c = 0; c < dim; ++c)
                          {
                            const auto dof = dofs[fe.component_to_system_index(c, i)];
                            if (!owned.is_element(dof))
                              continue;
                            const auto index = owned.index_within_set(dof);
                            if (places[index].body == no_body || counted[index] ||
                                !holds_component<dim>(condition, cell, f, c))
                              continue;
                            counted[index] = true;
                            sums[c] += forces[index];
                            const auto moment = moment_of(places[index].X, c, forces[index]);
                            for (unsigned int k = 0; k < moment.size(); ++k)
                              sums[dim + k] += moment[k];
                          }
                    }
            Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
            ReactionSummary reaction;
            reaction.condition = condition.name;
            reaction.boundary  = label(answer, boundary);
            reaction.force.assign(sums.begin(), sums.begin() + dim);
            reaction.moment.assign(sums.begin() + dim, sums.end());
            reactions.push_back(reaction);
          }
      }
    return reactions;
  }

  template <int dim>
  std::map<std::string, double>
  check_physics(const Answer<dim> &answer)
  {
    std::map<std::string, double> checks;
    double penetration = 0, tension = 0, complementarity = 0, cone = 0, misalignment = 0;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      {
        if (answer.interfaces[i].pair->tied)
          continue;
        cone              = std::max(cone, cone_excess(answer, i));
        misalignment      = std::max(misalignment, slip_misalignment(answer, i));
        const double h    = answer.interfaces[i].slave->mean_size;
        double       peak = 0;
        for (const auto &node : answer.state.contact[i])
          peak = std::max(peak, node.pressure);
        for (const auto &node : answer.state.contact[i])
          {
            penetration = std::max(penetration, -node.gap / h);
            if (peak > 0)
              {
                tension         = std::max(tension, -node.pressure / peak);
                complementarity = std::max(complementarity, std::abs(node.pressure * node.gap) / (peak * h));
              }
          }
      }
    checks["penetration"]     = penetration;
    checks["tension"]         = tension;
    checks["complementarity"] = complementarity;
    if (std::any_of(answer.interfaces.begin(), answer.interfaces.end(), [](const auto &interface) {
          return interface.pair->has_friction();
        }))
      {
        checks["coulomb_cone"]   = cone;
        checks["slip_direction"] = misalignment;
      }

    // By body: the supports' forces are what is missing for equilibrium on constrained DoFs; elsewhere
    // nothing may be missing.
    const auto          places = locate_dofs(answer);
    const auto          forces = support_forces(answer, places);
    const IndexSet     &owned  = answer.discretization.locally_owned;
    std::vector<double> sums(2, 0.);
    LA::Vector          missing = answer.discretization.make_owned_vector();
    unsigned int        i       = 0;
    for (const auto dof : owned)
      missing(dof) = forces[i++];
    missing.compress(VectorOperation::insert);
    const LA::Vector condensed =
        condense(missing, answer.supports, answer.discretization.make_owned_vector());
    i                             = 0;
    const unsigned int  n_moments = dim == 2 ? 1 : 3, n_bodies = answer.discretization.scene.bodies.size();
    std::vector<double> moments(n_bodies * n_moments, 0.), levers(n_bodies, 0.);
    for (const auto dof : owned)
      {
        const Place<dim> &place = places[i++];
        if (place.body == no_body)
          continue;
        const double value = condensed(dof);
        sums[1] += std::pow(answer.loads(dof), 2) + value * value;
        if (answer.supports.is_constrained(dof))
          continue;
        sums[0] += value * value;
        const auto moment = moment_of(place.X, place.component, value);
        for (unsigned int k = 0; k < n_moments; ++k)
          moments[place.body * n_moments + k] += moment[k];
      }
    for (const auto &[dof, force] : contact_forces(answer))
      if (owned.is_element(dof))
        {
          sums[1] += force * force;
          if (const auto body = places[owned.index_within_set(dof)].body; body != no_body)
            levers[body] += std::abs(force) * answer.discretization.geometry.body_sizes[body];
        }
    Utilities::MPI::sum(moments, answer.discretization.geometry.communicator, moments);
    Utilities::MPI::sum(levers, answer.discretization.geometry.communicator, levers);
    checks["moment_balance"] = 0;
    for (unsigned int b = 0; b < n_bodies; ++b)
      for (unsigned int k = 0; k < n_moments && levers[b] > 0; ++k)
        checks["moment_balance"] =
            std::max(checks["moment_balance"], std::abs(moments[b * n_moments + k]) / levers[b]);
    Utilities::MPI::sum(sums, answer.discretization.geometry.communicator, sums);
    const double rounding   = 1e-12 * answer.elasticity.rounding_scale(answer.state.displacement);
    checks["force_balance"] = sums[1] > 0 ? std::sqrt(sums[0] / std::max(sums[1], rounding * rounding)) : 0;
    return checks;
  }

  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<2> &);
  template std::vector<PairSummary>
  summarize_pairs(const Answer<2> &);
  template double
  stored_energy(const Answer<2> &);
  template std::vector<ReactionSummary>
  compute_reactions(const Answer<2> &);
  template std::map<std::string, double>
  check_physics(const Answer<2> &);
  template std::map<types::global_dof_index, double>
  contact_forces(const Answer<3> &);
  template std::vector<PairSummary>
  summarize_pairs(const Answer<3> &);
  template double
  stored_energy(const Answer<3> &);
  template std::vector<ReactionSummary>
  compute_reactions(const Answer<3> &);
  template std::map<std::string, double>
  check_physics(const Answer<3> &);
} // namespace Amontons
