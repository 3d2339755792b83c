#include <amontons/scene/load_program.h>
#include <amontons/scene/path_corners.h>
#include <amontons/scene/text.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Amontons
{
  namespace
  {
    unsigned int
    read_increments(const SectionInput &top)
    {
      const std::string text = top.text("Increments");
      if (text == "automatic")
        return 0;
      const auto number = as_number(text);
      if (!number || !(*number >= 1 && *number <= 1e9) || *number != std::floor(*number))
        top.fail("Increments", "found '" + text + "'", "automatic, or an integer n >= 1");
      return static_cast<unsigned int>(*number);
    }

    std::vector<double>
    read_output_times(const SectionInput &top, const double end_time)
    {
      std::vector<double> times;
      for (const std::string &text : split(top.text("Output times"), ','))
        {
          const auto time = as_number(text);
          if (!time)
            top.fail("Output times", "found '" + text + "'", "numbers separated by commas");
          if (!(*time > 0 && *time <= end_time))
            top.fail("Output times", "found " + text, "times in (0, End time]");
          if (!times.empty() && *time <= times.back())
            top.fail("Output times", "found " + text + " after a later time", "increasing times");
          times.push_back(*time);
        }
      return times;
    }

    // Where what depends on the place may be looked at.
    std::vector<Point<3>>
    places_of(const Scene &scene)
    {
      std::vector<Point<3>> places = {Point<3>()};
      for (const BodyData &body : scene.bodies)
        if (body.shape == "block")
          for (const double part : {0., 0.5, 1.})
            places.push_back(body.lower + part * (body.upper - body.lower) + body.shift);
        else if (body.shape != "file")
          for (const double side : {-1., 0., 1.})
            places.push_back(body.centre + body.shift + side * body.radius * Point<3>(1, 1, 1));
      return places;
    }

    // All that moves or loads bodies and obstacles, but for fields at boundaries: f(expression).
    template <typename SceneType, typename F>
    void
    for_each_load(SceneType &scene, const F &f)
    {
      const auto all = [&](auto &expressions) {
        for (auto &expression : expressions)
          f(expression);
      };
      const auto given = [&](auto &expressions) {
        for (auto &expression : expressions)
          if (expression)
            f(*expression);
      };
      const auto motion = [&](auto &data) {
        given(data.displacement);
        all(data.force);
        given(data.rotation);
        all(data.moment);
      };
      for (auto &body : scene.bodies)
        {
          all(body.body_force);
          if (body.rigid)
            motion(*body.rigid);
        }
      for (auto &obstacle : scene.obstacles)
        motion(obstacle.motion);
      for (auto &condition : scene.conditions)
        {
          given(condition.displacement);
          all(condition.value);
          if (condition.motion)
            motion(*condition.motion);
        }
    }

    class CornerTimes
    {
    public:
      explicit CornerTimes(const Scene &scene)
          : looks(scene.n_increments == 0 && scene.has_friction()), end_time(scene.end_time),
            places(places_of(scene))
      {
      }

      void
      add(const Expression &expression)
      {
        add(expression.corners());
        if (!looks || !expression.depends_on_time())
          return;
        for (const Point<3> &place : expression.depends_on_place() ? places : std::vector<Point<3>>(1))
          try
            {
              const auto course =
                  course_of_path([&](const double t) { return expression.value(place, t); }, end_time);
              found.insert(found.end(), course.corners.begin(), course.corners.end());
              add_variation(course.variation);
            }
          catch (const InputError &)
            {
              // it has no value there, nor need it
            }
      }

      void
      add(const std::vector<double> &more)
      {
        times.insert(times.end(), more.begin(), more.end());
      }

      void
      add(const std::optional<Expression> &expression)
      {
        if (expression)
          add(*expression);
      }

      std::vector<double>
      inside() const
      {
        std::vector<double> result;
        const auto          add = [&](const std::vector<double> &more, const double same) {
          for (const double t : more)
            if (t > 0 && t < end_time && std::none_of(result.begin(), result.end(), [&](const double other) {
                  return std::abs(t - other) <= same;
                }))
              result.push_back(t);
        };
        add(times, 0);
        add(found, 1.5e-3 * end_time); // those of tables are known better; no nearer than values looked at
        std::sort(result.begin(), result.end());
        return result;
      }

      // See Scene::load_progress.
      std::vector<double>
      progress() const
      {
        constexpr double    of_time = 0.1;
        std::vector<double> result(varied);
        for (unsigned int i = 0; i < result.size(); ++i)
          result[i] = (result[i] / n_varied + of_time * i / (result.size() - 1)) / (1 + of_time);
        return result;
      }

      // The last point of a table.
      double
      last() const
      {
        return times.empty() ? 0. : *std::max_element(times.begin(), times.end());
      }

    private:
      void
      add_variation(const std::vector<double> &shares)
      {
        varied.resize(std::max(varied.size(), shares.size()), 0.);
        for (unsigned int i = 0; i < shares.size(); ++i)
          varied[i] += shares[i];
        n_varied += !shares.empty();
      }

      const bool   looks; // beyond tables: for friction; who says how many increments there are, says where
      const double end_time;
      const std::vector<Point<3>> places;
      std::vector<double>         times, found; // of tables, and by looking
      std::vector<double>         varied;       // sum over n_varied paths, see PathCourse
      unsigned int                n_varied = 0;
    };
  } // namespace

  void
  read_load_program(const SectionInput &top, Scene &scene)
  {
    scene.end_time          = top.positive_number("End time");
    scene.n_increments      = read_increments(top);
    scene.minimum_increment = top.positive_number("Minimum increment");
    if (scene.minimum_increment > 1)
      top.fail("Minimum increment",
               "found " + top.text("Minimum increment"),
               "a fraction of the end time, more than 0 and at most 1");
    scene.output_times = read_output_times(top, scene.end_time);
  }

  void
  find_corner_times(Scene &scene)
  {
    CornerTimes corners(scene);
    for_each_load(scene, [&](const Expression &load) { corners.add(load); });
    for (const ConditionData &condition : scene.conditions)
      if (condition.field)
        corners.add(scene.boundary_fields.corner_times(*condition.field, scene.end_time));
    for (const PairData &pair : scene.pairs)
      {
        corners.add(pair.initial_gap);
        corners.add(pair.friction);
        corners.add(pair.tresca_bound);
      }
    scene.corner_times  = corners.inside();
    scene.load_progress = corners.progress();
    if (corners.last() > scene.end_time)
      {
        std::ostringstream text;
        text << "the load program ends at t = " << scene.end_time
             << " ('End time'), but tables go on to t = " << corners.last()
             << ": what they say after the end is not applied";
        scene.notes.push_back(text.str());
      }
  }

  bool
  let_loads_grow_before_start(Scene &scene)
  {
    bool       found  = false;
    const auto places = places_of(scene);
    for_each_load(scene, [&](Expression &load) {
      load.grow_before_start(scene.end_time);
      for (const Point<3> &place : places)
        try
          {
            found = found || load.value(place, 0) != 0;
          }
        catch (const InputError &)
          {
            // it has no value there, nor need it
          }
    });
    return found;
  }
} // namespace Amontons
