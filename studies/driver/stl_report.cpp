#include "studies/driver/stl_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

namespace g27 {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// "4, 7, 9 and 12 more"
std::string list_text(std::vector<int> const& ids) {
  constexpr std::size_t most = 10;
  std::string out;
  for (std::size_t i = 0; i < std::min(ids.size(), most); ++i) out += fmt::format("{}{}", i > 0 ? ", " : "", ids[i]);
  return ids.size() > most ? out + fmt::format(" and {} more", ids.size() - most) : out;
}

std::string finding_text(SurfaceFinding const& f) {
  return fmt::format("  {}: {}, at triangles {}\n    -> {}\n", fault_name(f.fault), f.count, list_text(f.triangles),
                     fault_remedy(f.fault));
}

/// Shares of edges within two ranges of the cell size: what the method wants, and what it works with.
struct CellFit {
  double smallest, mean, largest;  ///< over the cell size
  double wanted, usable;           ///< shares
  double least_extent;             ///< of the body's box, in cells

  [[nodiscard]] std::string advice() const {
    if (usable < 1) return "outside 0.5 to 2 h the method loses accuracy or breaks: --remesh with the cell size";
    return wanted < 1 ? "usable; best is 0.7 to 1.2 h, by --remesh with the cell size" : "as wanted";
  }
};

CellFit cell_fit(StlReport const& r) {
  double const h = *r.cell;
  CellFit out{r.diagnosis.edges.smallest / h, r.diagnosis.edges.mean / h, r.diagnosis.edges.largest / h, 0, 0, 0};
  auto const lengths = edge_lengths(r.surface);
  for (double const l : lengths) {
    out.wanted += l >= 0.7 * h && l <= 1.2 * h;
    out.usable += l >= 0.5 * h && l <= 2 * h;
  }
  out.wanted /= static_cast<double>(lengths.size());
  out.usable /= static_cast<double>(lengths.size());
  Vec3 const size = r.diagnosis.box.upper - r.diagnosis.box.lower;
  out.least_extent = std::min({size[0], size[1], size[2]}) / h;
  return out;
}

/// What the body's size says about the unit; empty if nothing.
std::string unit_hint(StlReport const& r) {
  Vec3 const size = r.diagnosis.box.upper - r.diagnosis.box.lower;
  double const extent = std::max({size[0], size[1], size[2]});
  if (extent >= 1e-4 && extent <= 10) return {};
  std::string const other = extent > 10 ? "mm" : "m";
  return fmt::format("the body is {:.4g} m across: is {} the file's unit{}? (--unit)", extent, r.unit_name,
                     r.unit_name == other ? "" : ", or " + other);
}

nlohmann::ordered_json json_of(std::vector<SurfaceFinding> const& findings) {
  auto out = nlohmann::ordered_json::array();
  for (SurfaceFinding const& f : findings) {
    out.push_back({{"fault", fault_name(f.fault)},
                   {"count", f.count},
                   {"triangles", f.triangles},
                   {"remedy", fault_remedy(f.fault)}});
  }
  return out;
}

}  // namespace

std::string to_text(StlReport const& r) {
  double const u = r.unit;
  std::string const& m = r.unit_name;
  Diagnosis const& d = r.diagnosis;
  Vec3 const size = d.box.upper - d.box.lower;
  MassProperties const mass = mass_properties(r.surface, r.density.value_or(1));
  std::string out =
      fmt::format("{}; unit {}{}\n", r.source, m, r.unit_assumed ? ", assumed: STL files state none (--unit)" : "");
  auto line = [&out](std::string const& name, std::string const& what) {
    out += fmt::format("  {:<12}{}\n", name, what);
  };
  // round-off of the body's size is no place
  auto place = [&](double x) { return std::fabs(x) < 1e-14 * length(size) ? 0 : x / u; };
  auto point = [&](Vec3 const& x) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", place(x[0]), place(x[1]), place(x[2]));
  };
  line("triangles", fmt::format("{}, with {} vertices in {} {}", r.surface.size(), r.surface.vertices.size(), d.shells,
                                d.shells == 1 ? "shell" : "shells"));
  line("box", fmt::format("{:.6g} x {:.6g} x {:.6g} {}, from {} to {}", size[0] / u, size[1] / u, size[2] / u, m,
                          point(d.box.lower), point(d.box.upper)));
  line("area", fmt::format("{:.6g} {}2", mass.area / (u * u), m));
  bool const encloses = d.find(Fault::open_edge) == nullptr && d.find(Fault::non_manifold_edge) == nullptr &&
                        d.find(Fault::inconsistent_orientation) == nullptr &&
                        d.find(Fault::self_intersection) == nullptr;
  line("volume", fmt::format("{:.6g} {}3{}", mass.volume / (u * u * u), m,
                             encloses ? "" : ", of no meaning while the surface encloses no body: see below"));
  line("centroid", fmt::format("{} {}", point(mass.centroid), m));
  if (r.density) {
    line("mass", fmt::format("{:.6g} kg at {:.6g} kg/m3", mass.mass, *r.density));
    auto const& i = mass.inertia;
    line("inertia",
         fmt::format("xx {:.6g}, yy {:.6g}, zz {:.6g}, xy {:.3g}, xz {:.3g}, yz {:.3g} kg m2, about the centroid",
                     i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]));
  }
  line("edges",
       fmt::format("{:.4g} to {:.4g} {}, mean {:.4g}; the shortest at triangle {}", d.edges.smallest / u,
                   d.edges.largest / u, m, d.edges.mean / u, r.origin[static_cast<std::size_t>(d.edges.at_smallest)]));
  line("angles", fmt::format("{:.1f} to {:.1f} degrees between triangles, within the body", d.angles.smallest / degree,
                             d.angles.largest / degree));
  if (r.cell) {
    CellFit const fit = cell_fit(r);
    line("cell",
         fmt::format("h = {:.4g} {}: edges {:.2f} to {:.2f} h, mean {:.2f}; {:.1f} % within 0.7 to 1.2 h, {:.1f} % "
                     "within 0.5 to 2; the body is {:.1f} h thin",
                     *r.cell / u, m, fit.smallest, fit.largest, fit.mean, 100 * fit.wanted, 100 * fit.usable,
                     fit.least_extent));
    line("", fit.advice());
  }
  for (std::string const& remark : r.remarks) line("remark", remark);
  if (auto const hint = unit_hint(r); !hint.empty()) line("hint", hint);
  if (!r.found.empty()) {
    out += "found:\n";
    for (SurfaceFinding const& f : r.found)
      out += fmt::format("  {}: {}, at triangles {}\n", fault_name(f.fault), f.count, list_text(f.triangles));
  }
  if (!r.repaired.empty()) {
    out += "repaired:\n";
    for (RepairStep const& s : r.repaired) {
      out += fmt::format("  {}: {}{}\n", s.what, s.count,
                         s.triangles.empty() ? "" : ", triangles " + list_text(s.triangles));
    }
  }
  if (r.volume_before_remeshing) {
    out += fmt::format("remeshed: volume changed by {:.2g} %\n", 100 * (mass.volume / *r.volume_before_remeshing - 1));
    if (d.healthy() && r.written.empty()) out += "not written: give a file with --out\n";
  }
  if (d.healthy()) {
    out += "healthy: closed, manifold, oriented outward, free of self-intersections\n";
  } else {
    out += "faulty:\n";
    for (SurfaceFinding const& f : d.findings) out += finding_text(f);
  }
  for (std::string const& file : r.written) out += fmt::format("{}\n", file);
  return out;
}

nlohmann::ordered_json to_json(StlReport const& r) {
  Diagnosis const& d = r.diagnosis;
  MassProperties const mass = mass_properties(r.surface, r.density.value_or(1));
  nlohmann::ordered_json out{{"source", r.source},
                             {"unit", r.unit_name},
                             {"unit_assumed", r.unit_assumed},
                             {"triangles", r.surface.size()},
                             {"vertices", r.surface.vertices.size()},
                             {"shells", d.shells},
                             {"box", {d.box.lower, d.box.upper}},
                             {"area", mass.area},
                             {"volume", mass.volume},
                             {"centroid", mass.centroid}};
  if (r.density) {
    out["density"] = *r.density;
    out["mass"] = mass.mass;
    out["inertia"] = mass.inertia;
  }
  out["edges"] = {{"smallest", d.edges.smallest}, {"mean", d.edges.mean}, {"largest", d.edges.largest}};
  out["angles_deg"] = {{"smallest", d.angles.smallest / degree}, {"largest", d.angles.largest / degree}};
  if (r.cell) {
    CellFit const fit = cell_fit(r);
    out["cell"] = {{"size", *r.cell},
                   {"smallest", fit.smallest},
                   {"mean", fit.mean},
                   {"largest", fit.largest},
                   {"share_wanted", fit.wanted},
                   {"share_usable", fit.usable},
                   {"least_extent", fit.least_extent},
                   {"advice", fit.advice()}};
  }
  out["remarks"] = r.remarks;
  out["hint"] = unit_hint(r);
  out["found"] = json_of(r.found);
  out["repaired"] = nlohmann::ordered_json::array();
  for (RepairStep const& s : r.repaired) {
    out["repaired"].push_back({{"what", s.what}, {"count", s.count}, {"triangles", s.triangles}});
  }
  if (r.volume_before_remeshing) out["volume_change"] = mass.volume / *r.volume_before_remeshing - 1;
  out["faults"] = json_of(d.findings);
  out["healthy"] = d.healthy();
  out["written"] = r.written;
  return out;
}

}  // namespace g27
