// The increments of the load: their sizes follow the iteration, and they end exactly where the scene says.
#pragma once

#include <amontons/scene/scene.h>

#include <optional>
#include <vector>

namespace Amontons
{
  // How long increments are.
  struct IncrementLengths
  {
    double times = 1; // what the scene says
    // Ends of pieces between landings that take few increments, and how many each of them.
    std::vector<double> few       = {};
    unsigned int        n_of_each = 1;
    // Ends of pieces whose first increment is begun by a shorter one, as what closes within the very first
    // has slipped its whole way, which leaves a spike of shear at its edge. Not said: none.
    std::optional<std::vector<double>> begins_in_two = {};
  };

  // Times to land on are the end time and `Output times`; with history (friction) and where the kinematics
  // are to be chosen also the corners of the load path. Between two of them increments are equal, and no
  // longer than the present size. (Where they follow the history and the scene does not say how many, those
  // of the first piece grow: see Piece.) A failed increment is halved; after easy ones the size doubles
  // again, up to what the scene started with.
  class LoadProgram
  {
  public:
    // In each piece between landings, unless the scene says how many over all.
    static constexpr double increments_by_default = 10;
    // And where a target chooses them, until their error is known.
    static constexpr double increments_at_first = 4;

    // incremental: the load is applied in increments, which may be cut.
    LoadProgram(const Scene &scene, const bool incremental, const IncrementLengths &lengths = {});

    // Before its first increment: all of them end at these times.
    void
    follow(const std::vector<double> &times);
    // Before its first increment: it starts at -end_time, and what is there at t = 0 is applied in increments
    // until then.
    void
    start_before();

    bool
    is_incremental() const
    {
      return incremental;
    }
    double
    time() const // that is reached
    {
      return t;
    }
    double
    next() const; // time that the next increment ends at
    unsigned int
    number() const // of the next increment, from 1
    {
      return n_accepted + 1;
    }
    bool
    finished() const
    {
      return t >= breakpoints.back();
    }
    bool
    is_last() const // the next increment ends at the end time
    {
      return next() >= breakpoints.back();
    }
    bool
    is_at_breakpoint() const; // time() is a time to land on
    double
    first_breakpoint() const
    {
      return breakpoints.front();
    }
    unsigned int
    n_breakpoints() const
    {
      return breakpoints.size();
    }
    // time() lies within an increment that is begun by a shorter one: they count as one.
    bool
    is_beginning() const;
    // time() is the end of an increment of a piece that takes few.
    bool
    is_of_few() const;
    // The path may turn at time(): it starts or bends there.
    bool
    at_corner() const;

    void
    accept(const unsigned int iterations);
    bool
    is_smallest() const // the next increment cannot be cut
    {
      return next() - t <= smallest * (1 + 1e-9);
    }
    // After a failure; false: the increment is the smallest allowed, or the only one.
    bool
    cut_back();

  private:
    // The piece between landings that goes on from time t.
    struct Piece
    {
      double                     begin, end, exponent;
      const std::vector<double> *loads; // Scene::load_progress; nullptr: as the time, within the piece
      double                     end_time;

      // Increments are equal steps of s in [0, 1], of which s^exponent is the share of the time of the piece
      // that is over, or of what loads do in it if they do that unevenly. Where contact
      // begins in a point or a line its size grows as t^(1/2), or more slowly: what closes within the first
      // of equal increments is the inner part of the contact, 1/sqrt(n) of it, and its shear that of a
      // single increment.
      double
      progress(const double t) const;
      double
      time(const double progress) const;
      // Loads go on as the time does.
      bool
      is_even() const;

    private:
      double
      of_loads(const double t) const;
    };
    Piece
    piece() const;
    bool
    is_begun_in_two(const Piece &here) const;
    bool
    is_one_of(const std::vector<double> &ends, const double end_of_piece) const;
    double
    first(const Piece &here) const; // end of the first increment
    double
    longest(const Piece &here) const; // increment at time t, as progress in its piece

    bool                incremental;
    std::vector<double> breakpoints, corners, followed, load_progress;
    IncrementLengths    lengths;
    double              constant_size;  // times lengths.times; 0: increments_by_default in each piece
    double              smallest;       // as a time
    double              factor     = 1; // present size over longest()
    double              t          = 0;
    unsigned int        n_accepted = 0;
  };
} // namespace Amontons
