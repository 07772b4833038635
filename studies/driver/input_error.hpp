#pragma once
/// A mistake in what the user gave: a scene, a key, an argument. The program prints it and exits with status 2.
#include <stdexcept>
#include <string>

namespace g27 {

struct InputError : std::runtime_error {
  /// file: path, with `:line:column` where known; key: dotted key or option; what: what is wrong; remedy: what to do
  InputError(std::string file_, std::string key_, std::string what_, std::string remedy_)
      : std::runtime_error(file_ + ": " + key_ + ": " + what_ + "; " + remedy_),
        file(std::move(file_)),
        key(std::move(key_)),
        problem(std::move(what_)),
        remedy(std::move(remedy_)) {}

  std::string file, key, problem, remedy;
};

}  // namespace g27
