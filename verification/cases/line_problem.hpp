#pragma once
/// A one-dimensional problem as data, and how it is run on a mesh and held against its reference.
#include <functional>
#include <string>
#include <vector>

#include "verification/cases/case.hpp"

namespace g27 {

/// Mean of the conserved densities over a cell [a, b].
using CellMean = std::function<GasConserved<>(double a, double b)>;

struct LineProblem {
  AnyEos eos{};
  double x0 = 0, x1 = 1, t_end = 1;
  GasBoundary left{}, right{};
  CellMean initial{};
  CellMean reference{};  ///< at t_end; empty: none
  Symmetry symmetry = Symmetry::planar;
  MeshMotion motion{};  ///< the problem's own; a mesh chosen by the options overrides it
  GasSource source{};
  ProgrammedBurn burn{};
  double cfl = 0.8;
  Switch monotonicity = Switch::graded;
};

/// Faces of a mesh of the family `kind`: uniform graded alternating random moving moving-random. The moving ones start
/// as uniform and random. The random ones are the same at every call. Throws std::invalid_argument.
std::vector<double> mesh_faces(std::string const& kind, double x0, double x1, int cells);
/// Their motion, for a run that ends at t_end; the ends of the line stay.
MeshMotion mesh_motion(std::string const& kind, double x0, double x1, int cells, double t_end);

/// Cell mean of a state given at points, by Gauss quadrature.
CellMean mean_of(AnyEos const& eos, Symmetry symmetry, std::function<GasState<>(double x)> state, int points = 5);

/// Both boundaries periodic.
void make_periodic(LineProblem& problem);

/// Runs the problem; throws std::runtime_error when a step fails. `cells`: unless the options say otherwise.
CaseResult run_problem(std::string const& name, int cells, LineProblem problem, CaseOptions const& options);

}  // namespace g27
