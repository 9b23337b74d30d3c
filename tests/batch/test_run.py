# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A run does what is not done, survives what crashes, and can be started again."""

import sys
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from pathlib import Path

import pytest

from sweep_addon.batch.plan import Task
from sweep_addon.batch.run import run

PROGRAM = """
import os, sys
verb, job, _, output = sys.argv[1:5]
with open(job + ".log", "a") as log:
    log.write("x")
if job.endswith("crash"):
    os.abort()
if job.endswith("bad"):
    sys.exit("first\\nit is bad")
if not job.endswith("lazy"):
    open(output, "w").write(job)
"""


@pytest.fixture
def program(tmp_path):
    script = tmp_path / "program.py"
    script.write_text(PROGRAM)
    return (sys.executable, str(script))


def tasks(folder, *names, digest="1"):
    return [Task("build", str(folder / name), str(folder / f"{name}.out"), digest=digest) for name in names]


def outcome(results):
    return {Path(result.task.job).name: (result.state, result.sentence) for result in results}


def times(folder, name):
    log = folder / f"{name}.log"
    return len(log.read_text()) if log.exists() else 0


@pytest.mark.parametrize("executor", [None, ThreadPoolExecutor(2)])
def test_one_that_crashes_takes_no_other_with_it(tmp_path, program, executor):
    found = outcome(run(tasks(tmp_path, "a", "crash", "bad", "lazy", "b"), program, executor))
    assert found["a"] == found["b"] == ("done", "")
    assert found["bad"] == ("failed", "it is bad")
    assert found["crash"][0] == found["lazy"][0] == "failed"
    assert found["lazy"][1] == "its process ended with 0 and wrote nothing"
    assert (tmp_path / "a.out").read_text() == str(tmp_path / "a")


def test_what_is_finished_is_skipped_and_only_that(tmp_path, program):
    assert outcome(run(tasks(tmp_path, "a", "bad"), program))["a"] == ("done", "")
    again = outcome(run(tasks(tmp_path, "a", "b", "bad"), program))
    assert [again[name][0] for name in ("a", "b", "bad")] == ["skipped", "done", "failed"]
    assert (times(tmp_path, "a"), times(tmp_path, "b"), times(tmp_path, "bad")) == (1, 1, 2)
    assert outcome(run(tasks(tmp_path, "a"), program, again=True))["a"][0] == "done"
    assert outcome(run(tasks(tmp_path, "a", digest="2"), program))["a"][0] == "done"


@pytest.mark.parametrize("spoil", [lambda output: output.write_text("cut"), lambda output: output.unlink()])
def test_an_output_that_was_lost_or_cut_short_is_made_again(tmp_path, program, spoil):
    list(run(tasks(tmp_path, "a"), program))
    spoil(tmp_path / "a.out")
    assert outcome(run(tasks(tmp_path, "a"), program))["a"][0] == "done"
    assert (tmp_path / "a.out").read_text() == str(tmp_path / "a")


def test_a_run_that_is_stopped_can_go_on(tmp_path, program):
    started = run(tasks(tmp_path, "a", "b", "c"), program)
    first = next(started).task
    started.close()
    found = outcome(run(tasks(tmp_path, "a", "b", "c"), program))
    assert found.pop(Path(first.job).name)[0] == "skipped"
    assert {state for state, _ in found.values()} <= {"done", "skipped"}
    assert all((tmp_path / f"{name}.out").exists() for name in "abc")


class Lost(Executor):
    """An executor that has lost its worker."""

    def submit(self, function, *arguments):
        future = Future()
        future.set_exception(BrokenExecutor("the worker is gone"))
        return future


def test_a_lost_worker_is_a_failed_task(tmp_path, program):
    assert outcome(run(tasks(tmp_path, "a"), program, Lost()))["a"] == ("failed", "the worker is gone")
