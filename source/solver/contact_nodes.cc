#include <amontons/elasticity/linear_elastic.h>
#include <amontons/solver/contact_nodes.h>

namespace Amontons
{
  namespace
  {
    // Statements of one row: frictionless, one with the normal; tied, one per component.
    template <int dim>
    std::vector<ContactEquation>
    equations_of(const CouplingRow<dim> &row, const SurfaceNode<dim> &node, const bool tied)
    {
      std::vector<ContactEquation> equations;
      for (unsigned int k = 0; k < (tied ? dim : 1); ++k)
        {
          ContactEquation result;
          for (unsigned int c = 0; c < dim; ++c)
            {
              const double n = tied ? double(c == k) : row.normal[c];
              if (n == 0)
                continue;
              for (const auto &[dofs, weight] : row.slave)
                result.equation.coefficients[dofs[c]] += n * weight;
              for (const auto &[dofs, weight] : row.master)
                result.equation.coefficients[dofs[c]] -= n * weight;
              result.candidates.push_back(node.dofs[c]);
            }
          result.equation.value = tied ? 0. : row.gap;
          equations.push_back(result);
        }
      return equations;
    }
  } // namespace

  double
  evaluate(const LinearEquation &equation, const LA::Vector &u)
  {
    double sum = 0;
    for (const auto &[dof, coefficient] : equation.coefficients)
      sum += coefficient * u(dof);
    return sum;
  }

  template <int dim>
  std::vector<CandidateNode>
  collect_contact_nodes(const Discretization<dim>                &discretization,
                        const std::vector<ContactInterface<dim>> &interfaces,
                        const double                              scaling)
  {
    std::vector<CandidateNode> nodes;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        const auto  &slave    = *interfaces[i].slave;
        const auto  &material = discretization.scene.bodies[slave.body].material;
        const double c        = scaling * contact_modulus(material) / slave.mean_size;
        for (unsigned int r = 0; r < interfaces[i].coupling.rows.size(); ++r)
          {
            const auto &row  = interfaces[i].coupling.rows[r];
            const bool  tied = interfaces[i].pair->tied;
            nodes.push_back({i, r, tied, 1e-14 * contact_modulus(material), row.area, c, equations_of(row, slave.nodes[row.node], tied)});
          }
      }
    return nodes;
  }

  template <int dim>
  std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<CandidateNode>         &nodes,
                              const std::vector<ContactInterface<dim>> &interfaces,
                              const FloatingBodies<dim>                &floating,
                              const LA::Vector                         &u)
  {
    std::vector<double> gaps;
    std::vector<double> smallest(interfaces.size(), std::numeric_limits<double>::max());
    for (const auto &node : nodes)
      {
        gaps.push_back(node.equations[0].equation.value - evaluate(node.equations[0].equation, u));
        smallest[node.interface] = std::min(smallest[node.interface], gaps.back());
      }
    std::vector<bool> closed;
    for (unsigned int k = 0; k < nodes.size(); ++k)
      {
        const auto &slave = *interfaces[nodes[k].interface].slave;
        bool        touch = nodes[k].tied || gaps[k] <= 1e-10 * slave.mean_size;
        for (const auto &entry : nodes[k].equations[0].equation.coefficients)
          if (!touch && floating.floats()[floating.owner_of(entry.first)])
            touch = gaps[k] <= smallest[nodes[k].interface] + 0.02 * slave.mean_size;
        closed.push_back(touch);
      }
    return closed;
  }

  template std::vector<CandidateNode>
  collect_contact_nodes(const Discretization<2> &, const std::vector<ContactInterface<2>> &, const double);
  template std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<CandidateNode> &,
                              const std::vector<ContactInterface<2>> &,
                              const FloatingBodies<2> &,
                              const LA::Vector &);
  template std::vector<CandidateNode>
  collect_contact_nodes(const Discretization<3> &, const std::vector<ContactInterface<3>> &, const double);
  template std::vector<bool>
  first_guess_of_closed_nodes(const std::vector<CandidateNode> &,
                              const std::vector<ContactInterface<3>> &,
                              const FloatingBodies<3> &,
                              const LA::Vector &);
} // namespace Amontons
