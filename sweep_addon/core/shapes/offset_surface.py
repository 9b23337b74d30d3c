# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offset surface: the boundary of what a ball visits that moves over a solid, or a disc along a plane region."""

from dataclasses import replace

import numpy as np

from ..contours import Contour
from ..declared.options import Engine, Side
from ..declared.parameters import declared, length, parameter, require, spelled
from ..later import later
from ..solids import Bracket, Solid
from ..variation.morph import AS_THICK
from ..vectors import unit
from .operand import Operand

in_the_plane = later("core.offsets.in_the_plane")
offset = later("core.offsets.offset", "offset")

Body = Solid | Contour
QUICK = 60  # faces of a body whose offset is made in a tenth of a second or two


@declared
class OffsetSurface(Operand):
    """A ball that moves over the surface of a solid, or a disc along a plane region, outside, inside or on both sides

    The surface bounds one valid solid, also where the radius is more than the solid's features are apart: holes close,
    and what is thin inside is gone. Of a contour it is a plane region, whose boundary is lines and arcs.

    Source
    ------
    The lecture's "offset surface". Steiner's formula gives the volume around a convex solid: V + A r + the turns of its
    edges times their lengths r^2 / 2 + 4/3 pi r^3.

    Examples
    --------
    >>> from math import pi
    >>> from sweep_addon.core.solids import Block
    >>> round_block = OffsetSurface(Block(1.0, 1.0, 1.0), radius=0.5, tolerance=1e-5).mesh()
    >>> round(round_block.volume() / (1 + 6 * 0.5 + 12 * pi / 4 * 0.5**2 + 4 / 3 * pi * 0.5**3), 4)
    1.0

    The lecture's disc of radius 1 that moves along a circle of radius 5 leaves what is between circles of 4 and 6:

    >>> from sweep_addon.core.contours import Circle
    >>> ring = OffsetSurface(Circle(5.0), radius=1.0, side="shell", tolerance=1e-6)
    >>> round(ring.outline().area / pi, 9), round(ring.mesh().area() / pi, 4)
    (20.0, 20.0)
    """

    body: Body = parameter(
        Bracket(),
        "The solid over whose surface a ball moves, or the contour along which a disc does",
        others=AS_THICK,
        accepts=("MESH", "CURVE", "FONT"),
    )
    radius: float = length(0.02, "Radius of the ball or disc")
    side: Side = parameter(Side.OUTSIDE, "On which side of the surface")
    tolerance: float = parameter(
        0.0, "Largest distance from the true surface on smooth parts; 0 is by the size of the body", unit="length",
        minimum=0.0,
    )  # fmt: skip
    engine: Engine = parameter(Engine.AUTOMATIC, "How it is made; of a contour always by lines and arcs")

    @property
    def is_plane(self):
        """Whether a disc moves in the plane of a contour."""
        return isinstance(self.body, Contour)

    def mesh(self, dtype=np.float64):
        """The surface as a mesh of triangles: closed, manifold and outward; of a contour its plane region.

        Parameters
        ----------
        dtype : numpy dtype
            Of the vertices, which are in metres.

        Returns
        -------
        Mesh
            ``told`` says which engine made it and why, and how far from the radius it is at most.

        Raises
        ------
        ShapeError
            For a solid that is not closed or crosses itself, inside where nothing is left of it, for a tolerance that
            is too small, or where manifold3d is missing.

        Examples
        --------
        >>> mesh = OffsetSurface().mesh()
        >>> len(mesh.boundary_edges()), mesh.euler_characteristic()
        (0, 2)
        >>> mesh.told[0].split(".")[0]
        'Engine rounded faces, as the solid has no more than 2000 flat faces'
        """
        if self.is_plane:
            return in_the_plane.mesh(self.outline(), dtype)
        return self.made().mesh(self.radius, dtype)

    def outline(self):
        """Of a contour the boundary of the offset, an `Outline` of lines and true arcs, to be swept or offset again.

        Examples
        --------
        >>> from sweep_addon.core.contours import Rectangle
        >>> OffsetSurface(Rectangle(2.0, 1.0), 0.25).outline().bulges[0].values.round(3).tolist()
        [0.0, 0.414, 0.0, 0.414, 0.0, 0.414, 0.0, 0.414]
        """
        require(self.is_plane, "must be a contour: a solid has no outline", spelled(type(self.body)), "body")
        return in_the_plane.outline(self.body, self.radius, self.side, self.tolerance)

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window a rough one stands until it is made."""
        if self.is_plane:
            return False
        fine = self.tolerance > 0 or self.engine is Engine.LEVEL_SET
        return fine or len(self.body.mesh().offsets) > QUICK

    def surface(self, dtype=np.float64):
        """Roughly the mesh, at once: the vertices of the body moved along their normals. It may cross itself."""
        mesh, side = self.body.mesh(), -1 if self.side is Side.INSIDE else 1
        corners, normals = mesh.corners, np.repeat(mesh.normals, np.diff(mesh.offsets), axis=0)
        count = len(mesh.vertices)
        ways = unit(np.stack([np.bincount(corners, part, count) for part in normals.T], axis=1))
        return replace(mesh, vertices=(mesh.vertices + side * self.radius * ways).astype(dtype))

    def solid(self, progress=None):
        """The mesh, which is the boundary of a solid or a plane region, and tells what part of it is done.

        Parameters
        ----------
        progress : callable, optional
            Is told which part is done, from 0 to 1; what it raises ends the work.

        Returns
        -------
        Mesh

        Examples
        --------
        >>> OffsetSurface().solid().euler_characteristic()
        2
        """
        if self.is_plane:
            return self.mesh()
        progress = progress or (lambda part: None)
        progress(0.0)
        made = self.made(progress=progress).mesh(self.radius)
        progress(1.0)
        return made

    def made(self, **told):
        return offset(self.body.mesh(), self.radius, self.side, self.tolerance, self.engine, **told)

    def self_intersections(self):
        """Where the surface meets itself: nowhere, for it bounds a solid or is a region.

        Returns
        -------
        Places
            Empty.

        Examples
        --------
        >>> len(OffsetSurface().self_intersections())
        0
        """
        from ..self_intersection.places import Places

        return Places(())
