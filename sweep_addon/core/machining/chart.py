# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What vertices of machined stock know: how deep the cut is there, by which line, and how far it is from the part."""

import numpy as np

from ..declared.digest import checksum


class Cut:
    """The chart of machined stock: attributes by name, (n,) float arrays, and no texture coordinates.

    Where a sweep has contours this has moves.
    """

    def __init__(self, attributes, moves):
        self.attributes, self.rings = attributes, moves
        self.keys = ("", "", "".join(name + checksum(values) for name, values in attributes.items()))

    def uv(self, dtype=np.float64, empty=np.empty):
        return None

    def along(self, dtype=np.float64, but=(), rooms=None):
        return {}

    def across(self, dtype=np.float64, but=(), rooms=None):
        return {name: values.astype(dtype) for name, values in self.attributes.items() if name not in but}
