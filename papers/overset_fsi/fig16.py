"""Shapes and places of the bodies at the start, at 13 us and at the end.

usage: fig16.py RUN.h5 OUT.png
"""
# needs: three-cubes
import numpy as np
from _paper import US, arguments, plt, save, solid, view

COLOURS = ([0.70, 0.72, 0.75], [0.45, 0.62, 0.80], [0.80, 0.47, 0.42])


def main():
    runs, out = arguments()
    run = runs[0]
    states = [run.states[0], run.near(13 * US), run.states[-1]]
    if len({state.time for state in states}) < 3:
        states = [run.states[0], run.states[-1]]
    figure = plt.figure(figsize=(4.2 * len(states), 8), constrained_layout=True)
    everything = np.concatenate([body.whole() for state in states for body in state.bodies()])
    largest = max((state.body("top").whole() for state in states), key=lambda c: np.ptp(c, axis=(0, 1)).max())
    for n, state in enumerate(states):
        axes = figure.add_subplot(2, len(states), n + 1, projection="3d")
        for body in state.bodies():
            solid(axes, body.whole(), COLOURS[n])
        view(axes, everything)
        axes.set_title(f"{state.time / US:.3g} us", fontsize=10)
        axes = figure.add_subplot(2, len(states), len(states) + n + 1, projection="3d")
        corners = state.body("top").whole()
        solid(axes, corners, COLOURS[n])
        view(axes, largest + (corners.mean(axis=(0, 1)) - largest.mean(axis=(0, 1))))
        axes.set_title(f"{state.body('top').name}, {state.time / US:.3g} us", fontsize=10)
    figure.suptitle(f"Shapes of the bodies\n{run.label()}", fontsize=10)
    save(figure, out)


if __name__ == "__main__":
    main()
