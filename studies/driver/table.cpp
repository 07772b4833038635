#include "studies/driver/table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace g27 {
namespace {

std::string brief(Value const& value) {
  if (auto const* text = std::get_if<std::string>(&value)) {
    return *text;
  }
  if (auto const* number = std::get_if<double>(&value)) {
    return fmt::format("{:.4g}", *number);
  }
  return std::to_string(std::get<long>(value));
}

std::string quoted(std::string const& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) {
    return text;
  }
  std::string out = "\"";
  for (char const c : text) {
    out += c == '"' ? std::string("\"\"") : std::string(1, c);
  }
  return out + '"';
}

std::string full(Value const& value) {
  auto const* number = std::get_if<double>(&value);
  return number != nullptr ? fmt::format("{}", *number) : quoted(brief(value));
}

std::string heading(Column const& column) {
  return column.unit.empty() || column.unit == "1" ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

/// Columns of display: code points, since units may hold a Greek letter.
std::size_t display_width(std::string const& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace

std::string to_text(Table const& table) {
  std::vector<std::vector<std::string>> lines(1);
  for (Column const& column : table.columns) {
    lines[0].push_back(heading(column));
  }
  std::vector<bool> numeric(table.columns.size(), true);
  for (auto const& row : table.rows) {
    auto& line = lines.emplace_back();
    for (std::size_t i = 0; i < row.size(); ++i) {
      line.push_back(brief(row[i]));
      numeric[i] = numeric[i] && !std::holds_alternative<std::string>(row[i]);
    }
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (auto const& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], display_width(line[i]));
    }
  }
  std::string out = table.title.empty() ? "" : table.title + "\n";
  for (auto const& line : lines) {
    std::string text;
    for (std::size_t i = 0; i < line.size(); ++i) {
      std::string const pad(widths[i] - display_width(line[i]), ' ');
      text += (i > 0 ? "  " : "") + (numeric[i] ? pad + line[i] : line[i] + pad);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  }
  for (auto const& [name, value] : table.facts) {
    out += fmt::format("{}: {}\n", name, brief(value));
  }
  return out;
}

std::string to_csv(Table const& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    out += (i > 0 ? "," : "") + quoted(heading(table.columns[i]));
  }
  out += '\n';
  for (auto const& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      out += (i > 0 ? "," : "") + full(row[i]);
    }
    out += '\n';
  }
  return out;
}

}  // namespace g27
