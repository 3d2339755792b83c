// Loads that friction cannot hold are told from those that it can, up to the closed limits of rigid blocks.
#include "check.h"

#include <amontons/friction/limit_load.h>

#include <cmath>

namespace test_limit_load
{
using namespace Amontons;

// Motions of a body on the plane z = 0, about the origin: (u, w, rotation) in 2D; (u, v, w, three rotations)
// in 3D.
std::vector<RigidContact>
on_a_line(const std::vector<double> &x, const double mu)
{
  std::vector<RigidContact> contacts;
  for (const double X : x)
    contacts.push_back({{0, -1, -X}, {{1, 0, 0}}, mu});
  return contacts;
}

std::vector<RigidContact>
on_a_plane(const double half_x, const double half_y, const unsigned int n, const double mu)
{
  std::vector<RigidContact> contacts;
  for (unsigned int i = 0; i <= n; ++i)
    for (unsigned int j = 0; j <= n; ++j)
      {
        const double x = half_x * (2. * i / n - 1), y = half_y * (2. * j / n - 1);
        contacts.push_back({{0, 0, -1, 0, x, -y}, {{1, 0, 0, -y, 0, 0}, {0, 1, 0, x, 0, 0}}, mu});
      }
  return contacts;
}

void
expect(const bool                       held,
       const std::string               &what,
       const std::vector<double>       &load,
       const std::vector<RigidContact> &contacts)
{
  check::is_true(motion_beyond_friction(load, contacts, 1e-5).empty() == held,
                 what + (held ? " is held" : " is not held"));
}

// Of unit length, in this component alone.
void
expect_motion(const unsigned int               component,
              const double                     value,
              const std::vector<double>       &load,
              const std::vector<RigidContact> &contacts)
{
  auto motion = motion_beyond_friction(load, contacts, 1e-5);
  motion.resize(load.size());
  motion[component] -= value;
  for (const double v : motion)
    check::is_close(v, 0, 1e-6, "motion beyond friction", 1);
}

int
main(int, char **)
{
  for (const double mu : {0.01, 0.15, 0.5, 1., 3.})
    {
      const auto contacts = on_a_line({-1, -0.5, 0, 0.5, 1}, mu);
      expect(true, "a push below the limit", {0.99 * mu, -1, 0}, contacts);
      expect(true, "a push to the left", {-0.99 * mu, -1, 0}, contacts);
      expect(false, "a push beyond the limit", {1.01 * mu, -1, 0}, contacts);
      expect_motion(0, -1, {-1.01 * mu, -1, 0}, contacts);
    }

  // A larger coefficient would not help.
  const auto two_feet = on_a_line({-1, 1}, 0.5);
  expect(true, "nothing", {0, 0, 0}, two_feet);
  expect(true, "what is lifted (by friction or not)", {0, 1, 0}, two_feet);
  expect(true, "what tips over", {0.1, -1, -1.5}, two_feet);
  const auto turns = motion_beyond_contact({0.1, -1, -1.5}, two_feet, 1e-3);
  check::is_true(turns.size() == 3 && turns[2] < -0.1, "what tips over is beyond the contact, and turns");
  check::is_true(motion_beyond_contact({0.1, -1, -0.8}, two_feet, 1e-3).empty(), "what stands is not");
  check::is_true(motion_beyond_contact({0.6, -1, 0}, two_feet, 1e-3).size() == 3, "what slides is");
  expect(true, "what has no free motion", {}, {{{}, {}, 0}});
  // One foot without friction, one with, half the weight on each.
  const std::vector<RigidContact> one_slides = {{{0, -1, 1}, {}, 0}, {{0, -1, -1}, {{1, 0, 0}}, 0.5}};
  expect(true, "a push on one foot", {0.24, -1, 0}, one_slides);
  expect(false, "a push on one foot", {0.26, -1, 0}, one_slides);
  expect(true, "a wedge", {0, 1}, {{{1, 0}, {{0, 1}}, 0.1}, {{-1, 0}, {{0, 1}}, 0.1}});

  for (const unsigned int n : {1, 2, 7})
    for (const double mu : {0.05, 0.2, 1.})
      for (const double factor : {0.998, 0.9995, 1.0005, 1.002, 1.5})
        {
          const auto   contacts = on_a_plane(2, 1, n, mu);
          const double T        = factor * mu;
          for (double angle = 0.1; angle < 6; angle += 0.7)
            expect(factor < 1,
                   "a push in 3D",
                   {T * std::cos(angle), T * std::sin(angle), -1, 0, 0, 0},
                   contacts);
          // At height 1: the centre of pressure moves on by T.
          expect(
              factor < 1, "a push above the plane", {0.6 * T, 0.8 * T, -1, 0, -0.6 * T, 0.8 * T}, contacts);
          // The corners can carry everything: mu N r with r their distance.
          expect(factor < 1, "a body turned", {0, 0, -1, T * std::hypot(2, 1), 0, 0}, contacts);
        }
  expect_motion(3, 1, {0, 0, -1, 1, 0, 0}, on_a_plane(2, 1, 4, 0.3));
  return check::result();
}
} // namespace test_limit_load
