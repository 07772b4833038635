#include "studies/driver/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "studies/driver/atomic_file.hpp"
#include "studies/driver/input_error.hpp"

namespace g27 {

FolderLock::FolderLock(std::filesystem::path const& folder, std::string const& command) {
  make_output_folder(folder);
  folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  // a file system without locks does not keep anybody from computing
  if (folder_ >= 0 && ::flock(folder_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    ::close(folder_);
    throw InputError(command, "--out", fmt::format("another process writes its results into {}", folder.string()),
                     "wait until it is done, or choose another folder");
  }
}

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

}  // namespace g27
