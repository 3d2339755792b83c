// Words for people: the scene in a paragraph, the answer in lines.
#include <amontons/base/independent_errors.h>
#include <amontons/output/terminal.h>
#include <amontons/solver/load_program.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace Amontons
{
  namespace
  {
    std::string
    count(const std::size_t n, const std::string &one, const std::string &many)
    {
      return std::to_string(n) + " " + (n == 1 ? one : many);
    }

    double
    norm(const std::vector<double> &v)
    {
      double sum = 0;
      for (const double x : v)
        sum += x * x;
      return std::sqrt(sum);
    }

    // Rounding errors are shown as 0.
    std::string
    vector_text(const std::vector<double> &v)
    {
      std::string text;
      for (const double x : v)
        text += (text.empty() ? "" : ", ") + short_number(std::abs(x) > 1e-12 * norm(v) ? x : 0);
      return "(" + text + ")";
    }

    std::string
    percent(const double fraction)
    {
      return std::isfinite(fraction) ? short_number(100 * fraction) + " %" : "unknown";
    }

    std::string
    body_text(const BodyData &body)
    {
      std::string shape = body.shape;
      if (shape == "file")
        shape = "mesh " + body.mesh_file.substr(body.mesh_file.find_last_of('/') + 1);
      if (body.rigid)
        return body.name + " (" + shape + ", rigid)";
      return body.name + " (" + shape + ", E " + short_number(body.material.young) + ", nu " +
             short_number(body.material.poisson) + ")";
    }

    std::string
    friction_text(const PairData &pair)
    {
      return (pair.friction ? ", friction " + pair.friction->text() : "") +
             (pair.tresca_bound ? ", shear up to " + pair.tresca_bound->text() : "");
    }

    std::string
    pair_text(const PairData &pair)
    {
      return pair.name + " (" + pair.first.body + "/" + pair.first.boundary + " on " +
             (pair.second ? pair.second->body + "/" + pair.second->boundary : pair.obstacle) +
             (pair.tied ? ", tied" : "") + friction_text(pair) + ")";
    }

    // "250 N"; without a unit the number alone.
    std::string
    measured(const double number, const std::string &unit)
    {
      return short_number(number) + (unit.empty() ? "" : " " + unit);
    }

    bool
    is_plane(const ProblemType kind)
    {
      return kind == ProblemType::plane_strain || kind == ProblemType::plane_stress;
    }

    using Lines = std::vector<std::pair<std::string, std::string>>;

    void
    add_pair(Lines             &lines,
             const PairSummary &pair,
             const ProblemType  kind,
             const Units       &units,
             const bool         with_approach)
    {
      const std::string force     = units.force_of(is_plane(kind));
      const std::string full_turn = kind == ProblemType::axisymmetric ? ", full turn" : "";
      const bool        is_round =
          kind == ProblemType::three_dimensional ||
          (kind == ProblemType::axisymmetric && (pair.centre.empty() || pair.centre[0] == 0));
      lines.emplace_back("pair " + pair.name, "");
      if (!pair.touched)
        lines.emplace_back("  contact", "NONE in the whole run: " + without_contact(pair));
      lines.emplace_back("  normal force",
                         measured(norm(pair.normal_force), force) + "   " + vector_text(pair.normal_force) +
                             full_turn);
      if (norm(pair.tangential_force) > 1e-12 * norm(pair.normal_force))
        lines.emplace_back("  tangential force",
                           vector_text(pair.tangential_force) + (force.empty() ? "" : " " + force) +
                               full_turn);
      lines.emplace_back("  peak pressure", measured(pair.peak_pressure, units.pressure()));
      if (pair.n_open > 0)
        lines.emplace_back(is_round ? "  contact radius" : "  contact half-width",
                           measured(pair.contact_size, units.length) + "   (Hertz-equivalent)");
      if (pair.stick_size && pair.n_open > 0 && pair.n_slip > 0 && pair.n_stick > 0)
        lines.emplace_back(is_round ? "  stick radius" : "  stick half-width",
                           measured(*pair.stick_size, units.length) +
                               "   (Hertz-equivalent, of bound less shear)");
      if (with_approach && pair.approach)
        lines.emplace_back("  approach", measured(*pair.approach, units.length));
      lines.emplace_back("  nodes",
                         std::to_string(pair.n_open) + " open, " + std::to_string(pair.n_stick) + " stick, " +
                             std::to_string(pair.n_slip) + " slip");
    }

    // The errors of the mesh (`facets` is a part of that) and of what else is known, and all together.
    void
    add_estimate(Lines             &lines,
                 const std::string &what,
                 const double       of_mesh,
                 const double       of_kinematics,
                 const double       of_increments,
                 const RunSummary  &summary,
                 const double       facets = 0)
    {
      if (std::isnan(of_mesh))
        return;
      double      all   = of_mesh;
      std::string parts = "mesh " + percent(of_mesh);
      const bool  facet = facets > noteworthy_facets;
      if (facet)
        parts += ", of which facets " + percent(facets);
      if (summary.increments)
        all = together(all, of_increments);
      if (!std::isnan(of_kinematics))
        {
          all += of_kinematics;
          parts += ", kinematics " + percent(of_kinematics);
        }
      if (summary.increments)
        parts += ", increments " + percent(of_increments);
      lines.emplace_back("estimated error of the " + what,
                         percent(all) +
                             (all == of_mesh && !summary.increments && !facet ? "" : "   (" + parts + ")"));
    }

    void
    add_increments(Lines &lines, const IncrementErrors &errors)
    {
      lines.emplace_back("estimated error by increments",
                         "shear " + percent(errors.shear) + ", stick size " + percent(errors.stick_size) +
                             ", forces " + percent(std::max(errors.normal_force, errors.tangential_force)) +
                             ", work of friction " + percent(errors.dissipation) + " of all");
    }

    void
    add_estimates(Lines &lines, const RunSummary &summary)
    {
      const auto           &estimate   = summary.error_estimate;
      const auto           &kinematics = estimate.kinematics;
      const IncrementErrors increments = summary.increments.value_or(IncrementErrors());
      const auto            add        = [&](const std::string &what,
                           const double       of_mesh,
                           const double       of_kinematics,
                           const double       of_increments,
                           const double       facets = 0) {
        add_estimate(lines, what, of_mesh, of_kinematics, of_increments, summary, facets);
      };
      add("pressure", estimate.contact, kinematics.answer, increments.pressure, estimate.facets);
      add("shear", estimate.shear, kinematics.shear, increments.shear);
      add("stress", estimate.bulk, kinematics.answer, increments.pressure);
      add("target quantity", estimate.quantity, kinematics.target, estimate.increments);
      if (summary.increments)
        add_increments(lines, *summary.increments);
    }

    // A line per point; the report and summary.json have those of long probes.
    void
    add_probe(Lines &lines, const ProbeSummary &probe, const Units &units)
    {
      if (probe.points.size() > 4)
        return;
      std::string       label  = "probe " + probe.name;
      const std::string length = units.are_known() ? " " + units.length : "";
      for (const ProbePoint &point : probe.points)
        {
          lines.emplace_back(
              label,
              "at " + vector_text(point.point) + ": displacement " +
                  (point.displacement.empty() ? "-" : vector_text(point.displacement) + length) +
                  "; von Mises " + measured(point.von_mises, units.pressure()));
          label.clear();
        }
    }

    void
    add_reference(Lines &lines, const ReferenceSummary &reference)
    {
      lines.emplace_back("against " + reference.closed_form, "");
      for (const auto &[name, error] : reference.errors)
        {
          std::string text  = percent(error);
          const auto  value = reference.values.find(name);
          if (value != reference.values.end())
            text +=
                "   (" + short_number(value->second[0]) + ", exact " + short_number(value->second[1]) + ")";
          lines.emplace_back("  error of " + name, text);
        }
    }
  } // namespace

  std::string
  short_number(const double number)
  {
    if (!std::isfinite(number))
      return "-";
    char text[32];
    std::snprintf(text, sizeof(text), "%.5g", number);
    return text;
  }

  unsigned int
  planned_increments(const Scene &scene)
  {
    LoadProgram program(scene, scene.has_friction());
    while (!program.finished())
      program.accept(1);
    return program.number() - 1;
  }

  std::string
  without_contact(const PairSummary &pair)
  {
    return std::isnan(pair.smallest_gap)
               ? "nothing of one side is opposite of the other at the end"
               : "the sides are " + short_number(pair.smallest_gap) + " apart at the end";
  }

  std::string
  describe_scene(const Scene &scene, const unsigned int n_ranks)
  {
    std::string text = (scene.title.empty() ? scene.file : scene.title) + ": " + kind_name(scene.kind) +
                       ", " + count(scene.bodies.size(), "body", "bodies") + " - ";
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      text += (b == 0 ? "" : ", ") + body_text(scene.bodies[b]);
    for (const ObstacleData &obstacle : scene.obstacles)
      text += ", rigid obstacle " + obstacle.name;
    text += "; " + count(scene.pairs.size(), "contact pair", "contact pairs");
    for (std::size_t p = 0; p < scene.pairs.size(); ++p)
      text += (p == 0 ? " - " : ", ") + pair_text(scene.pairs[p]);
    const unsigned int n_increments = planned_increments(scene);
    text += "; " + count(scene.conditions.size(), "condition", "conditions") + "; " +
            (scene.n_increments == 0 && n_increments > 1 ? "automatic increments"
                                                         : count(n_increments, "increment", "increments")) +
            " to t = " + short_number(scene.end_time) + "; " + count(n_ranks, "process", "processes") + ".";
    return text;
  }

  Lines
  answer_lines(const RunSummary &summary)
  {
    Lines lines = {{"status", summary.status() + (summary.message.empty() ? "" : ": " + summary.message)}};
    for (const PairSummary &pair : summary.pairs)
      add_pair(lines, pair, summary.kind, summary.units, !std::isnan(summary.error_estimate.quantity));
    const std::string work = summary.units.work_of(is_plane(summary.kind));
    add_estimates(lines, summary);
    if (!std::isnan(summary.energy))
      lines.emplace_back("strain energy", measured(summary.energy, work));
    // Without friction the work is the strain energy; where meshes were refined in the last increment, that
    // of the increments before is one of coarser meshes.
    const bool has_friction = std::any_of(summary.pairs.begin(), summary.pairs.end(), [](const auto &pair) {
      return pair.stick_size.has_value();
    });
    if (has_friction && !summary.meshes.empty() && summary.meshes.back().dissipation)
      {
        lines.emplace_back("external work", measured(*summary.meshes.back().external_work, work));
        lines.emplace_back("work of friction", measured(*summary.meshes.back().dissipation, work));
      }
    for (const ProbeSummary &probe : summary.probes)
      add_probe(lines, probe, summary.units);
    if (summary.reference)
      add_reference(lines, *summary.reference);
    lines.emplace_back("finest mesh",
                       std::to_string(summary.cells) + " cells, " + std::to_string(summary.dofs) + " DoFs");
    if (!std::isnan(summary.cost.wall_seconds))
      lines.emplace_back("time", short_number(summary.cost.wall_seconds) + " s");
    for (const std::string &note : summary.notes)
      lines.emplace_back("note", note);
    return lines;
  }
} // namespace Amontons
