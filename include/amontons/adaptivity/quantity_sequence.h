/// Numbers on the meshes of a run (a size or a force of each pair): how far the last ones are from their
/// limits.
#pragma once

#include <optional>
#include <vector>

namespace Amontons
{
  class QuantitySequence
  {
  public:
    static constexpr double least_of_largest = 1e-3;

    /// The same number of values each time; of the same number of DoFs as the last ones: instead of those.
    /// least: size of a value that is worth telling, against which smaller ones count. doubts: by how much
    /// each value is off where its mesh is as coarse as before (empty: not known).
    void
    add(const double               n_dofs,
        const std::vector<double> &values,
        const double               least  = 0,
        const std::vector<double> &doubts = {});

    /// Of a mesh that does not see all that touches: no other is compared with it, nor with those before.
    void
    add_unseen(const std::vector<double> &values);
    /// Those that follow are, whatever their DoFs, until others can be: faces are so much smaller where
    /// bodies touch that they cannot miss the same.
    void
    compare_with_unseen();

    /// What has come of the last mesh is computed anew there, with other increments. What changes by them is
    /// none of the mesh: the numbers on the meshes before change alike.
    void
    repeat();

    /// Of the worst value, relative to itself (or `least`, or least_of_largest of the largest value). Between
    /// three meshes, each of twice as many DoFs as the one before or more, the changes D fall by rho, so that
    /// D rho/(1 - rho) is left. rho is believed between 0.4 and 0.8, and a change that happens to be small
    /// counts as no smaller than 0.4 of the one before. Of two such meshes: their change, but as if rho were
    /// 0.8 where numbers that change smoothly (is_smooth: forces, not sizes of sets of nodes) swing on the
    /// meshes between, or change by more and more. (A change is the largest from any mesh between.) Where
    /// the first of the two has changed them more, that change counts as one of three meshes does. At least a
    /// quarter of the error on the mesh before: one mesh more does not take away more; and doubt(), or half
    /// of that on the mesh before. Infinite as long as there are no two meshes.
    double
    error(const bool is_smooth = false) const;

    /// The part of the error that no change tells: of values whose doubts have not fallen by a quarter
    /// between the first and the last of the meshes that are compared. (Refined elsewhere alone, these
    /// agree.)
    double
    doubt() const;

    bool
    is_empty() const
    {
      return meshes.empty();
    }
    /// All values on all meshes (of which there are any): what does not exist, or vanishes.
    bool
    vanishes() const;
    /// On two meshes or more, which is enough to believe it.
    bool
    is_zero() const
    {
      return meshes.size() > 1 && vanishes();
    }
    /// Of the worst value, relative as above: its largest change to the last mesh from any since one of at
    /// most a quarter of the DoFs. Infinite as long as there is no such mesh.
    double
    spread() const;

    /// Likewise from any mesh before; 0 of a single mesh.
    double
    change() const;

    /// One of the numbers has changed in one direction and hardly by less on the last meshes: it may have no
    /// limit.
    bool
    keeps_on_changing() const;

  private:
    struct Mesh
    {
      double              n_dofs;
      std::vector<double> values, doubts;
    };
    double
    error_on(const unsigned int last, const bool is_smooth) const;
    double
    change_since(const unsigned int first) const;
    double
    doubt_on(const unsigned int last) const;
    // What the errors of a mesh's i-th value count against.
    double
    norm(const unsigned int mesh, const unsigned int i) const;
    unsigned int
    half_of(const unsigned int k) const;
    bool
    settles(const unsigned int from, const unsigned int to, const unsigned int i) const;
    double
    value(const unsigned int mesh, const unsigned int i) const;
    // The changes by a repeat become part of the numbers.
    void
                        settle();
    std::vector<Mesh>   meshes;
    std::optional<Mesh> unseen; // the last, if it was added so
    std::vector<double> before; // on the last mesh, where that is repeated; else empty
    double              least_value = 0;
  };
} // namespace Amontons
