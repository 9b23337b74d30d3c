# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a field is: a function whose zero is a surface, and which changes by at most the way.

It is 1-Lipschitz, so that a value of more than half a cell's diagonal at its centre tells that the zero is not in that
cell. A field has three methods, all of points (n, 3) with hints (n, k) that what it knows of a cell's centre may give
to the points in that cell (k may be 0):

``evaluate(points, hints, reach)``
    The values (n,), negative inside, and hints for points near them. Of a value that is farther from 0 than `reach` no
    more than that is asked.
``inside(points, hints)``
    Whether values are negative: often told sooner than the value.
``normals(points, hints)``
    The values, unit normals (n, 3) outward, and hints, close to the zero.
"""

import numpy as np

HALVINGS = 4  # of a way out: where it leaves is known to a 16th, and the plane there to the square of that


class AnyField:
    """What holds for any field, and what some know better.

    ``ridges`` says whether smooth sheets of the zero may meet in an edge that is convex: those of a distance do not.
    """

    ridges = True

    def leaving(self, within, outside, hints):
        """Where ways out of the inside leave it, just outside; and a foot and a normal of the surface near there.

        Parameters
        ----------
        within, outside : (n, 3) float arrays
            Places of which values are negative, and are not.
        hints : (n, k) float array

        Returns
        -------
        places, feet, normals : (n, 3) float arrays
            Values just outside are the distance of a moving solid in all poses, and not a depth in one.
        """
        for _ in range(HALVINGS):
            middle = (within + outside) / 2
            inner = self.inside(middle, hints)[:, None]
            within, outside = np.where(inner, middle, within), np.where(inner, outside, middle)
        values, normals, _ = self.normals(outside, hints)
        return outside, outside - values[:, None] * normals, normals

    def at_feet(self, vertices, places):
        """`Vertices` moved to the zero, as far as places (n, 3) near their feet allow."""
        return vertices.at(self, places)
