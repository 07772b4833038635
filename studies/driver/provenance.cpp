#include "studies/driver/provenance.hpp"

#include <ctime>

#include "scheme/kernel/gas_kernels.hpp"

namespace g27 {
namespace {

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
  return {{"version", facts.version},
          {"commit", facts.commit},
          {"compiler", facts.compiler},
          {"build_type", facts.build_type},
          {"flags", facts.flags},
          {"sources", facts.sources},
          {"instruction_set", gas_kernels().isa},
          {"threads", std::to_string(threads)},
          {"date", utc_now()}};
}

}  // namespace g27
