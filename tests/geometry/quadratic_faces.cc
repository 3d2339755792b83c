// Nodes in the middle of edges and faces of a mesh file are geometry, which refinement follows.
#include "check.h"

#include <amontons/geometry/geometry.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace test_quadratic_faces
{
using namespace Amontons;
using namespace dealii;

const std::string folder =
    (std::filesystem::temp_directory_path() / ("amontons_quadratic_faces_" + std::to_string(getpid())))
        .string();

// All vertices of the boundary `name` of the mesh `text`, refined, in the coordinates of the file: the body
// is turned by 90 degrees and shifted.
template <int dim>
std::vector<Point<dim>>
vertices_on(const std::string &name,
            const std::string &file,
            const std::string &text,
            const unsigned int refinements)
{
  std::filesystem::create_directories(folder);
  std::ofstream(folder + "/" + file) << text;
  Scene    scene;
  BodyData body;
  body.name           = "it";
  body.shape          = "file";
  body.mesh_file      = folder + "/" + file;
  body.rotation_angle = 90;
  body.shift          = Tensor<1, 3>({3, 4, 0});
  body.refinements    = refinements;
  scene.kind          = dim == 3 ? ProblemType::three_dimensional : ProblemType::plane_strain;
  scene.bodies        = {body};
  Geometry<dim> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  const auto             &boundary = geometry.boundary({"it", name, {}}, scene);
  std::vector<Point<dim>> points;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (face->at_boundary() && face->boundary_id() == boundary.id)
        for (const unsigned int v : face->vertex_indices())
          {
            auto         p = face->vertex(v);
            const double x = p[1] - 4, y = 3 - p[0];
            p[0] = x;
            p[1] = y;
            points.push_back(p);
          }
  return points;
}

// gmsh's format 2.2: one cell and one named boundary.
std::string
gmsh(const std::vector<Point<3>> &nodes, const unsigned int type, const std::string &face)
{
  std::ostringstream text;
  text.precision(16);
  const unsigned int dim = type == 10 || type == 16 || type == 36 ? 2 : 3;
  text << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n"
       << dim - 1 << " 1 \"top\"\n$EndPhysicalNames\n$Nodes\n"
       << nodes.size() << "\n";
  for (unsigned int i = 0; i < nodes.size(); ++i)
    text << i + 1 << " " << nodes[i] << "\n";
  text << "$EndNodes\n$Elements\n2\n1 " << (dim == 2 ? 1 : 3) << " 2 1 1 " << face << "\n2 " << type
       << " 2 2 2";
  for (unsigned int i = 0; i < nodes.size(); ++i)
    text << " " << i + 1;
  text << "\n$EndElements\n";
  return text.str();
}

std::string
abaqus(const std::vector<Point<3>> &nodes, const std::string &type, const std::string &face)
{
  std::ostringstream text;
  text.precision(16);
  text << "*NODE\n";
  for (unsigned int i = 0; i < nodes.size(); ++i)
    text << i + 1 << ", " << nodes[i][0] << ", " << nodes[i][1] << ", " << nodes[i][2] << "\n";
  text << "*ELEMENT, TYPE=" << type << ", ELSET=all\n1";
  for (unsigned int i = 0; i < nodes.size(); ++i)
    text << (i % 8 == 7 ? ",\n" : ", ") << i + 1;
  text << "\n*SURFACE, NAME=top\nall, " << face << "\n";
  return text.str();
}

// The upper edge is y = 1 + 0.8 x (1 - x); on the straight right one the node is not in the middle.
void
check_plane()
{
  const std::vector<Point<3>> nodes = {{0, 0, 0},
                                       {1, 0, 0},
                                       {1, 1, 0},
                                       {0, 1, 0},
                                       {0.5, 0, 0},
                                       {1, 0.6, 0},
                                       {0.5, 1.2, 0},
                                       {0, 0.5, 0},
                                       {0.5, 0.6, 0}};
  const std::vector<Point<3>> eight(nodes.begin(), nodes.begin() + 8);
  std::vector<Point<3>>       sixteen(nodes.begin(), nodes.begin() + 4); // third order
  for (const Point<2> &p : {Point<2>(1, 0),
                            Point<2>(2, 0),
                            Point<2>(3, 1),
                            Point<2>(3, 2),
                            Point<2>(2, 3),
                            Point<2>(1, 3),
                            Point<2>(0, 2),
                            Point<2>(0, 1),
                            Point<2>(1, 1),
                            Point<2>(2, 1),
                            Point<2>(2, 2),
                            Point<2>(1, 2)})
    sixteen.emplace_back(p[0] / 3, p[1] / 3 * (1 + (p[1] == 3 ? 0.8 * 2 / 9 : 0.)), 0);
  for (const auto &[file, text] :
       std::vector<std::pair<std::string, std::string>>{{"nine.msh", gmsh(nodes, 10, "3 4")},
                                                        {"sixteen.msh", gmsh(sixteen, 36, "3 4")},
                                                        {"eight.msh", gmsh(eight, 16, "3 4")},
                                                        {"eight.inp", abaqus(eight, "CPE8", "S3")}})
    {
      const auto points = vertices_on<2>("top", file, text, 3);
      check::is_true(points.size() == 16, file + ": vertices of the edge");
      for (const auto &p : points)
        {
          check::is_close(p[1], 1 + 0.8 * p[0] * (1 - p[0]), 1e-12, file + ": the edge is a parabola");
          check::is_close(p[0] * 8, std::round(p[0] * 8), 1e-12, file + ": evenly refined", 1);
        }
    }
}

// The upper face is z = 1 + 0.4 x (1 - x) + 0.8 y (1 - y) + bump 16 x (1 - x) y (1 - y).
void
check_space()
{
  const auto height = [](const double x, const double y, const double bump) {
    return 1 + 0.4 * x * (1 - x) + 0.8 * y * (1 - y) + 16 * bump * x * (1 - x) * y * (1 - y);
  };
  const std::vector<std::array<unsigned int, 2>> of_gmsh   = {{{0, 1}},
                                                              {{0, 3}},
                                                              {{0, 4}},
                                                              {{1, 2}},
                                                              {{1, 5}},
                                                              {{2, 3}},
                                                              {{2, 6}},
                                                              {{3, 7}},
                                                              {{4, 5}},
                                                              {{4, 7}},
                                                              {{5, 6}},
                                                              {{6, 7}}};
  const std::vector<std::array<unsigned int, 2>> of_abaqus = {{{0, 1}},
                                                              {{1, 2}},
                                                              {{2, 3}},
                                                              {{3, 0}},
                                                              {{4, 5}},
                                                              {{5, 6}},
                                                              {{6, 7}},
                                                              {{7, 4}},
                                                              {{0, 4}},
                                                              {{1, 5}},
                                                              {{2, 6}},
                                                              {{3, 7}}};
  const auto nodes_with = [&](const auto &edges, const double bump, const bool whole) {
    std::vector<Point<3>> nodes = {
        {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (const auto &edge : edges)
      {
        Point<3> p = nodes[edge[0]] + 0.5 * (nodes[edge[1]] - nodes[edge[0]]);
        if (p[2] == 1)
          p[2] = height(p[0], p[1], 0);
        nodes.push_back(p);
      }
    if (whole)
      for (const Point<3> &p : {Point<3>(.5, .5, 0),
                                Point<3>(.5, 0, .5),
                                Point<3>(0, .5, .5),
                                Point<3>(1, .5, .5),
                                Point<3>(.5, 1, .5),
                                Point<3>(.5, .5, height(.5, .5, bump)),
                                Point<3>(.5, .5, .5)})
        nodes.push_back(p);
    return nodes;
  };
  // Of third order: two nodes on each edge, four on each face, eight inside.
  std::vector<Point<3>> cubic = nodes_with(of_gmsh, 0, false);
  cubic.resize(8);
  const auto on_top = [&](Point<3> p) {
    if (p[2] > 0.999)
      p[2] = height(p[0], p[1], 0.1);
    cubic.push_back(p);
  };
  const std::vector<Point<3>> corners = cubic;
  for (const auto &edge : of_gmsh)
    for (const double part : {1. / 3, 2. / 3})
      on_top(corners[edge[0]] + part * (corners[edge[1]] - corners[edge[0]]));
  for (const auto &[across, at] :
       std::vector<std::pair<unsigned int, double>>{{2, 0.}, {1, 0.}, {0, 0.}, {0, 1.}, {1, 1.}, {2, 1.}})
    for (const double a : {1. / 3, 2. / 3})
      for (const double b : {1. / 3, 2. / 3})
        {
          Point<3> p;
          p[across]           = at;
          p[(across + 1) % 3] = a;
          p[(across + 2) % 3] = b;
          on_top(p);
        }
  cubic.resize(64);
  struct Case
  {
    std::string file, text;
    double      bump;
  };
  for (const Case &c : {Case{"20.msh", gmsh(nodes_with(of_gmsh, 0, false), 17, "5 6 7 8"), 0},
                        Case{"27.msh", gmsh(nodes_with(of_gmsh, 0.1, true), 12, "5 6 7 8"), 0.1},
                        Case{"64.msh", gmsh(cubic, 92, "5 6 7 8"), 0.1},
                        Case{"20.inp", abaqus(nodes_with(of_abaqus, 0, false), "C3D20", "S2"), 0}})
    {
      const auto points = vertices_on<3>("top", c.file, c.text, 2);
      check::is_true(points.size() == 64, c.file + ": vertices of the face");
      for (const auto &p : points)
        check::is_close(
            p[2], height(p[0], p[1], c.bump), 1e-12, c.file + ": the face is as curved as its nodes");
    }
}

void
check_errors()
{
  std::string message;
  try
    {
      vertices_on<2>("top",
                     "back.msh",
                     gmsh({{0, 0, 0},
                           {1, 0, 0},
                           {1, 1, 0},
                           {0, 1, 0},
                           {0.5, 0, 0},
                           {1, 0.5, 0},
                           {0.9, 1.2, 0},
                           {0, 0.5, 0}},
                          16,
                          "3 4"),
                     0);
    }
  catch (const InputError &error)
    {
      message = error.what();
    }
  check::is_true(message.find("the edge turns back") != std::string::npos,
                 "an edge that turns back: " + message);
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_plane();
  check_space();
  check_errors();
  std::filesystem::remove_all(folder);
  return check::result();
}
} // namespace test_quadratic_faces
