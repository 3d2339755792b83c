#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/load_path.h>
#include <amontons/model_reduction.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    constexpr double part_of_target = 0.1;
    constexpr double most_slender   = 4; // a first mesh may be much too stiff for a body that bends

    bool
    stands_on(const std::vector<BoundaryName> &boundaries, const std::string &body)
    {
      return std::any_of(
          boundaries.begin(), boundaries.end(), [&](const auto &name) { return name.body == body; });
    }

    // What the conditions of a body say of its motion, were it rigid.
    class SupportedMotion
    {
    public:
      SupportedMotion(const Scene &scene, const BodyData &body)
      {
        for (const auto &condition : scene.conditions)
          if (stands_on(condition.boundaries, body.name))
            add(condition, body.name);
        for (unsigned int i = 0; i < 3; ++i)
          loaded = loaded || !body.body_force[i].is_zero();
        if (platen == nullptr)
          for (auto &component : motion.displacement) // symmetry holds what is not said, or else it shows
            component = component.value_or(Expression(0.));
        else
          motion = *platen;
        motion.name = body.name;
      }

      // Nothing: they do not tell it.
      std::optional<MotionData>
      find() const
      {
        if (contradicts || (platen == nullptr) == (n_displacements == 0) ||
            (loaded && !is_prescribed(motion)))
          return {};
        return motion;
      }

      static bool
      is_prescribed(const MotionData &motion)
      {
        const auto all = [](const auto &components) {
          return std::all_of(
              components.begin(), components.end(), [](const auto &c) { return c.has_value(); });
        };
        return all(motion.displacement) && all(motion.rotation);
      }

    private:
      void
      add(const ConditionData &condition, const std::string &body)
      {
        using Type = ConditionData::Type;
        if (condition.type == Type::platen)
          {
            contradicts = contradicts || platen != nullptr || condition.boundaries.size() != 1;
            platen      = &*condition.motion;
          }
        else if (condition.type == Type::displacement)
          {
            ++n_displacements;
            contradicts = contradicts || condition.field || condition.boundaries.front().body != body;
            for (unsigned int c = 0; c < 3; ++c)
              if (const auto &value = condition.displacement[c])
                {
                  auto &component = motion.displacement[c];
                  contradicts     = contradicts || (component && component->text() != value->text());
                  component       = value;
                }
          }
        else if (condition.type != Type::symmetry)
          loaded = true;
      }

      MotionData        motion = {"", {}, {}, {}, {}, {{Expression(0.), Expression(0.), Expression(0.)}}, {}};
      const MotionData *platen = nullptr;
      unsigned int      n_displacements = 0;
      bool              contradicts = false, loaded = false;
    };

    // By the scene alone.
    bool
    may_be_rigid(const Scene &scene, const BodyData &body, const double target)
    {
      if (body.rigid || !body.true_geometry.empty() || (body.shape != "block" && body.shape != "file") ||
          std::any_of(
              scene.probes.begin(), scene.probes.end(), [&](const auto &p) { return p.body == body.name; }))
        return false;
      bool touches = false;
      for (const auto &pair : scene.pairs)
        {
          const bool is_first  = pair.first.body == body.name,
                     is_second = pair.second && pair.second->body == body.name;
          if (!is_first && !is_second)
            continue;
          touches              = true;
          const auto  as_slave = is_first ? PairData::Slave::first : PairData::Slave::second;
          const auto &opposite = is_first ? pair.second : std::optional<BoundaryName>(pair.first);
          const auto  other    = std::find_if(scene.bodies.begin(), scene.bodies.end(), [&](const auto &b) {
            return opposite && b.name == opposite->body;
          });
          if (pair.tied || pair.slave == as_slave || other == scene.bodies.end() || other->rigid ||
              body.material.young * target < other->material.young)
            return false;
        }
      return touches && SupportedMotion(scene, body).find();
    }

    void
    make_rigid(Scene &scene, BodyData &body, const MotionData &motion)
    {
      body.rigid       = motion;
      body.body_force  = {};
      auto &conditions = scene.conditions;
      for (auto &condition : conditions)
        {
          auto &names = condition.boundaries;
          names.erase(std::remove_if(names.begin(),
                                     names.end(),
                                     [&](const auto &name) { return name.body == body.name; }),
                      names.end());
        }
      conditions.erase(std::remove_if(conditions.begin(),
                                      conditions.end(),
                                      [](const auto &condition) { return condition.boundaries.empty(); }),
                       conditions.end());
      for (auto &pair : scene.pairs)
        if (pair.first.body == body.name)
          pair.slave = PairData::Slave::second;
        else if (pair.second && pair.second->body == body.name)
          pair.slave = PairData::Slave::first;
    }

    // By shear that is this part of the pressure friction matters.
    double
    least_shear(const double target)
    {
      return part_of_target * target * noteworthy_shear;
    }

    // The answer of a scene on its first mesh.
    template <int dim>
    class FirstAnswer
    {
    public:
      // enough_shear: with that the load program need not go on.
      FirstAnswer(const Scene      &scene,
                  const Parameters &parameters,
                  RunControl       &control,
                  const double      enough_shear)
          : scene(scene), timer(std::cout, TimerOutput::never, TimerOutput::wall_times),
            mesh(std::make_shared<BodyMesh<dim>>(scene, parameters.discretization))
      {
        const bool  finite_strain = scene.kinematics == Kinematics::finite_strain;
        LoadProgram program(scene,
                            scene.has_friction() || finite_strain,
                            {LoadProgram::increments_by_default / LoadProgram::increments_at_first});
        mesh->collocated = parameters.newton.collocates();
        path             = std::make_unique<LoadPath<dim>>(
            parameters, make_model(mesh, finite_strain, program.next(), timer), timer, control);
        path->model->refine_where_bodies_are_close(parameters.refinement);
        converged = path->run(program, 0, [&]() { return part_of_shear().value_or(0) > enough_shear; });
        if (converged)
          energy = stored_energy(path->answer());
      }

      bool
      is_known() const
      {
        return converged && energy > 0;
      }

      double
      part_of_energy(const unsigned int body) const
      {
        const auto &discretization = *mesh->discretization;
        LA::Vector  owned          = discretization.make_owned_vector(),
                   relevant        = discretization.make_relevant_vector();
        for_each_dof(body, [&](const auto dof, const unsigned int) {
          owned(dof) = path->history.state.displacement(dof);
        });
        owned.compress(VectorOperation::insert);
        relevant = owned;
        return path->model->elasticity.stored_energy(relevant) / energy;
      }

      // The longest side of the box around a body over the shortest.
      double
      slenderness(const unsigned int body) const
      {
        std::vector<Point<dim>> vertices;
        for (const auto &cell :
             mesh->geometry.triangulation.cell_iterators_on_level(0)) // all ranks have these
          if (cell->material_id() == body)
            for (const unsigned int v : cell->vertex_indices())
              vertices.push_back(cell->vertex(v));
        const BoundingBox<dim> box(vertices);
        double                 longest = box.side_length(0), shortest = longest;
        for (unsigned int d = 1; d < dim; ++d)
          {
            longest  = std::max(longest, box.side_length(d));
            shortest = std::min(shortest, box.side_length(d));
          }
        return longest / shortest;
      }

      double
      part_of_unknowns(const unsigned int body) const
      {
        double n = 0;
        for_each_dof(body, [&](const auto, const unsigned int) { ++n; });
        const auto &discretization = *mesh->discretization;
        return Utilities::MPI::sum(n, discretization.geometry.communicator) /
               discretization.dof_handler.n_dofs();
      }

      // How far from these displacements, over the largest of all.
      double
      distance_from(const std::array<std::optional<Expression>, 3> &motion, const unsigned int body) const
      {
        const auto &u    = path->history.state.displacement;
        double      most = 0;
        for_each_dof(body, [&](const auto dof, const unsigned int component) {
          most = std::max(most, std::abs(u(dof) - motion[component]->value(Point<3>(), scene.end_time)));
        });
        return Utilities::MPI::max(most, mesh->geometry.communicator) / u.linfty_norm();
      }

      // Of the shear, over the pressure. Nothing where a pair presses by a few nodes only: one at a tip has
      // no shear, however much there is beside it.
      std::optional<double>
      part_of_shear() const
      {
        double                    shear = 0, pressure = 0; // squares
        std::vector<unsigned int> most_nodes;              // that press, by pair
        for (const auto &landing : path->history.record.breakpoints)
          {
            most_nodes.resize(landing.pairs.size(), 0);
            for (unsigned int i = 0; i < landing.pairs.size(); ++i)
              {
                double       q = 0, p = 0;
                unsigned int n = 0;
                for (const auto &[node, values] : landing.pairs[i].nodes)
                  {
                    q += values.area * values.shear.norm_square();
                    p += values.area * values.pressure * values.pressure;
                    n += values.pressure > 0;
                  }
                shear         = std::max(shear, q);
                pressure      = std::max(pressure, p);
                most_nodes[i] = std::max(most_nodes[i], n);
              }
          }
        const bool is_seen = std::all_of(most_nodes.begin(), most_nodes.end(), [](const unsigned int n) {
          return n == 0 || n >= enough_closed_nodes<dim>;
        });
        return pressure > 0 && is_seen ? std::optional<double>(std::sqrt(shear / pressure)) : std::nullopt;
      }

    private:
      // Owned ones; f(dof, component).
      template <typename Function>
      void
      for_each_dof(const unsigned int body, const Function &f) const
      {
        const auto                          &discretization = *mesh->discretization;
        const auto                          &fe             = discretization.fe;
        std::vector<types::global_dof_index> dofs(fe.n_dofs_per_cell());
        std::vector<bool>                    done(discretization.locally_owned.n_elements(), false);
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (!cell->is_artificial() && cell->material_id() == body)
            {
              cell->get_dof_indices(dofs);
              for (unsigned int i = 0; i < dofs.size(); ++i)
                if (discretization.locally_owned.is_element(dofs[i]))
                  if (const auto k = discretization.locally_owned.index_within_set(dofs[i]); !done[k])
                    {
                      done[k] = true;
                      f(dofs[i], fe.system_to_component_index(i).first);
                    }
            }
      }

      const Scene                   &scene;
      TimerOutput                    timer;
      std::shared_ptr<BodyMesh<dim>> mesh;
      std::unique_ptr<LoadPath<dim>> path;
      bool                           converged = false;
      double                         energy    = 0;
    };

    std::string
    percent(const double part)
    {
      std::ostringstream text;
      text.precision(2);
      text << 100 * part << " %";
      return text.str();
    }

    std::string
    worth(const double part, const double target)
    {
      return percent(part) + ", " + percent(part / target) + " of the target error; 'Model = full' keeps it";
    }

    std::vector<unsigned int>
    candidates(const Scene &scene, const double target)
    {
      std::vector<unsigned int> bodies;
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (may_be_rigid(scene, scene.bodies[b], target))
          bodies.push_back(b);
      return bodies;
    }

    template <int dim>
    void
    make_rigid_if_stiff(const unsigned int      b,
                        const FirstAnswer<dim> &first,
                        const double            target,
                        ReducedScene           &reduced)
    {
      auto        &body   = reduced.scene.bodies[b];
      const auto   motion = *SupportedMotion(reduced.scene, body).find();
      const double part = first.part_of_energy(b), allowed = part_of_target * target;
      if (part > allowed || first.slenderness(b) > most_slender ||
          (SupportedMotion::is_prescribed(motion) && first.distance_from(motion.displacement, b) > allowed))
        return;
      make_rigid(reduced.scene, body, motion);
      reduced.notes.push_back("model: body '" + body.name + "', " + percent(first.part_of_unknowns(b)) +
                              " of the unknowns, is taken for rigid: it holds of the stored energy " +
                              worth(part, target));
    }

    // Nodes of a first mesh may all lie where a bound that depends on place vanishes.
    bool
    may_leave_out_friction(const Scene &scene)
    {
      return scene.has_friction() &&
             std::none_of(scene.pairs.begin(), scene.pairs.end(), [](const auto &pair) {
               return pair.bound_depends_on_place();
             });
    }

    template <int dim>
    void
    leave_out_friction(const FirstAnswer<dim> &first, const double target, ReducedScene &reduced)
    {
      const auto part_of_shear = first.part_of_shear();
      if (!part_of_shear || *part_of_shear > least_shear(target))
        return;
      for (auto &pair : reduced.scene.pairs)
        pair.friction = pair.tresca_bound = {};
      reduced.notes.push_back(
          "model: friction, and with it the increments, is left out: shear is, of 5 % of the pressure, " +
          worth(*part_of_shear / noteworthy_shear, target));
    }
  } // namespace

  template <int dim>
  ReducedScene
  reduce_model(const Scene &scene, const Parameters &parameters, RunControl &control)
  {
    const double target  = parameters.refinement.target_error;
    ReducedScene reduced = {scene, {}};
    if (target <= 0 || scene.full_model || scene.reference)
      return reduced;
    const auto stiff = candidates(scene, target);
    if (stiff.empty() && !may_leave_out_friction(scene))
      return reduced;
    const FirstAnswer<dim> first(scene,
                                 parameters,
                                 control,
                                 stiff.empty() ? least_shear(target)
                                               : std::numeric_limits<double>::infinity());
    if (!first.is_known())
      return reduced;
    for (const unsigned int b : stiff)
      make_rigid_if_stiff(b, first, target, reduced);
    if (may_leave_out_friction(scene))
      leave_out_friction(first, target, reduced);
    return reduced;
  }

  template ReducedScene
  reduce_model<2>(const Scene &, const Parameters &, RunControl &);
  template ReducedScene
  reduce_model<3>(const Scene &, const Parameters &, RunControl &);
} // namespace Amontons
