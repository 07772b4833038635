#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "verification/exact/oracle.hpp"

namespace g27 {

std::string help_of(ExactArguments const& arguments) {
  std::string text;
  for (Oracle const& oracle : all_oracles()) {
    if (oracle.name != arguments.name) continue;
    text = fmt::format("{}: {}\n{}\n", oracle.name, oracle.summary, oracle.source);
    for (OracleParameter const& p : oracle.parameters) {
      text += fmt::format("  {}={}  [{}] {}\n", p.name, p.fallback.empty() ? "(required)" : p.fallback, p.unit, p.what);
    }
  }
  return text;
}

namespace {

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

int command_exact(ExactArguments const& arguments) {
  Oracle const oracle = find_by_name(all_oracles(), arguments.name, "g27 exact");
  OracleArguments values;
  for (std::string const& word : arguments.values) {
    std::size_t const equals = word.find('=');
    if (equals == std::string::npos || equals == 0) {
      throw InputError("g27 exact", word, "is not key=value", "write for instance gamma=1.4");
    }
    if (!values.emplace(word.substr(0, equals), word.substr(equals + 1)).second) {
      throw InputError("g27 exact", word.substr(0, equals), "is given twice", "give each key once");
    }
  }
  try {
    OracleRecord const record = evaluate(oracle, values);
    if (arguments.json) {
      nlohmann::ordered_json json = nlohmann::ordered_json::object();
      for (auto const& [name, value] : record) {
        json[name] = std::visit([](auto const& v) { return nlohmann::ordered_json(v); }, value);
      }
      fmt::print("{}\n", json.dump(2));
    } else {
      print_text(record);
    }
  } catch (OracleError const&) {
    fmt::print(stderr, "{}", help_of(arguments));
    throw;
  }
  return 0;
}

}  // namespace g27
