/// Numbers of a summary.json by their paths, "pairs.0.normal_force".
#pragma once

#include <amontons/verification/study_entries.h>

#include <boost/property_tree/ptree.hpp>

namespace Amontons
{
  /// NaN for what is there but is no number (null). Throws InputError at `where` if there is nothing.
  double
  number_at(const boost::property_tree::ptree &summary, const SummaryPath &path, const SourceLocation &where);
} // namespace Amontons
