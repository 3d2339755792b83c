// A scene file, understood as far as declarations go: each value matches its pattern and knows its place.
#pragma once

#include <amontons/base/parameters.h>
#include <amontons/scene/outline.h>
#include <amontons/scene/scene.h>

namespace Amontons
{
  class SectionInput;

  class SceneInput
  {
  public:
    // Reads the file, declares its sections, and passes every value to the ParameterHandler (which fills the
    // groups). Throws InputError.
    SceneInput(const std::string              &file,
               const std::vector<std::string> &overrides,
               const ParameterGroups          &groups);

    std::string file;
    ProblemType kind = ProblemType::plane_strain;
    Outline     outline;

    // Sections "PREFIX NAME" in the order of the file.
    std::vector<SectionInput>
    sections(const std::string &prefix) const;

    // Whether the section at `path` is of the form PREFIX NAME (and not a group's).
    bool
    is_named(const std::string &path) const;

    struct Declaration
    {
      std::string section, name, default_value, pattern;
    };
    const Declaration &
    declaration(const std::string &section, const std::string &name) const;

  private:
    bool
    is_declared(const std::string &section) const;
    void
    declare(dealii::ParameterHandler &prm, const ParameterGroups &groups);
    void
    collect_declarations(const dealii::ParameterHandler &prm);
    void
    check_section(const std::string &path, const SourceLocation &where) const;
    void
    check_entry(const OutlineEntry &entry) const;
    void
    set(const OutlineEntry &entry, dealii::ParameterHandler &prm) const;

    std::vector<Declaration> declarations;
    std::vector<std::string> declared_sections; // all paths
    std::vector<std::string> named_paths;       // those of the form PREFIX NAME
  };

  // The values of one section. All reading functions throw InputError at the entry's place.
  class SectionInput
  {
  public:
    SectionInput(const SceneInput &input, const std::string &path, const std::string &name);

    std::string name; // "lower" of "Body lower"
    SourceLocation
    where() const;
    SourceLocation
    where(const std::string &entry) const;
    ProblemType
    kind() const;
    int
    dim() const;
    std::string
    scene_file() const;

    // Set, and to another value than the default.
    bool
    is_given(const std::string &entry) const;

    std::string
    text(const std::string &entry) const;
    double
    number(const std::string &entry) const;
    double
    positive_number(const std::string &entry) const;
    bool
    flag(const std::string &entry) const;
    Point<3>
    point(const std::string &entry) const;
    Tensor<1, 3>
    direction(const std::string &entry) const; // normalised
    std::vector<double>
    numbers(const std::string &entry) const;
    // Of what the expression may depend on.
    enum class Of
    {
      time,
      place_and_time,
      place_time_and_pressure
    };
    Expression
    expression(const std::string &entry, const std::string &text, const Of of = Of::place_and_time) const;
    // Exactly n texts (one more is ignored if two are needed, so that 2D scenes may write z); none if the
    // entry is empty.
    std::vector<std::string>
    components(const std::string &entry, const unsigned int n) const;
    std::array<Expression, 3>
    expressions(const std::string &entry, const Of of = Of::place_and_time) const; // dim; zero if empty
    FieldData
    field(const std::string &entry) const; // NAME or NAME(PARAMETER = NUMBER, ...)

    // An error if one of the entries is given: they mean nothing `context`, e.g. "for Mesh = disk".
    void
    refuse(const std::vector<std::string> &entries, const std::string &context) const;

    // An error if one of the entries is empty: they must be given `context`, e.g. "for Mesh = disk".
    void
    require(const std::vector<std::string> &entries, const std::string &context) const;

    [[noreturn]] void
    fail(const std::string &entry, const std::string &found, const std::string &allowed = "") const;

  private:
    const SceneInput *input;
    std::string       path;
  };
} // namespace Amontons
