#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/base/version.h>
#include <amontons/output/files.h>
#include <amontons/output/json.h>
#include <amontons/output/summary.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    std::vector<double>
    components(const Tensor<1, dim> &v)
    {
      return std::vector<double>(v.begin_raw(), v.end_raw());
    }

    Json
    to_json(const std::map<std::string, double> &numbers)
    {
      Json json = Json::object();
      for (const auto &[name, value] : numbers)
        json.add(name, value);
      return json;
    }

    Json
    to_json(const EstimateSummary &estimate)
    {
      Json json = Json::object()
                      .add("bulk", estimate.bulk)
                      .add("contact", estimate.contact)
                      .add("facets", estimate.facets);
      if (!std::isnan(estimate.shear))
        json.add("shear", estimate.shear);
      if (!std::isnan(estimate.quantity))
        json.add("quantity", estimate.quantity);
      const auto &kinematics = estimate.kinematics;
      if (!std::isnan(kinematics.answer))
        json.add("kinematics", kinematics.answer);
      if (!std::isnan(kinematics.shear))
        json.add("shear_kinematics", kinematics.shear);
      if (!std::isnan(estimate.quantity) && !std::isnan(kinematics.target))
        json.add("quantity_kinematics", kinematics.target);
      if (!std::isnan(estimate.increments))
        json.add("increments", estimate.increments);
      return json;
    }

    Json
    to_json(const IncrementErrors &errors)
    {
      return Json::object()
          .add("number", errors.n_increments)
          .add("measured_with", errors.measured_with)
          .add("repeated_with", errors.repeated_with)
          .add("pressure", errors.pressure)
          .add("shear", errors.shear)
          .add("stick_size", errors.stick_size)
          .add("own_stick_size", errors.own_stick_size)
          .add("normal_force", errors.normal_force)
          .add("tangential_force", errors.tangential_force)
          .add("dissipation", errors.dissipation)
          .add("own_dissipation", errors.own_dissipation);
    }

    Json
    to_json(const ReferenceSummary &reference)
    {
      Json values = Json::object();
      for (const auto &[name, pair] : reference.values)
        values.add(name, std::vector<double>{pair[0], pair[1]});
      return Json::object()
          .add("closed_form", reference.closed_form)
          .add("errors", to_json(reference.errors))
          .add("values", values);
    }

    Json
    to_json(const PairSummary &pair)
    {
      return Json::object()
          .add("name", pair.name)
          .add("normal_force", pair.normal_force)
          .add("tangential_force", pair.tangential_force)
          .add("peak_pressure", pair.peak_pressure)
          .add("contact_size", pair.contact_size)
          .add("approach", pair.approach.value_or(unknown))
          .add("stick_size", pair.stick_size.value_or(unknown))
          .add("centre", pair.centre)
          .add("stick_centre", pair.stick_centre)
          .add("n_open", pair.n_open)
          .add("n_stick", pair.n_stick)
          .add("n_slip", pair.n_slip)
          .add("n_without_multiplier", pair.n_without_multiplier)
          .add("smallest_gap", pair.smallest_gap)
          .add("touched", pair.touched);
    }

    Json
    to_json(const NewtonSummary &newton)
    {
      Json json = Json::object();
      json.add("increment", newton.increment)
          .add("mesh", newton.mesh)
          .add("dofs", newton.dofs)
          .add("cells", newton.cells)
          .add("iterations", newton.iterations);
      if (newton.outer_iterations > 0)
        json.add("outer_iterations", newton.outer_iterations);
      return json.add("active_set_changes", newton.active_set_changes)
          .add("krylov_iterations", newton.krylov_iterations)
          .add("residual", newton.residual)
          .add("residuals", newton.residuals);
    }

    Json
    to_json(const ReactionSummary &reaction)
    {
      return Json::object()
          .add("condition", reaction.condition)
          .add("boundary", reaction.boundary)
          .add("force", reaction.force)
          .add("moment", reaction.moment);
    }

    Json
    to_json(const ProbePoint &point, const std::vector<std::string> &names)
    {
      Json json = Json::object().add("point", point.point);
      if (point.displacement.empty())
        return json.add("displacement", Json()).add("stress", Json()).add("von_mises", Json());
      Json stress = Json::object();
      for (std::size_t i = 0; i < point.stress.size(); ++i)
        stress.add(names[i], point.stress[i]);
      return json.add("displacement", point.displacement)
          .add("stress", stress)
          .add("von_mises", point.von_mises);
    }

    Json
    to_json(const ProbeSummary &probe, const std::vector<std::string> &names)
    {
      Json points = Json::array();
      for (const ProbePoint &point : probe.points)
        points.push(to_json(point, names));
      return Json::object().add("name", probe.name).add("points", points);
    }

    Json
    to_json(const MeshSummary &mesh);

    template <typename T>
    Json
    list(const std::vector<T> &values)
    {
      Json json = Json::array();
      for (const T &value : values)
        json.push(to_json(value));
      return json;
    }

    Json
    list(const std::vector<ProbeSummary> &probes, const ProblemType kind)
    {
      Json json = Json::array();
      for (const ProbeSummary &probe : probes)
        json.push(to_json(probe, stress_names(kind)));
      return json;
    }

    Json
    to_json(const MeshSummary &mesh)
    {
      Json json = Json::object();
      json.add("increment", mesh.increment)
          .add("mesh", mesh.mesh)
          .add("t", mesh.t)
          .add("cells", mesh.cells)
          .add("dofs", mesh.dofs)
          .add("iterations", mesh.iterations)
          .add("seconds", mesh.seconds)
          .add("error_estimate", to_json(mesh.error_estimate))
          .add("pairs", list(mesh.pairs))
          .add("energy", mesh.energy);
      if (mesh.external_work)
        json.add("external_work", *mesh.external_work)
            .add("contact_work", *mesh.contact_work)
            .add("dissipation", *mesh.dissipation);
      if (mesh.reference)
        json.add("reference", to_json(*mesh.reference));
      return json;
    }

    void
    add_head(Json &json, const RunSummary &summary)
    {
      json.add("version", version)
          .add("commit", commit)
          .add("status", summary.status())
          .add("failure", summary.failure)
          .add("message", summary.message)
          .add("scene", summary.scene)
          .add("title", summary.title)
          .add("dimension", dimension_of(summary.kind))
          .add("kind", kind_name(summary.kind))
          .add("dofs", summary.dofs)
          .add("cells", summary.cells)
          .add("ranks", summary.ranks)
          .add("cut_backs", summary.n_cut_backs)
          .add("wall_seconds", summary.cost.wall_seconds)
          .add("timing", to_json(summary.cost.timing))
          .add("linear_solves", summary.cost.linear_solves)
          .add("one_linear_solve_seconds", summary.cost.one_linear_solve_seconds)
          .add("finest_mesh_seconds", summary.cost.finest_mesh_seconds);
    }

    void
    add_answer(Json &json, const RunSummary &summary)
    {
      json.add("newton", list(summary.newton))
          .add("meshes", list(summary.meshes))
          .add("pairs", list(summary.pairs))
          .add("energy", summary.energy)
          .add("error_estimate", to_json(summary.error_estimate))
          .add("reactions", list(summary.reactions))
          .add("probes", list(summary.probes, summary.kind));
      if (summary.increments)
        json.add("increments", to_json(*summary.increments));
      if (summary.reference)
        json.add("reference", to_json(*summary.reference));
      json.add("checks", to_json(summary.checks)).add("notes", summary.notes);
    }
  } // namespace

  template <int dim>
  PairSummary
  summarize_pair(const ContactInterface<dim> &interface,
                 const SurfaceFields<dim>    &fields,
                 const SurfaceApproach<dim>  &approach)
  {
    PairSummary result;
    result.name             = interface.pair->name;
    result.normal_force     = components(fields.normal_force);
    result.tangential_force = components(fields.tangential_force);
    result.peak_pressure    = fields.peak_pressure;
    result.contact_size     = fields.contact_size;
    if (interface.pair->has_friction())
      {
        result.stick_size   = fields.stick_size;
        result.stick_centre = components<dim>(fields.stick_centre);
      }
    result.centre               = components<dim>(fields.centre);
    result.n_without_multiplier = interface.n_without_multiplier;
    for (const MortarRow<dim> &row : interface.coupling.rows) // hanging nodes have none
      {
        ++(fields.state[row.node] == ContactStatus::open   ? result.n_open
           : fields.state[row.node] == ContactStatus::slip ? result.n_slip
                                                           : result.n_stick);
        if (const double gap = fields.gap[row.node]; !(gap >= result.smallest_gap) && !std::isnan(gap))
          result.smallest_gap = gap; // NaN is smaller than nothing
      }
    result.touched = result.n_slip + result.n_stick > 0;
    if (!result.touched && !std::isnan(result.smallest_gap)) // something is opposite
      result.smallest_gap = smallest_gap_of(interface, fields, approach);
    return result;
  }

  void
  write_summary(const RunSummary &summary, const std::string &file)
  {
    Json json = Json::object();
    add_head(json, summary);
    add_answer(json, summary);
    write_file(file, json.text() + "\n");
  }

  template PairSummary
  summarize_pair(const ContactInterface<2> &, const SurfaceFields<2> &, const SurfaceApproach<2> &);
  template PairSummary
  summarize_pair(const ContactInterface<3> &, const SurfaceFields<3> &, const SurfaceApproach<3> &);
} // namespace Amontons
