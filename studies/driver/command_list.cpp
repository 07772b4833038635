#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "riemann/eos/factory.hpp"
#include "studies/driver/benchmark.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/document.hpp"
#include "studies/driver/figure_needs.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/python.hpp"
#include "studies/driver/scene_reader.hpp"
#include "studies/driver/study.hpp"
#include "verification/cases/case.hpp"
#include "verification/exact/oracle.hpp"

namespace g27 {
namespace {

struct Item {
  std::string name, what;
};

std::vector<Item> list_scenes() {
  std::vector<Item> items;
  for (auto const& name : scene_names()) {
    Document const document = read_document(find_scene(name));
    Node const* title = document.root.find("title");
    auto const* text = title != nullptr ? std::get_if<std::string>(&title->value) : nullptr;
    items.push_back({name, text != nullptr ? *text : ""});
  }
  return items;
}

std::vector<Item> list_eos() {
  std::vector<Item> items;
  for (auto const& name : eos_names()) {
    std::string parameters;
    for (auto const& p : eos_parameters(name)) {
      parameters += fmt::format("{}{} [{}]", parameters.empty() ? "" : ", ", p.name, p.unit);
    }
    items.push_back({name, eos_title(name) + "; " + parameters});
  }
  return items;
}

std::vector<Item> list_schemes() {
  return {{"godunov", "order 1: cell states"},
          {"linear", "order 2: linear profile sampled where the characteristics start"},
          {"parabolic", "order 3: parabola averaged over what each characteristic sweeps"},
          {"muscl", "MUSCL-Hancock with van Leer slopes, for comparison"}};
}

std::vector<Item> list_figures() {
  std::vector<Item> items;
  for (auto const& name : figure_names()) {
    items.push_back({name, figure_title(figure_script(name))});
  }
  return items;
}

template <class Table, class What>
std::vector<Item> items_of(Table const& table, What what) {
  std::vector<Item> items;
  for (auto const& entry : table) {
    items.push_back({entry.name, what(entry)});
  }
  return items;
}

/// Title, and what --set may change.
std::string case_text(Case const& c) {
  std::string text = c.title;
  for (CaseParameter const& p : c.parameters) {
    text += fmt::format("{}{} = {:g}{}: {}", &p == c.parameters.data() ? " [--set " : "; ", p.name, p.value,
                        p.unit == "1" ? "" : " " + p.unit, p.what);
  }
  return c.parameters.empty() ? text : text + "]";
}

struct Kind {
  std::string name;
  std::function<std::vector<Item>()> list;
};

std::vector<Kind> kinds() {
  return {{"scenes", list_scenes},
          {"cases", [] { return items_of(all_cases(), case_text); }},
          {"studies", [] { return items_of(all_studies(), [](Study const& s) { return s.claim; }); }},
          {"exact", [] { return items_of(all_oracles(), [](Oracle const& o) { return o.summary; }); }},
          {"eos", list_eos},
          {"schemes", list_schemes},
          {"figures", list_figures},
          {"benchmarks", [] { return items_of(all_benchmarks(), [](Benchmark const& b) { return b.what; }); }}};
}

}  // namespace

int command_list(ListArguments const& arguments) {
  auto chosen = kinds();
  if (!arguments.kind.empty()) {
    chosen = {find_by_name(chosen, arguments.kind, "g27 list")};
  }
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (Kind const& kind : chosen) {
    auto const items = kind.list();
    std::size_t width = 0;
    for (Item const& item : items) {
      width = std::max(width, item.name.size());
    }
    if (!arguments.json) {
      fmt::print("{}\n", kind.name);
    } else {
      json[kind.name] = nlohmann::ordered_json::array();
    }
    for (Item const& item : items) {
      if (arguments.json) {
        json[kind.name].push_back({{"name", item.name}, {"what", item.what}});
      } else {
        fmt::print("  {:{}}  {}\n", item.name, width, item.what);
      }
    }
  }
  if (arguments.json) {
    fmt::print("{}\n", json.dump(2));
  }
  return 0;
}

}  // namespace g27
