#include "studies/driver/body_history.hpp"

#include <algorithm>
#include <cmath>

#include "scheme/grid/cell_place.hpp"

namespace g27 {
namespace {

struct VectorColumn {
  char const *name, *unit;
};
constexpr VectorColumn body_vectors[] = {{"centre", "m"},    {"velocity", "m/s"},           {"momentum", "N s"},
                                         {"impulse", "N s"}, {"angular_momentum", "N m s"}, {"extent", "m"}};
constexpr VectorColumn body_scalars[] = {
    {"mass", "kg"}, {"volume", "m3"}, {"kinetic_energy", "J"}, {"energy", "J"}, {"plastic_strain", "1"}};

void add_vector(std::vector<HistoryColumn>& out, std::string const& name, char const* unit) {
  for (std::size_t d = 0; d < 3; ++d) out.push_back({name + "_" + ray_names()[d], unit, {}});
}

void add(std::vector<double>& row, Vec3 const& x) { row.insert(row.end(), x.begin(), x.end()); }

double largest_plastic_strain(Body const& body) {
  double largest = 0;
  for (std::size_t i = 0; i < body.solid.kinds.count(); ++i) {
    if (body.solid.kinds.valid(i)) largest = std::max(largest, body.solid.states[i][solid_field_of::ep]);
  }
  for (TriangleState const& t : body.triangles) {
    for (SolidFields const& q : t.solid) largest = std::max(largest, q[solid_field_of::ep]);
  }
  return largest;
}

/// Area means over the triangles whose outward normal at the start was within 45 degrees of the probe's.
void add_face(BodyProbe const& probe, Body const& body, std::vector<double>& row) {
  Vec3 position{0, 0, 0}, velocity{0, 0, 0};
  double area = 0, pressure = 0;
  for (TriangleState const& t : body.triangles) {
    if (!(probe.sign * t.at_start[probe.axis] > std::sqrt(0.5))) continue;
    area += t.area, pressure += t.area * t.pressure;
    position = position + t.area * t.centre, velocity = velocity + t.area * t.velocity;
  }
  double const share = area > 0 ? 1 / area : none;
  Vec3 const mean = share * velocity;
  add(row, share * position), add(row, mean);
  row.push_back(length(mean)), row.push_back(share * pressure);
}

/// Whether x lies in the window, a cell away from where it ends within the grid.
bool covers(WindowBox const& box, Vec3 const& x) {
  for (std::size_t a = 0; a < 3; ++a) {
    double const at = (x[a] - box.lower[a]) / box.h - box.first[a];
    bool const begins = box.first[a] == 0, ends = box.first[a] + box.size[a] == box.grid[a];
    if (at < (begins ? 0 : 1) || at > box.size[a] - (ends ? 0 : 1)) return false;
  }
  return true;
}

}  // namespace

std::vector<HistoryColumn> body_columns(SceneRun const& run) {
  std::vector<HistoryColumn> out;
  if (!run.grid) return out;
  for (SceneBody const& body : run.grid->bodies) {
    std::string const name = "body/" + body.name + "/";
    for (auto const& [what, unit] : body_vectors) add_vector(out, name + what, unit);
    for (auto const& [what, unit] : body_scalars) out.push_back({name + what, unit, {}});
  }
  for (BodyProbe const& probe : run.output.body_probes) {
    std::string const name = "probe/" + probe.name + "/";
    add_vector(out, name + "position", "m"), add_vector(out, name + "velocity", "m/s");
    out.push_back({name + "speed", "m/s", {}}), out.push_back({name + "pressure", "Pa", {}});
  }
  return out;
}

void add_body_row(SceneRun const& run, OversetSolver const& solver, std::vector<BodyIntegrals> const& held,
                  std::vector<Vec3> const& start, std::vector<double>& row) {
  for (std::size_t n = 0; n < held.size(); ++n) {
    Body const& body = *solver.bodies()[n];
    BodyIntegrals const& now = held[n];
    BoundingBox const box = bounding_box(body.surface);
    add(row, now.centre), add(row, (1 / now.mass) * now.momentum), add(row, now.momentum);
    add(row, solver.momenta()[n].linear - start[n]), add(row, now.angular), add(row, box.upper - box.lower);
    for (double x : {now.mass, now.volume, now.kinetic, now.energy, largest_plastic_strain(body)}) row.push_back(x);
  }
  for (BodyProbe const& probe : run.output.body_probes) add_face(probe, *solver.bodies()[probe.body], row);
}

GasPoint BodyFieldView::at(Vec3 const& x) const {
  for (auto const& body : solver_->bodies()) {
    if (!covers(body->gas.kinds.box(), x)) continue;
    if (!body->gas.kinds.in_medium(x)) return {none, {none, none, none}, none};
    GasFields const q = body->gas.donors.at(x, Donors<GasFields>::From::valid, body->ambient);
    return {q[gas_field::rho], velocity_of(q), q[gas_field::p]};
  }
  return GridFieldView::at(x);
}

double BodyFieldView::max_pressure() const {
  auto p = solver_->gas().field(GasGrid::Field::pressure);
  Int3 const n = solver_->gas().cells();
  for (auto const& body : solver_->bodies()) {
    CellKinds const& kinds = body->gas.kinds;
    for (std::size_t i = 0; i < kinds.count(); ++i) {
      if (kinds.valid(i) || kinds.is_image(i)) continue;
      p[cell_number(n, kinds.in_grid(kinds.cell(i)))] = -1e300;
    }
  }
  return *std::max_element(p.begin(), p.end());
}

}  // namespace g27
