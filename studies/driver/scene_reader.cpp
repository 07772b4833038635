#include "studies/driver/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "studies/driver/nearest_key.hpp"
#include "studies/driver/provenance.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

std::vector<std::string> const root_keys{"title",   "source", "name",   "time",    "scheme", "domain", "material",
                                         "ambient", "region", "charge", "initial", "output", "expect", "variant"};

/// Lays `over` onto `base`: tables merge, everything else replaces.
void merge(Node& base, Node const& over) {
  auto* table = std::get_if<Node::Table>(&base.value);
  auto const* changes = std::get_if<Node::Table>(&over.value);
  if (table == nullptr || changes == nullptr) {
    base = over;
    return;
  }
  for (auto const& change : *changes) {
    auto const entry =
        std::find_if(table->begin(), table->end(), [&](NodeEntry const& e) { return e.key == change.key; });
    if (entry == table->end()) {
      table->push_back(change);
    } else {
      merge(entry->node, change.node);
    }
  }
}

std::string slug(std::string const& text) {
  std::string out;
  for (char const c : text) {
    bool const plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
    if (plain) {
      out += c;
    } else if (!out.empty() && out.back() != '-') {
      out += '-';
    }
  }
  return out;
}

void check_domain(Section const& domain, GasLineSetup const& setup) {
  using Kind = GasBoundary::Kind;
  bool const curved = setup.symmetry != Symmetry::planar;
  if (curved && setup.faces.front() < 0) {
    throw domain.error("extent", "starts below 0 in curved symmetry", "start at \"0 cm\" or beyond");
  }
  if (curved && setup.faces.front() == 0 && setup.left.kind != Kind::wall) {
    throw domain.error("boundary", "left is the axis or centre", "write left = \"wall\" there");
  }
  if ((setup.left.kind == Kind::periodic) != (setup.right.kind == Kind::periodic)) {
    throw domain.error("boundary", "is periodic on one side only", "make both sides \"periodic\"");
  }
  if (setup.left.kind == Kind::periodic && (curved || setup.motion.kind == MeshMotion::Kind::lagrangian)) {
    throw domain.error("boundary", "cannot be periodic here", "use planar symmetry and a mesh that is not Lagrangian");
  }
  bool const piston = setup.left.kind == Kind::piston || setup.right.kind == Kind::piston;
  if (piston && setup.motion.kind != MeshMotion::Kind::stretched && setup.motion.kind != MeshMotion::Kind::lagrangian) {
    throw domain.error("motion", "does not follow the piston", "write motion = \"stretched\" or \"lagrangian\"");
  }
}

std::vector<SceneRun> read_variant(Reading& reading, Node const& tree, std::string const& variant) {
  Section const root(reading, tree, "", root_keys);
  SceneRun run;
  run.variant = variant;

  Section const domain = root.table("domain", {"symmetry", "extent", "cells", "cell", "mesh", "motion", "boundary"});
  run.setup.eos = read_eos(root);
  run.setup.symmetry = static_cast<Symmetry>(domain.choice("symmetry", symmetry_names(), 0));
  run.setup.faces = read_faces(domain);
  double const left = run.setup.faces.front(), right = run.setup.faces.back();
  run.setup.motion = read_motion(domain, left, right);
  run.setup.left = read_boundary(domain, "left", run.setup.eos);
  run.setup.right = read_boundary(domain, "right", run.setup.eos);
  check_domain(domain, run.setup);

  InitialData const data = read_initial(root, run.setup.eos, run.setup.symmetry, left, right);
  run.initial = data.state;
  run.start = data.start.value_or(0);
  if (run.start > 0 && run.setup.motion.kind != MeshMotion::Kind::fixed) {
    throw domain.error("motion", "is not possible with a charge", "remove it: charges use a fixed mesh");
  }

  Section const time = root.table("time", {"end", "cfl"});
  run.end = time.positive("end", dimension::time);
  if (run.end <= run.start) {
    throw time.error("end", fmt::format("{} s is not after the start at {} s", run.end, run.start), "make it later");
  }
  double const cfl = time.quantity("cfl", dimension::number, GasSchemeOptions{}.cfl);
  if (!(cfl > 0 && cfl <= 1)) {
    throw time.error("cfl", fmt::format("{} is out of range", cfl), "choose it above 0 and up to 1");
  }
  run.output = read_output(root, run.start, run.end, left, right);

  std::vector<SceneRun> runs;
  for (GasSchemeOptions const& options : read_schemes(root, cfl)) {
    run.setup.options = options;
    run.scheme = predictor_names()[static_cast<std::size_t>(options.predictor)];
    run.name = slug(variant) + "-" + run.scheme;
    runs.push_back(run);
  }
  return runs;
}

}  // namespace

Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  Document document = read_document(file);
  for (std::string const& assignment : overrides) {
    set_value(document, assignment);
  }
  Reading reading{.file = document.file, .bare_numbers = {}};
  Section const root(reading, document.root, "", root_keys);
  Scene scene;
  scene.file = file;
  scene.name = file.stem().string();
  scene.text = document.text;
  scene.overrides = overrides;
  scene.title = root.text("title");
  scene.source = root.text("source", "");

  Node base = document.root;
  std::erase_if(std::get<Node::Table>(base.value), [](NodeEntry const& e) { return e.key == "variant"; });
  std::vector<std::string> variants{root.text("name", "main")};
  scene.runs = read_variant(reading, base, variants[0]);
  std::vector<std::string> const variant_keys{"name",   "time",   "scheme",  "domain", "ambient",
                                              "region", "charge", "initial", "output"};
  for (Section const& section : root.tables("variant", variant_keys)) {
    std::string const name = section.text("name");
    for (std::string const& other : variants) {
      if (slug(other) == slug(name)) {
        throw section.error("name", fmt::format("'{}' is taken or empty", name), "give each variant its own name");
      }
    }
    variants.push_back(name);
    Node tree = base;
    merge(tree, section.node());
    auto runs = read_variant(reading, tree, name);
    std::move(runs.begin(), runs.end(), std::back_inserter(scene.runs));
  }
  if (slug(variants[0]).empty()) {
    throw root.error("name", "has no letter or digit", "name the run in plain letters");
  }
  scene.expect = read_expectations(root, variants);
  scene.bare_numbers = reading.bare_numbers;
  return scene;
}

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  std::filesystem::path const folder = std::filesystem::path(build_facts().source_dir) / "studies/scenes";
  if (std::filesystem::is_directory(folder)) {
    for (auto const& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() == ".toml") {
        names.push_back(entry.path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::filesystem::path find_scene(std::string const& path_or_name) {
  if (std::filesystem::is_regular_file(path_or_name)) {
    return path_or_name;
  }
  auto const names = scene_names();
  if (std::find(names.begin(), names.end(), path_or_name) != names.end()) {
    return std::filesystem::path(build_facts().source_dir) / "studies/scenes" / (path_or_name + ".toml");
  }
  throw InputError(path_or_name, "scene", "no such file and no scene of that name", suggestion(path_or_name, names));
}

}  // namespace g27
