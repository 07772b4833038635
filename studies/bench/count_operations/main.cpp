/// Steps of one grid of the benchmarks, for count_operations.py: no yardsticks, and no library that a simulated machine
/// would stop.
///
/// usage: count_operations gas|elastic|yielding PREDICTOR LAW CELLS     PREDICTOR: 0 godunov 1 linear 2 parabolic 3
/// muscl
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "studies/bench/box_waves.hpp"
#include "verification/cases/solid_media.hpp"

using namespace g27;

namespace {

template <class Grid>
int stepped(Grid grid) {
  constexpr int steps = 6;
  for (int k = 0; k < steps; ++k) step_time(grid);
  std::printf("%zu\n", steps * static_cast<std::size_t>(grid.cell_count()));
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 5) return std::fputs("four arguments are needed\n", stderr), 2;
  constexpr std::array predictors{Predictor::godunov, Predictor::linear, Predictor::parabolic, Predictor::muscl};
  Predictor const predictor = predictors.at(static_cast<std::size_t>(std::atoi(words[2])));
  int const cells = std::atoi(words[4]);
  bool const second = std::strcmp(words[3], "ideal") != 0 && std::strcmp(words[3], "linear") != 0;
  if (std::strcmp(words[1], "gas") == 0) {
    RiemannSolver const riemann = predictor == Predictor::muscl ? RiemannSolver::hllc : RiemannSolver::fast;
    return stepped(second ? gas_wave(Jwl{}, {1300.0, 0.0, 5e9}, cells, predictor, riemann, 1)
                          : gas_wave(IdealGas{}, {1.2, 0.0, 1e5}, cells, predictor, riemann, 1));
  }
  SolidMedium const m = solid_medium(second ? "aluminium" : "steel", std::strcmp(words[1], "yielding") == 0);
  return stepped(solid_wave(m.scheme, m.rho0, cells, predictor, 1));
}
