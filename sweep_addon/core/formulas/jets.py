# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Jets: numbers that know their derivatives, so that a formula that is evaluated on them is differentiated exactly.

A jet holds the first coefficients of a Taylor series at many places at once. NumPy hands its functions over to their
rules here (NEP 13 and 18), so an expression runs on jets as it does on arrays. Where a function has a step or a kink,
the derivative is that of the piece; a place where there is none gives NaN or infinity.
"""

from math import factorial

import numpy as np

MOST = 3  # derivatives


class Jet(np.lib.mixins.NDArrayOperatorsMixin):
    """The value and derivatives of a quantity at n places.

    Attributes
    ----------
    series : (k, n) float array
        Coefficients of its Taylor series: the value, the derivative, half the second one, and so on; k is at most 4.

    Examples
    --------
    >>> u = Jet.variable(np.array([0.0, 1.0]), order=2)
    >>> (np.exp(2 * u) * u).derivative(2).round(6).tolist()
    [4.0, 59.112449]
    """

    def __init__(self, series):
        self.series = series

    @classmethod
    def variable(cls, u, order):
        """The variable itself at places u: its derivative is 1."""
        series = np.zeros((order + 1, len(u)))
        series[0] = u
        series[1:2] = 1.0
        return cls(series)

    def derivative(self, order):
        return factorial(order) * self.series[order]

    def __array_ufunc__(self, ufunc, method, *inputs, **keywords):
        if method != "__call__" or keywords:
            return NotImplemented
        if ufunc in LIKE_NUMBERS:
            return ufunc(*(value.series[0] if isinstance(value, Jet) else value for value in inputs))
        if ufunc in OF_ONE:
            return composed(self, OF_ONE[ufunc])
        return OF_TWO[ufunc](*inputs) if ufunc in OF_TWO else NotImplemented

    def __array_function__(self, function, types, inputs, keywords):
        if function is np.where:
            return chosen(*inputs)
        return composed(self, stepped(np.round)) if function is np.round else NotImplemented


def lifted(value, like):
    """A number or an array as a jet that does not change."""
    if isinstance(value, Jet):
        return value
    series = np.zeros_like(like.series)
    series[0] = value
    return Jet(series)


def jets(rule):
    """A rule of two jets, one of which may be given as a plain number."""

    def applied(a, b):
        like = a if isinstance(a, Jet) else b
        return rule(lifted(a, like), lifted(b, like))

    return applied


def composed(inner, derivatives):
    """A function of a jet by Faa di Bruno's formula.

    The derivatives of x are its value and first three derivatives, or yield them: more than are needed are not asked.
    """
    x, *rest = inner.series
    f = [part / factorial(order) for order, part in zip(range(1 + len(rest)), derivatives(x), strict=False)]
    series = np.empty(inner.series.shape)
    series[0] = f[0]
    if len(rest) > 0:
        series[1] = f[1] * rest[0]
    if len(rest) > 1:
        series[2] = f[1] * rest[1] + f[2] * rest[0] ** 2
    if len(rest) > 2:
        series[3] = f[1] * rest[2] + 2 * f[2] * rest[0] * rest[1] + f[3] * rest[0] ** 3
    return Jet(series)


def chosen(condition, yes, no):
    """The jet ``yes`` where a condition holds, elsewhere ``no``."""
    like = next(value for value in (yes, no, condition) if isinstance(value, Jet))
    condition = condition.series[0] if isinstance(condition, Jet) else condition
    return Jet(np.where(condition, lifted(yes, like).series, lifted(no, like).series))


def total(a, b):
    """A sum, and a plain number added to the value alone."""
    if not isinstance(b, Jet):
        a, b = b, a
    if isinstance(a, Jet):
        return Jet(a.series + b.series)
    series = b.series + 0.0
    series[0] = a + b.series[0]
    return Jet(series)


def product(a, b):
    """A product, by Leibniz's rule but for a plain number, of which most formulas are full.

    Beside an infinite value there is no derivative, whatever it is multiplied by.
    """
    if not isinstance(b, Jet):
        a, b = b, a
    if not isinstance(a, Jet):
        if np.isfinite(b.series).all():
            return Jet(a * b.series)
        a = lifted(a, b)
    return Jet(np.array([(a.series[: k + 1] * b.series[k::-1]).sum(axis=0) for k in range(len(a.series))]))


@jets
def smaller(a, b):
    return chosen(b.series[0] < a.series[0], b, a)


@jets
def larger(a, b):
    return chosen(b.series[0] > a.series[0], b, a)


@jets
def remainder(a, b):
    found = a - np.floor_divide(a.series[0], b.series[0]) * b
    found.series[0] = np.mod(a.series[0], b.series[0])
    return found


@jets
def angle(y, x):
    steep = np.abs(y.series[0]) > np.abs(x.series[0])
    found = np.arctan(chosen(steep, -x, y) / chosen(steep, y, x))
    found.series[0] = np.arctan2(y.series[0], x.series[0])
    return found


def power(a, b):
    """A constant power by its own derivatives, so that 0 and negative numbers may be raised; others by logarithms."""
    if not isinstance(b, Jet):

        def derivatives(x):
            factor = 1.0
            for k in range(MOST + 1):
                yield np.where(factor == 0, 0.0, factor * np.power(x, b - k))
                factor = factor * (b - k)

        return composed(a, derivatives)
    found = np.exp(b * np.log(lifted(a, b)))
    found.series[0] = np.power(lifted(a, b).series[0], b.series[0])
    return found


def turned(order):
    """The derivatives of a sine whose phase is so many quarters ahead."""

    def derivatives(x):
        sine, cosine = np.sin(x), np.cos(x)
        cycle = sine, cosine, -sine, -cosine
        return [cycle[(order + k) % 4] for k in range(MOST + 1)]

    return derivatives


def stepped(function):
    """The derivatives of a function that is constant between its steps."""
    return lambda x: [function(x), *np.zeros((MOST, 1))]


def scaled(derivatives, factor, function=None):
    """The derivatives of a function times a factor; its value may be known better."""

    def found(x):
        value, *rest = (factor * part for part in derivatives(x))
        return [function(x) if function else value, *rest]

    return found


def reciprocal(x):
    yield 1 / x
    yield -1 / x**2
    yield 2 / x**3
    yield -6 / x**4


def logarithm(x):
    yield np.log(x)
    yield from reciprocal(x)


def square_root(x):
    root = np.sqrt(x)
    yield root
    yield 1 / (2 * root)
    yield -1 / (4 * root**3)
    yield 3 / (8 * root**5)


def tangent(x):
    t = np.tan(x)
    return [t, 1 + t**2, 2 * t * (1 + t**2), 2 * (1 + t**2) * (1 + 3 * t**2)]


def hyperbolic_tangent(x):
    t = np.tanh(x)
    return [t, 1 - t**2, -2 * t * (1 - t**2), -2 * (1 - t**2) * (1 - 3 * t**2)]


def arc_sine(x):
    w = 1 / np.sqrt(1 - x**2)
    return [np.arcsin(x), w, x * w**3, (1 + 2 * x**2) * w**5]


def arc_tangent(x):
    w = 1 / (1 + x**2)
    return [np.arctan(x), w, -2 * x * w**2, (6 * x**2 - 2) * w**3]


OF_ONE = {
    np.negative: lambda x: [-x, -np.ones(1), *np.zeros((MOST - 1, 1))],
    np.positive: lambda x: [x, np.ones(1), *np.zeros((MOST - 1, 1))],
    np.absolute: lambda x: [np.abs(x), np.sign(x), *np.zeros((MOST - 1, 1))],
    np.sin: turned(0),
    np.cos: turned(1),
    np.tan: tangent,
    np.sinh: lambda x: [np.sinh(x), np.cosh(x), np.sinh(x), np.cosh(x)],
    np.cosh: lambda x: [np.cosh(x), np.sinh(x), np.cosh(x), np.sinh(x)],
    np.tanh: hyperbolic_tangent,
    np.sqrt: square_root,
    np.exp: lambda x: [np.exp(x)] * (MOST + 1),
    np.log: logarithm,
    np.log10: scaled(logarithm, 1 / np.log(10), np.log10),
    np.arcsin: arc_sine,
    np.arccos: scaled(arc_sine, -1.0, np.arccos),
    np.arctan: arc_tangent,
    **{step: stepped(step) for step in (np.floor, np.ceil, np.trunc, np.sign)},
}
OF_TWO = {
    np.add: total,
    np.subtract: jets(lambda a, b: Jet(a.series - b.series)),
    np.multiply: product,
    np.divide: lambda a, b: a * composed(b, reciprocal) if isinstance(b, Jet) else a * (1 / b),
    np.power: power,
    np.remainder: remainder,
    np.arctan2: angle,
    np.minimum: smaller,
    np.maximum: larger,
}
LIKE_NUMBERS = {
    *(np.less, np.less_equal, np.greater, np.greater_equal, np.equal, np.not_equal),
    *(np.logical_and, np.logical_or, np.logical_not),
}
