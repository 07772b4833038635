#include "studies/driver/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "studies/driver/input_error.hpp"

namespace g27 {

void write_atomically(std::filesystem::path const& file, std::span<std::byte const> bytes) {
  std::error_code unknown;
  auto const there = std::filesystem::status(file, unknown);
  if (std::filesystem::exists(there) && !std::filesystem::is_regular_file(there)) {
    throw OutputError(fmt::format("cannot write {}: it is no file", file.string()));
  }
  std::filesystem::path const temporary = file.string() + ".part";
  int const descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  int error = descriptor < 0 ? errno : 0;
  for (std::size_t done = 0; error == 0 && done < bytes.size();) {
    ssize_t const count = ::write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count >= 0) {
      done += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  if (error == 0 && ::fsync(descriptor) != 0 && errno != EINVAL) {  // EINVAL: not a file that can be flushed
    error = errno;
  }
  if (descriptor >= 0 && ::close(descriptor) != 0 && error == 0) {
    error = errno;
  }
  if (error == 0 && ::rename(temporary.c_str(), file.c_str()) != 0) {
    error = errno;
  }
  if (error != 0) {
    ::unlink(temporary.c_str());
    throw OutputError(fmt::format("cannot write {}: {}", file.string(), std::strerror(error)));
  }
}

void write_atomically(std::filesystem::path const& file, std::string_view text) {
  write_atomically(file, std::as_bytes(std::span(text)));
}

void make_output_folder(std::filesystem::path const& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError("g27", "--out", fmt::format("cannot create {}: {}", folder.string(), error.message()),
                     "choose another folder");
  }
}

}  // namespace g27
