#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/units.hpp"
#include "verification/exact/oracle.hpp"

namespace g27 {

namespace {

std::string help_of(Oracle const& oracle) {
  std::string text = fmt::format("{}: {}\n{}\n", oracle.name, oracle.summary, oracle.source);
  for (OracleParameter const& p : oracle.parameters) {
    text += fmt::format("  {}={}  [{}] {}\n", p.name, p.fallback.empty() ? "(required)" : p.fallback, p.unit, p.what);
  }
  return text;
}

/// A value with a unit, in the parameter's own.
std::string in_own_unit(Oracle const& oracle, std::string const& key, std::string const& value) {
  for (OracleParameter const& p : oracle.parameters) {
    if (p.name != key) continue;
    auto const quantity = parse_quantity(value);
    if (!quantity || !quantity->has_unit) return value;
    auto const number = number_in(value, p.unit);
    if (!number) {
      throw InputError("g27 exact", key, fmt::format("'{}' has another dimension than {}", value, p.unit),
                       fmt::format("give a number of {}", p.unit));
    }
    return fmt::format("{:.17g}", *number);
  }
  return value;
}

void print_text(OracleRecord const& record) {
  for (auto const& [name, value] : record) {
    if (auto const* list = std::get_if<std::vector<double>>(&value)) {
      fmt::print("{} =", name);
      for (double const x : *list) {
        fmt::print(" {:.12g}", x);
      }
      fmt::print("\n");
    } else if (auto const* number = std::get_if<double>(&value)) {
      fmt::print("{} = {:.12g}\n", name, *number);
    } else {
      fmt::print("{} = {}\n", name, std::get<std::string>(value));
    }
  }
}

}  // namespace

std::string help_of(ExactArguments const& arguments) {
  return arguments.name.empty() ? "" : help_of(find_by_name(all_oracles(), arguments.name, "g27 exact"));
}

int command_exact(ExactArguments const& arguments) {
  Oracle const oracle = find_by_name(all_oracles(), arguments.name, "g27 exact");
  OracleArguments values;
  for (std::string const& word : arguments.values) {
    std::size_t const equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError("g27 exact", word, "is not key=value", "write for instance gamma=1.4");
    }
    std::string const key = word.substr(0, equals);
    if (!values.emplace(key, in_own_unit(oracle, key, word.substr(equals + 1))).second) {
      throw InputError("g27 exact", key, "is given twice", "give each key once");
    }
  }
  OracleRecord const record = [&] {
    try {
      return evaluate(oracle, values);
    } catch (OracleError const& error) {
      throw InputError("g27 exact", error.key, error.what,
                       fmt::format("{}; its keys: g27 exact {} --help", error.remedy, oracle.name));
    }
  }();
  if (arguments.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (auto const& [name, value] : record) {
      json[name] = std::visit([](auto const& v) { return nlohmann::ordered_json(v); }, value);
    }
    fmt::print("{}\n", json.dump(2));
  } else {
    print_text(record);
  }
  return 0;
}

}  // namespace g27
