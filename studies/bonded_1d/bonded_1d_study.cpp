/// Two solids bonded end to end: orders on waves that cross the face, the states of an impact in which both yield, and
/// two solids of one material against one line of it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fsi/line/solid_solid_line.hpp"
#include "studies/driver/hdf5_file.hpp"
#include "studies/driver/lookup.hpp"
#include "studies/driver/study.hpp"
#include "studies/orders/order_schemes.hpp"
#include "studies/orders/order_tables.hpp"
#include "verification/cases/bonded_problem.hpp"
#include "verification/cases/line_problem.hpp"
#include "verification/cases/solid_problem.hpp"

namespace g27 {
namespace {

constexpr double amplitude = 1e-6;  ///< of the waves' velocity, over the speed of P waves

struct Crossing {
  std::string group;
  double family, stress;
};

std::vector<OrderRow> order_rows() {
  std::vector<OrderRow> rows;
  for (Crossing const& w : {Crossing{"P", 0, 0}, {"S", 2, 0}, {"P, pre-stress", 0, 0.05}, {"S, pre-stress", 2, 0.05}}) {
    for (std::string const pair : {"steel-aluminium", "aluminium-steel"}) {
      SolidMedium const m = solid_medium("steel");
      for (OrderScheme const& s : order_schemes) {
        bool const third = s.predictor == Predictor::parabolic;
        OrderRow row{w.group, "bimaterial-1d", pair, "lagrangian", s.name, {}, {96, 136, 192, 272}};
        if (third) row.cells = {64, 90, 128, 180};  // round-off beyond
        row.options.predictor = s.predictor, row.options.monotonicity = s.monotonicity;
        row.options.values = {{"family", w.family}, {"stress", w.stress}};
        double const u = amplitude * m.sound, stress = m.rho0 * m.sound * u;
        auto const unit = [&](std::string const& v) {
          if (v.find("velocity") != std::string::npos) return u;
          return v.find("density") != std::string::npos ? m.rho0 * amplitude : stress;
        };
        for (std::string const side : {"left_", "right_"}) {
          for (std::string const& v : solid_variables()) row.units.emplace_back(side + v, unit(v));
        }
        for (char const* v : {"contact_velocity_x", "contact_velocity_y", "contact_velocity_z", "contact_traction_x",
                              "contact_traction_y", "contact_traction_z"})
          row.units.emplace_back(v, unit(v));
        rows.push_back(row);
      }
    }
  }
  return rows;
}

Table impact(Hdf5Writer& profiles, std::vector<Finding>& findings) {
  Table table{.name = "impact",
              .title = "steel at 300 m/s on aluminium, both yield: errors of the contact's last step and of the states",
              .columns = {{"scheme", "1"},
                          {"cells", "1"},
                          {"stress_error", "1"},
                          {"velocity_error", "1"},
                          {"left_velocity_l1", "m/s"},
                          {"right_velocity_l1", "m/s"}},
              .rows = {},
              .facts = {}};
  std::vector<Case> const cases = all_cases();
  Case const& problem = find_by_name(cases, "bonded-impact", "bonded-1d");
  for (Predictor const predictor : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
    std::vector<double> errors;
    std::string scheme;
    for (int const n : {100, 200, 400, 800}) {
      CaseOptions options;
      options.cells = n, options.predictor = predictor;
      CaseResult const r = problem.run(options);
      double const s = r.facts.at("contact_stress_error"), u = r.facts.at("contact_velocity_error");
      double const l = r.errors.at("left_velocity_x").l1, right = r.errors.at("right_velocity_x").l1;
      scheme = r.scheme;
      errors.push_back(l + right);
      table.rows.push_back({r.scheme, long{n}, s, u, l, right});
      if (n != 800) continue;
      if (predictor == Predictor::linear) {
        table.facts.push_back({"exact_contact_stress_pa", r.facts.at("exact_contact_stress")});
        table.facts.push_back({"exact_contact_velocity_mps", r.facts.at("exact_contact_velocity")});
      }
      std::string const group = "/" + r.scheme + "/";
      profiles.write(group + "x", r.x, "m");
      for (auto const& [variable, unit] :
           {std::pair{"velocity_x", "m/s"}, std::pair{"pressure", "Pa"}, std::pair{"sxx", "Pa"}}) {
        profiles.write(group + variable, r.profile.at(variable), unit);
        profiles.write(group + "reference_" + variable, r.profile_ref.at(variable), unit);
      }
      if (predictor != Predictor::godunov) {
        findings.push_back(
            {fmt::format("impact, {}, 800 cells a side: stress and velocity of the contact within 0.01 %", r.scheme),
             fmt::format("{:.2g}, {:.2g}", s, u), std::max(std::fabs(s), std::fabs(u)) <= 1e-4});
      }
    }
    // Godunov's shocks spread with the square root of the grid in part
    double const most = predictor == Predictor::godunov ? 0.8 : 0.65;
    bool falls = true;
    for (std::size_t i = 1; i < errors.size(); ++i) falls = falls && errors[i] < most * errors[i - 1];
    findings.push_back(
        {fmt::format("impact, {}: the velocity's error falls to less than {} at every doubling", scheme, most),
         fmt::format("{:.3g}, {:.3g}, {:.3g}, {:.3g} m/s m", errors[0], errors[1], errors[2], errors[3]), falls});
  }
  return table;
}

/// L1 difference of the velocities over the wave's own: steel bonded to steel, and one line of steel.
double gap(Predictor predictor, int cells) {
  SolidMedium const m = solid_medium("steel");
  auto const state = [&](double x) {
    double const f = amplitude * std::exp(-30 * (x + 0.35) * (x + 0.35));
    return SolidPoint{.rho = m.rho0 * (1 + f), .u = {m.sound * f, 0.7 * m.sound * f, 0}};
  };
  SolidSchemeOptions const options{.predictor = predictor, .monotonicity = Switch::off};
  SolidBoundary const contact{.kind = SolidBoundary::Kind::contact};
  auto const setup = [&](double x0, double x1, int n) {
    return SolidLineSetup{.material = m.scheme, .faces = mesh_faces("uniform", x0, x1, n), .options = options};
  };
  SolidLineSetup l = setup(-1, 0, cells), r = setup(0, 1, cells);
  l.right = r.left = contact;
  SolidSolidLine pair(l, r);
  SolidLine line(setup(-1, 1, 2 * cells));
  pair.left().set_state(state, 5), pair.right().set_state(state, 5), line.set_state(state, 5);
  double const t_end = 0.5 / m.sound;
  auto const advance = [&](auto& solid) {
    while (solid.time() < t_end) {
      if (solid.step(t_end).status != StepStatus::ok)
        throw std::runtime_error("bonded-1d: a step of one material failed");
    }
  };
  advance(pair), advance(line);
  double sum = 0;
  for (std::size_t i = 0; i < line.cells(); ++i) {
    std::size_t const n = line.cells() / 2;
    SolidPoint const a = i < n ? pair.left().primitive(i) : pair.right().primitive(i - n), b = line.primitive(i);
    for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(a.u[k] - b.u[k]);
  }
  return sum / (cells * amplitude * m.sound);
}

Table one_material(std::vector<Finding>& findings) {
  Table table{.name = "one-material",
              .title = "steel bonded to steel against one line: L1 difference of velocity over the wave's own",
              .columns = {{"scheme", "1"}, {"cells", "1"}, {"difference", "1"}},
              .rows = {},
              .facts = {}};
  for (Predictor const predictor : {Predictor::godunov, Predictor::linear, Predictor::parabolic}) {
    std::string const scheme = predictor == Predictor::godunov  ? "godunov"
                               : predictor == Predictor::linear ? "linear"
                                                                : "parabolic";
    std::vector<double> gaps;
    for (int const n : {50, 100, 200}) {
      gaps.push_back(gap(predictor, n));
      table.rows.push_back({scheme, long{n}, gaps.back()});
    }
    std::string const value = fmt::format("{:.2g}, {:.2g}, {:.2g}", gaps[0], gaps[1], gaps[2]);
    if (predictor == Predictor::godunov) {
      // round-off of positions, 1e-16/h, over the amplitude
      findings.push_back({"one material, Godunov: one line to 1e-7 of the wave, round-off", value,
                          *std::max_element(gaps.begin(), gaps.end()) <= 1e-7});
    } else {
      double const order = std::log2(gaps[1] / gaps[2]);
      findings.push_back(
          {fmt::format("one material, {}: the difference to one line falls with order 2.6 to 3.2", scheme),
           fmt::format("{}: {:.2f}", value, order), order > 2.6 && order < 3.2});
    }
  }
  return table;
}

StudyReport run(StudyContext const& context) {
  std::vector<Finding> findings;
  Hdf5Writer profiles;
  if (context.progress) context.progress(0, "impact");
  Table const hit = impact(profiles, findings);
  Table const same = one_material(findings);
  std::vector<RowResult> results = measure_orders(order_rows(), context);
  for (RowResult& r : results) keep_moving(r);
  auto const claim = [&](std::string const& text, std::string const& scheme, double low, double high) {
    findings.push_back(order_claim(results, text, low, high, [&](auto& r, auto&) { return r.scheme == scheme; }));
  };
  claim("waves, linear, off: L1 order of every variable on both sides and at the face 1.9 to 2.1", "linear, off", 1.9,
        2.1);
  claim("waves, linear, graded: L1 order at least 1.8", "linear, graded", 1.8, 3);
  claim("waves, parabolic, on: L1 order at least 1.8", "parabolic, on", 1.8, 4);
  claim("waves, Godunov: L1 order 0.7 to 1.1", "godunov", 0.7, 1.1);
  profiles.save(context.out / "profiles.h5");
  return {{hit, same, order_table(results), error_table(results)}, findings};
}

}  // namespace

Study bonded_1d_study() {
  return {"bonded-1d", "two bonded solids share velocity and traction, to second order on both sides", run};
}

}  // namespace g27
