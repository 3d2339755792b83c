#include <amontons/discretization/free_slides.h>
#include <amontons/discretization/rigid_motions.h>
#include <amontons/solver/floating_bodies.h>

#include <deal.II/lac/lapack_full_matrix.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    // By body: the plane that it touches with a round surface and friction, if it feels nothing else but
    // body forces.
    template <int dim>
    std::vector<const ObstacleData *>
    rough_planes(const Scene &scene, const Geometry<dim> &geometry)
    {
      std::vector<const ObstacleData *> plane(scene.bodies.size(), nullptr);
      const auto body_of = [&](const BoundaryName &name) { return geometry.boundary(name, scene).body; };
      for (const auto &pair : scene.pairs)
        if (!pair.second && pair.has_friction() &&
            geometry.boundary(pair.first, scene).geometry.type != TrueGeometry::Type::flat)
          for (const auto &obstacle : scene.obstacles)
            if (obstacle.name == pair.obstacle && obstacle.type == ObstacleData::Type::plane &&
                obstacle.size == 0)
              plane[body_of(pair.first)] = &obstacle;
      for (const auto &pair : scene.pairs)
        for (const auto *side : {&pair.first, pair.second ? &*pair.second : nullptr})
          if (side != nullptr && plane[body_of(*side)] != nullptr &&
              plane[body_of(*side)]->name != pair.obstacle)
            plane[body_of(*side)] = nullptr;
      for (const auto &condition : scene.conditions)
        for (const auto &boundary : condition.boundaries)
          plane[body_of(boundary)] = nullptr;
      return plane;
    }
  } // namespace

  template <int dim>
  FloatingBodies<dim>::FloatingBodies(const Discretization<dim>                &discretization,
                                      const Constraints                        &supports,
                                      const std::vector<ContactInterface<dim>> &interfaces,
                                      const LA::Vector                         *displacement)
      : discretization(discretization)
  {
    const Scene       &scene    = discretization.scene;
    const unsigned int n_bodies = scene.bodies.size(),
                       n_owners = n_bodies + discretization.carrier_dofs.size();
    modes_per_body              = scene.kind == ProblemType::axisymmetric ? 1 : n_rigid_motions<dim>;
    n_modes                     = modes_per_body * n_owners;
    centres.resize(n_owners);
    sizes.assign(n_owners, 1.);
    for (unsigned int b = 0; b < n_bodies; ++b)
      {
        sizes[b]   = discretization.geometry.body_sizes[b];
        centres[b] = discretization.geometry.body_centres[b];
      }

    place_dofs(interfaces, displacement);
    add_supports(supports);
    const auto free = null_space(supports_matrix, 1e-12);
    n_free          = free.m() == 0 ? 0 : free.n();
    floating.assign(n_owners, false);
    for (unsigned int k = 0; k < n_free; ++k)
      for (unsigned int i = 0; i < n_modes; ++i)
        if (std::abs(free(i, k)) > 1e-6)
          floating[i / modes_per_body] = true;
  }

  // Where each relevant DoF is and whom it belongs to.
  template <int dim>
  void
  FloatingBodies<dim>::place_dofs(const std::vector<ContactInterface<dim>> &interfaces,
                                  const LA::Vector                         *displacement)
  {
    const unsigned int n_bodies = discretization.scene.bodies.size();
    places                      = places_of_dofs(discretization, displacement);
    for (const auto &interface : interfaces)
      for (const auto *surface : {interface.slave.get(), interface.master_surface.get()})
        if (surface != nullptr)
          for (const auto &node : surface->nodes)
            for (unsigned int c = 0; c < dim; ++c)
              {
                place(node.dofs[c]) = {surface->body, c, node.x};
                surface_dofs.push_back(node.dofs[c]);
              }
    for (unsigned int m = 0; m < discretization.carrier_dofs.size(); ++m)
      {
        const auto &carrier = discretization.geometry.carriers[m];
        sizes[n_bodies + m] = carrier.size;
        for (unsigned int d = 0; d < dim; ++d)
          centres[n_bodies + m][d] = carrier.motion.reference[d];
        for (unsigned int k = 0; k <= dim; ++k)
          for (unsigned int c = 0; c < dim; ++c)
            {
              Point<dim> X = centres[n_bodies + m];
              if (k > 0)
                X[k - 1] += carrier.size;
              place(discretization.carrier_dofs[m][k][c]) = {n_bodies + m, c, X};
            }
      }
  }

  // Lines with unit weight each: relative sizes do not matter for a null space.
  template <int dim>
  void
  FloatingBodies<dim>::add_supports(const Constraints &supports)
  {
    supports_matrix.reinit(n_modes, n_modes);
    for (const auto &support : supports.get_lines())
      if (discretization.locally_owned.is_element(support.index))
        {
          Coefficients line = {{support.index, 1.}};
          for (const auto &[other, weight] : support.entries)
            line[other] -= weight;
          const auto e = violation(line);
          for (unsigned int i = 0; i < n_modes; ++i)
            if (e[i] != 0)
              for (unsigned int j = 0; j < n_modes; ++j)
                supports_matrix(i, j) += e[i] * e[j];
        }
    std::vector<double> entries(n_modes * n_modes);
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        entries[i * n_modes + j] = supports_matrix(i, j);
    Utilities::MPI::sum(entries, discretization.geometry.communicator, entries);
    for (unsigned int i = 0; i < n_modes; ++i)
      for (unsigned int j = 0; j < n_modes; ++j)
        supports_matrix(i, j) = entries[i * n_modes + j];
  }

  template <int dim>
  unsigned int
  FloatingBodies<dim>::owner_of(const types::global_dof_index dof) const
  {
    return places[discretization.relevant.index_within_set(dof)].body;
  }

  // Modes of a body: rigid motions of (X - centre)/size; in axisymmetric scenes that along the axis.
  template <int dim>
  double
  FloatingBodies<dim>::value_of_mode(const unsigned int owner,
                                     const unsigned int mode,
                                     const Point<dim>  &X,
                                     const unsigned int component) const
  {
    if (modes_per_body == 1)
      return component == 1 ? 1 : 0;
    return rigid_motion<dim>(mode, (X - centres[owner]) / sizes[owner], component);
  }

  template <int dim>
  void
  FloatingBodies<dim>::add_modes_of(const types::global_dof_index dof,
                                    const double                  weight,
                                    std::vector<double>          &e) const
  {
    if (!discretization.relevant.is_element(dof))
      return;
    const DofPlace<dim> &place = places[discretization.relevant.index_within_set(dof)];
    if (place.body == no_body)
      return;
    for (unsigned int mode = 0; mode < modes_per_body; ++mode)
      e[place.body * modes_per_body + mode] +=
          weight * value_of_mode(place.body, mode, place.X, place.component);
  }

  template <int dim>
  Tensor<1, dim>
  FloatingBodies<dim>::velocity(const std::vector<double> &motion,
                                const unsigned int         owner,
                                const Point<dim>          &x) const
  {
    Tensor<1, dim> v;
    for (unsigned int mode = 0; mode < modes_per_body; ++mode)
      for (unsigned int c = 0; c < dim; ++c)
        v[c] += motion[owner * modes_per_body + mode] * value_of_mode(owner, mode, x, c);
    return v;
  }

  template <int dim>
  std::vector<double>
  FloatingBodies<dim>::violation(const Coefficients &coefficients) const
  {
    std::vector<double> e(n_modes, 0.);
    for (const auto &[dof, weight] : coefficients)
      add_modes_of(dof, weight, e);
    // Rounding of lines that hold exactly (hanging nodes, rigid bodies).
    for (double &value : e)
      if (std::abs(value) < 1e-10)
        value = 0;
    return e;
  }

  template <int dim>
  FullMatrix<double>
  FloatingBodies<dim>::null_space(const FullMatrix<double> &S, const double relative_threshold) const
  {
    if (n_modes == 0)
      return FullMatrix<double>();
    LAPACKFullMatrix<double> matrix(n_modes, n_modes);
    matrix = S;
    matrix.compute_svd(); // syevx gives up at times where eigenvalues at 0 are many
    const double largest = std::max(S.linfty_norm(), 1e-300);
    unsigned int rank    = 0;
    while (rank < n_modes && matrix.singular_value(rank) > relative_threshold * largest + 1e-290)
      ++rank;
    FullMatrix<double> vectors(rank < n_modes ? n_modes : 0, n_modes - rank);
    for (unsigned int k = 0; k < vectors.n(); ++k)
      for (unsigned int i = 0; i < n_modes; ++i)
        vectors(i, k) = matrix.get_svd_vt()(n_modes - 1 - k, i);
    return vectors;
  }

  template <int dim>
  FullMatrix<double>
  FloatingBodies<dim>::with_equations(const std::vector<const LinearEquation *> &equations) const
  {
    FullMatrix<double> S = supports_matrix;
    for (const auto *equation : equations)
      {
        const auto e = violation(equation->coefficients);
        for (unsigned int i = 0; i < n_modes; ++i)
          if (e[i] != 0)
            for (unsigned int j = 0; j < n_modes; ++j)
              S(i, j) += e[i] * e[j];
      }
    return S;
  }

  // By what surface DoFs see of the unheld motions.
  template <int dim>
  void
  FloatingBodies<dim>::choose_pins(const std::vector<const LinearEquation *> &all_equations)
  {
    pinned.clear();
    if (!any())
      return;
    // Curved surfaces of finite elements resist a rotation about their centre a little, where the true ones
    // do not.
    const auto                       nearly = null_space(with_equations(all_equations), 1e-7);
    std::vector<std::vector<double>> free_rigid_modes;
    for (unsigned int k = 0; nearly.m() > 0 && k < nearly.n(); ++k)
      {
        std::vector<double> q(n_modes);
        for (unsigned int i = 0; i < n_modes; ++i)
          q[i] = nearly(i, k);
        if (!is_driven(q))
          free_rigid_modes.push_back(q);
      }
    const unsigned int n = free_rigid_modes.size();
    if (n == 0)
      return;
    // Of those that see as much: next to the body's centre, which its deformation leaves where it is.
    const auto from_centre = [&](const types::global_dof_index dof) {
      const auto &place = this->place(dof);
      return std::round(1e6 * place.X.distance(centres[place.body]) / sizes[place.body]);
    };
    auto candidates = surface_dofs;
    std::stable_sort(candidates.begin(), candidates.end(), [&](const auto a, const auto b) {
      return from_centre(a) < from_centre(b);
    });
    FullMatrix<double> values(candidates.size(), n);
    for (unsigned int i = 0; i < candidates.size(); ++i)
      {
        std::vector<double> e(n_modes, 0.);
        add_modes_of(candidates[i], 1, e);
        for (unsigned int k = 0; k < n; ++k)
          for (unsigned int m = 0; m < n_modes; ++m)
            values(i, k) += e[m] * free_rigid_modes[k][m];
      }
    for (const unsigned int row : candidates_that_hold(values, 1e-6))
      pinned.push_back(candidates[row]);
  }

  template <int dim>
  std::vector<std::vector<double>>
  FloatingBodies<dim>::free_rigid_modes(const std::vector<const LinearEquation *> &equations) const
  {
    std::vector<std::vector<double>> motions;
    if (!any())
      return motions;
    std::vector<const LinearEquation *> holding = equations;
    std::vector<LinearEquation>         pins(pinned.size());
    for (unsigned int i = 0; i < pinned.size(); ++i)
      {
        pins[i].coefficients[pinned[i]] = 1;
        holding.push_back(&pins[i]);
      }
    const auto left = null_space(with_equations(holding), 1e-12);
    for (unsigned int k = 0; left.m() > 0 && k < left.n(); ++k)
      {
        std::vector<double> q(n_modes);
        double              work = 0;
        for (unsigned int i = 0; i < n_modes; ++i)
          {
            q[i] = left(i, k);
            work += force[i] * q[i];
          }
        for (double &value : q)
          value *= work < 0 ? -1 : 1;
        motions.push_back(q);
      }
    return motions;
  }

  template <int dim>
  double
  FloatingBodies<dim>::evaluate_on(const LinearEquation &equation, const std::vector<double> &motion) const
  {
    const auto e   = violation(equation.coefficients);
    double     sum = 0;
    for (unsigned int i = 0; i < n_modes; ++i)
      sum += e[i] * motion[i];
    return sum;
  }

  template <int dim>
  std::string
  FloatingBodies<dim>::describe(const std::vector<double> &q) const
  {
    double largest = 0;
    for (const double value : q)
      largest = std::max(largest, std::abs(value));
    std::string text;
    const auto  n_bodies = discretization.scene.bodies.size();
    for (unsigned int i = 0; i < n_modes; ++i)
      if (std::abs(q[i]) > 0.1 * largest)
        {
          const unsigned int owner = i / modes_per_body, mode = i % modes_per_body;
          const std::string  motion = modes_per_body == 1 ? "axial motion"
                                      : mode < dim        ? std::string("motion along ") + "xyz"[mode]
                                                          : "rotation";
          const std::string  part =
              motion + " of " +
              (owner < n_bodies ? "body '" + discretization.scene.bodies[owner].name + "'"
                                : "'" + discretization.geometry.carriers[owner - n_bodies].motion.name + "'");
          if (text.find(part) == std::string::npos)
            text += (text.empty() ? "" : ", ") + part;
        }
    return text;
  }

  template <int dim>
  SourceLocation
  FloatingBodies<dim>::place_of(const std::vector<double> &q) const
  {
    unsigned int largest = 0;
    for (unsigned int i = 0; i < n_modes; ++i)
      if (std::abs(q[i]) > std::abs(q[largest]) + 1e-6)
        largest = i;
    const unsigned int owner = largest / modes_per_body, n_bodies = discretization.scene.bodies.size();
    return owner < n_bodies ? discretization.scene.bodies[owner].where
                            : discretization.geometry.carriers[owner - n_bodies].motion.where;
  }

  template <int dim>
  std::vector<bool>
  FloatingBodies<dim>::moved_by(const std::vector<std::vector<double>> &motions) const
  {
    std::vector<bool> moves(centres.size(), false);
    for (const auto &q : motions)
      for (unsigned int i = 0; i < n_modes; ++i)
        if (std::abs(q[i]) > 1e-6)
          moves[i / modes_per_body] = true;
    return moves;
  }

  template <int dim>
  std::vector<double>
  FloatingBodies<dim>::relative_work(const std::vector<std::vector<double>> &motions) const
  {
    const auto moves = moved_by(motions);
    double     scale = 0;
    for (unsigned int i = 0; i < n_modes; ++i)
      if (moves[i / modes_per_body])
        scale = std::max(scale, magnitude[i]);
    std::vector<double> result;
    result.reserve(motions.size());
    for (const auto &q : motions)
      result.push_back(scale > 0 ? work(q) / scale : 0.);
    return result;
  }

  template <int dim>
  bool
  FloatingBodies<dim>::is_driven(const std::vector<double> &q) const
  {
    return std::abs(relative_work({q})[0]) > 1e-6;
  }

  template <int dim>
  void
  FloatingBodies<dim>::set_loads(const LA::Vector &loads)
  {
    force.assign(n_modes, 0.);
    magnitude.assign(n_modes, 0.);
    std::vector<double> e(n_modes);
    for (const auto dof : discretization.locally_owned)
      if (const double f = loads(dof); f != 0)
        {
          std::fill(e.begin(), e.end(), 0.);
          add_modes_of(dof, f, e);
          for (unsigned int i = 0; i < n_modes; ++i)
            {
              force[i] += e[i];
              magnitude[i] += std::abs(e[i]);
            }
        }
    Utilities::MPI::sum(force, discretization.geometry.communicator, force);
    Utilities::MPI::sum(magnitude, discretization.geometry.communicator, magnitude);
  }

  // A round body that feels its weight alone rolls on a plane however rough it is: about the point that
  // touches, v = w + Omega x (x - centre) = 0. Facets hold it if the plane falls by little.
  template <int dim>
  void
  FloatingBodies<dim>::check_rolling() const
  {
    const Scene &scene = discretization.scene;
    if (scene.kind == ProblemType::axisymmetric)
      return;
    const auto        plane = rough_planes(scene, discretization.geometry);
    std::vector<bool> rolls;
    rolls.reserve(plane.size());
    for (const auto *p : plane)
      rolls.push_back(p != nullptr);
    if (std::none_of(rolls.begin(), rolls.end(), [](const bool does) { return does; }))
      return;
    const auto turns = motions_along_surfaces(discretization.geometry, rolls);
    for (unsigned int b = 0; b < rolls.size(); ++b)
      for (unsigned int k = 0; k < turns[b].n(); ++k)
        {
          Tensor<1, dim> below, w;
          for (unsigned int c = 0; c < dim; ++c)
            below[c] = -plane[b]->normal[c];
          for (unsigned int c = 0; c < dim; ++c)
            for (unsigned int i = 0; i < turns[b].m(); ++i)
              w[c] -= turns[b](i, k) * rigid_motion<dim>(i, below / below.norm(), c);
          std::vector<double> q(n_modes, 0.);
          for (unsigned int c = 0; c < dim && w.norm() > 1e-3; ++c)
            q[b * modes_per_body + c] = w[c] / w.norm();
          if (is_driven(q))
            throw InputError(scene.bodies[b].where,
                             "the round body '" + scene.bodies[b].name +
                                 "' rolls on its plane, whatever the friction, and the loads drive it",
                             "hold it by a displacement, a platen, or a second contact");
        }
  }

  template <int dim>
  std::string
  FloatingBodies<dim>::check_loads(const std::vector<const LinearEquation *> &all_equations) const
  {
    if (!any())
      return "";
    const auto check = [&](const std::vector<double> &q) {
      if (is_driven(q))
        throw InputError(
            place_of(q),
            "nothing holds the rigid " + describe(q) + ", and the loads drive it",
            "hold it by a displacement, a symmetry plane, a platen or a contact pair that resists it");
    };
    // Nodal normals of facets seem to hold what planes do not.
    for (const auto &slide : find_free_slides(discretization.scene, discretization.geometry, false))
      for (unsigned int k = 0; k < slide.motions.n(); ++k)
        {
          std::vector<double> q(n_modes, 0.); // translations alone: they are the same for all bodies
          bool                turns = false;
          for (unsigned int i = 0; i < slide.motions.m(); ++i)
            if (i >= dim)
              turns = turns || slide.motions(i, k) != 0;
            else
              for (const unsigned int body : slide.bodies)
                q[body * modes_per_body + i] = slide.motions(i, k);
          if (!turns)
            check(q);
        }
    check_rolling();
    const auto free_rigid_modes = null_space(with_equations(all_equations), 1e-12);
    if (free_rigid_modes.m() == 0)
      return "";
    std::vector<double> moves(n_modes); // in any of them, whatever basis they have
    for (unsigned int k = 0; k < free_rigid_modes.n(); ++k)
      {
        std::vector<double> q(n_modes);
        for (unsigned int i = 0; i < n_modes; ++i)
          q[i] = free_rigid_modes(i, k);
        check(q);
        for (unsigned int i = 0; i < n_modes; ++i)
          moves[i] = std::hypot(moves[i], q[i]);
      }
    return "no support and no contact holds the rigid " + describe(moves) +
           "; no load drives it, so it is kept at rest";
  }

  template class FloatingBodies<2>;
  template class FloatingBodies<3>;
} // namespace Amontons
