# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Panels: a motion as polynomials, piece by piece, each so short that they are exact to rounding.

A panel holds channels, quantities that depend on the parameter of the motion, as Chebyshev series of x from -1 to 1.
"""

import numpy as np

from ...declared.frozen import individual

ORDER = 8  # nodes in a panel
ANGLES = (np.arange(ORDER) + 0.5) * np.pi / ORDER
NODES = -np.cos(ANGLES)  # rising
PLACES = np.concatenate(([-1.0], NODES, [1.0]))  # where a panel is looked at
FITTED = 2 / ORDER * np.cos(np.arange(ORDER)[:, None] * np.arccos(NODES))  # from values at nodes to coefficients
FITTED[0] /= 2
EXACT = 1e-11  # of a channel's size: the last two terms of its series; the next are a hundred-thousandth of them
ROUNDING = 1e-10  # of the whole: no panel is shorter
MOST = 1 << 15  # panels


@individual
class Panels:
    """Pieces of a motion.

    Parameters
    ----------
    start, end : (k,) float array
        Where each begins and ends in the parameter of the motion.
    series : (k, channels, ORDER) float array
        The coefficients of each channel.
    """

    start: np.ndarray
    end: np.ndarray
    series: np.ndarray

    def at(self, panel, x):
        """The channels at places x (n,) of panels (n,): (n, channels)."""
        return np.einsum("ncj,nj->nc", self.series[panel], powers(x))

    def held(self, s):
        """The channels at parameters (n,) of the motion, at its ends beyond them: (n, channels)."""
        panel = np.clip(np.searchsorted(self.start, s, side="right") - 1, 0, len(self.start) - 1)
        start, end = self.start[panel], self.end[panel]
        return self.at(panel, np.clip((2 * s - start - end) / (end - start), -1.0, 1.0))

    def parameter(self, panel, x):
        """The parameter of the motion at places of panels: (n,)."""
        start, end = self.start[panel], self.end[panel]
        return (start + end) / 2 + (end - start) / 2 * x

    @property
    def bounds(self):
        """The least and the greatest value that each channel can have: two (k, channels)."""
        middle, reach = self.series[..., 0], np.abs(self.series[..., 1:]).sum(axis=-1)
        return middle - reach, middle + reach


def panels(channels, breaks, parts, sizes):
    """Cut a motion into panels.

    Parameters
    ----------
    channels : callable
        From rising parameters (n,) to (n, c).
    breaks : (b,) float array
        Rising parameters, both ends among them, between which the motion is smooth.
    parts : int
        Panels at least.
    sizes : (c,) float array
        How large the values of each channel are: what an error is measured by.

    Returns
    -------
    Panels
    """
    whole = breaks[-1] - breaks[0]
    counts = np.maximum(np.ceil(parts * np.diff(breaks) / whole).astype(int), 1)
    edges = np.concatenate(
        [np.linspace(a, b, n + 1)[:-1] for a, b, n in zip(breaks[:-1], breaks[1:], counts, strict=True)]
    )
    start, end = edges, np.append(edges[1:], breaks[-1])
    kept, done = [], 0
    while True:
        u = (start + end)[:, None] / 2 + (end - start)[:, None] / 2 * NODES
        values = channels(u.ravel()).reshape(len(start), ORDER, -1)
        series = np.einsum("ij,kjc->kci", FITTED, values)
        rough = (np.abs(series[..., -2:]).sum(axis=-1) > EXACT * sizes).any(axis=1)
        rough &= (end - start > ROUNDING * whole) & (done + len(start) < MOST)
        kept.append((start[~rough], end[~rough], series[~rough]))
        done += len(start)
        if not rough.any():
            break
        middle = (start + end)[rough] / 2
        start, end = (np.stack(ends, axis=1).ravel() for ends in ((start[rough], middle), (middle, end[rough])))
    start, end, series = (np.concatenate(part) for part in zip(*kept, strict=True))
    order = np.argsort(start, kind="stable")
    return Panels(start[order], end[order], series[order])


def parted(pieces, counts):
    """Panels cut once more, into so many parts each; and the number of the panel that each is of."""
    own = np.repeat(np.arange(len(counts)), counts)
    number = np.arange(len(own)) - np.repeat(np.cumsum(counts) - counts, counts)
    low, high = (2 * side / counts[own] - 1 for side in (number, number + 1))
    places = (low + high)[:, None] / 2 + (high - low)[:, None] / 2 * NODES
    basis = powers(places.ravel()).reshape(*places.shape, ORDER)
    series = np.einsum("kcj,kij,li->kcl", pieces.series[own], basis, FITTED, optimize=True)
    return Panels(pieces.parameter(own, low), pieces.parameter(own, high), series), own


def powers(x):
    """Chebyshev's polynomials at places (n,): (n, ORDER)."""
    made = np.empty((len(x), ORDER))
    made[:, 0], made[:, 1] = 1.0, x
    for degree in range(2, ORDER):
        made[:, degree] = 2 * x * made[..., degree - 1] - made[:, degree - 2]
    return made


def slopes(x):
    """Their derivatives at places (n,): (n, ORDER)."""
    second = np.empty((len(x), ORDER))  # those of the second kind, one degree behind
    second[:, 0], second[:, 1] = 1.0, 2 * x
    for degree in range(2, ORDER):
        second[:, degree] = 2 * x * second[:, degree - 1] - second[:, degree - 2]
    made = np.zeros((len(x), ORDER))
    made[:, 1:] = second[:, :-1] * np.arange(1, ORDER)
    return made


def derivative(series):
    """The series of the derivatives: (..., ORDER) to the same."""
    made = np.zeros_like(series)
    for degree in range(ORDER - 1, 0, -1):
        made[..., degree - 1] = 2 * degree * series[..., degree]
        if degree + 1 < ORDER:
            made[..., degree - 1] += made[..., degree + 1]
    made[..., 0] /= 2
    return made


def at_both(series):
    """Series (..., ORDER) at the start and at the end of their panels: two (...)."""
    return np.einsum("...j,j->...", series, (-1.0) ** np.arange(ORDER)), series.sum(axis=-1)
