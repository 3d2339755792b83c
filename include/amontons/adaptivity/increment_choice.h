/// How long the increments of a load program with friction are, where a target chooses them.
#pragma once

#include <amontons/adaptivity/increment_error.h>
#include <amontons/adaptivity/mesh_refinement.h>
#include <amontons/solver/load_program.h>

#include <functional>
#include <optional>

namespace Amontons
{
  /// The error of the increments is as large as they are long: measured once, on a mesh that sees slip, it
  /// says how many make it half of the target.
  class IncrementChoice
  {
  public:
    /// The load program with such increments; nothing: it failed.
    using Repeat = std::function<std::optional<LoadRecord>(const IncrementLengths &)>;

    /// by_target: else increments stay as long as the scene says.
    IncrementChoice(const RefinementParameters &parameters, const bool by_target);

    bool
    by_target() const
    {
      return chooses;
    }
    IncrementLengths
    lengths() const
    {
      return {times, few, n_of_each};
    }

    /// errors: of the increments at first, whose load program left the record. Returns what the errors will
    /// be of the increments that are taken in the end; nothing: on the last mesh the first ones do. On the
    /// way there no more than by default are taken: which cells need refinement they tell as well.
    std::optional<IncrementErrors>
    choose(const IncrementErrors &errors,
           const LoadRecord      &record,
           const bool             mesh_is_last,
           const Repeat          &repeat);

    /// Contact that grows makes most of the error, and it does so in few pieces of the path, mostly in the
    /// first. After that, where next to nothing closes, single increments are tried: what they change, over
    /// their number (the law of IncrementErrors), says how many would do, which are tried in turn. True: they
    /// are fewer, and taken from now on. of_record: length of the increments that left the record. change:
    /// what they do, for the report.
    bool
    try_fewer_in_pieces(const LoadRecord &record,
                        const double      of_record,
                        const Repeat     &repeat,
                        IncrementErrors  &change);

    /// Where much closes after all, pieces take as many as others again; false: there are none.
    bool
    divide(const LoadRecord &record);

    /// Those of another run of the same load program.
    void
    take_lengths(const IncrementChoice &other);

    /// The mesh is fine enough: all of them from now on. False: they are.
    bool
    take_all();
    /// More are to be taken in the end than now.
    bool
    wants_more() const
    {
      return times_in_the_end < times;
    }
    /// Those of now to the end, if on the last mesh, which has that error, these are their errors and do.
    bool
    keep(const IncrementErrors &errors, const double of_mesh);

  private:
    double
    wanted(const IncrementErrors &errors) const;
    std::optional<IncrementErrors>
    try_fewer(const double           n,
              const IncrementErrors &errors,
              const LoadRecord      &record,
              const Repeat          &repeat) const;
    double
    allowed() const;
    double
    counted(const IncrementErrors &errors) const;

    const RefinementParameters &parameters;
    const bool                  chooses;
    double                      times = 1, times_in_the_end = 1; // over what the scene says
    std::vector<double>         few;                             // ends of pieces that take so many:
    unsigned int                n_of_each = 1;
  };
} // namespace Amontons
