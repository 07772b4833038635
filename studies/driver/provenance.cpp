#include "studies/driver/provenance.hpp"

#include <ctime>

namespace g27 {
namespace {

/// The widest instruction set of this processor for which kernels exist.
std::string instruction_set() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("x86-64-v4")) {
    return "x86-64-v4";
  }
  if (__builtin_cpu_supports("x86-64-v3")) {
    return "x86-64-v3";
  }
  return "x86-64";
#else
  return "baseline";
#endif
}

std::string utc_now() {
  std::time_t const now = std::time(nullptr);
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> provenance(int threads) {
  BuildFacts const facts = build_facts();
  return {{"version", facts.version},           {"commit", facts.commit}, {"compiler", facts.compiler},
          {"build_type", facts.build_type},     {"flags", facts.flags},   {"instruction_set", instruction_set()},
          {"threads", std::to_string(threads)}, {"date", utc_now()}};
}

}  // namespace g27
