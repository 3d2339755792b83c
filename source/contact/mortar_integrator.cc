#include <amontons/base/gather.h>
#include <amontons/base/points.h>
#include <amontons/contact/dual_basis.h>
#include <amontons/contact/face_basis.h>
#include <amontons/contact/face_overlap.h>
#include <amontons/contact/mortar_integrator.h>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <sstream>

namespace Amontons
{
  namespace
  {
    // What the lines along the normals meet within `reach`.
    template <int dim>
    BoundingBox<dim>
    swept_box(const ContactSurface<dim> &slave, const unsigned int face, const double reach)
    {
      std::vector<Point<dim>> points;
      for (const unsigned int node : slave.faces[face].nodes)
        for (const double sign : {-1., 1.})
          points.push_back(slave.nodes[node].X + sign * reach * slave.nodes[node].normal);
      BoundingBox<dim> box(points);
      box.extend(0.1 * slave.faces[face].size); // curvature between the nodes
      return box;
    }

    template <int dim>
    double
    measure_of(const bool axisymmetric, const Point<dim> &x)
    {
      return axisymmetric ? 2 * numbers::PI * x[0] : 1.;
    }

    // The gap that counts at a point: declared, closed by `Adjust`, or geometric.
    template <int dim>
    void
    apply_declared_gap(const PairData &pair, const double face_size, OverlapPoint<dim> &p)
    {
      if (pair.initial_gap)
        {
          p.gap = pair.initial_gap->value(as_3d(p.x_slave), 0);
          return;
        }
      if (std::abs(p.gap) <= std::max(pair.adjust, 1e-10 * face_size))
        p.gap = 0;
      if (p.gap < -1e-4 * face_size && !pair.tied)
        {
          std::ostringstream found;
          found << "the bodies overlap by " << -p.gap << " near (" << p.x_slave << ")";
          throw InputError(
              pair.where,
              found.str(),
              "declare an interference with 'Initial gap' (negative), close mesh gaps up to a size with "
              "'Adjust', declare round boundaries in 'Curved boundaries', or move the bodies apart");
        }
    }
  } // namespace

  namespace
  {
    // Where the other side has a step, a node sees both of its levels; psi changes sign, so the far one would
    // count for as much as the near one. What lies farther from a face, by more than half its size, than what
    // is opposite of it or of the faces beside it cannot close with it: the strain would be too large.
    template <int dim>
    std::vector<OverlapPoint<dim>>
    without_steps(const ContactSurface<dim> &slave, std::vector<OverlapPoint<dim>> points)
    {
      std::vector<double> closest(slave.nodes.size(), std::numeric_limits<double>::max());
      for (const auto &p : points)
        for (const unsigned int node : slave.faces[p.slave_face].unknowns)
          closest[node] = std::min(closest[node], p.gap);
      std::vector<OverlapPoint<dim>> result;
      for (auto begin = points.begin(), end = begin; begin != points.end(); begin = end)
        {
          double gap = std::numeric_limits<double>::max(), beside = gap;
          for (; end != points.end() && end->slave_face == begin->slave_face &&
                 end->master_face == begin->master_face;
               ++end)
            gap = std::min(gap, end->gap);
          const auto &face = slave.faces[begin->slave_face];
          for (const unsigned int node : face.unknowns)
            beside = std::min(beside, closest[node]);
          if (gap <= beside + 0.5 * face.size)
            result.insert(result.end(), begin, end);
        }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<OverlapPoint<dim>>
  find_overlaps(const PairData            &pair,
                const ContactSurface<dim> &slave,
                const MasterSide<dim>     &master,
                const double               reach,
                const bool                 axisymmetric,
                const MPI_Comm             communicator)
  {
    std::vector<OverlapPoint<dim>> points;

    std::vector<std::pair<BoundingBox<dim>, unsigned int>> boxes;
    if (master.surface != nullptr)
      for (unsigned int m = 0; m < master.surface->faces.size(); ++m)
        boxes.emplace_back(BoundingBox<dim>(master.surface->faces[m].geometry), m);
    const auto         tree = pack_rtree(boxes);
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);

    std::vector<unsigned int> candidates;
    for (unsigned int s = 0; s < slave.faces.size(); ++s)
      if (slave.faces[s].rank == rank)
        {
          if (master.surface == nullptr)
            {
              overlap_obstacle(slave, s, *master.obstacle, reach, points);
              continue;
            }
          candidates.clear();
          const auto box = swept_box(slave, s, reach);
          for (auto it = tree.qbegin(boost::geometry::index::intersects(box)); it != tree.qend(); ++it)
            candidates.push_back(it->second);
          std::sort(candidates.begin(), candidates.end());
          overlap_faces(slave, s, *master.surface, candidates, reach, points);
        }
    if (Utilities::MPI::n_mpi_processes(communicator) > 1)
      {
        const auto parts = gather_on_all(communicator, points);
        points.clear();
        for (const auto &part : parts)
          points.insert(points.end(), part.begin(), part.end());
      }
    if (!pair.initial_gap)
      points = without_steps(slave, std::move(points));
    for (auto &p : points)
      {
        apply_declared_gap(pair, slave.faces[p.slave_face].size, p);
        p.weight *= measure_of(axisymmetric, p.x_slave);
      }
    return points;
  }

  namespace
  {
    // int B_i over the covered part in proportion to that over the whole faces, by slave node; and the faces
    // that are covered whole, up to quadrature on curved ones.
    template <int dim>
    std::vector<double>
    covered_shares(const ContactSurface<dim>            &slave,
                   const std::vector<OverlapPoint<dim>> &points,
                   const bool                            axisymmetric,
                   std::set<unsigned int>               &whole_faces)
    {
      std::vector<double> covered(slave.nodes.size(), 0.), whole(slave.nodes.size(), 0.),
          covered_area(slave.faces.size(), 0.);
      const auto add = [&](std::vector<double>    &sums,
                           const SurfaceFace<dim> &face,
                           const Point<dim - 1>   &xi,
                           const double            weight) {
        const auto B = traces_of_unknowns(bernstein_values<dim - 1>(slave.degree, xi), face.subdivision);
        for (unsigned int j = 0; j < B.size(); ++j)
          sums[face.unknowns[j]] += weight * B[j];
      };
      for (const auto &p : points)
        {
          add(covered, slave.faces[p.slave_face], p.xi_slave, p.weight);
          covered_area[p.slave_face] += p.weight;
        }
      const QGauss<dim - 1> gauss(slave.degree + 2);
      for (unsigned int f = 0; f < slave.faces.size(); ++f)
        if (std::any_of(slave.faces[f].unknowns.begin(),
                        slave.faces[f].unknowns.end(),
                        [&](const unsigned int i) { return covered[i] > 0; }))
          {
            double face_area = 0;
            for (unsigned int q = 0; q < gauss.size(); ++q)
              {
                double jacobian;
                slave.face_normal(f, gauss.point(q), &jacobian);
                const double weight =
                    gauss.weight(q) * jacobian * measure_of(axisymmetric, slave.position(f, gauss.point(q)));
                add(whole, slave.faces[f], gauss.point(q), weight);
                face_area += weight;
              }
            if (covered_area[f] > 0.999 * face_area)
              whole_faces.insert(f);
          }
      for (unsigned int i = 0; i < whole.size(); ++i)
        covered[i] /= std::max(whole[i], 1e-300);
      return covered;
    }
  } // namespace

  // Row i collects, over the faces at its node,
  //   area = int psi_i,  area normal = int psi_i n,  area gap = normal . int psi_i g n (the normal that the
  //   jump is multiplied with, so that a uniform interference is met by the uniform displacement),  int psi_i
  //   B_j (slave),  int psi_i N_q (master).
  template <int dim>
  Coupling<dim>
  integrate_coupling(const Discretization<dim>     &discretization,
                     const ContactSurface<dim>     &slave,
                     const MasterSide<dim>         &master,
                     std::vector<OverlapPoint<dim>> points,
                     const std::vector<bool>       &carries_multiplier)
  {
    struct Sums
    {
      double                          area         = 0;
      double                          smallest_gap = std::numeric_limits<double>::max(), face_size = 0;
      Tensor<1, dim>                  normal, gap; // gap: int psi g n
      std::map<unsigned int, double>  traces;
      std::map<NodeDofs<dim>, double> master;
    };
    std::map<unsigned int, Sums> sums;
    Coupling<dim>                coupling;
    // A node of which next to nothing is covered leaves its share to the others, as if supports owned it: a
    // force on so small an area is rounding. (Dropping it would break the patch test.)
    const double smallest_share = 1e-3;
    const auto   shares =
        covered_shares(slave, points, discretization.scene.kind == Kind::axisymmetric, coupling.whole_faces);

    for (std::size_t begin = 0, end; begin < points.size(); begin = end)
      {
        for (end = begin; end < points.size() && points[end].slave_face == points[begin].slave_face;)
          ++end;
        const auto                 &face  = slave.faces[points[begin].slave_face];
        const auto                 &nodes = face.unknowns;
        std::vector<Point<dim - 1>> xi;
        std::vector<double>         weights;
        std::vector<bool>           carries;
        for (std::size_t q = begin; q < end; ++q)
          {
            xi.push_back(points[q].xi_slave);
            weights.push_back(points[q].weight);
          }
        for (const unsigned int node : nodes)
          carries.push_back(carries_multiplier[node] && shares[node] > smallest_share);
        for (unsigned int i = 0; i < nodes.size(); ++i)
          if (carries_multiplier[nodes[i]] && !carries[i])
            for (unsigned int j = 0; j < nodes.size(); ++j)
              if (carries[j])
                coupling.slivers[nodes[i]].push_back(nodes[j]);
        const auto basis = make_dual_basis<dim - 1>(slave.degree, xi, weights, carries, face.subdivision);

        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            for (unsigned int j = 0; j < nodes.size(); ++j)
              coupling.trace_mass[{nodes[i], nodes[j]}] += basis.mass(i, j);
            if (!carries[i])
              continue;
            Sums &row = sums[nodes[i]];
            for (unsigned int j = 0; j < nodes.size(); ++j)
              if (basis.traces(i, j) != 0)
                row.traces[nodes[j]] += basis.traces(i, j);
          }
        for (std::size_t q = begin; q < end; ++q)
          {
            std::vector<std::pair<NodeDofs<dim>, double>> columns;
            if (master.surface != nullptr)
              {
                const auto N = lagrange_values<dim - 1>(master.surface->degree, points[q].xi_master);
                for (unsigned int k = 0; k < N.size(); ++k)
                  columns.emplace_back(
                      master.surface->nodes[master.surface->faces[points[q].master_face].nodes[k]].dofs,
                      N[k]);
              }
            else
              {
                const auto N = discretization.carrier_weights(master.carrier, points[q].x_master);
                for (unsigned int k = 0; k <= dim; ++k)
                  columns.emplace_back(discretization.carrier_dofs[master.carrier][k], N[k]);
              }
            for (unsigned int i = 0; i < nodes.size(); ++i)
              if (carries[i])
                {
                  Sums        &row    = sums[nodes[i]];
                  const double weight = basis.psi(i, q - begin) * points[q].weight;
                  row.area += weight;
                  row.gap += weight * points[q].gap * points[q].normal;
                  row.smallest_gap = std::min(row.smallest_gap, points[q].gap);
                  row.face_size    = std::max(row.face_size, slave.faces[points[q].slave_face].size);
                  row.normal += weight * points[q].normal;
                  for (const auto &[dofs, N] : columns)
                    row.master[dofs] += weight * N;
                }
          }
      }

    double closest = std::numeric_limits<double>::max();
    for (const auto &p : points)
      closest = std::min(closest, p.gap);
    for (const auto &[node, row] : sums)
      {
        CouplingRow<dim> result;
        result.node   = node;
        result.area   = row.area;
        result.normal = row.normal / row.area;
        result.gap    = result.normal * row.gap / row.area;
        // psi changes sign, and where the surface turns away from the other body gaps grow without bound:
        // what is open all around stays open.
        if (row.smallest_gap - closest > 0.1 * row.face_size)
          result.gap = std::max(result.gap, row.smallest_gap);
        std::map<unsigned int, double> slave_weights;
        for (const auto &[j, trace] : row.traces)
          {
            result.traces.emplace_back(j, trace);
            for (const auto &[k, weight] : slave.nodes[j].control)
              slave_weights[k] += weight * trace / row.area;
          }
        for (const auto &[k, weight] : slave_weights)
          if (std::abs(weight) > 1e-14)
            result.slave.emplace_back(slave.nodes[k].dofs, weight);
        for (const auto &[dofs, weight] : row.master)
          if (std::abs(weight) > 1e-14 * row.area)
            result.master.emplace_back(dofs, weight / row.area);
        coupling.rows.push_back(result);
      }
    coupling.points = std::move(points);
    return coupling;
  }

  template std::vector<OverlapPoint<2>>
  find_overlaps(const PairData &,
                const ContactSurface<2> &,
                const MasterSide<2> &,
                const double,
                const bool,
                const MPI_Comm);
  template Coupling<2>
  integrate_coupling(const Discretization<2> &,
                     const ContactSurface<2> &,
                     const MasterSide<2> &,
                     std::vector<OverlapPoint<2>>,
                     const std::vector<bool> &);
  template std::vector<OverlapPoint<3>>
  find_overlaps(const PairData &,
                const ContactSurface<3> &,
                const MasterSide<3> &,
                const double,
                const bool,
                const MPI_Comm);
  template Coupling<3>
  integrate_coupling(const Discretization<3> &,
                     const ContactSurface<3> &,
                     const MasterSide<3> &,
                     std::vector<OverlapPoint<3>>,
                     const std::vector<bool> &);
} // namespace Amontons
