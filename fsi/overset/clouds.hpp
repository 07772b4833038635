#pragma once
/// The cores of the local grids as donors to the cells and the local grids around them.
#include <memory>
#include <vector>

#include "fsi/overset/body.hpp"

namespace g27 {

/// Gas cores of all bodies, and their images, that lie in the gas within a body's window.
void set_gas_cloud(Body& body, std::vector<std::unique_ptr<Body>> const& all);

/// Cores of a body in itself. Those of its first layer give always: thin rims hold nothing else.
void set_solid_cloud(Body& body);

}  // namespace g27
