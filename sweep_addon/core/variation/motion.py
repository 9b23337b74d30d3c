# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Motion: where a generator is at each place of a trajectory, how it is turned and scaled there, and deformed.

A point x of the generator goes to t(u) + F(u) Rz Ry Rx S d(x, t): first it is deformed, then scaled along the
generator's axes, turned about its x, y and z axis, put into the frame, and moved.
"""

from functools import cached_property
from typing import NamedTuple

import numpy as np

from ..declared.frozen import frozen
from ..declared.parameters import at
from ..formulas.expressions import compile
from ..meshes.mesh import require_few
from ..shapes.general_sweep import PLACES
from ..stations.frames import Parallel, axes
from ..stations.rotations import turned
from ..stations.sampling import place, stations
from ..trajectories.arc_length import arc_length
from ..vectors import columns, cross, dot, norms
from .laws import Constant, Law
from .legs import between, legs, on_leg

FOLLOWED = 32  # points of the generator whose ways say how closely it stands
ROUNDS = 5  # of Newton's method
DIFFERENCE = 1e-6  # of the size: over which slopes of formulas are taken
SINGULAR = 1e-9  # a determinant of less turns no way back
SAME = 1e-9  # of how far points move: nearer to where it began a generator is back
UNSCALED, UNDEFORMED = (Constant(1.0),) * 3, ("x", "y", "z")


class Poses(NamedTuple):
    """A generator at some places of its way."""

    u: np.ndarray  # the trajectory's parameter: (n,)
    s: np.ndarray  # the arc length in metres: (n,)
    t: np.ndarray  # from 0 to 1: (n,)
    origin: np.ndarray  # where the reference point is: (n, 3)
    matrix: np.ndarray  # whose columns are where the generator's axes point, scaled: (n, 3, 3)
    told: tuple  # sentences for people

    def only(self, which):
        """Some of the poses."""
        return Poses(*(part[which] for part in self[:-1]), self.told)

    def thinned(self, most):
        """The poses, or so many of them, the first and the last among them."""
        return self.only(np.unique(np.linspace(0, len(self.s) - 1, min(most, len(self.s))).round().astype(int)))


@frozen
class Motion:
    """A trajectory, and what becomes of the generator on it.

    Parameters
    ----------
    trajectory : Trajectory
    frame : Parallel or Frame
        In a frame the generator's x and y axes lie along e2 and e3, as a contour's do, and its z axis along e1.
    turns, scales : tuple of three Law
        About and along the generator's own axes.
    formulas : tuple of three str
        Where a point of the generator goes before it is scaled: expressions of `PLACES`.
    """

    trajectory: object
    frame: object
    turns: tuple[Law, ...]
    scales: tuple[Law, ...]
    formulas: tuple[str, ...]

    def poses(self, placed):
        """The `Poses` at `Stations`."""
        u, s, t = placed.u, placed.s, placed.t
        matrix, told = self.framed(placed)
        for axis, (name, law) in reversed(
            list(enumerate(zip(("turn_x", "turn_y", "turn_z"), self.turns, strict=True)))
        ):
            with at(name):
                matrix = matrix @ about(axis, law.evaluate(u, t, s))
        scale = np.empty((len(s), 1, 3))
        for axis, law in enumerate(self.scales):
            with at(f"scale_{'xyz'[axis]}"):
                scale[:, 0, axis] = law.evaluate(u, t, s)
        return Poses(u, s, t, placed.points, matrix * scale, self.trajectory.told + told)

    def framed(self, placed):
        """The axes of the frame as columns, (n, 3, 3), and what is to be told of it."""
        if isinstance(self.frame, Parallel):
            return np.broadcast_to(np.eye(3), (len(placed.s), 3, 3)), ()
        e2, e3, told = axes(self.frame, placed, np.zeros(len(placed.s)))
        return np.stack((e2, e3, placed.tangent), axis=-1), told

    def at(self, s):
        """The `Poses` at arc lengths that begin with 0."""
        return self.poses(stations(self.trajectory, s))

    def posed(self, points, poses):
        """Where points of the generator, (k, 3), are in some poses: (n, k, 3)."""
        return self.deformed(points, poses) @ poses.matrix.swapaxes(1, 2) + poses.origin[:, None]

    def each(self, points, poses):
        """Where points of the generator, (n, 3), are in a pose each: (n, 3)."""
        if self.deforms:
            known, given = {name: getattr(poses, name) for name in "tus"}, points
            points = points.copy()
            for axis in self.moved:
                with at(f"deform_{'xyz'[axis]}"):
                    points[:, axis] = self.taken(axis, given, known)
        return np.einsum("nij,nj->ni", poses.matrix, points) + poses.origin

    def deformed(self, points, poses):
        """Points of the generator, (k, 3), as they are deformed in some poses: (n, k, 3), or (1, k, 3) if they stay."""
        if not self.deforms:
            return points[None]
        known = dict(zip("xyz", points.T[:, None], strict=True))
        known |= {name: getattr(poses, name)[:, None] for name in "tus"}
        made = np.empty((len(poses.t), len(points), 3))
        for axis, formula in enumerate(self.formulas):
            with at(f"deform_{'xyz'[axis]}"):
                made[..., axis] = compile(formula, PLACES).evaluate(**known)
        return made

    def undeformed(self, places, **known):
        """The points of the generator that a deformation takes to places (n, 3), by Newton's method.

        Parameters
        ----------
        places : (n, 3) float array
        **known : (n,) float arrays
            The t, u and s of each.

        Returns
        -------
        points : (n, 3) float array
        missed : (n,) float array
            How far from their places they are taken: more than rounding where there is no such point near.
        """
        size = max(float(np.abs(places).max(initial=0.0)), 1e-300)
        points = places.copy()
        off = self.displaced(points, known) - places
        for _ in range(ROUNDS):
            if np.abs(off).max(initial=0.0) <= SAME * size:
                break
            points -= solved(self.slopes(points, known, off + places, DIFFERENCE * size), off)
            off = self.displaced(points, known) - places
        return points, norms(off)

    @cached_property
    def moved(self):
        """The axes along which something is deformed: a list."""
        return [axis for axis, name in enumerate("xyz") if self.formulas[axis].strip() != name]

    def displaced(self, points, known):
        """Where a deformation takes points (n, 3) with a t, a u and an s each: (n, 3)."""
        made = columns(points.shape)
        for axis in range(3):
            made[:, axis] = self.taken(axis, points, known) if axis in self.moved else points[:, axis]
        return made

    def taken(self, axis, points, known):
        """Where it takes them along an axis: (n,), or a number of a formula that is constant."""
        formula, known = compile(self.formulas[axis], PLACES), known | dict(zip("xyz", points.T, strict=True))
        found = formula.run(known)
        if not np.isfinite(found).all():
            formula.evaluate(**known)  # refuses, and says where
        return found

    def slopes(self, points, known, found, step):
        """How what it makes of points, found (n, 3), changes along each axis: three (n, 3) float arrays."""
        slopes = []
        for axis, way in zip("xyz", np.eye(3), strict=True):
            slope = columns(points.shape)
            slope[:] = way
            for other in self.moved:
                changes = axis in compile(self.formulas[other], PLACES).names
                beside = self.taken(other, points + step * way, known) if changes else found[:, other]
                slope[:, other] = (beside - found[:, other]) / step
            slopes.append(slope)
        return slopes

    @property
    def rigid(self):
        """The motion without what it makes of the generator itself: its scales and its deformation."""
        return Motion(self.trajectory, self.frame, self.turns, UNSCALED, UNDEFORMED)

    @property
    def deforms(self):
        """Whether anything is deformed."""
        return len(self.moved) > 0

    def comes_back(self, points):
        """Whether a closed trajectory brings points of the generator back to where they began."""
        if not self.trajectory.closed:
            return False
        total = arc_length(self.trajectory).total
        placed = stations(self.trajectory, np.array([0.0, total * SAME, total / 2, total * (1 - SAME)]))
        poses = self.poses(placed)
        if 0 in placed.corners and not isinstance(self.frame, Parallel):  # there it stands in the bisector plane
            ways = np.repeat((placed.leave[-1:], placed.tangent[:1]), 3, axis=1)
            poses.matrix[-1] = turned(poses.matrix[-1].T, *ways).T
        near = self.posed(points, poses)
        back = norms(near[3] - near[0]).max()
        return bool(back <= 100 * SAME * max(norms(near[2] - near[0]).max(), total))

    def standing(self, points, samples, vertices, ends=0):
        """The poses in which a generator stands on each leg, and whether it comes back to the first.

        Parameters
        ----------
        points : (k, 3) float array
            Of the generator.
        samples : Count or Tolerance
        vertices, ends : int
            How many there are at each place, and besides: of a mesh of too many the samples are refused.

        Returns
        -------
        list of (Poses, bool)
            Where a closed trajectory does not bring it back, it ends in a pose of its own. Where its frame turns at
            corners each leg is by itself.
        """
        found = legs(self, self.comes_back(points))
        if not len(found):
            return [self.stands(points, samples, vertices, ends)]
        placed = self.stations(points, samples)
        require_few(len(placed.s) * vertices + ends, "samples")
        return [(on_leg(self, leg, between(placed, leg)), False) for leg in found]

    def stands(self, points, samples, vertices, ends=0):
        """The same as if it had one leg: poses, and whether it comes back."""
        placed = self.stations(points, samples)
        require_few(len(placed.s) * vertices + ends, "samples")
        back = self.comes_back(points)
        if self.trajectory.closed and not back:  # it ends elsewhere, or turned
            return self.at(np.append(placed.s, placed.total)), False
        return self.poses(placed), back

    def stations(self, points, samples):
        """The stations at which the chords of all points of the generator keep a tolerance, or so many."""
        some = points[np.unique(np.linspace(0, len(points) - 1, FOLLOWED).round().astype(int))]

        def steps(s, u, chord):
            poses = self.at(s)
            beside = self.posed(some, poses) - poses.origin[:, None]  # the bends of the trajectory itself are counted
            bends = np.gradient(np.gradient(beside, s, axis=0), s, axis=0)
            bends[[0, -1]] = bends[[1, -2]]
            return np.sqrt(norms(bends).max(axis=1) / (8 * chord))

        return place(self.trajectory, samples, (), steps)


def solved(slopes, off):
    """The steps (n, 3) that lead as far as off (n, 3), by Cramer's rule; where slopes turn no way back, off itself."""
    one, two, three = slopes
    across = cross(two, three)
    size = dot(one, across)
    steps = np.stack((dot(off, across), dot(one, cross(off, three)), dot(one, cross(two, off))), axis=1)
    singular = np.abs(size) < SINGULAR
    return np.where(singular[:, None], off, steps / np.where(singular, 1.0, size)[:, None])


def about(axis, angle):
    """Turns about an axis by angles (n,): (n, 3, 3) float array."""
    made = np.zeros((len(angle), 3, 3))
    first, second = (axis + 1) % 3, (axis + 2) % 3
    made[:, axis, axis] = 1.0
    made[:, first, first] = made[:, second, second] = np.cos(angle)
    made[:, second, first] = np.sin(angle)
    made[:, first, second] = -made[:, second, first]
    return made
