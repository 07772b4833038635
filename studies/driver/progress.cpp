#include "studies/driver/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace g27 {

std::string duration_text(double seconds) {
  auto const s = static_cast<long>(seconds + 0.5);
  if (s < 60) {
    return fmt::format("{} s", s);
  }
  return s < 3600 ? fmt::format("{} min {:02} s", s / 60, s % 60)
                  : fmt::format("{} h {:02} min", s / 3600, s / 60 % 60);
}

Progress::Progress(std::vector<double> weights)
    : weights_(std::move(weights)),
      fractions_(weights_.size(), 0.0),
      first_(weights_.size(), -1.0),
      began_(std::chrono::steady_clock::now()),
      shown_(began_),
      terminal_(isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() { clear(); }

void Progress::update(std::size_t part, double fraction, std::string const& what) {
  std::lock_guard const lock(mutex_);
  fractions_[part] = fraction;
  if (first_[part] < 0) {
    first_[part] = fraction;
  }
  double const total = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  double done = 0, gained = 0;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    done += weights_[k] * fractions_[k] / total;
    gained += weights_[k] * (fractions_[k] - std::max(first_[k], 0.0)) / total;
  }
  auto const now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - shown_).count() >= (terminal_ ? 0.1 : 10.0)) {
    shown_ = now;
    show(done, gained, what);
  }
}

void Progress::show(double fraction, double gained, std::string const& what) {
  double const elapsed = std::chrono::duration<double>(shown_ - began_).count();
  std::string const left =
      gained > 0.005 ? fmt::format(", {} left", duration_text(elapsed * (1 - fraction) / gained)) : "";
  fmt::print(stderr, "{}{:3.0f} %  {}{}{}", terminal_ ? "\r\033[K" : "", 100 * fraction, what, left,
             terminal_ ? "" : "\n");
  line_open_ = terminal_;
  std::fflush(stderr);
}

void Progress::clear() {
  if (line_open_) {
    fmt::print(stderr, "\r\033[K");
    line_open_ = false;
    std::fflush(stderr);
  }
}

void Progress::say(std::string const& line) {
  std::lock_guard const lock(mutex_);
  clear();
  fmt::print(stderr, "{}\n", line);
}

}  // namespace g27
