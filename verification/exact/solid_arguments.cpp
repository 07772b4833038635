#include "verification/exact/solid_arguments.hpp"

#include <cmath>

namespace g27 {
namespace {

std::vector<std::string> const laws{"linear-bulk", "mie-gruneisen", "constant-gruneisen", "stiffened", "ideal", "jwl"};

/// Reference density of a law, 0 for one that has none.
double reference_density(ExactSolidLaw const& law) {
  if (auto const* l = std::get_if<LinearBulkLaw>(&law)) return l->rho0;
  if (auto const* l = std::get_if<MieGruneisenLaw>(&law)) return l->rho0;
  if (auto const* l = std::get_if<ConstantGammaLaw>(&law)) return l->rho0;
  return 0;
}

double above(OracleArguments const& arguments, std::string const& key, double value, double bound, bool equal) {
  if (value > bound || (equal && value == bound)) return value;
  throw OracleError{key, "is " + (given(arguments, key) ? arguments.at(key) : std::string("too small")),
                    std::string("give a number ") + (equal ? "of at least " : "above ") + std::to_string(bound)};
}

}  // namespace

std::vector<OracleParameter> solid_parameters(std::string const& suffix, std::string const& fallback) {
  std::vector<OracleParameter> out = eos_parameters(suffix, fallback);
  out[0].what = "linear-bulk, mie-gruneisen, constant-gruneisen (Gamma itself constant), stiffened, ideal or jwl";
  out.insert(out.begin() + 1, {"K" + suffix, not_given, "Pa", "bulk modulus (linear-bulk; 175e9)"});
  out.push_back({"mu" + suffix, not_given, "Pa", "shear modulus (linear-bulk: 80.77e9; ideal, jwl: 0)"});
  out.push_back({"strength" + suffix, not_given, "", "plastic, or elastic whatever the stress (plastic)"});
  out.push_back({"yield" + suffix, not_given, "Pa", "yield stress in tension (linear-bulk: 340e6)"});
  out.push_back({"hardening" + suffix, not_given, "Pa", "its growth by plastic strain (linear-bulk: 240e6; else 0)"});
  return out;
}

SolidMaterial solid_material_argument(OracleArguments const& arguments, std::string const& suffix,
                                      std::string const& other_suffix) {
  bool const second = !other_suffix.empty();
  std::string const eos_key = "eos" + (given(arguments, "eos" + suffix) || !second ? suffix : other_suffix);
  std::string const name = word(arguments, eos_key, laws);
  bool const shared = second && arguments.at("eos" + other_suffix) == name, linear = name == "linear-bulk";
  auto value = [&](std::string const& key, double fallback) {
    if (given(arguments, key + suffix)) return number(arguments, key + suffix);
    if (shared && given(arguments, key + other_suffix)) return number(arguments, key + other_suffix);
    if (std::isnan(fallback))
      throw OracleError{key + suffix, "is missing: " + name + " needs it", "add " + key + suffix + "=VALUE"};
    return fallback;
  };
  double const required = std::nan("");
  auto positive = [&](std::string const& key, double fallback) {
    return above(arguments, key + suffix, value(key, fallback), 0, false);
  };
  auto refuse = [&](std::string const& key, std::string const& why) {
    if (given(arguments, key + suffix))
      throw OracleError{key + suffix, "is of no use: " + why, "leave it out, or choose a solid that has it"};
  };
  SolidMaterial out;
  if (!linear) refuse("K", name + " has none");
  if (linear) {
    refuse_other_laws(arguments, suffix, name, {"rho0"});
    out.law = LinearBulkLaw{.K = positive("K", 175e9), .rho0 = positive("rho0", 7800)};
  } else if (name == "constant-gruneisen") {
    refuse_other_laws(arguments, suffix, name, {"rho0", "c0", "s", "Gamma0"});
    out.law = ConstantGammaLaw{.rho0 = positive("rho0", required),
                               .c0 = positive("c0", required),
                               .s = above(arguments, "s" + suffix, value("s", required), 1, false),
                               .Gamma = positive("Gamma0", required)};
  } else {
    ExactEos const eos = eos_argument(arguments, suffix, other_suffix);
    if (auto const* stiffened = std::get_if<StiffenedLaw>(&eos)) out.law = *stiffened;
    if (auto const* ideal = std::get_if<IdealLaw>(&eos)) out.law = *ideal;
    if (auto const* jwl = std::get_if<JwlLaw>(&eos)) out.law = *jwl;
    if (auto const* mie = std::get_if<MieGruneisenLaw>(&eos)) out.law = *mie;
  }
  bool const fluid = name == "ideal" || name == "jwl";
  out.mu = above(arguments, "mu" + suffix, value("mu", linear ? 80.77e9 : fluid ? 0 : required), 0, true);
  std::string const strength_key =
      "strength" + (given(arguments, "strength" + suffix) || !shared ? suffix : other_suffix);
  bool const elastic =
      given(arguments, strength_key) && word(arguments, strength_key, {"plastic", "elastic"}) == "elastic";
  if (elastic || out.mu == 0) {
    for (char const* key : {"yield", "hardening"}) refuse(key, elastic ? "the solid is elastic" : "mu is 0");
    return out;
  }
  out.yield = positive("yield", linear ? 340e6 : required);
  out.hardening = above(arguments, "hardening" + suffix, value("hardening", linear ? 240e6 : 0), 0, true);
  return out;
}

std::vector<OracleParameter> solid_state_parameters(std::string const& suffix) {
  return {{"rho" + suffix, not_given, "kg/m^3", "density (the law's reference density)"},
          {"p" + suffix, not_given, "Pa", "pressure (0; a linear-bulk solid has that of its density)"}};
}

SolidPoint solid_state_argument(OracleArguments const& arguments, SolidMaterial const& material,
                                std::string const& suffix) {
  SolidPoint out;
  out.rho =
      given(arguments, "rho" + suffix) ? positive_number(arguments, "rho" + suffix) : reference_density(material.law);
  if (out.rho == 0)
    throw OracleError{"rho" + suffix, "is missing: the law has no reference density", "add rho" + suffix + "=VALUE"};
  if (std::holds_alternative<LinearBulkLaw>(material.law)) {
    if (given(arguments, "p" + suffix))
      throw OracleError{"p" + suffix, "follows from the density in a linear-bulk solid",
                        "give rho" + suffix + " instead"};
    out.p = pressure(material.law, out.rho, 0);
  } else if (given(arguments, "p" + suffix)) {
    out.p = number(arguments, "p" + suffix);
  }
  out.e = energy(material.law, out.rho, out.p);
  return out;
}

void SolidColumns::add(SolidPoint const& s) {
  rho.push_back(s.rho);
  u.push_back(s.u[0]);
  p.push_back(s.p);
  e.push_back(s.e);
  sxx.push_back(s.S[0]);
  ep.push_back(s.ep);
}

void SolidColumns::append_to(OracleRecord& out) const {
  out.insert(out.end(), {{"rho", rho}, {"u", u}, {"p", p}, {"e", e}, {"sxx", sxx}, {"ep", ep}});
}

}  // namespace g27
