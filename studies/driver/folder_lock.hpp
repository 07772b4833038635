#pragma once
/// One process at a time writes results into a folder.
#include <filesystem>
#include <string>

namespace g27 {

/// Held until it is destroyed or the process dies; leaves no file behind.
class FolderLock {
 public:
  /// Makes the folder. Throws InputError where it cannot be made, or where another process holds it.
  FolderLock(std::filesystem::path const& folder, std::string const& command);
  ~FolderLock();
  FolderLock(FolderLock const&) = delete;
  FolderLock& operator=(FolderLock const&) = delete;

 private:
  int folder_ = -1;
};

}  // namespace g27
