#include <amontons/scene/section_readers.h>
#include <amontons/scene/scene_declarations.h>
#include <amontons/scene/text.h>

#include <algorithm>
#include <regex>

namespace Amontons
{
  namespace
  {
    using Type = ConditionData::Type;

    Type
    type_of(const std::string &text)
    {
      return text == "displacement"  ? Type::displacement
             : text == "symmetry"    ? Type::symmetry
             : text == "traction"    ? Type::traction
             : text == "pressure"    ? Type::pressure
             : text == "total force" ? Type::total_force
                                     : Type::platen;
    }

    // "halfplane_elliptic(P = 1, a = 2)", but no expression such as "if(x == 1, 2, 3)".
    bool
    is_closed_form(const std::string &text)
    {
      static const std::regex form(
          "[A-Za-z_][A-Za-z_0-9]*\\s*\\(\\s*[A-Za-z_][A-Za-z_0-9]*\\s*=[^=][\\s\\S]*\\)");
      return std::regex_match(text, form);
    }

    void
    read_displacement(const SectionInput &section, ConditionData &condition)
    {
      if (is_closed_form(section.text("Value")))
        {
          condition.field = section.field("Value");
          return;
        }
      const auto pieces = section.components("Value", section.dim());
      bool       any    = false;
      for (unsigned int i = 0; i < pieces.size(); ++i)
        if (!pieces[i].empty() && pieces[i] != "free")
          {
            condition.displacement[i] = section.expression("Value", pieces[i]);
            any                       = true;
          }
      if (!any)
        section.fail("Value",
                     "found '" + section.text("Value") + "', which prescribes nothing",
                     "'ux; uy" + std::string(section.dim() == 3 ? "; uz" : "") +
                         "', each an expression or 'free' but one, or NAME(PARAMETER = NUMBER, ...)");
    }

    void
    read_value(const SectionInput &section, ConditionData &condition)
    {
      const std::string value = section.text("Value");
      switch (condition.type)
        {
          case Type::displacement:
            read_displacement(section, condition);
            break;
          case Type::traction:
          case Type::total_force:
            if (value.empty())
              section.fail(
                  "Value", "found nothing", std::to_string(section.dim()) + " components separated by ';'");
            condition.value = section.expressions(
                "Value",
                condition.type == Type::traction ? SectionInput::Of::place_and_time : SectionInput::Of::time);
            break;
          case Type::pressure:
            if (value.empty())
              section.fail("Value", "found nothing", "one expression, positive in compression");
            condition.value[0] = section.expression("Value", section.components("Value", 1)[0]);
            break;
          case Type::symmetry:
          case Type::platen:
            section.refuse(
                {"Value"},
                "for Type = " + section.text("Type") +
                    (condition.type == Type::platen ? ": use Displacement, Force, Rotation, Moment" : ""));
        }
    }
  } // namespace

  ConditionData
  read_condition(const SectionInput &section)
  {
    ConditionData condition;
    condition.name  = section.name;
    condition.where = section.where();
    condition.type  = type_of(section.text("Type"));
    for (const std::string &boundary : split(section.text("Boundaries"), ','))
      condition.boundaries.push_back(read_boundary_name(section, "Boundaries", boundary));
    if (condition.boundaries.empty())
      section.fail("Boundaries", "found nothing", "BODY/BOUNDARY, BODY/BOUNDARY, ...");
    read_value(section, condition);
    if (condition.type == Type::platen)
      condition.motion = read_motion(section);
    else
      section.refuse(motion_entries(),
                     "for Type = " + section.text("Type") + ", only for a platen: use Value");
    return condition;
  }
} // namespace Amontons
