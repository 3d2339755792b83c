// Cook's membrane at finite strain, plane strain, neo-Hookean: published deflections of its upper right
// corner, compressible and nearly incompressible, by Newton's method without contact.
#include "check.h"

#include <amontons/elasticity/elasticity_operator.h>
#include <amontons/elasticity/loads.h>

#include <deal.II/base/mpi.h>
#include <deal.II/dofs/dof_tools.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/lac/dynamic_sparsity_pattern.h>
#include <deal.II/lac/sparse_direct.h>
#include <deal.II/lac/sparse_matrix.h>

namespace test_cook_membrane
{
using namespace Amontons;

namespace
{
  // The trapezoid (0, 0), (48, 44), (48, 60), (0, 44), held on the left, under a dead traction up on the
  // right.
  Scene
  membrane(const double young, const double poisson, const double traction, const unsigned int n)
  {
    Scene    scene;
    BodyData body;
    body.name             = "it";
    body.lower            = {0, 0, 0};
    body.upper            = {1, 1, 0};
    body.cells            = {{n, n, 1}};
    body.material.young   = young;
    body.material.poisson = poisson;
    scene.bodies          = {body};
    ConditionData held, force;
    held.boundaries   = {{"it", "left", {}}};
    held.displacement = {{Expression(0.), Expression(0.), {}}};
    force.type        = ConditionData::Type::traction;
    force.boundaries  = {{"it", "right", {}}};
    force.value[1]    = Expression(std::to_string(traction) + "*t", {});
    scene.conditions  = {held, force};
    return scene;
  }

  class Membrane
  {
  public:
    Membrane(const Scene &scene, const unsigned int degree) : geometry(MPI_COMM_WORLD)
    {
      make_geometry(scene, geometry);
      GridTools::transform(
          [](const Point<2> &p) { return Point<2>(48 * p[0], 44 * p[0] + p[1] * (44 - 28 * p[0])); },
          geometry.triangulation);
      discretization = std::make_unique<Discretization<2>>(scene, geometry, degree);
      discretization->distribute_dofs();
      supports   = discretization->make_supports(1);
      elasticity = std::make_unique<ElasticityOperator<2>>(*discretization, true);
      DynamicSparsityPattern dsp(discretization->dof_handler.n_dofs());
      DoFTools::make_sparsity_pattern(discretization->dof_handler, dsp, supports);
      pattern.copy_from(dsp);
    }

    // Deflection of the corner (48, 60) after so many equal load steps.
    double
    solve(const unsigned int n_steps)
    {
      LA::Vector u = discretization->make_relevant_vector();
      for (unsigned int step = 1; step <= n_steps; ++step)
        {
          const auto   loads      = assemble_loads<2>(*discretization, double(step) / n_steps, {}, &u);
          unsigned int iterations = 0;
          while (iterate(loads, u) > 1e-10)
            if (++iterations == 15)
              {
                check::is_true(false, "Newton's method converges");
                return 0;
              }
        }
      for (const auto &cell : discretization->dof_handler.active_cell_iterators())
        for (const unsigned int v : cell->vertex_indices())
          if (cell->vertex(v).distance({48, 60}) < 1e-9)
            return u(cell->vertex_dof_index(v, 1));
      return 0;
    }

  private:
    // u += K^-1 (loads - forces); returns the largest change.
    double
    iterate(const LA::Vector &loads, LA::Vector &u)
    {
      check::is_true(!elasticity->assemble(u), "no cell is inverted");
      const LA::Vector     forces = elasticity->internal_forces(u);
      SparseMatrix<double> matrix(pattern);
      Vector<double>       change(loads.size());
      for (const auto dof : discretization->locally_owned)
        supports.distribute_local_to_global(Vector<double>({loads(dof) - forces(dof)}), {dof}, change);
      for (unsigned int c = 0; c < elasticity->n_cells(); ++c)
        supports.distribute_local_to_global(elasticity->matrix(c), elasticity->dofs(c), matrix);
      SparseDirectUMFPACK solver;
      solver.solve(matrix, change);
      for (const auto dof : discretization->locally_owned)
        u(dof) += change(dof);
      u.compress(VectorOperation::add);
      return change.linfty_norm();
    }

    Geometry<2>                            geometry;
    std::unique_ptr<Discretization<2>>     discretization;
    Constraints                            supports;
    std::unique_ptr<ElasticityOperator<2>> elasticity;
    SparsityPattern                        pattern;
  };

  // E = 200, nu = 0.35, traction 4: 6.1469 (B. Mueller, Mixed least squares finite element methods based on
  // inverse stress-strain relations in hyperelasticity, thesis, Universitaet Duisburg-Essen 2015). The corner
  // at the upper left is singular: first order.
  void
  check_compressible(const unsigned int degree, const double tolerance)
  {
    const Scene scene = membrane(200, 0.35, 4, 16);
    check::is_close(Membrane(scene, degree).solve(1),
                    6.1469,
                    tolerance,
                    "Cook's membrane, compressible, degree " + std::to_string(degree));
  }

  // E = 3, traction 0.05, incompressible: 4.7011 (the same thesis); here nu = 0.4999.
  void
  check_incompressible(const unsigned int degree, const unsigned int n, const double tolerance)
  {
    const Scene scene = membrane(3, 0.4999, 0.05, n);
    check::is_close(Membrane(scene, degree).solve(8),
                    4.7011,
                    tolerance,
                    "Cook's membrane, nearly incompressible, degree " + std::to_string(degree));
  }
} // namespace

int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_compressible(1, 0.016);
  check_compressible(2, 1.5e-3);
  check_incompressible(1, 16, 0.02);
  check_incompressible(2, 8, 6e-3);
  return check::result();
}
} // namespace test_cook_membrane
