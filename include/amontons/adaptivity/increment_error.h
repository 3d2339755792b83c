// What the number of increments does to an answer with friction.
#pragma once

#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

namespace Amontons
{
  // The work of friction that is worth telling, as part of all: where all sticks, meshes make 1e-5 and less.
  constexpr double noteworthy_dissipation = 1e-4;

  // A load program on one mesh, at the times that it lands on whatever the
  // increments are.
  struct LoadRecord
  {
    struct Node
    {
      double               area = 0, pressure = 0, bound = 0; // of the shear
      dealii::Tensor<1, 3> shear;
    };
    struct Pair
    {
      std::map<unsigned int, Node> nodes; // by slave node
      dealii::Tensor<1, 3>         normal_force, tangential_force;
      double                       force        = 0; // sum of the normal ones: around a shaft they balance
      double                       contact_size = 0, stick_size = 0;
      bool                         tresca_alone = false; // the bound does not depend on the pressure
    };
    struct Landing
    {
      std::vector<Pair> pairs;
      double            dissipation = 0;
      double            t           = 0;
    };
    std::vector<Landing> breakpoints;
    std::vector<double>  times; // that increments end at
    unsigned int         n_increments = 0;
    unsigned int         n_at_once    = 0; // of these: in pieces between landings that take a single one
    double               largest_work = 0, largest_force = 0; // of a pair
    // From when to when: increments in which nodes with friction have closed.
    using Closing = std::vector<std::array<double, 2>>;
    Closing closing;

    // Ends of pieces between landings in which contact grows: in the first one after its first increment.
    std::vector<double>
    growing() const;

    // For a good part of a piece nodes close where none did on another mesh: what increments do there was not
    // seen.
    bool
    closes_beyond(const Closing &of_other) const;

    // What is divided where increments are shortened.
    unsigned int
    n_in_steps() const
    {
      return n_increments - n_at_once;
    }

    // Enough nodes of a pair stick, some time, to tell how large that zone is.
    bool
    resolves_stick() const;
  };

  // Estimated, relative, the largest of all pairs and landings.
  struct IncrementErrors
  {
    unsigned int n_increments  = 0; // that they are of
    unsigned int n_at_once     = 0; // of these, as in LoadRecord
    unsigned int measured_with = 0, repeated_with = 0;
    double       pressure         = 0; // in the mean square, as
    double       shear            = 0; // likewise, or of noteworthy_shear times the bound or pressure
    double       stick_size       = 0; // of the contact's size
    double       own_stick_size   = 0; // of itself
    double       normal_force     = 0;
    double       tangential_force = 0; // of the largest that the bound allows
    double       dissipation      = 0; // of the work
    double       own_dissipation  = 0; // of itself, or of what is noteworthy

    // With increments that are `factor` times as long.
    IncrementErrors
    scaled(const double factor) const;
    // Of those of the record, which may be others where some were cut when these were measured.
    IncrementErrors
    for_steps(const LoadRecord &record) const;

    // Of the state; the work of friction may be wrong where that is right.
    double
    largest() const
    {
      return std::max({pressure, shear, stick_size, normal_force, tangential_force});
    }

    // What counts for a target.
    double
    of(const std::string &target_quantity) const;
  };

  // With n increments Q(n) = Q + C/n + O(1/n^2): the slip of an increment is counted with the traction at its
  // end, and what closes within it with its whole motion. The same program with n' of them gives
  //   Q(n) - Q = C/n + ... = (Q(n') - Q(n)) / (n/n' - 1) + O(1/n^2),
  // (doc/introduction.md, (21)), for n' = n/2 the difference itself.
  // Pieces that take a single increment count with what two of them change.
  IncrementErrors
  error_of_increments(const LoadRecord &run, const LoadRecord &repeat);

  // The difference itself, whatever the numbers of increments.
  IncrementErrors
  difference(const LoadRecord &run, const LoadRecord &repeat);

  // Ends of pieces between landings over which no pressure changes by much and nothing closes: what slips
  // there does so at the same bound all the time, so that how many increments there are may not matter.
  std::vector<double>
  pieces_of_steady_pressure(const LoadRecord &run);
} // namespace Amontons
