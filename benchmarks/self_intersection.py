# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How long it takes to find whether a sweep meets itself, where, and up to which size it does not."""

from dataclasses import replace
from itertools import count, product
from math import tau

from measuring import medians, short, table, tell, verdict

from bl_ext.user_default import sweep_addon as sw

CONTOURS, POINTS, ROUNDS, ASKED = 10_000, 64, 5, 50
KNOT, HELIX, PARABOLA, EIGHT = "(2,3) knot", "helix of 3 turns", "parabola", "figure-eight"
INTRODUCTION = f"""
### Self-intersection

Finding where a sweep of {CONTOURS:,} contours meets itself, each time on a trajectory that is new: milliseconds from
the parameters to the verdict, and to all places; medians of {ROUNDS} rounds. A round tube, of {POINTS} points, is
decided by the reach of its trajectory, which is its largest safe size too; others by their triangles, and their size is
a search. No peer has a row: none of them finds a self-intersection of a sweep.

"""


def formula(x, y, start, end):
    return sw.trajectories.Formula(x, y, "0", start, end)


TRAJECTORIES = {  # all a little larger or smaller
    KNOT: lambda size: sw.trajectories.TorusKnot(2, 3, 2.0 * size, 0.8 * size),  # its reach is 0.8
    HELIX: lambda size: sw.trajectories.Helix(size, 0.5 * size, 3.0),  # 0.24921
    PARABOLA: lambda size: formula("u", f"{4 / size!r}*u^2", -1.0, 1.0),  # 0.125
    EIGHT: lambda size: formula(f"{size!r}*sin(u)", f"{size!r}*sin(u)*cos(u)", 0.0, tau),  # 0
}
TUBES = {KNOT: (0.5, 0.7999, 0.8001, 0.9), HELIX: (0.2, 0.2492, 0.2494, 0.3), PARABOLA: (0.1, 0.13), EIGHT: (0.2,)}
SQUARES = {KNOT: (1.0, 1.3), HELIX: (0.2, 0.45), EIGHT: (0.2,)}
VERDICT, PLACES, SIZE = "verdict", "all places", "largest safe size"
QUESTIONS = {VERDICT: bool, PLACES: len, SIZE: lambda places: places.largest_safe_size}


def sweeps():
    """Contours and the names of their trajectories, by what they are."""
    tubes = {f"tube of {r:g} m, {path}": (sw.contours.Circle(r, POINTS), path) for path in TUBES for r in TUBES[path]}
    return tubes | {
        f"square of {side:g} m, {path}": (sw.contours.Rectangle(side, side), path)
        for path in SQUARES
        for side in SQUARES[path]
    }


def actions():
    """What looks at each sweep anew and asks it a question, by the names of both."""
    fresh = count()

    def look(contour, path, question):
        shape = sw.GeneralizedCylinder(contour, samples=sw.sampling.Count(CONTOURS))
        make, ask = TRAJECTORIES[path], QUESTIONS[question]
        return lambda _: ask(replace(shape, trajectory=make(1 + 1e-9 * next(fresh))).self_intersections())

    asked = product(sweeps().items(), QUESTIONS)
    return {(name, question): look(*sweep, question) for (name, sweep), question in asked if has(name, question)}


def has(name, question):
    """Whether a question is asked: the size of a tube is never searched for."""
    return question != SIZE or name.startswith("square")


def main():
    found = medians(actions(), ROUNDS)[0]
    rows = [[name, *(short(found[name, q]) if has(name, q) else "" for q in QUESTIONS)] for name in sweeps()]
    page = [INTRODUCTION + table(["", *(f"{question}, ms" for question in QUESTIONS)], rows), ""]
    page += [f"- {name}: {verdict(found[name, PLACES], ASKED, ' ms')}" for name in sweeps() if not has(name, SIZE)]
    tell("\n".join(page))


main()
