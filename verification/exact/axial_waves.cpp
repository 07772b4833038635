#include "verification/exact/axial_waves.hpp"

#include <algorithm>
#include <cmath>

#include "verification/exact/numerics.hpp"

namespace g27 {
namespace {

constexpr int fan_intervals = 400;

/// Largest density of a law: where the shock locus has its pole.
double densest(ExactSolidLaw const& law) {
  auto pole = [](auto const* l) { return l && l->s > 1 ? l->rho0 * l->s / (l->s - 1) : 1e300; };
  return std::min(pole(std::get_if<MieGruneisenLaw>(&law)), pole(std::get_if<ConstantGammaLaw>(&law)));
}

}  // namespace

AxialWaves::AxialWaves(SolidMaterial const& material, SolidPoint const& ahead, double sigma, Direction direction)
    : material_(material),
      sign_(static_cast<double>(static_cast<int>(direction))),
      rho0_(ahead.rho),
      Q0_(-1.5 * ahead.S[0]),
      ep0_(ahead.ep),
      Y0_(material.yield + material.hardening * ahead.ep) {
  double const mu = material_.mu;
  if (std::fabs(Q0_) > Y0_ * (1 + 1e-12)) throw NumericsError("the initial deviator is beyond the yield surface");
  bool const elastic = !(mu > 0) || !std::isfinite(Y0_);
  compressed_limit_ = elastic ? 1e300 : std::max(0.0, (Y0_ - Q0_) / (2 * mu));
  expanded_limit_ = elastic ? -1e300 : std::min(0.0, (-Y0_ - Q0_) / (2 * mu));
  State const start{ahead.p - ahead.S[0], ahead.rho, sign_ * ahead.u[0], ahead.e};
  double const rho_a2 = stiffness(start, false);
  if (!(rho_a2 > 0)) throw NumericsError("the initial state has no sound speed");
  a0_ = std::sqrt(rho_a2 / rho0_);
  if (sigma > start.sigma)
    compress(start, sigma);
  else if (sigma < start.sigma)
    expand(start, sigma);
  behind_ = pieces_.empty() ? ahead : point(pieces_.back().behind);
  for (Piece const& piece : pieces_)
    waves_.push_back(
        {piece.shock, piece.plastic, sign_ * piece.head, sign_ * piece.tail, point(piece.ahead), point(piece.behind)});
}

AxialWaves::Strength AxialWaves::strength(double rho) const {
  double const x = std::log(rho / rho0_), mu = material_.mu, H = material_.hardening;
  double const beyond = x > compressed_limit_ ? x - compressed_limit_ : std::max(0.0, expanded_limit_ - x);
  if (beyond == 0) return {Q0_ + 2 * mu * x, ep0_};
  double const flow = 2 * mu * beyond / (3 * mu + H);
  return {(x > 0 ? 1 : -1) * (Y0_ + H * flow), ep0_ + flow};
}

double AxialWaves::stiffness(State const& s, bool plastic) const {
  double const Q = strength(s.rho).Q, mu = material_.mu, H = material_.hardening;
  double const kept = plastic ? H / (3 * mu + H) : 1;
  double const p = pressure(material_.law, s.rho, s.e);
  return bulk_modulus(material_.law, s.rho, p) + gruneisen(material_.law, s.rho) * Q * 2 / 3 + 4.0 / 3 * mu * kept;
}

AxialWaves::State AxialWaves::fan_slope(State const& s, bool plastic) const {
  double const rho_a2 = stiffness(s, plastic);
  if (!(rho_a2 > 0)) throw NumericsError("a fan leaves the law: no sound speed");
  double const a2 = rho_a2 / s.rho;
  return {1, 1 / a2, 1 / (s.rho * std::sqrt(a2)), s.sigma / (s.rho * s.rho * a2)};
}

SolidPoint AxialWaves::point(State const& s) const {
  Strength const y = strength(s.rho);
  SolidPoint out;
  out.rho = s.rho;
  out.u[0] = sign_ * s.u;
  out.e = s.e;
  // sigma is what the waves agree on: p(rho, e) differs by the error of the fan, which residual() reports
  out.p = s.sigma - y.Q * 2 / 3;
  out.S = {-y.Q * 2 / 3, y.Q / 3, y.Q / 3, 0, 0, 0};
  out.ep = y.ep;
  return out;
}

AxialWaves::State AxialWaves::shocked_at_density(State const& s, double rho) const {
  // sigma = p(rho, 0) + f rho e + 2 Q/3 with e = e_0 + (sigma_0 + sigma) shrink: linear in sigma
  double const shrink = (1 / s.rho - 1 / rho) / 2, slope = gruneisen(material_.law, rho) * rho;
  double const sigma = (pressure(material_.law, rho, 0) + slope * (s.e + s.sigma * shrink) + strength(rho).Q * 2 / 3) /
                       (1 - slope * shrink);
  return {sigma, rho, s.u + std::sqrt(std::max(0.0, (sigma - s.sigma) * 2 * shrink)), s.e + (s.sigma + sigma) * shrink};
}

AxialWaves::State AxialWaves::shocked(State const& s, double sigma) const {
  auto energy_at = [&](double rho) { return s.e + (s.sigma + sigma) * (1 / s.rho - 1 / rho) / 2; };
  auto excess = [&](double rho) {
    return pressure(material_.law, rho, energy_at(rho)) + strength(rho).Q * 2 / 3 - sigma;
  };
  double const limit = densest(material_.law);
  double lo = s.rho, hi = s.rho;
  for (double step = 0.01 * s.rho; excess(hi) < 0; step *= 1.5) {
    if (step > 1e6 * s.rho) throw NumericsError("no shock reaches this stress");
    lo = hi;
    hi = hi + step < limit ? hi + step : lo + (limit - lo) * 0.9;
  }
  double const rho = lo == hi ? hi : find_root(excess, lo, hi);
  double const gap = std::max(0.0, 1 / s.rho - 1 / rho);
  return {sigma, rho, s.u + std::sqrt((sigma - s.sigma) * gap), energy_at(rho)};
}

void AxialWaves::add_shock(State const& ahead, State const& behind, bool plastic) {
  // The mean of the characteristic speeds errs by the square of the strength, the jump condition by round-off over it.
  bool const weak = behind.sigma - ahead.sigma < 3e-6 * stiffness(ahead, plastic);
  auto characteristic = [&](State const& s) { return s.u + std::sqrt(stiffness(s, plastic) / s.rho); };
  double const speed =
      weak ? (characteristic(ahead) + characteristic(behind)) / 2
           : ahead.u + std::sqrt((behind.sigma - ahead.sigma) / (1 / ahead.rho - 1 / behind.rho)) / ahead.rho;
  pieces_.push_back({true, plastic, speed, speed, ahead, behind, {}});
}

void AxialWaves::compress(State const& start, double sigma) {
  if (compressed_limit_ > 1e299) return add_shock(start, shocked(start, sigma), false);
  State limit = start;  // where yielding begins
  if (compressed_limit_ > 1e-14) {
    limit = shocked_at_density(start, rho0_ * std::exp(compressed_limit_));
    if (sigma <= limit.sigma) return add_shock(start, shocked(start, sigma), false);
    add_shock(start, limit, false);
  }
  State const end = shocked(limit, sigma);
  add_shock(limit, end, true);
  if (pieces_.size() == 2 && pieces_[1].head >= pieces_[0].head) {
    // overdriven: one shock, which yields inside
    pieces_.clear();
    add_shock(start, shocked(start, sigma), true);
  }
}

AxialWaves::State AxialWaves::expanded(State const& s, double sigma, bool plastic, std::vector<State>* nodes) const {
  // scaled by the state ahead, so that one tolerance fits all; counted from it, so that weak fans keep their digits
  double const unit = rho0_ * a0_ * a0_;
  auto state = [&](double x, double const* y) {
    return State{s.sigma + unit * x, s.rho * std::exp(y[0]), s.u + a0_ * y[1], s.e + a0_ * a0_ * y[2]};
  };
  auto slope = [&](double x, double const* y, double* out) {
    State const now = state(x, y), d = fan_slope(now, plastic);
    out[0] = unit * d.rho / now.rho;
    out[1] = unit * d.u / a0_;
    out[2] = unit * d.e / (a0_ * a0_);
  };
  std::vector<double> at{0};
  int const intervals = nodes ? fan_intervals : 1;
  for (int i = 1; i <= intervals; ++i) at.push_back((sigma - s.sigma) / unit * i / intervals);
  auto const values = solve_ode(slope, {0, 0, 0}, at);
  if (nodes)
    for (std::size_t i = 0; i < at.size(); ++i) nodes->push_back(state(at[i], values[i].data()));
  State out = state(at.back(), values.back().data());
  out.sigma = sigma;
  if (nodes) nodes->back().sigma = sigma;
  return out;
}

AxialWaves::State AxialWaves::expanded_to_density(State const& s, double rho, bool plastic) const {
  double const unit = rho0_ * a0_ * a0_;
  auto state = [&](double x, double const* y) {
    return State{s.sigma + unit * y[0], s.rho * std::exp(x), s.u + a0_ * y[1], s.e + a0_ * a0_ * y[2]};
  };
  auto slope = [&](double x, double const* y, double* out) {
    State const now = state(x, y), d = fan_slope(now, plastic);
    double const by_log = now.rho / d.rho;
    out[0] = by_log / unit;
    out[1] = by_log * d.u / a0_;
    out[2] = by_log * d.e / (a0_ * a0_);
  };
  double const end = std::log(rho / s.rho);
  return state(end, solve_ode(slope, {0, 0, 0}, {0, end}).back().data());
}

void AxialWaves::add_fan(State const& ahead, State const& behind, bool plastic) {
  auto characteristic = [&](State const& s) { return s.u + std::sqrt(stiffness(s, plastic) / s.rho); };
  Piece fan{false, plastic, characteristic(ahead), 0, ahead, behind, {}};
  fan.behind = expanded(ahead, behind.sigma, plastic, &fan.nodes);
  fan.tail = characteristic(fan.behind);
  pieces_.push_back(std::move(fan));
}

void AxialWaves::expand(State const& start, double sigma) {
  State const wanted{sigma, 0, 0, 0};
  if (expanded_limit_ < -1e299) return add_fan(start, wanted, false);
  State limit = start;
  if (expanded_limit_ < -1e-14) {
    limit = expanded_to_density(start, rho0_ * std::exp(expanded_limit_), false);
    if (sigma >= limit.sigma) return add_fan(start, wanted, false);
    add_fan(start, limit, false);
    limit = pieces_.back().behind;
  }
  add_fan(limit, wanted, true);
}

AxialWaves::State AxialWaves::in_fan(Piece const& fan, double ray) const {
  auto speed = [&](State const& s) { return s.u + std::sqrt(stiffness(s, fan.plastic) / s.rho) - ray; };
  auto const after =
      std::partition_point(fan.nodes.begin(), fan.nodes.end(), [&](State const& s) { return speed(s) > 0; });
  if (after == fan.nodes.begin()) return fan.nodes.front();
  if (after == fan.nodes.end()) return fan.nodes.back();
  State const &a = *(after - 1), &b = *after, da = fan_slope(a, fan.plastic), db = fan_slope(b, fan.plastic);
  double const h = b.sigma - a.sigma;
  auto within = [&](double s) {
    return State{a.sigma + s * h, hermite(s, h, a.rho, da.rho, b.rho, db.rho), hermite(s, h, a.u, da.u, b.u, db.u),
                 hermite(s, h, a.e, da.e, b.e, db.e)};
  };
  if (speed(b) == 0) return b;
  return within(find_root([&](double s) { return speed(within(s)); }, 0, 1));
}

SolidPoint AxialWaves::at(double xi) const {
  double const ray = sign_ * xi;
  for (Piece const& piece : pieces_) {
    if (ray >= piece.head) return point(piece.ahead);
    if (ray > piece.tail) return point(in_fan(piece, ray));
  }
  return behind_;
}

std::vector<double> AxialWaves::speeds() const {
  std::vector<double> out;
  for (Wave const& wave : waves_) {
    out.push_back(wave.head);
    if (!wave.shock) out.push_back(wave.tail);
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::string AxialWaves::pattern() const {
  std::string out;
  for (Wave const& wave : waves_)
    out += std::string(out.empty() ? "" : ", ") +
           (material_.mu == 0 ? ""
            : wave.plastic    ? "plastic "
                              : "elastic ") +
           (wave.shock ? "shock" : "fan");
  return out.empty() ? "none" : out;
}

double AxialWaves::residual() const {
  double const unit = rho0_ * a0_ * a0_;
  double worst = 0;
  auto law = [&](State const& s) {
    return std::fabs(pressure(material_.law, s.rho, s.e) + strength(s.rho).Q * 2 / 3 - s.sigma) / unit;
  };
  for (Piece const& piece : pieces_) {
    State const &a = piece.ahead, &b = piece.behind;
    worst = std::max({worst, law(a), law(b)});
    for (State const& s : piece.nodes) worst = std::max(worst, law(s));
    if (!piece.shock) continue;
    double const D = piece.head, ua = a.u - D, ub = b.u - D;
    double const mass = b.rho * ub - a.rho * ua;
    double const momentum = b.rho * ub * ub + b.sigma - a.rho * ua * ua - a.sigma;
    double const power =
        b.rho * ub * (b.e + ub * ub / 2) + b.sigma * ub - a.rho * ua * (a.e + ua * ua / 2) - a.sigma * ua;
    worst =
        std::max({worst, std::fabs(mass) / (rho0_ * a0_), std::fabs(momentum) / unit, std::fabs(power) / (unit * a0_)});
  }
  return worst;
}

AxialWaves axial_piston(SolidMaterial const& material, SolidPoint const& ahead, double u, Direction direction) {
  double const sigma0 = ahead.p - ahead.S[0], sign = static_cast<double>(static_cast<int>(direction));
  double const push = sign * (u - ahead.u[0]);
  auto gap = [&](double sigma) {
    return sign * (AxialWaves(material, ahead, sigma, direction).behind().u[0] - ahead.u[0]) - push;
  };
  if (push == 0) return {material, ahead, sigma0, direction};
  // sigma grows with the velocity, less than the elastic impedance times it or more
  double const guess = ahead.rho * AxialWaves(material, ahead, sigma0, direction).sound_speed() * push;
  double lo = 0, hi = guess;
  for (int i = 0; gap(sigma0 + hi) * push < 0; ++i) {
    if (i > 60) throw NumericsError("no stress gives the piston its velocity");
    lo = hi;
    hi *= 1.5;
  }
  return {material, ahead, find_root([&](double d) { return gap(sigma0 + d); }, lo, hi) + sigma0, direction};
}

SolidPoint axial_state(SolidMaterial const& material, double rho, double u, double p, double sxx, double ep) {
  SolidPoint out;
  out.rho = rho;
  out.u[0] = u;
  out.p = p;
  out.e = energy(material.law, rho, p);
  out.S = {sxx, -sxx / 2, -sxx / 2, 0, 0, 0};
  out.ep = ep;
  return out;
}

}  // namespace g27
