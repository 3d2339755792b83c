/// The bodies of a 3D scene as a picture: pixels within an SVG, with the colours of the stress and the axes.
#pragma once

#include <amontons/output/body_surfaces.h>
#include <amontons/output/rasteriser.h>

namespace Amontons
{
  /// Unit vectors in space: to the right and down in the picture, and towards the viewer.
  struct BodyView
  {
    Tensor<1, 3> right, down, towards;
  };

  /// Where points X + warp u are in a picture; parallel projection.
  struct Camera
  {
    BodyView     view;
    double       warp = 1, scale = 1; // pixels per length
    double       x = 0, y = 0;        // of the picture's upper left corner, along right and down, in lengths
    unsigned int width = 1, height = 1;

    RasterPoint
    project(const BodyPoint &point) const;
  };

  /// All that is in any of these states, in at most this many pixels.
  Camera
  camera_of(const std::vector<const BodySurfaces *> &states,
            const BodyView                          &view,
            const double                             warp,
            const unsigned int                       width,
            const unsigned int                       height);

  /// Draws the faces with light lines around them; with a plane: what is behind of it, with the cut.
  void
  draw_bodies(const BodySurfaces &surfaces,
              const BodyCut      &cut,
              const CutPlane     *plane,
              const Camera       &camera,
              Raster             &raster);

  /// The place x = X + moved u.
  Tensor<1, 3>
  place_of(const BodyPoint &point, const double moved);

  /// One or several pictures side by side, in the same colours.
  struct BodyPicture
  {
    struct Panel
    {
      Raster      raster;
      std::string label; // below it; empty: none
    };
    std::string        title;
    BodyView           view; // whose axes are drawn beside the pictures
    std::vector<Panel> panels;
    std::string        caption; // below all of it
  };

  /// Empty where nothing is drawn.
  std::string
  svg_bodies(const BodyPicture &picture);
} // namespace Amontons
