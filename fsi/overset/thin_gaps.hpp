#pragma once
/// The second core of gas of a triangle before which there is another surface, nearer than that core.
#include "fsi/overset/body.hpp"

namespace g27 {

/// Goes in dt [s] to the state of the first core. To be called once the cells have been classified anew.
void tie_thin_gaps(Body& body, double dt);

}  // namespace g27
