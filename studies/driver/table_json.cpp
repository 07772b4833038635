#include "studies/driver/table_json.hpp"

#include <nlohmann/json.hpp>

#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/provenance.hpp"

namespace g27 {

nlohmann::ordered_json to_json(Table const& table) {
  using Json = nlohmann::ordered_json;
  auto const of = [](Value const& value) { return std::visit([](auto const& v) { return Json(v); }, value); };
  Json out{{"title", table.title}, {"columns", Json::array()}, {"rows", Json::array()}, {"facts", Json::object()}};
  for (Column const& column : table.columns) {
    out["columns"].push_back({{"name", column.name}, {"unit", column.unit}});
  }
  for (auto const& row : table.rows) {
    Json object = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      object[table.columns[i].name] = of(row[i]);
    }
    out["rows"].push_back(std::move(object));
  }
  for (auto const& [name, value] : table.facts) {
    out["facts"][name] = of(value);
  }
  return out;
}

void write_tables(std::filesystem::path const& file, std::vector<Table> const& tables) {
  Hdf5Writer out;
  for (Table const& table : tables) {
    std::string const group = "/" + table.name;
    out.group(group);
    out.attribute(group, "title", table.title);
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      std::string const path = group + "/" + table.columns[c].name;
      std::vector<double> numbers;
      std::vector<std::string> texts;
      for (auto const& row : table.rows) {
        if (auto const* text = std::get_if<std::string>(&row[c])) {
          texts.push_back(*text);
        } else {
          auto const* whole = std::get_if<long>(&row[c]);
          numbers.push_back(whole != nullptr ? static_cast<double>(*whole) : std::get<double>(row[c]));
          texts.push_back(std::to_string(numbers.back()));
        }
      }
      if (numbers.size() == table.rows.size()) {
        out.write(path, numbers, table.columns[c].unit);
      } else {
        out.write_texts(path, texts);
      }
    }
    for (auto const& [name, value] : table.facts) {
      if (auto const* text = std::get_if<std::string>(&value)) {
        out.attribute(group, name, *text);
      } else {
        auto const* whole = std::get_if<long>(&value);
        out.attribute(group, name, whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value));
      }
    }
  }
  for (auto const& [name, value] : provenance(1)) {
    out.write_text("/provenance/" + name, value);
  }
  out.save(file);
}

void write_csv(std::filesystem::path const& folder, Table const& table) {
  write_atomically(folder / (table.name + ".csv"), to_csv(table));
}

}  // namespace g27
