#include <amontons/solver/penalty.h>

namespace Amontons
{
  template <int dim>
  Tensor<1, dim>
  Penalty<dim>::trial(const unsigned int k) const
  {
    const auto    &node   = contact.nodes()[k];
    Tensor<1, dim> result = eps(k) * contact.slip(k, state.displacement);
    if (!kept.empty())
      result += node.tangential(kept[k].shear);
    else if (!state.committed_contact.empty())
      result += node.tangential(state.committed_contact[node.interface][node.node].shear);
    return result;
  }

  template <int dim>
  NodalContact<dim>
  Penalty<dim>::answer(const unsigned int k, const NodeStates<dim> &states) const
  {
    NodalContact<dim> result;
    if (states[k] == ContactStatus::open)
      {
        result.gap = contact.open_gap(k, state.displacement) - (kept.empty() ? 0 : kept[k].pressure / eps(k));
        if (contact.nodes()[k].frictional && contact.is_opposite(k))
          result.slip = trial(k) / eps(k);
        return result;
      }
    result.pressure = pressure(k);
    if (!contact.nodes()[k].frictional)
      return result;
    const auto q = result.shear = trial(k);
    if (const double length = q.norm(); states[k] == ContactStatus::slip && length > 0)
      {
        result.shear = states.bound(k, result.pressure).value / length * q;
        result.slip  = (q - result.shear) / eps(k);
      }
    return result;
  }

  template <int dim>
  void
  Penalty<dim>::add_forces(const unsigned int k, const NodeStates<dim> &states, LA::Vector &forces) const
  {
    const auto          &node = contact.nodes()[k];
    const auto           at   = answer(k, states);
    const Tensor<1, dim> t    = at.pressure * node.normal + at.shear;
    for (const auto &[dof, c, weight] : jump_terms(node, !node.frictional))
      if (forces.in_local_range(dof))
        forces(dof) -= node.area * weight * (node.frictional ? t[c] : at.pressure);
  }

  // area sum weight_c dt_c with dt = n dp + dq, dp = -eps dg and, with d = trial/|trial|,
  //   stick: dq = eps dv,   slip: dq = phi' dp d + (phi eps/|trial|) (1 - d d^T) dv.
  template <int dim>
  LocalMatrix
  Penalty<dim>::stiffness(const unsigned int k, const NodeStates<dim> &states) const
  {
    const auto &node = contact.nodes()[k];
    const auto  dg   = contact.gap_gradient(k);
    // By component; frictionless: the pressure alone.
    std::vector<Coefficients> dt(node.frictional ? dim : 1);
    if (!node.frictional)
      add(dt[0], -eps(k), dg);
    else
      {
        const auto           dv     = contact.slip_gradient(k, state.displacement);
        const auto           q      = trial(k);
        const bool           slips  = states[k] == ContactStatus::slip && q.norm() > 0;
        const Tensor<1, dim> d      = slips ? q / q.norm() : Tensor<1, dim>();
        const auto           bound  = states.bound(k, pressure(k));
        const double         across = slips ? bound.value / q.norm() * eps(k) : eps(k);
        for (unsigned int c = 0; c < dim; ++c)
          {
            add(dt[c], -eps(k) * (node.normal[c] + (slips ? bound.slope * d[c] : 0.)), dg);
            for (unsigned int e = 0; e < dim; ++e)
              add(dt[c], across * (double(c == e) - d[c] * d[e]), dv[e]);
          }
      }
    return stiffness_of_traction(jump_terms(node, !node.frictional), node.area, dt);
  }

  template class Penalty<2>;
  template class Penalty<3>;
} // namespace Amontons
