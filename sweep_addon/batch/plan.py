# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plan: what is to be done for some jobs, one task for each file that will be written. Nothing is done here."""

import hashlib
from dataclasses import dataclass
from pathlib import Path

from ..core.parameters import ShapeError


@dataclass(frozen=True)
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


def plan(verb, jobs, folder, suffix, version=""):
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

    Returns
    -------
    tuple of Task

    Raises
    ------
    ShapeError
        If two jobs would write the same file.
    """
    tasks, taken = [], {}
    for job in jobs:
        if taken.setdefault(job.path.stem, job.path) != job.path:
            raise ShapeError(f"would write {job.path.stem}{suffix}, as {taken[job.path.stem]} does", str(job.path))
        frames = job.render.frames if verb == "render" else 1
        for frame in range(1, frames + 1) if frames > 1 else [0]:
            output = numbered(Path(folder, job.path.stem + suffix), frame)
            said = hashlib.sha256("\n".join((verb, suffix, str(frame), version, job.digest)).encode())
            tasks.append(Task(verb, str(job.path), str(output), frame, said.hexdigest()))
    return tuple(tasks)


def numbered(output, frame):
    """The file of one frame: ``knot.png`` is ``knot_0012.png`` for frame 12, and itself for a still.

    >>> numbered(Path("knot.png"), 12).name
    'knot_0012.png'
    """
    output = Path(output)
    return output.with_name(f"{output.stem}_{frame:04}{output.suffix}") if frame else output
