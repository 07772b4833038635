#pragma once
/// Lines that share a contact with what lies beyond one of their ends, and step together with it.
///
/// A step of both: the smaller `next_dt`; from each line the `trace` of its material at the contact, half of that step
/// on; the contact's Riemann problem (riemann/contact); an `attempt` of each with the pressure and the velocity found,
/// and `accept` of each. Where an attempt fails all is tried again with a smaller step: nothing has changed by then.
#include "riemann/contact/contact.hpp"

namespace g27 {

enum class LineEnd { left, right };

/// The contacts at the ends of a line, both with velocities along +x; of an end that has another boundary it is not
/// read.
struct LineContacts {
  Contact left{}, right{};
  [[nodiscard]] Contact const& at(LineEnd end) const noexcept { return end == LineEnd::left ? left : right; }
};

}  // namespace g27
