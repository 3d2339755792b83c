#include <amontons/base/directions.h>
#include <amontons/discretization/free_slides.h>
#include <amontons/geometry/vector_area.h>

#include <algorithm>
#include <numeric>

namespace Amontons
{
  namespace
  {
    // What the bodies that touch each other may not move along.
    template <int dim>
    class Held
    {
    public:
      Held(const Scene &scene, const bool with_forces) : scene(scene), with_forces(with_forces) {}

      void
      add(const Tensor<1, 3> &direction)
      {
        constexpr double least = 1e-9; // of a force that is none beside another: rounding
        Tensor<1, dim>   d;
        for (unsigned int c = 0; c < dim; ++c)
          d[c] = direction[c];
        const double length = d.norm();
        for (unsigned int twice = 0; twice < 2; ++twice)
          d = without(d, held);
        if (d.norm() > least * length)
          held.push_back(d / d.norm());
      }

      void
      add_axis(const unsigned int c)
      {
        Tensor<1, 3> axis;
        axis[c] = 1;
        add(axis);
      }

      // A force (per area or volume, or of a motion) at all times.
      void
      add_force(const std::array<Expression, 3> &force)
      {
        if (!with_forces)
          return;
        const bool varies =
            std::any_of(force.begin(), force.end(), [](const auto &e) { return e.depends_on_place(); });
        for (unsigned int c = 0; varies && c < dim; ++c)
          if (!force[c].is_zero())
            add_axis(c);
        constexpr unsigned int n = 64;
        for (unsigned int k = 0; !varies && k <= n; ++k)
          {
            Tensor<1, 3> f;
            for (unsigned int c = 0; c < dim; ++c)
              f[c] = force[c].value(Point<3>(), scene.end_time * k / n);
            add(f);
          }
      }

      void
      add_motion(const MotionData &motion)
      {
        for (unsigned int c = 0; c < dim; ++c)
          if (motion.displacement[c])
            add_axis(c);
        add_force(motion.force);
        may_turn = false;
        is_fixed = is_fixed || !with_forces; // its force is not that of a body
      }

      void
      add_condition(const ConditionData &condition)
      {
        using Type = ConditionData::Type;
        if (condition.type == Type::pressure || condition.field) // turns with the surface; may hold anything
          is_fixed = true;
        else if (condition.type == Type::platen)
          add_motion(*condition.motion);
        else if (condition.type == Type::displacement)
          {
            for (unsigned int c = 0; c < dim; ++c)
              if (condition.displacement[c])
                add_axis(c);
          }
        else if (condition.type != Type::symmetry)
          add_force(condition.value);
      }

      void
      add_obstacle(const PairData &pair)
      {
        const auto obstacle = std::find_if(scene.obstacles.begin(),
                                           scene.obstacles.end(),
                                           [&](const auto &o) { return o.name == pair.obstacle; });
        const auto turns    = [](const auto &rotation) { return rotation && !rotation->is_zero(); };
        if (pair.tied || pair.has_friction() || obstacle->type != ObstacleData::Type::plane ||
            obstacle->size > 0 ||
            std::any_of(obstacle->motion.rotation.begin(), obstacle->motion.rotation.end(), turns))
          is_fixed = true;
        else
          add(obstacle->normal);
        touches_plane = true;
      }

      // Columns: rigid motions that are left.
      FullMatrix<double>
      motions_left() const
      {
        const auto left = directions_left(held);
        if (is_fixed || !touches_plane || left.empty())
          return FullMatrix<double>();
        const bool         turns = dim == 3 && may_turn && held.size() == 1;
        FullMatrix<double> motions(n_rigid_motions<dim>, left.size() + turns);
        for (unsigned int k = 0; k < left.size(); ++k)
          for (unsigned int c = 0; c < dim; ++c)
            motions(c, k) = left[k][c];
        if (turns) // about d: d_z in the plane (x, y), -d_y in (x, z), d_x in (y, z)
          for (unsigned int i = 0; i < 3; ++i)
            motions(dim + i, left.size()) = (i == 1 ? -1 : 1) * held[0][dim - 1 - i];
        return motions;
      }

    private:
      const Scene                &scene;
      const bool                  with_forces;
      std::vector<Tensor<1, dim>> held; // of unit length, square to each other
      bool                        is_fixed = false, touches_plane = false, may_turn = true;
    };

    // By body: the first of those that it touches, directly or by others.
    template <int dim>
    std::vector<unsigned int>
    groups_of_bodies(const Scene &scene, const Geometry<dim> &geometry)
    {
      std::vector<unsigned int> group(scene.bodies.size());
      std::iota(group.begin(), group.end(), 0U);
      for (const auto &pair : scene.pairs)
        if (pair.second)
          {
            const auto         ends  = std::minmax(group[geometry.boundary(pair.first, scene).body],
                                          group[geometry.boundary(*pair.second, scene).body]);
            const unsigned int first = ends.first, second = ends.second;
            std::replace(group.begin(), group.end(), second, first);
          }
      return group;
    }

    // On the coarse mesh, which every rank has.
    template <int dim>
    Tensor<1, 3>
    normal_of_plane(const Geometry<dim> &geometry, const types::boundary_id id)
    {
      Tensor<1, 3> result;
      for (const auto &cell : geometry.triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary() && face->boundary_id() == id)
            {
              const auto normal = vector_area<dim>(face);
              for (unsigned int c = 0; c < dim; ++c)
                result[c] = normal[c];
              return result;
            }
      return result;
    }
  } // namespace

  template <int dim>
  std::vector<FreeSlide>
  find_free_slides(const Scene                 &scene,
                   const Geometry<dim>         &geometry,
                   const bool                   with_forces,
                   const std::set<std::string> &walls)
  {
    if (scene.kind == ProblemType::axisymmetric)
      return {};
    const auto                        group = groups_of_bodies(scene, geometry);
    std::map<unsigned int, Held<dim>> held;
    std::map<unsigned int, FreeSlide> slides;
    for (unsigned int b = 0; b < group.size(); ++b)
      {
        auto &of_group = held.try_emplace(group[b], scene, with_forces).first->second;
        slides[group[b]].bodies.push_back(b);
        of_group.add_force(scene.bodies[b].body_force);
        if (scene.bodies[b].rigid)
          of_group.add_motion(*scene.bodies[b].rigid);
      }
    for (const auto &condition : scene.conditions)
      for (const auto &name : condition.boundaries)
        {
          const auto &boundary = geometry.boundary(name, scene);
          auto       &of_group = held.at(group[boundary.body]);
          of_group.add_condition(condition);
          if (condition.type == ConditionData::Type::symmetry)
            of_group.add(normal_of_plane(geometry, boundary.id));
        }
    for (const auto &pair : scene.pairs)
      if (!pair.second && walls.count(pair.name) == 0)
        held.at(group[geometry.boundary(pair.first, scene).body]).add_obstacle(pair);

    std::vector<FreeSlide> result;
    for (auto &[first, slide] : slides)
      {
        slide.motions = held.at(first).motions_left();
        if (slide.motions.m() > 0)
          result.push_back(std::move(slide));
      }
    return result;
  }

  template std::vector<FreeSlide>
  find_free_slides(const Scene &, const Geometry<2> &, const bool, const std::set<std::string> &);
  template std::vector<FreeSlide>
  find_free_slides(const Scene &, const Geometry<3> &, const bool, const std::set<std::string> &);
} // namespace Amontons
