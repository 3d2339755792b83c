// RunReport: what it writes into its folder.
#include <amontons/output/contact_csv.h>
#include <amontons/output/files.h>
#include <amontons/output/history.h>
#include <amontons/output/json.h>
#include <amontons/output/output_folder.h>
#include <amontons/run_report.h>
#include <amontons/scene/text.h>

namespace Amontons
{
  void
  OutputParameters::declare(ParameterHandler &prm)
  {
    prm.enter_subsection("Output");
    prm.add_parameter("VTU", vtu, "Write .pvd and .vtu files of the bodies and of the contact surfaces.");
    prm.add_parameter("Report", report, "Write report.html, a self-contained page with pictures.");
    prm.add_parameter("Contact tables",
                      contact_tables,
                      "Write contact_0000.csv, contact_0001.csv, ...: contact.csv of each increment.");
    prm.add_parameter("Checkpoint every",
                      checkpoint_every,
                      "How often what has been solved is written, for 'amontons --resume': 'N minutes', "
                      "'N increments', both (with a comma between; whichever comes first), or 'never'. A run "
                      "that is stopped writes it, too, unless it is 'never'.");
    prm.leave_subsection();
  }

  namespace
  {
    // None: not understood.
    std::optional<Checkpoint::Intervals>
    parse_intervals(const std::string &text)
    {
      Checkpoint::Intervals intervals;
      if (trim(text) == "never")
        return intervals;
      for (const std::string &part : split(text, ','))
        {
          const std::string word  = trim(part);
          const auto        space = word.find(' ');
          const auto        value = as_number(word.substr(0, space));
          const std::string unit  = space == std::string::npos ? "" : trim(word.substr(space));
          if (!value || !(*value > 0) || *value > 1e9)
            return {};
          if (unit == "minutes" || unit == "minute")
            intervals.seconds = 60 * *value;
          else if ((unit == "increments" || unit == "increment") && *value == std::floor(*value))
            intervals.solves = static_cast<unsigned int>(*value);
          else
            return {};
        }
      return intervals;
    }
  } // namespace

  void
  OutputParameters::check() const
  {
    if (!parse_intervals(checkpoint_every))
      throw std::invalid_argument("Checkpoint every: found '" + checkpoint_every +
                                  "'; 'N minutes', 'N increments', both with a comma between, or 'never'");
  }

  Checkpoint::Intervals
  OutputParameters::checkpoint_intervals() const
  {
    return *parse_intervals(checkpoint_every);
  }

  template <int dim>
  void
  RunReport<dim>::open_log()
  {
    terminal.log_to(folder + "/amontons.log");
  }

  template <int dim>
  void
  RunReport<dim>::write_increment(const Answer<dim> &answer, const Evaluation<dim> &evaluation)
  {
    TimerOutput::Scope scope(phases, "output");
    if (parameters.vtu)
      {
        control.try_to([&]() {
          vtu.write_bodies(BodyFields<dim>{answer.discretization,
                                           answer.state.displacement,
                                           *evaluation.recovery,
                                           evaluation.error.cell_indicators},
                           answer.state.t);
        });
        control.try_to([&]() { vtu.write_contact(answer.interfaces, answer.fields, answer.state.t); });
      }
    if (parameters.report)
      keep_picture(answer, *evaluation.recovery);
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    if (parameters.contact_tables)
      control.try_to([&]() {
        write_contact_csv(folder + "/contact_" + Utilities::int_to_string(n_tables++, 4) + ".csv",
                          contact_table(answer.interfaces, answer.fields, answer.state.t));
      });
    // A hundredth of the time at most.
    const double now = control.wall.wall_time();
    if (last_write >= 0 && now - last_write < std::max(0.5, 100 * cost_of_write))
      return;
    control.try_to([&]() {
      write_history(folder + "/history.csv", summary.meshes, scene.kind);
      write_progress("running");
    });
    last_write    = control.wall.wall_time();
    cost_of_write = last_write - now;
  }

  // Where bodies touch: of the last way through the load program.
  template <int dim>
  void
  RunReport<dim>::keep_picture(const Answer<dim> &answer, const StressRecovery<dim> &recovery)
  {
    const auto touches = [](const MeshSummary &mesh) {
      return std::any_of(
          mesh.pairs.begin(), mesh.pairs.end(), [](const PairSummary &pair) { return pair.touched; });
    };
    if (summary.meshes.empty() || !touches(summary.meshes.back()))
      return;
    const auto pass = last_pass(summary);
    const bool first =
        std::none_of(pass.begin(), pass.end() - 1, [&](const auto *mesh) { return touches(*mesh); });
    bodies.add(answer, recovery, first);
  }

  // seconds_left: of the load program on this mesh, if the rest goes like what was done.
  template <int dim>
  void
  RunReport<dim>::write_progress(const std::string &state) const
  {
    const double       seconds = control.wall.wall_time();
    const MeshSummary *last    = summary.meshes.empty() ? nullptr : &summary.meshes.back();
    Json               json    = Json::object();
    json.add("state", state)
        .add("percent", 100 * fraction)
        .add("seconds", seconds)
        .add("seconds_left", state == "running" && fraction > 0 ? seconds / fraction - seconds : unknown);
    if (last != nullptr)
      json.add("t", last->t)
          .add("end_time", scene.end_time)
          .add("increment", last->increment)
          .add("mesh", last->mesh)
          .add("dofs", last->dofs);
    write_file(folder + "/progress.json", json.text() + "\n");
  }

  // Stopped before any state had converged.
  template <int dim>
  void
  RunReport<dim>::write_files_without_answer() const
  {
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      control.try_to([&]() {
        write_progress("stopped");
        write_summary(summary, folder + "/summary.json");
      });
  }

  // Each, even if another one cannot be written.
  template <int dim>
  void
  RunReport<dim>::write_files(const Answer<dim> &answer, const StressRecovery<dim> *recovery) const
  {
    MeshPicture              picture;
    std::vector<std::string> body_pictures;
    double                   largest_young = 0;
    for (const BodyData &body : scene.bodies)
      largest_young = std::max(largest_young, body.material.young);
    if (parameters.report && recovery != nullptr)
      {
        picture = gather_mesh_picture(
            answer.discretization, *recovery, answer.state.displacement, 1e-13 * largest_young);
        body_pictures = bodies.pictures(answer, *recovery);
      }
    if (Utilities::MPI::this_mpi_process(communicator) != 0)
      return;
    control.try_to([&]() {
      vtu.remove_earlier();
      remove_later_files(folder, "contact", "csv", n_tables);
    });
    const auto table = contact_table(answer.interfaces, answer.fields, answer.state.t);
    control.try_to([&]() { write_history(folder + "/history.csv", summary.meshes, scene.kind); });
    control.try_to([&]() { write_contact_csv(folder + "/contact.csv", table); });
    control.try_to([&]() {
      write_progress(summary.failure == "stopped" ? "stopped"
                     : summary.converged          ? "converged"
                                                  : "not converged");
    });
    if (parameters.report)
      control.try_to([&]() {
        const auto tractions = reference ? reference->tractions() : ReferenceTractions();
        const auto curves    = pressure_curves(table, summary.pairs, dim, tractions);
        std::map<std::string, MeshPicture> pressure_maps;
        for (unsigned int i = 0; i < answer.interfaces.size(); ++i)
          for (const PressureCurve &curve : curves)
            if (curve.pair == answer.interfaces[i].pair->name)
              pressure_maps[curve.pair] =
                  make_pressure_picture(answer.interfaces[i], answer.fields[i], curve.axes);
        write_report(folder + "/report.html", summary, curves, picture, pressure_maps, body_pictures);
      });
    control.try_to([&]() { write_summary(summary, folder + "/summary.json"); }); // all is there
  }

  template void
  RunReport<2>::open_log();
  template void
  RunReport<3>::open_log();
  template void
  RunReport<2>::write_increment(const Answer<2> &, const Evaluation<2> &);
  template void
  RunReport<3>::write_increment(const Answer<3> &, const Evaluation<3> &);
  template void
  RunReport<2>::write_files_without_answer() const;
  template void
  RunReport<3>::write_files_without_answer() const;
  template void
  RunReport<2>::write_files(const Answer<2> &, const StressRecovery<2> *) const;
  template void
  RunReport<3>::write_files(const Answer<3> &, const StressRecovery<3> *) const;
} // namespace Amontons
