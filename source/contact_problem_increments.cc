// With friction the answer depends on the increments: by how much.
#include <amontons/base/points.h>
#include <amontons/contact_problem.h>
#include <amontons/friction/shear_law.h>

#include <sstream>

namespace Amontons
{
  // After an increment that ends at a time to land on.
  template <int dim>
  void
  ContactProblem<dim>::keep_record(const LoadProgram &program)
  {
    if (!has_history)
      return;
    ++history.record.n_increments;
    history.record.largest_work = history.work.largest_work;
    if (!program.has_landed())
      return;
    history.record.landings.emplace_back();
    history.record.landings.back().dissipation = history.work.dissipation;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const PairData &pair = *interfaces[i].pair;
        if (pair.tied)
          continue;
        LoadRecord::Pair kept;
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto  &node    = history.state.contact[i][row.node];
            const double p       = node.pressure;
            const auto   X       = as_3d(interfaces[i].slave->nodes[row.node].X);
            const double bound   = pair.has_friction() ? shear_bound(pair, X, history.state.t, p).value : 0;
            kept.nodes[row.node] = {row.area, p, bound, as_3d(node.shear)};
          }
        for (unsigned int c = 0; c < dim; ++c)
          {
            kept.normal_force[c]     = fields[i].normal_force[c];
            kept.tangential_force[c] = fields[i].tangential_force[c];
          }
        kept.contact_size = fields[i].contact_size;
        kept.stick_size   = fields[i].stick_size;
        kept.tresca_alone = !pair.friction;
        history.record.landings.back().pairs.push_back(kept);
      }
  }

  // Enough nodes touch to see how slip spreads.
  template <int dim>
  bool
  ContactProblem<dim>::resolves_friction() const
  {
    unsigned int most = 0;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      if (interfaces[i].pair->has_friction())
        most = std::max<unsigned int>(
            most,
            std::count_if(history.state.contact[i].begin(),
                          history.state.contact[i].end(),
                          [](const auto &node) { return node.state != ContactState::open; }));
    return most >= (dim == 2 ? 10 : 20);
  }

  // The load program, which has converged on this mesh, once more with half as many increments; where they
  // are few, with twice as many. Nothing is shown nor written, and the run goes on from where it was.
  template <int dim>
  void
  ContactProblem<dim>::measure_increments()
  {
    TimerOutput::Scope scope(report.timer(), "error of the increments");
    LoadProgram        plan(scene, incremental);
    while (!plan.finished())
      plan.accept(1);
    const bool few = plan.number() - 1 < 4 * plan.n_landings();

    auto       kept_interfaces = std::move(interfaces);
    auto       kept_bodies     = std::move(elasticity);
    auto       kept_history    = std::move(history);
    const auto kept_error      = error;
    const auto kept_fields     = fields;
    const auto kept_loads      = loads;
    const auto kept_reaches    = reaches;

    is_repeat = true;
    report.pause(true);
    coarser         = few ? 0.5 : 2;
    elasticity      = std::make_unique<ElasticityOperator<dim>>(*discretization, finite_strain);
    history         = LoadHistory<dim>();
    history.path    = std::move(kept_history.path); // first guesses for both
    history.state.t = LoadProgram(scene, incremental, coarser).next();
    couple_surfaces();
    if (run_load_program() && history.record.n_increments != kept_history.record.n_increments)
      report.set_error_of_increments(error_of_increments(kept_history.record, history.record));

    is_repeat = false;
    report.pause(false);
    coarser             = 1;
    interfaces          = std::move(kept_interfaces);
    elasticity          = std::move(kept_bodies);
    kept_history.path   = std::move(history.path);
    history             = std::move(kept_history);
    error               = kept_error;
    fields              = kept_fields;
    loads               = kept_loads;
    reaches             = kept_reaches;
    supports            = discretization->make_supports(history.state.t);
    time_of_supports    = history.state.t;
    measured_increments = true;
  }

  // In the end. Where meshes were refined on the way, the load program on a mesh of its own.
  template <int dim>
  void
  ContactProblem<dim>::add_error_of_increments()
  {
    if (!measured_increments && parameters.refinement.history == "transfer" && mesh_number > 0)
      {
        Scene part      = scene;
        part.kinematics = finite_strain ? Kinematics::finite_strain : Kinematics::small_strain;
        part.reference.reset();
        part.probes.clear();
        Parameters replay         = parameters;
        replay.refinement.history = "replay";
        replay.output.vtu         = false;
        TimerOutput::Scope scope(report.timer(), "error of the increments");
        report.set_error_of_increments(
            ContactProblem<dim>(part, replay, folder, true).run_to_measure_increments());
      }
    else if (!measured_increments)
      measure_increments();
    if (!report.error_of_increments())
      return report.announce(
          "the error of the increments is not known: with half as many (where they are few: twice as "
          "many) the iteration does not converge");
    const IncrementErrors &errors = *report.error_of_increments();
    std::ostringstream     text;
    text.precision(2);
    if (errors.largest() > allowed_error())
      text << errors.shear << " of the shear traction (against its bound), " << errors.stick_size
           << " of the stick size, " << std::max(errors.normal_force, errors.tangential_force)
           << " of the forces";
    if (errors.dissipation > allowed_error())
      text << (text.str().empty() ? "" : ", ") << errors.dissipation << " of the work, in that of friction";
    if (!text.str().empty())
      report.announce("warning: with " + std::to_string(errors.repeated_with) + " increments instead of " +
                      std::to_string(errors.n_increments) +
                      " the answer is another; what is wrong by the increments is about " + text.str() +
                      "; it falls with their number ('Increments')");
  }

  template <int dim>
  std::optional<IncrementErrors>
  ContactProblem<dim>::run_to_measure_increments()
  {
    only_increments = true;
    history.state.t = LoadProgram(scene, incremental).next();
    make_mesh();
    rebuild();
    refine_where_bodies_are_close();
    if (run_all_meshes() && !measured_increments)
      measure_increments();
    return report.error_of_increments();
  }

  template class ContactProblem<2>;
  template class ContactProblem<3>;
} // namespace Amontons
