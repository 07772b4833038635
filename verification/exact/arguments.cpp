#include "verification/exact/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace g27 {
namespace {

/// Parameters of every law, in the order in which they are listed; a name shared by `laws` appears once.
struct LawParameter {
  char const *name, *unit, *what, *laws;
};
constexpr LawParameter law_parameters[] = {
    {"gamma", "1", "ratio of specific heats", "ideal, stiffened"},
    {"p_inf", "Pa", "stiffening pressure", "stiffened"},
    {"A", "Pa", "first coefficient", "jwl"},
    {"B", "Pa", "second coefficient", "jwl"},
    {"R1", "1", "first exponent", "jwl"},
    {"R2", "1", "second exponent", "jwl"},
    {"omega", "1", "Grueneisen coefficient", "jwl"},
    {"rho0", "kg/m^3", "reference density", "jwl, mie-gruneisen"},
    {"c0", "m/s", "intercept of the shock locus", "mie-gruneisen"},
    {"s", "1", "slope of the shock locus", "mie-gruneisen"},
    {"Gamma0", "1", "Grueneisen coefficient at rho0", "mie-gruneisen"},
};

double parse(std::string const& key, std::string const& text) {
  char* end = nullptr;
  double const value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !std::isfinite(value))
    throw OracleError{key, "'" + text + "' is not a number", "write " + key + "=1.5"};
  return value;
}

}  // namespace

bool given(OracleArguments const& arguments, std::string const& key) {
  auto const found = arguments.find(key);
  return found != arguments.end() && found->second != not_given;
}

double number(OracleArguments const& arguments, std::string const& key) {
  if (!given(arguments, key)) throw OracleError{key, "is missing", "add " + key + "=VALUE"};
  return parse(key, arguments.at(key));
}

double positive_number(OracleArguments const& arguments, std::string const& key) {
  double const value = number(arguments, key);
  if (!(value > 0)) throw OracleError{key, "is " + arguments.at(key), "give a number above 0"};
  return value;
}

std::vector<double> numbers(OracleArguments const& arguments, std::string const& key) {
  if (!given(arguments, key)) throw OracleError{key, "is missing", "add " + key + "=VALUE"};
  std::string const& text = arguments.at(key);
  char const separator = text.find(':') == std::string::npos ? ',' : ':';
  std::vector<double> out;
  for (std::size_t from = 0; from <= text.size();) {
    std::size_t const to = std::min(text.find(separator, from), text.size());
    out.push_back(parse(key, text.substr(from, to - from)));
    from = to + 1;
  }
  if (separator == ',') return out;
  if (out.size() != 3) throw OracleError{key, "'" + text + "' is not a range", "write FIRST:LAST:COUNT, as 0:1:101"};
  if (out[2] < 2 || out[2] > 1e6 || out[2] != std::floor(out[2]))
    throw OracleError{key, "'" + text + "' has no such number of points",
                      "give a whole number of them from 2 to 1000000"};
  std::vector<double> range(static_cast<std::size_t>(out[2]));
  for (std::size_t i = 0; i < range.size(); ++i)
    range[i] = out[0] + (out[1] - out[0]) * static_cast<double>(i) / (out[2] - 1);
  return range;
}

std::optional<Samples> samples_argument(OracleArguments const& arguments) {
  if (given(arguments, "x") != given(arguments, "t"))
    throw OracleError{given(arguments, "x") ? "t" : "x", "is missing", "give both x and t to sample the solution"};
  if (!given(arguments, "x")) return std::nullopt;
  double const t = positive_number(arguments, "t"), x0 = arguments.contains("x0") ? number(arguments, "x0") : 0.0;
  return Samples{numbers(arguments, "x"), t, x0};
}

std::string word(OracleArguments const& arguments, std::string const& key, std::vector<std::string> const& words) {
  std::string const& value = arguments.at(key);
  if (std::find(words.begin(), words.end(), value) != words.end()) return value;
  std::string list;
  for (auto const& w : words) list += (list.empty() ? "" : ", ") + w;
  throw OracleError{key, "'" + value + "' is unknown", "choose one of: " + list};
}

std::vector<OracleParameter> eos_parameters(std::string const& suffix, std::string const& fallback) {
  std::vector<OracleParameter> out{
      {"eos" + suffix, fallback, "", "equation of state: ideal, stiffened, jwl, mie-gruneisen"}};
  for (auto const& p : law_parameters) {
    out.push_back({p.name + suffix, not_given, p.unit, std::string(p.what) + " (" + p.laws + ")"});
  }
  return out;
}

void refuse_other_laws(OracleArguments const& arguments, std::string const& suffix, std::string const& law,
                       std::vector<std::string> const& own) {
  for (auto const& p : law_parameters) {
    bool const has =
        std::string(p.laws).find(law) != std::string::npos || std::find(own.begin(), own.end(), p.name) != own.end();
    if (!has && given(arguments, p.name + suffix))
      throw OracleError{p.name + suffix, "is of no use: " + law + " has none",
                        "leave it out, or choose a law that has it: " + std::string(p.laws)};
  }
}

ExactEos eos_argument(OracleArguments const& arguments, std::string const& suffix, std::string const& other_suffix) {
  bool const named = given(arguments, "eos" + suffix);
  std::string const& source = named ? suffix : other_suffix;
  std::string const name = word(arguments, "eos" + source, {"ideal", "stiffened", "jwl", "mie-gruneisen"});
  refuse_other_laws(arguments, suffix, name);
  bool const shared = !other_suffix.empty() && arguments.at("eos" + other_suffix) == name;
  auto value = [&](std::string const& key) {
    if (given(arguments, key + suffix)) return number(arguments, key + suffix);
    if (shared && given(arguments, key + other_suffix)) return number(arguments, key + other_suffix);
    if (key == "gamma" && name == "ideal") return 1.4;
    throw OracleError{key + suffix, "is missing: " + name + " needs it", "add " + key + suffix + "=VALUE"};
  };
  auto above = [&](std::string const& key, double bound) {
    double const x = value(key);
    if (!(x > bound)) throw OracleError{key + suffix, "is too small", "give a number above " + std::to_string(bound)};
    return x;
  };
  if (name == "ideal") return IdealLaw{.gamma = above("gamma", 1)};
  if (name == "stiffened") return StiffenedLaw{.gamma = above("gamma", 1), .p_inf = value("p_inf")};
  if (name == "jwl")
    return JwlLaw{.A = value("A"),
                  .B = value("B"),
                  .R1 = above("R1", 0),
                  .R2 = above("R2", 0),
                  .omega = above("omega", 0),
                  .rho0 = above("rho0", 0)};
  return MieGruneisenLaw{
      .rho0 = above("rho0", 0), .c0 = above("c0", 0), .s = above("s", 1), .Gamma0 = above("Gamma0", 0)};
}

int symmetry_argument(OracleArguments const& arguments) {
  std::string const name = word(arguments, "symmetry", {"planar", "cylindrical", "spherical"});
  return name == "planar" ? 0 : name == "cylindrical" ? 1 : 2;
}

OracleParameter symmetry_parameter(std::string const& fallback) {
  return {"symmetry", fallback, "", "planar, cylindrical or spherical"};
}

}  // namespace g27
