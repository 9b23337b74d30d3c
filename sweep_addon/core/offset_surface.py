# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The offset surface: the boundary of what a ball visits that moves over the surface of a solid."""

from dataclasses import replace

import numpy as np

from .later import later
from .offsets.choices import Engine, Side
from .operand import Operand
from .parameters import declared, length, parameter
from .solids import Bracket, Solid
from .vectors import unit

offset = later("core.offsets.offset", "offset")

QUICK = 60  # faces of a body whose offset is made in a tenth of a second or two


@declared
class OffsetSurface(Operand):
    """A ball that moves over the surface of a solid, outside, inside or on both sides

    The surface bounds one valid solid, also where the radius is more than the solid's features are apart: holes close,
    and what is thin inside is gone.

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
    """

    body: Solid = parameter(Bracket(), "Whose surface the ball moves over", accepts=("MESH",))
    radius: float = length(0.02, "Radius of the ball")
    side: Side = parameter(Side.OUTSIDE, "On which side of the surface")
    tolerance: float = parameter(
        0.0, "Largest distance from the true surface on smooth parts; 0 is by the size of the solid", unit="length",
        minimum=0.0,
    )  # fmt: skip
    engine: Engine = parameter(Engine.AUTOMATIC, "How it is made")

    def mesh(self, dtype=np.float64):
        """The surface as a mesh of triangles: closed, manifold and outward.

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
        >>> mesh.told[0].split(":")[0]
        'Offset by rounded faces, as the solid has no more than 2000 flat faces'
        """
        return self.made().mesh(self.radius, dtype)

    @property
    def make_solid(self):
        """Whether the mesh takes so long that in a window a rough one stands until it is made."""
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
        """The mesh, which is the boundary of a solid, and tells what part of it is done.

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
        progress = progress or (lambda part: None)
        progress(0.0)
        made = self.made(progress=progress).mesh(self.radius)
        progress(1.0)
        return made

    def made(self, **told):
        return offset(self.body.mesh(), self.radius, self.side, self.tolerance, self.engine, **told)

    def self_intersections(self):
        """Where the surface meets itself: nowhere, for it bounds a solid.

        Returns
        -------
        Places
            Empty.

        Examples
        --------
        >>> len(OffsetSurface().self_intersections())
        0
        """
        from .self_intersection.places import Places

        return Places(())
