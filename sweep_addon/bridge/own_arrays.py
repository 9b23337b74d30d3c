# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Arrays of a Blender mesh's own, into which NumPy writes without a copy.

`foreach_set` copies what NumPy has made elsewhere, and memory is what a large mesh waits for. RNA's own setters write
where an item's pointer says, so an array may be written there too, where the items prove to be one. This is not
promised by Blender, so it is found out each time:

- They are an array of the mesh's own. Setting a value through RNA makes it so where the mesh shared it with another.
- The items' pointers lie as far from each other as numbers of an array do. A Blender whose items are larger structures,
  or that answers with numbers of items, is told apart by that.
- Numbers that nothing else writes, set through RNA on the first, the middle and the last item, are read at these
  pointers. No other memory than theirs, and what lies between them, is then written.

Where any of this is not so, `foreach_set` writes: slower, and right in every Blender.
"""

import ctypes

import numpy as np

FEWEST = 1000  # items that are worth the looking, where RNA sets one by one
MANY = 50_000  # and where it only copies them
SENTINELS = (0x5EED01, 0x5EED02, 0x5EED03)  # of the first, the middle and the last item: single precision has them
KINDS = {np.dtype(np.int32): ctypes.c_int, np.dtype(np.float32): ctypes.c_float}


def own_array(items, name, dtype, width=1):
    """The array that holds a property of items, or None where it cannot be proven to be one.

    Parameters
    ----------
    items : bpy_prop_collection
    name : str
        Of the property: a number, or so many as the width says.
    dtype : numpy dtype
        int32 or float32.

    Returns
    -------
    (n * width,) array or None
        Good until anything else is done to the mesh; some of its values are not kept.
    """
    for index, value in zip(proven(items), SENTINELS, strict=True):
        setattr(items[index], name, (value,) * width if width > 1 else value)
    return seen_array(items, name, dtype, width)


def seen_array(items, name, dtype, width=1):
    """The same to be read alone: no value is set, and it is another mesh's too where these share it."""
    dtype = np.dtype(dtype)
    first, size = items[0].as_pointer(), width * dtype.itemsize
    for index in proven(items):
        item, place = items[index], first + size * index
        if item.as_pointer() != place:
            return None
        held, told = (KINDS[dtype] * width).from_address(place), getattr(item, name)
        if list(held) != (list(told) if width > 1 else [told]):
            return None
    return np.ctypeslib.as_array((KINDS[dtype] * (len(items) * width)).from_address(first))


def proven(items):
    """The numbers of the items that are looked at."""
    return 0, len(items) // 2, len(items) - 1


class Room:
    """Room for the values of items: Blender's own, where it proves to be an array of as many numbers as are asked for.

    It is called as `numpy.empty` is, with a size and a dtype, at most once for each time that the mesh is written.

    Parameters
    ----------
    items : bpy_prop_collection
    name : str
        Of their property.
    width : int
        Numbers in each.
    otherwise : callable
        What gives any other room.
    """

    def __init__(self, items, name, width, otherwise=np.empty):
        self.items, self.name, self.width, self.otherwise = items, name, width, otherwise
        self.own = None

    def __call__(self, size, dtype):
        if len(self.items) >= MANY and size == len(self.items) * self.width and np.dtype(dtype) in KINDS:
            self.own = own_array(self.items, self.name, dtype, self.width)
        return self.otherwise(size, dtype) if self.own is None else self.own

    def holds(self, values):
        """Whether values lie in Blender's own array already."""
        return self.own is not None and values.ctypes.data == self.own.ctypes.data

    def fill(self, values):
        """Give the items their values, (n * width,), unless they have them."""
        if not self.holds(values):
            self.items.foreach_set(self.name, values)
