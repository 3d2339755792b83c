#include <amontons/contact/covered_shares.h>
#include <amontons/contact/shared_nodes.h>

#include <deal.II/base/quadrature_lib.h>

#include <algorithm>
#include <map>

namespace Amontons
{
  namespace
  {
    bool
    is_marked(const std::vector<bool> &marks, const unsigned int node)
    {
      return node < marks.size() && marks[node];
    }

    void
    mark(std::vector<bool> &marks, const unsigned int size, const unsigned int node)
    {
      marks.resize(size, false);
      marks[node] = true;
    }

    // By slave face: the part that is opposite of the master.
    template <int dim>
    std::vector<double>
    covered_parts(const ContactInterface<dim> &interface, const bool axisymmetric)
    {
      const auto           &slave = *interface.slave;
      const QGauss<dim - 1> gauss(2);
      std::vector<double>   parts(slave.faces.size(), 0.);
      for (const auto &point : interface.coupling.points)
        parts[point.slave_face] += point.weight;
      for (unsigned int f = 0; f < parts.size(); ++f)
        {
          double area = 0;
          for (unsigned int q = 0; q < gauss.size(); ++q)
            {
              double jacobian;
              slave.face_normal(f, gauss.point(q), &jacobian);
              area +=
                  gauss.weight(q) * jacobian * area_factor(axisymmetric, slave.position(f, gauss.point(q)));
            }
          parts[f] /= area;
        }
      return parts;
    }

    // Two masters of the same slave surface, one behind the other, not beside it, on a face at the node: what
    // both cover of all its faces at least; else 0.
    template <int dim>
    double
    part_that_both_cover(const ContactSurface<dim> &slave,
                         const unsigned int         node,
                         const std::vector<double> &parts_of_one,
                         const std::vector<double> &parts_of_other)
    {
      double most = 0, least = 1;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (const auto &nodes = slave.faces[f].nodes;
            std::find(nodes.begin(), nodes.end(), node) != nodes.end())
          {
            most  = std::max(most, parts_of_one[f] + parts_of_other[f]);
            least = std::min({least, parts_of_one[f], parts_of_other[f]});
          }
      return most > 1.5 ? std::max(least, 1e-6) : 0;
    }

    template <int dim>
    struct Claim
    {
      unsigned int    interface, node;
      double          gap, area;
      Tensor<1, dim>  normal;
      const PairData *pair;
      bool            preferred;

      bool
      may_hold_all() const
      {
        return pair->tied || pair->has_friction();
      }
    };

    template <int dim>
    bool
    same_normal(const Claim<dim> &a, const Claim<dim> &b)
    {
      return a.normal * b.normal > 0.99;
    }

    // Neither of the two lies behind the other one.
    template <int dim>
    bool
    are_beside(const Claim<dim> &a, const Claim<dim> &b, const double size)
    {
      return a.preferred == b.preferred && std::abs(a.gap - b.gap) <= 0.1 * size && same_normal(a, b);
    }

    // Tied pairs go first, as they leave contact no freedom, then clearly closer ones (iterates must not take
    // a node from one to the other). Of masters side by side the one that covers more of the node: so each
    // part of a face keeps a node. Of masters one behind the other, which cover as much, the closer one, as
    // long as nothing has moved. Names decide between equal ones, whatever the order of the pairs.
    template <int dim>
    bool
    goes_before(const Claim<dim> &a, const Claim<dim> &b, const double size, const bool moved)
    {
      if (a.pair->tied != b.pair->tied)
        return a.pair->tied;
      if (a.preferred != b.preferred)
        return a.preferred;
      if (std::abs(a.gap - b.gap) > 0.1 * size)
        return a.gap < b.gap;
      if (same_normal(a, b) && std::abs(a.area - b.area) > 0.01 * std::max(a.area, b.area))
        return a.area > b.area;
      if (!moved && std::abs(a.gap - b.gap) > 1e-6 * size)
        return a.gap < b.gap;
      return a.pair->name < b.pair->name;
    }

    // By node, in the order of names.
    template <int dim>
    std::map<types::global_dof_index, std::vector<Claim<dim>>>
    claims_of(const std::vector<ContactInterface<dim>> &interfaces)
    {
      std::map<types::global_dof_index, std::vector<Claim<dim>>> claims;
      for (unsigned int i = 0; i < interfaces.size(); ++i)
        for (const auto &row : interfaces[i].coupling.rows)
          claims[interfaces[i].slave->nodes[row.node].dofs[0]].push_back(
              {i,
               row.node,
               row.mean_gap,
               row.area,
               row.normal / row.normal.norm(),
               interfaces[i].pair,
               is_marked(interfaces[i].preferred, row.node)});
      for (auto &[dof, rivals] : claims)
        {
          (void)dof;
          std::sort(rivals.begin(), rivals.end(), [](const auto &a, const auto &b) {
            return a.pair->name < b.pair->name;
          });
        }
      return claims;
    }

    template <int dim>
    class CoveredParts
    {
    public:
      CoveredParts(const std::vector<ContactInterface<dim>> &interfaces, const bool axisymmetric)
          : interfaces(interfaces), axisymmetric(axisymmetric), parts(interfaces.size())
      {
      }

      // Of the faces at the node of both claims; 0 unless both masters lie one behind the other.
      double
      of_both(const Claim<dim> &a, const Claim<dim> &b)
      {
        const auto &one = *interfaces[a.interface].slave, &other = *interfaces[b.interface].slave;
        return same_normal(a, b) && a.node == b.node && one.faces.size() == other.faces.size()
                   ? part_that_both_cover(one, a.node, of(a.interface), of(b.interface))
                   : 0;
      }

    private:
      const std::vector<double> &
      of(const unsigned int interface)
      {
        if (parts[interface].empty())
          parts[interface] = covered_parts(interfaces[interface], axisymmetric);
        return parts[interface];
      }

      const std::vector<ContactInterface<dim>> &interfaces;
      const bool                                axisymmetric;
      std::vector<std::vector<double>>          parts; // by interface and face, where asked for
    };

    // A claim lost to a pair beside, and the quotient of both areas.
    struct LostClaim
    {
      unsigned int interface, node, winner, node_of_winner;
      double       part;
    };

    // A pair that covers little of a slave face beside another one would lose every node, and what it covers
    // would press on nothing: of each face it takes the nodes of which it covers most, as long as the other
    // one keeps some. Returns the pairs that gave. (With half of the best part in common, a strip along an
    // edge in space takes the edge.)
    template <int dim>
    std::set<unsigned int>
    return_nodes(const std::vector<ContactInterface<dim>> &interfaces,
                 const std::vector<LostClaim>             &lost,
                 std::vector<std::vector<bool>>           &carries)
    {
      const auto n_kept = [&](const unsigned int i) {
        const auto &rows = interfaces[i].coupling.rows;
        return std::count_if(rows.begin(), rows.end(), [&](const auto &row) { return carries[i][row.node]; });
      };
      std::map<unsigned int, std::map<unsigned int, LostClaim>> losers;
      for (const auto &claim : lost)
        if (n_kept(claim.interface) == 0)
          losers[claim.interface].emplace(claim.node, claim);
      std::set<unsigned int> givers;
      for (const auto &[i, claims] : losers)
        for (const auto &face : interfaces[i].slave->faces)
          {
            double best = 0;
            for (const unsigned int node : face.nodes)
              if (const auto claim = claims.find(node); claim != claims.end())
                best = std::max(best, claim->second.part);
            for (const unsigned int node : face.nodes)
              if (const auto claim = claims.find(node); claim != claims.end() &&
                                                        claim->second.part > 0.5 * best &&
                                                        n_kept(claim->second.winner) > 1)
                {
                  carries[i][node]                                            = true;
                  carries[claim->second.winner][claim->second.node_of_winner] = false;
                  givers.insert(claim->second.winner);
                }
          }
      return givers;
    }
  } // namespace

  template <int dim>
  std::vector<bool>
  resolve_crosspoints(const Discretization<dim>          &discretization,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const bool                          moved,
                      std::vector<std::vector<bool>>     &carries)
  {
    for (auto &interface : interfaces)
      interface.behind.clear();
    std::vector<bool>      again(interfaces.size(), false);
    CoveredParts<dim>      parts(interfaces, discretization.scene.kind == ProblemType::axisymmetric);
    std::vector<LostClaim> lost;
    for (const auto &[dof, rivals] : claims_of(interfaces))
      {
        (void)dof;
        for (unsigned int k = 1; k < rivals.size(); ++k)
          for (unsigned int j = 0; j < k; ++j)
            {
              const auto &a = rivals[j], &b = rivals[k];
              if (!carries[a.interface][a.node] || !carries[b.interface][b.node] ||
                  !(same_normal(a, b) || a.may_hold_all() || b.may_hold_all()))
                continue;
              const double size                    = interfaces[a.interface].slave->mean_size;
              const bool   first                   = goes_before(a, b, size, moved);
              const auto  &winner                  = first ? a : b;
              const auto  &loser                   = first ? b : a;
              carries[loser.interface][loser.node] = false;
              again[loser.interface]               = true;
              if (const double both = parts.of_both(a, b); both == 0 && are_beside(a, b, size))
                lost.push_back(
                    {loser.interface, loser.node, winner.interface, winner.node, loser.area / winner.area});
              else if (both > 0 && !loser.pair->tied)
                {
                  auto &behind = interfaces[loser.interface].behind;
                  behind.resize(interfaces[loser.interface].slave->nodes.size(), 0.);
                  behind[loser.node] = std::max(behind[loser.node], both);
                }
            }
      }
    for (const unsigned int winner : return_nodes(interfaces, lost, carries))
      again[winner] = true;
    return again;
  }

  namespace
  {
    // By node that is behind another master: its gap. Along a normal that nearly misses the master, distances
    // differ by far more than faces are large, and a weighted mean says little: overlaps are seen by the
    // plain one, too. u: see prefer_overlapped().
    template <int dim>
    std::map<unsigned int, double>
    gaps_behind(const Discretization<dim>   &discretization,
                const LA::Vector            &u,
                const ContactInterface<dim> &interface)
    {
      std::map<unsigned int, double> gaps;
      const auto                    &behind = interface.behind;
      if (std::all_of(behind.begin(), behind.end(), [](const double part) { return part == 0; }))
        return gaps;
      auto all = interface.carries;
      for (unsigned int k = 0; k < all.size(); ++k)
        all[k] = all[k] || behind[k] > 0;
      const auto coupling = integrate_coupling(
          discretization, *interface.slave, interface.master, interface.coupling.points, all, all);
      for (const auto &row : coupling.rows)
        if (behind[row.node] > 0)
          {
            const double gap = std::max(row.gap, row.mean_gap);
            gaps[row.node]   = discretization.finite_strain ? gap : gap - row.normal * jump(row, u);
          }
      return gaps;
    }
  } // namespace

  template <int dim>
  bool
  prefer_overlapped(const Discretization<dim>                       &discretization,
                    const LA::Vector                                &u,
                    std::vector<ContactInterface<dim>>              &interfaces,
                    std::set<std::pair<unsigned int, unsigned int>> &changed)
  {
    bool any = false;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        auto        &interface = interfaces[i];
        const double rounding  = 1e-6 * interface.slave->mean_size;
        for (const auto &[node, gap] : gaps_behind(discretization, u, interface))
          {
            if (gap > -rounding || changed.count({i, node}) > 0)
              continue;
            bool is_tied = false; // to the other one
            for (auto &other : interfaces)
              if (other.slave->nodes.size() == interface.slave->nodes.size() &&
                  other.slave->nodes[node].dofs == interface.slave->nodes[node].dofs)
                {
                  is_tied = is_tied || (other.pair->tied && other.carries[node]);
                  if (is_marked(other.preferred, node))
                    other.preferred[node] = false;
                }
            if (is_tied)
              continue;
            changed.insert({i, node});
            mark(interface.preferred, interface.slave->nodes.size(), node);
            any = true;
          }
      }
    return any;
  }

  template <int dim>
  double
  overlap_behind(const Discretization<dim>                &discretization,
                 const LA::Vector                         &u,
                 const std::vector<ContactInterface<dim>> &interfaces)
  {
    double most = 0;
    for (const auto &interface : interfaces)
      for (const auto &[node, gap] : gaps_behind(discretization, u, interface))
        if (interface.behind[node] > 0.99)
          most = std::max(most, -gap / interface.slave->mean_size);
    return most;
  }

  template std::vector<bool>
  resolve_crosspoints(const Discretization<2> &,
                      std::vector<ContactInterface<2>> &,
                      const bool,
                      std::vector<std::vector<bool>> &);
  template double
  overlap_behind(const Discretization<2> &, const LA::Vector &, const std::vector<ContactInterface<2>> &);
  template bool
  prefer_overlapped(const Discretization<2> &,
                    const LA::Vector &,
                    std::vector<ContactInterface<2>> &,
                    std::set<std::pair<unsigned int, unsigned int>> &);
  template std::vector<bool>
  resolve_crosspoints(const Discretization<3> &,
                      std::vector<ContactInterface<3>> &,
                      const bool,
                      std::vector<std::vector<bool>> &);
  template double
  overlap_behind(const Discretization<3> &, const LA::Vector &, const std::vector<ContactInterface<3>> &);
  template bool
  prefer_overlapped(const Discretization<3> &,
                    const LA::Vector &,
                    std::vector<ContactInterface<3>> &,
                    std::set<std::pair<unsigned int, unsigned int>> &);
} // namespace Amontons
