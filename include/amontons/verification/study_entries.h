/// What all kinds of study files have in common: which entries there may be, and the grammar of their values.
#pragma once

#include <amontons/scene/outline.h>

#include <string>
#include <vector>

namespace Amontons
{
  /// "Body a/Refinements & Body b/Refinements: 1, 2, 3": all `names` take the same value. A name may say what
  /// to make of it: "Body a/Cells = {}, 4".
  struct SweptParameter
  {
    std::vector<std::string> names, values;
    std::string              label; // "Refinements"

    /// "Section/Name = value", one for each name.
    std::vector<std::string>
    overrides(const unsigned int value) const;
  };

  /// A number of summary.json.
  struct SummaryPath
  {
    std::string path, label; // "reference.errors.contact_size", "contact_size"
  };

  enum class StudyKind
  {
    convergence,
    work_precision,
    stability
  };

  /// The outline of a study file, with its kind. Functions throw InputError with the place of the entry.
  class StudyEntries
  {
  public:
    static const unsigned int max_swept = 4;

    /// Refuses sections and entries that this kind has not.
    explicit StudyEntries(const std::string &file);

    SourceLocation
    where(const std::string &section, const std::string &name) const;

    /// At the top level; `otherwise` where it is missing or empty.
    std::string
    text(const std::string &name, const std::string &otherwise = "") const;
    bool
    is_true(const std::string &name) const;
    double
    positive_number(const std::string &name, const double otherwise) const;
    unsigned int
    number_up_to(const std::string &name, const unsigned int most) const;
    std::string
    choice(const std::string              &name,
           const std::vector<std::string> &allowed) const; // the first is the default
    std::vector<SummaryPath>
    paths(const std::string &name, const std::string &otherwise = "") const;
    std::vector<std::string>
    overrides(const std::string &section) const;

    /// Title and output folder are the name of the file where they are missing; the scene is relative to the
    /// file.
    std::string
    or_stem(const std::string &name) const;
    std::string
    scene() const;

    /// In their order, the one of number `last` (0: none) at the end.
    std::vector<SweptParameter>
    sweep(const unsigned int last = 0) const;

    const std::string file;
    const Outline     outline;
    const StudyKind   kind;
  };
} // namespace Amontons
