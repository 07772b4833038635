#include "verification/measure/memory.hpp"

#include <unistd.h>

#include <cstdio>
#include <stdexcept>

namespace g27 {

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

void require_memory(double cells, double bytes_each) {
  double const needed = cells * bytes_each, present = physical_memory();
  if (needed <= present) return;
  char text[160];
  std::snprintf(text, sizeof text, "%.3g cells take %.3g GB and the machine has %.3g GB", cells, needed / 1e9,
                present / 1e9);
  throw std::invalid_argument(text);
}

}  // namespace g27
