#include <amontons/base/points.h>
#include <amontons/elasticity/boundary_faces.h>
#include <amontons/elasticity/kinematics.h>
#include <amontons/elasticity/load_values.h>
#include <amontons/elasticity/loads.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    class LoadAssembly
    {
    public:
      LoadAssembly(const Discretization<dim>            &discretization,
                   const double                          t,
                   const std::vector<CoveredPoint<dim>> &covered,
                   const LA::Vector                     *u)
          : discretization(discretization), kind(discretization.scene.kind), t(t), covered(covered), u(u),
            loads(discretization.make_owned_vector()),
            face_values(discretization,
                        QGauss<dim - 1>(discretization.fe.degree + 2),
                        update_values | update_quadrature_points | update_JxW_values | update_normal_vectors |
                            gradients_of_u()),
            dofs(discretization.fe.n_dofs_per_cell())
      {
      }

      LA::Vector
      run()
      {
        add_body_forces();
        for (const auto &condition : discretization.scene.conditions)
          add_condition(condition);
        if (Utilities::MPI::this_mpi_process(discretization.geometry.communicator) == 0)
          add_motion_forces();
        loads.compress(VectorOperation::add);
        return loads;
      }

    private:
      // f_i += weight force . phi_i(q)
      void
      add_point_force(const FEValuesBase<dim> &values, const unsigned int q, const Tensor<1, dim> &force)
      {
        for (unsigned int i = 0; i < dofs.size(); ++i)
          {
            const double value =
                force[discretization.fe.system_to_component_index(i).first] * values.shape_value(i, q);
            if (value != 0)
              loads(dofs[i]) += value;
          }
      }

      template <typename Values>
      void
      add_dead_load(const LoadOn<Values> &on, const double factor)
      {
        for (unsigned int q = 0; q < on.load.size(); ++q)
          {
            Tensor<1, dim> force;
            for (unsigned int d = 0; d < dim; ++d)
              force[d] = factor * weight(on.values, q) * on.load[q][d];
            add_point_force(on.values, q, force);
          }
      }

      void
      add_body_forces()
      {
        LoadCellValues<dim> cell_values(discretization,
                                        QGauss<dim>(discretization.fe.degree + 1),
                                        update_values | update_quadrature_points | update_JxW_values);
        for (unsigned int body = 0; body < discretization.scene.bodies.size(); ++body)
          {
            const auto &force = discretization.scene.bodies[body].body_force;
            if (!discretization.is_deformable(body) ||
                (force[0].is_zero() && force[1].is_zero() && force[2].is_zero()))
              continue;
            const auto for_each_cell = [&](const auto &action) {
              for (const auto &cell : discretization.dof_handler.active_cell_iterators())
                if (cell->is_locally_owned() && cell->material_id() == body)
                  action(cell);
            };
            cell_values.measure(force, t, for_each_cell);
            for_each_cell([&](const auto &cell) {
              cell->get_dof_indices(dofs);
              add_dead_load(cell_values.reinit(force, t, cell), 1);
            });
          }
      }

      void
      add_condition(const ConditionData &condition)
      {
        using Type = ConditionData::Type;
        if (condition.type != Type::traction && condition.type != Type::pressure &&
            condition.type != Type::total_force)
          return;
        double area = 1;
        if (condition.type == Type::total_force)
          area = total_area(condition);
        if (!(area > 0))
          throw InputError(
              condition.where, "a total force on a boundary without area", "a boundary off the axis");
        for (const auto &name : condition.boundaries)
          {
            const auto id = discretization.geometry.boundary(name, discretization.scene).id;
            face_values.measure(
                condition.value, t, [&](const auto &action) { for_each_face(discretization, id, action); });
            for_each_face(discretization, id, [&](const auto &cell, const unsigned int f) {
              const auto on_face = face_values.reinit(condition.value, t, cell, f);
              cell->get_dof_indices(dofs);
              if (condition.type == Type::pressure)
                add_pressure(on_face);
              else
                add_dead_load(on_face, 1 / area);
            });
            if (condition.type == Type::pressure)
              remove_covered_pressure(condition, id);
          }
      }

      // -int p n da
      void
      add_pressure(const LoadOn<FEFaceValues<dim>> &on_face)
      {
        const auto &values = on_face.values;
        const auto  face   = deform(values, u);
        for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
          add_point_force(values,
                          q,
                          -on_face.load[q][0] * (values.JxW(q) * measure<dim>(kind, face.positions[q])) *
                              face.normals[q]);
      }

      void
      remove_covered_pressure(const ConditionData &condition, const types::boundary_id id)
      {
        // FEValues, not FEFaceValues, whose points depend on how the face is turned in the mesh.
        for (std::size_t begin = 0, end; begin < covered.size(); begin = end)
          {
            const auto             &cell = covered[begin].cell;
            const unsigned int      face = covered[begin].face;
            std::vector<Point<dim>> points;
            for (end = begin; end < covered.size() && covered[end].cell == cell && covered[end].face == face;
                 ++end)
              points.push_back(covered[end].unit_point);
            if (cell->face(face)->boundary_id() != id)
              continue;
            FEValues<dim> on_facets(discretization.mapping(),
                                    discretization.fe,
                                    Quadrature<dim>(points),
                                    flags_of_area_vectors()),
                values(discretization.load_mapping,
                       discretization.fe,
                       Quadrature<dim>(points),
                       flags_of_area_vectors() | update_values | update_quadrature_points);
            on_facets.reinit(cell);
            values.reinit(cell);
            cell->get_dof_indices(dofs);
            const auto facets = area_vectors(on_facets, face), area = area_vectors(values, face);
            for (unsigned int q = 0; q < points.size(); ++q)
              add_point_force(values,
                              q,
                              condition.value[0].value(as_3d(values.quadrature_point(q)), t) *
                                  covered[begin + q].weight / facets[q].norm() * area[q]);
          }
      }

      UpdateFlags
      flags_of_area_vectors() const
      {
        return update_jacobians | update_inverse_jacobians | gradients_of_u();
      }

      // n da of a face per area of the unit face, by point.
      std::vector<Tensor<1, dim>>
      area_vectors(const FEValues<dim> &values, const unsigned int face) const
      {
        std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
        if (u != nullptr)
          values[FEValuesExtractors::Vector(0)].get_function_gradients(*u, gradients);
        std::vector<Tensor<1, dim>> result;
        for (unsigned int q = 0; q < gradients.size(); ++q)
          {
            const Tensor<1, dim> N = values.inverse_jacobian(q)[face / 2]; // J^-T e
            result.push_back((face % 2 == 1 ? 1 : -1) * values.jacobian(q).determinant() *
                             (cofactor(unit_symmetric_tensor<dim>() + gradients[q]) * N));
          }
        return result;
      }

      // A moment about axis k acts on the corner that carries the rotation (discretization/supports.cc).
      void
      add_motion_forces()
      {
        for (unsigned int m = 0; m < discretization.carrier_dofs.size(); ++m)
          {
            const MotionData &motion = discretization.geometry.carriers[m].motion;
            const double      s      = discretization.geometry.carriers[m].size;
            const auto       &u      = discretization.carrier_dofs[m];
            for (unsigned int c = 0; c < dim; ++c)
              loads(u[0][c]) += motion.force[c].value(motion.reference, t);
            const auto add_couple = [&](const unsigned int k, const unsigned int c, const double force) {
              loads(u[k][c]) += force;
              loads(u[0][c]) -= force;
            };
            if (kind == ProblemType::axisymmetric)
              continue;
            add_couple(1, 1, motion.moment[2].value(motion.reference, t) / s);
            if (dim == 3)
              {
                add_couple(1, dim - 1, -motion.moment[1].value(motion.reference, t) / s);
                add_couple(2, dim - 1, motion.moment[0].value(motion.reference, t) / s);
              }
          }
      }

      double
      total_area(const ConditionData &condition)
      {
        double area = 0;
        for (const auto &name : condition.boundaries)
          for_each_face(discretization,
                        discretization.geometry.boundary(name, discretization.scene).id,
                        [&](const auto &cell, const unsigned int f) {
                          const auto &values = face_values.reinit(cell, f);
                          for (unsigned int q = 0; q < values.n_quadrature_points; ++q)
                            area += weight(values, q);
                        });
        return Utilities::MPI::sum(area, discretization.geometry.communicator);
      }

      double
      weight(const FEValuesBase<dim> &values, const unsigned int q) const
      {
        return values.JxW(q) * measure<dim>(kind, values.quadrature_point(q));
      }

      UpdateFlags
      gradients_of_u() const
      {
        return u == nullptr ? update_default : update_gradients;
      }

      const Discretization<dim>            &discretization;
      const ProblemType                     kind;
      const double                          t;
      const std::vector<CoveredPoint<dim>> &covered;
      const LA::Vector                     *u; // of finite strain
      LA::Vector                            loads;
      LoadFaceValues<dim>                   face_values;
      std::vector<types::global_dof_index>  dofs;
    };
  } // namespace

  template <int dim>
  FaceLoads<dim>::FaceLoads(const Discretization<dim>            &discretization,
                            const double                          t,
                            const std::vector<CoveredPoint<dim>> &covered)
      : discretization(discretization), t(t)
  {
    for (const auto &point : covered)
      covered_areas[{point.cell->active_cell_index(), point.face}] += point.weight;
  }

  template <int dim>
  std::vector<const ConditionData *>
  FaceLoads<dim>::on(const typename DoFHandler<dim>::active_cell_iterator &cell,
                     const unsigned int                                    face,
                     const double                                          area) const
  {
    const auto covered    = covered_areas.find({cell->active_cell_index(), face});
    const bool is_exposed = covered == covered_areas.end() || covered->second < area / 2;
    const auto acts       = [&](const ConditionData &condition) {
      return condition.type == ConditionData::Type::traction ||
             (condition.type == ConditionData::Type::pressure && is_exposed);
    };
    std::vector<const ConditionData *> result;
    for (const ConditionData &condition : discretization.scene.conditions)
      if (acts(condition) &&
          std::any_of(condition.boundaries.begin(), condition.boundaries.end(), [&](const auto &name) {
            return discretization.geometry.boundary(name, discretization.scene).id ==
                   cell->face(face)->boundary_id();
          }))
        result.push_back(&condition);
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  FaceLoads<dim>::traction(const std::vector<const ConditionData *> &conditions,
                           const Point<dim>                         &X,
                           const Tensor<1, dim>                     &n) const
  {
    Tensor<1, dim> result;
    for (const ConditionData *condition : conditions)
      if (condition->type == ConditionData::Type::pressure)
        result -= condition->value[0].value(as_3d(X), t) * n;
      else
        for (unsigned int c = 0; c < dim; ++c)
          result[c] += condition->value[c].value(as_3d(X), t);
    return result;
  }

  template class FaceLoads<2>;
  template class FaceLoads<3>;

  template <int dim>
  LA::Vector
  assemble_loads(const Discretization<dim>            &discretization,
                 const double                          t,
                 const std::vector<CoveredPoint<dim>> &covered,
                 const LA::Vector                     *u)
  {
    return LoadAssembly<dim>(discretization, t, covered, u).run();
  }

  template LA::Vector
  assemble_loads(const Discretization<2> &,
                 const double,
                 const std::vector<CoveredPoint<2>> &,
                 const LA::Vector *);
  template LA::Vector
  assemble_loads(const Discretization<3> &,
                 const double,
                 const std::vector<CoveredPoint<3>> &,
                 const LA::Vector *);
} // namespace Amontons
