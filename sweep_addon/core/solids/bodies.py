# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The solids: balls, prisms, which are figures that have moved along z, and triangles, which may be any."""

import numpy as np

from ..declared.parameters import Array, count, declared, length, parameter, require
from ..later import later
from ..shapes.operand import Operand

bent_facets = later("core.meshes.facets", "bent_facets")

MOST = 1_000_000  # vertices and triangles
TETRAHEDRON = ((0.0, 0.0, 0.3), (0.3, 0.0, -0.1), (-0.15, 0.26, -0.1), (-0.15, -0.26, -0.1))
SIDES = ((0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2))


@declared
class Ball(Operand):
    """A ball about its reference point

    As a polyhedron inscribed in it, of rings about the z axis with a pole above and one below.

    Examples
    --------
    >>> ball = Ball(radius=2.0, points=16).mesh()
    >>> ball.euler_characteristic(), len(ball.vertices)
    (2, 114)
    """

    radius: float = length(0.25, "Distance of the points from the centre")
    points: int = count(32, "Points around the axis; from pole to pole half as many steps", minimum=4, maximum=1024,
                        soft_maximum=128)  # fmt: skip

    def mesh(self):
        """The surface as a `Mesh`."""
        from ..meshes.polyhedron import polyhedron

        around, rings = self.points, self.points // 2 - 1
        turn = 2 * np.pi * np.arange(around) / around
        rise = np.pi * (np.arange(rings) + 1) / (rings + 1)
        ring = np.stack((np.cos(turn), np.sin(turn), np.zeros(around)), axis=1)
        vertices = np.sin(rise)[:, None, None] * ring + np.cos(rise)[:, None, None] * (0, 0, 1)
        vertices = self.radius * np.concatenate((vertices.reshape(-1, 3), [(0, 0, 1), (0, 0, -1)]))
        here = np.arange(around)
        ahead = (here + 1) % around
        strips = around * np.arange(rings - 1)[:, None]
        quads = np.stack(np.broadcast_arrays(strips + here, strips + around + here, strips + around + ahead,
                                             strips + ahead), axis=-1)  # fmt: skip
        top, last = around * rings, around * (rings - 1)
        caps = [np.stack((np.full(around, top), here, ahead), axis=1),
                np.stack((np.full(around, top + 1), last + ahead, last + here), axis=1)]  # fmt: skip
        corners = np.concatenate((quads.ravel(), *(cap.ravel() for cap in caps)))
        sizes = np.repeat((4, 3), (quads.size // 4, 2 * around))
        return polyhedron(vertices, corners, np.concatenate(([0], np.cumsum(sizes))))


class Prism(Operand):
    """A figure that has moved along z. A kind gives `figure`, the contour, and `height`, in metres."""

    def mesh(self):
        """The surface as a `Mesh`."""
        return self.sweep().mesh()

    def sweep(self):
        """The same as a `TranslationalSweep`."""
        from ..shapes.translational_sweep import TranslationalSweep  # shapes have solids as parameters

        contour, height = self.figure(), self.height
        return TranslationalSweep(contour, height=height, directions="symmetric", texture="none", attributes=False)


@declared
class Block(Prism):
    """A block about its reference point

    Examples
    --------
    >>> Block(width=2.0, depth=2.0, height=2.0).mesh().euler_characteristic()
    2
    """

    width: float = length(0.5, "Size along x")
    depth: float = length(0.5, "Size along y")
    height: float = length(0.5, "Size along z")

    def figure(self):
        from ..contours import Rectangle

        return Rectangle(self.width, self.depth)


@declared
class Cylinder(Prism):
    """A round cylinder about the z axis

    Its base is a polygon inscribed in the circle.

    Examples
    --------
    >>> len(Cylinder(points=6).mesh().vertices)
    12
    """

    radius: float = length(0.2, "Distance of the points from the axis")
    height: float = length(0.6, "Size along z")
    points: int = count(64, "Points around the axis", minimum=3, maximum=4096, soft_maximum=128)

    def figure(self):
        from ..contours import Circle

        return Circle(self.radius, self.points)


@declared
class Bracket(Prism):
    """An L-bracket: two legs at a right angle

    Its legs run along x and y from the corner at the origin.

    Examples
    --------
    >>> round(Bracket(width=0.4, depth=0.6, thickness=0.1, height=1.0).mesh().volume(), 12)
    0.09
    """

    width: float = length(0.5, "Length of the leg along x")
    depth: float = length(0.5, "Length of the leg along y")
    thickness: float = length(0.12, "Thickness of both legs")
    height: float = length(0.2, "Size along z")

    def check(self):
        """Refuse legs that are no longer than thick."""
        most = min(self.width, self.depth)
        require(self.thickness < most, f"must be less than {most:g}, the shorter leg", self.thickness, "thickness")

    def figure(self):
        from ..contours import Outline

        w, d, t = self.width, self.depth, self.thickness
        return Outline([[(0, 0), (w, 0), (w, t), (t, t), (t, d), (0, d)]])


@declared
class DrilledBlock(Prism):
    """A block with a round hole drilled through along z

    The hole's edge is a polygon inscribed in its circle.

    Examples
    --------
    >>> DrilledBlock().mesh().euler_characteristic()
    0
    """

    width: float = length(0.5, "Size along x")
    depth: float = length(0.5, "Size along y")
    height: float = length(0.3, "Size along z")
    radius: float = length(0.15, "Radius of the hole")
    points: int = count(64, "Points around the hole", minimum=3, maximum=4096, soft_maximum=128)

    def check(self):
        """Refuse a hole that is no less wide than the block."""
        most = min(self.width, self.depth) / 2
        require(self.radius < most, f"must be less than {most:g}, half the shorter side", self.radius, "radius")

    def figure(self):
        from ..contours import Circle, Outline, Rectangle

        sections = Rectangle(self.width, self.depth).section(), Circle(self.radius, self.points).section()
        return Outline([np.array(section.points) for section in sections])


@declared
class Triangles(Operand):
    """A surface of triangles, or the solid that it bounds if it is closed

    Examples
    --------
    >>> Triangles().mesh().euler_characteristic()
    2
    """

    vertices: Array = parameter(TETRAHEDRON, "Corners of the triangles", columns=3, unit="length", most=MOST)
    faces: Array = parameter(
        SIDES, "Numbers of the vertices of each triangle, counter-clockwise from outside", columns=3, most=MOST
    )

    def check(self):
        """Refuse less than one triangle, and numbers of vertices that are not there."""
        faces = self.faces.values
        require(len(faces), "must have a triangle", len(faces), "faces")
        wrong = (faces % 1 != 0) | (faces < 0) | (faces >= len(self.vertices))
        if wrong.any():
            require(False, f"must be whole numbers below {len(self.vertices)}", float(faces[wrong][0]), "faces")

    @classmethod
    def of(cls, mesh):
        """The triangles of a `Mesh`, its larger faces cut into several, bent ones of four corners into four.

        Where these would be too many they are cut into two, as `Mesh.triangles` are.
        """
        vertices, faces = bent_facets(mesh)
        return cls(vertices, faces) if len(faces) <= MOST else cls(mesh.vertices, mesh.triangles)

    def scaled(self, factor):
        """The triangles made larger or smaller about the origin."""
        return Triangles(self.vertices.values * factor, self.faces)

    def mesh(self):
        """The triangles as a `Mesh`."""
        from ..meshes.polyhedron import polyhedron

        return polyhedron(self.vertices.values, self.faces.values.astype(np.int32))
