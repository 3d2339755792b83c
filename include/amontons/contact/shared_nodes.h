/// Nodes that are slaves of several pairs.
#pragma once

#include <amontons/contact/contact_interface.h>

#include <set>

namespace Amontons
{
  /// A node has dim freedoms. On several slave surfaces without friction it can stop each of them, if their
  /// normals differ; where one of them may hold it in all directions (tied, sticking), or they have the same
  /// normal, it stays with one pair and leaves its share in the others to its neighbours. carries: by
  /// interface and slave node, whether it may have a row; nodes that lose are taken out. Returns, by
  /// interface, whether it must be integrated again. Where a master covers what the one that wins covers,
  /// too, the node is `behind` that one.
  template <int dim>
  std::vector<bool>
  resolve_crosspoints(const Discretization<dim>          &discretization,
                      std::vector<ContactInterface<dim>> &interfaces,
                      const bool                          moved,
                      std::vector<std::vector<bool>>     &carries);

  /// A node that obeys one master may come through another one behind it, which has moved on or less far. u:
  /// a solution, readable at relevant DoFs, in which the surfaces lie if they move. Such nodes are
  /// `preferred` by that pair from now on, and the couplings have to be integrated anew. changed: interfaces
  /// and nodes of which that was so since it was empty; they stay where they are. False: there are no others.
  template <int dim>
  bool
  prefer_overlapped(const Discretization<dim>                       &discretization,
                    const LA::Vector                                &u,
                    std::vector<ContactInterface<dim>>              &interfaces,
                    std::set<std::pair<unsigned int, unsigned int>> &changed);

  /// How far nodes have come through masters behind those that they obey, over the mean size of faces; where
  /// both cover all around the node. (Both ought to press there: a node has one multiplier.)
  template <int dim>
  double
  overlap_behind(const Discretization<dim>                &discretization,
                 const LA::Vector                         &u,
                 const std::vector<ContactInterface<dim>> &interfaces);
} // namespace Amontons
