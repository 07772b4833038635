/// Initial data: [ambient], [[region]], [[charge]], or [initial] with a wave or a table.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "studies/driver/data_file.hpp"
#include "studies/driver/scene_parts.hpp"

namespace g27 {
namespace {

struct Piece {
  double from, to;
  InitialState state;
  Section section;
};

InitialState constant(GasState<> const& state) {
  return [state](double) { return state; };
}

/// A piece beside the domain, or smaller than a cell, is a slip: in a unit or in its place.
void check_covers(Piece const& piece, std::vector<double> const& faces) {
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    double const centre = 0.5 * (faces[i] + faces[i + 1]);
    if (centre >= piece.from && centre <= piece.to) return;
  }
  throw piece.section.error(
      piece.section.has("extent") ? "extent" : "radius",
      fmt::format("covers no centre of a cell of the domain, {} m to {} m", faces.front(), faces.back()),
      "move it into the domain, or take smaller cells; a bare number is in SI units");
}

/// Pieces must not overlap and, without an ambient state, must leave no gap.
InitialState assemble(std::vector<Piece> pieces, std::optional<GasState<>> const& ambient, Section const& root,
                      double left, double right) {
  std::sort(pieces.begin(), pieces.end(), [](Piece const& a, Piece const& b) { return a.from < b.from; });
  double const slack = 1e-9 * (right - left);
  double covered = left;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (i > 0 && pieces[i].from < pieces[i - 1].to - slack) {
      throw pieces[i].section.error("",
                                    fmt::format("overlaps {} (from {} m, that ends at {} m)",
                                                pieces[i - 1].section.path(), pieces[i].from, pieces[i - 1].to),
                                    "make the extents meet");
    }
    if (!ambient && pieces[i].from > covered + slack && covered < right) {
      throw pieces[i].section.error("", fmt::format("leaves a gap from {} m to {} m", covered, pieces[i].from),
                                    "make the extents meet, or add [ambient]");
    }
    covered = std::max(covered, pieces[i].to);
  }
  if (!ambient && covered < right - slack) {
    throw root.error("", fmt::format("no initial data from {} m to {} m", covered, right),
                     "add a [[region]] there, or [ambient]");
  }
  return [pieces, ambient](double x) {
    for (Piece const& piece : pieces) {
      if (x >= piece.from && x <= piece.to) {
        return piece.state(x);
      }
    }
    return ambient ? *ambient : pieces.empty() ? GasState<>{} : pieces.back().state(x);
  };
}

/// State on the isentrope through `base` whose velocity is u along the wave curve u - int dp/(rho c) = const, by RK4.
GasState<> simple_wave(AnyEos const& eos, GasState<> const& base, double u) {
  constexpr int steps = 64;
  double const h = (u - base.u) / steps;
  auto const rates = [&](double rho, double p) {
    double const K = std::visit([&](auto const& e) { return e.bulk_modulus(rho, p); }, eos);
    return std::array{rho * std::sqrt(rho / K), std::sqrt(rho * K)};  // d rho/du = rho/c, dp/du = rho c
  };
  GasState<> s = base;
  for (int i = 0; i < steps; ++i) {
    auto const k1 = rates(s.rho, s.p);
    auto const k2 = rates(s.rho + h / 2 * k1[0], s.p + h / 2 * k1[1]);
    auto const k3 = rates(s.rho + h / 2 * k2[0], s.p + h / 2 * k2[1]);
    auto const k4 = rates(s.rho + h * k3[0], s.p + h * k3[1]);
    s.rho += h / 6 * (k1[0] + 2 * k2[0] + 2 * k3[0] + k4[0]);
    s.p += h / 6 * (k1[1] + 2 * k2[1] + 2 * k3[1] + k4[1]);
  }
  return {s.rho, u, s.p};
}

/// base (1 + amplitude sin(2 pi x / wavelength)): the density of an entropy or acoustic wave, the velocity (in sound
/// speeds) of a simple wave.
InitialState read_wave(Section const& section, AnyEos const& eos) {
  GasState<> const base = read_state(section, eos);
  std::size_t const kind = section.choice("kind", {"acoustic", "entropy", "simple"}, 0);
  double const a = section.quantity("amplitude", dimension::number);
  double const k = 2 * std::numbers::pi / section.positive("wavelength", dimension::length);
  double const phase = section.quantity("phase", dimension::angle, 0);
  double const K = std::visit([&](auto const& e) { return e.bulk_modulus(base.rho, base.p); }, eos);
  double const c = std::sqrt(K / base.rho);
  auto const state = [=](double x) -> GasState<> {
    double const s = a * std::sin(k * x + phase);
    switch (kind) {
      case 0:
        return {base.rho * (1 + s), base.u + c * s, base.p + K * s};
      case 1:
        return {base.rho * (1 + s), base.u, base.p};
      default:
        return simple_wave(eos, base, base.u + c * s);
    }
  };
  for (double const sign : {-1.0, 1.0}) {
    GasState<> const extreme = state((sign * std::numbers::pi / 2 - phase) / k);
    if (!(std::fabs(a) < 1) || !std::isfinite(extreme.rho) || !std::isfinite(extreme.p) || !(extreme.rho > 0) ||
        !(std::visit([&](auto const& e) { return e.pressure_margin(extreme.rho, extreme.p); }, eos) > 0)) {
      throw section.error("amplitude", fmt::format("{} makes a state that is not admissible", a), "make it smaller");
    }
  }
  return state;
}

/// Linear interpolation in a table of x, density, velocity, pressure; from a CSV file beside the scene or inline.
InitialState read_table(Section const& section, AnyEos const& eos, double left, double right) {
  std::vector<double> x, rho, u, p;
  if (section.has("file")) {
    Section const only = section.reopened({"type", "material", "file"});
    auto const path = std::filesystem::path(only.reading().file).parent_path() / only.text("file");
    auto const columns = read_columns(path, {{"x", dimension::length},
                                             {"density", dimension::density},
                                             {"velocity", dimension::velocity},
                                             {"pressure", dimension::pressure}});
    x = columns[0], rho = columns[1], u = columns[2], p = columns[3];
  } else {
    x = section.quantities("x", dimension::length);
    rho = section.quantities("density", dimension::density);
    u = section.quantities("velocity", dimension::velocity);
    p = section.quantities("pressure", dimension::pressure);
  }
  std::string const key = section.has("file") ? "file" : "x";
  if (x.size() < 2 || rho.size() != x.size() || u.size() != x.size() || p.size() != x.size()) {
    throw section.error(key, "columns differ in length or have fewer than two rows",
                        "give x, density, velocity and pressure as many values each");
  }
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (i > 0 && !(x[i] > x[i - 1])) {
      throw section.error(key, fmt::format("positions do not increase at row {}", i), "sort the rows by position");
    }
    check_admissible(section, eos, {rho[i], u[i], p[i]});
  }
  double const slack = 1e-9 * (right - left);
  if (x.front() > left + slack || x.back() < right - slack) {
    throw section.error(
        key, fmt::format("covers {} m to {} m only, the domain {} m to {} m", x.front(), x.back(), left, right),
        "extend the table or shorten domain.extent");
  }
  return [=](double at) -> GasState<> {
    auto const next = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::upper_bound(x.begin(), x.end(), at) - x.begin()), 1, x.size() - 1);
    double const f = std::clamp((at - x[next - 1]) / (x[next] - x[next - 1]), 0.0, 1.0);
    auto const mix = [&](std::vector<double> const& v) { return (1 - f) * v[next - 1] + f * v[next]; };
    return {mix(rho), mix(u), mix(p)};
  };
}

}  // namespace

std::vector<std::string> with_state_keys(std::vector<std::string> keys) {
  keys.insert(keys.end(), {"material", "density", "velocity", "pressure"});
  return keys;
}

void check_admissible(Section const& where, AnyEos const& eos, GasState<> const& state) {
  if (!(state.rho > 0)) {
    throw where.error("density", fmt::format("{} kg/m3 is not positive", state.rho), "give a density > 0");
  }
  double const margin = std::visit([&](auto const& e) { return e.pressure_margin(state.rho, state.p); }, eos);
  if (!(margin > 0)) {
    throw where.error(
        "pressure",
        fmt::format("{} Pa is not admissible at {} kg/m3 (lowest: {} Pa)", state.p, state.rho, state.p - margin),
        "raise the pressure or change the density");
  }
}

GasState<> read_state(Section const& section, AnyEos const& eos) {
  GasState<> const state{section.quantity("density", dimension::density),
                         section.quantity("velocity", dimension::velocity, 0),
                         section.quantity("pressure", dimension::pressure)};
  check_admissible(section, eos, state);
  return state;
}

InitialData read_initial(Section const& root, AnyEos const& eos, Symmetry symmetry, std::vector<double> const& faces) {
  double const left = faces.front(), right = faces.back();
  bool const pieces_given = root.has("ambient") || root.has("region") || root.has("charge");
  if (root.has("initial")) {
    if (pieces_given) {
      throw root.error("initial", "is given beside [ambient], [[region]] or [[charge]]", "keep one of the two");
    }
    Section const any =
        root.table("initial", with_state_keys({"type", "kind", "amplitude", "wavelength", "phase", "file", "x"}));
    if (index_of_choice(any, "type", any.text("type"), {"wave", "table"}) == 0) {
      return {read_wave(any.reopened(with_state_keys({"type", "kind", "amplitude", "wavelength", "phase"})), eos), {}};
    }
    return {read_table(any.reopened(with_state_keys({"type", "file", "x"})), eos, left, right), {}};
  }
  if (!pieces_given) {
    throw root.error("region", "is missing", "add [[region]], [ambient] with [[charge]], or [initial]");
  }
  std::optional<GasState<>> ambient;
  if (root.has("ambient")) {
    ambient = read_state(root.table("ambient", with_state_keys({})), eos);
  }
  std::vector<Piece> pieces;
  for (Section const& region : root.tables("region", with_state_keys({"extent"}))) {
    auto const [from, to] = region.interval("extent", dimension::length);
    pieces.push_back({from, to, constant(read_state(region, eos)), region});
  }
  InitialData data;
  for (Charge const& charge : read_charges(root, eos, symmetry)) {
    pieces.push_back({0.0, charge.radius, charge.state, charge.section});
    data.charge = charge;
  }
  for (Piece const& piece : pieces) check_covers(piece, faces);
  data.state = assemble(std::move(pieces), ambient, root, left, right);
  return data;
}

}  // namespace g27
