# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chains of edges joined to loops, as lines and arcs of drawings are that were drawn one by one."""

from collections import defaultdict, deque
from math import floor

import numpy as np

SAME = 1e-6  # of the size: ends closer than this are joined


def closed_loops(chains):
    """The loops that chains of edges close; what stays open is left out.

    Parameters
    ----------
    chains : list of (n, 5) float arrays
        Edges one after the other, each its start, its end and its bulge.

    Returns
    -------
    list of ((n, 2) float array, (n,) float array)
        Corners and bulges. Where more than two ends meet, those are joined first that were drawn first.

    Examples
    --------
    >>> sides = [(0, 0, 1, 0, 0), (1, 1, 1, 0, 0), (0, 0, 1, 1, 0)]
    >>> [(corners, _)] = closed_loops([np.array([side], float) for side in sides])
    >>> corners.tolist()
    [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]
    """
    chains = [chain for chain in chains if len(chain)]
    if not chains:
        return []
    size = float(np.ptp(np.concatenate([chain[:, :4].reshape(-1, 2) for chain in chains]), axis=0).max())
    cell = max(SAME * size, 1e-300)
    nodes = Nodes(cell)
    ends = [(nodes.of(chain[0, :2]), nodes.of(chain[-1, 2:4])) for chain in chains]
    loops = [np.concatenate(list(run)) for run in runs(chains, ends)]
    lengths = [np.hypot(*(loop[:, 2:4] - loop[:, :2]).T) > cell for loop in loops]
    loops = [loop[long] for loop, long in zip(loops, lengths, strict=True)]
    return [(loop[:, :2], loop[:, 4]) for loop in loops if len(loop) > 2 or len(loop) == 2 and loop[:, 4].any()]


def runs(chains, ends):
    """The chains of each loop, one after the other, those drawn the other way run backward."""
    at, used = defaultdict(deque), [False] * len(chains)
    for number, pair in enumerate(ends):
        for node in pair:
            at[node].append(number)
    for first in range(len(chains)):
        if used[first]:
            continue
        used[first], run, here = True, [chains[first]], ends[first][1]
        while here != ends[first][0]:
            meeting = at[here]
            while meeting and used[meeting[0]]:
                meeting.popleft()
            if not meeting:
                break
            number = meeting.popleft()
            used[number] = True
            start, end = ends[number]
            run.append(chains[number] if start == here else backward(chains[number]))
            here = end if start == here else start
        else:
            yield run


class Nodes:
    """Places that are one where they are closer than a distance.

    Parameters
    ----------
    cell : float
    """

    def __init__(self, cell):
        self.cell, self.known, self.count = cell, {}, 0

    def of(self, place):
        """The number of a place."""
        x, y = (floor(value / (2 * self.cell)) for value in place)
        for key in ((x + i, y + j) for i in (0, -1, 1) for j in (0, -1, 1)):
            for other, number in self.known.get(key, ()):
                if max(abs(place[0] - other[0]), abs(place[1] - other[1])) <= self.cell:
                    return number
        self.known.setdefault((x, y), []).append((place, self.count))
        self.count += 1
        return self.count - 1


def backward(chain):
    """A chain run from its end to its start."""
    return np.column_stack((chain[::-1, 2:4], chain[::-1, :2], -chain[::-1, 4]))
