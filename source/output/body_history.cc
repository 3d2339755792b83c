#include <amontons/output/body_history.h>
#include <amontons/output/body_views.h>
#include <amontons/output/terminal.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace Amontons
{
  namespace
  {
    constexpr unsigned int full_width = 560, full_height = 430, small_width = 300, small_height = 260;

    // Stresses below are rounding errors.
    double
    rounding_of(const Scene &scene)
    {
      double largest_young = 0;
      for (const BodyData &body : scene.bodies)
        largest_young = std::max(largest_young, body.material.young);
      return 1e-13 * largest_young;
    }

    // What is known of the last state before it is drawn.
    struct Situation
    {
      const Scene                &scene;
      BodySurfaces                surfaces;
      std::vector<PressedPoint>   pressed;
      double                      moved = 0, warp = 1; // moved: 1 at finite strain
      ChosenView                  view;
      std::optional<ContactPlace> contact;

      bool
      hides_contact() const
      {
        return contact && view.seen < 0.15;
      }

      Camera
      camera_of_whole() const
      {
        return camera_of({&surfaces}, view.view, warp, full_width, full_height);
      }

      // Of the whole, or of what is around the contact, if that is small.
      Camera
      camera_of_contact() const
      {
        const Camera whole = camera_of_whole(), bounds = camera_of({&surfaces}, view.view, 1, 100, 100);
        const auto   centre          = place_of(contact->centre, 1);
        Camera       near            = whole;
        near.warp                    = 1;
        near.scale                   = 360 / (5 * std::max(contact->radius, 1e-300));
        std::tie(near.x, near.width) = part_of(
            view.view.right * centre, 460 / near.scale, bounds.x, bounds.width / bounds.scale, near.scale);
        std::tie(near.y, near.height) = part_of(
            view.view.down * centre, 360 / near.scale, bounds.y, bounds.height / bounds.scale, near.scale);
        return near.scale > 1.5 * whole.scale ? near : whole;
      }

    private:
      // Lower end, and size in pixels, of what a part about `centre` shares with the whole, which begins at
      // `first`; all in lengths.
      static std::pair<double, unsigned int>
      part_of(
          const double centre, const double size, const double first, const double all, const double scale)
      {
        const double lower = std::max(centre - size / 2, first),
                     upper = std::min(centre + size / 2, first + all);
        return {lower, static_cast<unsigned int>(std::max(1l, std::lround(scale * (upper - lower))))};
      }
    };

    Situation
    situation_of(const Answer<3> &answer, const StressRecovery<3> &recovery)
    {
      const Scene &scene = answer.discretization.scene;
      Situation    result{scene,
                       gather_body_surfaces(
                           answer.discretization, recovery, answer.state.displacement, rounding_of(scene)),
                       {},
                       0,
                       1,
                       {},
                       {}};
      if (result.surfaces.empty())
        return result;
      result.pressed = pressed_points(answer.interfaces, answer.fields);
      result.moved   = answer.elasticity.finite_strain() ? 1 : 0;
      result.warp    = result.moved > 0 ? 1 : warp_factor(result.surfaces, result.pressed);
      result.view    = choose_view(result.surfaces, result.pressed, result.warp);
      result.contact = contact_place(result.pressed, result.moved);
      return result;
    }

    std::string
    with_stress(const std::string &title, const Scene &scene)
    {
      return with_unit(title + ", von Mises stress", scene.units.pressure());
    }

    std::string
    caption_of(const Scene &scene, const double warp)
    {
      return (warp > 1 ? "Displacements are drawn " + short_number(warp) + " times as large as they are."
                       : std::string("Displacements are drawn as they are.")) +
             (scene.obstacles.empty() ? "" : " Rigid obstacles are not drawn.");
    }

    std::string
    whole_picture(const Situation &situation)
    {
      const Camera camera = situation.camera_of_whole();
      BodyPicture  picture{with_stress("Bodies", situation.scene),
                          camera.view,
                          {{Raster(camera.width, camera.height), ""}},
                          caption_of(situation.scene, situation.warp)};
      draw_bodies(situation.surfaces, {}, nullptr, camera, picture.panels[0].raster);
      return svg_bodies(picture);
    }

    // Three digits, of the size of the bodies.
    std::string
    place_text(const CutPlane &plane, const ContactPlace &contact, const double size)
    {
      std::string text;
      for (unsigned int d = 0; d < 3; ++d)
        if (plane.normal[d] != 0)
          {
            const double unit = std::pow(10., std::floor(std::log10(size)) - 2);
            const double at   = unit * std::round(place_of(contact.centre, plane.moved)[d] / unit);
            text = std::string("Cut at ") + "xyz"[d] + " = " + short_number(at == 0 ? 0. : at) + ". ";
          }
      return text;
    }

    // cut, plane: of a contact that is hidden, else empty.
    std::string
    contact_picture(const Situation &situation, const BodyCut &cut, const CutPlane *plane)
    {
      const Camera camera = situation.camera_of_contact();
      BodyPicture  picture{
          with_stress(plane != nullptr ? "Cut through the contact" : "Around the contact", situation.scene),
          camera.view,
          {{Raster(camera.width, camera.height), ""}},
          caption_of(situation.scene, camera.warp)};
      if (plane != nullptr)
        picture.caption =
            place_text(*plane, *situation.contact, size_of(situation.surfaces)) + picture.caption;
      draw_bodies(situation.surfaces, cut, plane, camera, picture.panels[0].raster);
      return svg_bodies(picture);
    }

    struct Instant
    {
      std::string         label;
      const BodySurfaces *surfaces;
    };

    // All with the same eyes.
    std::string
    strip(const Situation &situation, const std::vector<Instant> &instants)
    {
      std::vector<const BodySurfaces *> all;
      all.reserve(instants.size());
      for (const Instant &instant : instants)
        all.push_back(instant.surfaces);
      const Camera camera = camera_of(all, situation.view.view, situation.warp, small_width, small_height);
      BodyPicture  picture{with_stress("From the first contact to the end", situation.scene),
                          camera.view,
                          {},
                          caption_of(situation.scene, situation.warp)};
      for (const Instant &instant : instants)
        {
          picture.panels.push_back({Raster(camera.width, camera.height), instant.label});
          draw_bodies(*instant.surfaces, {}, nullptr, camera, picture.panels.back().raster);
        }
      return svg_bodies(picture);
    }
  } // namespace

  template <>
  void
  BodyHistory<3>::add(const Answer<3> &answer, const StressRecovery<3> &recovery, const bool is_first)
  {
    const Scene &scene   = answer.discretization.scene;
    const double t       = answer.state.t;
    const bool   is_last = t >= scene.end_time * (1 - 1e-9);
    if (is_last || states.size() > 1 ||
        (states.size() == 1 && t < (states[0].t + scene.end_time) / 2 - 1e-9 * scene.end_time))
      return;
    states.push_back({t,
                      is_first,
                      gather_body_surfaces(
                          answer.discretization, recovery, answer.state.displacement, rounding_of(scene))});
  }

  template <>
  void
  BodyHistory<2>::add(const Answer<2> &, const StressRecovery<2> &, const bool)
  {
  }

  template <>
  std::vector<std::string>
  BodyHistory<3>::pictures(const Answer<3> &answer, const StressRecovery<3> &recovery) const
  {
    const Situation       situation    = situation_of(answer, recovery);
    const MPI_Comm        communicator = answer.discretization.geometry.communicator;
    const bool            is_root      = Utilities::MPI::this_mpi_process(communicator) == 0;
    std::vector<CutPlane> planes; // one or none
    if (situation.hides_contact())
      planes.push_back(
          choose_cut(situation.view.view, *situation.contact, size_of(situation.surfaces), situation.moved));
    planes = Utilities::MPI::broadcast(communicator, planes);
    BodyCut cut;
    if (!planes.empty())
      cut = gather_body_cut(answer.discretization,
                            recovery,
                            answer.state.displacement,
                            rounding_of(situation.scene),
                            planes[0]);
    if (!is_root || situation.surfaces.empty())
      return {};
    std::vector<std::string> svgs = {whole_picture(situation)};
    if (situation.contact &&
        (!planes.empty() || situation.camera_of_contact().scale > 1.01 * situation.camera_of_whole().scale))
      svgs.push_back(contact_picture(situation, cut, planes.empty() ? nullptr : &planes[0]));
    std::vector<Instant> instants;
    for (const State &state : states)
      if (state.t < answer.state.t)
        instants.push_back(
            {"t = " + short_number(state.t) + (state.is_first ? ", first contact" : ""), &state.surfaces});
    if (!instants.empty())
      {
        instants.push_back({"t = " + short_number(answer.state.t), &situation.surfaces});
        svgs.push_back(strip(situation, instants));
      }
    svgs.erase(std::remove(svgs.begin(), svgs.end(), ""), svgs.end());
    return svgs;
  }

  template <>
  std::vector<std::string>
  BodyHistory<2>::pictures(const Answer<2> &, const StressRecovery<2> &) const
  {
    return {};
  }
} // namespace Amontons
