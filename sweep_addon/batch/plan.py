# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plan: what is to be done for some jobs, one task for each file that will be written. Nothing is done here."""

import hashlib
from os.path import abspath
from pathlib import Path

from ..core.declared.frozen import frozen
from ..core.declared.parameters import ShapeError, require


@frozen
class Task:
    """One file to be written, in words that any process on any machine can follow.

    Attributes
    ----------
    verb : str
        ``build`` or ``render``.
    job, output : str
        Paths of the job file and of the file to be written.
    frame : int
        Which picture of a turn, from 1; 0 for a still or a model.
    digest : str
        A hash of everything the output depends on.
    """

    verb: str
    job: str
    output: str
    frame: int = 0
    digest: str = ""

    @property
    def arguments(self):
        """What follows the program's name on the command line."""
        frame = ("--frame", str(self.frame)) if self.frame else ()
        return (self.verb, self.job, "--output", self.output, *frame)


def plan(verb, jobs, folder, suffix, version="", frame=0):
    """The tasks of some jobs.

    Parameters
    ----------
    verb : str
        ``build`` or ``render``.
    jobs : iterable of Job
        Each with a path; its name is that of the output.
    folder : path
        Where the outputs go.
    suffix : str
        ``.glb``, ``.png``, ...
    version : str, optional
        Of the program: outputs of another one are not taken for finished.
    frame : int
        Only this picture of each turn, from 1; 0 for all.

    Returns
    -------
    tuple of Task
        A job that is given twice is done once.

    Raises
    ------
    ShapeError
        If two jobs would write the same file, or the turn of one has no such picture.
    """
    tasks = {}
    for job in jobs:
        for number in numbers(job, frame) if verb == "render" else [0]:
            output = numbered(Path(folder, job.path.stem + suffix), number)
            said = hashlib.sha256("\n".join((verb, suffix, str(number), version, job.digest)).encode())
            other = tasks.setdefault(output, Task(verb, str(job.path), str(output), number, said.hexdigest()))
            if abspath(other.job) != abspath(job.path):
                way_out = "rename one of them, or give the jobs of each folder an --output-dir of their own"
                raise ShapeError(f"would write {output.name}, as {other.job} does: {way_out}", str(job.path))
    return tuple(tasks.values())


def numbers(job, frame=0):
    """The numbers of the pictures of a job's turn, or of one of them; 0 alone for a still."""
    frames = job.render.frames
    require(0 <= frame <= frames, f"must be from 1 to {frames}, the pictures of {job.path.name}", frame, "frame")
    if frames == 1:
        return [0]
    return [frame] if frame else range(1, frames + 1)


def numbered(output, frame):
    """The file of one frame: ``knot.png`` is ``knot_0012.png`` for frame 12, and itself for a still.

    >>> numbered(Path("knot.png"), 12).name
    'knot_0012.png'
    """
    output = Path(output)
    return output.with_name(f"{output.stem}_{frame:04}{output.suffix}") if frame else output
