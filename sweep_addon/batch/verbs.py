# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The verbs of the command line. Each takes what was told and returns the exit code."""

import hashlib
import importlib.util
import json
import sys
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path

import numpy as np

from ..core.declared import description
from ..core.declared.parameters import ShapeError, require, spelled
from ..core.self_intersection.places import Places
from ..core.shapes.kinds import SWEPT
from ..core.shapes.machined_stock import MachinedStock
from . import describing, grammar
from . import job as jobs
from .export import MODELS, PICTURES, check_output, save_model, silent
from .plan import numbered, numbers, plan
from .run import run

NAMED = 10  # files of one fate that the summary of many jobs names


class CommandError(Exception):
    """Something that should have worked did not: a sentence."""


def code_of(refusal):
    """The exit code of a refusal: 2 where what was told is wrong, 1 where only a library or Blender is missing here."""
    return max(1 if isinstance(each.__cause__, ImportError) else 2 for each in refusal.each())


def read(path):
    """The job in a file; what Blender prints about a file that it refers to is no result."""
    with silent():
        return jobs.read(path)


def build(told):
    """Write the shape of a job as a model: a .blend with the shape live in it, camera and light, or a .glb, .stl,
    .obj or .ply of the shape alone."""
    need_blender()
    if told.output_dir:
        return run_many("build", told)
    output, job = check_output(told.output, MODELS), only_job(told)
    from . import scene

    with pointing_at(job):
        composed = scene.compose(job, job.path.stem)
    made = scene.told(composed)
    tell(f"writing {output.name}")
    save_model(output)
    say(output)
    warn(job.path, meeting(job.shape).in_place_of(made))
    return 0


def render(told):
    """Write a picture of the shape of a job, made as its table [render] says."""
    need_blender()
    if told.output_dir:
        return run_many("render", told, told.frame)
    output, job = check_output(told.output, PICTURES), only_job(told)
    frames = numbers(job, told.frame)
    from . import scene
    from .watching import watched

    for frame in frames:
        with pointing_at(job):
            scene.compose(job, job.path.stem, frame)
        written = output if frame == told.frame else numbered(output, frame)
        with watched(f"rendering {written.name}, {job.render.width} x {job.render.height}", told.progress):
            scene.render_picture(job.render, written)
        say(written)
    return 0


def check(told):
    """Read jobs and make their meshes, and say for each whether it is right, or at which line and key it is not; and
    where it meets itself."""
    code = 0
    for path in told.jobs:
        try:
            job = read(path)
            with pointing_at(job):
                mesh = job.shape.mesh()
                found = meeting(job.shape)
            counts = f"{len(mesh.vertices):,} vertices and {len(mesh.offsets) - 1:,} faces"
            say(", ".join(filter(None, (f"{path}: {counts}", size(mesh.vertices)))))
            warn(path, found.in_place_of(mesh.told))
        except ShapeError as refusal:
            sys.stderr.write(f"{refusal}\n")
            code = max(code, code_of(refusal))
    return code


def verify(told):
    """Say whether the programs of jobs of machined stock make their parts: what they cut away of these, where rapid
    moves cut, and by which lines."""
    part = read(told.part).shape if told.part else None
    code = 0
    for path in told.jobs:
        try:
            job = read(path)
            with pointing_at(job):
                require(isinstance(job.shape, MachinedStock), "must be machined-stock", word(job.shape), "kind")
                found = job.shape.verify(part)
        except ShapeError as refusal:
            sys.stderr.write(f"{refusal}\n")
            code = max(code, code_of(refusal))
            continue
        say(f"{path}: {'right' if found.correct else 'wrong'}")
        for sentence in found.sentences():
            say(f"{path}: {sentence}")
        code = max(code, 0 if found.correct else 1)
    return code


def word(shape):
    """The kind of a shape, as jobs name it."""
    return spelled(type(shape))


def size(vertices):
    """The sides of the box that holds vertices, in words of three digits each; nothing where there are none.

    >>> size([(0.0, 0.0, 0.0), (0.4, 1250.4, 0.0305)])
    '0.4 x 1250 x 0.0305 m'
    """
    if not len(vertices):
        return ""
    sides = np.ptp(vertices, axis=0)
    digits = np.maximum(2 - np.floor(np.log10(np.maximum(sides, 1e-9 * sides.max() + 1e-300))), 0).astype(int)
    return f"{' x '.join(f'{round(float(side), int(kept)):.9g}' for side, kept in zip(sides, digits, strict=True))} m"


def meeting(shape):
    """Where a sweep meets itself: nowhere, for a tree, whose operands are made solids first, and for what grew."""
    return shape.self_intersections() if isinstance(shape, SWEPT) else Places(())


def describe(told):
    """Say what a job may tell of a shape, a tree, one of its choices, as circle or helix, or of render: parameters
    with units, limits and defaults. Of a preset, as hose, print the job."""
    if told.schema:
        say(json.dumps(jobs.schema(), indent=2))
        return 0
    if not told.shape:
        say("\n".join(describing.everything()))
        return 0
    job = describing.preset(told.shape)
    if job:
        say(job)
        return 0
    kinds = describing.named(told.shape)
    if not kinds:
        say("\n".join(grammar.describe(told.shape)))
        return 0
    tables = (description.markdown(kind) if told.markdown else describing.table(told.shape, kind) for kind in kinds)
    say("\n\n".join(tables))
    return 0


def run_many(verb, told, frame=0):
    """Do many jobs, each in a process of its own, and go on where the last run stopped; wrong ones stop no others."""
    require(not told.output and told.parallel >= 1, "must be at least 1", told.parallel, "parallel")
    understood, refused, code = [], [], 0
    for path in told.jobs:
        try:
            understood.append(read(path))
        except ShapeError as refusal:
            sys.stderr.write(f"{refusal}\n")
            refused.append(path)
            code = max(code, code_of(refusal))
    folder = Path(told.output_dir).absolute()
    require(folder.is_dir() or not folder.exists(), "must be a folder", told.output_dir, "output-dir")
    tasks = plan(verb, understood, folder, f".{told.format}", version(), frame)
    folder.mkdir(parents=True, exist_ok=True)
    became = {"done": [], "skipped": [], "failed": [], "refused": refused}
    with ThreadPoolExecutor(max_workers=told.parallel) as executor:
        for number, result in enumerate(run(tasks, program(told.arguments), executor, told.again), 1):
            became[result.state].append(result.task.output)
            if result.state == "skipped" or sys.stderr.isatty():
                sys.stderr.write(f"{number} of {len(tasks)}: {Path(result.task.output).name} {result.state}\n")
            if result.state == "failed":
                sys.stderr.write(f"{result.task.job}: {result.sentence}\n")
                code = code or 1
            else:
                say(result.task.output)
    if len(told.jobs) > 1:
        sys.stderr.write(f"{summary(became)}\n")
    return code


def summary(became):
    """What became of many jobs: how many are done or were skipped, and of the others which they are.

    Parameters
    ----------
    became : dict of list of str
        Paths of outputs, or of jobs that were refused, by what became of them.

    Returns
    -------
    str

    Examples
    --------
    >>> summary({"done": ["o/a.png", "o/b.png"], "failed": [], "refused": ["jobs/c.toml"]})
    '2 done, 1 refused: c.toml'
    """
    said = []
    for state, paths in became.items():
        names = [Path(path).name for path in paths[:NAMED]] if state in ("failed", "refused") else []
        names += [f"and {len(paths) - NAMED} more"] if names and len(paths) > NAMED else []
        said += [f"{len(paths)} {state}{': ' * bool(names)}{', '.join(names)}"] if paths else []
    return ", ".join(said)


def program(arguments):
    """How this program was started, without its own arguments: what a process for one task is started by."""
    import bpy

    if bpy.app.binary_path:
        started = [bpy.app.binary_path, *sys.argv[1:]]
    else:
        started = [sys.executable, *sys.orig_argv[1:]]
    return started[: len(started) - len(arguments)]


def version():
    """A hash of this program and of Blender, so that what another version wrote is not taken for finished."""
    import bpy

    said = hashlib.sha256(bpy.app.version_string.encode())
    home = Path(__file__).parents[1]
    for file in sorted(home.rglob("*.py"), key=lambda file: file.relative_to(home).as_posix()):
        said.update(file.read_bytes())
    return said.hexdigest()


@contextmanager
def pointing_at(job):
    """Say of a refusal at which line of the job it is."""
    try:
        yield
    except ShapeError as refusal:
        text = jobs.decoded(job.path.read_bytes())
        wrong = jobs.JobError(refusal, job.path, text)
        raise wrong from wrong.__cause__


def only_job(told):
    require(len(told.jobs) == 1, "takes one job; for more give --output-dir", len(told.jobs), "output")
    return read(told.jobs[0])


def need_blender():
    if importlib.util.find_spec("bpy") is None:
        raise CommandError(
            "This needs Blender: run it as blender --background --command sweep ..., "
            "or pip install 'bpy==4.5.*' with Python 3.11 or 'bpy==5.2.*' with Python 3.13."
        )


def warn(path, sentences):
    """What a person should know of a job, beside its result: on standard error."""
    sys.stderr.writelines(f"{path}: {sentence}\n" for sentence in sentences)


def say(result):
    sys.stdout.write(f"{result}\n")
    sys.stdout.flush()


def tell(sentence):
    """Progress, for somebody who watches: a line on standard error if it is a terminal."""
    if sys.stderr.isatty():
        sys.stderr.write(f"{sentence}\n")
