// Derivatives of the coupling of moved surfaces by the displacement (doc/introduction.md, (23)): what the
// exact tangent of large sliding needs.
#pragma once

#include <amontons/base/local_matrix.h>
#include <amontons/contact/contact_interface.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

namespace Amontons
{
  using Gradient = Coefficients; // df/du
}

namespace boost
{
  namespace serialization
  {
    template <class Archive>
    void
    serialize(Archive &archive, Amontons::Gradient &gradient, const unsigned int)
    {
      auto                                                              entries = gradient.extract_sequence();
      std::vector<std::pair<Amontons::types::global_dof_index, double>> sorted(entries.begin(),
                                                                               entries.end());
      archive                                                          &sorted;
      gradient.adopt_sequence(container::ordered_unique_range, {sorted.begin(), sorted.end()});
    }
  } // namespace serialization
} // namespace boost

namespace Amontons
{
  // Of MortarRow::gap, normal and area.
  template <int dim>
  struct RowGradient
  {
    Gradient                  gap;
    std::array<Gradient, dim> normal;
    Gradient                  area;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &gap &normal &area;
    }
  };

  template <int dim>
  class FaceDerivatives;

  // For the surfaces where they are now and the coupling integrated there (`moved`). Exact derivatives of the
  // discrete integrals, quadrature and segments included, but for what is decided by comparison: which pieces
  // count (`reach`, steps, slivers), the edges of obstacles, and the lower bound of gaps that are open all
  // around. DoFs of hanging nodes count like others.
  template <int dim>
  class CouplingDerivatives
  {
  public:
    // wanted: by coupling row; the others' gradients stay empty, and only faces of these rows cost anything.
    // Collective.
    CouplingDerivatives(const Discretization<dim>   &discretization,
                        const ContactInterface<dim> &interface,
                        const std::vector<bool>     &wanted);
    ~CouplingDerivatives();

    // By coupling row, the same on every rank.
    const std::vector<RowGradient<dim>> &
    rows() const
    {
      return gradients;
    }

    // df/du of the forces f_d = sum_i area_i t_i . dDelta_i/du_d: on traces of the slave sum_i t_i int psi_i
    // B_j, on the master -sum_i t_i int psi_i N_q, with the tractions t_i held fixed (by row; those not
    // wanted count as zero). This rank's part; the sum over ranks is the whole.
    std::vector<LocalMatrix>
    stiffness(const std::vector<Tensor<1, dim>> &tractions) const;

    // Groups of DoFs that may depend on each other here or after a little sliding: those of each slave face,
    // with what is opposite of the faces beside it. This rank's part.
    std::vector<std::vector<types::global_dof_index>>
    links() const;

  private:
    const std::vector<bool>           wanted;
    std::vector<RowGradient<dim>>     gradients;
    std::vector<FaceDerivatives<dim>> faces; // of this rank
  };
} // namespace Amontons
