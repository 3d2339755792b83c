// The stiffness of all bodies, cell by cell: assembled once per mesh for small strain, in every iteration for
// finite strain.
#pragma once

#include <amontons/base/local_matrix.h>
#include <amontons/discretization/discretization.h>
#include <amontons/elasticity/finite_strain_cell.h>
#include <amontons/elasticity/linear_elastic.h>

#include <optional>
#include <set>

namespace Amontons
{
  // A cell that the deformation turns inside out: det F <= 0 (or not a number) at a quadrature point.
  template <int dim>
  struct InvertedCell
  {
    Point<dim>         centre; // in the reference configuration
    types::material_id body;
    double             smallest_jacobian;
  };

  template <int dim>
  class ElasticityOperator
  {
  public:
    explicit ElasticityOperator(const Discretization<dim> &discretization, const bool finite_strain = false);

    bool
    finite_strain() const
    {
      return is_finite;
    }

    // Small strain: K_e = int B^T C B over every owned cell of a deformable body; u is not read, and nothing
    // fails. Finite strain: the derivative of the internal forces at u (readable at relevant DoFs); where
    // that inverts a cell, the worst one on all ranks, and the operator is cleared. Collective.
    // dilatations: of the cells (see FiniteStrainCell), on the way to a solution; empty: those of u.
    std::optional<InvertedCell<dim>>
    assemble(const LA::Vector &u, const std::vector<double> &dilatations = {});

    // Finite strain: forces, excess and dilatations as assemble() makes them, while the derivative stays what
    // the last assemble() on this mesh has made.
    std::optional<InvertedCell<dim>>
    update_forces(const LA::Vector &u, const std::vector<double> &dilatations);

    // Of the last assemble() or update_forces() with finite strain, unless it found an inverted cell: forces,
    // what the excess adds to them in the next step, dilatations (less 1), and how Newton's step (readable at
    // relevant DoFs) changes them.
    const LA::Vector &
    forces() const
    {
      return assembled_forces;
    }
    const LA::Vector &
    forces_of_excess() const
    {
      return assembled_forces_of_excess;
    }
    const std::vector<double> &
    dilatations() const
    {
      return cell_dilatations;
    }
    std::vector<double>
    change_of_dilatations(const LA::Vector &step) const;

    // A displacement that comes from a coarser mesh keeps the volume of its cells, and not that of the new
    // ones, which would mean large pressures: the last dilatations, but 1 in nearly incompressible bodies. If
    // there are any; the same on all ranks.
    std::optional<std::vector<double>>
    dilatations_after_refinement() const;

    // After a change of the mesh, until the next assemble().
    void
    clear()
    {
      is_clear = true;
      cells.clear();
      values.clear();
      cell_dilatations.clear();
      excesses.clear();
      changes_of_volume.clear();
    }

    // The same on all ranks.
    bool
    is_cleared() const
    {
      return is_clear;
    }
    unsigned int
    n_cells() const
    {
      return cells.size();
    }
    FullMatrix<double>
    matrix(const unsigned int c) const;
    double
    diagonal(const unsigned int c, const unsigned int i) const
    {
      return values[c * n_values + i * (i + 1) / 2 + i];
    }
    // All of them; the operator must outlive what is returned.
    CellMatrices
    tangent() const;
    const std::vector<types::global_dof_index> &
    dofs(const unsigned int c) const
    {
      return cells[c].dofs;
    }
    types::material_id
    body(const unsigned int c) const
    {
      return cells[c].body;
    }

    // Small strain: K u, after assemble(). Both on unconstrained degrees of freedom (hanging nodes as if they
    // were free); u readable at relevant DoFs. Not a number on cells that u inverts.
    LA::Vector
    internal_forces(const LA::Vector &u) const;

    // Those of this rank that have one of these DoFs; small strain: K u of such cells alone, which is right
    // at these DoFs. Collective.
    std::vector<unsigned int>
    cells_with(const std::set<types::global_dof_index> &dofs) const;
    void
    add_internal_forces(const std::vector<unsigned int> &of_cells,
                        const LA::Vector                &u,
                        LA::Vector                      &forces) const;

    // Collective; small strain: u.K u / 2. Infinite if u inverts a cell.
    double
    stored_energy(const LA::Vector &u) const;

    // Norm of diag(K) u: what rounding is measured against. Finite strain: |u| + 0.02 h, as I + grad u is
    // rounded however small u is (times 1e-14: one unit in the last place).
    double
    rounding_scale(const LA::Vector &u) const;

    // Stress at the points of `values` (reinited on the cell; update flags as StrainOperator needs), from the
    // same projected strain as the stiffness. Finite strain: Cauchy stress.
    std::vector<Voigt<dim>>
    stresses(const FEValues<dim>                                  &values,
             const typename DoFHandler<dim>::active_cell_iterator &cell,
             const LA::Vector                                     &u) const;

    // What small strain leaves out: int r : C^-1 : r over the cell, of the quadratic terms r of the first
    // Piola-Kirchhoff stress without the rotation that it has at finite strain. With H = grad u less `turn`,
    // a rotation that the body makes as a whole, e = sym H, q = 1/2 H^T H, and the stress sigma of small
    // strain, as stresses() has it at the points of `values`,
    //   r = C:q - sym(sigma e) + lambda ((tr e)^2 - e:e) I   (neo-Hookean),   C:q + sym(sigma e)
    // (St. Venant-Kirchhoff). Here and in C, lambda is 2 mu at most: a displacement could undo a change of
    // volume at that price; nor has sigma more pressure than matter that is not confined. Plane stress: q_33
    // so that r_33 = 0.
    double
    energy_of_neglected_stress(const FEValues<dim>                                  &values,
                               const typename DoFHandler<dim>::active_cell_iterator &cell,
                               const LA::Vector                                     &u,
                               const std::vector<Voigt<dim>>                        &stress,
                               const Tensor<2, dim> &turn = Tensor<2, dim>()) const;

    static UpdateFlags
    needed_flags();

  private:
    struct CellStiffness
    {
      std::vector<types::global_dof_index> dofs;
      types::material_id                   body;
      double                               size; // the smallest distance of vertices
    };

    void
    find_cells();
    void
    assemble_small();
    std::optional<InvertedCell<dim>>
    assemble_finite(const LA::Vector &u, const std::vector<double> &dilatations, const bool with_tangent);
    bool
    is_nearly_incompressible(const types::material_id body) const
    {
      return n_dilatations > 0 && discretization.scene.bodies[body].material.poisson > 0.45;
    }
    void
    keep_change_of_volume(const FiniteStrainCell<dim> &cell);

    // action(cell, its degrees of freedom, its FiniteStrainCell, reinit() of that), for owned deformable
    // cells; dilatations: null for those of u.
    template <typename Action>
    void
    for_each_deformed_cell(const LA::Vector &u, const double *dilatations, const Action &action) const;

    void
    pack(const FullMatrix<double> &K);
    LA::Vector
    multiply(const LA::Vector &u) const;

    const Discretization<dim>      &discretization;
    const bool                      is_finite;
    bool                            is_clear = true;
    std::vector<LinearElastic<dim>> materials; // per body
    std::vector<HyperelasticLaw>    laws;      // per body
    std::vector<CellStiffness>      cells;
    const std::size_t               n_values; // per cell
    std::vector<double>             values;   // of the cells' lower triangles, row by row

    // Finite strain: coefficients of theta - 1, of the excess, and of P(J tr B), cell by cell.
    const unsigned int  n_dilatations; // per cell
    std::vector<double> cell_dilatations, excesses, changes_of_volume;
    LA::Vector          assembled_forces, assembled_forces_of_excess;
  };
} // namespace Amontons
