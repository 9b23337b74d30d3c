# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Roots of many short Chebyshev series at once, double ones too."""

import numpy as np

from .panels import ORDER, derivative, powers

DEGREES = np.arange(ORDER)
STEEP = DEGREES**2  # the most that a Chebyshev polynomial rises
STEPS = 6  # of Newton's method
ENOUGH = 1e-8  # of half a panel: the next step is the square of this one
BEYOND = 1e-9  # of half a panel: a root so far outside is one of its ends
REAL = 1e-4  # of half a panel: roots whose imaginary parts are less may be one that is double but for rounding
SMALL = 1e-300


def monomials():
    """From Chebyshev's polynomials to powers of x: (ORDER, ORDER), a column for each of the former."""
    made = np.zeros((ORDER, ORDER))
    made[0, 0] = made[1, 1] = 1.0
    for degree in range(2, ORDER):
        made[1:, degree] = 2 * made[:-1, degree - 1]
        made[:, degree] -= made[:, degree - 2]
    return made


MONOMIALS = monomials()


def simple(series):
    """The roots of series (n, ORDER) that rise or fall all the way.

    Parameters
    ----------
    series : (n, ORDER) float array

    Returns
    -------
    monotone : (n,) bool array
        Which do, and are roots to be told of; nothing is said of the others.
    x : (n,) float array
        Where they vanish, within the panel or, if they do not there, near its end beyond which they would.
    """
    bends = np.einsum("nj,j->n", np.abs(series[:, 2:]), STEEP[2:])
    monotone = np.abs(series[:, 1]) > bends
    terms = np.einsum("ij,nj->in", MONOMIALS, series)  # of powers of x, each in one run of memory
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        guess = np.clip(np.where(monotone, -series[:, 0] / series[:, 1], 0.0), -2.0, 2.0)
        return monotone, solved(terms, guess)


def solved(terms, x):
    """Where polynomials (ORDER, n) vanish, by Newton's method from places x (n,), none farther out than 2."""
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        for _ in range(STEPS):
            value, slope = horner(terms, x)
            slope[slope == 0] = np.inf
            value /= slope
            x = np.minimum(np.maximum(x - value, -2.0), 2.0)
            if np.abs(value, out=value).max(initial=0.0) < ENOUGH:
                break
    return x


def horner(terms, x):
    """Polynomials (ORDER, n) at places (n,), and their derivatives there: two (n,)."""
    value, slope = terms[-1].copy(), np.zeros_like(x)
    for term in terms[-2::-1]:
        slope *= x
        slope += value
        value *= x
        value += term
    return value, slope


def all_roots(series, near):
    """All real roots within the panel of series (n, ORDER), and places where they come nearer to 0 than some values.

    Parameters
    ----------
    series : (n, ORDER) float array
    near : float
        What counts as 0 at an extremum.

    Returns
    -------
    which : (k,) int array
        The series that each root is of.
    x : (k,) float array

    The roots are the eigenvalues of colleague matrices (Good: The colleague matrix, Q. J. Math. 12, 1961); extrema are
    those of the derivative.
    """
    size = np.abs(series)
    flat = np.flatnonzero(size.sum(axis=1) <= near)  # 0 all the way
    asked = np.flatnonzero((size.sum(axis=1) > near) & (size[:, 0] <= size[:, 1:].sum(axis=1) + near))
    which, x = real(series[asked])
    turning, at = real(derivative(series[asked]))
    touching = np.abs(np.einsum("nj,nj->n", series[asked[turning]], powers(at))) <= near
    which = np.concatenate((asked[which], asked[turning[touching]], flat))
    return which, np.concatenate((x, at[touching], np.zeros(len(flat))))


def real(series):
    """The real roots within the panel, or at its ends but for rounding: which series, and where."""
    size = np.abs(series).max(axis=1)
    live = np.flatnonzero(size > SMALL)
    if not len(live):
        return live, np.zeros(0)
    scaled = series[live] / size[live, None]
    degree = ORDER - 1
    top = scaled[:, degree].copy()
    top = np.where(np.abs(top) < 1e-18, 1e-18, top)  # of lower degree: its other roots are far away
    matrix = np.zeros((len(live), degree, degree))
    matrix[:, 0, 1] = 1.0
    for row in range(1, degree):
        matrix[:, row, row - 1] = 0.5
        if row + 1 < degree:
            matrix[:, row, row + 1] = 0.5
    matrix[:, -1] -= scaled[:, :degree] / (2 * top[:, None])
    found = np.linalg.eigvals(matrix)
    kept = (np.abs(found.imag) <= REAL) & (np.abs(found.real) <= 1 + BEYOND)
    which, place = np.nonzero(kept)
    x = np.clip(found.real[which, place], -1.0, 1.0)
    return live[which], x
