#include <amontons/discretization/common_turn.h>
#include <amontons/discretization/dof_places.h>

#include <deal.II/base/mpi.templates.h>
#include <deal.II/lac/lapack_full_matrix.h>

namespace Amontons
{
  namespace
  {
    // Places before and after.
    template <int dim>
    using Journey = std::pair<Point<dim>, Point<dim>>;

    template <int dim>
    std::vector<Journey<dim>>
    given_journeys(const Discretization<dim> &discretization,
                   const Constraints         &supports,
                   const LA::Vector          &displacement)
    {
      std::vector<Journey<dim>> journeys;
      for_each_node(discretization, [&](const auto &, const auto &node, const Point<dim> &X) {
        Journey<dim> journey{X, X};
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto *entries = supports.get_constraint_entries(node[c]);
            if (!discretization.locally_owned.is_element(node[c]) || entries == nullptr || !entries->empty())
              return;
            journey.first[c] += displacement(node[c]);
            journey.second[c] += supports.get_inhomogeneity(node[c]);
          }
        journeys.push_back(journey);
      });
      return journeys;
    }

    constexpr double rounding = 1e-10; // of the size of the scene

    // Kabsch: with H = sum (x - mean x)(y - mean y)^T = U S V^T the rotation that fits best is V U^T, its
    // last column turned round where that is a reflection. Nothing for points on a line, or one.
    template <int dim>
    std::optional<Tensor<2, dim>>
    best_rotation(const Tensor<2, dim> &moments)
    {
      LAPACKFullMatrix<double> H(dim, dim);
      for (unsigned int a = 0; a < dim; ++a)
        for (unsigned int b = 0; b < dim; ++b)
          H(a, b) = moments[a][b];
      H.compute_svd();
      if (!(H.singular_value(dim - 2) > rounding * H.singular_value(0))) // points on a line, or one
        return {};
      const auto rotation = [&](const double last) {
        Tensor<2, dim> R;
        for (unsigned int a = 0; a < dim; ++a)
          for (unsigned int b = 0; b < dim; ++b)
            for (unsigned int k = 0; k < dim; ++k)
              R[a][b] += (k + 1 < dim ? 1 : last) * H.get_svd_vt()(k, a) * H.get_svd_u()(b, k);
        return R;
      };
      const auto proper = rotation(1);
      return determinant(proper) > 0 ? proper : rotation(-1);
    }
  } // namespace

  template <int dim>
  std::optional<RigidMotion<dim>>
  common_turn(const Discretization<dim> &discretization,
              const Constraints         &supports,
              const LA::Vector          &displacement)
  {
    const auto   journeys = given_journeys(discretization, supports, displacement);
    const auto   comm     = discretization.geometry.communicator;
    const double n        = Utilities::MPI::sum(double(journeys.size()), comm);
    if (n == 0)
      return {};
    RigidMotion<dim> motion;
    for (const auto &[from, to] : journeys)
      for (unsigned int c = 0; c < dim; ++c)
        {
          motion.from[c] += from[c] / n;
          motion.to[c] += to[c] / n;
        }
    motion.from = Point<dim>(Utilities::MPI::sum(Tensor<1, dim>(motion.from), comm));
    motion.to   = Point<dim>(Utilities::MPI::sum(Tensor<1, dim>(motion.to), comm));
    Tensor<2, dim> moments;
    for (const auto &[from, to] : journeys)
      moments += outer_product(from - motion.from, to - motion.to);
    moments             = Utilities::MPI::sum(moments, comm);
    const auto rotation = best_rotation(moments);
    if (!rotation)
      return {};
    motion.rotation = *rotation;

    double off = 0, size = 0;
    for (const auto &[from, to] : journeys)
      {
        off  = std::max(off, (motion.rotation * (from - motion.from) - (to - motion.to)).norm());
        size = std::max(size, from.distance(motion.from));
      }
    off  = Utilities::MPI::max(off, comm);
    size = Utilities::MPI::max(size, comm);
    if (off > rounding * size || (motion.rotation - unit_symmetric_tensor<dim>()).norm() < 1e-6)
      return {};
    return motion;
  }

  // Hanging nodes do not lie on their curved faces, and are left where their lines put them.
  template <int dim>
  std::optional<LA::Vector>
  moved(const Discretization<dim> &discretization,
        const Constraints         &supports,
        const RigidMotion<dim>    &motion,
        const LA::Vector          &displacement)
  {
    auto   owned = discretization.make_owned_vector();
    double size  = 0;
    for_each_node(discretization, [&](const auto &, const auto &node, const Point<dim> &X) {
      Point<dim> x = X;
      for (unsigned int c = 0; c < dim; ++c)
        x[c] += displacement(node[c]);
      const Tensor<1, dim> u = motion.to + motion.rotation * (x - motion.from) - X;
      for (unsigned int c = 0; c < dim; ++c)
        if (discretization.locally_owned.is_element(node[c]))
          owned(node[c]) = u[c];
      size = std::max(size, x.distance(motion.from));
    });
    owned.compress(VectorOperation::insert);
    auto supported = owned;
    supports.distribute(supported);
    auto result = discretization.make_relevant_vector();
    result      = supported;

    double broken = 0;
    for (const auto &line : supports.get_lines())
      if (discretization.locally_owned.is_element(line.index) &&
          !discretization.hanging_nodes.is_constrained(line.index))
        broken = std::max(broken, std::abs(supported(line.index) - owned(line.index)));
    const auto comm = discretization.geometry.communicator;
    if (Utilities::MPI::max(broken, comm) > 100 * rounding * Utilities::MPI::max(size, comm))
      return {};
    return result;
  }

  template std::optional<RigidMotion<2>>
  common_turn(const Discretization<2> &, const Constraints &, const LA::Vector &);
  template std::optional<RigidMotion<3>>
  common_turn(const Discretization<3> &, const Constraints &, const LA::Vector &);
  template std::optional<LA::Vector>
  moved(const Discretization<2> &, const Constraints &, const RigidMotion<2> &, const LA::Vector &);
  template std::optional<LA::Vector>
  moved(const Discretization<3> &, const Constraints &, const RigidMotion<3> &, const LA::Vector &);
} // namespace Amontons
