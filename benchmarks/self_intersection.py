# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long it takes to find whether a sweep meets itself, where, and up to which size it does not."""

from dataclasses import replace
from math import tau

from measuring import medians, short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw

CONTOURS, POINTS, ROUNDS, ASKED = 10_000, 64, 9, 50
KNOT, HELIX, PARABOLA, EIGHT = "(2,3) knot", "helix of 3 turns", "parabola", "figure-eight"
INTRODUCTION = f"""
### Self-intersection

Finding where a sweep of {CONTOURS:,} contours meets itself, each time on a trajectory that is new: milliseconds from
the parameters to the verdict, and to all places; medians of {ROUNDS} rounds. A round tube, of {POINTS} points, is
decided by the reach of its trajectory, others by their triangles; of these the largest safe size is a search of its
own. No peer has a row: none of them finds a self-intersection of a sweep.

"""


def trajectories(size):
    """The trajectories that are asked for, a little larger or smaller, by their names."""
    formula = sw.trajectories.Formula
    return {
        KNOT: sw.trajectories.TorusKnot(2, 3, 2.0 * size, 0.8 * size),  # its reach is 0.8
        HELIX: sw.trajectories.Helix(size, 0.5 * size, 3.0),  # 0.24921
        PARABOLA: formula("u", f"{4 / size!r}*u^2", "0", -1.0, 1.0),  # 0.125
        EIGHT: formula(f"{size!r}*sin(u)", f"{size!r}*sin(u)*cos(u)", "0", 0.0, tau),  # 0
    }


def sweeps():
    """Contours and the names of their trajectories, by what they are."""
    radii = {KNOT: (0.5, 0.7999, 0.8001, 0.9), HELIX: (0.2, 0.2492, 0.2494, 0.3), PARABOLA: (0.1, 0.13), EIGHT: (0.2,)}
    squares = {KNOT: (1.0, 1.3), HELIX: (0.2, 0.45), EIGHT: (0.2,)}
    tubes = {f"tube of {r:g} m, {path}": (sw.contours.Circle(r, POINTS), path) for path in radii for r in radii[path]}
    return tubes | {
        f"square of {side:g} m, {path}": (sw.contours.Rectangle(side, side), path)
        for path in squares
        for side in squares[path]
    }


def actions(questions):
    """What looks at each sweep anew and asks it each question, by the names of both."""

    def look(contour, path, ask):
        shape = sw.GeneralizedCylinder(contour, samples=sw.sampling.Count(CONTOURS))
        return lambda number: ask(replace(shape, trajectory=trajectories(1 + 1e-9 * number)[path]).self_intersections())

    return {(name, asked): look(*sweep, ask) for name, sweep in sweeps().items() for asked, ask in questions.items()}


def main():
    questions = {"verdict": bool, "all places": len, "largest safe size": lambda places: places.largest_safe_size}
    found = medians(actions(questions), ROUNDS)[0]
    rows = [[name, *(short(found[name, asked]) for asked in questions)] for name in sweeps()]
    page = [INTRODUCTION + table(["", *(f"{asked}, ms" for asked in questions)], rows), ""]
    page += [f"- {name}: {verdict(found[name, 'all places'], ASKED, ' ms')}" for name in sweeps() if "tube" in name]
    tell("\n".join(page))


main()
