// Boundaries from CAD files: new vertices and the points of mappings lie on the true surface and its edges,
// wherever the body stands; what does not fit is said.
#include "check.h"

#include <amontons/geometry/geometry.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/fe/fe_nothing.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/opencascade/utilities.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace test_cad_manifold
{
using namespace Amontons;
using namespace dealii;

std::string folder;

std::string
scene_file(const std::string &name)
{
  return std::string(std::getenv("AMONTONS_SOURCE_DIR")) + "/parameters/" + name;
}

bool
is_first()
{
  return Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0;
}

std::string
read(const std::string &file)
{
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string
write(const std::string &name, const std::string &text)
{
  if (is_first())
    std::ofstream(folder + "/" + name) << text;
  MPI_Barrier(MPI_COMM_WORLD);
  return folder + "/" + name;
}

TrueGeometry
cad(const std::string &file, const double scale = 1)
{
  return {TrueGeometry::Type::cad, {}, {}, file, scale};
}

// The block of step_file.geo, somewhere else.
BodyData
dome(const TrueGeometry &geometry)
{
  BodyData body;
  body.name                 = "dome";
  body.where                = {"scene.prm", 5, "Body dome"};
  body.shape                = "file";
  body.mesh_file            = scene_file("step_file.msh");
  body.true_geometry["top"] = geometry;
  body.refinements          = 2;
  body.rotation_angle       = 90;
  body.rotation_axis        = Tensor<1, 3>({1, 0, 0}); // y -> z, z -> -y
  body.rotation_centre      = {1, 2, 3};
  body.shift                = Tensor<1, 3>({10, 20, -30});
  return body;
}

Point<3>
before_placement(const Point<3> &p)
{
  const Tensor<1, 3> d = p - Point<3>(1, 2, 3) - Tensor<1, 3>({10, 20, -30});
  return {1 + d[0], 2 + d[2], 3 - d[1]};
}

double
off_ellipsoid(const Point<3> &p)
{
  return 4 - std::sqrt(p[0] * p[0] / 9 + p[1] * p[1] / 4 + (p[2] + 4) * (p[2] + 4));
}

double
exact_volume()
{
  const QGauss<2> quadrature(20);
  double          sum = 0;
  for (unsigned int q = 0; q < quadrature.size(); ++q)
    {
      const Point<2> p = 4 * quadrature.point(q);
      sum += 16 * quadrature.weight(q) * 4 * std::sqrt(1 - p[0] * p[0] / 144 - p[1] * p[1] / 64);
    }
  return sum;
}

void
check_dome(const BodyData &body, const std::string &what, const double tolerance = 1e-11)
{
  Scene scene;
  scene.kind   = ProblemType::three_dimensional;
  scene.bodies = {body};
  Geometry<3> geometry(MPI_COMM_WORLD);
  make_geometry(scene, geometry);
  const auto &top   = geometry.boundary({"dome", "top", {}}, scene);
  const auto &sides = geometry.boundary({"dome", "sides", {}}, scene);

  const MappingQ<3>      mapping(4);
  const FE_Nothing<3>    fe;
  const QGaussLobatto<2> points(5); // where the mapping is exact
  FEValues<3>            cell_values(mapping, fe, QGauss<3>(5), update_JxW_values);
  FEFaceValues<3>        face_values(mapping, fe, points, update_quadrature_points);
  double                 volume = 0, worst_top = 0, worst_side = 0;
  unsigned int           n_faces = 0;
  for (const auto &cell : geometry.triangulation.active_cell_iterators())
    if (cell->is_locally_owned())
      {
        cell_values.reinit(cell);
        for (const double JxW : cell_values.get_JxW_values())
          volume += JxW;
        for (const unsigned int f : cell->face_indices())
          {
            face_values.reinit(cell, f);
            for (const auto &placed : face_values.get_quadrature_points())
              {
                const Point<3> p = before_placement(placed);
                if (cell->face(f)->boundary_id() == top.id)
                  worst_top = std::max(worst_top, std::abs(off_ellipsoid(p)));
                if (cell->face(f)->boundary_id() == sides.id)
                  worst_side = std::max(worst_side, std::min(std::abs(p[0] - 4), std::abs(p[1] - 4)));
              }
            n_faces += cell->face(f)->boundary_id() == top.id;
          }
      }
  check::is_close(Utilities::MPI::sum(volume, MPI_COMM_WORLD), exact_volume(), 1e-8, what + ": volume");
  check::is_close(worst_top, 0, tolerance, what + ": points of the mapping on the ellipsoid", 1);
  check::is_close(worst_side, 0, tolerance, what + ": the edge of the ellipsoid stays in the plane sides", 1);
  check::is_true(Utilities::MPI::sum(n_faces, MPI_COMM_WORLD) == 64, what + ": faces of the top");
}

void
check_error(const BodyData &body, const std::vector<std::string> &words)
{
  Scene scene;
  scene.kind   = ProblemType::three_dimensional;
  scene.bodies = {body};
  try
    {
      Geometry<3> geometry(MPI_COMM_WORLD);
      make_geometry(scene, geometry);
      check::is_true(false, "no error: " + words[0]);
    }
  catch (const InputError &e)
    {
      const std::string message = e.what();
      for (const auto &word : words)
        check::is_true(message.find(word) != std::string::npos, "'" + word + "' in " + message);
      check::is_true(message.find('\n') == std::string::npos, "one line");
    }
}

// The mesh file with coordinates of 6 digits, as other programs write them.
std::string
rounded_mesh()
{
  std::istringstream in(read(scene_file("step_file.msh")));
  std::ostringstream out;
  for (std::string line; std::getline(in, line); out << "\n")
    {
      double x, y, z;
      if (std::sscanf(line.c_str(), "%lf %lf %lf", &x, &y, &z) == 3 && line.find('.') != std::string::npos &&
          std::count(line.begin(), line.end(), ' ') == 2)
        out << x << " " << y << " " << z;
      else
        out << line;
    }
  return write("rounded.msh", out.str());
}

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  std::string name = (std::filesystem::temp_directory_path() / "amontons-test-XXXXXX").string();
  if (is_first() && mkdtemp(name.data()) == nullptr)
    return 1;
  folder = Utilities::MPI::broadcast(MPI_COMM_WORLD, name, 0);

  const std::string step = scene_file("step_file.step");
  check_dome(dome(cad(step)), "STEP");
  if (is_first())
    OpenCASCADE::write_IGES(OpenCASCADE::read_STEP(step, 1), folder + "/dome.igs");
  MPI_Barrier(MPI_COMM_WORLD);
  check_dome(dome(cad(folder + "/dome.igs")), "IGES", 1e-8);
  BodyData rounded  = dome(cad(step));
  rounded.mesh_file = rounded_mesh();
  check_dome(rounded, "mesh of few digits");

  check_error(dome(cad(step, 1.1)), {"scene.prm:5", "'top'", "no single face", "1e-3"});
  check_error(dome(cad(step, 100)), {"scene.prm:5", "no single face"});
  check_error(dome(cad(write("text.step", "hello\n"))),
              {"scene.prm:5", "cannot read", "STEP or IGES format"});
  check_error(dome(cad(write("empty.igs", ""))), {"scene.prm:5", "cannot read", "IGES format"});

  MPI_Barrier(MPI_COMM_WORLD);
  if (is_first())
    std::filesystem::remove_all(folder);
  return check::result();
}
} // namespace test_cad_manifold
