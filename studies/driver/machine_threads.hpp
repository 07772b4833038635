#pragma once
/// How many threads a command takes.
#include <algorithm>
#include <thread>

namespace g27 {

/// As many as asked for; 0: all of the machine.
inline int threads_or_all(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace g27
