#include <amontons/friction/linear_complementarity.h>
#include <amontons/solver/condensed_friction.h>

namespace Amontons
{
  namespace
  {
    // p, q+, q- and lambda of all nodes, one kind after the other: forces (tractions would make the matrix
    // unsymmetric), in units of force/c of the largest node.
    struct Unknowns
    {
      std::vector<unsigned int> node;   // by number
      std::vector<double>       factor; // from these units to tractions over c
      unsigned int
      n() const
      {
        return node.size();
      }
      unsigned int
      shear(const unsigned int i, const int sign) const
      {
        return (sign > 0 ? 1 : 2) * n() + i;
      }
      unsigned int
      slip(const unsigned int i) const
      {
        return 3 * n() + i;
      }
    };

    template <int dim>
    double
    slip_along(const SlaveNode<dim> &node, const NodalContact<dim> &answer)
    {
      return node.frictional ? answer.slip * node.tangent() : 0.;
    }

    // The columns of M that responses make.
    template <int dim>
    void
    fill_columns(const BaseSolution<dim>                         &base,
                 const typename ActiveSetLookahead<dim>::Respond &respond,
                 const Unknowns                                  &unknowns,
                 FullMatrix<double>                              &M)
    {
      std::vector<ContactInput> inputs;
      std::vector<unsigned int> columns, of;
      for (unsigned int j = 0; j < unknowns.n(); ++j)
        for (const auto input : {NodeInput::across, NodeInput::along})
          if (const unsigned int k = unknowns.node[j];
              input == NodeInput::across || (base.nodes[k].frictional && base.movable[k]))
            {
              inputs.emplace_back(k, input);
              columns.push_back(input == NodeInput::across ? j : unknowns.shear(j, 1));
              of.push_back(j);
            }
      const auto responses = respond(inputs);
      for (unsigned int r = 0; r < inputs.size(); ++r)
        {
          for (unsigned int i = 0; i < unknowns.n(); ++i)
            {
              const auto  &answer = responses[r][unknowns.node[i]];
              const double factor = unknowns.factor[of[r]],
                           v      = factor * slip_along(base.nodes[unknowns.node[i]], answer);
              M(i, columns[r])    = factor * answer.gap;
              for (const int sign : {1, -1})
                M(unknowns.shear(i, sign), columns[r]) = -sign * v;
            }
          if (inputs[r].second == NodeInput::along)
            for (unsigned int i = 0; i < 3 * unknowns.n(); ++i)
              M(i, unknowns.shear(of[r], -1)) = -M(i, columns[r]);
        }
    }

    template <int dim>
    Unknowns
    number_unknowns(const BaseSolution<dim> &base)
    {
      Unknowns unknowns;
      double   largest = 0;
      for (unsigned int k = 0; k < base.nodes.size(); ++k)
        if (!base.nodes[k].tied)
          {
            unknowns.node.push_back(k);
            largest = std::max(largest, base.nodes[k].area * base.nodes[k].c);
          }
      for (const unsigned int k : unknowns.node)
        unknowns.factor.push_back(largest / (base.nodes[k].area * base.nodes[k].c));
      return unknowns;
    }

    // M and q of the inequalities.
    template <int dim>
    void
    fill_problem(const BaseSolution<dim>                         &base,
                 const typename ActiveSetLookahead<dim>::Respond &respond,
                 const std::vector<ShearBound>                   &bounds,
                 const Unknowns                                  &unknowns,
                 FullMatrix<double>                              &M,
                 Vector<double>                                  &q)
    {
      fill_columns(base, respond, unknowns, M);
      for (unsigned int i = 0; i < unknowns.n(); ++i)
        {
          const unsigned int k    = unknowns.node[i];
          const auto        &node = base.nodes[k];
          const double       v    = slip_along(node, base.answers[k]);
          q[i]                    = base.answers[k].gap;
          if (node.frictional && base.movable[k])
            {
              q[unknowns.slip(i)]    = bounds[k].value / (node.c * unknowns.factor[i]);
              M(unknowns.slip(i), i) = bounds[k].slope;
            }
          for (const int sign : {1, -1})
            {
              q[unknowns.shear(i, sign)]                   = -sign * v;
              M(unknowns.shear(i, sign), unknowns.slip(i)) = 1;
              M(unknowns.slip(i), unknowns.shear(i, sign)) = -1;
            }
        }
    }
  } // namespace

  template <int dim>
  std::optional<NodalContacts<dim>>
  solve_condensed_friction(const BaseSolution<dim>                         &base,
                           const typename ActiveSetLookahead<dim>::Respond &respond,
                           const std::vector<ShearBound>                   &bounds)
  {
    const auto         unknowns = number_unknowns(base);
    const unsigned int n        = unknowns.n();
    FullMatrix<double> M(4 * n, 4 * n);
    Vector<double>     q(4 * n);
    fill_problem(base, respond, bounds, unknowns, M, q);
    const double size = q.linfty_norm();
    if (size == 0)
      return {};
    q /= size;
    const auto z = complementary_solution(M, q);
    if (!z)
      return {};
    NodalContacts<dim> result(base.nodes.size());
    for (unsigned int k = 0; k < base.nodes.size(); ++k)
      result[k].state = base.states[k];
    for (unsigned int i = 0; i < n; ++i)
      {
        const unsigned int k      = unknowns.node[i];
        const auto        &node   = base.nodes[k];
        const double       unit   = size * node.c * unknowns.factor[i];
        auto              &answer = result[k];
        answer.pressure           = unit * (*z)[i];
        answer.shear = unit * ((*z)[unknowns.shear(i, 1)] - (*z)[unknowns.shear(i, -1)]) * node.tangent();
        answer.state = (*z)[i] == 0                                     ? ContactStatus::open
                       : node.frictional && (*z)[unknowns.slip(i)] == 0 ? ContactStatus::stick
                                                                        : ContactStatus::slip;
      }
    return result;
  }

  // Of each node that takes part, with pressures over c: z >= 0 is the pressure of one that the base has open
  // and the gap of one that it has closed, w >= 0 the other of the two: w = q + M z.
  template <int dim>
  class CondensedContact
  {
  public:
    CondensedContact(const BaseSolution<dim> &base, const typename ActiveSetLookahead<dim>::Respond &respond)
        : base(base), respond(respond), takes_part(base.nodes.size(), false)
    {
      for (unsigned int k = 0; k < base.nodes.size(); ++k)
        q.push_back(base.nodes[k].tied ? 0. : dependent(k, base.answers[k]));
      size =
          std::max(1e-300, std::abs(*std::max_element(q.begin(), q.end(), [](const double a, const double b) {
                     return std::abs(a) < std::abs(b);
                   })));
    }

    // The others that pull or overlap, by more than rounding.
    std::vector<unsigned int>
    wrong() const
    {
      std::vector<unsigned int> result;
      for (unsigned int k = 0; k < base.nodes.size(); ++k)
        if (!takes_part[k] && !base.nodes[k].tied && value(k) < -1e-10 * size)
          result.push_back(k);
      return result;
    }

    void
    add(const std::vector<unsigned int> &more)
    {
      std::vector<ContactInput> inputs;
      for (const unsigned int k : more)
        inputs.emplace_back(k, NodeInput::across);
      auto found = respond(inputs);
      for (unsigned int i = 0; i < more.size(); ++i)
        {
          const unsigned int k = more[i];
          takes_part[k]        = true;
          nodes.push_back(k);
          own.push_back(is_open(k) ? found[i][k].pressure / base.nodes[k].c : found[i][k].gap);
          responses.push_back(std::move(found[i]));
        }
    }

    unsigned int
    n() const
    {
      return nodes.size();
    }

    // False: the path ends on a ray.
    bool
    solve()
    {
      FullMatrix<double> M(n(), n());
      Vector<double>     q_of_nodes(n());
      for (unsigned int i = 0; i < n(); ++i)
        {
          q_of_nodes[i] = q[nodes[i]] / size;
          for (unsigned int j = 0; j < n(); ++j)
            M(i, j) = dependent(nodes[i], responses[j][nodes[i]]) / own[j];
        }
      const auto solution = complementary_solution(M, q_of_nodes);
      if (solution)
        z = *solution;
      return solution.has_value();
    }

    NodalContacts<dim>
    answers() const
    {
      NodalContacts<dim> result = base.answers;
      for (unsigned int k = 0; k < result.size(); ++k)
        {
          result[k].state = base.states[k];
          if (!base.nodes[k].tied && !is_open(k))
            result[k].pressure = base.nodes[k].c * value(k);
        }
      for (unsigned int j = 0; j < n(); ++j)
        if (auto &answer = result[nodes[j]]; z[j] > 0)
          {
            answer.state    = is_open(nodes[j]) ? ContactStatus::slip : ContactStatus::open;
            answer.pressure = is_open(nodes[j]) ? size * z[j] * base.nodes[nodes[j]].c : 0;
          }
      return result;
    }

  private:
    bool
    is_open(const unsigned int k) const
    {
      return base.states[k] == ContactStatus::open;
    }
    // Of an answer, what w is.
    double
    dependent(const unsigned int k, const NodalContact<dim> &answer) const
    {
      return is_open(k) ? answer.gap : answer.pressure / base.nodes[k].c;
    }
    // w of any node
    double
    value(const unsigned int k) const
    {
      double w = q[k];
      for (unsigned int j = 0; j < z.size(); ++j)
        w += size * z[j] / own[j] * dependent(k, responses[j][k]);
      return w;
    }

    const BaseSolution<dim>                         &base;
    const typename ActiveSetLookahead<dim>::Respond &respond;
    std::vector<bool>                                takes_part;
    std::vector<double>                              q;
    double                                           size; // of q; z and M are without
    std::vector<unsigned int>                        nodes;
    std::vector<NodalContacts<dim>>                  responses; // of these to their inputs
    std::vector<double>                              own;       // z that these inputs are
    Vector<double>                                   z;
  };

  template <int dim>
  std::optional<NodalContacts<dim>>
  solve_condensed_contact(const BaseSolution<dim>                         &base,
                          const typename ActiveSetLookahead<dim>::Respond &respond,
                          const unsigned int                               n_most)
  {
    CondensedContact<dim> contact(base, respond);
    for (auto more = contact.wrong(); !more.empty(); more = contact.wrong())
      {
        if (contact.n() + more.size() > n_most)
          return {};
        contact.add(more);
        if (!contact.solve())
          return {};
      }
    return contact.n() > 0 ? std::make_optional(contact.answers()) : std::nullopt;
  }

  template std::optional<NodalContacts<2>>
  solve_condensed_friction(const BaseSolution<2> &,
                           const ActiveSetLookahead<2>::Respond &,
                           const std::vector<ShearBound> &);
  template std::optional<NodalContacts<3>>
  solve_condensed_friction(const BaseSolution<3> &,
                           const ActiveSetLookahead<3>::Respond &,
                           const std::vector<ShearBound> &);
  template std::optional<NodalContacts<2>>
  solve_condensed_contact(const BaseSolution<2> &,
                          const ActiveSetLookahead<2>::Respond &,
                          const unsigned int);
  template std::optional<NodalContacts<3>>
  solve_condensed_contact(const BaseSolution<3> &,
                          const ActiveSetLookahead<3>::Respond &,
                          const unsigned int);
} // namespace Amontons
