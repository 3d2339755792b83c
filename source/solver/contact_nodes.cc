#include <amontons/algebra/node_pattern.h>
#include <amontons/base/directions.h>
#include <amontons/elasticity/linear_elastic.h>
#include <amontons/solver/contact_nodes.h>
#include <amontons/solver/node_planes.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // sum_c direction_c Delta_c = value, for the node of the row.
    template <int dim>
    ContactEquation
    equation_along(const Tensor<1, dim>   &direction,
                   const double            value,
                   const MortarRow<dim>   &row,
                   const SurfaceNode<dim> &node)
    {
      ContactEquation result;
      for (unsigned int c = 0; c < dim; ++c)
        {
          if (direction[c] == 0)
            continue;
          for (const auto &[dofs, weight] : row.slave)
            result.equation.coefficients[dofs[c]] += direction[c] * weight;
          for (const auto &[dofs, weight] : row.master)
            result.equation.coefficients[dofs[c]] -= direction[c] * weight;
          result.candidates.push_back(node.dofs[c]);
        }
      result.equation.value = value;
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<const LinearEquation *>
  holding_equations(const std::vector<SlaveNode<dim>> &nodes, const bool only_tied)
  {
    std::vector<const LinearEquation *> equations;
    for (const auto &node : nodes)
      if (node.tied || !only_tied)
        for (const auto *e : node.holding())
          equations.push_back(&e->equation);
    return equations;
  }

  template <int dim>
  std::string
  places_of(const std::vector<Point<dim>> &points)
  {
    std::ostringstream text;
    text.precision(4);
    for (unsigned int i = 0; i < std::min<std::size_t>(3, points.size()); ++i)
      {
        text << (i == 0 ? "(" : ", (") << points[i][0];
        for (unsigned int d = 1; d < dim; ++d)
          text << ", " << points[i][d];
        text << ")";
      }
    if (points.size() > 3)
      text << " and " << points.size() - 3 << " more";
    return text.str();
  }

  double
  evaluate(const LinearEquation &equation, const LA::Vector &u)
  {
    double sum = 0;
    for (const auto &[dof, coefficient] : equation.coefficients)
      sum += coefficient * u(dof);
    return sum;
  }

  template <int dim>
  std::vector<const ContactEquation *>
  SlaveNode<dim>::holding() const
  {
    if (!tied && !frictional)
      return {&closing};
    std::vector<const ContactEquation *> all;
    for (const auto &component : components)
      all.push_back(&component);
    return all;
  }

  template <int dim>
  Tensor<1, dim>
  SlaveNode<dim>::jump(const LA::Vector &u) const
  {
    Tensor<1, dim> result;
    for (unsigned int k = 0; k < dim; ++k)
      result[k] = evaluate(components[k].equation, u);
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  SlaveNode<dim>::tangential(const Tensor<1, dim> &vector) const
  {
    if (at_ridge)
      {
        Tensor<1, dim> result;
        for (unsigned int k = 1; k < dim; ++k)
          result += (vector * directions[k]) * directions[k];
        return result;
      }
    return without(vector - (vector * normal) / normal.norm_square() * normal, planes);
  }

  template <int dim>
  Tensor<2, dim>
  SlaveNode<dim>::across(const Tensor<1, dim> &direction) const
  {
    Tensor<2, dim> result;
    for (unsigned int a = 0; a < dim; ++a)
      {
        Tensor<1, dim> axis;
        axis[a]   = 1;
        result[a] = tangential(axis) - direction[a] * direction;
      }
    return result;
  }

  template <int dim>
  ContactEquation
  SlaveNode<dim>::held(const unsigned int k) const
  {
    if (planes.empty())
      return components[k];
    ContactEquation result;
    for (unsigned int c = 0; c < dim; ++c)
      if (directions[k][c] != 0)
        {
          result.candidates.push_back(components[c].candidates[0]);
          for (const auto &[dof, weight] : components[c].equation.coefficients)
            result.equation.coefficients[dof] += directions[k][c] * weight;
        }
    return result;
  }

  template <int dim>
  Tensor<1, dim>
  SlaveNode<dim>::tangent(const unsigned int k) const
  {
    if constexpr (dim == 2)
      return cross_product_2d(normal) / normal.norm();
    else
      {
        if (at_ridge)
          return directions[k + 1];
        auto       held   = planes;
        const auto across = without(normal, planes);
        held.push_back(across / across.norm());
        const auto left = directions_left(held);
        return k < left.size() ? left[k] : Tensor<1, dim>();
      }
  }

  template <int dim>
  SlaveNode<dim>
  make_contact_node(const Discretization<dim>                &discretization,
                    const std::vector<ContactInterface<dim>> &interfaces,
                    const unsigned int                        interface,
                    const unsigned int                        row_number,
                    const double                              scaling,
                    const bool                                with_components)
  {
    const auto    &slave        = *interfaces[interface].slave;
    const auto    &pair         = *interfaces[interface].pair;
    const double   modulus      = contact_modulus(discretization.scene.bodies[slave.body].material);
    const auto    &row          = interfaces[interface].coupling.rows[row_number];
    const auto    &surface_node = slave.nodes[row.node];
    SlaveNode<dim> node;
    node.interface  = interface;
    node.node       = row.node;
    node.row        = row_number;
    node.tied       = pair.tied;
    node.frictional = pair.has_friction();
    node.rounding   = 1e-14 * modulus;
    node.area       = row.area;
    node.c          = scaling * modulus / slave.mean_size;
    node.gap        = pair.tied ? 0. : row.gap;
    node.normal     = row.normal;
    for (unsigned int c = 0; c < dim; ++c)
      node.X[c] = surface_node.X[c];
    const auto at   = planes_at(interfaces[interface], row);
    node.at_ridge   = at.ridge;
    node.planes     = at.planes;
    node.directions = at.directions;
    node.closing    = equation_along(row.normal, node.gap, row, surface_node);
    for (unsigned int c = 0; (with_components || node.tied || node.frictional) && c < dim; ++c)
      {
        Tensor<1, dim> unit;
        unit[c]            = 1;
        node.components[c] = equation_along(unit, 0, row, surface_node);
        if (interfaces[interface].master_surface)
          for (const auto &entry : row.master)
            node.components[c].others.push_back(entry.first[c]);
      }
    return node;
  }

  template <int dim>
  bool
  is_wedged(const SlaveNode<dim> &node, const Constraints &supports)
  {
    constexpr double rounding = 1e-6;
    const auto       is_given = [&](const types::global_dof_index dof) {
      const auto *const entries = supports.get_constraint_entries(dof);
      return entries != nullptr && entries->empty();
    };
    unsigned int n_free = 0;
    double       along  = 0; // that axis, of the normal
    for (unsigned int c = 0; c < dim; ++c)
      {
        const auto own = node.components[c].candidates[0];
        for (const auto &[dof, weight] : node.components[c].equation.coefficients)
          if (dof != own && !is_given(dof))
            return false;
        if (is_given(own))
          continue;
        ++n_free;
        along = std::abs(node.normal[c]) / node.normal.norm();
      }
    return n_free == 1 && along > rounding && along < 1 - rounding;
  }

  template <int dim>
  std::vector<SlaveNode<dim>>
  collect_contact_nodes(const Discretization<dim>                &discretization,
                        const std::vector<ContactInterface<dim>> &interfaces,
                        const double                              scaling)
  {
    std::vector<SlaveNode<dim>> nodes;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
        nodes.push_back(make_contact_node(discretization, interfaces, i, r, scaling));
    return nodes;
  }

  template <int dim>
  std::vector<ContactEquation>
  equations_of(const SlaveNode<dim> &node,
               const ContactStatus   state,
               const SlipLaw<dim>   &law,
               const Tensor<1, dim> &origin)
  {
    if (state == ContactStatus::open)
      return {};
    if (state == ContactStatus::stick)
      {
        std::vector<ContactEquation> equations;
        const auto value = node.gap / node.normal.norm_square() * node.normal + node.tangential(origin);
        for (unsigned int k = 0; k < dim; ++k)
          {
            equations.push_back(node.held(k));
            if (!node.tied)
              equations.back().equation.value = value * node.directions[k];
          }
        return equations;
      }
    ContactEquation equation = node.closing;
    if (law.slope != 0)
      {
        equation.candidates.clear();
        for (unsigned int k = 0; k < dim; ++k)
          {
            equation.candidates.push_back(node.components[k].candidates[0]);
            for (const auto &[dof, weight] : node.components[k].equation.coefficients)
              equation.test[dof] += (node.normal[k] + law.slope * law.direction[k]) * weight;
          }
      }
    return {equation};
  }

  template <int dim>
  ContactEquation
  all_components(const SlaveNode<dim> &node)
  {
    ContactEquation result;
    for (const auto &component : node.components)
      {
        result.candidates.push_back(component.candidates[0]);
        for (const auto &entry : component.equation.coefficients)
          result.equation.coefficients[entry.first] = 1;
      }
    return result;
  }

  template <int dim>
  LocalMatrix
  slip_stiffness(const SlaveNode<dim> &node, const SlipLaw<dim> &law)
  {
    LocalMatrix                                  further;
    std::vector<std::pair<unsigned int, double>> terms; // component and weight of each DoF
    for (unsigned int c = 0; c < dim; ++c)
      for (const auto &[dof, weight] : node.components[c].equation.coefficients)
        {
          further.rows.push_back(dof);
          terms.emplace_back(c, weight);
        }
    further.columns             = further.rows;
    const Tensor<2, dim> across = node.across(law.direction);
    further.matrix.reinit(terms.size(), terms.size());
    for (unsigned int i = 0; i < terms.size(); ++i)
      for (unsigned int j = 0; j < terms.size(); ++j)
        {
          const auto [a, weight_a] = terms[i];
          const auto [b, weight_b] = terms[j];
          further.matrix(i, j)     = node.area * law.stiffness * weight_a * weight_b * across[a][b];
        }
    return further;
  }

  template <int dim>
  std::vector<JumpTerm>
  jump_terms(const SlaveNode<dim> &node, const bool normal)
  {
    std::vector<JumpTerm> result;
    for (unsigned int c = 0; c < (normal ? 1 : dim); ++c)
      for (const auto &[dof, weight] : (normal ? node.closing : node.components[c]).equation.coefficients)
        result.push_back({dof, c, weight});
    return result;
  }

  LocalMatrix
  stiffness_of_traction(const std::vector<JumpTerm>     &jump,
                        const double                     area,
                        const std::vector<Coefficients> &dt)
  {
    LocalMatrix result;
    auto       &columns = result.columns;
    for (const auto &component : dt)
      for (const auto &entry : component)
        columns.push_back(entry.first);
    sort_once(columns);
    FullMatrix<double> of_traction(dt.size(), columns.size());
    for (unsigned int c = 0; c < dt.size(); ++c)
      for (const auto &[dof, value] : dt[c])
        of_traction(c, std::lower_bound(columns.begin(), columns.end(), dof) - columns.begin()) = value;
    result.matrix.reinit(jump.size(), columns.size());
    for (unsigned int i = 0; i < jump.size(); ++i)
      {
        result.rows.push_back(jump[i].dof);
        for (unsigned int j = 0; j < columns.size(); ++j)
          result.matrix(i, j) = area * jump[i].weight * of_traction(jump[i].component, j);
      }
    return result;
  }

  template <int dim>
  std::vector<LinearEquation>
  resistance_of(const SlaveNode<dim> &node, const ContactStatus state, const SlipLaw<dim> &law)
  {
    std::vector<LinearEquation> all;
    for (const auto &e : equations_of(node, state, law, Tensor<1, dim>()))
      all.push_back(e.equation);
    if constexpr (dim == 3)
      if (node.frictional && state == ContactStatus::slip && law.stiffness > 0)
        {
          const auto across = node.tangential(cross_product_3d(node.normal, law.direction));
          all.emplace_back();
          for (unsigned int c = 0; c < dim; ++c)
            for (const auto &[dof, weight] : node.components[c].equation.coefficients)
              all.back().coefficients[dof] += across[c] * weight;
        }
    return all;
  }

  template <int dim>
  std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<SlaveNode<dim>>        &nodes,
                              const std::vector<ContactInterface<dim>> &interfaces,
                              const FloatingBodies<dim>                &floating,
                              const std::vector<double>                &gaps)
  {
    constexpr double    far = std::numeric_limits<double>::max();
    std::vector<double> smallest(interfaces.size(), far), nearest(floating.floats().size(), far); // by owner
    const auto          for_floating_owners = [&](const unsigned int k, const auto &action) {
      for (const auto &entry : nodes[k].closing.equation.coefficients)
        if (const auto owner = floating.owner_of(entry.first); floating.floats()[owner])
          action(owner);
    };
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        smallest[nodes[k].interface] = std::min(smallest[nodes[k].interface], gaps[k]);
        for_floating_owners(
            k, [&](const unsigned int owner) { nearest[owner] = std::min(nearest[owner], gaps[k]); });
      }
    std::vector<bool> closed;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const double h     = interfaces[nodes[k].interface].slave->mean_size,
                     first = smallest[nodes[k].interface];
        bool touch         = nodes[k].tied || gaps[k] <= 1e-10 * h;
        if (!touch && gaps[k] <= first + 0.02 * h)
          for_floating_owners(
              k, [&](const unsigned int owner) { touch = touch || first <= nearest[owner] + 0.5 * h; });
        closed.push_back(touch);
      }
    return closed;
  }

  template SlaveNode<2>
  make_contact_node(const Discretization<2> &,
                    const std::vector<ContactInterface<2>> &,
                    const unsigned int,
                    const unsigned int,
                    const double,
                    const bool);
  template SlaveNode<3>
  make_contact_node(const Discretization<3> &,
                    const std::vector<ContactInterface<3>> &,
                    const unsigned int,
                    const unsigned int,
                    const double,
                    const bool);
  template bool
  is_wedged(const SlaveNode<2> &, const Constraints &);
  template bool
  is_wedged(const SlaveNode<3> &, const Constraints &);
  template std::vector<const LinearEquation *>
  holding_equations(const std::vector<SlaveNode<2>> &, const bool);
  template std::vector<const LinearEquation *>
  holding_equations(const std::vector<SlaveNode<3>> &, const bool);
  template std::string
  places_of(const std::vector<Point<2>> &);
  template std::string
  places_of(const std::vector<Point<3>> &);
  template std::vector<JumpTerm>
  jump_terms(const SlaveNode<2> &, const bool);
  template std::vector<JumpTerm>
  jump_terms(const SlaveNode<3> &, const bool);
  template struct SlaveNode<2>;
  template struct SlaveNode<3>;
  template std::vector<SlaveNode<2>>
  collect_contact_nodes(const Discretization<2> &, const std::vector<ContactInterface<2>> &, const double);
  template std::vector<SlaveNode<3>>
  collect_contact_nodes(const Discretization<3> &, const std::vector<ContactInterface<3>> &, const double);
  template std::vector<ContactEquation>
  equations_of(const SlaveNode<2> &, const ContactStatus, const SlipLaw<2> &, const Tensor<1, 2> &);
  template std::vector<ContactEquation>
  equations_of(const SlaveNode<3> &, const ContactStatus, const SlipLaw<3> &, const Tensor<1, 3> &);
  template ContactEquation
  all_components(const SlaveNode<2> &);
  template ContactEquation
  all_components(const SlaveNode<3> &);
  template LocalMatrix
  slip_stiffness(const SlaveNode<2> &, const SlipLaw<2> &);
  template LocalMatrix
  slip_stiffness(const SlaveNode<3> &, const SlipLaw<3> &);
  template std::vector<LinearEquation>
  resistance_of(const SlaveNode<2> &, const ContactStatus, const SlipLaw<2> &);
  template std::vector<LinearEquation>
  resistance_of(const SlaveNode<3> &, const ContactStatus, const SlipLaw<3> &);
  template std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<SlaveNode<2>> &,
                              const std::vector<ContactInterface<2>> &,
                              const FloatingBodies<2> &,
                              const std::vector<double> &);
  template std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<SlaveNode<3>> &,
                              const std::vector<ContactInterface<3>> &,
                              const FloatingBodies<3> &,
                              const std::vector<double> &);
} // namespace Amontons
