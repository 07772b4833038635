/// Gas and an elastic solid that push each other smoothly: a simple wave in the solid, both families in the gas.
#include <memory>

#include "verification/cases/fsi_problem.hpp"
#include "verification/cases/media.hpp"
#include "verification/exact/elastic_piston.hpp"
#include "verification/exact/numerics.hpp"

namespace g27 {

namespace {

constexpr double length = 0.5;  ///< of gas and solid [m]; a period is what sound takes for 1 m of gas

/// The gas at the times asked for, the last one kept: an inflow asks for one time after another.
class GasHistory {
 public:
  explicit GasHistory(std::shared_ptr<ElasticPiston const> exact) : exact_(std::move(exact)) {}
  ElasticPiston::Profile const& at(double t) {
    if (t != time_) profile_ = exact_->gas(t), time_ = t;
    return profile_;
  }

 private:
  std::shared_ptr<ElasticPiston const> exact_;
  double time_ = -1;
  ElasticPiston::Profile profile_;
};

}  // namespace

Case fsi_piston_1d_case() {
  Case out{.name = "fsi-piston-1d",
           .title = "smooth motion of gas and an elastic solid that share a contact, over one period",
           .source = "exact: verification/exact/elastic_piston.hpp",
           .dimensions = 1,
           .default_cells = 100,
           .eos = {"ideal", "stiffened", "jwl"},
           .meshes = fsi_meshes(),
           .parameters = {
               {.name = "velocity", .value = 0.03, .unit = "1", .what = "of the contact, over the gas's sound speed"},
               {.name = "density",
                .value = 2,
                .unit = "1",
                .what = "of the solid, over the gas's",
                .least = 0.01,
                .most = 100}}};
  out.run = [parameters = out.parameters](CaseOptions const& options) {
    Medium const m = medium(options.eos.value_or("ideal"));
    double const unit = m.base.rho * m.sound * m.sound, density = value_of(parameters, options, "density");
    ElasticPistonSetup const setup{.eos = m.exact,
                                   .gas = {m.base.rho, 0, m.base.p},
                                   .law = {.K = 2.5 * unit, .rho0 = density * m.base.rho},
                                   .mu = 1.5 * unit,
                                   .velocity = value_of(parameters, options, "velocity") * m.sound,
                                   .period = 1 / m.sound,
                                   .depth = 0.7 * m.base.rho};
    if (!(setup.velocity > 0)) throw std::invalid_argument("the velocity must be above 0");
    auto const exact = std::make_shared<ElasticPiston const>([&] {
      try {
        return ElasticPiston(setup);
      } catch (NumericsError const& error) {
        throw std::invalid_argument(error.what());
      }
    }());
    auto const history = std::make_shared<GasHistory>(exact);
    FsiProblem problem{.eos = m.eos,
                       .solid = {.eos = BulkModulus{setup.law.rho0, setup.law.K}, .mu = setup.mu},
                       .material = {.law = setup.law, .mu = setup.mu}};
    problem.x0 = -length, problem.x1 = length, problem.t_end = setup.period;
    problem.left = {.kind = GasBoundary::Kind::inflow,
                    .state = [=](double x, double t) { return history->at(t).at(x); }};
    double const label = exact->particle(length, 0);
    problem.right = {.kind = SolidBoundary::Kind::wall,
                     .normal_velocity = [=](Vec3 const&, double t) { return exact->particle_velocity(label, t); }};
    auto const gas_mean = [=](double t) {
      return mean_of(m.eos, Symmetry::planar, [=](double x) { return history->at(t).at(x); });
    };
    problem.gas_initial = gas_mean(0), problem.gas_reference = gas_mean(problem.t_end);
    auto const solid_mean = [=](double t) {
      return
          [=](double a, double b) { return solid_average([&](double x) { return exact->solid(x, t); }, a, b, {}, 5); };
    };
    problem.solid_initial = solid_mean(0), problem.solid_reference = solid_mean(problem.t_end);
    problem.position = [=](double t) { return exact->position(t); };
    CaseResult r = run_problem("fsi-piston-1d", 100, problem, options);
    r.facts["exact_truncation"] = exact->truncation();
    return r;
  };
  return out;
}

}  // namespace g27
