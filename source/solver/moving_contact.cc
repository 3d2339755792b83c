#include <amontons/solver/moving_contact.h>

namespace Amontons
{
  namespace
  {
    // Readable.
    template <int dim>
    LA::Vector
    committed_of(const SolutionState<dim> &state, const Discretization<dim> &discretization)
    {
      return state.committed.size() == discretization.dof_handler.n_dofs()
                 ? state.committed
                 : discretization.make_relevant_vector();
    }

    template <int dim>
    Tensor<1, dim>
    along(const SlaveNode<dim> &node, const Tensor<1, dim> &vector)
    {
      Tensor<1, dim> result;
      for (unsigned int k = 0; k < dim; ++k)
        result[k] = vector * node.directions[k];
      return result;
    }

    template <int dim>
    bool
    is_along_axes(const std::vector<Tensor<1, dim>> &planes)
    {
      return std::all_of(planes.begin(), planes.end(), [](const auto &plane) {
        double largest = 0;
        for (unsigned int c = 0; c < dim; ++c)
          largest = std::max(largest, std::abs(plane[c]));
        return largest > 1 - 1e-12;
      });
    }
  } // namespace

  template <int dim>
  MovingContact<dim>::MovingContact(const Discretization<dim>          &discretization,
                                    const Constraints                  &supports,
                                    std::vector<ContactInterface<dim>> &interfaces,
                                    const SolutionState<dim>           &start,
                                    const double                        scaling)
      : discretization(discretization), supports(supports), interfaces(interfaces), scaling(scaling),
        t(start.committed_t), slips(discretization, interfaces, committed_of(start, discretization)),
        derivatives(interfaces.size())
  {
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        node_of.emplace_back();
        for (unsigned int n = 0; n < interfaces[i].slave->nodes.size(); ++n)
          {
            node_of[i].push_back(all.size());
            SlaveNode<dim> node{};
            node.interface  = i;
            node.node       = n;
            node.row        = numbers::invalid_unsigned_int;
            node.tied       = interfaces[i].pair->tied;
            node.frictional = interfaces[i].pair->has_friction();
            node.area       = 0;
            for (unsigned int c = 0; c < dim; ++c)
              node.X[c] = interfaces[i].slave->nodes[n].X[c];
            all.push_back(node);
          }
      }
    move(slips.start());
    old_partners = OldPartners<dim>(interfaces);
    slips.remember_partners(all, start);
    t = start.t;
  }

  template <int dim>
  void
  MovingContact<dim>::move(const LA::Vector &u)
  {
    couple_moved(discretization, supports, u, t, interfaces);
    for (auto &node : all)
      {
        node.row  = numbers::invalid_unsigned_int;
        node.gap  = std::numeric_limits<double>::max();
        node.area = 0;
      }
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
        {
          auto &node = all[node_of[i][interfaces[i].coupling.rows[r].node]];
          node       = make_contact_node(discretization, interfaces, i, r, scaling, true);
          // test functions only
          node.closing.equation.value = 0;
          node.wedged                 = node.frictional && is_wedged(node, supports);
        }
  }

  template <int dim>
  Tensor<1, dim>
  MovingContact<dim>::slip(const unsigned int k, const LA::Vector &u) const
  {
    return all[k].tied ? Tensor<1, dim>() : slips.value(k, all[k], u);
  }

  template <int dim>
  double
  MovingContact<dim>::violation(const unsigned int k, const ContactStatus state, const LA::Vector &u) const
  {
    if (state == ContactStatus::open || !is_opposite(k))
      return 0;
    if (all[k].tied)
      return along(all[k], all[k].jump(u)).norm();
    const double length = all[k].normal.norm();
    if (state == ContactStatus::slip)
      return std::abs(all[k].gap) / length;
    auto E = slip(k, u) - all[k].gap / length * (all[k].normal / length);
    if (all[k].at_ridge)
      return along(all[k], E).norm();
    for (unsigned int c = 0; c < dim; ++c)
      if (supports.is_constrained(all[k].components[c].candidates[0]) && is_along_axes(all[k].planes) &&
          !others_hold(all[k].components[c], supports))
        E[c] = 0;
    return E.norm();
  }

  template <int dim>
  std::vector<ContactEquation>
  MovingContact<dim>::equations(const unsigned int  k,
                                const ContactStatus state,
                                const SlipLaw<dim> &law) const
  {
    auto result = equations_of(all[k], state, law, Tensor<1, dim>());
    for (auto &equation : result)
      equation.equation.value = 0;
    return result;
  }

  template <int dim>
  std::vector<unsigned int>
  MovingContact<dim>::neighbours(const NodeStates<dim> &states) const
  {
    std::set<unsigned int> result;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (const auto &face : interfaces[i].slave->faces)
        {
          const auto is_closed = [&](const unsigned int node) {
            return states[node_of[i][node]] != ContactStatus::open;
          };
          if (std::any_of(face.unknowns.begin(), face.unknowns.end(), is_closed))
            for (const unsigned int node : face.unknowns)
              if (!is_closed(node) && is_opposite(node_of[i][node]))
                result.insert(node_of[i][node]);
        }
    return {result.begin(), result.end()};
  }

  template <int dim>
  void
  MovingContact<dim>::differentiate(const NodeStates<dim> &states)
  {
    differentiated.assign(all.size(), numbers::invalid_unsigned_int);
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied)
          continue;
        const auto       &rows = interfaces[i].coupling.rows;
        std::vector<bool> wanted;
        for (unsigned int r = 0; r < rows.size(); ++r)
          {
            const unsigned int k = node_of[i][rows[r].node];
            wanted.push_back(states[k] != ContactStatus::open);
            if (wanted.back())
              differentiated[k] = r;
          }
        derivatives[i] = std::make_unique<CouplingDerivatives<dim>>(discretization, interfaces[i], wanted);
      }
  }

  template <int dim>
  bool
  MovingContact<dim>::is_differentiated(const NodeStates<dim> &states) const
  {
    for (unsigned int k = 0; k < all.size(); ++k)
      if (!all[k].tied && states[k] != ContactStatus::open &&
          (k >= differentiated.size() || differentiated[k] == numbers::invalid_unsigned_int))
        return false;
    return true;
  }

  // d n = (1 - n n^T)/|normal| d normal
  template <int dim>
  typename MovingContact<dim>::Rows
  MovingContact<dim>::unit_normal_gradient(const unsigned int k) const
  {
    const double         length = all[k].normal.norm();
    const Tensor<1, dim> n      = all[k].normal / length;
    const auto          &of     = gradient(k).normal;
    Rows                 result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        if (const double factor = (double(c == d) - n[c] * n[d]) / length; factor != 0)
          add(result[c], factor, of[d]);
    return result;
  }

  template <int dim>
  std::array<Coefficients, dim>
  MovingContact<dim>::slip_gradient(const unsigned int k, const LA::Vector &u) const
  {
    return slips.gradient(k, all[k], unit_normal_gradient(k), u);
  }

  template <int dim>
  Tensor<1, dim>
  MovingContact<dim>::row_values(const unsigned int k, const ContactStatus state, const LA::Vector &u) const
  {
    const SlaveNode<dim> &node = all[k];
    if (node.tied)
      return along(node, -node.jump(u));
    if (state == ContactStatus::stick)
      return along(node, node.gap / node.normal.norm_square() * node.normal - slip(k, u));
    Tensor<1, dim> values;
    values[0] = node.gap;
    return values;
  }

  template <int dim>
  std::vector<ContactRow>
  MovingContact<dim>::contact_rows(const unsigned int                                         k,
                                   const ContactStatus                                        state,
                                   const std::vector<std::optional<types::global_dof_index>> &pivots,
                                   const LA::Vector                                          &u) const
  {
    const SlaveNode<dim> &node   = all[k];
    const auto            values = row_values(k, state, u);
    Rows                  left;
    if (node.tied)
      for (unsigned int c = 0; c < dim; ++c)
        left[c] = node.components[c].equation.coefficients;
    else if (state == ContactStatus::slip)
      add(left[0], -1, gradient(k).gap);
    else
      {
        left = slip_gradient(k, u);
        for (unsigned int c = 0; c < dim; ++c)
          add(left[c], -node.normal[c] / node.normal.norm_square(), gradient(k).gap);
      }
    if (state == ContactStatus::stick && !node.planes.empty())
      {
        const Rows by_axis = left;
        left               = Rows();
        for (unsigned int j = 0; j < dim; ++j)
          for (unsigned int c = 0; c < dim; ++c)
            add(left[j], node.directions[j][c], by_axis[c]);
      }
    // Components whose test functions the supports own have no row: the others stand for them.
    std::vector<ContactRow> rows;
    for (unsigned int c = 0; c < pivots.size(); ++c)
      if (pivots[c])
        rows.push_back({*pivots[c], {left[c], values[c]}});
    return rows;
  }

  // The traction t = p normal + q of a slipping node turns with its normal (p and |q| fixed):
  //   dt = p d normal - n (q . dn) + stiffness (1 - d d^T) dv,
  // with force area dt . d(jump).
  template <int dim>
  LocalMatrix
  MovingContact<dim>::turning_traction(const unsigned int       k,
                                       const SlipLaw<dim>      &law,
                                       const NodalContact<dim> &answer,
                                       const LA::Vector        &u) const
  {
    const SlaveNode<dim> &node = all[k];
    const Tensor<1, dim>  n    = node.normal / node.normal.norm();
    Rows                  dt;
    for (unsigned int c = 0; c < dim; ++c)
      add(dt[c], answer.pressure, gradient(k).normal[c]);
    if (node.frictional)
      {
        const Rows dn = unit_normal_gradient(k);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            add(dt[c], -n[c] * answer.shear[d], dn[d]);
      }
    if (law.stiffness > 0)
      {
        const Rows           dv     = slip_gradient(k, u);
        const Tensor<2, dim> across = node.across(law.direction);
        for (unsigned int c = 0; c < dim; ++c)
          for (unsigned int d = 0; d < dim; ++d)
            add(dt[c], law.stiffness * across[c][d], dv[d]);
      }

    return stiffness_of_traction(jump_terms(node, false), node.area, {dt.begin(), dt.end()});
  }

  template <int dim>
  std::vector<LocalMatrix>
  MovingContact<dim>::links() const
  {
    std::vector<LocalMatrix> result;
    for (const auto &part : derivatives)
      if (part)
        for (const auto &dofs : part->links())
          result.push_back({dofs, dofs, FullMatrix<double>()});
    return result;
  }

  template <int dim>
  std::vector<LocalMatrix>
  MovingContact<dim>::stiffness(const NodeStates<dim>    &states,
                                const NodalContacts<dim> &answers,
                                const LA::Vector         &u,
                                const bool                by_penalty) const
  {
    std::vector<LocalMatrix> result;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        if (interfaces[i].pair->tied)
          continue;
        std::vector<Tensor<1, dim>> tractions(derivatives[i]->rows().size());
        for (const unsigned int k : node_of[i])
          if (states[k] != ContactStatus::open && differentiated[k] < tractions.size())
            tractions[differentiated[k]] = answers[k].pressure * all[k].normal + answers[k].shear;
        for (auto &part : derivatives[i]->stiffness(tractions))
          result.push_back(std::move(part));
      }
    for (unsigned int k = 0; k < all.size(); ++k)
      if (!all[k].tied && is_opposite(k) &&
          (states[k] == ContactStatus::slip || (by_penalty && states[k] == ContactStatus::stick)) &&
          discretization.locally_owned.is_element(all[k].components[0].candidates[0]))
        result.push_back(turning_traction(k, by_penalty ? SlipLaw<dim>() : states.law(k), answers[k], u));
    return result;
  }

  template class MovingContact<2>;
  template class MovingContact<3>;
} // namespace Amontons
