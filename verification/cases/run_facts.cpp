#include "verification/cases/run_facts.hpp"

#include <ctime>
#include <stdexcept>

#include "verification/cases/case.hpp"

namespace g27 {

int order_of(Predictor p) noexcept { return p == Predictor::godunov ? 1 : p == Predictor::parabolic ? 3 : 2; }

char const* name_of(Predictor p) noexcept {
  switch (p) {
    case Predictor::godunov:
      return "godunov";
    case Predictor::linear:
      return "linear";
    case Predictor::parabolic:
      return "parabolic";
    case Predictor::muscl:
      return "muscl";
  }
  return "";
}

char const* name_of(Switch s) noexcept {
  switch (s) {
    case Switch::off:
      return "off";
    case Switch::literal:
      return "literal";
    case Switch::binary:
      return "binary";
    case Switch::graded:
      return "graded";
  }
  return "";
}

double cpu_seconds() noexcept {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

double value_of(std::vector<CaseParameter> const& parameters, CaseOptions const& options, std::string const& name) {
  if (auto const given = options.values.find(name); given != options.values.end()) return given->second;
  for (CaseParameter const& p : parameters) {
    if (p.name == name) return p.value;
  }
  throw std::invalid_argument("no parameter '" + name + "'");
}

}  // namespace g27
