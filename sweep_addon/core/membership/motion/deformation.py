# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Solids that formulas deform on their way: from where points are then back to where they are in the solid itself.

Newton's method begins at that of many places in the solid's box that comes to be nearest to the point. How fast the
solid changes, and by how much lengths do, is looked at in fewer: of formulas nothing else is known. These places are
scattered: where they are evenly spaced, a wave may be 0 in all of them.
"""

import numpy as np

from ...declared.parameters import at
from ...formulas.expressions import compile
from ...shapes.general_sweep import PLACES
from ...trajectories.arc_length import arc_length
from ...vectors import columns, norms
from .boxes import APART, from_box, scattered
from .changes import ASIDE, FLATTEST, Change, Own, speeds
from .linear import LEAST, solved
from .panels import panels
from .ways import PARTS, apart

NODES = 729  # places in the box where Newton's method begins, and that tell where the solid gets
AT_ONCE = 64  # places, of which the distances to all nodes fit into a processor's cache: ten times as fast
FEW = 125  # where it is looked how much changes
PIECES = 64  # of the way, in each of which that is looked at
ROOM = 1.25  # for what is more between the places that are looked at
MARGIN = 0.25  # of the size: so far beyond the box places are looked for, where the formulas are finite
STEP = 1e-6  # of the size: over which slopes are taken
STEPS, HALVINGS = 40, 8  # of Newton's method, and of its steps where it misses by more
EXACT = 1e-13  # of the size
SOLVED = 1e-10


class Deformation(Change):
    """A solid that is deformed by formulas on its way, and then scaled along its own axes.

    Parameters
    ----------
    motion : Motion
    box : (2, 3) float array
        Around the solid itself.
    """

    is_unique = False

    def __init__(self, motion, box):
        measure = arc_length(motion.trajectory)
        self.total, self.formulas = measure.total, [compile(formula, PLACES) for formula in motion.formulas]
        self.bent = motion.moved  # axes along which it changes

        def laws(s):
            u, t = measure.parameter(s), s / measure.total
            return np.stack((u, *(law.evaluate(u, t, s) for law in motion.scales)), axis=1)

        breaks = apart(measure.at(motion.trajectory.joints()), measure.total)
        looked = np.abs(laws(np.linspace(0.0, measure.total, PIECES + 1))).max(axis=0)
        self.laws = panels(laws, breaks, PARTS, np.maximum(looked, 1e-3 * looked.max()))
        few = scattered(box, FEW)

        def followed(s):
            known = np.repeat(np.column_stack((s, laws(s))), len(few), axis=0)
            return self.taken(np.tile(few, (len(s), 1)), known, told=True).reshape(len(s), -1)

        reach = float(np.abs(followed(np.linspace(0.0, self.total, PIECES + 1))).max())
        self.reach = max(reach, LEAST)
        moved = panels(followed, breaks, PARTS, np.full(3 * len(few), self.reach))
        super().__init__(box, *speeds(moved, ROOM), scattered(box, NODES))
        self.look()

    def known(self, s):
        """The arc length, the trajectory's parameter and the scales at places of the way (n,): (n, 5)."""
        return np.column_stack((s, self.laws.held(s)))

    def taken(self, places, known, told=False):
        """Where places (n, 3) of the solid itself are, of what is known where: (n, 3), NaN where it is nowhere.

        What is told is refused there with a sentence.
        """
        made = columns(places.shape)
        for axis in range(3):
            made[:, axis] = self.along(axis, places, known, told)
        return made

    def along(self, axis, places, known, told=False):
        """The same along one axis: (n,)."""
        s, u, *scales = known.T
        if axis not in self.bent:
            return scales[axis] * places[:, axis]
        names, formula = dict(zip("xyz", places.T, strict=True)), self.formulas[axis]
        names |= {"t": s / self.total, "u": u, "s": s}
        with at(f"deform_{'xyz'[axis]}"):
            return scales[axis] * (formula.evaluate(**names) if told else formula.run(names))

    def maps(self, places, s):
        """The derivatives of what is made of places (n, 3): (n, 3, 3), a column for each direction."""
        known = self.known(np.broadcast_to(s, len(places)))
        return self.derived(places, known, self.taken(places, known))

    def derived(self, places, known, here):
        """The derivatives at places that are taken here: (n, 3, 3)."""
        step, made = STEP * self.size, np.zeros((3, 3, len(places))).transpose(2, 0, 1)
        inward = np.where(places > self.box.mean(axis=0), -step, step)  # formulas may end where the solid does
        for axis, name in enumerate("xyz"):
            there = places + inward * np.eye(3)[axis]
            for along in range(3):
                if along not in self.bent:
                    made[:, along, axis] = known[:, 2 + along] if along == axis else 0.0
                elif name in self.formulas[along].names:
                    made[:, along, axis] = (self.along(along, there, known) - here[:, along]) / inward[:, axis]
        return made

    def look(self):
        """See in many places where the solid gets, and by how much lengths change, in each piece of the way."""
        edges = np.linspace(0.0, self.total, 2 * PIECES + 1)
        wide = self.box + MARGIN * self.size * np.array([[-1.0], [1.0]])
        known = self.known(edges)
        found = self.taken(np.tile(scattered(wide, FEW), (len(edges), 1)), np.repeat(known, FEW, axis=0))
        self.room = wide if np.isfinite(found).all() else self.box
        few, self.nodes = scattered(self.room, FEW), self.places
        maps = self.maps(np.tile(few, (len(edges), 1)), np.repeat(edges, len(few)))
        stretches = np.linalg.svd(maps, compute_uv=False).reshape(len(edges), len(few), 3)
        least, most = stretches[..., 2].min(axis=1) / ROOM, ROOM * stretches[..., 0].max(axis=1)
        pieces = np.stack([np.arange(0, 2 * PIECES, 2) + number for number in range(3)])
        self.shortest, self.longest = least[pieces].min(axis=0), most[pieces].max(axis=0)
        self.shortest, self.flattest = np.maximum(self.shortest, 1e-9 * self.longest), FLATTEST * self.longest.max()
        places = self.taken(np.tile(self.nodes, (len(edges), 1)), np.repeat(known, len(self.nodes), axis=0))
        places = places.reshape(len(edges), -1, 3)
        self.images = places[1::2]
        low, high = places.min(axis=1)[pieces].min(axis=0), places.max(axis=1)[pieces].max(axis=0)
        room = (ROOM - 1) * norms(high - low)[:, None] / 2
        self.low, self.high = low - room, high + room

    def back(self, places, s):
        """Places (n, 3) as the solid itself has them; those far from what it becomes are in its middle."""
        s = np.broadcast_to(s, len(places))
        piece = np.clip((s / self.total * PIECES).astype(int), 0, PIECES - 1)
        away = from_box(places, self.low[piece], self.high[piece])
        own = np.broadcast_to(self.box.mean(axis=0), places.shape).copy()
        least, most = self.shortest[piece], self.longest[piece]
        near = np.flatnonzero(away <= APART * self.reach)
        missed = away.copy()
        own[near], missed[near] = self.followed(places[near], s[near], self.begun(places[near], piece[near]))
        bound = np.maximum(missed * least / most, LEAST)
        away[near] = np.where(missed > SOLVED * self.reach, bound, 0.0)[near]
        return Own(own, least, most, away, missed)

    def begun(self, places, piece):
        """The nodes of the solid that come to be nearest to places (n, 3) in pieces of the way: (n, 3)."""
        nearest = np.zeros(len(places), dtype=int)
        for number in np.unique(piece):
            some = np.flatnonzero(piece == number)
            images = self.images[number]
            half = (images**2).sum(axis=1) / 2
            for start in range(0, len(some), AT_ONCE):
                few = some[start : start + AT_ONCE]
                nearest[few] = (half - places[few] @ images.T).argmin(axis=1)
        return self.nodes[nearest]

    def followed(self, places, s, own):
        """Newton's method from places of the solid towards some of what it becomes: where it ends, what it misses."""
        best, missed, halved = own.copy(), np.full(len(own), np.inf), np.zeros(len(own), dtype=int)
        active, known = np.arange(len(own)), self.known(s)
        for _ in range(STEPS):
            if not len(active):
                break
            here = self.taken(own, known[active])
            off = places[active] - here
            far = norms(off)
            better = far < missed[active]
            best[active[better]], missed[active[better]] = own[better], far[better]
            halved[active] = np.where(better, 0, halved[active] + 1)
            going = np.flatnonzero((missed[active] > EXACT * self.reach) & (halved[active] <= HALVINGS))
            active, own, off, better, here = (part.take(going, axis=0) for part in (active, own, off, better, here))
            own = (own + best.take(active, axis=0)) / 2
            better = np.flatnonzero(better)
            start, here, off = (part.take(better, axis=0) for part in (own, here, off))
            slopes = self.derived(start, known.take(active.take(better), axis=0), here)
            own[better] = start + solved(slopes, off, ASIDE)
            own = np.clip(own, *self.room)
        return best, missed
