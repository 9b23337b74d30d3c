# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Figures: what a turtle has drawn, as arrays."""

from functools import cached_property

import numpy as np

from ..frozen import individual


@individual
class Figure:
    """Segments, polygons and organs that a turtle has left on its way through a word.

    Attributes
    ----------
    start, end : (n, 3) float array
        The ends of each segment, in metres.
    width : (n,) float array
        Diameters, in metres.
    colour : (n,) float array
        Numbers of colours.
    place : (n,) int array
        The module of each segment in the word that was interpreted.
    parent : (n,) int array
        The segment that each goes on from, or -1.
    branch : (n,) int array
        The branch of each segment: the part of the word within one pair of brackets.
    joined : (n,) bool array
        Whether it begins where its parent ends, in the same branch.
    birth : (n,) int array
        The step of the derivation that made it.
    orientations : callable
        Gives a pair of (n,) complex arrays, the orientation of each segment as a quaternion; `axes` has it as vectors.
    at : (3,) float array
        Where the turtle is at the end.
    polygons : tuple of (k, 3) float array
        Their vertices, in metres.
    organs : tuple of Organ
    """

    start: np.ndarray
    end: np.ndarray
    width: np.ndarray
    colour: np.ndarray
    place: np.ndarray
    parent: np.ndarray
    branch: np.ndarray
    joined: np.ndarray
    birth: np.ndarray
    orientations: object
    at: np.ndarray
    polygons: tuple = ()
    organs: tuple = ()

    @cached_property
    def axes(self):
        """(n, 3, 3) float array: heading, left and up of the turtle on each segment."""
        from .turns import axes

        return axes(*self.orientations())

    @property
    def bounds(self):
        """(2, 3) float array: the least and the greatest coordinates of all segments, in metres."""
        if not len(self.start):
            return np.zeros((2, 3))
        return np.array([np.minimum(self.start, self.end).min(axis=0), np.maximum(self.start, self.end).max(axis=0)])

    @cached_property
    def axis(self):
        """(n,) int array: the poly-line that each segment is part of.

        One goes on from segment to segment of a branch until the turtle moves without drawing; each branch begins its
        own.
        """
        order = np.argsort(self.branch, kind="stable")
        number = np.empty(len(order), dtype=np.intp)
        number[order] = np.cumsum(~self.joined[order]) - 1
        return number

    @cached_property
    def order(self):
        """(n,) int array: of how many others the branch of each segment grows out of another: 0 for the stem."""
        first = np.flatnonzero(~self.joined)
        grown = self.branch[first] != np.append(self.branch, -1)[self.parent[first]]
        steps = (grown & (self.parent[first] >= 0)).astype(np.intp)
        of_axis = np.empty(len(first), dtype=np.intp)
        of_axis[self.axis[first]] = np.arange(len(first))
        above = np.where(self.parent[first] >= 0, of_axis[self.axis[self.parent[first]]], -1)
        while (above >= 0).any():
            steps = steps + np.where(above >= 0, steps[above], 0)
            above = np.where(above >= 0, above[above], -1)
        return steps[of_axis[self.axis]]
