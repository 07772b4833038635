#pragma once
/// Progress on stderr: one line updated in place on a terminal, a plain line every ten seconds elsewhere.
#include <chrono>
#include <mutex>
#include <string>
#include <vector>

namespace g27 {

class Progress {
 public:
  /// `parts` run side by side or in turn; `weights` are their shares of the work.
  explicit Progress(std::vector<double> weights);
  ~Progress();
  Progress(Progress const&) = delete;
  Progress& operator=(Progress const&) = delete;

  /// Part `part` is `fraction` done; `what` says what it is. Safe from several threads.
  void update(std::size_t part, double fraction, std::string const& what);
  /// Prints a line of its own, clear of the moving one.
  void say(std::string const& line);
  /// Takes the moving line away, where no other thread puts it back.
  void clear();

 private:
  void show(double fraction, double gained, std::string const& what);

  std::mutex mutex_;
  std::vector<double> weights_, fractions_;
  std::vector<double> first_;  ///< fractions at the first update: an earlier process's work tells nothing of our speed
  std::chrono::steady_clock::time_point began_, shown_;
  bool terminal_, line_open_ = false;
};

/// "3 s", "2 min 05 s", "1 h 12 min"
std::string duration_text(double seconds);

}  // namespace g27
