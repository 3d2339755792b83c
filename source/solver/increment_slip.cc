#include <amontons/base/directions.h>
#include <amontons/solver/first_touch.h>
#include <amontons/solver/increment_slip.h>

namespace Amontons
{
  template <int dim>
  IncrementSlip<dim>::IncrementSlip(const Discretization<dim>                &discretization,
                                    const std::vector<ContactInterface<dim>> &interfaces,
                                    const LA::Vector                         &committed)
      : interfaces(interfaces), committed(committed)
  {
    for (const auto &interface : interfaces)
      {
        for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
          if (surface != nullptr)
            for (const auto &node : surface->nodes)
              add_coordinates(node.dofs, node.X);
        if (interface.master.obstacle != nullptr)
          {
            const unsigned int m       = interface.master.carrier;
            const auto        &carrier = discretization.geometry.carriers[m];
            for (unsigned int k = 0; k <= dim; ++k)
              {
                Point<dim> X;
                for (unsigned int d = 0; d < dim; ++d)
                  X[d] = carrier.motion.reference[d] + (k == d + 1 ? carrier.size : 0.);
                add_coordinates(discretization.carrier_dofs[m][k], X);
              }
          }
      }
  }

  template <int dim>
  void
  IncrementSlip<dim>::add_coordinates(const NodeDofs<dim> &dofs, const Point<dim> &X)
  {
    for (unsigned int c = 0; c < dim; ++c)
      reference_coordinate[dofs[c]] = X[c];
  }

  template <int dim>
  void
  IncrementSlip<dim>::remember_partners(const std::vector<SlaveNode<dim>> &nodes,
                                        const SolutionState<dim>          &start)
  {
    const bool goes_on = start.earlier.size() == committed.size() && !start.committed_contact.empty();
    old.assign(nodes.size(), Partners());
    std::vector<std::vector<std::set<unsigned int>>> beside; // by interface and slave node, of its faces
    for (const auto &interface : interfaces)
      {
        beside.emplace_back(interface.slave->nodes.size());
        if (!interface.pair->has_friction())
          continue;
        for (const auto &face : interface.slave->faces)
          for (const unsigned int node : face.unknowns)
            beside.back()[node].insert(face.nodes.begin(), face.nodes.end());
      }
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const auto &node   = nodes[k];
        const auto &slave  = *interfaces[node.interface].slave;
        const auto &around = beside[node.interface][node.node];
        if (!node.frictional || around.empty())
          continue;
        const bool           is_opposite = node.row != numbers::invalid_unsigned_int;
        const Tensor<1, dim> normal      = is_opposite ? node.normal : slave.nodes[node.node].normal;
        old[k].place                     = make_place(slave, around, normal / normal.norm());
        if (!is_opposite)
          continue;
        old[k].weights = aligned(old[k].place, node);
        if (goes_on && start.committed_contact[node.interface][node.node].state == ContactStatus::open)
          move_to_first_touch(start, node, old[k]);
      }
  }

  template <int dim>
  Tensor<2, dim>
  IncrementSlip<dim>::frame(const Place &place, const LA::Vector &u) const
  {
    std::array<Tensor<1, dim>, dim> columns;
    const auto                      along = directions_left<dim>({place.normal});
    for (const auto &[dofs, gamma] : place.gamma)
      for (unsigned int c = 0; c < dim; ++c)
        for (unsigned int i = 0; i < along.size(); ++i)
          columns[i][c] += (gamma * along[i]) * (reference_coordinate.at(dofs[c]) + u(dofs[c]));
    auto &n = columns[dim - 1];
    if constexpr (dim == 2)
      n = cross_product_2d(columns[0]);
    else
      n = cross_product_3d(columns[0], columns[1]);
    n /= n.norm();
    Tensor<2, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int i = 0; i < dim; ++i)
        result[c][i] = columns[i][c];
    return result;
  }

  // The jump z_- of the same material points where the increment before began, in the frame of the last
  // converged state, is a along the surface, likewise z_-- of the one before that. Along the line or parabola
  // through them (first_touch.h) the node closes with the jump l_- z_- + l_-- z_-- along the surface:
  //   v = (1 - n n^T) sum (w - beta - l_- beta_- - l_-- beta_--) x,   beta_- = gamma_j . z_-.
  template <int dim>
  void
  IncrementSlip<dim>::move_to_first_touch(const SolutionState<dim> &start,
                                          const SlaveNode<dim>     &node,
                                          Partners                 &partners) const
  {
    const auto &place     = partners.place;
    const auto  jump_then = [&](const LA::Vector &u) {
      return frame(place, committed) * invert(frame(place, u)) * position_jump(*partners.weights, u);
    };
    const bool           two = start.before_earlier.size() == committed.size();
    const Tensor<1, dim> z   = jump_then(start.earlier),
                         z_2 = two ? jump_then(start.before_earlier) : Tensor<1, dim>();
    const double jump_now    = position_jump(*partners.weights, committed) * place.normal,
                 gap_now = node.gap / node.normal.norm(), closed = jump_now - z * place.normal;
    const auto [before, earlier] =
        first_touch_weights(gap_now,
                            gap_now + closed,
                            two ? gap_now + jump_now - z_2 * place.normal : std::optional<double>(),
                            (start.t - start.committed_t) / (start.committed_t - start.earlier_t));
    if (before == 0)
      return;
    // What slides by more than mu times what it closes by slips on at its bound from the touch; a slip back
    // made up by too long a way would hold it.
    const auto   bound            = shear_bound(*interfaces[node.interface].pair, node.X, start.t, 0);
    const double along            = without<dim>(z, {place.normal}).norm(),
                 held             = bound.value > 0 ? 1 : std::min(1., bound.slope * closed / along);
    const Tensor<1, dim> at_touch = held * (before * z + earlier * z_2);
    for (const auto &[dofs, gamma] : place.gamma)
      for (unsigned int c = 0; c < dim; ++c)
        (*partners.weights)[c][dofs[c]] -= gamma * at_touch;
  }

  // With m the normal, y_j = (1 - m m^T)(x_j - mean of all x_j) and B = sum_j y_j y_j^T + (trace) m m^T:
  //   gamma_j = B^-1 y_j,   so that   (1 - m m^T) sum_j (gamma_j . a) x_j = a   for any a normal to m.
  template <int dim>
  typename IncrementSlip<dim>::Place
  IncrementSlip<dim>::make_place(const ContactSurface<dim>    &slave,
                                 const std::set<unsigned int> &beside,
                                 const Tensor<1, dim>         &normal)
  {
    Place          place{normal, {}};
    Tensor<1, dim> mean;
    for (const unsigned int j : beside)
      mean += Tensor<1, dim>(slave.nodes[j].x) / double(beside.size());
    Tensor<2, dim> B;
    for (const unsigned int j : beside)
      {
        const Tensor<1, dim> way = slave.nodes[j].x - mean, y = way - (way * normal) * normal;
        place.gamma.emplace_back(slave.nodes[j].dofs, y);
        B += outer_product(y, y);
      }
    B += trace(B) * outer_product(normal, normal);
    const Tensor<2, dim> inverse = invert(B);
    for (auto &entry : place.gamma)
      entry.second = inverse * entry.second;
    return place;
  }

  // w - beta
  template <int dim>
  typename IncrementSlip<dim>::Rows
  IncrementSlip<dim>::aligned(const Place &place, const SlaveNode<dim> &node) const
  {
    Rows weights;
    for (unsigned int c = 0; c < dim; ++c)
      weights[c] = node.components[c].equation.coefficients;
    const Tensor<1, dim> jump = position_jump(weights, committed);
    for (const auto &[dofs, gamma] : place.gamma)
      for (unsigned int c = 0; c < dim; ++c)
        weights[c][dofs[c]] -= gamma * jump;
    return weights;
  }

  // sum weight (X + u)
  template <int dim>
  Tensor<1, dim>
  IncrementSlip<dim>::position_jump(const Rows &weights, const LA::Vector &u) const
  {
    Tensor<1, dim> result;
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto &[dof, weight] : weights[c])
        result[c] += weight * (reference_coordinate.at(dof) + u(dof));
    return result;
  }

  // Nodes that nothing was opposite of in the last converged state have partners only now.
  template <int dim>
  typename IncrementSlip<dim>::Rows
  IncrementSlip<dim>::weights(const unsigned int k, const SlaveNode<dim> &node) const
  {
    return old[k].weights ? *old[k].weights : aligned(old[k].place, node);
  }

  // z; without old partners less z_old, which has turned with the slave's normal.
  template <int dim>
  Tensor<1, dim>
  IncrementSlip<dim>::jump(const unsigned int k, const SlaveNode<dim> &node, const LA::Vector &u) const
  {
    if (old[k].weights)
      return position_jump(*old[k].weights, u);
    const auto now = weights(k, node);
    return position_jump(now, u) - (position_jump(now, committed) * old[k].place.normal) *
                                       interfaces[node.interface].slave->nodes[node.node].normal;
  }

  // dv = (1 - n n^T) dz - (n . z) dn - n (dn . z), less its parts across the planes that the node stays in.
  template <int dim>
  typename IncrementSlip<dim>::Rows
  IncrementSlip<dim>::gradient(const unsigned int    k,
                               const SlaveNode<dim> &node,
                               const Rows           &dn,
                               const LA::Vector     &u) const
  {
    const Tensor<1, dim> n = node.normal / node.normal.norm(), z = jump(k, node, u);
    const Rows           dz = weights(k, node);
    Rows                 result;
    for (unsigned int c = 0; c < dim; ++c)
      for (unsigned int d = 0; d < dim; ++d)
        {
          add(result[c], double(c == d) - n[c] * n[d], dz[d]);
          add(result[c], -(n * z) * double(c == d) - n[c] * z[d], dn[d]);
        }
    if (node.at_ridge)
      {
        const Rows whole = std::exchange(result, Rows());
        for (unsigned int j = 1; j < dim; ++j)
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int d = 0; d < dim; ++d)
              add(result[c], node.directions[j][c] * node.directions[j][d], whole[d]);
        return result;
      }
    for (const auto &plane : node.planes)
      {
        Coefficients across;
        for (unsigned int c = 0; c < dim; ++c)
          add(across, plane[c], result[c]);
        for (unsigned int c = 0; c < dim; ++c)
          add(result[c], -plane[c], across);
      }
    return result;
  }

  template class IncrementSlip<2>;
  template class IncrementSlip<3>;
} // namespace Amontons
