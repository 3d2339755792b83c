#include <amontons/contact/surface_fields.h>
#include <amontons/output/mirror_symmetry.h>

#include <deal.II/base/bounding_box.h>

#include <sstream>

namespace Amontons
{
  namespace
  {
    template <int dim>
    struct Vertex
    {
      types::material_id body = 0;
      Point<dim>         place;
      Tensor<1, dim>     displacement;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &body &place &displacement;
      }
    };

    // Of the coarse mesh, the same on all ranks.
    template <int dim>
    std::vector<Vertex<dim>>
    coarse_vertices(const Answer<dim> &answer)
    {
      const auto            &discretization = answer.discretization;
      std::set<unsigned int> coarse;
      for (const auto &cell : discretization.geometry.triangulation.cell_iterators_on_level(0))
        for (const unsigned int v : cell->vertex_indices())
          coarse.insert(cell->vertex_index(v));
      std::map<unsigned int, Vertex<dim>> found;
      for (const auto &cell : discretization.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() < discretization.scene.bodies.size())
          for (const unsigned int v : cell->vertex_indices())
            if (const unsigned int index = cell->vertex_index(v); coarse.count(index) > 0)
              {
                Vertex<dim> &vertex = found[index];
                vertex.body         = cell->material_id();
                vertex.place        = cell->vertex(v);
                for (unsigned int c = 0; c < dim; ++c)
                  vertex.displacement[c] = answer.state.displacement(cell->vertex_dof_index(v, c));
              }
      std::vector<Vertex<dim>> mine, all;
      for (const auto &entry : found)
        mine.push_back(entry.second);
      for (const auto &part : Utilities::MPI::all_gather(discretization.geometry.communicator, mine))
        all.insert(all.end(), part.begin(), part.end());
      return all;
    }

    // Of each pair that touches, and of all supports: their own mirror images, too, if the scene is.
    template <int dim>
    std::vector<Tensor<1, dim>>
    resulting_forces(const Answer<dim> &answer)
    {
      std::vector<Tensor<1, dim>> forces;
      for (const auto &fields : answer.fields)
        if (const Tensor<1, dim> force = fields.normal_force + fields.tangential_force; force.norm() > 0)
          forces.push_back(force);
      if (forces.empty())
        return forces;
      Tensor<1, dim> sum;
      for (const auto &reaction : compute_reactions(answer))
        for (unsigned int c = 0; c < dim; ++c)
          sum[c] += reaction.force[c];
      if (sum.norm() > 1e-3 * forces.front().norm())
        forces.push_back(sum);
      return forces;
    }

    // Whether moments of the pressures of all pairs, odd along the axis, vanish against those of the absolute
    // values: xi y^j z^k and xi^3, with xi from the middle, j + k <= 3. Of a scene that is its own mirror
    // image all do, though two of its pairs may be images of each other.
    template <int dim>
    bool
    presses_mirrored(const Answer<dim> &answer,
                     const unsigned int axis,
                     const Point<dim>  &middle,
                     const double       size,
                     const double       allowed)
    {
      std::map<std::array<unsigned int, 3>, std::array<double, 2>> moments; // by exponents: signed, absolute
      for (unsigned int pair = 0; pair < answer.interfaces.size(); ++pair)
        for (const auto &point : answer.interfaces[pair].coupling.points)
          {
            const double f = value_on_face(*answer.interfaces[pair].slave,
                                           answer.fields[pair].pressure,
                                           point.slave_face,
                                           point.xi_slave) *
                             point.weight;
            const auto r = (point.x_slave - middle) / size;
            for (unsigned int i : {1, 3})
              for (unsigned int j = 0; j <= 3; ++j)
                for (unsigned int k = 0; k <= (dim == 3 ? 3 - j : 0); ++k)
                  if (i == 1 || j + k == 0)
                    {
                      const double moment = f * std::pow(r[axis], i) * std::pow(r[(axis + 1) % dim], j) *
                                            std::pow(r[(axis + 2) % dim], k);
                      moments[{{i, j, k}}][0] += moment;
                      moments[{{i, j, k}}][1] += std::abs(moment);
                    }
          }
      return std::all_of(moments.begin(), moments.end(), [&](const auto &entry) {
        return std::abs(entry.second[0]) <= allowed * entry.second[1];
      });
    }

    // Of all bodies, from their means: what is large of it.
    template <int dim>
    double
    largest_deformation(const std::vector<Vertex<dim>> &vertices)
    {
      std::map<types::material_id, std::pair<Tensor<1, dim>, unsigned int>> sums;
      for (const auto &vertex : vertices)
        {
          sums[vertex.body].first += vertex.displacement;
          ++sums[vertex.body].second;
        }
      double largest = 0;
      for (const auto &vertex : vertices)
        {
          const auto &[sum, n] = sums[vertex.body];
          largest              = std::max(largest, (vertex.displacement - sum / n).norm());
        }
      return largest;
    }

    template <int dim, typename Vector>
    Vector
    mirrored(Vector vector, const unsigned int axis, const double middle)
    {
      vector[axis] = 2 * middle - vector[axis];
      return vector;
    }

    template <int dim>
    bool
    is_mirrored(const std::vector<Vertex<dim>> &vertices,
                const unsigned int              axis,
                const double                    middle,
                const double                    size,
                const double                    allowed)
    {
      return std::all_of(vertices.begin(), vertices.end(), [&](const auto &vertex) {
        const Point<dim>     place = mirrored<dim>(vertex.place, axis, middle);
        const Tensor<1, dim> u     = mirrored<dim>(vertex.displacement, axis, 0);
        return std::any_of(vertices.begin(), vertices.end(), [&](const auto &other) {
          return other.body == vertex.body && (other.place - place).norm() <= 1e-8 * size &&
                 (other.displacement - u).norm() <= allowed;
        });
      });
    }
    // Mirror images turn the other way, but for turns about the axis.
    bool
    turns_obstacles(const Scene &scene, const unsigned int axis)
    {
      const auto turns = [](const MotionData &motion, const unsigned int k) {
        return motion.rotation[k] ? !motion.rotation[k]->is_zero() : !motion.moment[k].is_zero();
      };
      return std::any_of(scene.obstacles.begin(), scene.obstacles.end(), [&](const auto &obstacle) {
        return turns(obstacle.motion, (axis + 1) % 3) || turns(obstacle.motion, (axis + 2) % 3);
      });
    }
  } // namespace

  template <int dim>
  std::vector<std::string>
  mirror_planes(const Answer<dim>                      &answer,
                const double                            tolerance,
                const std::vector<LoadRecord::Landing> &breakpoints)
  {
    constexpr unsigned int many     = 2000; // each is compared with each
    const auto             vertices = coarse_vertices(answer);
    auto                   forces   = resulting_forces(answer);
    if (vertices.size() > many || forces.empty())
      return {};
    for (const auto &landing : breakpoints)
      for (const auto &pair : landing.pairs)
        if (const auto force = pair.normal_force + pair.tangential_force; force.norm() > 0)
          {
            forces.emplace_back();
            for (unsigned int d = 0; d < dim; ++d)
              forces.back()[d] = force[d];
          }
    std::vector<Point<dim>> places;
    places.reserve(vertices.size());
    for (const auto &vertex : vertices)
      places.push_back(vertex.place);
    const double             largest = largest_deformation(vertices);
    const auto               corners = BoundingBox<dim>(places).get_boundary_points();
    const double             size    = corners.first.distance(corners.second);
    const bool               turned  = answer.discretization.scene.kind == ProblemType::axisymmetric;
    std::vector<std::string> planes;
    for (unsigned int axis = turned ? 1 : 0; axis < dim; ++axis)
      if (const double middle = (corners.first[axis] + corners.second[axis]) / 2;
          std::all_of(forces.begin(),
                      forces.end(),
                      [&](const auto &f) { return std::abs(f[axis]) <= 1e-6 * f.norm(); }) &&
          !turns_obstacles(answer.discretization.scene, axis) &&
          is_mirrored(vertices, axis, middle, size, tolerance * largest) &&
          presses_mirrored(
              answer, axis, corners.first + (corners.second - corners.first) / 2, size, 10 * tolerance))
        {
          std::ostringstream text;
          text << "xyz"[axis] << " = " << (std::abs(middle) < 1e-8 * size ? 0 : middle);
          planes.push_back(text.str());
        }
    return planes;
  }

  template std::vector<std::string>
  mirror_planes(const Answer<2> &, const double, const std::vector<LoadRecord::Landing> &);
  template std::vector<std::string>
  mirror_planes(const Answer<3> &, const double, const std::vector<LoadRecord::Landing> &);
} // namespace Amontons
