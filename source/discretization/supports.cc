// What the scene prescribes about displacements, as affine constraints.
#include <amontons/base/points.h>
#include <amontons/discretization/discretization.h>
#include <amontons/discretization/elimination.h>

#include <deal.II/fe/fe_values.h>
#include <deal.II/physics/transformations.h>

namespace Amontons
{
  namespace
  {
    using Terms = std::vector<std::pair<types::global_dof_index, double>>;

    // Unless the DoF is constrained already.
    void
    tie(Constraints &constraints, const types::global_dof_index dof, const Terms &terms, const double value)
    {
      if (!constraints.can_store_line(dof) || constraints.is_constrained(dof))
        return;
      constraints.add_line(dof);
      constraints.add_entries(dof, terms);
      constraints.set_inhomogeneity(dof, value);
    }

    // Calls action(dofs of the node by component, position, unit normal of the face there) for every node of
    // every face of `boundary`.
    template <int dim, typename Action>
    void
    for_each_node_on(const Discretization<dim> &discretization,
                     const types::boundary_id   boundary,
                     const Action              &action)
    {
      const auto                              &fe   = discretization.fe;
      const auto                              &base = fe.base_element(0);
      std::vector<types::global_dof_index>     dofs(fe.n_dofs_per_cell());
      std::array<types::global_dof_index, dim> node;
      FEValues<dim>                            values(discretization.mapping(),
                           fe,
                           Quadrature<dim>(base.get_unit_support_points()),
                           update_quadrature_points | update_inverse_jacobians);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (!cell->is_artificial() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() && cell->face(f)->boundary_id() == boundary)
              {
                cell->get_dof_indices(dofs);
                values.reinit(cell);
                for (const unsigned int i : nodes_on_face(base, f))
                  {
                    for (unsigned int c = 0; c < dim; ++c)
                      node[c] = dofs[fe.component_to_system_index(c, i)];
                    Tensor<1, dim> normal; // J^-T N
                    const double   sign = f % 2 == 1 ? 1 : -1;
                    for (unsigned int d = 0; d < dim; ++d)
                      normal[d] = sign * values.inverse_jacobian(i)[f / 2][d];
                    action(node, values.quadrature_point(i), normal / normal.norm());
                  }
              }
    }

    // Lines of relevant DoFs of other ranks, from their owners.
    // (AffineConstraints::make_consistent_in_parallel of deal.II 9.4 searches all lines for every such DoF.)
    void
    add_lines_of_others(Constraints    &own,
                        const IndexSet &locally_owned,
                        const IndexSet &relevant,
                        const MPI_Comm  communicator)
    {
      using Dofs    = std::vector<types::global_dof_index>;
      using Entries = std::vector<std::pair<types::global_dof_index, double>>;
      using Line    = std::pair<std::pair<types::global_dof_index, double>, Entries>;

      IndexSet others = relevant;
      others.subtract_set(locally_owned);
      const auto owners = Utilities::MPI::compute_index_owner(locally_owned, others, communicator);

      std::map<unsigned int, Dofs> wanted;
      unsigned int                 i = 0;
      for (const auto dof : others)
        wanted[owners[i++]].push_back(dof);
      std::map<unsigned int, std::vector<Line>> answers;
      for (const auto &[rank, dofs] : Utilities::MPI::some_to_some(communicator, wanted))
        for (const auto dof : dofs)
          if (own.is_constrained(dof))
            answers[rank].push_back({{dof, own.get_inhomogeneity(dof)}, *own.get_constraint_entries(dof)});
      for (const auto &[rank, lines] : Utilities::MPI::some_to_some(communicator, answers))
        for (const auto &[dof, entries] : lines)
          {
            own.add_line(dof.first);
            own.add_entries(dof.first, entries);
            own.set_inhomogeneity(dof.first, dof.second);
          }
    }

    // Columns R e_k of the rotation by theta (about theta, by its length).
    template <int dim>
    Tensor<2, 3>
    turned_axes(const MotionData &motion, const double t)
    {
      Point<3> theta;
      for (unsigned int k = dim == 2 ? 2 : 0; k < 3; ++k)
        {
          if (!motion.rotation[k])
            throw InputError(motion.where,
                             "a free rotation, which finite strain does not have",
                             "'Rotation' given or left out (held); or a meshed body instead");
          theta[k] = motion.rotation[k]->value(motion.reference, t);
        }
      const double angle = theta.norm();
      if (angle == 0)
        return unit_symmetric_tensor<3>();
      return Physics::Transformations::Rotations::rotation_matrix_3d(Point<3>(theta / angle), angle);
    }
  } // namespace

  template <int dim>
  Constraints
  Discretization<dim>::make_supports(const double t) const
  {
    Constraints constraints(relevant);
    for (const auto &line : hanging_nodes.get_lines())
      {
        constraints.add_line(line.index);
        constraints.add_entries(line.index, line.entries);
      }
    constrain_carriers(constraints, t);
    constrain_rigid_bodies(constraints);
    for (const auto &condition : scene.conditions)
      if (condition.type == ConditionData::Type::displacement)
        constrain_displacement(constraints, condition, t);
    for (const auto &condition : scene.conditions)
      if (condition.type == ConditionData::Type::symmetry)
        constrain_symmetry(constraints, condition);
    for (const auto &condition : scene.conditions)
      if (condition.type == ConditionData::Type::platen)
        constrain_platen(constraints, condition);
    if (scene.kind == ProblemType::axisymmetric) // u_r = 0 on the axis
      {
        const auto                          &base = fe.base_element(0);
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
        for (const auto &cell : dof_handler.active_cell_iterators())
          if (!cell->is_artificial() && cell->at_boundary() && is_deformable(cell->material_id()))
            for (const unsigned int f : cell->face_indices())
              if (cell->face(f)->at_boundary() &&
                  std::abs(cell->face(f)->center()[0]) < 1e-10 * cell->diameter())
                {
                  cell->get_dof_indices(dofs);
                  for (const unsigned int i : nodes_on_face(base, f))
                    {
                      const auto dof = dofs[fe.component_to_system_index(0, i)];
                      if (!constraints.is_constrained(dof))
                        constraints.add_line(dof);
                    }
                }
      }
    for (const auto &turn : free_turns)
      tie(constraints, turn.second, {{turn.first, 1.}}, 0);
    for (const auto &slide : free_slides)
      for (const auto &[first, second, sign] : slide.held)
        if (finite_strain)
          tie(constraints, second, first == second ? Terms() : Terms{{first, sign}}, 0);
    // Ranks that see only part of a node's faces may have chosen another DoF to eliminate; the owner of a DoF
    // sees all of them.
    Constraints own(relevant);
    for (const auto &line : constraints.get_lines())
      if (locally_owned.is_element(line.index))
        {
          own.add_line(line.index);
          own.add_entries(line.index, line.entries);
          own.set_inhomogeneity(line.index, line.inhomogeneity);
        }
    add_lines_of_others(own, locally_owned, relevant, geometry.communicator);
    own.close();
    return own;
  }

  // With A the corner at the reference point, B, C, D at distance s along x, y, z, finite strain:
  //   u_B = u_A + s (R - 1) e_x, ..., where R turns by the prescribed rotation vector theta. Small strain:
  //   u_B = u_A + s theta x e_x = u_A + s (0, theta_z, -theta_y),   u_C = u_A + s (-theta_z, 0, theta_x),
  //   u_D = u_A + s (theta_y, -theta_x, 0).
  // A free rotation is carried by B_y (theta_z), B_z (theta_y) and C_z (theta_x).
  template <int dim>
  void
  Discretization<dim>::constrain_carriers(Constraints &constraints, const double t) const
  {
    const auto tie = [&](const types::global_dof_index dof, const Terms &terms, const double value) {
      Amontons::tie(constraints, dof, terms, value);
    };
    const bool axisymmetric = scene.kind == ProblemType::axisymmetric;

    for (unsigned int m = 0; m < carrier_dofs.size(); ++m)
      {
        const MotionData &motion = geometry.carriers[m].motion;
        const double      s      = geometry.carriers[m].size;
        const auto       &u      = carrier_dofs[m];
        for (unsigned int c = 0; c < dim; ++c)
          {
            if (axisymmetric && c == 0)
              tie(u[0][c], {}, 0);
            else if (motion.displacement[c])
              tie(u[0][c], {}, motion.displacement[c]->value(motion.reference, t));
          }
        if (axisymmetric || finite_strain)
          {
            const Tensor<2, 3> turned =
                axisymmetric ? Tensor<2, 3>(unit_symmetric_tensor<3>()) : turned_axes<dim>(motion, t);
            for (unsigned int k = 0; k < dim; ++k)
              for (unsigned int c = 0; c < dim; ++c)
                tie(u[k + 1][c], {{u[0][c], 1.}}, s * (turned[c][k] - double(c == k)));
            continue;
          }
        for (unsigned int c = 0; c < dim; ++c)
          tie(u[c + 1][c], {{u[0][c], 1.}}, 0);

        // theta about `axis`: u[k+1][c] = u[0][c] + sign s theta for (k, c, sign) and its opposite.
        struct Rotation
        {
          unsigned int axis, k, c;
          double       sign;
          unsigned int opposite_k, opposite_c;
        };
        const std::vector<Rotation> rotations =
            dim == 2 ? std::vector<Rotation>{{2, 1, 1, 1., 2, 0}}
                     : std::vector<Rotation>{{2, 1, 1, 1., 2, 0}, {1, 1, 2, -1., 3, 0}, {0, 2, 2, 1., 3, 1}};
        for (const auto &r : rotations)
          {
            const auto dof = u[r.k][r.c], opposite = u[r.opposite_k][r.opposite_c];
            const auto origin = u[0][r.c], opposite_origin = u[0][r.opposite_c];
            if (motion.rotation[r.axis])
              {
                const double theta = motion.rotation[r.axis]->value(motion.reference, t);
                tie(dof, {{origin, 1.}}, r.sign * s * theta);
                tie(opposite, {{opposite_origin, 1.}}, -r.sign * s * theta);
              }
            else
              tie(opposite, {{opposite_origin, 1.}, {dof, -1.}, {origin, 1.}}, 0);
          }
      }
    constrain_carrier_cells(constraints);
  }

  // The other nodes of the carrier cells follow their corners.
  template <int dim>
  void
  Discretization<dim>::constrain_carrier_cells(Constraints &constraints) const
  {
    const auto                          &base = fe.base_element(0);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && geometry.is_carrier(cell->material_id()))
        {
          const unsigned int m = cell->material_id() - scene.bodies.size();
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < base.n_dofs_per_cell(); ++i)
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto dof    = dofs[fe.component_to_system_index(c, i)];
                bool       corner = false;
                for (unsigned int k = 0; k <= dim; ++k)
                  corner = corner || dof == carrier_dofs[m][k][c];
                if (corner)
                  continue;
                const Point<dim> xi = base.unit_support_point(i);
                Terms            terms;
                double           first = 1;
                for (unsigned int k = 0; k < dim; ++k)
                  {
                    if (xi[k] != 0)
                      terms.emplace_back(carrier_dofs[m][k + 1][c], xi[k]);
                    first -= xi[k];
                  }
                if (first != 0)
                  terms.emplace_back(carrier_dofs[m][0][c], first);
                tie(constraints, dof, terms, 0);
              }
        }
  }

  template <int dim>
  void
  Discretization<dim>::constrain_rigid_bodies(Constraints &constraints) const
  {
    const auto                          &base = fe.base_element(0);
    std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
    FEValues<dim>                        values(
        mapping(), fe, Quadrature<dim>(base.get_unit_support_points()), update_quadrature_points);
    for (const auto &cell : dof_handler.active_cell_iterators())
      if (!cell->is_artificial() && !geometry.is_carrier(cell->material_id()) &&
          !is_deformable(cell->material_id()))
        {
          const unsigned int m = carrier_of_body[cell->material_id()];
          values.reinit(cell);
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < base.n_dofs_per_cell(); ++i)
            {
              const auto weights = carrier_weights(m, values.quadrature_point(i));
              for (unsigned int c = 0; c < dim; ++c)
                {
                  const auto dof = dofs[fe.component_to_system_index(c, i)];
                  if (constraints.is_constrained(dof))
                    continue;
                  constraints.add_line(dof);
                  for (unsigned int k = 0; k <= dim; ++k)
                    constraints.add_entry(dof, carrier_dofs[m][k][c], weights[k]);
                }
            }
        }
  }

  template <int dim>
  void
  Discretization<dim>::constrain_platen(Constraints &constraints, const ConditionData &condition) const
  {
    const unsigned int m = geometry.carrier(condition.motion->name);
    for (const auto &name : condition.boundaries)
      for_each_node_on(
          *this, geometry.boundary(name, scene).id, [&](const auto &node, const auto &X, const auto &) {
            const auto weights = carrier_weights(m, X);
            for (unsigned int c = 0; c < dim; ++c)
              if (!constraints.is_constrained(node[c]))
                {
                  constraints.add_line(node[c]);
                  for (unsigned int k = 0; k <= dim; ++k)
                    if (weights[k] != 0)
                      constraints.add_entry(node[c], carrier_dofs[m][k][c], weights[k]);
                }
          });
  }

  template <int dim>
  void
  Discretization<dim>::constrain_displacement(Constraints         &constraints,
                                              const ConditionData &condition,
                                              const double         t) const
  {
    for (const auto &name : condition.boundaries)
      {
        const Boundary                               &boundary = geometry.boundary(name, scene);
        std::function<Tensor<1, 3>(const Point<3> &)> field;
        if (condition.field)
          field = [t,
                   of_time = scene.boundary_fields.displacement(
                       *condition.field, scene.bodies[boundary.body].material, scene.kind)](
                      const Point<3> &p) { return of_time(p, t); };
        for_each_node_on(*this, boundary.id, [&](const auto &node, const auto &X, const auto &) {
          const Point<3> p = as_3d(X);
          if (field && !std::isfinite(field(p).norm()))
            throw InputError(condition.field->where,
                             "the field is not finite at (" + std::to_string(p[0]) + ", " +
                                 std::to_string(p[1]) + ")",
                             "a field that is regular on the boundary");
          for (unsigned int c = 0; c < dim; ++c)
            if ((field || condition.displacement[c]) && !constraints.is_constrained(node[c]))
              {
                constraints.add_line(node[c]);
                constraints.set_inhomogeneity(node[c],
                                              field ? field(p)[c] : condition.displacement[c]->value(p, t));
              }
        });
      }
  }

  // u . n = 0 with the normal of each plane, so that edges and corners between planes are held by each of
  // them.
  template <int dim>
  void
  Discretization<dim>::constrain_symmetry(Constraints &constraints, const ConditionData &condition) const
  {
    for (const auto &name : condition.boundaries)
      for_each_node_on(
          *this, geometry.boundary(name, scene).id, [&](const auto &node, const auto &, const auto &normal) {
            LinearEquation equation;
            for (unsigned int c = 0; c < dim; ++c)
              if (std::abs(normal[c]) > 1e-10)
                equation.coefficients[node[c]] = normal[c];
            substitute(equation, constraints);
            const std::vector<types::global_dof_index> own(node.begin(), node.end());
            if (const auto pivot = choose_pivot(equation, constraints, own))
              eliminate(equation, *pivot, constraints);
          });
  }

  template Constraints
  Discretization<2>::make_supports(const double) const;
  template Constraints
  Discretization<3>::make_supports(const double) const;
} // namespace Amontons
