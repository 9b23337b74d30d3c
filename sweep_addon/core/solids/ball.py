# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The ball, as a solid."""

import numpy as np

from ..declared.parameters import count, declared, length
from ..shapes.operand import Operand


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
