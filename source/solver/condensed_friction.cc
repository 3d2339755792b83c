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

    template <int dim>
    void
    add_columns(const BaseSolution<dim>                         &base,
                const typename ActiveSetLookahead<dim>::Respond &respond,
                const Unknowns                                  &unknowns,
                const unsigned int                               j,
                FullMatrix<double>                              &M)
    {
      const unsigned int k    = unknowns.node[j];
      const auto         fill = [&](const NodeInput input, const unsigned int column, const double factor) {
        const auto response = respond(k, input);
        for (unsigned int i = 0; i < unknowns.n(); ++i)
          {
            const auto  &answer = response[unknowns.node[i]];
            const double v      = factor * slip_along(base.nodes[unknowns.node[i]], answer);
            M(i, column)        = factor * answer.gap;
            for (const int sign : {1, -1})
              M(unknowns.shear(i, sign), column) = -sign * v;
          }
      };
      fill(NodeInput::across, j, unknowns.factor[j]);
      if (base.nodes[k].frictional && base.movable[k])
        {
          fill(NodeInput::along, unknowns.shear(j, 1), unknowns.factor[j]);
          for (unsigned int i = 0; i < 4 * unknowns.n(); ++i)
            M(i, unknowns.shear(j, -1)) = -M(i, unknowns.shear(j, 1));
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
      for (unsigned int i = 0; i < unknowns.n(); ++i)
        {
          const unsigned int k    = unknowns.node[i];
          const auto        &node = base.nodes[k];
          const double       v    = slip_along(node, base.answers[k]);
          add_columns(base, respond, unknowns, i, M);
          q[i] = base.answers[k].gap;
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

  // Pressures and what they make of all gaps, with those nodes that have been asked for.
  template <int dim>
  class CondensedContact
  {
  public:
    CondensedContact(const BaseSolution<dim> &base, const typename ActiveSetLookahead<dim>::Respond &respond)
        : base(base), respond(respond), working(base.nodes.size(), false)
    {
      for (unsigned int k = 0; k < base.nodes.size(); ++k)
        if (!base.nodes[k].tied)
          size = std::max(size, std::abs(base.answers[k].gap));
    }

    unsigned int
    n() const
    {
      return nodes.size();
    }

    void
    add(const unsigned int k)
    {
      if (working[k] || base.nodes[k].tied)
        return;
      working[k] = true;
      nodes.push_back(k);
      responses.push_back(respond(k, NodeInput::across));
    }

    // False: the path ends on a ray.
    bool
    solve()
    {
      FullMatrix<double> M(n(), n());
      Vector<double>     q(n());
      for (unsigned int i = 0; i < n(); ++i)
        {
          q[i] = base.answers[nodes[i]].gap / size;
          for (unsigned int j = 0; j < n(); ++j)
            M(i, j) = responses[j][nodes[i]].gap;
        }
      const auto z = complementary_solution(M, q);
      if (z)
        pressures = *z;
      return z.has_value();
    }

    // Those outside that overlap by more than rounding.
    std::vector<unsigned int>
    overlapping() const
    {
      std::vector<unsigned int> result;
      for (unsigned int k = 0; k < base.nodes.size(); ++k)
        if (!working[k] && !base.nodes[k].tied)
          {
            double gap = base.answers[k].gap, sum = std::abs(gap);
            for (unsigned int j = 0; j < n(); ++j)
              {
                const double change = size * pressures[j] * responses[j][k].gap;
                gap += change;
                sum += std::abs(change);
              }
            if (gap < -1e-10 * sum)
              result.push_back(k);
          }
      return result;
    }

    NodalContacts<dim>
    answers() const
    {
      NodalContacts<dim> result(base.nodes.size());
      for (unsigned int k = 0; k < result.size(); ++k)
        result[k].state = base.nodes[k].tied ? base.states[k] : ContactStatus::open;
      for (unsigned int j = 0; j < n(); ++j)
        if (pressures[j] > 0)
          {
            result[nodes[j]].state    = ContactStatus::slip;
            result[nodes[j]].pressure = size * base.nodes[nodes[j]].c * pressures[j];
          }
      return result;
    }

  private:
    const BaseSolution<dim>                         &base;
    const typename ActiveSetLookahead<dim>::Respond &respond;
    double                                           size = 0; // of the gaps
    std::vector<bool>                                working;
    std::vector<unsigned int>                        nodes;
    std::vector<NodalContacts<dim>>                  responses; // of these to p = c
    Vector<double>                                   pressures; // over size c
  };

  template <int dim>
  std::optional<NodalContacts<dim>>
  solve_condensed_contact(const BaseSolution<dim>                         &base,
                          const typename ActiveSetLookahead<dim>::Respond &respond,
                          const std::vector<unsigned int>                 &first,
                          const unsigned int                               n_most)
  {
    CondensedContact<dim> contact(base, respond);
    for (auto more = first; !more.empty(); more = contact.overlapping())
      {
        if (contact.n() + more.size() > n_most)
          return {};
        for (const unsigned int k : more)
          contact.add(k);
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
                          const std::vector<unsigned int> &,
                          const unsigned int);
  template std::optional<NodalContacts<3>>
  solve_condensed_contact(const BaseSolution<3> &,
                          const ActiveSetLookahead<3>::Respond &,
                          const std::vector<unsigned int> &,
                          const unsigned int);
} // namespace Amontons
