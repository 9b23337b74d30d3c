# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arcs of curves and texts: outlines are flattened, and where a curve was bent chords of one circle are arcs again."""

from dataclasses import replace
from functools import lru_cache

from ..core.contours import Outline
from ..core.contours.arc_recovery import recover_arcs
from ..core.declared.parameters import ShapeError, require
from . import curves

QUARTER = 2e-4  # of its size: what a circle of four Bezier segments is off at most


def outline(ob, depsgraph=None, scaled=True):
    """The outline of a curve or text object as `curves.outline` has it, with arcs where splines bend.

    Straight splines stay as they are drawn, also those whose corners lie on a circle. Letters that overlap, and
    drawings whose splines slip, have no arcs.
    """
    try:
        loops, bent = curves.as_shown(ob, depsgraph, loops_and_bends)
        require(loops, "must be a curve or text with an outline", ob.name)
        return with_arcs(Outline([loop * (ob.scale[:2] if scaled else 1.0) for loop in loops]), bent)
    except ShapeError:
        return curves.outline(ob, depsgraph, scaled)  # or the same refusal


def loops_and_bends(splines):
    """Splines as loops of points (n, 2), and which of them have points between their joints: a tuple of bool."""
    made = [trajectory for trajectory in map(curves.closed_trajectory, splines) if trajectory]
    loops = [curves.flattened(trajectory) for trajectory in made]
    joints = [len(trajectory.joints()) for trajectory in made]
    return loops, tuple(len(loop) > count for loop, count in zip(loops, joints, strict=True))


@lru_cache(maxsize=8)  # while a radius is dragged, the curve stays
def with_arcs(outline, bent):
    """An outline whose bent loops have arcs; ``bent`` is a tuple of bool, one for each loop."""
    if not any(bent):
        return outline
    found = recovered(outline)
    straight = [[0.0] * len(loop) for loop in outline.loops]
    pick = [(found.loops, found.bulges) if each else (outline.loops, straight) for each in bent]
    loops, bulges = zip(*((loops[i], bulges[i]) for i, (loops, bulges) in enumerate(pick)), strict=True)
    return replace(outline, loops=loops, bulges=bulges)


def recovered(outline):
    """An outline in which all chords of one circle are arcs, also where the circle was drawn in Bezier segments."""
    return recover_arcs(outline, QUARTER * outline.section().size)
