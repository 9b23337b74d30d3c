# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Hints: what somebody may have meant who named none of the kinds or options that there are."""

from difflib import get_close_matches
from numbers import Real

import numpy as np

from .coercing import rows
from .names import spelled
from .parameters import Array, parameters
from .refusals import ShapeError
from .wording import named, shown

MANY = 40  # names that a refusal tells
FEW = 3  # kinds of which a number says one; of more, as of trajectories, it may be any of many
MOST_LONGER = 3  # names that a refusal tells of those that somebody may have meant
SURE = 0.82  # how alike a word and the only name that it may be are: more than spline and line, or plane and plant
LONGEST = 40  # characters of what may be a name with a slip in it
PART = (  # how else a shape, which is no kind of part, can be one
    ": a shape is compared with by shape.verify(part) or verify --part part.toml; here stands a mesh, as "
    'Triangles.of(part.mesh()) or { file = "part.blend", object = "Part" }'
)
FIGURES = {  # by the names that people have for them: the kind, and what it is told
    "triangle": ("regular-polygon", "sides = 3"),
    "square": ("regular-polygon", "sides = 4"),
    "pentagon": ("regular-polygon", "sides = 5"),
    "hexagon": ("regular-polygon", "sides = 6"),
    "octagon": ("regular-polygon", "sides = 8"),
    "circle": ("arc", "angle = 6.283185307179586"),
    "sphere": ("ball", ""),
    "cube": ("block", ""),
    "box": ("block", ""),
    "trefoil": ("torus-knot", "p = 2, q = 3"),
}


def hint(names, value):
    """What to add to the refusal of a value that is none of the names; often nothing.

    Parameters
    ----------
    names : dict of str
        The kinds or options that there are, by their names.
    value : object

    Returns
    -------
    str

    Examples
    --------
    >>> from sweep_addon.core.contours import RegularPolygon, Star
    >>> hint({"regular-polygon": RegularPolygon, "star": Star}, "hexagon")
    ': say { kind = "regular-polygon", sides = 6 }'
    >>> hint({"regular-polygon": RegularPolygon, "star": Star}, "starr")
    ": did you mean 'star'?"
    """
    if "unknown" in names and (isinstance(value, str) or hasattr(value, "mesh") or hasattr(value, "triangles")):
        return meant(names, value) or PART
    if isinstance(value, str):
        kind, told = FIGURES.get(value.lower(), ("", ""))
        if kind in names:
            return f': say {{ kind = "{kind}", {told} }}' if told else f": say '{kind}'"
        return meant(names, value)
    if isinstance(value, list) and value and isinstance(value[0], dict):
        return ": a table that is no item of a list stands in single brackets, as [contour]"
    if isinstance(value, (list, tuple, np.ndarray, Array)):
        return of_a_list(names)
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return of_a_number(names, type(value))
    if isinstance(value, type) and value in names.values():
        return f": say {value.__name__}()"
    if callable(value) and "constant" in names:
        return ': say a formula in text, as "2*pi*t"'
    if hasattr(value, "bl_rna"):
        return ": say it of an object of Blender where the shape is made one, sw.to_object(shape, trajectory=ob)"
    if value is None and "constant" in names:
        return ': say a number, a formula in text, as "2*pi*t", or a list of points [t, value]'
    return ""


def meant(names, name):
    """What to add to the refusal of a name that is near one of those there are; else nothing.

    >>> meant(["radius", "points"], "raduis"), meant(["radius", "points"], "twist")
    (": did you mean 'radius'?", '')
    >>> meant(["axis_point", "axis_direction", "angle"], "axis")
    ": did you mean 'axis_point' or 'axis_direction'?"
    """
    if not isinstance(name, str) or len(name) > LONGEST:
        return ""
    longer = [other for other in names if name.lower() in other.split("_")]  # axis: axis_point, axis_direction
    near = map(repr, get_close_matches(name.lower(), names, 1) or longer[:MOST_LONGER])
    told = " or ".join(near)
    return f": did you mean {told}?" if told else ""


def unmistakable(names, name):
    """What a name with a slip in it stands for, if it is near enough to one of the names and to no other; else None.

    >>> unmistakable({"line": 1, "circle": 2}, "circel"), unmistakable({"line": 1, "circle": 2}, "spline")
    (2, None)
    """
    if not isinstance(name, str) or len(name) > LONGEST:
        return None
    near = get_close_matches(name.lower(), names, 2, SURE)
    return names[near[0]] if len(near) == 1 else None


def has_none(owner, name, names, beside=()):
    """What to say of a name that is no parameter of something, which has others, and more may stand beside them."""
    return f"no parameter of {owner}, which has {', '.join(names) or 'none'}{meant([*names, *beside], name)}"


def kindless(names, table):
    """The refusal of a table that does not say of which kind it is, or calls that something else."""
    slips = get_close_matches("kind", list(map(str, table))[:MANY], 1)
    if slips:
        return ShapeError("is no parameter: did you mean 'kind'?", named(slips[0]))
    return ShapeError(f"must be given, as {one_of(names, None)}", "kind")


def one_of(names, value):
    """Which names there are: all, or of many only the nearest.

    >>> one_of(["line", "arc"], "lin")
    'one of line, arc'
    >>> one_of([f"tree_{number}" for number in range(100)], "tree 7")
    'one of 100 names, as tree_7, tree_97, tree_87'
    """
    if len(names) <= MANY:
        return f"one of {', '.join(names)}"
    spelled = value.lower().replace(" ", "_")[:LONGEST] if isinstance(value, str) else ""
    near = get_close_matches(spelled, names, 3, 0.4) or sorted(names)[:3]
    return f"one of {len(names)} names, as {', '.join(near)}"


def of_a_list(names):
    """Which kinds a list alone could be, and how to say so."""
    kinds = [kind for kind in names.values() if isinstance(kind, type) and leading_list(kind)]
    if not kinds:
        return ""
    first, last = kinds[0], spelled(kinds[-1])
    others = ", ".join(spelled(kind) for kind in kinds[:-1])
    what = leading_list(first)
    said = f'{first.__name__}({what}=...) or {{ kind = "{spelled(first)}", {what} = ... }}'
    return f": {what} alone may be those of {f'{others} or {last}' if others else last}, say {said}"


def first_wrong(value, columns):
    """What a refusal shows, in 60 characters, of what is no list of rows: where it has some the first that is none.

    Parameters
    ----------
    value : object
    columns : int or None
        Numbers in a row; None where a row is one number.

    Returns
    -------
    str

    Examples
    --------
    >>> first_wrong([[0, 0, 1], [1, 0]], 3), first_wrong([1, 2], 3), first_wrong([1, [2]], None)
    ('[1, 0] in row 2', '[1, 2]', '[2] in row 2')
    """
    if isinstance(value, (list, tuple)) and any(map(rows, value)):
        for number, row in enumerate(value, 1):
            if not is_row(row, columns):
                text, place = shown(row), f" in row {number}"
                return (text if len(text + place) <= 60 else f"{text[: 57 - len(place)]}...") + place
    return shown(value)


def is_row(row, columns):
    """Whether a value is so many numbers, or one."""
    items = row if columns else [row]
    return rows(row) == (columns or 0) and all(isinstance(item, Real) and not isinstance(item, bool) for item in items)


def of_a_number(names, type_):
    """Which kind a number alone could be, if that is one, and how to say so.

    >>> from sweep_addon.core.stations.sampling import Count, Tolerance
    >>> of_a_number({"tolerance": Tolerance, "count": Count}, int)
    ': say Count(contours=...) or { kind = "count", contours = ... }'
    """
    kinds = [kind for kind in names.values() if isinstance(kind, type) and hasattr(kind, "__dataclass_fields__")]
    first = [(kind, p.name) for kind in kinds for p in parameters(kind)[:1] if p.type is type_]
    if len(first) != 1 or len(kinds) > FEW:
        return ""
    [(kind, name)] = first
    return f': say {kind.__name__}({name}=...) or {{ kind = "{spelled(kind)}", {name} = ... }}'


def leading_list(kind):
    """The name of the first parameter of a kind if that is a list, or nothing."""
    first = next(iter(parameters(kind)), None)
    return first.name if first is not None and first.is_list else ""
