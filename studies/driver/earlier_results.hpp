#pragma once
/// Results that a folder holds when a run begins there. They are kept in its folder `earlier` until the new run is
/// complete: results of two scenes never mix, and none are lost before there are others.
#include <filesystem>

namespace g27 {

class EarlierResults {
 public:
  explicit EarlierResults(std::filesystem::path const& out);
  /// Says where they are, if they are still there.
  ~EarlierResults();
  EarlierResults(EarlierResults const&) = delete;
  EarlierResults& operator=(EarlierResults const&) = delete;

  /// Takes those of the last run, as its summary lists them; those of a run that failed are removed. Throws InputError.
  void set_aside() const;
  void remove() const;

 private:
  std::filesystem::path out_, aside_;
};

}  // namespace g27
