// Mesh files give cells and named boundaries; what is wrong in them is said with its line and a remedy.
#include "check.h"

#include <amontons/geometry/geometry.h>
#include <amontons/geometry/grid_reader.h>

#include <deal.II/grid/grid_tools.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace test_grid_reader
{
using namespace Amontons;
using namespace dealii;

std::string folder;

bool
is_first()
{
  return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

// Writes a file on rank 0.
std::string
write(const std::string &name, const std::string &text)
{
  if (is_first())
    std::ofstream(folder + "/" + name) << text;
  MPI_Barrier(MPI_COMM_WORLD);
  return folder + "/" + name;
}

// Runs gmsh on rank 0.
std::string
mesh_with_gmsh(const std::string &geo, const std::string &name, const std::string &options)
{
  if (is_first())
    check::is_true(std::system(("env -i PATH=\"$PATH\" HOME=/tmp gmsh " + geo + " " + options + " -v 1 -o " +
                                folder + "/" + name)
                                   .c_str()) == 0,
                   "gmsh runs");
  MPI_Barrier(MPI_COMM_WORLD);
  return folder + "/" + name;
}

std::string
read(const std::string &file)
{
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

BodyData
file_body(const std::string &file)
{
  BodyData body;
  body.name      = "it";
  body.shape     = "file";
  body.mesh_file = file;
  body.where     = {"scene.prm", 3, "Body it"};
  return body;
}

BodyData
part_of(const std::string &file, const std::string &part)
{
  BodyData body = file_body(file);
  body.part     = part;
  return body;
}

template <int dim>
void
check_mesh(const std::string                   &file,
           const double                         volume,
           const std::map<std::string, double> &boundaries,
           const std::string                   &part = "")
{
  const auto mesh = read_grid<dim>(part_of(file, part), MPI_COMM_WORLD);
  double     sum  = 0;
  for (const auto &cell : mesh.cells)
    sum += GridTools::cell_measure<dim>(mesh.vertices,
                                        make_array_view(cell.vertices.begin(), cell.vertices.end()));
  check::is_close(sum, volume, 1e-10, file + " volume");

  std::map<std::string, double> found;
  for (const auto &[key, name] : mesh.boundaries)
    if (dim == 2)
      found[mesh.names[name]] += mesh.vertices[key[0]].distance(mesh.vertices[key[1]]);
    else
      found[mesh.names[name]] += 1;
  check::is_true(found.size() == boundaries.size() && mesh.names.size() == boundaries.size(),
                 file + " number of boundaries");
  for (const auto &[name, size] : boundaries)
    check::is_close(found[name], size, 1e-10, file + " " + name);
}

template <int dim>
void
check_error(const std::string &file, const std::vector<std::string> &words, const std::string &part = "")
{
  try
    {
      read_grid<dim>(part_of(file, part), MPI_COMM_WORLD);
      check::is_true(false, file + ": no error");
    }
  catch (const InputError &e)
    {
      const std::string message = e.what();
      for (const auto &word : words)
        check::is_true(message.find(word) != std::string::npos || !is_first(),
                       "'" + word + "' in " + message);
      check::is_true(message.find('\n') == std::string::npos, "one line");
    }
}

const std::string square = R"(
Mesh.MeshSizeMax = 0.6;
Point(1) = {0, 0, 0}; Point(2) = {2, 0, 0}; Point(3) = {2, 1, 0}; Point(4) = {0, 1, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Physical Curve("left side") = {-4}; Physical Curve("rest") = {1, 3}; Physical Curve(7) = {2};
Physical Surface("body") = {1}; Physical Surface("again") = {1};
)";
const std::string recombine =
    "Recombine Surface{:}; Mesh.RecombinationAlgorithm = 1; Mesh.SubdivisionAlgorithm = 1;\n";

void
check_gmsh()
{
  const std::map<std::string, double> boundaries = {{"left side", 1}, {"rest", 4}, {"7", 1}};

  const std::string geo = write("quads.geo", square + recombine);
  check_mesh<2>(geo, 2, boundaries);
  check_mesh<2>(mesh_with_gmsh(geo, "q22.msh", "-2 -format msh22"), 2, boundaries);
  check_mesh<2>(mesh_with_gmsh(geo, "q41.msh", "-2 -format msh41"), 2, boundaries);
  check_mesh<2>(mesh_with_gmsh(geo, "bin22.msh", "-2 -format msh22 -bin"), 2, boundaries);
  check_mesh<2>(mesh_with_gmsh(geo, "bin41.msh", "-2 -format msh41 -bin"), 2, boundaries);
  check_mesh<2>(mesh_with_gmsh(geo, "quadratic.msh", "-2 -order 2"), 2, boundaries);

  const std::string triangles = write("triangles.geo", square);
  check_error<2>(triangles, {"triangles", "Mesh.SubdivisionAlgorithm = 1;", "Body it"});
  check_error<2>(mesh_with_gmsh(triangles, "t41.msh", "-2"),
                 {"t41.msh:", "triangles", "Recombine Surface{:};"});
  check_error<2>(write("bad.geo", "Point(1 = {0, 0, 0};\n"), {"scene.prm:3", "gmsh made no mesh"});

  const std::string box = "SetFactory(\"OpenCASCADE\"); Box(1) = {0, 0, 0, 1, 1, 1};\n"
                          "Mesh.MeshSizeMax = 3; Physical Volume(\"v\") = {1};\n";
  check_error<3>(write("tets.geo", box), {"tetrahedra", "Mesh.SubdivisionAlgorithm = 2"});
  check_error<2>(mesh_with_gmsh(folder + "/tets.geo", "tets.msh", "-3"), {"three-dimensional elements"});
  check_mesh<3>(write("hexes.geo",
                      box +
                          "Transfinite Curve{:} = 3; Transfinite Surface{:}; Recombine Surface{:};\n"
                          "Transfinite Volume{:}; Physical Surface(\"low\") = {5}; Mesh.ElementOrder = 2;\n"),
                1,
                {{"low", 4}});
}

void
check_damaged()
{
  const std::string good = read(folder + "/q22.msh"), good_4 = read(folder + "/q41.msh");
  check_error<2>(folder + "/none.msh", {"scene.prm:3", "cannot be opened"});
  check_error<2>(write("a.stl", ""), {".msh, .geo or .inp"});
  check_error<2>(write("empty.msh", ""), {"$MeshFormat"});
  check_error<2>(write("text.msh", "solid\n"), {"text.msh:1", "no gmsh mesh"});
  for (const double part : {0.2, 0.5, 0.9})
    for (const auto &text : {good, good_4})
      check_error<2>(write("cut.msh", text.substr(0, text.size() * part)), {"cut.msh:"});

  const auto changed = [&](const std::string &text, const std::string &from, const std::string &to) {
    std::string       result = text;
    const std::size_t at     = result.find(from);
    if (at != std::string::npos)
      result.replace(at, from.size(), to);
    return write("changed.msh", result);
  };
  check_error<2>(changed(good, "$Nodes\n", "$Nodes\n1"), {"changed.msh:"});
  check_error<2>(changed(good, "$Elements\n", "$Elements\n9"), {"$Elements"});
  check_error<2>(changed(good, "\n2 2 0 0\n", "\n2 2 nan 0\n"), {"changed.msh:", "a finite number"});
  check_error<2>(changed(good, "\n2 2 0 0\n", "\n900 2 0 0\n"), {"changed.msh:", "there is no node 2"});
  check_error<2>(changed(good, "\n2 2 0 0\n", "\n2 -2 0 0\n"), {"changed.msh:", "degenerate or folded"});
  check_error<2>(changed(good, "\n2 2 0 0\n", "\n2 2 0 1\n"), {"different z"});
  check_error<2>(changed(good, "2.2 0 8", "3.0 0 8"), {"changed.msh:2", "versions 2.2 and 4.1"});
}

const std::string abaqus = R"(*Heading
** two squares side by side
*Part, name=P
*Node
 1, 0., 0.
 2, 1., 0.
 3, 2., 0.
 4, 0., 1.
 5, 1., 1.
 6, 2.0e0, +1., 0.
 99, 7., 7.
*ELEMENT, type=CPE4R, Elset=All
 1, 1, 2, 5, 4
 2, 3, 2, 5,
    6
*Nset, nset=Bottom, generate
 1, 3, 1
*nset, nset="right end"
 3, 6
*Elset, elset=second
 2,
*Surface, name=Top, type=ELEMENT
 1, S3
 SECOND, s3
*End Part
*Assembly
*Instance, name=P-1, part=P
*End Instance
*End Assembly
*Material, name=M
*Elastic
 1., 0.3
)";

void
check_abaqus()
{
  check_mesh<2>(write("two.inp", abaqus), 2, {{"Top", 2}, {"Bottom", 2}, {"right end", 1}});
  const std::string quadratic = "*NODE\n1,0,0\n2,1,0\n3,1,1\n4,0,1\n5,0.5,0\n6,1,0.5\n7,0.5,1\n8,0,0.5\n"
                                "*ELEMENT, TYPE=T3D3, ELSET=low\n1, 1, 5, 2\n"
                                "*ELEMENT, TYPE=CPS8, ELSET=all\n2, 1, 2, 3, 4, 5, 6, 7, 8\n";
  check_mesh<2>(write("lines.inp", quadratic), 1, {{"low", 1}});
  check_error<2>(write("id.inp", "*NODE\n1, 0, 0\n*ELEMENT, TYPE=CPS4\n1, 1, 2, 3, 4\n"),
                 {"id.inp:4", "no node 2"});
  check_error<2>(
      write("tri.inp",
            "*NODE\n1,0,0\n2,1,0\n3,0,1\n*ELEMENT, TYPE=CPS3\n1, 1, 2, 3\n*SURFACE, NAME=s\n1, S1\n"),
      {"tri.inp:6", "triangles"});
  check_error<2>(write("type.inp", "*NODE\n1,0,0\n*ELEMENT, TYPE=COH2D4\n1, 1, 1, 1, 1\n"),
                 {"type.inp:", "COH2D4"});
  check_error<2>(write("set.inp", abaqus + "*SURFACE, NAME=x\n secnod, S1\n"), {"did you mean"});
  std::string folded = abaqus;
  for (const std::string node : {" 3, 2., 0.", " 6, 2.0e0, +1."})
    folded.replace(folded.find(node) + 4, 2, "0.");
  check_error<2>(write("folded.inp", folded), {"folded.inp:14", "that of line 13: they overlap near (1 "});
  check_error<2>(write("cut.inp", abaqus.substr(0, abaqus.find("    6\n"))), {"an element with 3 nodes"});

  std::string cube = "*NODE\n";
  for (int i = 0; i < 8; ++i)
    cube += std::to_string(i + 1) + ", " + std::to_string(i / 2 % 2 != i % 2) + ", " +
            std::to_string(i / 2 % 2) + ", " + std::to_string(i / 4) + "\n";
  cube += "*ELEMENT, TYPE=C3D8, ELSET=E\n 5, 1, 2, 3, 4, 5, 6, 7, 8\n*SURFACE, NAME=low\nE, S1\n*SURFACE, "
          "NAME=sides\n"
          "E, S3\nE, S4\nE, S5\nE, S6\n*NSET, NSET=high\n5,6,7,8\n";
  check_mesh<3>(write("cube.inp", cube), 1, {{"low", 1}, {"high", 1}, {"sides", 4}});

  check_mesh<2>(mesh_with_gmsh(folder + "/quads.geo", "quads.inp", "-2"),
                2,
                {{"left_side", 1}, {"rest", 4}, {"PhysicalLine7", 1}});
}

// Bodies of one file: a strip of two squares, of which the left one has a name more, and a triangle above.
void
check_parts_of_gmsh()
{
  const std::string geo =
      write("parts.geo",
            "SetFactory(\"OpenCASCADE\");\n"
            "Rectangle(1) = {0, 0, 0, 1, 1}; Rectangle(2) = {1, 0, 0, 1, 1}; Coherence;\n"
            "Rectangle(3) = {0, 2, 0, 1, 1};\n"
            "Transfinite Curve{:} = 3; Transfinite Surface{1, 2}; Recombine Surface{1, 2};\n"
            "joint() = Curve In BoundingBox{0.9, -0.1, -0.1, 1.1, 1.1, 0.1};\n"
            "low() = Curve In BoundingBox{-0.1, -0.1, -0.1, 2.1, 0.1, 0.1};\n"
            "Physical Curve(\"joint\") = {joint()}; Physical Curve(\"low\") = {low()};\n"
            "Physical Surface(\"left one\") = {1}; Physical Surface(\"strip\") = {1, 2};\n"
            "Physical Surface(9) = {2}; Physical Surface(\"lid\") = {3};\n");
  for (const std::string options : {"-2 -format msh22", "-2 -format msh41", "-2 -format msh41 -bin"})
    {
      const std::string file = mesh_with_gmsh(geo, "parts.msh", options);
      check_mesh<2>(file, 1, {{"joint", 1}, {"low", 1}}, "left one");
      check_mesh<2>(file, 1, {{"joint", 1}, {"low", 1}}, "9");
      check_mesh<2>(file, 2, {{"low", 2}}, "strip");
      check_error<2>(file, {"triangles"}, "lid");
      check_error<2>(file, {"triangles"});
      check_error<2>(file,
                     {"scene.prm:3", "no part 'srtip' (did you mean 'strip'?)", "9, left one, lid, strip"},
                     "srtip");
    }
  check_error<2>(write("no_groups.msh",
                       "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n"
                       "3 1 1 0\n4 0 1 0\n$EndNodes\n$Elements\n1\n1 3 2 0 1 1 2 3 4\n"
                       "$EndElements\n"),
                 {"no part 'a'", "no cells of the file are in a physical group"},
                 "a");
}

// Element sets; and parts that number nodes and elements each for itself.
void
check_parts_of_abaqus()
{
  const std::string flat =
      write("flat.inp", abaqus + "*ELSET, ELSET=first\n1\n*NSET, NSET=of_first\n1,2,4,5\n");
  check_mesh<2>(flat, 1, {{"Top", 1}, {"Bottom", 1}}, "FIRST");
  check_mesh<2>(flat, 1, {{"Top", 1}, {"Bottom", 1}, {"right end", 1}, {"of_first", 1}}, "second");
  check_mesh<2>(flat, 2, {{"Top", 2}, {"Bottom", 2}, {"right end", 1}, {"of_first", 1}}, "p");
  check_error<2>(flat, {"no part 'secnd' (did you mean 'second'?)", "All, first, second"}, "secnd");
  const std::string triangle = "*ELEMENT, TYPE=CPE3, ELSET=other\n3, 1, 2, 4\n";
  std::string       mixed    = abaqus;
  mixed.replace(mixed.find("*Nset"), 0, triangle);
  check_mesh<2>(write("mixed.inp", mixed), 1, {{"Top", 1}, {"Bottom", 1}, {"right end", 1}}, "second");
  check_error<2>(folder + "/mixed.inp", {"mixed.inp:", "1 triangles"}, "other");

  const std::string parts =
      write("assembly.inp",
            "*PART, NAME=Shaft\n*NODE\n1,0,0\n2,2,0\n3,2,1\n4,0,1\n*ELEMENT, TYPE=CPS4\n"
            "1,1,2,3,4\n*END PART\n"
            "*PART, NAME=Hub\n*NODE\n1,0,1\n2,3,1\n3,3,2\n4,0,2\n*ELEMENT, TYPE=CPS4\n"
            "1,1,2,3,4\n*END PART\n"
            "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=Shaft-1, PART=Shaft\n*END INSTANCE\n"
            "*INSTANCE, NAME=Hub-1, PART=Hub\n0, 1, 0\n*END INSTANCE\n"
            "*NSET, NSET=ends, INSTANCE=Shaft-1\n2,3\n"
            "*ELSET, ELSET=_s, INSTANCE=Shaft-1\n1\n*SURFACE, NAME=below\n_s, S1\n"
            "*NSET, NSET=left, INSTANCE=Hub-1\n1,4\n*SURFACE, NAME=above\nHub-1.1, S3\n"
            "*NSET, NSET=right\nHub-1.2, Hub-1.3\n*END ASSEMBLY\n");
  check_mesh<2>(parts, 2, {{"below", 2}, {"ends", 1}}, "shaft");
  check_mesh<2>(parts, 3, {{"above", 3}, {"left", 1}, {"right", 1}}, "Hub");
  check_mesh<2>(parts, 3, {{"above", 3}, {"left", 1}, {"right", 1}}, "hub-1");
  const auto corner_of = [](const BodyData &body) {
    const auto mesh = read_grid<2>(body, MPI_COMM_WORLD);
    Point<2>   corner(0, 1e9);
    for (const auto &p : mesh.vertices)
      corner = p[1] < corner[1] - 1e-9 || (p[1] < corner[1] + 1e-9 && p[0] < corner[0]) ? p : corner;
    return corner;
  };
  check::is_true(corner_of(part_of(parts, "Hub")).distance({0, 2}) < 1e-12, "an instance that is shifted");
  check_error<2>(parts, {"the mesh file has 2 parts", "'Part', one of them: Hub, Shaft"});
  check_error<2>(parts, {"no part 'shft' (did you mean 'Shaft'?)"}, "shft");
  std::string twice = read(parts); // (3, 3) goes to (0, 6), and is the lowest on the left
  twice.insert(twice.find("*NSET, NSET=ends"),
               "*INSTANCE, NAME=Hub-2, PART=Hub\n0, 2\n3, 3, 0, 3, 3, 1, -90\n*END INSTANCE\n");
  const std::string file = write("twice.inp", twice);
  check::is_true(corner_of(part_of(file, "HUB-2")).distance({3, 3}) < 1e-12, "an instance that is turned");
  check_mesh<2>(file, 3, {}, "HUB-2");
  check_mesh<2>(file, 3, {{"above", 3}, {"left", 1}, {"right", 1}}, "HUB-1");
  check_error<2>(file, {"no part 'Hub' (did you mean 'Hub-1'?)", "Hub-1, Hub-2, Shaft"}, "Hub");
  // Meshes of instances, where parts have none.
  std::string       own   = read(parts);
  const std::size_t begin = own.find("*NODE", own.find("NAME=Hub")), end = own.find("*END PART", begin);
  const std::string hub = own.substr(begin, end - begin);
  own.erase(begin, end - begin);
  own.insert(own.find("*END INSTANCE", own.find("NAME=Hub-1")), hub);
  check_mesh<2>(write("own.inp", own), 3, {{"above", 3}, {"left", 1}, {"right", 1}}, "Hub");
  check::is_true(corner_of(part_of(folder + "/own.inp", "Hub-1")).distance({0, 2}) < 1e-12, "its own mesh");
  check_mesh<2>(folder + "/own.inp", 2, {{"below", 2}, {"ends", 1}}, "Shaft");
  own.erase(own.rfind("*END INSTANCE"), 14);
  check_error<2>(write("no_end.inp", own), {"the file ends within an instance"}, "Hub");
  twice.replace(twice.find("3, 3, 1, -90"), 12, "3, 3, 0, -90");
  check_error<2>(write("no_axis.inp", twice), {"no_axis.inp:", "an axis without a direction"}, "Hub-2");
}

// A quarter of a tube in unstructured hexahedra: the same from all formats, and fit for deal.II.
void
check_hexahedra()
{
  const std::string body =
      "SetFactory(\"OpenCASCADE\"); Cylinder(1) = {0, 0, 0, 0, 0, 1, 1, Pi/2};\n"
      "Cylinder(2) = {0, 0, 0, 0, 0, 1, 0.5, Pi/2};\n"
      "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n"
      "Mesh.MeshSizeMax = 0.4; Mesh.SubdivisionAlgorithm = 2;\n"
      "low() = Surface In BoundingBox{-1, -1, -0.1, 2, 2, 0.1};\n"
      "out() = Surface In BoundingBox{-0.1, -0.1, -0.1, 1.1, 1.1, 1.1}; out() -= {low()};\n"
      "Physical Surface(\"low end\") = {low()}; Physical Surface(\"others\") = {out()};\n"
      "Physical Volume(\"tube\") = {3};\n";
  const std::string geo = write("tube.geo", body);
  const auto        reference =
      read_grid<3>(file_body(mesh_with_gmsh(geo, "h41.msh", "-3 -format msh41")), MPI_COMM_WORLD);
  check::is_true(reference.cells.size() > 50 && reference.names.size() == 2, "hexahedra of a tube");
  for (const std::string &file : {mesh_with_gmsh(geo, "h22.msh", "-3 -format msh22"),
                                  mesh_with_gmsh(geo, "h41b.msh", "-3 -format msh41 -bin"),
                                  mesh_with_gmsh(geo, "h.inp", "-3")})
    {
      const auto mesh = read_grid<3>(file_body(file), MPI_COMM_WORLD);
      check::is_true(mesh.cells.size() == reference.cells.size() && mesh.names.size() == 2 &&
                         mesh.boundaries.size() == reference.boundaries.size(),
                     file + ": cells and boundaries");
      Triangulation<3> triangulation;
      triangulation.create_triangulation(mesh.vertices, mesh.cells, SubCellData());
      triangulation.refine_global(1);
      check::is_close(GridTools::volume(triangulation), 0.75 * numbers::PI / 4, 0.02, file + ": volume");
    }
}

// Two cubes side by side; the second is numbered in all 24 ways of a cube, and inside out.
void
check_cube_orientations()
{
  const std::vector<std::array<double, 3>> corners = {
      {{0, 0, 0}}, {{1, 0, 0}}, {{1, 1, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 0, 1}}, {{1, 1, 1}}, {{0, 1, 1}}};
  std::array<unsigned int, 3> axes{{0, 1, 2}};
  do
    for (unsigned int flips = 0; flips < 8; ++flips)
      {
        std::ostringstream text;
        text << "*NODE\n";
        for (unsigned int i = 0; i < 12; ++i)
          text << i + 1 << ", " << i % 3 << ", " << i / 3 % 2 << ", " << i / 6 << "\n";
        text << "*ELEMENT, TYPE=C3D8, ELSET=E\n1, 1, 2, 5, 4, 7, 8, 11, 10\n2";
        for (const auto &corner : corners)
          {
            std::array<unsigned int, 3> p{};
            for (unsigned int d = 0; d < 3; ++d)
              p[axes[d]] = (flips >> d) & 1 ? 1 - corner[d] : corner[d];
            text << ", " << 2 + p[0] + 3 * p[1] + 6 * p[2];
          }
        text << "\n*NSET, NSET=end\n3, 6, 9, 12\n";
        check_mesh<3>(write("cubes.inp", text.str()), 2, {{"end", 1}});
        const auto       mesh = read_grid<3>(file_body(folder + "/cubes.inp"), MPI_COMM_WORLD);
        Triangulation<3> triangulation;
        triangulation.create_triangulation(mesh.vertices, mesh.cells, SubCellData());
        triangulation.refine_global(1);
        check::is_close(GridTools::volume(triangulation), 2, 1e-12, "two cubes, refined");
        std::string folded = text.str();
        for (unsigned int i = 2; i < 12; i += 3) // x = 0.4, within the first cube
          folded.replace(folded.find("\n" + std::to_string(i + 1) + ", 2, "),
                         ("\n" + std::to_string(i + 1) + ", 2, ").size(),
                         "\n" + std::to_string(i + 1) + ", 0.4, ");
        check_error<3>(write("folded.inp", folded), {"that of line 15: they overlap near (1 "});
        MPI_Barrier(MPI_COMM_WORLD);
      }
  while (std::next_permutation(axes.begin(), axes.end()));
}

// A disk from gmsh with a declared circle: the vertices of refinement lie on it.
void
check_curved_file()
{
  const std::string disk = "Mesh.MeshSizeMax = 1; SetFactory(\"OpenCASCADE\"); Disk(1) = {0, 0, 0, 1};\n"
                           "Physical Curve(\"rim\") = {1}; Physical Surface(\"s\") = {1};\n" +
                           recombine;
  Scene    scene;
  BodyData body             = file_body(write("disk.geo", disk));
  body.true_geometry["rim"] = {TrueGeometry::Type::circle, Point<3>(), {}};
  body.shift                = Tensor<1, 3>({3, 0, 0});
  body.refinements          = 2;
  scene.bodies              = {body};
  Geometry<2> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  const auto &rim = geometry.boundary({"it", "rim", {}}, scene);
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    for (const auto &face : cell->face_iterators())
      if (!cell->is_artificial() && face->at_boundary())
        {
          check::is_true(face->boundary_id() == rim.id, "all of the boundary is the rim");
          check::is_close(face->vertex(0).distance({3, 0}), 1, 1e-9, "vertex on the circle");
        }
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::string name = (std::filesystem::temp_directory_path() / "amontons-test-XXXXXX").string();
  if (is_first() && mkdtemp(name.data()) == nullptr)
    return 1;
  folder = Utilities::MPI::broadcast(MPI_COMM_WORLD, name, 0);
  check_gmsh();
  check_damaged();
  check_abaqus();
  check_parts_of_gmsh();
  check_parts_of_abaqus();
  check_hexahedra();
  check_cube_orientations();
  check_curved_file();
  MPI_Barrier(MPI_COMM_WORLD);
  if (is_first())
    std::filesystem::remove_all(folder);
  return check::result();
}
} // namespace test_grid_reader
