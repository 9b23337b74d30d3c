# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Places near the zero of a field, with what the field says there."""

import numpy as np

from ..declared.frozen import individual


@individual
class Vertices:
    """Places and what a field says of them.

    Parameters
    ----------
    places, normals : (n, 3) float arrays
    values : (n,) float array
    hints : (n, k) float array
    """

    places: np.ndarray
    values: np.ndarray
    normals: np.ndarray
    hints: np.ndarray

    @property
    def foot(self):
        """(n, 3) float array: where the zero would be, were the field a plane's."""
        return self.places - self.values[:, None] * self.normals

    def at(self, field, places):
        """What the field says of other places near these."""
        return Vertices(places, *field.normals(places, self.hints))

    def some(self, which):
        return Vertices(self.places[which], self.values[which], self.normals[which], self.hints[which])

    def replaced(self, which, others):
        """These, some of them replaced by others."""
        parts = [(getattr(self, name).copy(), getattr(others, name)) for name in self.__dataclass_fields__]
        for whole, part in parts:
            whole[which] = part
        return Vertices(*(whole for whole, _ in parts))

    def and_then(self, others):
        """These, and others after them."""
        names = self.__dataclass_fields__
        return Vertices(*(np.concatenate((getattr(self, name), getattr(others, name))) for name in names))
