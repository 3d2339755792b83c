#include <amontons/scene/section_readers.h>

#include <algorithm>

namespace Amontons
{
  namespace
  {
    using Prescribed = std::array<std::optional<Expression>, 3>;

    // The indices that a list of components stands for; in 2D, there is one rotation, about z.
    std::vector<unsigned int>
    displacement_indices(const SectionInput &section)
    {
      return section.dim() == 2 ? std::vector<unsigned int>{0, 1} : std::vector<unsigned int>{0, 1, 2};
    }

    std::vector<unsigned int>
    rotation_indices(const SectionInput &section)
    {
      return section.dim() == 2 ? std::vector<unsigned int>{2} : std::vector<unsigned int>{0, 1, 2};
    }

    // Expressions or `free`; what the list does not name is held. `driver` is the force (moment) at free
    // components; components that nobody prescribed become free where they are driven.
    void
    read_degrees_of_freedom(const SectionInput              &section,
                            const std::string               &entry,
                            const std::string               &driver_entry,
                            const std::vector<unsigned int> &indices,
                            Prescribed                      &prescribed,
                            std::array<Expression, 3>       &driver)
    {
      prescribed.fill(Expression(0.));
      const auto values = section.components(entry, indices.size());
      const auto forces = section.components(driver_entry, indices.size());
      for (unsigned int k = 0; k < indices.size(); ++k)
        {
          const unsigned int i = indices[k];
          if (!forces.empty())
            driver[i] = section.expression(driver_entry, forces[k], SectionInput::Of::time);
          if (values.empty() ? !driver[i].is_zero() : values[k] == "free")
            prescribed[i].reset();
          else if (!values.empty() && values[k].empty())
            section.fail(
                entry, "component " + std::to_string(k) + " is empty", "an expression (0: held) or 'free'");
          else if (!values.empty())
            prescribed[i] = section.expression(entry, values[k], SectionInput::Of::time);
          if (prescribed[i] && !driver[i].is_zero())
            section.fail(driver_entry,
                         "component " + std::to_string(k) + " is '" + driver[i].text() + "', but " + entry +
                             " prescribes '" + prescribed[i]->text() + "' there",
                         "0, or 'free' as this component of " + entry);
        }
    }
  } // namespace

  MotionData
  read_motion(const SectionInput &section)
  {
    MotionData motion;
    motion.name      = section.name;
    motion.where     = section.where();
    motion.reference = section.point("Reference point");
    read_degrees_of_freedom(
        section, "Displacement", "Force", displacement_indices(section), motion.displacement, motion.force);
    read_degrees_of_freedom(
        section, "Rotation", "Moment", rotation_indices(section), motion.rotation, motion.moment);

    if (section.kind() == ProblemType::axisymmetric)
      {
        const std::string entry = section.is_given("Displacement") ? "Displacement" : "Force";
        if (!motion.displacement[0] || !motion.displacement[0]->is_zero())
          section.fail(entry,
                       "found '" + section.text(entry) + "', a rigid motion in the radial direction",
                       "0 as first component: axisymmetric rigid motions are along the axis");
        for (const std::string rotation : {"Rotation", "Moment"})
          if (section.is_given(rotation) && (!motion.rotation[2] || !motion.rotation[2]->is_zero()))
            section.fail(
                rotation, "found '" + section.text(rotation) + "'", "no rotation in axisymmetric scenes");
      }
    return motion;
  }
} // namespace Amontons
