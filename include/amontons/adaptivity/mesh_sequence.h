/// The meshes of a run that resolve its contact: how the estimated error falls with the unknowns, and what a
/// target would take.
#pragma once

#include <string>
#include <vector>

namespace Amontons
{
  class MeshSequence
  {
  public:
    /// Of the same number of DoFs as the last one: instead of it. Infinite errors, which are not known yet,
    /// and none, where nothing touches so far, are left out. growth: of the DoFs, within which errors need
    /// not fall; of numbers, whose errors are differences between meshes of so many DoFs, 4. has_limit: of
    /// the exact quantity, whatever the pressure is (forces, energies): its error falls, if not always.
    void
    add(const double n_dofs, const double error, const double growth = 2, const bool has_limit = false);

    /// The same meshes with other increments: what was is no longer compared by order().
    void
    restart()
    {
      begin = meshes.size();
    }

    /// r in error ~ DoFs^-r over the last meshes since a restart, at least four refinements and that growth
    /// of the DoFs; NaN where there are not so many yet. Without the first mesh if its error is smaller than
    /// that of the second: it has not seen the edge that the second has.
    double
    order() const;

    /// r as above by the method of least squares over the last nine meshes, with whatever increments, that
    /// grow as much; NaN where there are not so many.
    double
    trend() const;

    /// Two refinements to the square of that growth have changed the error by less than 1 %.
    bool
    stands_still() const;

    /// error: of cells that cannot be refined, on the mesh of so many DoFs (the same number: instead of the
    /// last one). The meshes end where that is more than the target, and not less than on the mesh before.
    void
    add_lasting(const double n_dofs, const double error, const double target);

    /// At this order; infinite where the error does not fall, NaN where the order is not known.
    double
    dofs_for(const double target) const;

    /// The meshes have ended, or the quantity does not converge: the error stands still, or, where there may
    /// be no limit, its order is below 0.1, where smooth contact has 1/2 (3D) and more, and contact at an
    /// edge with a pressure that is square integrable 1/4 on uniform and more on graded meshes. After a
    /// restart, which leaves that unknown, the trend says so. (Where a corner fits a corner with friction,
    /// errors swing by a factor of ten.)
    bool
    is_hopeless(const double target, const double max_dofs) const;

    /// For the user. place: of most of the error; reason: a sentence that goes on from there, or nothing.
    std::string
    why_missed(const double       target,
               const double       max_dofs,
               const std::string &place,
               const std::string &reason) const;

  private:
    struct Mesh
    {
      double n_dofs, error;
    };
    // At the order r.
    double
    dofs_at(const double r, const double target) const;

    std::vector<Mesh> meshes;
    std::size_t       begin        = 0;
    double            least_growth = 2;
    bool              always_falls = false;
    bool              has_ended    = false;
    std::vector<Mesh> lasting; // the last two, with the error of cells that cannot be refined
  };
} // namespace Amontons
