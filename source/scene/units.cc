#include <amontons/scene/text.h>
#include <amontons/scene/units.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace Amontons
{
  namespace
  {
    const std::set<std::string> lengths = {"m", "mm", "cm", "km", "um", "nm", "in", "ft"},
                                forces  = {"N", "kN", "MN", "mN", "uN", "nN", "lbf", "kip", "kgf", "dyn"};

    // A word of letters; what is not ASCII is one.
    bool
    is_name(const std::string &text)
    {
      return !text.empty() && text.size() <= 12 && std::all_of(text.begin(), text.end(), [](const char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
      });
    }
  } // namespace

  std::string
  Units::pressure() const
  {
    static const std::map<std::pair<std::string, std::string>, std::string> names = {{{"mm", "N"}, "MPa"},
                                                                                     {{"mm", "kN"}, "GPa"},
                                                                                     {{"m", "N"}, "Pa"},
                                                                                     {{"m", "kN"}, "kPa"},
                                                                                     {{"m", "MN"}, "MPa"},
                                                                                     {{"um", "uN"}, "MPa"},
                                                                                     {{"um", "mN"}, "GPa"},
                                                                                     {{"in", "lbf"}, "psi"},
                                                                                     {{"in", "kip"}, "ksi"}};
    const auto found = names.find({length, force});
    if (found != names.end())
      return found->second;
    return are_known() ? force + "/" + length + "^2" : "";
  }

  std::string
  Units::force_of(const bool per_thickness) const
  {
    return per_thickness && are_known() ? force + "/" + length : force;
  }

  std::string
  Units::work_of(const bool per_thickness) const
  {
    return per_thickness || !are_known() ? force : force + " " + length;
  }

  std::optional<Units>
  read_units(const std::string &text, std::string &allowed)
  {
    const std::vector<std::string> names = split(text, ',');
    allowed                              = "LENGTH, FORCE, as in 'mm, N'";
    if (names.empty())
      return Units();
    if (names.size() != 2 || !is_name(names[0]) || !is_name(names[1]))
      return {};
    if (forces.count(names[0]) > 0 || lengths.count(names[1]) > 0)
      {
        allowed = "first the unit of length, then that of force, as in 'mm, N'";
        return {};
      }
    return Units{names[0], names[1]};
  }

  std::string
  with_unit(const std::string &text, const std::string &unit)
  {
    return unit.empty() ? text : text + " [" + unit + "]";
  }
} // namespace Amontons
