/// From where the bodies of a 3D scene are looked at, so that their contact is seen; how much their
/// displacements are enlarged; where they are cut.
#pragma once

#include <amontons/contact/contact_interface.h>
#include <amontons/output/body_picture.h>

#include <optional>

namespace Amontons
{
  /// A slave node that is pressed.
  struct PressedPoint
  {
    unsigned int pair = 0;
    BodyPoint    place;
    Tensor<1, 3> force;   // pressure times area, along the normal
    double       gap = 0; // of the reference configuration, to another body; obstacles: 0
  };

  /// Of all pairs; needs no communication.
  std::vector<PressedPoint>
  pressed_points(const std::vector<ContactInterface<3>> &interfaces,
                 const std::vector<SurfaceFields<3>>    &fields);

  /// Diameter of the bounding box, reference configuration.
  double
  size_of(const BodySurfaces &surfaces);

  /// 1, 2, 5, 10, 20, ... times, so that the largest displacement is a twentieth of the size; not where
  /// surfaces that touch would overlap visibly, as gaps that displacements have closed are enlarged, too.
  double
  warp_factor(const BodySurfaces &surfaces, const std::vector<PressedPoint> &pressed);

  /// Centre and radius of the force of the pair that is pressed most; where x is X + moved u.
  struct ContactPlace
  {
    BodyPoint centre;
    double    radius = 0;
  };
  std::optional<ContactPlace>
  contact_place(const std::vector<PressedPoint> &pressed, const double moved);

  /// Up is the axis along which bodies are pressed most; from the side, and from above unless that shows less
  /// of the contact by far.
  struct ChosenView
  {
    BodyView view;
    double   seen = 0; // part of the contact's force that acts where it is seen, or just behind what is seen
  };
  ChosenView
  choose_view(const BodySurfaces &surfaces, const std::vector<PressedPoint> &pressed, const double warp);

  /// Through the centre of the contact, along the axis `up` and across the view as far as axes allow: the
  /// side away from the viewer is kept.
  CutPlane
  choose_cut(const BodyView &view, const ContactPlace &contact, const double size, const double moved);
} // namespace Amontons
