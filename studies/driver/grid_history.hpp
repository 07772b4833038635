#pragma once
/// What a run on a grid records as it goes. The same rows come from the line of a first phase.
#include "studies/driver/history.hpp"

namespace g27 {

/// time, dt, max_pressure, total_mass, total_energy (with bodies: of the gas outside of them), active_share,
/// stored_share; shock/x, /y, (/z), /diagonal where there is a threshold; of every probe density, speed, its components
/// and pressure.
std::vector<HistoryColumn> grid_columns(OutputPlan const& plan, int dimensions);

/// A state to look at: a grid's, or a line's around its centre.
class GridView {
 public:
  virtual ~GridView() = default;
  [[nodiscard]] virtual GasPoint at(Vec3 const& x) const = 0;
  [[nodiscard]] virtual double max_pressure() const = 0;
};

/// Linear between the centres of the cells; next to a block, the state of the cell itself.
class GridFieldView : public GridView {
 public:
  explicit GridFieldView(GasGrid const& grid) : grid_(&grid) {}
  [[nodiscard]] GasPoint at(Vec3 const& x) const override;
  [[nodiscard]] double max_pressure() const override;

 private:
  GasGrid const* grid_;
};

class LineFieldView : public GridView {
 public:
  LineFieldView(GasLine const& line, Vec3 const& centre, int dimensions)
      : line_(&line), centre_(centre), dimensions_(dimensions) {}
  [[nodiscard]] GasPoint at(Vec3 const& x) const override;
  [[nodiscard]] double max_pressure() const override;

 private:
  GasLine const* line_;
  Vec3 centre_;
  int dimensions_;
};

/// What a row holds beside the view.
struct GridRowFacts {
  double time = 0, dt = 0;
  double total_mass = 0, total_energy = 0;    ///< NaN in the first phase
  double active_share = 1, stored_share = 1;  ///< of cell updates done since the last row; of cells stored
};
std::vector<double> grid_row(GridView const& view, GridRun const& run, OutputPlan const& plan,
                             GridRowFacts const& facts);

/// Distance from `origin` along a ray (an index of ray_names(), towards the farther side) at which the pressure falls
/// through `threshold`, seen from outside; NaN when it is nowhere above.
double shock_radius(GridView const& view, GasGridSetup const& box, Vec3 const& origin, std::size_t ray,
                    double threshold);

}  // namespace g27
