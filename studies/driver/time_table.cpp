#include "studies/driver/time_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace g27 {

double TimeTable::operator()(double time) const {
  auto const next = static_cast<std::size_t>(std::upper_bound(t.begin(), t.end(), time) - t.begin());
  if (next == 0 || next == t.size()) {
    return next == 0 ? v.front() : v.back();
  }
  double const f = (time - t[next - 1]) / (t[next] - t[next - 1]);
  return (1 - f) * v[next - 1] + f * v[next];
}

TimeTable read_time_table(Section const& section, std::string const& key, Dimension const& dim) {
  return read_time_table(section, section.need(key, fmt::format("\"{}\"", dim.example)), key, dim);
}

TimeTable read_time_table(Section const& section, Node const& node, std::string const& key, Dimension const& dim) {
  auto const* rows = std::get_if<Node::Array>(&node.value);
  if (rows == nullptr) {
    return {{0.0}, {section.quantity_of(node, key, dim)}};
  }
  std::vector<double> t, v;
  for (std::size_t i = 0; i < rows->size(); ++i) {
    auto const* row = std::get_if<Node::Array>(&(*rows)[i].value);
    std::string const place = fmt::format("{}.{}", key, i);
    if (row == nullptr || row->size() != 2) {
      throw section.error(key, fmt::format("entry {} is not a pair", i),
                          fmt::format("write [[\"0 us\", \"{}\"], ...]", dim.example));
    }
    t.push_back(section.quantity_of((*row)[0], place + ".0", dimension::time));
    v.push_back(section.quantity_of((*row)[1], place + ".1", dim));
    if (i > 0 && !(t[i] > t[i - 1])) {
      throw section.error(key, fmt::format("times do not increase at entry {}", i), "sort the pairs by time");
    }
  }
  if (t.empty()) {
    throw section.error(key, "is an empty table", fmt::format("write [[\"0 us\", \"{}\"], ...]", dim.example));
  }
  return {t, v};
}

}  // namespace g27
