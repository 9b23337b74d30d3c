# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Verifying a program: where it cuts into the desired part, what it leaves beside it, and by which lines.

The intersection of the part with what the tool sweeps must be empty. All is known at the places of the lattice at which
the stock's heights are.
"""

from dataclasses import dataclass, field

import numpy as np

from ..declared.parameters import ShapeError, require
from ..progress import unheard, within
from .cutting import Question, cut
from .decided import decided
from .desired import Desired
from .gouging import TOUCHING, part_cuts, rapid_cuts

ROUNDING = 1e-8  # metres that may be cut away at least: coordinates of meshes are rounded
BELOW = 1e-6  # metres below the bottom of the stock, from which on it is told
NO_PART = "There was no part to compare with."
FEW = 6  # lines that a sentence names
FAULTS = ("The program cuts ", "The part reaches ", "Rapid moves cut ", "The tool goes ")  # how sentences of them begin


@dataclass(frozen=True)
class Verification:
    """What is wrong with a program, and how much.

    Attributes
    ----------
    gouged_volume, excess_volume : float
        Of the part that is cut away, and of stock that is left beside it, in cubic metres; 0 without a part.
    gouge, excess : float
        The largest depth of a cut into the part, and height of what is left above it, in metres.
    gouging, rapid, below : dict of int to float
        The lines of the program that cut into the part; whose rapid moves cut into stock; and that go below the bottom
        of the stock: how deep each does, in metres.
    outside : float
        How far the part reaches out of the stock, in metres.
    where : tuple of 2 floats
        The place of the deepest cut into the part, seen from above, in metres.
    decided : tuple of str
        What else is worth knowing, a sentence each: nothing that is cut, tools that are missing or too wide.
    deviation : (n, m) float array
        The height of what is left above the part at the places of the lattice: negative where it is cut into. On walls,
        as near as the allowance, from the nearest height that the part has there. None without a part.
    """

    gouged_volume: float = 0.0
    excess_volume: float = 0.0
    gouge: float = 0.0
    excess: float = 0.0
    gouging: dict = field(default_factory=dict)
    rapid: dict = field(default_factory=dict)
    below: dict = field(default_factory=dict)
    outside: float = 0.0
    where: tuple = (0.0, 0.0)
    decided: tuple = ()
    deviation: np.ndarray = field(default=None, repr=False, compare=False)

    @property
    def correct(self):
        """Whether nothing of the part is cut away, no rapid move cuts, and none goes below the stock."""
        return not (self.gouge or self.rapid or self.below or self.outside)

    def sentences(self):
        """What is wrong, what is left, and what was decided, a sentence each: a tuple of str."""
        said = []
        if self.gouging:
            x, y = (round(1e3 * number, 3) for number in self.where)
            said.append(
                f"The program cuts up to {self.gouge * 1e3:.3g} mm into the part, {self.gouged_volume * 1e9:.3g} mm3, "
                f"deepest at x {x:g} mm, y {y:g} mm, by {named(self.gouging)}."
            )
        if self.outside:
            said.append(f"The part reaches {self.outside * 1e3:.3g} mm out of the stock.")
        if self.rapid:
            said.append(
                f"Rapid moves cut up to {max(self.rapid.values()) * 1e3:.3g} mm into the stock, by {named(self.rapid)}."
            )
        if self.below:
            deepest = max(self.below.values())
            said.append(f"The tool goes up to {deepest * 1e3:.3g} mm below the stock, by {named(self.below)}.")
        if self.deviation is None:
            said.append(NO_PART)
        elif self.excess_volume:
            said.append(
                f"Up to {self.excess * 1e3:.3g} mm are left above the part, {self.excess_volume * 1e9:.3g} mm3."
            )
        else:
            said.append("Nothing is left beside the part.")
        return (*said, *self.decided)


def is_fault(sentence):
    """Whether a sentence tells of something that is wrong, beside what is left or was decided.

    >>> is_fault("Nothing is left beside the part."), is_fault("The part reaches 5 mm out of the stock.")
    (False, True)
    """
    return sentence.startswith(FAULTS)


def named(lines):
    """Some lines of a program for people, the worst first.

    >>> named({3: 0.1, 8: 0.2})
    'lines 8 and 3'
    """
    worst = [str(line) for line, _ in sorted(lines.items(), key=lambda item: (-item[1], item[0]))]
    if len(worst) == 1:
        return f"line {worst[0]}"
    if len(worst) > FEW:
        return f"lines {', '.join(worst[:FEW])} and {len(worst) - FEW} more"
    return f"lines {', '.join(worst[:-1])} and {worst[-1]}"


def verify(stock, part=None, allowance=None, progress=unheard):
    """Whether a program makes a part of its stock: what it cuts away of it, what it leaves, and by which lines.

    Parameters
    ----------
    stock : MachinedStock
    part : Mesh, shape, solid or tree, optional
        The desired part, in the places of the program; by default that of the stock, which may be unknown. What can be
        seen of it from above counts.
    allowance : float, optional
        How much may be cut away, in metres, to the side too; by default what the stock says.
    progress : callable, optional
        Is told which part of the comparison is done, from 0 to 1; what it raises ends the work.

    Returns
    -------
    Verification

    Raises
    ------
    ShapeError
        Where the program is refused, or the part has no faces.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> program = '''G21 F300
    ... G0 X0 Y0 Z5
    ... G1 Z-2
    ... X15
    ... Y15 Z-2.5
    ... G0 X0'''
    >>> block = sw.machining.Box(low=(-0.02, -0.02, -0.01), high=(0.02, 0.02, 0.0))
    >>> part = sw.solids.Block(0.04, 0.04, 0.008).moved(z=-0.006)
    >>> found = sw.machining.verify(sw.MachinedStock(program, stock=block), part)
    >>> found.correct, sorted(found.gouging), sorted(found.rapid), round(found.gouge, 6)
    (False, [5, 6], [6], 0.0005)
    >>> print(found.sentences()[1])
    Rapid moves cut up to 2.5 mm into the stock, by line 6.
    """
    require(hasattr(stock, "program"), "must be machined stock", stock, "stock")
    machined = cut(Question.of(stock))
    mesh = part_of(stock if part is None else part, "part" if part is None else "")
    rapid = rapid_cuts(machined, within(progress, 0.0, 0.5))
    found = {"rapid": by_line(machined, rapid), "below": by_line(machined, below_bottom(machined))}
    found["decided"] = decided(machined, [each.number for each in stock.tools])
    if mesh is not None:
        allowance = stock.allowance if allowance is None else allowance
        found |= beside_part(machined, mesh, allowance, within(progress, 0.5, 1.0))
    progress(1.0)
    return Verification(**found)


def part_of(value, name):
    """The mesh of a part, or None where it is not known."""
    value = getattr(value, name) if name else value
    value = value.mesh() if hasattr(value, "mesh") else value
    if value is None:
        return None
    require(hasattr(value, "triangles"), "must be a mesh, a shape, a solid or a tree", value, "part")
    if not len(value.triangles):
        raise ShapeError("must have faces, got none", "part")
    return value


def by_line(machined, depths):
    """How deep the worst move of each line goes, by the depths of some of the pieces of moves: dict of int to float."""
    deep = np.flatnonzero(depths > 0)
    lines, which = np.unique(machined.path.lines[machined.moves[deep]], return_inverse=True)
    worst = np.zeros(len(lines))
    np.maximum.at(worst, which.ravel(), depths[deep])
    return dict(zip(lines.tolist(), worst.tolist(), strict=True))


def below_bottom(machined):
    """How far each piece of a move goes below the bottom of the stock, above or within the block: (m,) array."""
    low = np.minimum(machined.starts[:, 2], machined.ends[:, 2])
    depths = np.where(low < machined.low[2] - BELOW, machined.low[2] - low, 0.0)
    for tool, rows in machined.tools:
        first = np.minimum(machined.starts[rows], machined.ends[rows])[:, :2] - tool.radius
        last = np.maximum(machined.starts[rows], machined.ends[rows])[:, :2] + tool.radius
        apart = (first > machined.high[:2]) | (last < machined.low[:2])
        depths[rows[apart.any(axis=1)]] = 0.0
    return depths


def beside_part(machined, mesh, allowance, progress):
    """What is cut away of a part and left beside it."""
    allowance = max(allowance, ROUNDING)
    lattice, places = machined.lattice, np.asarray(mesh.vertices, dtype=np.float64)
    part = Desired.of(mesh, machined, allowance)
    weights, deviation = areas(lattice), machined.left - part.nearest(machined.left)
    least, most = part.lowest - allowance, part.highest + allowance
    gouged, excess = machined.left < least, machined.left > most
    depth = np.where(gouged, -deviation, 0.0)
    deepest = np.unravel_index(np.argmax(depth), depth.shape)
    depths = part_cuts(machined, np.where(gouged, least, -np.inf), machined.left - deviation, progress)
    if depths.max(initial=0.0) < depth.max() - TOUCHING:  # in steps too small to be told each
        depths[machined.by[deepest]] = depth.max()
    reach = max((machined.low - places.min(axis=0)).max(), (places.max(axis=0) - machined.high).max())
    return {
        "gouged_volume": float(np.sum(weights * part.lower * depth)),
        "excess_volume": float(np.sum(weights * np.where(excess, deviation, 0.0))),
        "gouge": float(depth.max()),
        "excess": float(deviation[excess].max(initial=0.0)),
        "gouging": by_line(machined, depths),
        "outside": float(reach) if reach > allowance else 0.0,
        "where": tuple(float(lattice.along(axis)[deepest[axis]]) for axis in range(2)),
        "deviation": deviation,
    }


def areas(lattice):
    """The area that each place of a lattice stands for: (n, m), smaller on its edge."""
    along = [np.full(size, step) for size, step in zip(lattice.size, lattice.step, strict=True)]
    for lengths in along:
        lengths[[0, -1]] /= 2
    return np.multiply.outer(*along)
