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
      // In the mean square: of what has closed since the landing before, the largest bound since then.
      double closed = 0;
    };
    struct Landing
    {
      std::vector<Pair> pairs;
      double            dissipation = 0;
      double            t           = 0;
    };
    std::vector<Landing> breakpoints;
    // What has closed since the last of them, by interface and slave node: the largest square of its bound
    // since then, times its area.
    using ClosedNodes = std::vector<std::map<unsigned int, double>>;
    ClosedNodes         closed;
    std::vector<double> times; // that increments end at
    unsigned int        n_increments = 0;
    unsigned int        n_of_few     = 0; // of these: in pieces between landings that take few
    double              largest_work = 0, largest_force = 0; // of a pair
    // From when to when: increments in which nodes with friction have closed.
    using Closing = std::vector<std::array<double, 2>>;
    Closing closing;

    // Ends of pieces between landings in which contact grows: in the first one after its first increment.
    std::vector<double>
    growing() const;

    // Ends of pieces after the first in which what closes has more than that part of the shear.
    std::vector<double>
    closing_beyond(const double part) const;

    // For a good part of a piece nodes close where none did on another mesh: what increments do there was not
    // seen.
    bool
    closes_beyond(const Closing &of_other) const;

    // What is divided where increments are shortened.
    unsigned int
    n_in_steps() const
    {
      return n_increments - n_of_few;
    }

    // Enough nodes of a pair stick, some time, to tell how large that zone is.
    bool
    resolves_stick() const;
  };

  // Estimated, relative, the largest of all pairs. Tractions and stick sizes are those of the end, as their
  // errors of the mesh are, relative to what they are there; where a pair is unloaded in the end
  // (unloaded_part), they are the largest of all landings, relative to the largest. So are all others.
  struct IncrementErrors
  {
    unsigned int n_increments  = 0; // that they are of
    unsigned int n_of_few      = 0; // of these, as in LoadRecord
    unsigned int measured_with = 0, repeated_with = 0;
    double       pressure         = 0; // in the mean square, as
    double       shear            = 0; // likewise, or of noteworthy_shear times the bound or pressure
    double       shear_on_path    = 0; // the largest of all landings, relative to the largest
    double       stick_size       = 0; // of the contact's size
    double       own_stick_size   = 0; // of itself
    double       normal_force     = 0;
    double       tangential_force = 0; // of the largest that the bound allows
    double       dissipation      = 0; // of the work
    double       own_dissipation  = 0; // of itself, or of what is noteworthy

    // All pieces are divided so far. Together with the difference() that it makes where some take few: their
    // increments are none of those that the error falls with.
    IncrementErrors
    with(const IncrementErrors &others) const;
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

  // The difference itself, whatever the numbers of increments: those of the repeat; measured_with: of the
  // run.
  IncrementErrors
  difference(const LoadRecord &run, const LoadRecord &repeat);
} // namespace Amontons
