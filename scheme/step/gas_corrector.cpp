#include <algorithm>
#include <cmath>

#include "scheme/step/gas_line_impl.hpp"
#include "scheme/step/gauss.hpp"

namespace g27 {

namespace {

constexpr double vacuum_pressure = 1e-12, vacuum_density = 1e-13;  ///< floors, over rho u^2 and the largest density

}  // namespace

std::pair<double, double> GasLine::Impl::correct(double dt, std::ptrdiff_t begin, std::size_t count, GasCells& out,
                                                 std::ptrdiff_t to) const noexcept {
  bool const sourced = setup.source.mean || burns();
  double const h = line.width();
  UpdateArguments g{.cells = count,
                    .eos = eos,
                    .mass = now.mass.data() + begin,
                    .momentum = now.momentum.data() + begin,
                    .energy = now.energy.data() + begin,
                    .f_mass = faces.mass.data() + begin,
                    .f_momentum = faces.momentum.data() + begin,
                    .f_energy = faces.energy.data() + begin,
                    .face_p = faces.p.data() + begin,
                    .area = curved ? line.area.data() + begin : nullptr,
                    .measure = plain ? nullptr : line.measure.data() + begin,
                    .inv_measure_new = line.inv_measure_new.data() + begin,
                    .src_mass = sourced ? src_mass.data() + begin : nullptr,
                    .src_momentum = src_momentum.data() + begin,
                    .src_energy = src_energy.data() + begin,
                    .inv_h = line.inv_h.data() + begin,
                    .dt = dt,
                    .lambda = dt / h,
                    .inv_width = 1.0 / h,
                    .rho_old = now.rho.data() + begin,
                    .margin_old = now.margin.data() + begin,
                    .mass_new = out.mass.data() + to,
                    .momentum_new = out.momentum.data() + to,
                    .energy_new = out.energy.data() + to,
                    .rho = out.rho.data() + to,
                    .u = out.u.data() + to,
                    .p = out.p.data() + to,
                    .K = out.K.data() + to,
                    .margin = out.margin.data() + to,
                    .worst = 1.0,
                    .rate = 0.0};
  law.update(g);
  return {g.worst, g.rate};
}

std::pair<double, double> GasLine::Impl::correct_with_cell_feet(double dt) {
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const k = dt * line.inv_h[i];
    next.mass[i] = now.mass[i] - k * (faces.mass[i + 1] - other_faces.mass[i]);
    next.momentum[i] = now.momentum[i] - k * (faces.momentum[i + 1] - other_faces.momentum[i]);
    next.energy[i] = now.energy[i] - k * (faces.energy[i + 1] - other_faces.energy[i]);
  }
  primitives(next, 0, n);
  double worst = 1.0;
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    double const share = std::min(next.rho[i] / now.rho[i], next.margin[i] / now.margin[i]);
    if (!(share >= worst)) worst = share > 0 ? share : -1.0;
  }
  return {worst, signal_rate(next, false)};
}

void GasLine::Impl::set_sources(double dt) {
  if (!setup.source.mean) return;
  auto const gauss = gauss_points(2);
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    std::size_t const k = static_cast<std::size_t>(i);
    double mass = 0, momentum = 0, energy = 0;
    auto const add = [&](double x0, double x1, double t, double span, double weight) {
      double const v = weight * measure_between(setup.symmetry, x0, x1);
      GasConserved<> const s = setup.source.mean(x0, x1, t, span);
      mass += v * s.mass, momentum += v * s.momentum, energy += v * s.energy;
    };
    if (moving) {
      // at two instants, over the cell where it stands then
      for (std::size_t m = 0; m < 2; ++m) {
        double const past = 0.5 * dt * (1.0 + gauss[m].x);
        add(line.x[k] + past * line.w[i], line.x[k + 1] + past * line.w[i + 1], time + past, 0.0, 0.5 * dt);
      }
    } else {
      add(line.x[k], line.x[k + 1], time, dt, dt);
    }
    src_mass[i] = mass, src_momentum[i] = momentum, src_energy[i] = energy;
  }
}

bool GasLine::Impl::bad(std::ptrdiff_t i, double share) const noexcept {
  // unburnt explosive at rest has no pressure margin: it lies below the products' isentropes
  bool const fresh = burns() && unburnt[static_cast<std::size_t>(i)] > 0;
  bool const margin = fresh ? next.K[i] > 0 : next.margin[i] > share * now.margin[i];
  return !(next.rho[i] > share * now.rho[i]) || !margin || !std::isfinite(next.energy[i]) ||
         !std::isfinite(next.momentum[i]);
}

GasLine::Impl::FaceRun GasLine::Impl::at_first_order(FaceRun run) noexcept {
  run.predictor = PredictorKernel::godunov, run.increments = false, run.linear_star = false;
  return run;
}

void GasLine::Impl::repair(FaceRun const& run, double dt) {
  std::fill(redone.begin(), redone.end(), 0);
  FaceRun const first = at_first_order(run);
  GasFaces one(16);
  GasCells cell(16);
  bool const periodic = setup.left.kind == GasBoundary::Kind::periodic;
  std::vector<std::ptrdiff_t> touched;
  for (bool again = true; again;) {
    again = false;
    touched.clear();
    for (std::ptrdiff_t i = 0; i < cells(); ++i) {
      if (!bad(i, repair_share)) continue;
      for (std::ptrdiff_t f : {i, i + 1}) {
        if (redone[static_cast<std::size_t>(f)] != 0) continue;
        auto const redo = [&](std::ptrdiff_t face) {
          bool const unburnt_face = burns() && unburnt_faces[static_cast<std::size_t>(face)] != 0;
          run_faces(unburnt_face ? beside_unburnt(first) : first, face, 1, problems[0], one, 0);
          faces.copy_face(face, one, 0);
          redone[static_cast<std::size_t>(face)] = 1;
          counters.repaired += 1;
          if (face > 0) touched.push_back(face - 1);
          if (face < cells()) touched.push_back(face);
        };
        redo(f);
        if (periodic && (f == 0 || f == cells())) redo(cells() - f);
        again = true;
      }
    }
    for (std::ptrdiff_t i : touched) {
      if (burns()) release(i, dt);
      correct(dt, i, 1, cell, 0);
      next.copy_cell(i, cell, 0);
    }
  }
}

bool GasLine::Impl::floor_vacuum() {
  bool sound = true;
  for (std::ptrdiff_t i = 0; i < cells(); ++i) {
    if (!bad(i, 0.0)) continue;
    GasConserved<> const before = next.average(i);
    if (!std::isfinite(before.mass) || !std::isfinite(before.momentum) || !std::isfinite(before.energy)) return false;
    double const rho = std::max(before.mass, vacuum_density * largest_density);
    double const u = before.mass > 0 ? before.momentum / rho : 0.0;
    GasState<> s{rho, u, now.p[i]};
    double const wanted = std::max(vacuum_pressure * rho * u * u, 1e-300);
    for (int k = 0; k < 3; ++k) {
      double const margin = std::visit([&](auto const& e) { return e.pressure_margin(s.rho, s.p); }, setup.eos);
      s.p += wanted - margin;
    }
    next.mass[i] = s.rho, next.momentum[i] = s.rho * s.u, next.energy[i] = energy_density(s);
    GasCells cell(16);
    cell.mass[0] = next.mass[i], cell.momentum[0] = next.momentum[i], cell.energy[0] = next.energy[i];
    primitives(cell, 0, 1);
    next.copy_primitives(i, cell, 0);
    double const v = 1.0 / line.inv_measure_new[i];
    floor.add(v * (next.mass[i] - before.mass), v * (next.momentum[i] - before.momentum),
              v * (next.energy[i] - before.energy));
    counters.floored += 1;
    sound = sound && !bad(i, 0.0);
  }
  return sound;
}

}  // namespace g27
