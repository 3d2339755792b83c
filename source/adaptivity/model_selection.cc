#include <amontons/adaptivity/error_estimator.h>
#include <amontons/adaptivity/model_selection.h>
#include <amontons/adaptivity/slenderness.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_values.h>

namespace Amontons
{
  namespace
  {
    template <int dim>
    std::map<unsigned int, double>
    gaps_by_node(const ContactInterface<dim> &interface, const std::vector<bool> &closed)
    {
      std::map<unsigned int, double> gaps;
      for (const auto &row : interface.coupling.rows)
        gaps[row.node] = closed[row.node] ? row.gap : std::max(row.gap, row.mean_gap);
      return gaps;
    }

    bool
    has_declared_gap(const PairData &pair)
    {
      return pair.initial_gap || pair.adjust > 0;
    }

    // Between the nodes of a face that are farthest apart: those between differ by how faces are curved. 0
    // where fewer than two have gaps.
    template <int dim>
    double
    largest_slope(const ContactSurface<dim>            &slave,
                  const SurfaceFace<dim>               &face,
                  const std::map<unsigned int, double> &gaps)
    {
      std::vector<std::pair<double, double>> pairs; // distance, difference
      double                                 farthest = 0, slope = 0;
      for (const unsigned int a : face.unknowns)
        for (const unsigned int b : face.unknowns)
          if (a < b && gaps.count(a) > 0 && gaps.count(b) > 0)
            {
              pairs.emplace_back(slave.nodes[a].x.distance(slave.nodes[b].x),
                                 std::abs(gaps.at(a) - gaps.at(b)));
              farthest = std::max(farthest, pairs.back().first);
            }
      for (const auto &[distance, difference] : pairs)
        if (distance > 0.9 * farthest)
          slope = std::max(slope, difference / distance);
      return slope;
    }

    // Open nodes that are farther from the other side than this part of the motion are left alone: where
    // small strain is that wrong, it shows elsewhere.
    constexpr double near = 0.1;

    // The infinitesimal rotation of each body, its mean. Collective.
    template <int dim>
    std::vector<Tensor<2, dim>>
    mean_turns(const Discretization<dim> &discretization, const LA::Vector &u)
    {
      const unsigned int          n_bodies = discretization.scene.bodies.size();
      std::vector<double>         sums(n_bodies * (dim * dim + 1), 0.); // volume, gradients
      FEValues<dim>               values(discretization.mapping(),
                           discretization.fe,
                           QGauss<dim>(discretization.fe.degree + 1),
                           update_gradients | update_JxW_values);
      std::vector<Tensor<2, dim>> gradients(values.n_quadrature_points);
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            values.reinit(cell);
            values[FEValuesExtractors::Vector(0)].get_function_gradients(u, gradients);
            double *const sum = &sums[cell->material_id() * (dim * dim + 1)];
            for (const unsigned int q : values.quadrature_point_indices())
              {
                sum[0] += values.JxW(q);
                for (unsigned int i = 0; i < dim * dim; ++i)
                  sum[1 + i] += gradients[q][i / dim][i % dim] * values.JxW(q);
              }
          }
      Utilities::MPI::sum(sums, discretization.geometry.communicator, sums);
      std::vector<Tensor<2, dim>> turns(n_bodies);
      for (unsigned int b = 0; b < n_bodies; ++b)
        if (const double *const sum = &sums[b * (dim * dim + 1)]; sum[0] > 0)
          for (unsigned int i = 0; i < dim; ++i)
            for (unsigned int j = 0; j < dim; ++j)
              turns[b][i][j] = (sum[1 + i * dim + j] - sum[1 + j * dim + i]) / (2 * sum[0]);
      return turns;
    }

    // The neglected stress without what bodies turn as a whole, or that turn. energy: what its square counts
    // against.
    template <int dim>
    double
    strain_beside_turns(const Discretization<dim>     &discretization,
                        const ElasticityOperator<dim> &elasticity,
                        const LA::Vector              &u,
                        const double                   energy)
    {
      const auto    turns = mean_turns(discretization, u);
      FEValues<dim> values(discretization.mapping(),
                           discretization.fe,
                           QGauss<dim>(discretization.fe.degree + 1),
                           elasticity.needed_flags());
      double        quadratic = 0, largest = 0;
      for (const auto &turn : turns)
        largest = std::max(largest, turn.norm() / std::sqrt(2.));
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && discretization.is_deformable(cell->material_id()))
          {
            values.reinit(cell);
            quadratic += elasticity.energy_of_neglected_stress(
                values, cell, u, elasticity.stresses(values, cell, u), turns[cell->material_id()]);
          }
      quadratic = Utilities::MPI::sum(quadratic, discretization.geometry.communicator);
      return std::max(largest, std::sqrt(quadratic / energy));
    }

    // Of the surfaces of all pairs; of obstacles, the corners of their carriers.
    template <int dim>
    double
    largest_motion(const Discretization<dim>                &discretization,
                   const std::vector<ContactInterface<dim>> &interfaces,
                   const LA::Vector                         &u)
    {
      double     square = 0;
      const auto look   = [&](const NodeDofs<dim> &dofs) {
        double sum = 0;
        for (const auto dof : dofs)
          sum += u(dof) * u(dof);
        square = std::max(square, sum);
      };
      for (const auto &interface : interfaces)
        {
          for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
            if (surface != nullptr)
              for (const auto &node : surface->nodes)
                look(node.dofs);
          if (!interface.master_surface)
            for (const auto &dofs : discretization.carrier_dofs[interface.master.carrier])
              look(dofs);
        }
      return std::sqrt(square);
    }
  } // namespace

  template <int dim>
  bool
  holds_all_rotations(const Discretization<dim> &discretization)
  {
    if (discretization.scene.kind != ProblemType::axisymmetric)
      for (const auto &carrier : discretization.geometry.carriers)
        for (unsigned int k = dim == 2 ? 2 : 0; k < 3; ++k)
          if (!carrier.motion.rotation[k])
            return false;
    return true;
  }

  template <int dim>
  void
  NeglectedTermsOfHistory<dim>::add(const Discretization<dim>                &discretization,
                                    const StressRecovery<dim>                &recovery,
                                    const ElasticityOperator<dim>            &elasticity,
                                    const SolutionState<dim>                 &state,
                                    const std::vector<ContactInterface<dim>> &interfaces,
                                    const double                              energy)
  {
    largest_energy = std::max(largest_energy, 2 * std::abs(energy)); // that of rounding has any sign
    if (const double quadratic = recovery.energy_of_neglected_stress(); largest_energy > 0)
      {
        double strain = std::sqrt(quadratic / largest_energy);
        if (!holds_all_rotations(discretization))
          strain = std::min(
              strain, strain_beside_turns(discretization, elasticity, state.displacement, largest_energy));
        terms.strain = std::max(terms.strain, strain);
      }
    const Stiffening most = most_stiffening(discretization, recovery);
    terms.stiffening      = std::max(terms.stiffening, most.any);
    terms.buckling        = std::max(terms.buckling, most.by_compression);
    Place place;
    place.displacement = state.displacement;
    place.motion       = largest_motion(discretization, interfaces, state.displacement);
    place.energy       = largest_energy;
    place.t            = state.t;
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        place.nodes.emplace_back();
        for (const auto &row : interfaces[i].coupling.rows)
          {
            const auto &node   = state.contact[i][row.node];
            const bool  closed = node.state != ContactStatus::open;
            place.nodes.back().push_back({row.node, closed, row.area, node.pressure, row.gap, node.gap});
            if (closed)
              place.pressure += row.area * node.pressure * node.pressure;
          }
      }
    place.pressure = std::sqrt(place.pressure);
    if (discretization.scene.has_friction()) // else the end counts, whatever was before
      largest_pressure = std::max(largest_pressure, place.pressure);
    last.reset();
    (!farthest || place.motion >= farthest->motion ? farthest : last) = std::move(place);

    const double now = (last ? *last : *farthest).motion;
    has_come_back    = now < 0.5 * std::max(farthest->motion, measured_motion);
  }

  // Copies of the interfaces where u takes them, coupled where nodes are closed or near.
  template <int dim>
  std::vector<ContactInterface<dim>>
  NeglectedTermsOfHistory<dim>::interfaces_at(const LA::Vector                         &u,
                                              const Place                              &place,
                                              const Discretization<dim>                &discretization,
                                              const Constraints                        &supports,
                                              const std::vector<ContactInterface<dim>> &interfaces) const
  {
    std::vector<ContactInterface<dim>> result(interfaces.size());
    for (unsigned int i = 0; i < interfaces.size(); ++i)
      {
        result[i].pair            = interfaces[i].pair;
        result[i].slave           = std::make_unique<ContactSurface<dim>>(*interfaces[i].slave);
        result[i].master          = interfaces[i].master;
        result[i].carried         = interfaces[i].carried;
        result[i].search_distance = interfaces[i].search_distance + place.motion;
        if (interfaces[i].master_surface)
          {
            result[i].master_surface = std::make_unique<ContactSurface<dim>>(*interfaces[i].master_surface);
            result[i].master.surface = result[i].master_surface.get();
          }
        std::vector<bool> is_near(interfaces[i].slave->nodes.size(), false);
        for (const Node &node : place.nodes[i])
          is_near[node.node] = node.closed || node.gap <= near * place.motion;
        for (const auto &face : interfaces[i].slave->faces)
          result[i].wanted_faces.push_back(std::any_of(
              face.unknowns.begin(), face.unknowns.end(), [&](const unsigned int n) { return is_near[n]; }));
      }
    couple_moved(discretization, supports, u, place.t, result);
    return result;
  }

  // Of pair i, by node of the slave, where the surfaces really are. at_rest: empty, or where nothing has
  // moved. Meshes with a declared gap (`Initial gap`, `Adjust`) may lie elsewhere than the surfaces that they
  // stand for: there the change of the geometric gap counts.
  template <int dim>
  std::map<unsigned int, double>
  NeglectedTermsOfHistory<dim>::true_gaps(const unsigned int                        i,
                                          const Place                              &place,
                                          const std::vector<ContactInterface<dim>> &at_rest,
                                          const std::vector<ContactInterface<dim>> &moved) const
  {
    std::vector<bool> closed(moved[i].slave->nodes.size(), false);
    for (const Node &node : place.nodes[i])
      closed[node.node] = node.closed;
    if (!has_declared_gap(*moved[i].pair))
      return gaps_by_node(moved[i], closed);
    const auto                     now    = gaps_by_node(moved[i], closed);
    const auto                     before = gaps_by_node(at_rest[i], closed);
    std::map<unsigned int, double> gaps;
    for (const Node &node : place.nodes[i])
      if (const auto gap = now.find(node.node), old = before.find(node.node);
          gap != now.end() && old != before.end())
        gaps[node.node] = node.initial_gap + gap->second - old->second;
    return gaps;
  }

  template <int dim>
  double
  NeglectedTermsOfHistory<dim>::neglected_contact(const Place                              &place,
                                                  const std::vector<ContactInterface<dim>> &at_rest,
                                                  const std::vector<ContactInterface<dim>> &moved) const
  {
    std::set<types::global_dof_index> facing; // nodes that have something opposite, in whatever pair
    for (const auto &interface : moved)
      for (const auto &row : interface.coupling.rows)
        facing.insert(interface.slave->nodes[row.node].dofs[0]);
    double work = 0, other = 0;
    for (unsigned int i = 0; i < moved.size(); ++i)
      {
        if (moved[i].pair->tied)
          continue;
        const auto gaps     = true_gaps(i, place, at_rest, moved);
        double     rounding = 0;
        for (const auto &node : moved[i].slave->nodes)
          rounding = std::max(rounding, 1e-12 * std::max(node.x.norm(), node.X.norm()));

        double force = 0, area = 0, lost = 0, overlap = 0, farthest_overlap = 0;
        for (const Node &node : place.nodes[i])
          {
            const double share = node.closed ? node.area * node.pressure : 0;
            force += share;
            area += node.closed ? node.area : 0;
            if (!node.closed && node.gap > near * place.motion)
              continue;
            const auto gap = gaps.find(node.node);
            if (gap == gaps.end())
              lost += facing.count(moved[i].slave->nodes[node.node].dofs[0]) == 0 ? share : 0;
            else
              {
                const double size = node.closed ? std::abs(gap->second) : std::max(0., -gap->second);
                if (size <= rounding)
                  continue;
                work += share * size;
                overlap += node.closed ? 0 : node.area * size;
                farthest_overlap = std::max(farthest_overlap, size);
              }
          }
        if (force > 0 && !is_unloaded(place))
          {
            work += force / area * overlap;
            other = std::max(other, lost / force);
          }
        else if (place.motion > 0)
          other = std::max(other, farthest_overlap / place.motion);
      }
    return std::max(other, place.energy > 0 ? work / place.energy : 0.);
  }

  // Gaps g that should be 0 take the pressure E*/2 H(g') to close them on a half plane, H Hilbert's
  // transform, which changes no norm: |p| = E*/2 |g'|. Slopes are those of the faces at a node in the mean
  // square. A node misses no more than what it has: at a sharp edge or the tip of a crack slopes grow with
  // the mesh.
  template <int dim>
  double
  NeglectedTermsOfHistory<dim>::pressure_of_uneven_gaps(const Place               &place,
                                                        const Discretization<dim> &discretization,
                                                        const std::vector<ContactInterface<dim>> &at_rest,
                                                        const std::vector<ContactInterface<dim>> &moved) const
  {
    double neglected = 0, all = 0; // squares
    for (unsigned int i = 0; i < moved.size(); ++i)
      {
        if (moved[i].pair->tied)
          continue;
        const auto                    &slave    = *moved[i].slave;
        const double                   modulus  = combined_modulus(discretization.scene, moved[i]);
        const auto                     all_gaps = true_gaps(i, place, at_rest, moved);
        std::map<unsigned int, double> gaps; // of closed nodes
        for (const Node &node : place.nodes[i])
          if (const auto gap = all_gaps.find(node.node); node.closed && gap != all_gaps.end())
            gaps.insert(*gap);
        std::map<unsigned int, std::pair<double, unsigned int>> squares; // of slopes, and how many: by node
        for (const auto &face : slave.faces)
          {
            const double slope = largest_slope(slave, face, gaps);
            for (const unsigned int node : face.unknowns)
              {
                squares[node].first += slope * slope;
                ++squares[node].second;
              }
          }
        for (const Node &node : place.nodes[i])
          if (const auto at = squares.find(node.node); node.closed && at != squares.end())
            {
              const double square = node.pressure * node.pressure;
              neglected += node.area *
                           std::min(at->second.first / at->second.second * std::pow(modulus / 2, 2), square);
              all += node.area * square;
            }
      }
    return all > 0 ? std::sqrt(neglected / all) : 0;
  }

  template <int dim>
  double
  NeglectedTermsOfHistory<dim>::turned_force(const Place                              &place,
                                             const std::vector<ContactInterface<dim>> &interfaces,
                                             const std::vector<ContactInterface<dim>> &moved) const
  {
    double most = 0;
    for (unsigned int i = 0; i < moved.size(); ++i)
      {
        if (!moved[i].pair->has_friction())
          continue;
        std::map<unsigned int, Tensor<1, dim>> normals;
        for (const auto &row : moved[i].coupling.rows)
          normals[row.node] = row.normal / row.normal.norm();
        std::map<unsigned int, double> forces;
        for (const Node &node : place.nodes[i])
          forces[node.node] = node.closed ? node.area * node.pressure : 0.;
        double         force = 0;
        Tensor<1, dim> turned;
        for (const auto &row : interfaces[i].coupling.rows)
          if (const auto now = normals.find(row.node); now != normals.end())
            {
              force += forces[row.node];
              turned += forces[row.node] * (now->second - row.normal / row.normal.norm());
            }
        for (const auto &node : interfaces[i].slave->nodes)
          for (const auto &plane : node.symmetry_planes)
            turned -= (turned * plane) * plane;
        if (force > 0)
          most = std::max(most, turned.norm() / force);
      }
    return most;
  }

  template <int dim>
  void
  NeglectedTermsOfHistory<dim>::measure_gaps(const Discretization<dim>                &discretization,
                                             const Constraints                        &supports,
                                             const std::vector<ContactInterface<dim>> &interfaces,
                                             const bool                                pressures)
  {
    if (!farthest)
      return;
    measured_motion     = std::max(measured_motion, farthest->motion);
    const bool declared = std::any_of(interfaces.begin(), interfaces.end(), [](const auto &interface) {
      return has_declared_gap(*interface.pair);
    });
    const auto at       = [&](const LA::Vector &u, const Place &place) {
      return interfaces_at(u, place, discretization, supports, interfaces);
    };
    for (auto *const place : {&farthest, &last})
      if (*place)
        {
          std::vector<ContactInterface<dim>> at_rest;
          if (declared)
            at_rest = at(discretization.make_relevant_vector(), **place);
          const auto moved = at((*place)->displacement, **place);
          terms.contact    = std::max(terms.contact, neglected_contact(**place, at_rest, moved));
          if (pressures && !is_unloaded(**place))
            terms.pressure =
                std::max(terms.pressure, pressure_of_uneven_gaps(**place, discretization, at_rest, moved));
          if (!is_unloaded(**place))
            terms.turn = std::max(terms.turn, turned_force(**place, interfaces, moved));
          place->reset();
        }
  }

  template bool
  holds_all_rotations(const Discretization<2> &);
  template bool
  holds_all_rotations(const Discretization<3> &);
  template class NeglectedTermsOfHistory<2>;
  template class NeglectedTermsOfHistory<3>;
} // namespace Amontons
