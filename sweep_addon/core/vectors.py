# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Vectors, row by row."""

from functools import cache

import numpy as np

ONE_THREAD = 2**18  # multiplications of a product; OpenBLAS shares more than 2**18 among threads
TALL = 32  # rows of a block of a large one
NEAR = 9216  # numbers of the right array in a block, where rows are added
TOGETHER = 10_000  # numbers that are added at once: of 8,192 or less NumPy 1 makes copies, and takes twice as long
MANY = 1000  # vectors, from which on it takes less time to go through them by their columns
ROWS = 8192  # of these at once, which caches hold


def dot(a, b):
    """The products of vectors with one another, (..., k) twice to (...)."""
    a, b = np.asarray(a), np.asarray(b)
    if a.shape == b.shape and a.shape[1:] == (3,):
        if len(a) >= MANY or not (a.flags.c_contiguous and b.flags.c_contiguous):
            return column_by_column(a, b)
    return np.einsum("...i,...i->...", a, b)


def column_by_column(a, b):
    """The products of many vectors, (n, 3) twice to (n,), in half the time that as many sums of three numbers take.

    They are added in the order in which `numpy.einsum` adds three that lie row by row: the sums do not hang on how
    many vectors there are, nor on how they lie.
    """
    products = np.empty(len(a), np.result_type(a, b))
    for start in range(0, len(a), ROWS):
        (x, y, z), (u, v, w) = (vectors[start : start + ROWS].T for vectors in (a, b))
        part = products[start : start + ROWS]
        np.multiply(x, u, out=part)
        part += z * w
        part += y * v
    return products


def norms(vectors):
    """The lengths of vectors, (..., 3) to (...), in a quarter of the time that `numpy.linalg.norm` takes."""
    return np.sqrt(dot(vectors, vectors))


def differing(a, b):
    """The rows in which vectors, (n, 3) twice, are not the same: (k,) rising.

    >>> differing(np.zeros((3, 3)), np.array([[0.0, 0, 0], [0, 1, 1], [1, 0, 0]])).tolist()
    [1, 2]
    """
    return np.flatnonzero(np.logical_or.reduce((a != b).T))


def zeros(vectors):
    """The rows that are zero of vectors (n, 3): (k,) rising.

    >>> zeros(np.array([[0.0, 0, 0], [0, 1, 1], [1, 0, 0]])).tolist()
    [0]
    """
    rows = np.flatnonzero(vectors[:, 0] == 0)
    return rows[~vectors[rows].any(axis=1)]


def cross(a, b):
    """The vector products, (..., 3) twice to (..., 3), in a third of the time that `numpy.cross` takes."""
    products = columns(np.broadcast(a, b).shape)
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        np.subtract(a[..., j] * b[..., k], a[..., k] * b[..., j], out=products[..., i])
    return products


def columns(shape):
    """Room for vectors, of that shape, that lie column by column: so all that is done row by row takes half the time.

    What NumPy computes of them, number by number, lies as they do.
    """
    return np.empty((shape[-1], *shape[:-1])).transpose(*range(1, len(shape)), 0)


def unit(vectors):
    """Vectors of length one, row by row; a zero row stays zero."""
    norm = norms(vectors)
    return vectors / (norm + (norm == 0))[..., None]


def is_tuned(config):
    """Whether NumPy, as `numpy.show_config` says in dictionaries, multiplies by a BLAS made for fast processors.

    The recipe by which Blender builds its own names none, and Debian's has the reference.
    """
    name = config.get("Build Dependencies", {}).get("blas", {}).get("name", "")  # what is not there is left out
    return any(known in name.lower() for known in ("openblas", "accelerate", "mkl", "blis", "armpl"))


@cache
def tuned():
    """Whether this NumPy does; one that was built in the old way, and does not say, is taken to do not."""
    try:
        return is_tuned(np.show_config(mode="dicts"))
    except TypeError:
        return False


def product(left, right, out):
    """The matrix product of a (m, k) and a (k, n) array, k small, written into out, (m, n).

    With so short a sum it is bound by memory. A BLAS gets blocks so small that it computes each in one thread: where
    another program uses the processors, waiting for a second thread takes ten times as long. Few rows at once, so that
    each is written on for long, take a quarter less than all of them. Without a BLAS that is tuned, sums of whole rows
    take half the time of `numpy.matmul` or less, in blocks of which a row stays in the nearest cache.
    """
    if tuned():
        height = max(len(left), 1) if left.size * right.shape[1] <= ONE_THREAD else TALL
        width, multiply = max(ONE_THREAD // max(left[:height].size, 1), 1), np.matmul
    else:
        height, width, multiply = max(len(left), 1), max(NEAR // max(len(right), 1), 1), row_by_row
    for first in range(0, len(left), height):
        rows = slice(first, first + height)
        for start in range(0, right.shape[1], width):
            multiply(left[rows], right[:, start : start + width], out=out[rows, start : start + width])


def row_by_row(left, right, out):
    """The matrix product as sums of the rows of the right array."""
    np.einsum("ij,jk->ik", left, right, out=out)


def added(left, shares, right, out):
    """To each row of a (n, k) array the products of each row of a (m, 2) array with its shares, (2, k), k small.

    They are written into out, (m, n, k), in less time than the product of two matrices takes, which a BLAS is made for.

    >>> out = np.empty((2, 1, 3))
    >>> added(np.array([[1.0, 2], [3, 4]]), np.array([[1.0, 0, 0], [0, 0, 1]]), np.array([[10.0, 20, 30]]), out)
    >>> out.tolist()
    [[[11.0, 20.0, 32.0]], [[13.0, 20.0, 34.0]]]
    """
    m, n, k = out.shape
    together = max(min(n, TOGETHER // k), 1)  # loops over k alone would be short
    tile, blocks = np.tile(left @ shares, together), (n // together, together * k)
    whole, rest = blocks[0] * together, (n % together) * k
    np.add(right[:whole].reshape(blocks), tile[:, None], out=out[:, :whole].reshape(m, *blocks))
    np.add(right[whole:].reshape(1, rest), tile[:, :rest], out=out[:, whole:].reshape(m, rest))
