# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Forms: a shape as text and back: as a job, in TOML, and as a line of Python.

Between Python, job files and Blender lies one plain form (`plain.py`), which the constructors of shapes read. A job
says the version of its format, the kind of its shape, and every
parameter, so that its meaning does not change when a default does.
"""

import json
import re
from dataclasses import is_dataclass

from ..later import later
from .coercing import from_table
from .parameters import ShapeError, parameters, require, spelled
from .plain import MIGRATIONS, VERSION, plain
from .refusals import together
from .wording import named

counted = later("core.csg.shared", "counted")

LONGEST = 50_000_000  # bytes of a job
MOST_WRITTEN = 100_000  # operands of a tree, each as often as it is named
DEEPEST = 32  # tables and lists inside one another
BESIDE = ("version", "render")  # keys of a job beside the parameters of its shape
WIDEST = 100  # characters of a line that is written

KEY = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')"""
LONG_KEY = re.compile(rf"(?<![\w-]){KEY}(?:[ \t]*+\.[ \t]*+{KEY}){{{DEEPEST}}}")  # tomllib takes time as its square
HALF = re.compile("[\ud800-\udfff]")  # of a pair of surrogates: no file holds one
LINES = re.compile(r"[^\x00-\x08\x0b-\x1f\x7f]*(?<!')")  # what TOML holds between three quotes


def tables(text):
    """The tables of a TOML text, as bytes or str; a `ShapeError` whose key is the line if it is none.

    >>> tables("version = 1")
    {'version': 1}
    """
    import tomllib  # 2 ms of a start that most sweeps can do without

    require(len(text) <= LONGEST, f"must have at most {LONGEST} characters", len(text))
    try:
        text = text.decode("utf-8-sig") if isinstance(text, bytes) else text
    except UnicodeDecodeError as error:
        where = f"line {text[: error.start].count(bytes([10])) + 1}"
        raise ShapeError(f"must be UTF-8, got the byte 0x{text[error.start]:02x}", where) from None
    deep = LONG_KEY.search(text)
    if deep:
        raise ShapeError(
            f"must have at most {DEEPEST} names in a key", f"line {text.count(chr(10), 0, deep.start()) + 1}"
        )
    try:
        table = tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        from .slips import slips

        wrong = slips(text, error)
        raise together(ShapeError(f"must be TOML: {said}", f"line {line}") for line, said in wrong) from None
    except (ValueError, RecursionError):
        raise ShapeError(f"must be TOML, nested at most {DEEPEST} deep, with numbers of at most 64 bits") from None
    check_bounds(table)
    return table


def check_bounds(table):
    """Refuse what is nested too deep to be walked, and numbers too large for TOML, whatever its parser took."""
    level, inner = 0, [("", table)]
    while inner:
        level += 1
        require(level <= DEEPEST, f"must be nested at most {DEEPEST} deep", level, inner[0][0])
        held = [pair for key, items in inner for pair in entries(key, items)]
        key, huge = next(
            (pair for pair in held if isinstance(pair[1], int) and not -(2**63) <= pair[1] < 2**63), ("", 0)
        )
        require(not huge, "must have numbers of at most 64 bits", huge, key)
        inner = [pair for pair in held if isinstance(pair[1], (dict, list))]


def entries(key, items):
    """What a table holds, by its keys; the items of a list by the list's own."""
    if isinstance(items, list):
        return [(key, item) for item in items]
    return [(f"{key}.{named(name)}".lstrip("."), item) for name, item in items.items()]


def shape_of(shapes, table):
    """The shape that a table describes, one of the kinds of `shapes`; tables of older versions are migrated."""
    table = dict(table)
    version = table.pop("version", 1)
    numbered = isinstance(version, (int, float)) and not isinstance(version, bool) and version >= 1 and version % 1 == 0
    require(numbered, "must be a whole number, at least 1", version, "version")
    require(version <= VERSION, f"must be at most {VERSION}, the newest that this program reads", version, "version")
    for migrate in MIGRATIONS[int(version) - 1 :]:
        table = migrate(table)
    return from_table({spelled(shape): shape for shape in shapes}, table, parameters, BESIDE)


def load(shapes, text):
    """The shape that a job's text describes.

    Parameters
    ----------
    shapes : tuple of shape classes
        Those that the text may name.
    text : str or bytes
        TOML: ``version``, which may be left out for 1, ``kind``, and parameters; those left out have their defaults.

    Returns
    -------
    A shape, an instance of one of the classes.

    Raises
    ------
    ShapeError
        If the text is no TOML, or names what is no parameter, or a parameter refuses its value.

    Examples
    --------
    >>> from sweep_addon.core.shapes.kinds import SHAPES
    >>> load(SHAPES, 'kind = "generalized-cylinder"\\nscale_x = "1 - t/2"').scale_x
    Formula(text='1 - t/2')
    """
    return shape_of(shapes, tables(text))


def dump(shape):
    """A shape as the text of a job, every parameter written, so that `load` makes an equal shape of it.

    Parameters
    ----------
    shape : a shape

    Returns
    -------
    str
        TOML, with lengths in metres and angles in radians.

    Raises
    ------
    ShapeError
        For what is no shape, as a contour alone, and for a tree that names its operands more than 100,000 times.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> shape = sw.GeneralizedCylinder(twist="2*pi*t")
    >>> sw.load(sw.dump(shape)) == shape
    True
    """
    require(is_dataclass(shape) and hasattr(type(shape), "mesh"), "must be a shape", shape, "shape")
    count = counted(shape)
    require(count <= MOST_WRITTEN, f"must name at most {MOST_WRITTEN:,} operands to be written", count, "shape")
    return toml({"version": VERSION, **plain(shape)})


def toml(table):
    """A table of plain values as TOML: first what is short, then a section for each table in it or in a list of it."""

    def lines(table, path=""):
        inner = {key: value for key, value in table.items() if holds_tables(value)}
        yield from (f"{bare(key)} = {tidy(table[key], scalar, len(key) + 3)}" for key in table if key not in inner)
        for key, value in inner.items():
            head, tables = (f"[{path}{key}]", [value]) if isinstance(value, dict) else (f"[[{path}{key}]]", value)
            for each in tables:
                yield from ("", head, *lines(each, f"{path}{key}."))

    return "\n".join(lines(table)) + "\n"


def bare(key):
    """A key as TOML has it, in quotes where it has other letters than those of English."""
    return key if key.isascii() else scalar(key)


def holds_tables(value):
    """Whether a plain value is a table or a list of them."""
    return isinstance(value, dict) or isinstance(value, list) and any(isinstance(item, dict) for item in value)


def scalar(value):
    """A number, a text, true or false: JSON writes them as TOML does, but for one character; lines of text as lines."""
    if isinstance(value, str) and "\n" in value and "'''" not in value and LINES.fullmatch(value):
        return f"'''\n{value}'''"
    return json.dumps(value, ensure_ascii=False).replace("\x7f", "\\u007f")


def literal(value):
    """A plain value that is no list, as Python writes it."""
    if isinstance(value, dict):
        return f"{{{', '.join(f'{literal(key)}: {literal(held)}' for key, held in value.items())}}}"
    if isinstance(value, str) and HALF.search(value):
        return ascii(value)
    if isinstance(value, str) and "\n" in value and "'''" not in value and LINES.fullmatch(value):
        return f"r'''{value}'''" if not value.endswith("\\") else repr(value)
    return json.dumps(value, ensure_ascii=False) if isinstance(value, str) else repr(value)


def tidy(value, scalar, used, indent=""):
    """A list in lines of bearable width, rows kept whole where they fit; used: what stands before it on its line."""
    if not isinstance(value, list):
        return scalar(value)
    items = [tidy(item, scalar, len(indent) + 4, indent + "    ") for item in value]
    if used + sum(map(len, items)) + 2 * len(items) <= WIDEST and not any("\n" in item for item in items):
        return f"[{', '.join(items)}]"
    rows, width = [], WIDEST
    for item in items:
        width += len(item) + 2
        if width > WIDEST or "\n" in item:
            rows.append([])
            width = len(indent) + 4 + len(item)
        rows[-1].append(item)
    inner = "".join(f"{indent}    {', '.join(row)},\n" for row in rows)
    return f"[\n{inner}{indent}]"


def python_source(shape):
    """The line of Python that makes the shape again after ``import sweep_addon as sw``; defaults are left out.

    >>> from sweep_addon.core.contours import Circle
    >>> python_source(Circle(radius=0.1))
    'sw.contours.Circle(radius=0.1)'
    """
    return source(shape, "")


def source(value, indent):
    if isinstance(value, tuple) and any(map(is_dataclass, value)):
        deeper = indent + "    "
        items = [", ".join(source(part, deeper) for part in vars(item).values()) for item in value]
        return f"[{''.join(f'{chr(10)}{deeper}({item}),' for item in items)}{chr(10)}{indent}]"
    form = plain(value)
    if (
        not is_dataclass(value)
        or not isinstance(form, (dict, str))
        or isinstance(form, str)
        and parameters(type(value))
    ):
        return tidy(form, literal, len(indent), indent)  # a law is its shorthand, an option its name
    given = {p.name: getattr(value, p.name) for p in parameters(type(value)) if getattr(value, p.name) != p.default}
    name = public_name(type(value))
    arguments = [f"{key}={source(argument, indent)}" for key, argument in given.items()]
    line = f"{name}({', '.join(arguments)})"
    if len(indent) + len(line) <= WIDEST and "\n" not in line:
        return line
    deeper = indent + "    "
    arguments = "".join(f"{deeper}{key}={source(argument, deeper)},\n" for key, argument in given.items())
    return f"{name}(\n{arguments}{indent})"


def public_name(cls):
    """Where a class is: ``rings/ends.py`` is ``sw.ends``, ``contours/`` is ``sw.contours``, shapes are in ``sw``."""
    parts = cls.__module__.rpartition(".core.")[2].split(".")
    spaces = (
        "contours",
        "trajectories",
        "directions",
        "frames",
        "laws",
        "ends",
        "limits",
        "sampling",
        "corners",
        "solids",
        "machining",
    )
    home = next((f"{part}." for part in parts if part in spaces), "")
    return f"sw.{home}{cls.__name__}"
