#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "fsi/surface/remesh.hpp"
#include "fsi/surface/repair.hpp"
#include "fsi/surface/shapes.hpp"
#include "fsi/surface/stl_file.hpp"
#include "studies/driver/atomic_file.hpp"
#include "studies/driver/command.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/stl_report.hpp"
#include "studies/driver/units.hpp"

namespace g27 {
namespace {

constexpr char const* here = "g27 stl";

/// A positive quantity of the command line, SI.
double positive(std::string const& key, std::string const& text, Dimension const& dimension) {
  auto const quantity = parse_quantity(text);
  std::string const remedy = fmt::format("give a {} such as '{}'", dimension.name, dimension.example);
  if (!quantity || (quantity->has_unit && quantity->exponents != dimension.exponents)) {
    throw InputError(here, key, fmt::format("'{}' is no {}", text, dimension.name), remedy);
  }
  if (!(quantity->value > 0) || !std::isfinite(quantity->value)) {
    throw InputError(here, key, fmt::format("'{}' is not positive", text), remedy);
  }
  return quantity->value;
}

std::optional<double> optional_positive(std::string const& key, std::string const& text, Dimension const& dimension) {
  return text.empty() ? std::nullopt : std::optional(positive(key, text, dimension));
}

double unit_of(std::string const& name) {
  auto const unit = parse_unit(name);
  if (!unit || unit->exponents != dimension::length.exponents) {
    throw InputError(here, "--unit", fmt::format("'{}' is no unit of length", name), "give m, cm, mm or um");
  }
  return unit->value;
}

TriangleSurface make(StlArguments const& arguments) {
  Shape const shape = find_by_name(all_shapes(), arguments.make, "g27 stl --make");
  std::vector<std::string> known;
  for (ShapeParameter const& p : shape.parameters) known.push_back(p.name);
  std::map<std::string, double> values;
  for (std::string const& word : arguments.set) {
    auto const equals = word.find('=');
    std::string const key = word.substr(0, equals);
    if (equals == std::string::npos || std::find(known.begin(), known.end(), key) == known.end()) {
      throw InputError(here, "--set " + word, fmt::format("is no length of a {}", shape.name), suggestion(key, known));
    }
    if (!values.emplace(key, positive("--set " + key, word.substr(equals + 1), dimension::length)).second) {
      throw InputError(here, "--set " + key, "is given twice", "give each length once");
    }
  }
  for (ShapeParameter const& p : shape.parameters) {
    if (!values.contains(p.name)) {
      throw InputError(here, "--make " + shape.name, fmt::format("needs {} ({})", p.name, p.what),
                       fmt::format("add --set {}='{}'", p.name, p.example));
    }
  }
  return shape.make(values);
}

/// The surface as single precision, in which STL files are written, leaves it.
TriangleSurface rounded(TriangleSurface const& surface, double unit) {
  return weld(parse_stl(binary_stl(surface, unit)).facets, unit);
}

class StlCommand {
 public:
  explicit StlCommand(StlArguments const& arguments) : a_(arguments) {
    if (a_.file.empty() == a_.make.empty()) {
      throw InputError(here, "file", "there is nothing to examine", "give an STL file, or --make and a shape");
    }
    if (!a_.out.empty() && a_.make.empty() && a_.remesh.empty()) {
      throw InputError(here, "--out", "there is nothing to write", "add --remesh, or use --repair FILE");
    }
    if (a_.make.empty() && !a_.set.empty()) {
      throw InputError(here, "--set", "belongs to --make", "leave it out for a file");
    }
    if (!a_.remesh.empty() && !a_.repair_out.empty() && (a_.out.empty() || a_.out == a_.repair_out)) {
      throw InputError(here, "--repair", "takes the surface before it is meshed anew",
                       "name another file for the one after it by --out");
    }
    report_.unit_assumed = a_.unit.empty();
    if (!a_.unit.empty()) report_.unit_name = a_.unit;
    report_.unit = unit_of(report_.unit_name);
    report_.density = optional_positive("--density", a_.density, dimension::density);
    report_.cell = optional_positive("--cell", a_.cell, dimension::length);
    edge_ = optional_positive("--remesh", a_.remesh, dimension::length);
  }

  int run() {
    load();
    if (!a_.repair_out.empty()) repair_surface();
    if (edge_ && report_.diagnosis.healthy()) remesh_surface();
    if (!a_.out.empty() && report_.diagnosis.healthy()) write("--out", a_.out);
    if (!report_.diagnosis.healthy() && !(a_.repair_out.empty() && a_.out.empty())) {
      fmt::print(stderr, "the surface is still faulty: no file is written\n");
    }
    if (a_.json) {
      fmt::print("{}\n", to_json(report_).dump(2));
    } else {
      fmt::print("{}", to_text(report_));
    }
    return report_.diagnosis.healthy() ? 0 : 1;
  }

 private:
  void load() {
    if (!a_.make.empty()) {
      report_.source = a_.make;
      report_.unit_assumed = false;
      adopt(rounded(make(a_), report_.unit));
      return;
    }
    StlFile const file = read_stl(a_.file);
    report_.source = fmt::format("{}: {}, {} facets in {} {}", a_.file, file.binary ? "binary" : "ASCII",
                                 file.facets.size(), file.solids, file.solids == 1 ? "solid" : "solids");
    report_.remarks = file.remarks;
    adopt(weld(file.facets, report_.unit));
  }

  void adopt(TriangleSurface surface) {
    report_.surface = std::move(surface);
    report_.diagnosis = diagnose(report_.surface);
    report_.origin.resize(report_.surface.size());
    std::iota(report_.origin.begin(), report_.origin.end(), 0);
  }

  void repair_surface() {
    report_.found = report_.diagnosis.findings;
    Repair done = repair(report_.surface);
    report_.repaired = done.steps;
    if (done.surface.size() == 0) return;  // nothing is left: the findings stand
    if (done.diagnosis.healthy()) {
      adopt(rounded(done.surface, report_.unit));
      if (report_.diagnosis.healthy()) write("--repair", a_.repair_out);
      return;
    }
    // Triangles keep the numbers that they have in the file.
    for (SurfaceFinding& f : done.diagnosis.findings) {
      for (int& t : f.triangles) t = done.origin[static_cast<std::size_t>(t)];
      std::erase(f.triangles, -1);
    }
    report_.surface = std::move(done.surface);
    report_.diagnosis = std::move(done.diagnosis);
    report_.origin = std::move(done.origin);
  }

  void remesh_surface() {
    double const volume = mass_properties(report_.surface).volume;
    adopt(rounded(remesh(report_.surface, {.edge = *edge_}), report_.unit));
    report_.volume_before_remeshing = volume;
  }

  void write(std::string const& option, std::string const& file) {
    if (std::error_code none; std::filesystem::equivalent(file, a_.file, none)) {
      throw InputError(here, option, fmt::format("{} is the file that is examined", file), "choose another file");
    }
    try {
      write_atomically(file, binary_stl(report_.surface, report_.unit));
    } catch (OutputError const& error) {
      throw InputError(here, option, error.what(), "choose another file");
    }
    report_.written.push_back(file);
  }

  StlArguments const& a_;
  StlReport report_;
  std::optional<double> edge_;
};

}  // namespace

int command_stl(StlArguments const& arguments) {
  try {
    return StlCommand(arguments).run();
  } catch (SurfaceError const& error) {
    throw InputError(arguments.file.empty() ? here : arguments.file,
                     arguments.file.empty() ? "--make " + arguments.make : "surface", error.problem, error.remedy);
  }
}

}  // namespace g27
