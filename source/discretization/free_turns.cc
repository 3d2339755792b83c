// Bodies that turn or slide without friction: where they are held.
#include <amontons/discretization/discretization.h>
#include <amontons/discretization/rigid_motions.h>
#include <amontons/geometry/vector_area.h>

#include <deal.II/base/mpi.templates.h>
#include <deal.II/lac/lapack_full_matrix.h>

namespace Amontons
{
  namespace
  {
    // Of a body's rigid motions, about its centre and in its size, the component c at x.
    template <int dim>
    std::array<double, n_rigid_motions<dim>>
    rigid_motions(const Geometry<dim> &geometry,
                  const unsigned int   body,
                  const Point<dim>    &x,
                  const unsigned int   c)
    {
      std::array<double, n_rigid_motions<dim>> values;
      for (unsigned int i = 0; i < values.size(); ++i)
        values[i] = rigid_motion<dim>(i, (x - geometry.body_centres[body]) / geometry.body_sizes[body], c);
      return values;
    }

    // Bodies that feel nothing but a uniform force, pairs without friction and planes of symmetry.
    template <int dim>
    std::vector<bool>
    bodies_that_slide(const Scene &scene, const Geometry<dim> &geometry)
    {
      const auto        is_uniform = [](const Expression &e) { return !e.depends_on_place(); };
      std::vector<bool> result, touches(scene.bodies.size(), false);
      for (const auto &body : scene.bodies)
        result.push_back(!body.rigid && scene.kind != ProblemType::axisymmetric &&
                         std::all_of(body.body_force.begin(), body.body_force.end(), is_uniform));
      const auto body_of = [&](const BoundaryName &name) { return geometry.boundary(name, scene).body; };
      for (const auto &pair : scene.pairs)
        for (const auto *side : {&pair.first, pair.second ? &*pair.second : nullptr})
          if (side != nullptr)
            {
              touches[body_of(*side)] = true;
              if (pair.tied || pair.has_friction() || (pair.initial_gap && !is_uniform(*pair.initial_gap)))
                result[body_of(*side)] = false;
            }
      for (const auto &condition : scene.conditions)
        for (const auto &boundary : condition.boundaries)
          if (condition.type != ConditionData::Type::symmetry)
            result[body_of(boundary)] = false;
      for (unsigned int b = 0; b < result.size(); ++b)
        result[b] = result[b] && touches[b];
      return result;
    }

    // Over all of the surface of a body: int (v_i . N)(v_j . N) dA and int v_i . v_j dA of its rigid motions.
    template <int dim>
    struct MotionsOfSurface
    {
      LAPACKFullMatrix<double> through{n_rigid_motions<dim>, n_rigid_motions<dim>}, all{through};
    };

    // Chords of a body's surface, in space flat faces: action(centre, vector area). An arc through three
    // nodes of a circle leaves it in between; these are on it, in the cells that are given (known on all
    // ranks).
    template <int dim, typename Action>
    void
    for_each_chord(const Geometry<dim> &geometry, const unsigned int body, const Action &action)
    {
      const auto visit = [&](const auto &cell, const auto &act) {
        if (cell->material_id() == body)
          for (const auto &face : cell->face_iterators())
            if (face->at_boundary())
              act(face);
      };
      if constexpr (dim == 2)
        if (geometry.of_second_order[body])
          {
            for (const auto &cell : geometry.triangulation.cell_iterators_on_level(0))
              visit(cell, [&](const auto &face) {
                const auto middle = face->center(true);
                for (const unsigned int v : {0, 1})
                  action(face->vertex(v) + (middle - face->vertex(v)) / 2,
                         Tensor<1, dim>(cross_product_2d(middle - face->vertex(v))));
              });
            return;
          }
      for (const auto &cell : geometry.triangulation.active_cell_iterators())
        if (cell->is_locally_owned())
          visit(cell, [&](const auto &face) { action(face->center(), vector_area<dim>(face)); });
    }

    template <int dim>
    std::vector<MotionsOfSurface<dim>>
    motions_of_surfaces(const Geometry<dim> &geometry, const std::vector<bool> &bodies)
    {
      constexpr unsigned int n = n_rigid_motions<dim>;
      std::vector<double>    sums(bodies.size() * 2 * n * n, 0.);
      for (unsigned int b = 0; b < bodies.size(); ++b)
        if (bodies[b])
          for_each_chord(geometry, b, [&](const Point<dim> &centre, const Tensor<1, dim> &normal) {
            const double          area    = normal.norm();
            double *const         of_body = &sums[b * 2 * n * n];
            std::array<double, n> flow{};
            for (unsigned int c = 0; c < dim; ++c)
              {
                const auto v = rigid_motions(geometry, b, centre, c);
                for (unsigned int i = 0; i < n; ++i)
                  {
                    flow[i] += normal[c] / area * v[i];
                    for (unsigned int j = 0; j < n; ++j)
                      of_body[n * n + i * n + j] += area * v[i] * v[j];
                  }
              }
            for (unsigned int i = 0; i < n; ++i)
              for (unsigned int j = 0; j < n; ++j)
                of_body[i * n + j] += area * flow[i] * flow[j];
          });
      Utilities::MPI::sum(sums, geometry.communicator, sums);
      std::vector<MotionsOfSurface<dim>> result(bodies.size());
      for (unsigned int b = 0; b < bodies.size(); ++b)
        for (unsigned int i = 0; bodies[b] && i < n * n; ++i)
          {
            result[b].through(i / n, i % n) = sums[b * 2 * n * n + i];
            result[b].all(i / n, i % n)     = sums[b * 2 * n * n + n * n + i];
          }
      return result;
    }

    // The largest |v . N| over a body's surface against the largest |v|: in the mean that is little for a
    // long body that moves along its length, but its ends do.
    template <int dim>
    double
    largest_part_through(const Geometry<dim> &geometry, const unsigned int body, const Vector<double> &motion)
    {
      double through = 0, all = 0;
      for_each_chord(geometry, body, [&](const Point<dim> &centre, const Tensor<1, dim> &normal) {
        Tensor<1, dim> v;
        for (unsigned int c = 0; c < dim; ++c)
          {
            const auto parts = rigid_motions(geometry, body, centre, c);
            v[c]             = std::inner_product(parts.begin(), parts.end(), motion.begin(), 0.);
          }
        through = std::max(through, std::abs(v * normal) / normal.norm());
        all     = std::max(all, v.norm());
      });
      return Utilities::MPI::max(through, geometry.communicator) /
             Utilities::MPI::max(all, geometry.communicator);
    }

    // A vertex far from the body's centre along an axis: better inside than where something may touch; among
    // equals that next to the centre.
    template <int dim>
    struct Extreme
    {
      bool                                     is_inside = false;
      double                                   distance  = std::numeric_limits<double>::lowest();
      Point<dim>                               X;
      std::array<types::global_dof_index, dim> dofs;

      // near: lengths that are equal.
      bool
      is_beyond(const Extreme &other, const Point<dim> &centre, const double near) const
      {
        if (is_inside != other.is_inside)
          return is_inside;
        if (const double d = distance - other.distance; std::abs(d) > near)
          return d > 0;
        if (const double d = X.distance(centre) - other.X.distance(centre); std::abs(d) > near)
          return d < 0;
        for (unsigned int c = 0; c < dim; ++c)
          if (const double d = X[c] - other.X[c]; std::abs(d) > near)
            return d > 0;
        return false;
      }

      template <typename Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &is_inside &distance &X &dofs;
      }
    };

    // By axis: to either side.
    template <int dim>
    using Extremes = std::array<std::array<Extreme<dim>, 2>, dim>;

    template <int dim>
    class FreeTurns
    {
    public:
      FreeTurns(const Discretization<dim> &discretization, const std::vector<bool> &slides)
          : discretization(discretization), geometry(discretization.geometry), slides(slides)
      {
      }

      bool
      is_of_interest(const types::material_id body) const
      {
        return body < slides.size() && slides[body];
      }

      std::map<unsigned int, Extremes<dim>>
      extremes() const
      {
        std::vector<bool> is_on_surface(geometry.triangulation.n_vertices(), false);
        for (const auto &cell : geometry.triangulation.active_cell_iterators())
          if (!cell->is_artificial())
            for (const auto &face : cell->face_iterators())
              for (const unsigned int v : face->vertex_indices())
                if (face->at_boundary())
                  is_on_surface[face->vertex_index(v)] = true;
        std::map<unsigned int, Extremes<dim>> mine, all;
        for (const auto &cell : discretization.dof_handler.active_cell_iterators())
          if (cell->is_locally_owned() && is_of_interest(cell->material_id()))
            for (const unsigned int v : cell->vertex_indices())
              {
                Extreme<dim> vertex;
                vertex.is_inside = !is_on_surface[cell->vertex_index(v)];
                vertex.X         = cell->vertex(v);
                for (unsigned int c = 0; c < dim; ++c)
                  vertex.dofs[c] = cell->vertex_dof_index(v, c);
                if (!discretization.hanging_nodes.is_constrained(vertex.dofs[0]))
                  take_farther(cell->material_id(), vertex, mine[cell->material_id()]);
              }
        for (const auto &part : Utilities::MPI::all_gather(geometry.communicator, mine))
          for (const auto &[body, found] : part)
            for (const auto &axis : found)
              for (const auto &vertex : axis)
                take_farther(body, vertex, all[body]);
        return all;
      }

    private:
      void
      take_farther(const unsigned int body, Extreme<dim> vertex, Extremes<dim> &extremes) const
      {
        const auto &centre = geometry.body_centres[body];
        for (unsigned int d = 0; d < dim; ++d)
          for (const unsigned int side : {0, 1})
            {
              vertex.distance = (side == 0 ? 1 : -1) * (vertex.X[d] - centre[d]);
              if (vertex.is_beyond(extremes[d][side], centre, 1e-6 * geometry.body_sizes[body]))
                extremes[d][side] = vertex;
            }
      }

      const Discretization<dim> &discretization;
      const Geometry<dim>       &geometry;
      const std::vector<bool>   &slides;
    };
  } // namespace

  template <int dim>
  std::vector<FullMatrix<double>>
  motions_along_surfaces(const Geometry<dim> &geometry, const std::vector<bool> &bodies)
  {
    auto                            motions = motions_of_surfaces(geometry, bodies);
    std::vector<FullMatrix<double>> result(bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bodies[b])
        {
          // Each against its own size: the turn of a slender body about its length is small everywhere. The
          // normals of quadrilaterals on a sphere are a little off.
          const double                through = dim == 3 ? 0.1 : 1e-5;
          Vector<double>              parts;
          std::vector<Vector<double>> found(n_rigid_motions<dim>, Vector<double>(n_rigid_motions<dim>));
          motions[b].through.compute_generalized_eigenvalues_symmetric(
              motions[b].all, -1, through * through, 1e-300, parts, found);
          const auto leaves = [&](const auto &motion) {
            return largest_part_through(geometry, b, motion) > 2 * through;
          };
          found.erase(std::remove_if(found.begin(), found.end(), leaves), found.end());
          result[b].reinit(found.empty() ? 0 : n_rigid_motions<dim>, found.size());
          for (unsigned int k = 0; k < found.size(); ++k)
            for (unsigned int i = 0; i < n_rigid_motions<dim>; ++i)
              result[b](i, k) = found[k](i);
        }
    return result;
  }

  // Where a rigid motion v carries a body along all of its own surface, int (v . N)^2 dA = 0, its potential
  // is the same in every place: none is an equilibrium rather than another. On a mesh its facets prefer some,
  // by forces that vanish with their size, and the iteration would look for them in vain. So for each such
  // turn a difference of displacements is held.
  template <int dim>
  void
  Discretization<dim>::find_free_turns()
  {
    free_turns.clear();
    const auto slides = bodies_that_slide(scene, geometry);
    if (std::none_of(slides.begin(), slides.end(), [](const bool does) { return does; }))
      return;
    const auto all = motions_along_surfaces(geometry, slides);
    IndexSet   indices(dof_handler.n_dofs());
    for (const auto &[body, ends] : FreeTurns<dim>(*this, slides).extremes())
      {
        const FullMatrix<double> &motions = all[body];
        if (motions.m() == 0)
          continue;
        FullMatrix<double>    values(dim * (dim - 1), motions.n());
        std::vector<FreeTurn> differences;
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            if (c != d)
              {
                const auto from = rigid_motions(geometry, body, ends[d][0].X, c),
                           to   = rigid_motions(geometry, body, ends[d][1].X, c);
                for (unsigned int k = 0; k < motions.n(); ++k)
                  for (unsigned int i = 0; i < n_rigid_motions<dim>; ++i)
                    values(differences.size(), k) += (from[i] - to[i]) * motions(i, k);
                differences.push_back({body, ends[d][0].dofs[c], ends[d][1].dofs[c]});
              }
        for (const unsigned int row : candidates_that_hold(values, 1e-3))
          {
            free_turns.push_back(differences[row]);
            indices.add_index(differences[row].first);
            indices.add_index(differences[row].second);
          }
      }
    add_relevant(indices);
  }

  // Surfaces of facets press a little aside on a plane, always the same way wherever the body is: there is no
  // equilibrium. So what may slide is held by as many displacements of one body.
  template <int dim>
  void
  Discretization<dim>::find_free_slides()
  {
    free_slides = Amontons::find_free_slides(scene, geometry, true, walls);
    std::vector<bool>         holds(scene.bodies.size(), false);
    std::vector<unsigned int> body_of;
    for (const auto &slide : free_slides)
      {
        body_of.push_back(*std::find_if(
            slide.bodies.begin(), slide.bodies.end(), [&](const auto b) { return is_deformable(b); }));
        holds[body_of.back()] = true;
      }
    if (free_slides.empty())
      return;
    const auto ends = FreeTurns<dim>(*this, holds).extremes();
    IndexSet   indices(dof_handler.n_dofs());
    for (unsigned int s = 0; s < free_slides.size(); ++s)
      {
        const auto           &motions = free_slides[s].motions;
        std::vector<HeldPair> candidates;
        FullMatrix<double>    values(dim * dim, motions.n());
        for (unsigned int d = 0; d < dim; ++d)
          for (unsigned int c = 0; c < dim; ++c)
            {
              const auto &[from, to] = ends.at(body_of[s])[d];
              const double sign      = c == d ? -1 : 1;
              const auto   is_second = [dof = from.dofs[c], other = to.dofs[c]](const FreeTurn &turn) {
                return turn.second == dof || turn.second == other;
              };
              if (std::any_of(free_turns.begin(), free_turns.end(), is_second))
                continue;
              const auto v = rigid_motions(geometry, body_of[s], from.X, c),
                         w = rigid_motions(geometry, body_of[s], to.X, c);
              for (unsigned int k = 0; k < motions.n(); ++k)
                for (unsigned int i = 0; i < v.size(); ++i)
                  values(candidates.size(), k) += (w[i] - sign * v[i]) * motions(i, k);
              candidates.push_back({from.dofs[c], to.dofs[c], sign});
            }
        for (const unsigned int row : candidates_that_hold(values, 1e-3))
          {
            const auto [first, second, sign] = candidates[row];
            const bool are_held              = // by the other sign: both are zero
                std::any_of(free_slides[s].held.begin(),
                            free_slides[s].held.end(),
                            [a = first, b = second](const auto &pair) {
                              return pair.first == a && pair.second == b;
                            });
            free_slides[s].held.push_back({first, are_held ? first : second, sign});
            indices.add_index(candidates[row].first);
            indices.add_index(candidates[row].second);
          }
      }
    add_relevant(indices);
  }

  template std::vector<FullMatrix<double>>
  motions_along_surfaces(const Geometry<2> &, const std::vector<bool> &);
  template std::vector<FullMatrix<double>>
  motions_along_surfaces(const Geometry<3> &, const std::vector<bool> &);
  template void
  Discretization<2>::find_free_turns();
  template void
  Discretization<2>::find_free_slides();
  template void
  Discretization<3>::find_free_slides();
  template void
  Discretization<3>::find_free_turns();
} // namespace Amontons
