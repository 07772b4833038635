#pragma once
/// A value in time as a scene writes it: one number, or pairs of time and value.
#include <vector>

#include "studies/driver/section.hpp"

namespace g27 {

/// Linear between the entries, constant beyond; a single entry is a constant.
struct TimeTable {
  std::vector<double> t, v;

  double operator()(double time) const;
};

/// The entry `key` of a section. Throws InputError.
TimeTable read_time_table(Section const& section, std::string const& key, Dimension const& dim);
/// The same of a node that is not a direct entry; `key` is its name for messages.
TimeTable read_time_table(Section const& section, Node const& node, std::string const& key, Dimension const& dim);

}  // namespace g27
