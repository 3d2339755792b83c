#include <amontons/adaptivity/data_error.h>
#include <amontons/adaptivity/load_record.h>
#include <amontons/adaptivity/peak_error.h>
#include <amontons/adaptivity/unseen_contact.h>
#include <amontons/base/points.h>
#include <amontons/contact/surface_fields.h>
#include <amontons/evaluation.h>
#include <amontons/friction/shear_law.h>

namespace Amontons
{
  namespace
  {
    // What the shear of sticking nodes leaves of the bound of friction, by coupling row. Nodes that slipped
    // and are held then are at their bound.
    template <int dim>
    std::vector<double>
    unused_shears(const ContactInterface<dim> &interface, const NodalContacts<dim> &contact, const double t)
    {
      std::vector<double> unused;
      for (const auto &row : interface.coupling.rows)
        {
          const auto  &node  = contact[row.node];
          const auto   X     = as_3d(interface.slave->nodes[row.node].X);
          const double bound = shear_bound(*interface.pair, X, t, node.pressure).value;
          const double left  = bound - node.shear.norm();
          unused.push_back(node.state == ContactStatus::stick && left > 1e-8 * bound ? left : 0);
        }
      return unused;
    }

    void
    keep_largest(const Vector<float> &old, Vector<float> &now)
    {
      for (unsigned int c = 0; c < now.size() && old.size() == now.size(); ++c)
        now[c] = std::max(now[c], old[c]);
    }
  } // namespace

  template <int dim>
  void
  Evaluation<dim>::collect_fields(const Model<dim> &model, const SolutionState<dim> &state)
  {
    fields.clear();
    for (unsigned int i = 0; i < model.interfaces.size(); ++i)
      {
        const auto &interface = model.interfaces[i];
        fields.push_back(
            make_surface_fields(model.discretization(),
                                interface,
                                state.contact[i],
                                unused_shears(interface, state.contact[i], state.t),
                                state.displacement,
                                state.was_open.empty() ? std::vector<bool>() : state.was_open[i]));
      }
  }

  template <int dim>
  unsigned int
  Evaluation<dim>::n_closed_nodes() const
  {
    unsigned int most = 0;
    for (const auto &of_pair : fields)
      most = std::max(most, Amontons::n_closed_nodes(of_pair));
    return most;
  }

  template <int dim>
  void
  Evaluation<dim>::estimate(const Model<dim> &model, const SolutionState<dim> &state)
  {
    recovery = std::make_unique<StressRecovery<dim>>(model.discretization(), model.elasticity);
    recovery->recover(state.displacement);
    const FaceLoads<dim> loads(model.discretization(), state.t, model.covered_points());
    error = estimate_error(model.discretization(),
                           *recovery,
                           model.interfaces,
                           fields,
                           state.displacement,
                           model.finite_strain(),
                           &loads,
                           refined.doubts());
    add_error_of_displacements(model.discretization(), state, error);
    add_error_of_peaks(model.discretization(), model.interfaces, fields, error);
    pressure_norm = error.pressure_norm;
    shear_norm    = error.shear_norm;
    energy_norm   = error.energy_norm;
    has_touched   = has_touched || touches();
    if (!of_history)
      return;
    if (!has_touched) // what was not seen on the way
      error.data = std::max(kept.data, error.data);
    error.worst_pressure = kept.worst_pressure;
    error.worst_shear    = kept.worst_shear;
    error.worst_bulk     = kept.worst_bulk;
    keep_largest(kept.cell_indicators, error.cell_indicators);
    keep_largest(kept.contact_indicators, error.contact_indicators);
    keep_largest(kept.pollution_indicators, error.pollution_indicators);
    keep_largest(kept.shear_indicators, error.shear_indicators);
    error.energy_norm   = std::max(kept.energy_norm, error.energy_norm);
    error.pressure_norm = std::max(kept.pressure_norm, error.pressure_norm);
    error.shear_norm    = std::max(kept.shear_norm, error.shear_norm);
  }

  template <int dim>
  void
  Evaluation<dim>::keep(const std::vector<ContactInterface<dim>> &interfaces)
  {
    if (presses_most())
      has_seen_small = small_contacts_are_resolved(interfaces, fields);
    kept = error;
  }

  template <int dim>
  void
  Evaluation<dim>::leave_mesh()
  {
    recovery.reset();
    for (auto *const indicators : {&kept.cell_indicators,
                                   &kept.contact_indicators,
                                   &kept.pollution_indicators,
                                   &kept.shear_indicators})
      indicators->reinit(0);
  }

  template <int dim>
  void
  Evaluation<dim>::judge_by_history()
  {
    error.worst_pressure = std::max(error.worst_pressure, error.contact * pressure_norm);
    error.worst_shear    = std::max(error.worst_shear, error.shear * shear_norm);
    error.worst_bulk     = std::max(error.worst_bulk, error.bulk * energy_norm);
    if (of_history && energy_norm < unloaded_part * error.energy_norm)
      error.bulk = error.worst_bulk / error.energy_norm;
    if (!is_judged_by_history())
      return;
    error.contact = error.worst_pressure / error.pressure_norm;
    error.shear   = error.shear_norm > 0 ? error.worst_shear / error.shear_norm : 0;
  }

  template <int dim>
  void
  Evaluation<dim>::judge_quantity(const std::string      &name,
                                  const QuantitySequence &values,
                                  const double            at_least)
  {
    double result = values.error(dim == 3 && always_converges(name)); // twice the DoFs: 0.8 h
    // Pressures that swing from node to node may do so alike on two meshes, or let the peak jump on the way:
    // it is not known much worse than the whole, unless it has no limit; nor much better, though peaks of two
    // meshes may agree by chance.
    if (name == "peak pressure" && std::isfinite(result) && error.cusp == 0 && !values.keeps_on_changing())
      result = std::max({std::min(result, 3 * error.contact), error.peak, error.contact / 3});
    if (name == "peak pressure")
      result = std::max(result, error.cusp_grows ? 1. : error.cusp);
    // What all meshes miss alike shows in no difference. (Nodes carry the bounds, by areas that are not those
    // of the interpolation.)
    result = std::max({result, at_least, error.data, 3 * error.friction_data});
    // Of a Galerkin solution energies are off by the square of the error in their norm; so are forces that
    // displacements cause, and what forces approach by (half of that: at a sharp rim recovery sees twice the
    // square that there is), and by all that facets leave out. What loads decide changes by rounding only.
    constexpr double rounding = 1e-8;
    if (always_converges(name) && (name == "energy" || result > rounding))
      result = std::max(result,
                        name == "energy" ? std::pow(error.bulk, 2)
                                         : (std::pow(error.bulk, 2) + error.sections) / 2);
    // The work of friction likewise by the shear's (of a pressed and sheared block it was 0.08, 0.02 and
    // 0.005 off where shear^2/2 was 0.06, 0.04 and 0.017). Shear that falls nowhere may do no work: then all
    // meshes of a quarter of the unknowns and more agree.
    constexpr double safety = 4;
    if (name == "dissipation" && result > rounding)
      result = std::max(result, std::min(std::pow(error.shear, 2) / 2, safety * values.spread()));
    error.quantity = result;
  }

  template <int dim>
  bool
  Evaluation<dim>::may_hide(const Model<dim>         &model,
                            const SolutionState<dim> &state,
                            const std::string        &quantity,
                            const double              target,
                            const bool                is_zero) const
  {
    const auto  &interfaces = model.interfaces;
    const double doubt      = std::max(height_in_doubt(interfaces, fields),
                                  error.bulk > target ? error.bulk * state.displacement.linfty_norm() : 0.);
    // What is left of the only pair in an unloaded end was seen when it pressed.
    const bool was_seen = interfaces.size() == 1 && has_touched && is_judged_by_history();
    return (!was_seen && !touches() && error.data >= 1) ||
           (error.quantity && !small_contacts_are_resolved(interfaces, fields)) ||
           (quantity == "contact size" && !sizes_are_resolved(interfaces, fields, target)) ||
           (quantity == "stick size" && is_zero && may_hide_stick(interfaces, state)) ||
           (!was_seen && doubt > 0 && smallest_gap_of_untouched(interfaces, fields) < doubt);
  }

  template struct Evaluation<2>;
  template struct Evaluation<3>;
} // namespace Amontons
