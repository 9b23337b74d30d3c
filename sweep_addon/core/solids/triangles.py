# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Any surface or solid, as triangles: what a mesh object of Blender becomes."""

import numpy as np

from ..declared.parameters import Array, declared, parameter, require
from ..shapes.operand import Operand

MOST = 1_000_000  # vertices, and triangles
TETRAHEDRON = ((0.0, 0.0, 0.3), (0.3, 0.0, -0.1), (-0.15, 0.26, -0.1), (-0.15, -0.26, -0.1))
SIDES = ((0, 1, 2), (0, 2, 3), (0, 3, 1), (1, 3, 2))


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
        """The triangles of a `Mesh`, its larger faces cut into several."""
        from ..meshes.facets import facets

        return cls(mesh.vertices, facets(mesh)[0])

    def scaled(self, factor):
        """The triangles made larger or smaller about the origin."""
        return Triangles(self.vertices.values * factor, self.faces)

    def mesh(self):
        """The triangles as a `Mesh`."""
        from ..meshes.polyhedron import polyhedron

        return polyhedron(self.vertices.values, self.faces.values.astype(np.int32))
