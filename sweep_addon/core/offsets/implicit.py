# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A field from any function of points that says how quickly it may change."""

import numpy as np

from ..vectors import norms, unit
from .any_field import AnyField

STEP = 1e-6  # of the size of what points are asked about: of a central difference


class Implicit(AnyField):
    """The field of a function.

    Parameters
    ----------
    function : callable
        Takes points (n, 3) in metres and gives values (n,), negative inside.
    lipschitz : float
        How much the values of two points can differ at most, as a multiple of their distance.
    size : float
        Of what is looked at, in metres: differences are taken over a millionth of it.
    """

    def __init__(self, function, lipschitz=1.0, size=1.0):
        self.function, self.lipschitz, self.step = function, lipschitz, STEP * size

    def evaluate(self, points, hints=None, reach=np.inf):
        return self.function(points) / self.lipschitz, np.empty((len(points), 0))

    def inside(self, points, hints=None):
        return self.function(points) < 0

    def normals(self, points, hints=None):
        values, hints = self.evaluate(points)
        offsets = self.step * np.eye(3)
        slopes = [self.function(points + offset) - self.function(points - offset) for offset in offsets]
        return values, unit(np.stack(slopes, axis=1)), hints

    def interval(self, surface):
        """Bounds of the distance from the zero on each triangle of a `Surface`, in metres: two (t,) arrays.

        They follow from the values at its corners and the most that these can change: as wide as cells are.
        """
        corners, values = surface.vertices.places[surface.triangles], surface.vertices.values[surface.triangles]
        reach = norms(corners[:, :, None] - corners[:, None]).max(axis=2)
        return (values - reach).max(axis=1), (values + reach).min(axis=1)
