#include "verification/exact/oracle.hpp"

#include <algorithm>
#include <numeric>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

/// Levenshtein distance: insertions, deletions and substitutions that turn a into b.
std::size_t edit_distance(std::string const& a, std::string const& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t const above = row[j];
      row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0 : 1)});
      diagonal = above;
    }
  }
  return row[b.size()];
}

std::string nearest(std::string const& key, std::vector<OracleParameter> const& parameters) {
  auto const best = std::min_element(parameters.begin(), parameters.end(), [&](auto const& a, auto const& b) {
    return edit_distance(key, a.name) < edit_distance(key, b.name);
  });
  return best == parameters.end() ? "" : best->name;
}

}  // namespace

OracleRecord evaluate(Oracle const& oracle, OracleArguments arguments) {
  for (auto const& [key, value] : arguments) {
    bool const known = std::any_of(oracle.parameters.begin(), oracle.parameters.end(),
                                   [&](auto const& parameter) { return parameter.name == key; });
    if (!known)
      throw OracleError{key, "is not a parameter of " + oracle.name,
                        "did you mean " + nearest(key, oracle.parameters) + "?"};
  }
  std::string missing;
  for (auto const& parameter : oracle.parameters) {
    if (arguments.count(parameter.name)) continue;
    if (parameter.fallback.empty())
      missing += (missing.empty() ? "" : " ") + parameter.name;
    else
      arguments[parameter.name] = parameter.fallback;
  }
  if (!missing.empty()) {
    std::string remedy = "add";
    for (std::size_t from = 0; from < missing.size();) {
      std::size_t const to = std::min(missing.find(' ', from), missing.size());
      remedy += " " + missing.substr(from, to - from) + "=VALUE";
      from = to + 1;
    }
    throw OracleError{missing, "missing", remedy};
  }
  try {
    return oracle.evaluate(arguments);
  } catch (NumericsError const& error) {
    throw OracleError{oracle.name, error.what(), "check that the arguments are admissible and in one set of units"};
  }
}

}  // namespace g27
