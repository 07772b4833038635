#pragma once
/// Whether a run fits into the machine.

namespace g27 {

/// Memory of the machine [B].
double physical_memory();

/// Bytes of a cell when every tile is stored: two states of five doubles, ghosts and work arrays; of a solid twelve.
constexpr double gas_cell_bytes = 84, solid_cell_bytes = 210;

/// Throws std::invalid_argument when `cells` of `bytes_each` [B] are more than the machine's memory.
void require_memory(double cells, double bytes_each);

}  // namespace g27
