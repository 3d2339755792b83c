#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/output/approach.h>
#include <amontons/output/nodal_forces.h>
#include <amontons/output/quantities.h>

#include <deal.II/base/quadrature_lib.h>

namespace Amontons
{
  namespace
  {
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

    template <int dim>
    std::string
    label(const Answer<dim> &answer, const Boundary &boundary)
    {
      return answer.discretization.scene.bodies[boundary.body].name + "/" + boundary.name;
    }
  } // namespace

  template <int dim>
  std::vector<PairSummary>
  summarize_pairs(const Answer<dim> &answer)
  {
    std::vector<PairSummary> pairs;
    for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
      {
        const auto &interface = answer.interfaces[i];
        pairs.push_back(summarize_pair(
            interface,
            answer.fields[i],
            SurfaceApproach<dim>(answer.discretization, interface, answer.state.displacement)));
        pairs.back().approach = compute_approach(answer, i);
      }
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

  template std::vector<PairSummary>
  summarize_pairs(const Answer<2> &);
  template double
  stored_energy(const Answer<2> &);
  template std::vector<ReactionSummary>
  compute_reactions(const Answer<2> &);
  template std::vector<PairSummary>
  summarize_pairs(const Answer<3> &);
  template double
  stored_energy(const Answer<3> &);
  template std::vector<ReactionSummary>
  compute_reactions(const Answer<3> &);
} // namespace Amontons
