#include <amontons/geometry/geometry.h>
#include <amontons/geometry/grid_reader.h>
#include <amontons/geometry/grids.h>
#include <amontons/geometry/manifolds.h>
#include <amontons/geometry/placement.h>

#include <deal.II/base/bounding_box.h>

#include <algorithm>

namespace Amontons
{
  using namespace dealii;

  namespace
  {
    template <int dim>
    CoarseMesh<dim>
    make_body(const BodyData &body, const ProblemType kind, MPI_Comm communicator)
    {
      CoarseMesh<dim> mesh = body.shape == "file" ? read_grid<dim>(body, communicator) : make_grid<dim>(body);
      check_cell_count<dim>(body, mesh.cells.size());
      for (const auto &[name, shape] : body.true_geometry)
        {
          if (std::find(mesh.names.begin(), mesh.names.end(), name) == mesh.names.end())
            throw InputError(body.where,
                             "a curved geometry for boundary '" + name + "', which the body does not have" +
                                 suggestion(name, mesh.names));
          mesh.geometry[name] = shape;
        }
      place(body, kind, mesh);
      return mesh;
    }

    // The motions in the order of their carriers.
    std::vector<MotionData>
    all_motions(const Scene &scene)
    {
      std::vector<MotionData> motions;
      for (const auto &body : scene.bodies)
        if (body.rigid)
          motions.push_back(*body.rigid);
      for (const auto &obstacle : scene.obstacles)
        motions.push_back(obstacle.motion);
      for (const auto &condition : scene.conditions)
        if (condition.motion)
          motions.push_back(*condition.motion);
      return motions;
    }

    // That of the bodies, unless they are far from the reference: what a carrier's nodes say would be
    // multiples of their differences there.
    template <int dim>
    double
    size_of_carrier(const MotionData &motion, const Geometry<dim> &geometry, const double size_of_bodies)
    {
      constexpr double far = 100;
      Point<dim>       reference;
      for (unsigned int d = 0; d < dim; ++d)
        reference[d] = motion.reference[d];
      double distance = 0;
      for (const auto &centre : geometry.body_centres)
        distance = std::max(distance, reference.distance(centre));
      return distance > far * size_of_bodies ? distance : size_of_bodies;
    }

    // The coarse mesh of all bodies and carriers.
    template <int dim>
    struct Assembly
    {
      std::vector<Point<dim>>                    vertices;
      std::vector<CellData<dim>>                 cells;
      std::map<FaceKey<dim>, types::boundary_id> ids;
      std::vector<types::boundary_id>            unnamed; // by material id
      types::boundary_id                         next_id = 1;
      MiddleNodes<dim>                           middle_nodes;
    };

    template <typename Nodes>
    void
    add_shifted(const Nodes &nodes, const unsigned int first_vertex, Nodes &all)
    {
      for (const auto &[old_key, p] : nodes)
        {
          auto key = old_key;
          for (unsigned int &v : key)
            v += first_vertex;
          all[key] = p;
        }
    }

    template <int dim>
    void
    add_body(CoarseMesh<dim>        mesh,
             const unsigned int     body,
             std::vector<Boundary> &boundaries,
             Assembly<dim>         &assembly)
    {
      const unsigned int first_vertex = assembly.vertices.size();
      assembly.vertices.insert(assembly.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
      for (auto &cell : mesh.cells)
        {
          for (unsigned int &v : cell.vertices)
            v += first_vertex;
          cell.material_id = body;
          assembly.cells.push_back(cell);
        }

      add_shifted(mesh.middle_nodes.of_edges, first_vertex, assembly.middle_nodes.of_edges);
      add_shifted(mesh.middle_nodes.of_faces, first_vertex, assembly.middle_nodes.of_faces);
      const types::boundary_id first_id = assembly.next_id;
      for (const auto &[old_key, name] : mesh.boundaries)
        {
          FaceKey<dim> key = old_key;
          for (unsigned int &v : key)
            v += first_vertex;
          assembly.ids[key] = first_id + name;
        }
      for (const std::string &name : mesh.names)
        boundaries.push_back({body,
                              name,
                              assembly.next_id++,
                              mesh.geometry.count(name) ? mesh.geometry[name] : TrueGeometry()});
      assembly.unnamed.push_back(assembly.next_id++);
    }

    template <int dim>
    void
    add_carrier(const CarrierCell &carrier, Assembly<dim> &assembly)
    {
      CellData<dim> cell;
      cell.material_id = carrier.material_id;
      for (unsigned int v = 0; v < cell.vertices.size(); ++v)
        {
          Point<dim> p;
          for (unsigned int d = 0; d < dim; ++d)
            p[d] = carrier.motion.reference[d] + ((v >> d) & 1) * carrier.size;
          cell.vertices[v] = assembly.vertices.size();
          assembly.vertices.push_back(p);
        }
      assembly.cells.push_back(cell);
      assembly.unnamed.push_back(assembly.next_id++);
    }

    template <int dim>
    void
    set_boundary_ids(const Assembly<dim> &assembly, Triangulation<dim> &triangulation)
    {
      for (const auto &cell : triangulation.cell_iterators_on_level(0))
        for (const auto &face : cell->face_iterators())
          if (face->at_boundary())
            {
              FaceKey<dim> key;
              for (unsigned int v = 0; v < key.size(); ++v)
                key[v] = face->vertex_index(v);
              std::sort(key.begin(), key.end());
              const auto named = assembly.ids.find(key);
              face->set_all_boundary_ids(named != assembly.ids.end() ? named->second
                                                                     : assembly.unnamed[cell->material_id()]);
            }
    }

    template <int dim>
    void
    refine_bodies(const std::vector<BodyData> &bodies, Triangulation<dim> &triangulation)
    {
      unsigned int n_refinements = 0;
      for (const auto &body : bodies)
        n_refinements = std::max(n_refinements, body.refinements);
      for (unsigned int i = 0; i < n_refinements; ++i)
        {
          for (const auto &cell : triangulation.active_cell_iterators())
            if (cell->is_locally_owned() && cell->material_id() < bodies.size() &&
                i < bodies[cell->material_id()].refinements)
              cell->set_refine_flag();
          triangulation.execute_coarsening_and_refinement();
        }
    }
  } // namespace

  template <int dim>
  Geometry<dim>::Geometry(MPI_Comm communicator) : communicator(communicator), triangulation(communicator)
  {
  }

  template <int dim>
  const Boundary &
  Geometry<dim>::boundary(const BoundaryName &name, const Scene &scene) const
  {
    std::vector<std::string> bodies, names;
    for (const auto &body : scene.bodies)
      bodies.push_back(body.name);
    const auto body = std::find(bodies.begin(), bodies.end(), name.body);
    if (body == bodies.end())
      throw InputError(name.where, "there is no body '" + name.body + "'" + suggestion(name.body, bodies));

    std::string list;
    for (const Boundary &b : boundaries)
      if (b.body == body - bodies.begin())
        {
          if (b.name == name.boundary)
            return b;
          names.push_back(b.name);
          list += (list.empty() ? "" : ", ") + b.name;
        }
    throw InputError(name.where,
                     "body '" + name.body + "' has no boundary '" + name.boundary + "'" +
                         suggestion(name.boundary, names),
                     "its boundaries: " + (list.empty() ? "none has a name" : list));
  }

  template <int dim>
  unsigned int
  Geometry<dim>::carrier(const std::string &motion) const
  {
    for (unsigned int i = 0; i < carriers.size(); ++i)
      if (carriers[i].motion.name == motion)
        return i;
    AssertThrow(false, ExcMessage("There is no motion called " + motion));
    return numbers::invalid_unsigned_int;
  }

  template <int dim>
  bool
  Geometry<dim>::is_carrier(const types::material_id id) const
  {
    return id >= n_bodies;
  }

  template <int dim>
  void
  make_geometry(const Scene &scene, Geometry<dim> &geometry, const bool refine)
  {
    Assembly<dim>                            assembly;
    std::vector<std::optional<TrueGeometry>> polar;
    double                                   largest = 0;
    geometry.n_bodies                                = scene.bodies.size();
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      {
        const auto mesh = make_body<dim>(scene.bodies[b], scene.kind, geometry.communicator);
        const auto box  = BoundingBox<dim>(mesh.vertices).get_boundary_points();
        geometry.body_sizes.push_back(box.first.distance(box.second));
        geometry.body_centres.push_back(box.first + 0.5 * (box.second - box.first));
        geometry.of_second_order.push_back(!mesh.middle_nodes.of_edges.empty());
        largest = std::max(largest, geometry.body_sizes.back());
        polar.push_back(mesh.polar);
        add_body(mesh, b, geometry.boundaries, assembly);
      }

    for (const MotionData &motion : all_motions(scene))
      {
        geometry.carriers.push_back(
            {static_cast<types::material_id>(geometry.n_bodies + geometry.carriers.size()),
             motion,
             size_of_carrier(motion, geometry, largest > 0 ? largest : 1.)});
        if (scene.kind == ProblemType::axisymmetric)
          geometry.carriers.back().motion.reference[0] = 0;
        add_carrier(geometry.carriers.back(), assembly);
      }

    auto &triangulation = geometry.triangulation;
    triangulation.create_triangulation(assembly.vertices, assembly.cells, SubCellData());
    set_boundary_ids(assembly, triangulation);
    for (unsigned int b = 0; b < scene.bodies.size(); ++b)
      if (polar[b])
        attach_polar_manifold(b, *polar[b], assembly.unnamed[b], triangulation);
    const auto next_id = attach_manifolds(scene, assembly.next_id, geometry);
    try
      {
        attach_quadratic_faces(assembly.middle_nodes, next_id, triangulation);
      }
    catch (const std::invalid_argument &failure)
      {
        throw InputError({scene.file, 0, ""},
                         failure.what(),
                         "meshes of second order with nodes near the middle of edges");
      }
    if (refine)
      refine_bodies(scene.bodies, triangulation);
  }

  template class Geometry<2>;
  template class Geometry<3>;
  template void
  make_geometry<2>(const Scene &, Geometry<2> &, const bool);
  template void
  make_geometry<3>(const Scene &, Geometry<3> &, const bool);
} // namespace Amontons
