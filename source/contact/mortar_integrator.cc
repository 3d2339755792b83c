#include <amontons/base/gather.h>
#include <amontons/contact/covered_shares.h>
#include <amontons/contact/dual_basis.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/mortar_integrator.h>
#include <amontons/contact/nodal_traces.h>

#include <boost/serialization/array.hpp>
#include <boost/serialization/map.hpp>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    // What one multiplier collects over the faces at its node.
    template <int dim>
    struct RowSums
    {
      double                          area         = 0; // int psi
      double                          smallest_gap = std::numeric_limits<double>::max(), face_size = 0;
      double                          trace = 0, trace_gap = 0; // int B, int B g
      Tensor<1, dim>                  normal, gap;              // int psi n, int psi g r, r the ray
      std::map<unsigned int, double>  traces;                   // int psi B_j
      std::map<NodeDofs<dim>, double> master;                   // int psi N_q

      RowSums &
      operator+=(const RowSums &other)
      {
        area += other.area;
        smallest_gap = std::min(smallest_gap, other.smallest_gap);
        face_size    = std::max(face_size, other.face_size);
        trace += other.trace;
        trace_gap += other.trace_gap;
        normal += other.normal;
        gap += other.gap;
        for (const auto &[j, value] : other.traces)
          traces[j] += value;
        for (const auto &[dofs, value] : other.master)
          master[dofs] += value;
        return *this;
      }

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &area &smallest_gap &face_size &trace &trace_gap &normal &gap &traces &master;
      }
    };

    // The integrals over some of the faces.
    template <int dim>
    struct FaceSums
    {
      std::map<unsigned int, RowSums<dim>>                    rows;
      std::map<std::pair<unsigned int, unsigned int>, double> trace_mass;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &rows &trace_mass;
      }
    };

    // Takes over entries that `map` has not, and adds to those that it has.
    template <typename Map>
    void
    add_to(Map &map, Map &other)
    {
      map.merge(other);
      for (const auto &[key, value] : other)
        map[key] += value;
    }

    // The parts of all ranks, added in their order: the same on all of them, to the last digit.
    template <int dim>
    FaceSums<dim>
    sum_over_ranks(FaceSums<dim> mine, const MPI_Comm communicator)
    {
      auto           parts = gather_on_all(communicator, std::move(mine));
      FaceSums<dim> &sums  = parts[0];
      for (unsigned int rank = 1; rank < parts.size(); ++rank)
        {
          add_to(sums.rows, parts[rank].rows);
          add_to(sums.trace_mass, parts[rank].trace_mass);
        }
      return std::move(sums);
    }

    // Adds int psi_i N_q over points [begin, end) of a slave face, all above one face of the master (or above
    // the obstacle). rows: by node of the slave face, null without a multiplier.
    template <int dim>
    void
    add_master(const Discretization<dim>         &discretization,
               const MasterSide<dim>             &master,
               const PointsView<dim>             &points,
               const unsigned int                 begin,
               const unsigned int                 end,
               const FullMatrix<double>          &psi,
               const std::vector<RowSums<dim> *> &rows)
    {
      const auto         dofs = master_dofs(discretization, master, points[begin]);
      FullMatrix<double> M(rows.size(), dofs.size());
      for (unsigned int q = begin; q < end; ++q)
        {
          const auto N = master_values(discretization, master, points[q]);
          for (unsigned int i = 0; i < rows.size(); ++i)
            for (unsigned int k = 0; k < dofs.size(); ++k)
              M(i, k) += psi(i, q) * points[q].weight * N[k];
        }
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int k = 0; rows[i] != nullptr && k < dofs.size(); ++k)
          rows[i]->master[dofs[k]] += M(i, k);
    }

    // Adds int psi, int psi n, int psi g r, int B, int B g.
    template <int dim>
    void
    add_points(const ContactSurface<dim>         &slave,
               const PointsView<dim>             &points,
               const FullMatrix<double>          &psi,
               const std::vector<RowSums<dim> *> &rows)
    {
      const auto &face = slave.faces[points[0].slave_face];
      for (const auto &p : points)
        {
          const auto B =
              traces_of_unknowns(bernstein_values<dim - 1>(slave.degree, p.xi_slave), face.subdivision);
          for (unsigned int i = 0; i < rows.size(); ++i)
            if (rows[i] != nullptr)
              {
                rows[i]->trace += B[i] * p.weight;
                rows[i]->trace_gap += B[i] * p.weight * p.gap;
              }
        }
      for (unsigned int i = 0; i < rows.size(); ++i)
        for (unsigned int q = 0; rows[i] != nullptr && q < points.size(); ++q)
          {
            RowSums<dim> &row    = *rows[i];
            const double  weight = psi(i, q) * points[q].weight;
            row.area += weight;
            row.normal += weight * points[q].normal;
            row.gap += weight * points[q].gap * points[q].ray;
            row.smallest_gap = std::min(row.smallest_gap, points[q].gap);
            row.face_size    = std::max(row.face_size, face.size);
          }
    }

    template <int dim>
    DualBasis<dim - 1>
    dual_basis_of(const ContactSurface<dim> &slave,
                  const PointsView<dim>     &points,
                  const std::vector<bool>   &carries,
                  const std::vector<bool>   &nodal)
    {
      const auto                 &face = slave.faces[points[0].slave_face];
      std::vector<Point<dim - 1>> xi;
      std::vector<double>         weights;
      std::vector<bool>           carries_here;
      for (const auto &p : points)
        {
          xi.push_back(p.xi_slave);
          weights.push_back(p.weight);
        }
      for (const unsigned int node : face.unknowns)
        carries_here.push_back(carries[node]);
      return make_dual_basis<dim - 1>(
          slave.degree, xi, weights, carries_here, face.subdivision, change_to_nodal(slave, face, nodal));
    }

    // Adds the integrals over the covered part of one face.
    template <int dim>
    void
    add_face(const Discretization<dim> &discretization,
             const ContactSurface<dim> &slave,
             const MasterSide<dim>     &master,
             const PointsView<dim>     &points,
             const std::vector<bool>   &carries,
             const std::vector<bool>   &nodal,
             FaceSums<dim>             &sums)
    {
      const auto                 &face  = slave.faces[points[0].slave_face];
      const auto                 &nodes = face.unknowns;
      const auto                  basis = dual_basis_of(slave, points, carries, nodal);
      std::vector<RowSums<dim> *> rows;
      rows.reserve(nodes.size());
      for (const unsigned int node : nodes)
        rows.push_back(carries[node] ? &sums.rows[node] : nullptr);

      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            sums.trace_mass[{nodes[i], nodes[j]}] += basis.mass(i, j);
            if (rows[i] != nullptr && basis.traces(i, j) != 0)
              rows[i]->traces[nodes[j]] += basis.traces(i, j);
          }
      add_points(slave, points, basis.psi, rows);
      for (unsigned int begin = 0, end = 0; begin < points.size(); begin = end)
        {
          while (end < points.size() && points[end].master_face == points[begin].master_face)
            ++end;
          add_master(discretization, master, points, begin, end, basis.psi, rows);
        }
    }

    // Nodes that could carry a multiplier but for their small share, with those on their faces that do.
    template <int dim>
    std::map<unsigned int, std::vector<unsigned int>>
    find_slivers(const ContactSurface<dim>  &slave,
                 const FacesWithPoints<dim> &points,
                 const std::vector<bool>    &could_carry,
                 const std::vector<bool>    &carries)
    {
      std::map<unsigned int, std::vector<unsigned int>> slivers;
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (points.meets(f))
          for (const unsigned int i : slave.faces[f].unknowns)
            if (could_carry[i] && !carries[i])
              for (const unsigned int j : slave.faces[f].unknowns)
                if (carries[j])
                  slivers[i].push_back(j);
      return slivers;
    }

    // int psi_i with Lagrange traces vanishes on the axis: such nodes carry nothing. Their pressure is that
    // of the middle node in the sense of control values, so that it has no kink there.
    template <int dim>
    void
    release_axis(const ContactSurface<dim> &slave,
                 const std::vector<bool>   &nodal,
                 std::vector<bool>         &carries,
                 Coupling<dim>             &coupling)
    {
      for (const auto &face : slave.faces)
        for (const unsigned int i : face.unknowns)
          for (const unsigned int j : face.unknowns)
            if (nodal[i] && is_on_axis(slave, j))
              {
                carries[j]          = false;
                coupling.slivers[j] = {i};
              }
    }

    // area = int psi_i,  area normal = int psi_i n,  area gap = normal . int psi_i g r (the normal that the
    // jump is multiplied with, so that a uniform interference is met by the uniform displacement),
    // int psi_i B_j (slave),  int psi_i N_q (master). closest: the smallest gap of all points.
    template <int dim>
    MortarRow<dim>
    make_row(const ContactSurface<dim> &slave,
             const unsigned int         node,
             const RowSums<dim>        &sums,
             const double               closest)
    {
      MortarRow<dim> row;
      row.node       = node;
      row.area       = sums.area;
      row.normal     = sums.normal / sums.area;
      row.gap_vector = sums.gap / sums.area;
      row.gap        = row.normal * row.gap_vector;
      row.mean_gap   = sums.trace_gap / sums.trace;
      // psi changes sign, and where the surface turns away from the other body gaps grow without bound:
      // what is open all around stays open. (Moved surfaces: see mean_gap.)
      if (!slave.moved && sums.smallest_gap - closest > 0.1 * sums.face_size)
        row.gap = std::max(row.gap, sums.smallest_gap);
      std::map<unsigned int, double> slave_weights;
      for (const auto &[j, trace] : sums.traces)
        {
          row.traces.emplace_back(j, trace);
          for (const auto &[k, weight] : slave.nodes[j].control)
            slave_weights[k] += weight * trace / sums.area;
        }
      for (const auto &[k, weight] : slave_weights)
        if (std::abs(weight) > 1e-14)
          row.slave.emplace_back(slave.nodes[k].dofs, weight);
      for (const auto &[dofs, weight] : sums.master)
        if (std::abs(weight) > 1e-14 * sums.area)
          row.master.emplace_back(dofs, weight / sums.area);
      return row;
    }
  } // namespace

  template <int dim>
  std::vector<NodeDofs<dim>>
  master_dofs(const Discretization<dim> &discretization,
              const MasterSide<dim>     &master,
              const OverlapPoint<dim>   &p)
  {
    std::vector<NodeDofs<dim>> dofs;
    if (master.surface != nullptr)
      for (const unsigned int node : master.surface->faces[p.master_face].nodes)
        dofs.push_back(master.surface->nodes[node].dofs);
    else
      dofs.assign(discretization.carrier_dofs[master.carrier].begin(),
                  discretization.carrier_dofs[master.carrier].end());
    return dofs;
  }

  template <int dim>
  std::vector<double>
  master_values(const Discretization<dim> &discretization,
                const MasterSide<dim>     &master,
                const OverlapPoint<dim>   &p)
  {
    if (master.surface != nullptr)
      return lagrange_values<dim - 1>(master.surface->degree, p.xi_master);
    const auto N = discretization.carrier_weights(master.carrier, master.motion.origin_of(p.x_master));
    return {N.begin(), N.end()};
  }

  template <int dim>
  AffineMap<dim>
  carrier_motion(const Discretization<dim> &discretization, const unsigned int m, const LA::Vector &u)
  {
    const auto displacement = [&](const Point<dim> &X) {
      const auto     N = discretization.carrier_weights(m, X);
      Tensor<1, dim> result;
      for (unsigned int k = 0; k <= dim; ++k)
        for (unsigned int c = 0; c < dim; ++c)
          result[c] += N[k] * u(discretization.carrier_dofs[m][k][c]);
      return result;
    };
    AffineMap<dim> motion;
    motion.b = displacement(Point<dim>());
    for (unsigned int d = 0; d < dim; ++d)
      {
        const Tensor<1, dim> column = displacement(Point<dim>::unit_vector(d)) - motion.b;
        for (unsigned int c = 0; c < dim; ++c)
          motion.A[c][d] += column[c];
      }
    return motion;
  }

  namespace
  {
    // A node of which next to nothing is covered leaves its share to the others, as if supports owned it: the
    // pressure of a force on so small an area says nothing. (Dropping it would break the patch test.) Where
    // surfaces slide, it comes back later than it leaves, so that no node comes and goes within an iteration.
    double
    smallest_share(const bool moved, const std::vector<bool> &carried, const unsigned int node)
    {
      return moved && !(node < carried.size() && carried[node]) ? 0.1 : 0.02;
    }
  } // namespace

  template <int dim>
  Coupling<dim>
  integrate_coupling(const Discretization<dim>     &discretization,
                     const ContactSurface<dim>     &slave,
                     const MasterSide<dim>         &master,
                     std::vector<OverlapPoint<dim>> points,
                     const std::vector<bool>       &carries_multiplier,
                     const std::vector<bool>       &carried,
                     const bool                     stays)
  {
    const MPI_Comm             communicator = discretization.geometry.communicator;
    const FacesWithPoints<dim> points_of(slave.faces.size(), points, communicator);
    Coupling<dim>              coupling;
    const bool                 axisymmetric  = discretization.scene.kind == ProblemType::axisymmetric;
    const auto                 coverage      = covered_shares(slave, points_of, axisymmetric, communicator);
    auto                       carries       = carries_multiplier;
    double                     largest_share = 0;
    for (unsigned int i = 0; i < carries.size(); ++i)
      if (carries_multiplier[i])
        largest_share = std::max(largest_share, coverage.shares[i]);
    // (Where the other side is small beside all faces, those that it covers most will be refined.)
    const double most = slave.moved ? 1. : largest_share / 2;
    for (unsigned int i = 0; i < carries.size(); ++i)
      carries[i] = carries_multiplier[i] &&
                   coverage.shares[i] > std::min(most, smallest_share(slave.moved, carried, i));
    coupling.whole_faces = coverage.whole_faces;
    coupling.slivers     = find_slivers(slave, points_of, carries_multiplier, carries);
    const auto nodal     = stays ? find_nodal_traces(slave, coverage.positive_faces)
                                 : std::vector<bool>(slave.nodes.size(), false);
    if (axisymmetric)
      release_axis(slave, nodal, carries, coupling);

    FaceSums<dim> mine;
    for (unsigned int f = 0; f < slave.faces.size(); ++f)
      if (points_of.meets(f) && points_of.is_mine(f))
        add_face(discretization, slave, master, points_of[f], carries, nodal, mine);
    auto sums = sum_over_ranks(std::move(mine), communicator);

    double closest = std::numeric_limits<double>::max();
    for (const auto &p : points)
      closest = std::min(closest, p.gap);
    for (const auto &[node, row] : sums.rows)
      coupling.rows.push_back(make_row(slave, node, row, closest));
    coupling.trace_mass = std::move(sums.trace_mass);
    coupling.points     = std::move(points);
    return coupling;
  }

  template std::vector<NodeDofs<2>>
  master_dofs<2>(const Discretization<2> &, const MasterSide<2> &, const OverlapPoint<2> &);
  template std::vector<NodeDofs<3>>
  master_dofs<3>(const Discretization<3> &, const MasterSide<3> &, const OverlapPoint<3> &);
  template std::vector<double>
  master_values(const Discretization<2> &, const MasterSide<2> &, const OverlapPoint<2> &);
  template std::vector<double>
  master_values(const Discretization<3> &, const MasterSide<3> &, const OverlapPoint<3> &);
  template AffineMap<2>
  carrier_motion(const Discretization<2> &, const unsigned int, const LA::Vector &);
  template AffineMap<3>
  carrier_motion(const Discretization<3> &, const unsigned int, const LA::Vector &);
  template Coupling<2>
  integrate_coupling(const Discretization<2> &,
                     const ContactSurface<2> &,
                     const MasterSide<2> &,
                     std::vector<OverlapPoint<2>>,
                     const std::vector<bool> &,
                     const std::vector<bool> &,
                     const bool);
  template Coupling<3>
  integrate_coupling(const Discretization<3> &,
                     const ContactSurface<3> &,
                     const MasterSide<3> &,
                     std::vector<OverlapPoint<3>>,
                     const std::vector<bool> &,
                     const std::vector<bool> &,
                     const bool);
} // namespace Amontons
