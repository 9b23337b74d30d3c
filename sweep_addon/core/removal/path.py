# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Removal paths: how a part gets out, and what must stay empty for it; or that none was found, and what was tried."""

import numpy as np

from ..declared.frozen import individual
from ..declared.parameters import require
from .legs import poses


@individual
class RemovalPath:
    """The way on which a part gets out of an assembly; it is true if there is one.

    Parameters
    ----------
    part : Body
        The part as it stands.
    legs : tuple of Leg
        On each it moves and turns evenly; none where no path was found.
    tolerance : float
        How deep the part may be in others on its way, in metres: the contact tolerance, or 0 where it stays clear.
    clearance : float
        How far the part stays from all others at least, in metres, proven; where there is a contact tolerance, the part
        drawn in by it.
    said : str
        How the path was found, or what was tried.
    sealed : bool
        Whether it is proven that there is no path.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> hole, pin = sw.solids.DrilledBlock(radius=0.15), sw.solids.Cylinder(0.14, 0.3)
    >>> path = sw.removal_path(pin, [hole])
    >>> len(path.legs), abs(path.matrices(1)[-1, :3, 3]).round(3).tolist()
    (1, [0.0, 0.0, 0.3])
    """

    part: object
    legs: tuple
    tolerance: float = 0.0
    clearance: float = 0.0
    said: str = ""
    sealed: bool = False

    def __bool__(self):
        return bool(self.legs)

    def __repr__(self):
        return f"RemovalPath({len(self.legs)} legs)" if self else "RemovalPath(none)"

    def __str__(self):
        return self.said

    def matrices(self, steps=16):
        """Where the part is on its way: its matrices as it starts, and after so many even steps of each leg.

        Parameters
        ----------
        steps : int

        Returns
        -------
        (n, 4, 4) float array
            What was at x is at the first three of ``matrix @ (x, y, z, 1)``; n is 1 + steps times the legs.
        """
        found = [np.eye(4)]
        for leg, pose in zip(self.legs, poses(self.legs)[:-1], strict=True):
            for part in np.arange(1, steps + 1) / steps:
                matrix, origin = leg.pose(part).after(pose)
                made = np.eye(4)
                made[:3, :3], made[:3, 3] = matrix, origin
                found.append(made)
        return np.array(found)

    def swept(self):
        """All points that the part visits on its way, which are to be kept empty: a solid, or a tree of such.

        Of a straight leg it is a solid of triangles that is exact; of one that turns a sweep, whose membership is
        exact, and whose mesh is as good as its cells are small; of several legs the union of theirs.

        Raises
        ------
        ShapeError
            Where there is no path.

        Examples
        --------
        >>> import sweep_addon as sw
        >>> path = sw.removal_path(sw.solids.Block(), [sw.solids.Block().moved(z=-0.5)])
        >>> swept = path.swept()
        >>> sw.classify(swept, [(0, 0, 0), (0, 0, -0.4)]).tolist()
        [1, -1]
        """
        require(self.legs, "must have a path", self.said, "path")
        from .volumes import swept  # which asks manifold3d

        return swept(self.part, self.legs)
