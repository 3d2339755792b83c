// Numerical parameters: each module declares one struct beside its use; the reader gathers them.
#pragma once

#include <deal.II/base/parameter_handler.h>

#include <vector>

namespace Amontons
{
  // A section of the .prm file. `declare` enters its own subsection and calls prm.add_parameter for every
  // member. `check` throws std::invalid_argument("Entry name: found ...; allowed ...") for combinations that
  // patterns cannot express.
  struct ParameterGroup
  {
    virtual ~ParameterGroup() = default;
    virtual void
    declare(dealii::ParameterHandler &prm) = 0;
    virtual void
    check() const
    {
    }
  };

  using ParameterGroups = std::vector<ParameterGroup *>;
} // namespace Amontons
