// contact.csv has the agreed columns and one row per slave node, in the order of a walk along the surface.
#include "check.h"

#include <amontons/output/contact_csv.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

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
  node.state    = ContactState::slip;

  const std::string file = std::string(std::getenv("TMPDIR") != nullptr ? std::getenv("TMPDIR") : "/tmp") +
                           "/amontons_test_contact.csv";
  write_contact_csv(file, {node});
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  std::remove(file.c_str());
  check::is_true(text.str() ==
                     "pair,X,Y,Z,x,y,z,nx,ny,nz,area,pressure,tx,ty,tz,gap,slip_x,slip_y,slip_z,state\n"
                     "\"a, b\",1,2,0,1.5,2,0,0,-1,0,0.25,3,0,0,0,nan,0,0,0,slip\n",
                 "the file: " + text.str());
}

int
main()
{
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
