#include "scheme/kernel/gas_kernels.hpp"

#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace g27 {

// The kernel objects define these in the namespace of their instruction set.
#define G27_FOR_ISA(isa)                          \
  namespace isa {                                 \
  extern GasKernels::Predictors const predictors; \
  template <class E>                              \
  EosKernels const& eos_kernels() noexcept;       \
  }
G27_FOR_EACH_ISA
#undef G27_FOR_ISA

namespace {

bool runs_here([[maybe_unused]] std::string_view isa) noexcept {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (isa == "x86_64_v4") return __builtin_cpu_supports("x86-64-v4");
  if (isa == "x86_64_v3") return __builtin_cpu_supports("x86-64-v3");
#endif
  return true;
}

std::array<GasKernels const*, 8> find_runnable() noexcept {
  std::array<GasKernels const*, 8> tables{};
  std::size_t n = 0;
  // one table an instruction set, the laws in the order of the registry
#define G27_FOR_ISA(isa)                                                                                               \
  static GasKernels const isa##_table{#isa, &isa::predictors, []<class... E>(std::variant<E...> const*) {              \
                                        return std::array<EosKernels const*, sizeof...(E)>{&isa::eos_kernels<E>()...}; \
                                      }(static_cast<AnyEos const*>(nullptr))};                                         \
  if (runs_here(#isa)) tables[n++] = &isa##_table;
  G27_FOR_EACH_ISA
#undef G27_FOR_ISA
  return tables;
}

}  // namespace

std::array<GasKernels const*, 8> const& runnable_gas_kernels() noexcept {
  static auto const tables = find_runnable();
  return tables;
}

GasKernels const& gas_kernels() {
  static GasKernels const* const chosen = [] {
    char const* const wanted = std::getenv("G27_ISA");
    GasKernels const* best = nullptr;
    for (GasKernels const* table : runnable_gas_kernels()) {
      if (table == nullptr) break;
      best = table;
      if (wanted != nullptr && std::string_view{wanted} == table->isa) break;
    }
    return best;
  }();
  if (chosen == nullptr) throw std::runtime_error("built for none of the instruction sets of this machine (G27_ISAS)");
  return *chosen;
}

PredictorKernel predictor_kernel(Predictor predictor, Switch monotonicity, FootPoints feet, bool single_foot) {
  bool const per_cell = feet != FootPoints::conservative;
  if (per_cell && (predictor != Predictor::linear || monotonicity != Switch::off)) {
    throw std::invalid_argument("the points of (3.10) go with the linear predictor and the switch off");
  }
  switch (predictor) {
    case Predictor::godunov:
      return PredictorKernel::godunov;
    case Predictor::muscl:
      return PredictorKernel::muscl;
    case Predictor::parabolic:
      return monotonicity == Switch::off ? PredictorKernel::parabolic_off : PredictorKernel::parabolic_on;
    case Predictor::linear:
      break;
  }
  if (per_cell) return PredictorKernel::linear_cell_feet;
  if (single_foot) return PredictorKernel::linear_single_foot;
  switch (monotonicity) {
    case Switch::off:
      return PredictorKernel::linear_off;
    case Switch::literal:
      return PredictorKernel::linear_literal;
    case Switch::binary:
      return PredictorKernel::linear_binary;
    case Switch::graded:
      return PredictorKernel::linear_graded;
  }
  return PredictorKernel::linear_graded;
}

}  // namespace g27
