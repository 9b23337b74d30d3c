# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The moves that a program makes: where each ends, how fast, by which line and with which tool."""

from dataclasses import dataclass

import numpy as np

from ...vectors import cross, dot, norms
from ..cells import cells

RAPID, FEED, ARC, SPLINE = range(4)
ROUND = {2: (0, 1), 1: (2, 0), 0: (1, 2)}  # the axis across a plane: those within it, from the first to the second


@dataclass(frozen=True, eq=False)
class Toolpath:
    """Moves of the tip of a tool, each from where the one before ended.

    Attributes
    ----------
    points : (n, 3) float array
        Where each move ends, in metres from the zero of the machine; the first begins there.
    kinds : (n,) int8 array
        0 for a rapid move, 1 for a straight one at a feed, 2 for an arc, 3 for a chord of a spline.
    lines : (n,) int32 array
        The line of the program that makes each, from 1.
    tools : (n,) int32 array
        The tool in the spindle, 0 before one is called.
    arcs : (k,) int array
        Which moves are arcs.
    centres, turns : (k, 3) float arrays
        Their centres, and their rotations: the axis times the angle in radians. What lies along the axis between the
        ends is covered evenly meanwhile: a helix.
    first : int
        The first move of which all of the start is known. Those before come from wherever the tool was.
    apart : (m,) int array
        Moves that lead to the home or to another place of the machine, which only it knows, or back from there.
    """

    points: np.ndarray
    kinds: np.ndarray
    lines: np.ndarray
    tools: np.ndarray
    arcs: np.ndarray
    centres: np.ndarray
    turns: np.ndarray
    first: int
    apart: np.ndarray

    def __len__(self):
        return len(self.points)

    @property
    def rapid(self):
        """Which moves are rapid: (n,) bool."""
        return self.kinds == RAPID

    @property
    def starts(self):
        """Where each move begins: (n, 3)."""
        return np.concatenate((np.zeros((1, 3)), self.points[:-1]))[: len(self)]

    def segments(self, tolerance):
        """Straight pieces of all moves that are known at both ends, with chords at most so far from arcs.

        Parameters
        ----------
        tolerance : float
            In metres.

        Returns
        -------
        starts, ends : (m, 3) float arrays
        moves : (m,) int array
            The move that each is part of.

        Examples
        --------
        >>> from sweep_addon.core.machining.programs import read
        >>> half = read("G21 F100\\nG0 X10 Y0 Z0\\nG3 X-10 I-10")
        >>> starts, ends, moves = half.segments(1e-3)
        >>> len(ends), bool(np.allclose(np.hypot(*ends[:, :2].T), 0.01))
        (4, True)
        """
        counts = self.pieces(tolerance)
        moves = np.repeat(np.arange(len(self)), counts)
        ends = self.points[moves]
        chords, first = counts[self.arcs], np.cumsum(counts) - counts
        inner = np.maximum(chords - 1, 0)  # the last point of an arc is that of the program itself
        arc, before, _ = cells(inner, np.ones_like(inner))
        ends[first[self.arcs[arc]] + before] = self.along_arcs(arc, (before + 1) / chords[arc])
        starts = np.concatenate((np.zeros((1, 3)), ends[:-1]))[: len(ends)]
        led_to = first[[move for move in (self.first, *self.apart + 1) if move < len(self) and counts[move]]]
        starts[led_to] = self.starts[moves[led_to]]
        return starts, ends, moves

    def along_arcs(self, arc, parts):
        """Points of some arcs (k,) at parts of their ways; a radius goes evenly from that of the start to the end's."""
        starts, angles = self.starts[self.arcs], norms(self.turns)
        axes = self.turns / angles[:, None]
        out, final = starts - self.centres, self.points[self.arcs] - self.centres
        risen, rise = dot(out, axes), dot(final - out, axes)
        radial, final = out - risen[:, None] * axes, final - (risen + rise)[:, None] * axes
        growth = norms(final) / np.maximum(norms(radial), 1e-300) - 1
        turned, wide = (angles[arc] * parts)[:, None], (1 + parts * growth[arc])[:, None]
        around = np.cos(turned) * radial[arc] + np.sin(turned) * cross(axes, radial)[arc]
        return self.centres[arc] + wide * around + (risen[arc] + parts * rise[arc])[:, None] * axes[arc]

    def pieces(self, tolerance):
        """How many straight pieces each move has: one, an arc as many as keep within a tolerance: (n,) int array."""
        counts = np.ones(len(self), dtype=np.int64)
        counts[self.arcs] = chords(self.radii(), np.linalg.norm(self.turns, axis=1), tolerance)
        counts[: self.first] = 0
        counts[self.apart] = 0
        return counts

    def radii(self):
        """The larger of the radii of each arc at its ends: (k,)."""
        normals = self.turns / np.linalg.norm(self.turns, axis=1, keepdims=True) if len(self.arcs) else self.turns
        return np.maximum(
            *(
                np.linalg.norm(np.cross(normals, ends[self.arcs] - self.centres), axis=1)
                for ends in (self.starts, self.points)
            )
        )


def chords(radii, angles, tolerance):
    """How many equal chords stay within a tolerance of arcs: (k,)."""
    sagitta = np.clip(tolerance / np.maximum(radii, 1e-300), 1e-12, 1.0)
    return np.maximum(1, np.ceil(angles / (2 * np.arccos(1 - sagitta)) - 1e-9)).astype(np.int64)
