#include <amontons/contact/contact_interface.h>

#include <algorithm>
#include <cmath>

namespace Amontons
{
  namespace
  {
    // The two sides of a pair: first, second.
    struct Sides
    {
      unsigned int                                        pair;
      PairData::Slave                                     given; // by the scene
      std::array<unsigned int, 2>                         bodies;
      std::array<std::vector<types::global_dof_index>, 2> dofs;    // ascending
      std::array<double, 2>                               measure; // mean face size times Young modulus
    };

    template <int dim>
    Sides
    sides_of(const Discretization<dim> &discretization, const unsigned int pair)
    {
      const Scene    &scene = discretization.scene;
      const PairData &data  = scene.pairs[pair];
      Sides           result{pair, data.slave, {}, {}, {}};
      for (const unsigned int side : {0, 1})
        {
          const ContactSurface<dim> surface(discretization, side == 0 ? data.first : *data.second);
          for (const auto &node : surface.nodes)
            result.dofs[side].push_back(node.dofs[0]);
          std::sort(result.dofs[side].begin(), result.dofs[side].end());
          result.bodies[side]  = surface.body;
          result.measure[side] = surface.mean_size * scene.bodies[surface.body].material.young;
        }
      return result;
    }

    template <int dim>
    bool
    is_rigid(const Discretization<dim> &discretization, const BoundaryName &name)
    {
      const Scene &scene = discretization.scene;
      return scene.bodies[discretization.geometry.boundary(name, scene).body].rigid.has_value();
    }

    // Both sides are.
    template <int dim>
    bool
    is_of_deformable(const Discretization<dim> &discretization, const unsigned int pair)
    {
      const PairData &data = discretization.scene.pairs[pair];
      return data.second && !is_rigid(discretization, data.first) && !is_rigid(discretization, *data.second);
    }

    // Pairs of the same two bodies, at a corner of both.
    bool
    meet(const Sides &a, const Sides &b)
    {
      const auto share = [](const auto &some, const auto &others) {
        return std::any_of(some.begin(), some.end(), [&](const auto dof) {
          return std::binary_search(others.begin(), others.end(), dof);
        });
      };
      for (const unsigned int first : {0, 1})
        if (a.bodies[0] == b.bodies[first] && a.bodies[1] == b.bodies[1 - first])
          return share(a.dofs[0], b.dofs[first]) && share(a.dofs[1], b.dofs[1 - first]);
      return false;
    }

    // By place in `all`: the smallest place in its group.
    std::vector<unsigned int>
    groups_of(const std::vector<Sides> &all)
    {
      std::vector<unsigned int> result;
      for (unsigned int i = 0; i < all.size(); ++i)
        {
          result.push_back(i);
          for (unsigned int k = 0; k < i; ++k)
            if (result[k] != result[i] && meet(all[k], all[i]))
              {
                const auto larger = std::max(result[k], result[i]), smaller = std::min(result[k], result[i]);
                std::replace(result.begin(), result.end(), larger, smaller);
              }
        }
      return result;
    }

    // Whether it is the first one. What the scene says of one pair holds for those of its group of which it
    // says nothing.
    bool
    is_slave(const Sides &sides, const std::vector<const Sides *> &group)
    {
      const Sides *given = nullptr;
      double       sum   = 0;
      for (const Sides *one : group)
        {
          const bool is_turned = one->bodies[0] != sides.bodies[0];
          sum += std::log(one->measure[is_turned] / one->measure[!is_turned]);
          if (one->given != PairData::Slave::automatic && (given == nullptr || one == &sides))
            given = one;
        }
      if (given == nullptr)
        return sum / group.size() <= std::log(1.001);
      return (given->given == PairData::Slave::first) == (given->bodies[0] == sides.bodies[0]);
    }
  } // namespace

  template <int dim>
  std::vector<bool>
  choose_slaves(const Discretization<dim> &discretization)
  {
    const Scene       &scene = discretization.scene;
    std::vector<bool>  result(scene.pairs.size(), true);
    std::vector<Sides> deform;
    for (unsigned int i = 0; i < result.size(); ++i)
      if (is_of_deformable(discretization, i))
        deform.push_back(sides_of(discretization, i));
      else if (scene.pairs[i].second)
        result[i] = !is_rigid(discretization, scene.pairs[i].first);
    const auto groups = groups_of(deform);
    for (unsigned int i = 0; i < deform.size(); ++i)
      {
        std::vector<const Sides *> group;
        for (unsigned int k = 0; k < deform.size(); ++k)
          if (groups[k] == groups[i])
            group.push_back(&deform[k]);
        result[deform[i].pair] = is_slave(deform[i], group);
      }
    return result;
  }

  template <int dim>
  std::string
  contradicting_slaves(const Discretization<dim> &discretization, const std::vector<bool> &first_is_slave)
  {
    const auto &pairs = discretization.scene.pairs;
    if (std::all_of(pairs.begin(), pairs.end(), [](const PairData &pair) {
          return pair.slave == PairData::Slave::automatic;
        }))
      return "";
    std::vector<Sides> all;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (pairs[i].has_friction() && is_of_deformable(discretization, i))
        all.push_back(sides_of(discretization, i));
    const auto slave = [&](const Sides &sides) { return sides.bodies[first_is_slave[sides.pair] ? 0 : 1]; };
    for (unsigned int i = 0; i < all.size(); ++i)
      for (unsigned int k = 0; k < i; ++k)
        if (const PairData &one = pairs[all[k].pair], &other = pairs[all[i].pair];
            slave(all[k]) != slave(all[i]) && meet(all[k], all[i]))
          return "pairs '" + one.name + "' and '" + other.name +
                 "' meet at a corner of both bodies, and of each of them one is the slave: such a corner is "
                 "held twice, and with friction there may be no states of contact; say no 'Slave', or one of "
                 "the same body";
    return "";
  }

  template std::vector<bool>
  choose_slaves(const Discretization<2> &);
  template std::string
  contradicting_slaves(const Discretization<2> &, const std::vector<bool> &);
  template std::string
  contradicting_slaves(const Discretization<3> &, const std::vector<bool> &);
  template std::vector<bool>
  choose_slaves(const Discretization<3> &);
} // namespace Amontons
