// Which of two half planes or half spaces a body of the scene is cut out of.
#pragma once

#include <amontons/verification/closed_form_arguments.h>
#include <amontons/verification/reference_solution.h>

namespace Amontons
{
  class TwoHalves
  {
  public:
    // The common surface is normal to `axis` and goes through `centre`; lengths below 1e-9 `size` count as
    // zero.
    TwoHalves(const Point<3>              &centre,
              const double                 size,
              const unsigned int           axis,
              const MaterialData          &lower,
              const MaterialData          &upper,
              const std::vector<BodyData> &bodies);

    // -1: below, 1: above: by the body's shape where that says it, else by the point; on the surface by the
    // material.
    int
    side(const std::string &body, const Point<3> &p) const;

  private:
    struct Sides
    {
      int by_shape, by_material; // 0: not known
    };
    double                       surface, tolerance;
    unsigned int                 axis;
    std::map<std::string, Sides> sides; // by body
  };

  // Displacement and stress of two bodies that are halves under opposite tractions: `lower` is the field
  // of the one below but for its material; E1, nu1 and E2, nu2 (a body without them is rigid) are read from
  // the arguments. Field: HalfPlaneField or HalfSpaceField.
  template <typename Field>
  void
  set_fields_of_halves(const ClosedFormArguments   &get,
                       const unsigned int           axis,
                       const std::vector<BodyData> &bodies,
                       Field                        lower,
                       ReferenceSolution           &s)
  {
    lower.material   = {get("E1"), get("nu1")};
    Field      upper = lower.opposite();
    const bool rigid = !get.is_given("E2");
    if (!rigid)
      upper.material = {get("E2"), get("nu2")};

    const TwoHalves halves(lower.centre, lower.size, axis, lower.material, upper.material, bodies);
    s.displacement = [=](const std::string &body, const Point<3> &p) {
      if (halves.side(body, p) < 0)
        return lower.displacement(p);
      return rigid ? dealii::Tensor<1, 3>() : upper.displacement(p);
    };
    s.stress = [=](const std::string &body, const Point<3> &p) {
      return halves.side(body, p) < 0 ? lower.stress(p) : upper.stress(p);
    };
  }
} // namespace Amontons
