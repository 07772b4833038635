#pragma once
/// What tells scenes apart by their results.
#include <string>
#include <vector>

#include "studies/driver/document.hpp"
#include "studies/driver/scene.hpp"

namespace g27 {

/// Digest of all in a scene that determines its results: the keys after --set (`root`), in whatever order and however
/// written, and the bytes of the surfaces (`runs`).
std::string scene_digest(Node const& root, std::vector<SceneRun> const& runs);

}  // namespace g27
