#include "studies/driver/scene_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/surface/gap.hpp"
#include "studies/driver/nearest_key.hpp"
#include "studies/driver/provenance.hpp"
#include "studies/driver/scene_digest.hpp"
#include "studies/driver/scene_grid_parts.hpp"

namespace g27 {
namespace {

std::vector<std::string> const root_keys{"title",    "source",  "name",   "time",   "scheme",  "domain",
                                         "material", "ambient", "region", "charge", "initial", "output",
                                         "expect",   "variant", "block",  "start",  "body"};

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

/// Whether the cell that x lies in is of the block.
bool covers(SolidBlock const& block, GridBox const& box, Vec3 const& x) {
  for (std::size_t d = 0; d < 3; ++d) {
    double const at = (x[d] - box.lower[d]) / (box.upper[d] - box.lower[d]) * box.cells[d];
    int const cell = std::clamp(static_cast<int>(at), 0, box.cells[d] - 1);
    if (cell < block.first[d] || cell >= block.last[d]) return false;
  }
  return true;
}

/// A probe that a body or a block covers measures nothing there.
std::vector<std::string> covered_probes(GridRun const& grid, GridBox const& box, OutputPlan const& output) {
  std::vector<std::string> out;
  for (Probe const& probe : output.probes) {
    for (SceneBody const& body : grid.bodies) {
      if (within(probe.position, body.whole)) {
        out.push_back(fmt::format("output.probe: '{}' lies in the body '{}' at the start: it has no values (NaN) there",
                                  probe.name, body.name));
      }
    }
    for (std::size_t n = 0; n < grid.setup.blocks.size(); ++n) {
      if (covers(grid.setup.blocks[n], box, probe.position)) {
        out.push_back(fmt::format("output.probe: '{}' lies in block.{}: its values are 0 there", probe.name, n));
      }
    }
  }
  return out;
}

/// CFL number up to `most`, if one is given.
std::optional<double> read_cfl(Section const& time, std::string const& key, double most) {
  if (!time.has(key)) return {};
  double const cfl = time.quantity(key, dimension::number);
  if (!(cfl > 0 && cfl <= most)) {
    throw time.error(key, fmt::format("{} is out of range", cfl),
                     fmt::format("choose it above 0 and up to {:g}", most));
  }
  return cfl;
}

/// [time]: sets the end.
Section read_time(Section const& root, SceneRun& run) {
  std::vector<std::string> keys{"end", "cfl"};
  if (root.has("body")) keys.emplace_back("body_cfl");
  Section const time = root.table("time", keys);
  run.end = time.positive("end", dimension::time);
  if (run.end <= run.start) {
    throw time.error("end", fmt::format("{} s is not after the start at {} s", run.end, run.start), "make it later");
  }
  return time;
}

void name_run(SceneRun& run, Predictor predictor) {
  run.scheme = predictor_names()[static_cast<std::size_t>(predictor)];
  run.name = slug(run.variant) + "-" + run.scheme;
}

/// An unburnt charge ends at a face: at a density between its own and the air's its energy belongs to no state.
void take_charge(Charge const& charge, SceneRun& run) {
  run.start = charge.begin, run.setup.burn = charge.burn;
  auto const& faces = run.setup.faces;
  bool const ends = std::any_of(faces.begin(), faces.end(),
                                [&](double x) { return std::fabs(x - charge.radius) <= 1e-9 * charge.radius; });
  if (charge.burn.there() && !ends) {
    throw charge.section.error("radius", fmt::format("{} m is no face of the mesh, as ignition needs", charge.radius),
                               "choose domain.cell so that the radius is a whole number of cells");
  }
}

void check_delays(Charge const& charge, double end) {
  for (IgnitionPoint const& point : charge.ignition) {
    if (point.time >= end) {
      throw charge.section.error("delay", fmt::format("{} s is not before the end at {} s", point.time, end),
                                 "light it sooner, or set time.end later");
    }
  }
}

/// The wave at breakout knows no body, and the grids at a body's surface know no burn.
void keep_from_charge(Charge const& charge, std::vector<SceneBody> const& bodies, double cell) {
  for (SceneBody const& body : bodies) {
    if (!charge.burn.there()) {
      if (distance_to_body(charge.centre, body.whole) < charge.radius) {
        throw charge.section.error("radius", fmt::format("reaches into the body '{}'", body.name),
                                   "move the body away: the exact wave at breakout holds in products alone");
      }
      continue;
    }
    if (distance_to_body(charge.centre, body.whole) < charge.radius + side_gap_cells * cell) {
      throw charge.section.error(
          "start", fmt::format("is ignition, and '{}' is within {} cells of the charge", body.name, side_gap_cells),
          "start at breakout, or move the body away");
    }
  }
}

/// One dimension.
std::vector<SceneRun> read_line_runs(Section const& root, SceneRun run) {
  for (char const* key : {"block", "start", "body"}) {
    if (root.has(key)) {
      bool const body = std::string(key) == "body";
      throw root.error(key, body ? "needs three dimensions" : "is for two and three dimensions",
                       "remove it, or give domain.extent = [[...], [...]] with an interval for each axis");
    }
  }
  Section const domain = root.table("domain", {"symmetry", "extent", "cells", "cell", "mesh", "motion", "boundary"});
  run.setup.eos = read_eos(root);
  run.setup.symmetry = static_cast<Symmetry>(domain.choice("symmetry", symmetry_names(), 0));
  run.setup.faces = read_faces(domain);
  double const left = run.setup.faces.front(), right = run.setup.faces.back();
  run.setup.motion = read_motion(domain, left, right);
  run.setup.left = read_boundary(domain, "left", run.setup.eos);
  run.setup.right = read_boundary(domain, "right", run.setup.eos);
  check_domain(domain, run.setup);

  InitialData const data = read_initial(root, run.setup.eos, run.setup.symmetry, run.setup.faces);
  run.initial = data.state;
  if (data.charge) take_charge(*data.charge, run);
  if (data.charge && run.setup.motion.kind != MeshMotion::Kind::fixed) {
    throw domain.error("motion", "is not possible with a charge", "remove it: charges use a fixed mesh");
  }
  double const cfl = read_cfl(read_time(root, run), "cfl", 1).value_or(GasSchemeOptions{}.cfl);
  run.output = read_output(root, run.start, run.end, {.lower = {left, 0, 0}, .upper = {right, 0, 0}});
  if (data.charge) run.output.remarks = mass_remarks(*data.charge, run.setup.symmetry, run.setup.faces);
  std::vector<SceneRun> runs;
  for (GasSchemeOptions const& options : read_schemes(root, cfl)) {
    run.setup.options = options;
    name_run(run, options.predictor);
    runs.push_back(run);
  }
  return runs;
}

/// Two or three dimensions.
std::vector<SceneRun> read_grid_runs(Section const& root, SceneRun run) {
  Section const domain =
      root.table("domain", {"extent", "cells", "cell", "boundary", "patch", "symmetry", "mesh", "motion"});
  GridBox const box = read_box(domain);
  int const dimensions = dimensions_of(box);
  GridRun grid;
  grid.setup.eos = read_eos(root);
  grid.setup.lower = box.lower, grid.setup.upper = box.upper, grid.setup.cells = box.cells;
  grid.setup.sides = read_sides(domain, grid.setup.eos, dimensions);
  grid.setup.patches = read_patches(domain, grid.setup.eos, box);
  grid.setup.blocks = read_blocks(root, box);
  GridRegions const regions = read_regions(root, grid.setup.eos, dimensions);
  check_covers(regions, grid.setup.blocks, box);
  if (regions.charge) {
    run.start = regions.charge->begin, grid.setup.burn = burn_around(*regions.charge, grid.setup);
  }
  Section const time = read_time(root, run);
  if (regions.charge) check_delays(*regions.charge, run.end);
  std::optional<double> const cfl = read_cfl(time, "cfl", 1);
  grid.cfl = cfl.value_or(0), grid.body_cfl = read_cfl(time, "body_cfl", largest_body_cfl).value_or(grid.cfl);
  grid.initial = make_initial(regions.list, grid.setup.eos, dimensions);
  grid.point = make_point_initial(regions.list);
  grid.bodies = read_bodies(root, grid.setup, grid.point);
  if (regions.charge) keep_from_charge(*regions.charge, grid.bodies, (box.upper[0] - box.lower[0]) / box.cells[0]);
  grid.line = read_line_start(root, regions, grid, run.start, run.end);
  std::vector<std::string> names;
  for (SceneBody const& body : grid.bodies) names.push_back(body.name);
  run.output = read_output(root, run.start, run.end, {box.lower, box.upper, dimensions, names});
  if (grid.line && (!root.has("output") || root.need("output", "").find("origin") == nullptr)) {
    run.output.origin = grid.line->centre;
  }
  run.output.remarks = covered_probes(grid, box, run.output);
  if (regions.charge && !grid.line) {
    auto const more = mass_remarks(*regions.charge, regions.list.back().distance, grid.setup);
    run.output.remarks.insert(run.output.remarks.end(), more.begin(), more.end());
  }

  std::vector<SceneRun> runs;
  if (!grid.bodies.empty()) read_scheme_of_bodies(root, grid);
  for (SceneBody const& body : grid.bodies) {
    if (!grid.closure || !body.setup.clamps.any()) continue;
    throw root.error("scheme", fmt::format("asks for closure, but '{}' has momentum from its clamp as well", body.name),
                     "write closure = false, or leave out clamped");
  }
  for (GridSchemeOptions options : read_grid_schemes(root, cfl.value_or(GasSchemeOptions{}.cfl), dimensions)) {
    if (!grid.bodies.empty()) check_schemes_of_bodies(root, options, grid.body_cfl);
    options.maps = run.output.repairs;
    grid.setup.options = options;
    if (grid.line) {
      GasSchemeOptions& line = grid.line->setup.options;
      line.predictor = options.predictor, line.monotonicity = options.monotonicity, line.riemann = options.riemann;
      line.linear_star = options.linear_star, line.cfl = options.cfl;
    }
    run.grid = grid;
    name_run(run, options.predictor);
    runs.push_back(run);
  }
  return runs;
}

std::vector<SceneRun> read_variant(Reading& reading, Node const& tree, std::string const& variant) {
  Section const root(reading, tree, "", root_keys);
  SceneRun run;
  run.variant = variant;
  Node const& domain = root.need("domain", "{ ... }");
  std::vector<std::string> every_key;
  if (auto const* table = std::get_if<Node::Table>(&domain.value)) {
    std::transform(table->begin(), table->end(), std::back_inserter(every_key),
                   [](NodeEntry const& e) { return e.key; });
  }
  return is_grid(root.table("domain", every_key)) ? read_grid_runs(root, run) : read_line_runs(root, run);
}

}  // namespace

Document read_overridden(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  Document document = read_document(file);
  for (std::string const& assignment : overrides) {
    bool const short_form = assignment.starts_with("skip=");  // the one key worth a shorter name on the command line
    set_value(document, (short_form ? "scheme." : "") + assignment);
  }
  return document;
}

Scene read_scene(std::filesystem::path const& file, std::vector<std::string> const& overrides) {
  Document const document = read_overridden(file, overrides);
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
  std::vector<Node> trees{base};
  std::vector<std::string> const variant_keys{"name",   "time",    "scheme", "domain", "ambient", "region",
                                              "charge", "initial", "output", "block",  "start",   "body"};
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
    trees.push_back(std::move(tree));
    if (runs[0].dimensions() != scene.runs[0].dimensions()) {
      throw section.error(
          "domain", fmt::format("has {} dimensions, the scene {}", runs[0].dimensions(), scene.runs[0].dimensions()),
          "write another scene for it");
    }
    std::move(runs.begin(), runs.end(), std::back_inserter(scene.runs));
  }
  if (slug(variants[0]).empty()) {
    throw root.error("name", "has no letter or digit", "name the run in plain letters");
  }
  double latest = 0;
  for (SceneRun const& run : scene.runs) latest = std::max(latest, run.end);
  for (Node const& tree : trees) {
    check_snapshots(Section(reading, tree, "", root_keys), scene.runs[0].dimensions(), latest);
  }
  check_probes_seen(root, scene.runs);
  scene.expect = read_expectations(root, variants, scene.runs);
  scene.bare_numbers = reading.bare_numbers;
  scene.digest = scene_digest(document.root, scene.runs);
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
