"""Figures of the gas's density in the plane y = 0, through the centres of charge and bodies."""
from _paper import CM, density_limits, draw_density, plt, save, section_axes


def draw(run, state, out, what, close=False):
    """The whole section, and a closer look at the first body where asked."""
    figure, panels = plt.subplots(1, 2 if close else 1, figsize=(12.5 if close else 8, 6), constrained_layout=True,
                                  squeeze=False)
    limits = density_limits(state)
    for axes in panels[0]:
        image = draw_density(axes, state, limits)
        section_axes(axes, state.nodes)
    if close:
        corners = state.body("top").whole() / CM
        axes = panels[0, 1]
        axes.set_xlim(-1.5, 1.5)
        axes.set_ylim(corners[:, :, 2].min() - 1, corners[:, :, 2].max() + 1)
    figure.colorbar(image, ax=panels[0, -1], label="density of the gas [kg/m3]", shrink=0.85)
    figure.suptitle(f"{what}, y = 0\n{run.label(state)}", fontsize=10)
    save(figure, out)
