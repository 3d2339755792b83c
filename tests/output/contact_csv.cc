// contact.csv and contact_*.vtu have the agreed columns and arrays, and what stands in them is what the
// fields of the slave surface say about each node; rows are in the order of a walk along the surface.
#include "contact/contact_scene.h"

#include <amontons/base/points.h>
#include <amontons/contact/surface_order.h>
#include <amontons/output/contact_csv.h>
#include <amontons/output/vtu_output.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace test_contact_csv
{
using namespace Amontons;

void
check_order()
{
  using Faces = std::vector<std::vector<unsigned int>>;
  // A quadratic curve that turns back over itself, so that x alone would mix its nodes; faces in any order
  // and direction.
  const std::vector<Point<2>> hook  = {{0, 0}, {1, 0}, {2, 0}, {2, 0.5}, {2, 1}, {1.5, 1}, {1, 1}};
  const Faces                 faces = {{4, 3, 2}, {4, 5, 6}, {0, 1, 2}};
  check::is_true(order_along_surface<2>(hook, faces) == std::vector<unsigned int>{0, 1, 2, 3, 4, 5, 6},
                 "open curve");

  const std::vector<Point<2>> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  check::is_true(order_along_surface<2>(square, {{0, 1}, {2, 1}, {2, 3}, {3, 0}}) ==
                     std::vector<unsigned int>{0, 1, 2, 3},
                 "closed curve");

  const std::vector<Point<2>> two = {{5, 0}, {0, 0}, {4, 0}, {1, 0}};
  check::is_true(order_along_surface<2>(two, {{0, 2}, {1, 3}}) == std::vector<unsigned int>{1, 3, 2, 0},
                 "two pieces");

  const std::vector<Point<3>> points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  check::is_true(order_along_surface<3>(points, {}) == std::vector<unsigned int>{2, 1, 0}, "3D: sorted");
}

void
check_file()
{
  ContactNode node;
  node.pair     = "a, b";
  node.X        = Point<3>(1, 2, 0);
  node.x        = Point<3>(1.5, 2, 0);
  node.normal   = Point<3>(0, -1, 0);
  node.area     = 0.25;
  node.pressure = 3;
  node.gap      = std::nan("");
  node.state    = ContactStatus::slip;
  node.force    = Point<3>(7, 8, 9);

  const std::string file = std::string(std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp") +
                           "/amontons_test_contact.csv";
  write_contact_csv(file, {node});
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::remove(file.c_str());
  check::is_true(text.str() ==
                     "pair,X,Y,Z,x,y,z,nx,ny,nz,area,pressure,tx,ty,tz,gap,slip_x,slip_y,slip_z,state,fx,"
                     "fy,fz\n"
                     "\"a, b\",1,2,0,1.5,2,0,0,-1,0,0.25,3,0,0,0,nan,0,0,0,slip,7,8,9\n",
                 "the file: " + text.str());
}

// Distinct numbers in all fields of slave node i of pair p. Nothing is opposite of node 2; friction allows
// node 0 of the second pair half of its traction.
template <int dim>
SurfaceFields<dim>
numbered_fields(const ContactSurface<dim> &surface, const unsigned int p)
{
  SurfaceFields<dim> fields;
  const auto         vector = [&](const double first) {
    Tensor<1, dim> v;
    for (unsigned int d = 0; d < dim; ++d)
      v[d] = first + 0.125 * (d + 1);
    return v;
  };
  for (unsigned int i = 0; i < surface.nodes.size(); ++i)
    {
      const double n = 100 * p + i + 1;
      fields.pressure.push_back(1000 + n);
      fields.multiplier.push_back(2000 + n);
      fields.gap.push_back(i == 1 ? std::nan("") : 3000 + n);
      fields.area.push_back(4000 + n);
      fields.normal.push_back(vector(5000 + n));
      fields.traction.push_back(vector(6000 + n));
      fields.slip.push_back(vector(7000 + n));
      fields.displacement.push_back(vector(8000 + n));
      fields.force.push_back(vector(9000 + n));
      fields.is_covered.push_back(i != 2);
      if (p == 1)
        fields.bound.push_back((i == 0 ? 0.5 : 2) * fields.traction[i].norm());
      fields.state.push_back(static_cast<ContactStatus>(i % 3));
    }
  return fields;
}

// The numbers of an ASCII array of a .vtu file.
std::vector<double>
vtu_array(const std::string &text, const std::string &name)
{
  const auto at = text.find("Name=\"" + name + "\""), from = text.find('>', at) + 1;
  check::is_true(at != std::string::npos, "array " + name);
  std::istringstream  words(text.substr(from, text.find('<', from) - from));
  std::vector<double> numbers;
  for (double x; words >> x;)
    numbers.push_back(x);
  return numbers;
}

template <int dim>
void
check_rows(const unsigned int degree)
{
  const std::array<unsigned int, 3> cells = {{2, 2, 2}};
  Scene                             scene;
  scene.bodies            = {block("lower", {0, 0, 0}, {1, 1, 1}, cells),
                             block("upper",
                        dim == 2 ? Point<3>(0, 1, 0) : Point<3>(0, 0, 1),
                        dim == 2 ? Point<3>(1, 2, 0) : Point<3>(1, 1, 2),
                        cells)};
  scene.pairs             = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}}),
                             pair_of({"lower", "top", {}}, {"upper", "bottom", {}})};
  scene.pairs[0].name     = "up";
  scene.pairs[1].name     = "down";
  scene.pairs[1].friction = Expression("0.5*t", SourceLocation(), {"x", "y", "z", "t", "p"});
  const Problem<dim>              problem(scene, degree);
  std::vector<SurfaceFields<dim>> fields;
  for (unsigned int p = 0; p < 2; ++p)
    fields.push_back(numbered_fields(*problem.interfaces[p].slave, p));
  const auto        table = contact_table(problem.interfaces, fields, 3);
  const std::string vtu   = contact_vtu(problem.interfaces, fields);
  const std::size_t n     = problem.interfaces[0].slave->nodes.size();
  const std::string what  = std::to_string(dim) + "D: ";
  check::is_close(table.size(), 2 * n, 0, what + "rows");

  const auto points = vtu_array(vtu, "Points"), pressure = vtu_array(vtu, "pressure"),
             traction = vtu_array(vtu, "traction"), slip = vtu_array(vtu, "slip"),
             normal = vtu_array(vtu, "normal"), displacement = vtu_array(vtu, "displacement"),
             state = vtu_array(vtu, "state"), pair = vtu_array(vtu, "pair");
  for (unsigned int p = 0, first = 0; p < 2; first += n, ++p)
    for (unsigned int i = 0; i < n; ++i)
      {
        const auto &node = problem.interfaces[p].slave->nodes[i];
        const auto  row =
            std::find_if(table.begin() + first, table.begin() + first + n, [&](const ContactNode &r) {
              return r.X.distance(as_3d(node.X)) < 1e-12;
            });
        check::is_true(row != table.begin() + first + n, what + "each node has a row");
        if (row == table.begin() + first + n)
          continue;
        const auto same =
            [&](const Tensor<1, 3> &found, const Tensor<1, dim> &wanted, const std::string &name) {
              for (unsigned int d = 0; d < 3; ++d)
                check::is_close(found[d], d < dim ? wanted[d < dim ? d : 0] : 0, 1e-14, what + name, 1);
            };
        check::is_true(row->pair == scene.pairs[p].name, what + "pair");
        same(row->x - Point<3>(), Tensor<1, dim>(node.X) + fields[p].displacement[i], "current position");
        same(row->normal, fields[p].normal[i], "normal");
        const double         shown_pressure = i == 2 ? 0 : fields[p].pressure[i];
        const Tensor<1, dim> shown_traction = (i == 2             ? 0.
                                               : i == 0 && p == 1 ? 0.5
                                                                  : 1.) *
                                              fields[p].traction[i];
        const double scale = fields[p].traction[i].norm();
        same(row->traction / scale, shown_traction / scale, "traction");
        same(row->force, fields[p].force[i], "force");
        same(row->slip, fields[p].slip[i], "slip");
        check::is_close(row->area, fields[p].area[i], 0, what + "area");
        check::is_close(row->pressure, shown_pressure, 0, what + "pressure");
        check::is_true(i == 1 ? std::isnan(row->gap) : row->gap == fields[p].gap[i], what + "gap");
        check::is_true(row->state == fields[p].state[i], what + "state");
        if (p == 0)
          check::is_true(std::isnan(row->bound), what + "no bound without friction");
        else
          check::is_close(row->bound, 1.5 * fields[p].pressure[i], 1e-12, what + "bound at t = 3");

        const auto part = [&](const std::vector<double> &array) {
          return Tensor<1, 3>(
              {array.at(3 * (first + i)), array.at(3 * (first + i) + 1), array.at(3 * (first + i) + 2)});
        };
        same(part(points), Tensor<1, dim>(node.X), "vtu: points");
        same(part(traction) / scale, shown_traction / scale, "vtu: traction");
        same(part(slip), fields[p].slip[i], "vtu: slip");
        same(part(normal), fields[p].normal[i], "vtu: normal");
        same(part(displacement), fields[p].displacement[i], "vtu: displacement");
        check::is_close(pressure.at(first + i), shown_pressure, 0, what + "vtu: pressure");
        check::is_close(state.at(first + i), i % 3, 0, what + "vtu: state");
        check::is_close(pair.at(first + i), p, 0, what + "vtu: pair");
      }

  // Pieces: as many as the degree allows, without gaps; their area is that of the surfaces.
  const auto corners = vtu_array(vtu, "connectivity"), ends = vtu_array(vtu, "offsets"),
             types            = vtu_array(vtu, "types");
  const unsigned int n_pieces = 2 * std::pow(2 * degree, dim - 1), size = dim == 2 ? 2 : 4;
  check::is_close(ends.size(), n_pieces, 0, what + "vtu: pieces");
  check::is_close(corners.size(), size * n_pieces, 0, what + "vtu: corners");
  double area = 0;
  for (unsigned int c = 0; c < n_pieces; ++c)
    {
      check::is_close(ends.at(c), size * (c + 1), 0, what + "vtu: offsets");
      check::is_close(types.at(c), dim == 2 ? 3 : 9, 0, what + "vtu: type");
      std::vector<Point<3>> x;
      for (unsigned int k = 0; k < size; ++k)
        {
          const unsigned int i = corners.at(size * c + k);
          x.emplace_back(points.at(3 * i), points.at(3 * i + 1), points.at(3 * i + 2));
        }
      area += dim == 2 ? x[0].distance(x[1]) : 0.5 * cross_product_3d(x[2] - x[0], x[3] - x[1]).norm();
    }
  check::is_close(area, 2, 1e-12, what + "vtu: area");
}

// Arc lengths begin at the end with the smallest x, in the reference configuration.
void
check_arc()
{
  Scene scene;
  scene.bodies = {block("lower", {0, 0, 0}, {3, 1, 1}, {{3, 1, 1}}),
                  block("upper", {0, 1, 0}, {3, 2, 1}, {{2, 1, 1}})};
  scene.pairs  = {pair_of({"upper", "bottom", {}}, {"lower", "top", {}})};
  const Problem<2> problem(scene, 1);
  const auto       table = contact_table(problem.interfaces, {numbered_fields(problem.slave(), 0)}, 0);
  check::is_true(table.size() == 3 && table[0].arc == 0 && table[1].arc == 1.5 && table[2].arc == 3,
                 "arc length");
}

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check_rows<2>(1);
  check_rows<2>(2);
  check_rows<3>(1);
  check_rows<3>(2);
  check_arc();
  check_order();
  check_file();
  bool refused = false;
  try
    {
      write_contact_csv("/nonexistent/folder/contact.csv", {});
    }
  catch (const InputError &)
    {
      refused = true;
    }
  check::is_true(refused, "a file that cannot be written is the user's to know");
  return check::result();
}
} // namespace test_contact_csv
