#include "fsi/ale/solid_side.hpp"

#include <algorithm>
#include <cmath>

namespace g27 {

namespace {

namespace cell = solid_cell;
namespace face = solid_face;

/// Bend of the amplitudes over K + 4 mu/3 up to which no switch acts, at a side of the body and in its inner (where the
/// local grid meets no side). One that acts from .001 on everywhere takes .5 % of the momentum of a driven plate of 10
/// cells; none at all adds 12 % to that of a yielding cube in a blast, and at edges a tetrahedron would gain spin
/// without: fsi/README.md.
constexpr double quiet = 1e-3, quiet_within = 0.03;
constexpr double most_change = 0.3;  ///< of the density in a step, relative

/// Whether the body ends within the local grid behind the contact, or on both sides of a layer: too little is known of
/// a tip for a switch to judge. One that does slows a spinning tetrahedron by 5 % in a quarter turn.
bool is_tip(ModelStencil const& s) noexcept {
  bool tip = s.solid_ghost[1][1][1] || s.solid_ghost[2][1][1];
  for (auto const& layer : s.solid_ghost) {
    tip = tip || (layer[0][1] && layer[2][1]) || (layer[1][0] && layer[1][2]);
  }
  return tip;
}

template <std::size_t fields>
FieldRows rows(LaneRows<fields>& r) noexcept {
  return {r.q[0], lane_stride};
}

}  // namespace

SolidSide::SolidSide(AnySolid const& solid, double width, ModelOptions const& options)
    : solid_(solid),
      kernels_(solid_kernels()),
      options_(options),
      strength_{solid.mu, solid.Y0, solid.H},
      h_(width),
      terms_(45) {}

void SolidSide::put(std::size_t lane, int layer, int j, int k, SolidFields const& q) {
  int const i = along(layer);
  for (std::size_t f = 0; f < solid_field_of::count; ++f) block_.at(f, i, j, k)[lane] = q[f];
  std::visit(
      [&](auto const& eos) {
        block_.at(cell::K, i, j, k)[lane] = eos.bulk_modulus(q[cell::rho], q[cell::p]);
        block_.at(cell::f, i, j, k)[lane] = eos.gruneisen(q[cell::rho]);
      },
      solid_.eos);
}

void SolidSide::load(std::span<ModelStencil const> stencils, std::array<Vec3, model_lanes> const& frame) {
  stencils_ = stencils, frame_ = frame;
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    ModelStencil const& s = stencils[std::min(lane, stencils.size() - 1)];
    tip_[lane] = is_tip(s), quiet_[lane] = s.inner ? quiet_within : quiet;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          SolidFields q =
              s.solid_smooth[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
          for (std::size_t c = 0; c < 3; ++c) q[cell::u + c] -= frame[lane][c];
          put(lane, i, j, k, q);
        }
      }
    }
  }
}

void SolidSide::shift(std::array<Vec3, model_lanes> const& by) noexcept {
  for (std::size_t lane = 0; lane < model_lanes; ++lane) frame_[lane] = frame_[lane] + by[lane];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        for (std::size_t c = 0; c < 3; ++c) {
          double* const at = block_.at(cell::u + c, i, j, k);
          for (std::size_t lane = 0; lane < model_lanes; ++lane) at[lane] -= by[lane][c];
        }
      }
    }
  }
}

void SolidSide::set_ghosts() {
  for (std::size_t lane = 0; lane < stencils_.size(); ++lane) {
    ModelStencil const& s = stencils_[lane];
    for (int layer = 0; layer < 3; ++layer) {
      for (int j = 0; j < 3; ++j) {
        for (int k = 0; k < 3; ++k) {
          auto const at = [&](auto const& cells) {
            return cells[static_cast<std::size_t>(layer)][static_cast<std::size_t>(j)][static_cast<std::size_t>(k)];
          };
          if (!at(s.solid_ghost)) continue;
          SolidFields q = at(s.solid);
          for (std::size_t c = 0; c < 3; ++c) q[cell::u + c] -= frame_[lane][c];
          put(lane, layer, j, k, q);
        }
      }
    }
  }
}

void SolidSide::term_of(int layer, int j, int k, double dt, std::array<Terms*, 3> const& out) {
  std::ptrdiff_t const at = decltype(block_)::index(along(layer), j, k);
  double const quarter = 0.25 * dt / h_;
  SolidTransverseArguments t{.cells = model_lanes,
                             .cell = {block_.q[0] + at, decltype(block_)::volume},
                             .stride = decltype(block_)::stride,
                             .quarter_dt_over_h = {quarter, quarter, quarter},
                             .mu = strength_.mu,
                             .term = {}};
  for (std::size_t a = 0; a < 3; ++a) {
    if (out[a] != nullptr) t.term[a] = rows(*out[a]);
  }
  kernels_.loops->transverse(t);
}

void SolidSide::transverse(double dt) {
  // beyond the contact: one-sided derivatives
  for (std::size_t f = 0; f < cell::fields; ++f) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        double *const to = block_.at(f, along(-1), j, k), *const q0 = block_.at(f, along(0), j, k),
                      *const q1 = block_.at(f, along(1), j, k);
        for (std::size_t lane = 0; lane < model_lanes; ++lane) to[lane] = 2 * q0[lane] - q1[lane];
      }
    }
  }
  for (int layer = 0; layer <= core_layers; ++layer) {
    bool const core = layer < core_layers;
    term_of(layer, 1, 1, dt,
            {&term(layer, 0, 0), core ? &term(layer, 0, 1) : nullptr, core ? &term(layer, 0, 2) : nullptr});
    if (!core) continue;
    for (int side = 0; side < 2; ++side) {
      term_of(layer, 2 * side, 1, dt, {nullptr, &term(layer, 1 + side, 1), nullptr});
      term_of(layer, 1, 2 * side, dt, {nullptr, nullptr, &term(layer, 3 + side, 2)});
    }
  }
}

void SolidSide::contact_face(double dt, std::array<double, model_lanes> const& pressure, bool first_order, Flux& out) {
  bool const godunov = first_order || options_.predictor == Predictor::godunov;
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    given_[0][lane] = -pressure[lane], given_[1][lane] = given_[2][lane] = 0;
  }
  SolidBoundaryArguments f{.faces = model_lanes,
                           .inward = -decltype(block_)::stride[0],
                           .axis = 0,
                           .side = 1,
                           .kind = SolidFaceCondition::traction,
                           .given = rows(given_),
                           .cells = {block_.q[0] + decltype(block_)::index(along(0), 1, 1), decltype(block_)::volume},
                           .terms = godunov ? FieldRows{} : rows(term(0, 0, 0)),
                           .dt = dt,
                           .h = h_,
                           .strength = strength_,
                           .plastic = solid_.plastic(),
                           .tangent = true,
                           .predictor = godunov ? Predictor::godunov : options_.predictor,
                           .limited = options_.monotonicity != Switch::off,
                           .out = rows(out)};
  kernels_.loops->boundary(f);
}

void SolidSide::respond(double dt, std::array<double, model_lanes> const& pressure, bool first_order,
                        std::array<Vec3, model_lanes>& velocity) {
  Flux out;
  contact_face(dt, pressure, first_order, out);
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    for (std::size_t c = 0; c < 3; ++c) velocity[lane][c] = out[face::u + c][lane];
  }
}

void SolidSide::faces(int axis, std::array<int, 3> at, bool far_left, bool far_right, bool const* free, Terms& left,
                      Terms& right, double dt, bool first_order, Flux& out) {
  bool const godunov = first_order || options_.predictor == Predictor::godunov;
  double open[model_lanes];
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    if (tip_[lane] || (free != nullptr && free[lane])) {
      open[lane] = 1;
      continue;
    }
    auto const [i, j, k] = known_side(axis, at, far_left);
    auto const q = [&](int field) { return block_.at(static_cast<std::size_t>(field), i, j, k)[lane]; };
    auto const known = [&](int field) {
      return differences(block_, static_cast<std::size_t>(field), axis, at, far_left, lane);
    };
    double const M = q(cell::K) + 4.0 / 3.0 * strength_.mu, Z = std::sqrt(M * q(cell::rho));
    double const Z_shear = std::sqrt(strength_.mu * q(cell::rho)), most = quiet_[lane] * M;
    auto const family = [&](KnownDifferences const& s, KnownDifferences const& u, double z) {
      return 1 - std::max(loudness(s.far + z * u.far, s.face + z * u.face, most),
                          loudness(s.far - z * u.far, s.face - z * u.face, most));
    };
    auto const S = known(cell::S + axis), p = known(cell::p);
    open[lane] = family({S.far - p.far, S.face - p.face}, known(cell::u + axis), Z);
    for (int other = 1; other < 3 && open[lane] > 0; ++other) {
      int const c = (axis + other) % 3;
      std::size_t const shear = tensor_place[static_cast<std::size_t>(axis)][static_cast<std::size_t>(c)];
      open[lane] = std::min(open[lane], family(known(cell::S + static_cast<int>(shear)), known(cell::u + c), Z_shear));
    }
  }
  gather(block_, axis, at, far_left, far_right, open, stencil_);
  SolidFaceArguments f{.faces = model_lanes,
                       .stride = lane_stride,
                       .axis = axis,
                       .cells = {stencil_.q[0][1], 4 * lane_stride},
                       .left = godunov ? FieldRows{} : rows(left),
                       .right = godunov ? FieldRows{} : rows(right),
                       .dt = dt,
                       .h = h_,
                       .strength = strength_,
                       .plastic = solid_.plastic(),
                       .tangent = true,
                       .monotonicity = options_.monotonicity,
                       .two_way = true,  // a yielding cube in a blast gains momentum without: fsi/README.md
                       .out = rows(out),
                       .switched = 0,
                       .tangents = 0};
  kernels_.faces[static_cast<std::size_t>(godunov ? Predictor::godunov : options_.predictor)](f);
}

void SolidSide::step(double dt, std::array<double, model_lanes> const& pressure, bool first_order) {
  std::array<Flux, core_layers + 1> normal;
  contact_face(dt, pressure, first_order, normal[0]);
  // in its own frame the contact stands
  for (std::size_t lane = 0; lane < model_lanes; ++lane) {
    normal[0][face::mass][lane] = normal[0][face::energy][lane] = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      normal[0][face::u + c][lane] = 0;
      normal[0][face::momentum + c][lane] = c == 0 ? pressure[lane] : 0.0;
    }
  }
  for (int layer = 0; layer < core_layers; ++layer) {
    faces(0, {along(layer + 1), 1, 1}, layer + 1 < core_layers, layer > 0, nullptr, term(layer + 1, 0, 0),
          term(layer, 0, 0), dt, first_order, normal[static_cast<std::size_t>(layer) + 1]);
  }
  double const lambda = dt / h_;
  for (int layer = 0; layer < core_layers; ++layer) {
    std::size_t const l = static_cast<std::size_t>(layer);
    std::array<Flux, 4> across;
    // the switch does not act on a face between a core cell and one that stands for the body's side
    bool free[4][model_lanes] = {};
    for (std::size_t lane = 0; lane < stencils_.size(); ++lane) {
      auto const& ghost = stencils_[lane].solid_ghost[l];
      free[0][lane] = ghost[0][1], free[1][lane] = ghost[2][1];
      free[2][lane] = ghost[1][0], free[3][lane] = ghost[1][2];
    }
    int const i = along(layer);
    faces(1, {i, 0, 1}, false, true, free[0], term(layer, 1, 1), term(layer, 0, 1), dt, first_order, across[0]);
    faces(1, {i, 1, 1}, true, false, free[1], term(layer, 0, 1), term(layer, 2, 1), dt, first_order, across[1]);
    faces(2, {i, 1, 0}, false, true, free[2], term(layer, 3, 2), term(layer, 0, 2), dt, first_order, across[2]);
    faces(2, {i, 1, 1}, true, false, free[3], term(layer, 0, 2), term(layer, 4, 2), dt, first_order, across[3]);
    Averages& now = now_[l];
    for (std::size_t lane = 0; lane < model_lanes; ++lane) {
      auto const q = [&](std::size_t f) { return block_.at(f, i, 1, 1)[lane]; };
      double const rho = q(cell::rho);
      double speed2 = 0;
      now[solid_conserved::mass][lane] = rho, now[solid_conserved::ep][lane] = rho * q(cell::ep);
      for (std::size_t c = 0; c < 3; ++c) {
        double const v = q(cell::u + c);
        now[solid_conserved::momentum + c][lane] = rho * v, speed2 += v * v;
      }
      for (std::size_t c = 0; c < 6; ++c) now[solid_conserved::S + c][lane] = rho * q(cell::S + c);
      now[solid_conserved::energy][lane] = rho * (q(cell::e) + 0.5 * speed2);
    }
    SolidCorrectArguments c{.cells = model_lanes,
                            .now = rows(now),
                            .next = rows(next_[l]),
                            .source = {},
                            .lower = {rows(normal[l + 1]), rows(across[0]), rows(across[2])},
                            .upper = {rows(normal[l]), rows(across[1]), rows(across[3])},
                            .lambda = {lambda, lambda, lambda},
                            .strength = strength_,
                            .plastic = solid_.plastic(),
                            .midpoint = true,
                            .yielded = 0,
                            .plastic_work = 0};
    kernels_.loops->correct(c);
  }
}

SolidFields SolidSide::state(std::size_t lane, int layer, Vec3 const& frame, bool& sound) const {
  Averages const &q = next_[static_cast<std::size_t>(layer)], &old = now_[static_cast<std::size_t>(layer)];
  SolidFields s{};
  double const rho = q[solid_conserved::mass][lane], before = old[solid_conserved::mass][lane];
  double speed2 = 0;
  s[cell::rho] = rho, s[cell::ep] = q[solid_conserved::ep][lane] / rho;
  for (std::size_t c = 0; c < 3; ++c) {
    double const v = q[solid_conserved::momentum + c][lane] / rho;
    s[cell::u + c] = v + frame[c], speed2 += v * v;
  }
  for (std::size_t c = 0; c < 6; ++c) s[cell::S + c] = q[solid_conserved::S + c][lane] / rho;
  s[cell::e] = q[solid_conserved::energy][lane] / rho - 0.5 * speed2;
  s[cell::p] = std::visit([&](auto const& eos) { return eos.pressure(rho, s[cell::e]); }, solid_.eos);
  sound = sound && std::fabs(rho - before) < most_change * before;
  for (double x : s) sound = sound && std::isfinite(x);
  return s;
}

double SolidSide::impedance(std::size_t lane) const noexcept {
  auto const q = [&](std::size_t f) { return block_.at(f, along(0), 1, 1)[lane]; };
  double const M = q(cell::K) + 4.0 / 3.0 * strength_.mu - q(cell::f) * q(cell::S);
  return std::sqrt(q(cell::rho) * std::max(M, 1e-3 * q(cell::K)));
}

}  // namespace g27
