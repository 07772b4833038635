#include "studies/driver/data_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>

#include "studies/driver/input_error.hpp"
#include "studies/driver/nearest_key.hpp"

namespace g27 {
namespace {

std::vector<std::string> split(std::string const& line) {
  std::vector<std::string> fields(1);
  for (char const c : line) {
    if (c == ',') {
      fields.emplace_back();
    } else if (c != '\r' && c != '"' && !(c == ' ' && fields.back().empty())) {
      fields.back() += c;
    }
  }
  return fields;
}

struct Source {
  std::size_t field = 0;
  double factor = 1;
};

Source find_column(std::vector<std::string> const& header, ColumnRequest const& request, std::string const& place) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < header.size(); ++i) {
    std::string const& heading = header[i];
    std::size_t const open = heading.find('[');
    std::string name = heading.substr(0, open);
    name.erase(name.find_last_not_of(' ') + 1);
    names.push_back(name);
    if (name != request.name) {
      continue;
    }
    std::size_t const close = heading.find(']');
    auto const unit = open < close && close != std::string::npos
                          ? parse_unit(std::string_view(heading).substr(open + 1, close - open - 1))
                          : std::nullopt;
    if (!unit || unit->exponents != request.dimension.exponents) {
      throw InputError(place, request.name,
                       fmt::format("heading '{}' has no unit of {}", heading, request.dimension.name),
                       fmt::format("write the unit in square brackets, as in \"{} [{}]\"", request.name,
                                   si_unit(request.dimension.exponents)));
    }
    return {i, unit->value};
  }
  throw InputError(place, request.name, "column is missing", suggestion(request.name, names));
}

}  // namespace

std::vector<std::vector<double>> read_columns(std::filesystem::path const& file,
                                              std::vector<ColumnRequest> const& requests) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw InputError(file.string(), "file", "cannot be read", "give a path relative to the scene's folder");
  }
  std::vector<std::vector<double>> columns(requests.size());
  std::vector<Source> sources;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    if (line.empty() || line.front() == '#') {
      continue;
    }
    auto const fields = split(line);
    std::string const place = fmt::format("{}:{}", file.string(), number);
    if (sources.empty()) {
      for (auto const& request : requests) {
        sources.push_back(find_column(fields, request, place));
      }
      continue;
    }
    for (std::size_t i = 0; i < requests.size(); ++i) {
      auto const value = sources[i].field < fields.size() ? parse_quantity(fields[sources[i].field]) : std::nullopt;
      if (!value || value->has_unit || !std::isfinite(value->value)) {
        throw InputError(place, requests[i].name, "is not a finite number", "write plain numbers below the heading");
      }
      columns[i].push_back(value->value * sources[i].factor);
    }
  }
  if (sources.empty()) {
    throw InputError(file.string(), "file", "has no heading line", "start it with \"x [m],density [kg/m3],...\"");
  }
  return columns;
}

}  // namespace g27
