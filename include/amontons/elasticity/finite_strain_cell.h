// Energy, forces and tangent of one cell at finite strain.
#pragma once

#include <amontons/elasticity/finite_kinematics.h>
#include <amontons/elasticity/hyperelastic.h>
#include <amontons/elasticity/volume_stabilisation.h>

namespace Amontons
{
  // The energy of the displacement u of a cell is
  //   Pi(u) = int W(F_bar) dV0,
  // its derivatives are forces and tangent: symmetric, and free of locking up to nu = 0.4999. All integrals
  // are those of Updated Lagrangian, over the current configuration with spatial gradients and Cauchy stress:
  // tau dV0 = sigma dv (doc/introduction.md, (22)).
  //
  // With spatial gradients B of a test function and A of an increment,
  //   a(B) = (P(J tr B)/theta - tr B)/3,  e_bar(B) = sym B + a(B) I,  pi = P(tr tau/(3 theta)),
  // pi being the pressure that the projection admits. Plane stress: a = 0, and the law's tangent with the
  // thickness condensed. Degree 2 adds W_s of volume_stabilisation.h, with s its pressure and
  // d = dev(J^(-2/3) b): to tau the shear stress m r^2 d, to J pi the pressure s - J P(s/theta).
  //
  // Pi is what the three-field functional of Simo, Taylor and Pister (1985),
  //   int W((theta/J)^(1/3) F) + p (J - theta) dV0,
  // becomes with its stationary theta = P J and p = pi. Newton's method for u alone takes theta = P J(u) of
  // every iterate, whose volume is wrong by the square of the last step A: a pressure of that times the bulk
  // modulus. Newton's method for (u, theta) moves theta linearly instead,
  //   theta + P J(u) - theta + P(J tr A),
  // and the wrong volume, the excess e = P J(u) - theta, only enters the right-hand side of the next step,
  // condensed cell by cell. The tangent is the above, with pi(u, theta), and so is the solution.
  template <int dim>
  class FiniteStrainCell
  {
  public:
    FiniteStrainCell(const FiniteElement<dim> &fe, const ProblemType kind);

    // As FiniteKinematics::reinit(); not positive also where plane stress finds no thickness.
    double
    reinit(const FEValues<dim>       &values,
           const HyperelasticLaw     &law,
           const std::vector<double> &u,
           const double              *theta = nullptr);

    double
    energy() const;

    // int tau : e_bar(B) dV0 = int (dev tau + J pi I) : B dV0
    std::vector<double>
    forces() const;

    // Their change with theta by the excess e: with alpha = e/(3 theta) and d tau = alpha (c:I + 2 tau),
    //   int (dev d tau + J P(d(tr tau/(3 theta))) I) : B dV0,
    //   d(tr tau/(3 theta)) = alpha (I:c:I - tr tau)/(3 theta).
    std::vector<double>
    forces_of_excess();

    // Coefficients of theta - 1, of the excess, and (after make_tangent()) of P(J tr B), a column for each
    // shape function.
    const std::vector<double> &
    dilatation() const
    {
      return kinematics.dilatation();
    }
    const std::vector<double> &
    excess() const
    {
      return kinematics.excess();
    }
    const FullMatrix<double> &
    change_of_volume() const
    {
      return kinematics.coefficients_of_columns();
    }

    // int [ e_bar(B):c:e_bar(A) + tr(B tau A^T) + 2 a(A) tau:B + 2 a(B) tau:A + 2 a(B) a(A) tr tau
    //       + tr tau/3 (tr(B A) - D(B) D(A)) + J pi (tr A tr B - tr(B A)) ] dV0,  D(B) = P(J tr B)/theta,
    // and of W_s (its shear stress in tau, its pressure in J pi), with R(B) = tr B - D(B) and j = J/theta,
    //   m [ 2 r j (d:A R(B) + d:B R(A)) + phi j^2 R(A) R(B) ] + s [ 2 D(A) D(B) - tr A D(B) - tr B D(A) ]
    void
    make_tangent(FullMatrix<double> &K);

    // sigma = tau(F_bar)/det F_bar
    Voigt<dim>
    cauchy_stress(const unsigned int q) const;

  private:
    static constexpr unsigned int n_rows = n_voigt<dim> + 1; // e_bar and tr B
    using Matrix                         = std::array<std::array<double, n_rows>, n_rows>;

    // Of the law and of the stabilisation.
    Voigt<3>
    all_stress(const unsigned int q) const;
    void
    project_pressure(std::vector<double> &pressure);
    std::vector<double>
    forces_of(const std::vector<Voigt<3>> &stress, const std::vector<double> &pressure) const;
    Matrix
    material_matrix(const unsigned int q) const;
    void
    add_stabilisation(const unsigned int q, Matrix &M) const;
    void
    fill_strains();
    void
    add_mean_dilatation();
    void
    fill_material_stresses();
    void
    add_geometric(FullMatrix<double> &K);
    void
    add_hoop(FullMatrix<double> &K) const;

    FiniteKinematics<dim>              kinematics;
    const bool                         projects, stabilised;
    const HyperelasticLaw             *law = nullptr;
    std::vector<SymmetricTensor<2, 3>> strain;        // e = b - I
    std::vector<Voigt<3>>              stress;        // tau of the law
    std::vector<double>                pressure;      // J pi; plane stress: tr tau/3
    std::vector<VolumeStabilisation>   stabilisation; // if stabilised

    // Rows by point, columns: shape functions of the cell or (scalar) nodes.
    FullMatrix<double> strains, material_stresses, divergences, dilatations, weighted_divergences,
        stressed_gradients, of_components, of_nodes;
  };
} // namespace Amontons
