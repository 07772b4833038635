#include "fsi/overset/overset_state.hpp"

#include <algorithm>
#include <stdexcept>

#include "scheme/grid/cell_place.hpp"

namespace g27 {

namespace {

/// Numbers in the order in which they are asked for.
class Numbers {
 public:
  explicit Numbers(std::vector<double> const& from) : next_(from.begin()), end_(from.end()) {}

  void get(double& x) { x = next_ == end_ ? 0.0 : *next_++; }
  template <class T, std::size_t N>
  void get(std::array<T, N>& all) {
    for (T& x : all) get(x);
  }

 private:
  std::vector<double>::const_iterator next_, end_;
};

void put(std::vector<double>& to, double x) { to.push_back(x); }
template <class T, std::size_t N>
void put(std::vector<double>& to, std::array<T, N> const& all) {
  for (T const& x : all) put(to, x);
}

template <class T>
std::vector<double> packed(std::vector<T> const& all) {
  std::vector<double> out;
  for (T const& x : all) put(out, x);
  return out;
}

template <std::size_t N>
std::vector<std::array<double, N>> unpacked(std::vector<double> const& from) {
  std::vector<std::array<double, N>> out(from.size() / N);
  Numbers numbers(from);
  for (auto& x : out) numbers.get(x);
  return out;
}

constexpr std::size_t solid_densities = 12;

template <class State, class F>
void for_each_member_of_rigid(State& s, F const& f) {
  f(s.centre), f(s.rotation), f(s.momentum), f(s.angular);
}

/// Calls f with every member of a triangle's state that its corners do not give.
template <class State, class F>
void for_each_member(State& t, F const& f) {
  for (auto& q : t.gas) f(q);
  for (auto& q : t.solid) f(q);
  f(t.velocity), f(t.pressure), f(t.at_start);
  for (auto& g : t.gradient) f(g);
}

template <class Clock, class F>
void for_each_member_of_clock(Clock& c, F const& f) {
  f(c.time), f(c.last_dt);
  f(c.counters.seconds_local), f(c.counters.seconds_gas), f(c.counters.seconds_solid);
  f(c.counters.seconds_geometry), f(c.counters.seconds_fill);
}

constexpr std::array counts{&OversetCounters::steps,   &OversetCounters::problems, &OversetCounters::first_order,
                            &OversetCounters::failed,  &OversetCounters::skipped,  &OversetCounters::untangled,
                            &OversetCounters::tangled, &OversetCounters::renewed};
constexpr std::array remesh_counts{&LocalRemeshCounts::splits, &LocalRemeshCounts::collapses, &LocalRemeshCounts::flips,
                                   &LocalRemeshCounts::moves, &LocalRemeshCounts::refused};

std::string name_of(std::size_t body, char const* what) { return "body/" + std::to_string(body) + "/" + what; }

}  // namespace

void save_gas(GasGrid const& gas, OversetState& out) {
  std::array<std::vector<double>, 5> fields;
  for_each_cell(gas.cells(), [&](Int3 const& c) {
    GasDensities const q = gas.average(c);
    fields[0].push_back(q.mass), fields[4].push_back(q.energy);
    for (std::size_t d = 0; d < 3; ++d) fields[1 + d].push_back(q.momentum[d]);
  });
  char const* const names[] = {"gas/mass", "gas/momentum_x", "gas/momentum_y", "gas/momentum_z", "gas/energy"};
  for (std::size_t f = 0; f < 5; ++f) out.arrays[names[f]] = std::move(fields[f]);
  GasGridMemory const memory = gas.memory();
  out.arrays["gas/memory"] = {gas.time(), memory.signal_rate, memory.largest_density};
}

void restore_gas(OversetState const& from, GasGrid& gas) {
  auto const &mass = from.at("gas/mass"), &x = from.at("gas/momentum_x"), &y = from.at("gas/momentum_y"),
             &z = from.at("gas/momentum_z"), &energy = from.at("gas/energy"), &memory = from.at("gas/memory");
  Int3 const n = gas.cells();
  gas.set_cells(
      [&](Int3 const& c) -> GasDensities {
        std::size_t const i = cell_number(n, c);
        return {mass.at(i), {x.at(i), y.at(i), z.at(i)}, energy.at(i)};
      },
      memory.at(0));
  gas.set_memory({memory.at(1), memory.at(2)});
}

void save_body(Body const& body, BodyMomentum const& held, std::size_t n, OversetState& out) {
  auto const array = [&](char const* what) -> std::vector<double>& { return out.arrays[name_of(n, what)]; };
  array("vertices") = packed(body.surface.vertices);
  auto& corners = array("triangles");
  for (Triangle const& t : body.surface.triangles) {
    for (int v : t) corners.push_back(v);
  }
  auto& states = array("triangle_states");
  for (TriangleState const& t : body.triangles) for_each_member(t, [&](auto const& x) { put(states, x); });
  array("gas_states") = packed(body.gas.states), array("solid_states") = packed(body.solid.states);
  auto& averages = array("averages");
  for_each_cell(body.grid.cells(), [&](Int3 const& c) {
    SolidDensities const q = body.grid.average(c);
    put(averages, q.mass), put(averages, q.momentum), put(averages, q.energy);
    put(averages, q.rho_S), put(averages, q.rho_ep);
  });
  if (body.rigid) {
    auto& rigid = array("rigid");
    for_each_member_of_rigid(body.rigid->state, [&](auto const& x) { put(rigid, x); });
  }
  auto& rest = array("rest");
  put(rest, body.grid.time()), put(rest, body.grid.signal_rate());
  put(rest, body.background), put(rest, body.ambient);
  put(rest, held.linear), put(rest, held.angular), put(rest, held.work), put(rest, held.mass), put(rest, held.growth);
}

BodyMomentum restore_body(OversetState const& from, std::size_t n, Body& body) {
  auto const array = [&](char const* what) -> std::vector<double> const& { return from.at(name_of(n, what)); };
  body.surface.vertices = unpacked<3>(array("vertices"));
  auto const corners = unpacked<3>(array("triangles"));
  body.surface.triangles.resize(corners.size());
  body.around.assign(body.surface.vertices.size(), {});
  for (std::size_t t = 0; t < corners.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      int const v = static_cast<int>(corners[t][k]);
      body.surface.triangles[t][k] = v, body.around.at(static_cast<std::size_t>(v)).push_back(static_cast<int>(t));
    }
  }
  // triangles may have been meshed anew since the start: other vertices lie on the planes of symmetry
  body.cut = find_cut(body.surface, body.cut.mirrors, 1e-3 * body.setup.cell);
  body.triangles.resize(corners.size());
  body.place_triangles();
  Numbers states(array("triangle_states"));
  for (TriangleState& t : body.triangles) for_each_member(t, [&](auto& x) { states.get(x); });
  body.gas.states = unpacked<gas_field::count>(array("gas_states"));
  body.solid.states = unpacked<solid_field_of::count>(array("solid_states"));
  if (body.gas.states.size() != body.gas.kinds.count() || body.solid.states.size() != body.solid.kinds.count()) {
    throw std::invalid_argument("the stored state is of other grids");
  }
  if (body.rigid) {
    Numbers rigid(array("rigid"));
    for_each_member_of_rigid(body.rigid->state, [&](auto& x) { rigid.get(x); });
  }
  Numbers rest(array("rest"));
  double time = 0, rate = 0;
  BodyMomentum held;
  rest.get(time), rest.get(rate), rest.get(body.background), rest.get(body.ambient);
  rest.get(held.linear), rest.get(held.angular), rest.get(held.work), rest.get(held.mass), rest.get(held.growth);
  auto const averages = unpacked<solid_densities>(array("averages"));
  Int3 const cells = body.grid.cells();
  body.grid.set_cells(
      [&](Int3 const& c) {
        auto const& a = averages.at(cell_number(cells, c));
        SolidDensities q{.mass = a[0], .momentum = {a[1], a[2], a[3]}, .energy = a[4], .rho_S = {}, .rho_ep = a[11]};
        std::copy_n(a.begin() + 5, 6, q.rho_S.begin());
        return q;
      },
      time);
  body.grid.set_signal_rate(rate);
  return held;
}

void save_clock(OversetClock const& clock, OversetState& out) {
  auto& numbers = out.arrays["clock"];
  for_each_member_of_clock(clock, [&](double x) { put(numbers, x); });
  for (auto const count : counts) put(numbers, static_cast<double>(clock.counters.*count));
  for (auto const count : remesh_counts) put(numbers, static_cast<double>(clock.counters.remeshing.*count));
  put(numbers, clock.counters.remeshing.volume);
}

OversetClock clock_of(OversetState const& from) {
  OversetClock clock;
  Numbers numbers(from.at("clock"));
  for_each_member_of_clock(clock, [&](double& x) { numbers.get(x); });
  auto const whole = [&] {
    double value = 0;
    numbers.get(value);
    return static_cast<std::uint64_t>(value);
  };
  for (auto const count : counts) clock.counters.*count = whole();
  for (auto const count : remesh_counts) clock.counters.remeshing.*count = whole();
  numbers.get(clock.counters.remeshing.volume);
  return clock;
}

}  // namespace g27
