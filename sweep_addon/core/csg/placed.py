# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A solid somewhere else: moved, turned, scaled or sheared."""

from numbers import Real

import numpy as np

from ..declared.parameters import Array, declared, parameter, require
from ..later import later
from ..shapes.operand import Operand, standing
from ..solids import Block

line, shared_hash, shared_equal = (later("core.csg.shared", name) for name in ("line", "hashed", "equal"))

NOWHERE = ((1.0, 0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0), (0.0, 0.0, 1.0, 0.0))
FLATTEST = 1e-9  # of the product of its columns' lengths: a smaller determinant flattens


@declared
class Placed(Operand):
    """A solid that is moved, turned, scaled or sheared

    Examples
    --------
    >>> Block().moved(x=2.0).mesh().vertices.mean(axis=0).round(9).tolist()
    [2.0, 0.0, 0.0]
    """

    solid: Operand = parameter(Block(), "What is placed")
    matrix: Array = parameter(
        NOWHERE, "Three rows of four: where its axes point, and where its origin goes", columns=4, most=3
    )

    def check(self):
        """Refuse a matrix that is not three rows, or that leaves no volume."""
        rows = len(self.matrix)
        require(rows == 3, "must have three rows of four numbers", rows, "matrix")
        size = float(np.linalg.norm(self.axes, axis=0).prod())
        found = float(np.linalg.det(self.axes))
        require(abs(found) > FLATTEST * size, "must leave a volume", found, "matrix")

    @property
    def axes(self):
        """(3, 3) float array: its columns are where the solid's axes point."""
        return self.matrix.values[:, :3]

    @property
    def origin(self):
        """(3,) float array: where the solid's origin goes, in metres."""
        return self.matrix.values[:, 3]

    def mesh(self, dtype=np.float64):
        """The surface as a `Mesh`, in metres."""
        return self.carried(standing(self.solid).mesh()).astype(dtype)

    def carried(self, mesh):
        """A mesh of the solid taken there; mirrored ones are turned over."""
        from .meshes import transformed

        return transformed(mesh, self.axes, self.origin)

    def __hash__(self):
        return shared_hash(self)

    def __eq__(self, other):
        return shared_equal(self, other)

    def __str__(self):
        return line(self)


def moved(solid, by):
    """A solid moved by (3,) metres; one that is placed already is placed once."""
    for key, way in zip("xyz", by, strict=True):
        require(isinstance(way, Real), "must be a number of metres", way, key)
    if isinstance(solid, Placed):
        matrix = solid.matrix.values.copy()
        matrix[:, 3] += by
        return Placed(solid.solid, matrix)
    return Placed(solid, np.column_stack((np.eye(3), by)))
