#include "verification/exact/elastic_riemann.hpp"
#include "verification/exact/solid_arguments.hpp"

namespace g27 {
namespace {

char const* const components[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
char const* const axes[] = {"x", "y", "z"};

OracleRecord solve(OracleArguments const& arguments) {
  SolidMaterial const material = solid_material_argument(arguments);
  SolidPoint base = solid_state_argument(arguments, material);
  auto tensor = [&](std::string const& name, std::string const& suffix) {
    Tensor6 out;
    for (std::size_t c = 0; c < 6; ++c) out[c] = number(arguments, name + components[c] + suffix);
    return out;
  };
  auto vector = [&](std::string const& name, std::string const& suffix) {
    Vector3 out;
    for (std::size_t i = 0; i < 3; ++i) out[i] = number(arguments, name + axes[i] + suffix);
    return out;
  };
  base.S = tensor("s", "");
  base.u = vector("u", "");
  auto changed = [&](std::string const& side) {
    SolidPoint s = base;
    s.rho += number(arguments, "drho" + side);
    s.p += number(arguments, "dp" + side);
    Tensor6 const dS = tensor("ds", side);
    Vector3 const du = vector("du", side);
    for (std::size_t c = 0; c < 6; ++c) s.S[c] += dS[c];
    for (std::size_t i = 0; i < 3; ++i) s.u[i] += du[i];
    return s;
  };
  ElasticRiemann const solution(material, base, changed("_l"), changed("_r"));
  auto list = [](Vector3 const& v) { return std::vector<double>(v.begin(), v.end()); };
  OracleRecord out{{"speeds", list(solution.speeds())},
                   {"u_star", list(solution.u_star())},
                   {"traction_star", list(solution.traction_star())},
                   {"rays", solution.rays()},
                   {"residual", solution.residual()}};
  auto const samples = samples_argument(arguments);
  if (!samples) return out;
  std::vector<double> rho, p;
  std::array<std::vector<double>, 3> u;
  std::array<std::vector<double>, 6> S;
  for (double const position : samples->x) {
    SolidPoint const s = solution.at(samples->speed(position));
    rho.push_back(s.rho);
    p.push_back(s.p);
    for (std::size_t i = 0; i < 3; ++i) u[i].push_back(s.u[i]);
    for (std::size_t c = 0; c < 6; ++c) S[c].push_back(s.S[c]);
  }
  out.insert(out.end(), {{"x", samples->x}, {"rho", rho}, {"p", p}});
  for (std::size_t i = 0; i < 3; ++i) out.push_back({std::string("u") + axes[i], u[i]});
  for (std::size_t c = 0; c < 6; ++c) out.push_back({std::string("s") + components[c], S[c]});
  return out;
}

}  // namespace

Oracle elastic_riemann_oracle() {
  std::vector<OracleParameter> parameters{
      {"x", not_given, "m", "where to sample: a number, a list 0,0.5,1 or a range 0:1:101"},
      {"t", not_given, "s", "when to sample"},
      {"x0", "0", "m", "position of the jump"}};
  for (auto const& p : solid_state_parameters()) parameters.push_back(p);
  for (char const* axis : axes)
    parameters.push_back({std::string("u") + axis, "0", "m/s", "velocity of the base state"});
  for (char const* c : components)
    parameters.push_back({std::string("s") + c, "0", "Pa", "deviator of the base state: the pre-stress"});
  for (std::string const side : {"_l", "_r"}) {
    std::string const where =
        side == "_l" ? " on the left, less the base state's" : " on the right, less the base state's";
    // without any argument: a step of velocity in all directions
    std::string const step = side == "_l" ? "1" : "0";
    for (char const* axis : axes)
      parameters.push_back({std::string("du") + axis + side, step, "m/s", "velocity" + where});
    parameters.push_back({"drho" + side, "0", "kg/m^3", "density" + where});
    parameters.push_back({"dp" + side, "0", "Pa", "pressure" + where});
    for (char const* c : components)
      parameters.push_back({std::string("ds") + c + side, "0", "Pa", "deviator" + where});
  }
  for (auto const& p : solid_parameters()) parameters.push_back(p);
  return {.name = "elastic-riemann",
          .summary = "Riemann problem of linear elasticity with P and S waves, coupled by a pre-stress",
          .source =
              "Achenbach, Wave Propagation in Elastic Solids (1973); pre-stress: Truesdell and Noll, The Non-Linear "
              "Field Theories of Mechanics (1965)",
          .parameters = parameters,
          .evaluate = solve};
}

}  // namespace g27
