# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""How many points of a curve are asked for, so that no chord is farther from it than a tolerance."""

import numpy as np
import opencascade
from mathutils.kdtree import KDTree
from peers import BezierCircle, Resampled, trimesh_resampled

from bl_ext.user_default import sweep_addon as sw

TOLERANCE = 1e-4
MOST = 8192
LOOKS = 100_000
ELLIPSE = "an ellipse, 10 to 1"
CURVES = {
    ELLIPSE: ("10*cos(u)", "sin(u)", "0"),
    "a (2, 3) torus knot": ("(2 + 0.8*cos(3*u))*cos(2*u)", "(2 + 0.8*cos(3*u))*sin(2*u)", "0.8*sin(3*u)"),
    "a hairpin": ("5*cos(u)", "sin(u)/(1 + 8*cos(u)^2)", "0.2*sin(3*u)"),
}


class Course:
    """A closed curve looked at so closely that its distance from chords can be read off.

    Parameters
    ----------
    places : (k, 3) float array
        Points in order; the last leads back to the first.
    """

    def __init__(self, places):
        self.places = places
        self.tree = KDTree(len(places))
        for index, place in enumerate(places):
            self.tree.insert(place, index)
        self.tree.balance()

    def farthest(self, points):
        """How far the curve goes from the chords of a closed polygon (n, 3) that begins where it begins."""
        reached = np.array([self.tree.find(point)[1] for point in points])
        reached[0] = 0
        chord = np.clip(np.searchsorted(reached, np.arange(len(self.places)), side="right") - 1, 0, len(points) - 1)
        along = np.roll(points, -1, axis=0) - points
        along, away = along[chord], self.places - points[chord]
        share = np.einsum("ij,ij->i", away, along) / np.einsum("ij,ij->i", along, along)
        return np.linalg.norm(away - share[:, None] * along, axis=1).max()

    def fewest(self, points):
        """The least count with which a function's polygon keeps the tolerance; more than `MOST` are not tried."""
        low, high = 8, MOST
        while high - low > 1:
            middle = (low + high) // 2
            low, high = (low, middle) if self.farthest(points(middle)) <= TOLERANCE else (middle, high)
        return high


def rows():
    """Of each curve: the theory, this project, the node, the bevel, trimesh and OpenCASCADE."""
    u = np.linspace(0, 2 * np.pi, LOOKS, endpoint=False)
    for name, formula in CURVES.items():
        trajectory = sw.trajectories.Formula(*formula)
        course = Course(trajectory.evaluate(u))
        swept = trimesh_resampled(course.places)
        yield [
            f"contours along {name}, for chords within 0.0001",
            f"{theory(trajectory, u):.1f}",
            adaptive(trajectory, course),
            course.fewest(Resampled(course.places).points),
            stretched_circle() if name == ELLIPSE else "-",
            course.fewest(swept) if swept else "not installed",
            opencascade.samples(10, 1, TOLERANCE) if name == ELLIPSE else "-",
        ]


def adaptive(trajectory, course):
    """The number of this project's contours, and how far they are off where that is more than the tolerance."""
    contour = sw.contours.Circle(1e-3, points=3)
    mesh = sw.GeneralizedCylinder(contour, trajectory, sw.sampling.Tolerance(TOLERANCE)).mesh()
    middles = mesh.vertices.reshape(3, -1, 3).mean(axis=0)
    farthest = course.farthest(middles)
    return len(middles) if farthest <= TOLERANCE else f"{len(middles)}, off by {farthest:.2g}"


def stretched_circle():
    """The steps of Blender's Bezier circle, stretched ten to one, that follow its own curve."""
    circle = BezierCircle((10, 1, 1))
    return Course(circle.exact(LOOKS)).fewest(circle.points)


def theory(trajectory, u):
    """The integral of the square root of curvature over that of eight tolerances: as few as even chords can be."""
    first, second = trajectory.derivative(u), trajectory.derivative(u, 2)
    speed = np.linalg.norm(first, axis=1)
    curvature = np.linalg.norm(np.cross(first, second), axis=1) / speed**3
    return np.sqrt(curvature / (8 * TOLERANCE)) @ speed * (u[1] - u[0])
