# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Running a plan: each task in a process of its own, so that one that crashes takes no other with it.

A finished output is marked with the hash of what it was made from, beside it in ``.sweep``. A run that was killed can
be started again: what is marked is skipped, and nothing unfinished ever has an output's name.
"""

import os
import subprocess
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

from ..core.declared.frozen import frozen
from .plan import Task
from .stopping import processes, starting


@frozen
class Result:
    """What became of a task: ``done``, ``skipped`` or ``failed``, and in the last case why, in a sentence."""

    task: Task
    state: str
    sentence: str = ""


def run(tasks, program, executor=None, again=False):
    """Do what is not done yet.

    Parameters
    ----------
    tasks : iterable of Task
    program : sequence of str
        What a task's arguments are given to: ``("python", "-m", "sweep_addon")``.
    executor : concurrent.futures.Executor, optional
        Where tasks run: threads here, or ``dask.distributed.Client.get_executor(pure=False)`` on many machines that
        share the files. One task after the other if there is none.
    again : bool
        Do also what is finished.

    Yields
    ------
    Result
        One for each task, as they finish.
    """
    waiting = []
    for task in tasks:
        if not again and finished(task):
            yield Result(task, "skipped")
        else:
            waiting.append(task)
    own = executor is None
    executor = executor or ThreadPoolExecutor(max_workers=1)
    futures = {}
    try:
        futures = {executor.submit(perform, task, tuple(program)): task for task in waiting}
        for future in as_completed(futures):
            error = future.exception()  # that of an executor which lost a worker
            yield Result(futures[future], "failed", str(error) or type(error).__name__) if error else future.result()
    finally:
        for future in futures:
            future.cancel()
        if own:
            executor.shutdown(cancel_futures=True)


def perform(task, program):
    """Do one task in a process of its own, and mark its output as finished."""
    Path(task.output).parent.mkdir(parents=True, exist_ok=True)
    mark(task).unlink(missing_ok=True)
    code, told = ended([*program, *task.arguments])
    if code or not Path(task.output).is_file():
        said = told.strip().splitlines() or [f"its process ended with {code} and wrote nothing"]
        return Result(task, "failed", said[-1])
    mark(task).parent.mkdir(exist_ok=True)
    part = mark(task).with_suffix(".part")
    part.write_text(signature(task), encoding="utf-8")
    os.replace(part, mark(task))
    return Result(task, "done")


def ended(command):
    """The exit code of a process, and what it said on its error stream."""
    pipes = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE}
    with starting:
        process = subprocess.Popen(command, **pipes, text=True, errors="replace")
        processes.add(process)
    try:
        _, told = process.communicate()
    finally:
        processes.discard(process)
    return process.returncode, told


def finished(task):
    """Whether the output is there and is what the task would write."""
    try:
        return mark(task).read_text(encoding="utf-8") == signature(task)
    except OSError:
        return False


def mark(task):
    output = Path(task.output)
    return output.parent / ".sweep" / f"{output.name}.done"


def signature(task):
    """The task's hash and the output's size: a file that was cut short or replaced is not the one that was marked."""
    return f"{task.digest} {os.stat(task.output).st_size}\n"
