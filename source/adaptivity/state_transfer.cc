#include <amontons/adaptivity/state_transfer.h>
#include <amontons/contact/contact_edge.h>

namespace Amontons
{
  namespace
  {
    // By slave node. Next to the contact it is continued: nodes that close there on the new mesh slip if
    // their neighbours do.
    template <int dim>
    std::vector<Tensor<1, dim>>
    trial_shears(const ContactInterface<dim> &interface, const NodalContacts<dim> &contact)
    {
      std::vector<Tensor<1, dim>> shear(interface.slave->nodes.size());
      for (const auto &row : interface.coupling.rows)
        shear[row.node] = contact[row.node].trial;
      auto continued = shear;
      for (const auto &face : interface.slave->faces)
        for (const unsigned int n : face.nodes)
          if (shear[n].norm() == 0)
            for (const unsigned int other : face.nodes)
              if (shear[other].norm() > continued[n].norm())
                continued[n] = shear[other];
      return continued;
    }
  } // namespace

  namespace
  {
    // What the pairs of which a node is a slave say across the surface. Far from the contact of one of them
    // its values are large and negative: they may not hide that another one touches there.
    template <int dim>
    struct Edge
    {
      NodeDofs<dim>  dofs;
      Tensor<1, dim> inside, outside;
      double         nearest = std::numeric_limits<double>::lowest(); // of the values outside
      bool           touches = false;

      void
      add(const double value, const Tensor<1, dim> &normal)
      {
        touches = touches || value > 0;
        if (value > 0)
          inside += value * normal;
        else if (value > nearest)
          {
            nearest = value;
            outside = value * normal;
          }
      }
      Tensor<1, dim>
      sum() const
      {
        return touches ? inside : outside;
      }
    };
  } // namespace

  template <int dim>
  void
  make_traction_field(const Discretization<dim>                &discretization,
                      const std::vector<ContactInterface<dim>> &interfaces,
                      const std::vector<SurfaceFields<dim>>    &fields,
                      SolutionState<dim>                       &state)
  {
    LA::Vector traction = discretization.make_owned_vector();
    state.peaks.clear();
    std::map<types::global_dof_index, Edge<dim>> edges; // by the first DoF of the node
    const auto                                   add = [&](const auto &dofs, const Tensor<1, dim> &value) {
      for (unsigned int c = 0; c < dim; ++c)
        if (discretization.locally_owned.is_element(dofs[c]))
          traction(dofs[c]) += value[c];
    };
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto  &nodes = interfaces[i].slave->nodes;
        const double peak  = fields[i].peak_pressure;
        const double scale = peak > 0 ? std::pow(peak, -2) : 0;
        const auto   edge  = signed_pressure_square(interfaces[i], fields[i]);
        const auto   shear = trial_shears(interfaces[i], state.contact[i]);
        state.peaks.push_back(peak);
        for (unsigned int n = 0; n < nodes.size(); ++n)
          {
            auto &of_node = edges[nodes[n].dofs[0]];
            of_node.dofs  = nodes[n].dofs;
            of_node.add(scale * edge[n], fields[i].normal[n]);
            add(nodes[n].dofs, shear[n]);
          }
      }
    for (const auto &entry : edges)
      add(entry.second.dofs, entry.second.sum());
    traction.compress(VectorOperation::add);
    state.traction = discretization.make_relevant_vector();
    state.traction = traction;
  }

  template <int dim>
  void
  carry_active_set(const std::vector<ContactInterface<dim>> &interfaces, SolutionState<dim> &state)
  {
    state.contact.clear();
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const PairData    &pair = *interfaces[i].pair;
        NodalContacts<dim> contact(interfaces[i].slave->nodes.size());
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto    &node = interfaces[i].slave->nodes[row.node];
            Tensor<1, dim> field;
            for (unsigned int c = 0; c < dim; ++c)
              field[c] = state.traction(node.dofs[c]);
            const double         edge  = field * node.normal;
            const Tensor<1, dim> shear = field - edge * node.normal;
            const bool           slips = !pair.has_friction() || shear.norm() > 1;
            auto                &known = contact[row.node];
            known.has_multiplier       = true;
            known.state                = pair.tied   ? ContactStatus::stick
                                         : edge <= 0 ? ContactStatus::open
                                         : slips     ? ContactStatus::slip
                                                     : ContactStatus::stick;
            known.pressure             = state.peaks[i] * std::sqrt(std::max(0., edge));
            known.trial                = shear;
          }
        state.contact.push_back(contact);
      }
  }

  template void
  make_traction_field(const Discretization<2> &,
                      const std::vector<ContactInterface<2>> &,
                      const std::vector<SurfaceFields<2>> &,
                      SolutionState<2> &);
  template void
  make_traction_field(const Discretization<3> &,
                      const std::vector<ContactInterface<3>> &,
                      const std::vector<SurfaceFields<3>> &,
                      SolutionState<3> &);
  template void
  carry_active_set(const std::vector<ContactInterface<2>> &, SolutionState<2> &);
  template void
  carry_active_set(const std::vector<ContactInterface<3>> &, SolutionState<3> &);
} // namespace Amontons
