#include "studies/shock_tubes/recorded_errors.hpp"

#include <map>

namespace g27 {

namespace {

/// Two digits on record: a ratio agrees when it is within one unit of the last.
constexpr double rounding = 0.01;

using Ratios = std::map<std::string, double>;

std::map<std::string, Ratios> const& ratios() {
  static std::map<std::string, Ratios> const table{
      {"toro1",
       {{"literal", .74},
        {"binary", .42},
        {"linear-solver", .34},
        {"linear", .34},
        {"muscl-solver", .20},
        {"muscl", .21},
        {"parabolic", .08}}},
      {"toro2",
       {{"literal", .43},
        {"binary", .45},
        {"linear-solver", .41},
        {"linear", .41},
        {"muscl-solver", .26},
        {"muscl", .26},
        {"parabolic", .18}}},
      {"toro3",
       {{"literal", .82},
        {"binary", .53},
        {"linear-solver", .38},
        {"linear", .38},
        {"muscl-solver", .40},
        {"muscl", .40},
        {"parabolic", .12}}},
      {"toro4",
       {{"literal", 1.09},
        {"binary", .49},
        {"linear-solver", .34},
        {"linear", .34},
        {"muscl-solver", .34},
        {"muscl", .34},
        {"parabolic", .09}}},
      {"toro5",
       {{"literal", 3.84},
        {"binary", .86},
        {"linear-solver", .58},
        {"linear", .77},
        {"muscl-solver", .81},
        {"muscl", .82},
        {"parabolic", .67}}},
      {"lax",
       {{"literal", .83},
        {"binary", .43},
        {"linear-solver", .33},
        {"linear", .33},
        {"muscl-solver", .30},
        {"muscl", .30},
        {"parabolic", .06}}},
      {"leblanc",
       {{"literal", .52},
        {"binary", .35},
        {"linear-solver", .30},
        {"linear", .29},
        {"muscl-solver", .25},
        {"muscl", .25},
        {"parabolic", .22}}},
      {"contact",
       {{"literal", .84},
        {"binary", .34},
        {"linear-solver", .33},
        {"linear", .33},
        {"muscl-solver", .29},
        {"muscl", .29},
        {"parabolic", .05}}},
      {"slow-shock",
       {{"literal", 6.6},
        {"binary", 2.2},
        {"linear-solver", 4.5},
        {"linear", 4.5},
        {"muscl-solver", 3.0},
        {"muscl", 2.97},
        {"parabolic", 2.5}}},
      {"tube-1e10",
       {{"literal", .74},
        {"binary", .57},
        {"linear-solver", .40},
        {"linear", .40},
        {"muscl-solver", .45},
        {"muscl", .45},
        {"parabolic", .18}}},
  };
  return table;
}

/// Errors themselves [kg/m^3], where Godunov's is no yardstick; means over the domain (of length 10 and 1).
std::map<std::string, Ratios> const& errors() {
  static std::map<std::string, Ratios> const table{
      {"shu-osher-200", {{"linear", .069}, {"muscl", .072}, {"parabolic", .031}}},
      {"shu-osher-400", {{"linear", .047}, {"muscl", .045}, {"parabolic", .025}}},
      {"woodward-colella-400", {{"linear", .105}, {"muscl", .101}, {"parabolic", .034}}},
  };
  return table;
}

std::optional<double> look_up(std::map<std::string, Ratios> const& table, std::string const& problem,
                              std::string const& scheme) {
  auto const row = table.find(problem);
  if (row == table.end()) return std::nullopt;
  auto const entry = row->second.find(scheme);
  return entry == row->second.end() ? std::nullopt : std::optional(entry->second);
}

}  // namespace

std::optional<RecordedError> recorded_error(std::string const& problem, std::string const& scheme) {
  if (auto const ratio = look_up(ratios(), problem, scheme)) return RecordedError{*ratio, rounding, false};
  if (auto const error = look_up(errors(), problem, scheme)) return RecordedError{*error, 0.0005, true};
  return std::nullopt;
}

}  // namespace g27
