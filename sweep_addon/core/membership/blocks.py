# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many points in blocks that threads share: what is told of a block does not depend on who asks, nor on the others."""

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np

BLOCK = 1 << 16  # points: their pairs with panels fit into a processor's cache
MOST = 16  # threads


def in_blocks(labels, points, progress=None, threads=None):
    """The labels of points, block by block, in as many threads as there are processors.

    The blocks are the same for any number of threads, so the labels are so to the bit. The first block is done alone:
    what is made when it is first asked for is then there. No product of matrices is so large that a thread of these
    would start others.

    Parameters
    ----------
    labels : callable
        From points (k, 3) to (k,) int8; it may be called in several threads at once.
    points : (n, 3) float array
    progress : callable, optional
        Is told which part is done, in the thread that calls; what it raises ends the work.
    threads : int, optional
        by default one for each processor that this process may use, at most 16.

    Returns
    -------
    (n,) int8 array

    Examples
    --------
    >>> in_blocks(lambda some: np.sign(some[:, 0]).astype(np.int8), np.array([(1.0, 0, 0), (-2.0, 0, 0)])).tolist()
    [1, -1]
    """
    found = np.empty(len(points), dtype=np.int8)
    blocks = [slice(start, start + BLOCK) for start in range(0, max(len(points), 1), BLOCK)]
    progress = progress or (lambda part: None)

    def tell(block):
        found[block] = labels(points[block])

    tell(blocks[0])
    progress(1 / len(blocks))
    rest, threads = blocks[1:], threads or processors()
    if not rest:
        return found
    with ThreadPoolExecutor(min(threads, len(rest))) as pool:
        try:
            for number, _ in enumerate(pool.map(tell, rest), 2):
                progress(number / len(blocks))
        except BaseException:
            pool.shutdown(wait=True, cancel_futures=True)  # what is begun ends with its block
            raise
    return found


def processors():
    """How many processors this process may use, at most so many as help."""
    available = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return min(available, MOST)
