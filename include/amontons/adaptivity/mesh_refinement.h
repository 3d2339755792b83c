// Where to refine, and how the state gets to the new mesh.
#pragma once

#include <amontons/adaptivity/error_estimator.h>
#include <amontons/base/parameters.h>
#include <functional>
#include <limits>

namespace Amontons
{
  //! [parameters]
  struct RefinementParameters : ParameterGroup
  {
    int          cycles       = -1;      // refinements after the first solve; -1: see most_cycles()
    unsigned int max_dofs     = 1000000; // no mesh with more than about this many DoFs
    double       target_error = -1;      // stop once the estimated relative error is below; 0: off; -1: see
                                         // choose_target()
    // Of what: contact pressure (with friction also of the tangential traction) | peak pressure | contact
    // size | stick size | total force | approach | energy | dissipation
    std::string target_quantity = "contact pressure";
    double      fraction        = 0.5;        // bulk (Doerfler) fraction of the squared error to be refined
    std::string strategy        = "adaptive"; // adaptive | uniform
    // Before the first solve: refine faces that are close to the other surface until about this many faces
    // see a contact.
    unsigned int initial_refinements = 3;
    // With friction: replay (the load program starts anew on the refined mesh) | transfer (increments go on
    // from displacements interpolated to it).
    std::string history         = "replay";
    bool        target_is_given = true; // else by choose_target()

    void
    declare(ParameterHandler &prm) override;
    void
    check() const override;

    // Where none is given: none with cycles; else 1 %, as far as meshes take seconds. has_history: each of
    // them takes many increments.
    void
    choose_target(const bool has_history);

    // In each piece of the load path, for the error of the increments: no more than by default for a target
    // that nobody has asked for.
    double
    most_increments() const;

    // After choose_target(): as many as the target takes, if there is one; else none.
    unsigned int
    most_cycles() const
    {
      return cycles >= 0 ? cycles : target_error > 0 ? std::numeric_limits<unsigned int>::max() : 0;
    }
  };
  //! [parameters]

  // Marks the cells of deformable bodies with the largest indicators until their squares make `fraction` of
  // the sum; uniform: all of them. Fewer where the mesh would get more than about max_dofs DoFs (uniform:
  // none), more where these are few: the number of cells would grow by less than a seventh of `step`; it
  // grows by that then. Returns whether anything is marked, on any rank. Collective.
  template <int dim>
  bool
  mark_cells(const Discretization<dim>  &discretization,
             Geometry<dim>              &geometry,
             const RefinementParameters &parameters,
             const Vector<float>        &indicators,
             const double                step = 0);

  // A squared error falls by that where a cell is refined: second order.
  constexpr double per_level = 16;

  // Cells that are marked, or that have just been refined, and how often their children are refined in turn;
  // the same on all ranks.
  using DeeperCells = std::map<CellId, unsigned int>;

  // The same for a target: the error is to fall to `reduction` of what it is. The cells that together have a
  // part of the squared error that may be left stay; the others share the rest of that, and where the error
  // of a cell is that much larger than its share that one refinement will not do, it goes to `deeper`.
  // In space the way goes by equal steps, of which none leaves less than 0.4 of the error: unknowns are dear
  // there, and a mesh that is much finer than the one it was made from has many where they do little.
  // has_history: not so, as the load program is repeated on each mesh, and one more costs more than it saves;
  // nor in the plane. There half of the squared error stays, and a quarter of the error is left at least, as
  // coarse meshes do not know more. Collective.
  template <int dim>
  bool
  mark_cells_for_target(const Discretization<dim> &discretization,
                        Geometry<dim>             &geometry,
                        const unsigned int         max_dofs,
                        const Vector<float>       &indicators,
                        const double               reduction,
                        const bool                 has_history,
                        DeeperCells               &deeper);

  // Marks the children of cells, which have been refined, and takes them for these. Collective.
  template <int dim>
  void
  mark_children(const Discretization<dim> &discretization, Geometry<dim> &geometry, DeeperCells &deeper);

  // Refines and coarsens marked cells; the fields (readable at relevant DoFs) are interpolated to the new
  // mesh, those that are empty stay so. `rebuild` is called between refinement and
  // interpolation: it must distribute the DoFs of the new mesh and leave discretization ready to make
  // vectors. The caller then distributes constraints. Collective.
  template <int dim>
  void
  refine_and_transfer(Discretization<dim>             &discretization,
                      Geometry<dim>                   &geometry,
                      const std::vector<LA::Vector *> &fields,
                      const std::function<void()>     &rebuild);
} // namespace Amontons
