"""Where the characteristics that meet a face at half a time step start: the points that states are taken from."""


def draw(axes, width, dt, speeds):
    """A face at x = 0 between two cells of one width; {name: (speed, colour)}; lengths in cells, times in steps."""
    feet = {name: -speed * dt / 2 / width for name, (speed, _) in speeds.items()}
    axes.fill([min(feet.values()), max(feet.values()), 0], [0, 0, 0.5], color="0.9", zorder=0, label="zone of influence")
    for edge in (-1, 0, 1):
        axes.plot([edge, edge], [0, 1], color="k", lw=1.6 if edge == 0 else 0.8)
    for centre in (-0.5, 0.5):
        axes.plot([centre], [0], "ko", ms=7)
    for name, (_, colour) in speeds.items():
        axes.plot([feet[name], 0], [0, 0.5], color=colour, lw=1.8, label=f"{name}: starts at {feet[name]:+.3f} cells")
        axes.plot([feet[name]], [0], "x", color=colour, ms=10, mew=2)
    for t in (0, 0.5, 1):
        axes.axhline(t, color="0.5", lw=0.6)
    axes.set_xlim(-1.05, 1.05)
    axes.set_ylim(-0.06, 1.02)
    axes.set_xlabel("distance from the face [cells]; dots: centres of the cells")
    axes.set_ylabel("time [steps]")
    axes.legend(loc="upper left", fontsize=8)
