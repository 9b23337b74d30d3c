# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs of milling machines: how fast they are read, beside libraries, and how fast and well stock is cut."""

import gzip
from pathlib import Path

import numpy as np
from measuring import medians, short, table, tell

from bl_ext.user_default import sweep_addon as sw

try:
    import gcodeparser
except ImportError:
    gcodeparser = None

PROGRAMS = Path(__file__).resolve().parents[1] / "tests" / "data" / "gcode"
READ = "camotics_flower_mold.nc", "camotics_botomata_bottom.nc", "linuxcnc_blur_torus.ngc"
CUT = "camotics_flower_mold.nc"
ROUNDS, PLACES = 5, 512
OURS, PARSER = "this project", "gcodeparser"
INTRODUCTION = f"""
### Machining

Reading programs: microseconds a line of the text, medians of {ROUNDS} turns. gcodeparser gives the words of each line;
expressions, subroutines and loops, of which one line makes many moves, are run by this project alone.

"""
CUTTING = f"""

Cutting: `{CUT}` with a ball nose on {PLACES} x {PLACES} places. Here that ends with a mesh; beside it is what
simulations of heights do, written with NumPy for this page, which ends with heights: an image of the tool is stamped
at each cell of the way. Milliseconds, medians of {ROUNDS} turns, and how much more the second removes.

"""


def text_of(name):
    return gzip.decompress((PROGRAMS / f"{name}.gz").read_bytes()).decode()


def reading():
    """A row for each program."""
    for name in READ:
        text = text_of(name)
        actions = {OURS: lambda i, text=text: sw.machining.read(text)}
        if gcodeparser:
            actions[PARSER] = lambda i, text=text: gcodeparser.GcodeParser(text).lines
        times, _ = medians(actions, ROUNDS, times=1)
        each = {reader: 1000 * taken / text.count("\n") for reader, taken in times.items()}
        yield [
            name,
            f"{text.count(chr(10)):,}",
            f"{len(sw.machining.read(text)):,}",
            short(each[OURS]),
            short(each[PARSER]) if PARSER in each else "not installed",
        ]


def stamped(path, radius, low, cell, size, top):
    """Heights after an image of a ball has been stamped at each cell of the way of each move."""
    reach = int(np.ceil(radius / cell))
    steps = np.arange(-reach, reach + 1) * cell
    across = steps[:, None] ** 2 + steps**2
    image = np.where(across <= radius**2, radius - np.sqrt(np.maximum(radius**2 - across, 0)), np.inf)
    heights = np.full((size[0] + 2 * reach, size[1] + 2 * reach), top)
    starts, ends, _ = path.segments(1e-5)
    for start, end in zip(starts, ends, strict=True):
        count = max(1, int(np.ceil(np.linalg.norm(end - start) / cell)))
        places = start + (end - start) * (np.arange(1, count + 1) / count)[:, None]
        x, y = np.round((places[:, :2] - low[:2]) / cell).astype(int).T
        for i, j, z in zip(x, y, places[:, 2], strict=True):
            window = heights[i : i + 2 * reach + 1, j : j + 2 * reach + 1]
            np.minimum(window, image + z, out=window)
    return heights[reach:-reach, reach:-reach]


def cutting():
    """The rows of both ways to cut, and how much more the second removes."""
    path, tool = sw.machining.read(text_of(CUT)), sw.machining.BallNose(diameter=0.003)
    low, high = path.points.min(axis=0) - 0.002, path.points.max(axis=0) + 0.002
    cell = float((high - low)[:2].max()) / (PLACES - 1)
    high[:2], high[2] = low[:2] + (PLACES - 1) * cell, 0.0
    low[2] -= 0.002
    box = sw.machining.Box(tuple(low), tuple(high))
    size = (PLACES, PLACES)

    def stock(number):
        return sw.MachinedStock(text_of(CUT), tool, stock=box, cell=cell, tolerance=1e-5 * (1 + 1e-6 * number))

    actions = {
        OURS: lambda number: stock(number).mesh(),
        "stamping": lambda number: stamped(path, tool.diameter / 2, low, cell, size, high[2]),
    }
    times, _ = medians(actions, ROUNDS, times=1)
    block = float(np.prod(high - low))
    removed = block - stock(0).mesh().volume()
    heights = np.maximum(actions["stamping"](0), low[2]) - low[2]
    less = block - held(heights, cell)
    yield [OURS, short(times[OURS]), ""]
    yield ["stamping", short(times["stamping"]), f"{100 * (less / removed - 1):+.2f} %"]


def held(heights, cell):
    """What is below heights at places of a lattice, linear between them."""
    means = (heights[1:, 1:] + heights[:-1, 1:] + heights[1:, :-1] + heights[:-1, :-1]) / 4
    return float(means.sum()) * cell**2


def main():
    titles = ["program", "lines", "moves", f"{OURS}, µs a line", f"{PARSER}, µs a line"]
    page = INTRODUCTION + table(titles, reading())
    tell(page + CUTTING + table(["", "ms", "removed"], cutting()))


main()
