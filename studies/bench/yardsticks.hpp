#pragma once
/// What the machine can do, measured: the yardsticks that rates of cell updates are held against.
namespace g27 {

/// Bytes that a triad a = b + s c moves in a second with `threads` threads, 24 bytes an element counted [GB/s].
double triad_gb_per_s(int threads);

/// Fused multiply-adds of the widest vectors of this machine on one core, two operations each [GFLOP/s].
double fma_gflops_per_core();

/// CPU time of this process [s].
double process_cpu_seconds();

}  // namespace g27
