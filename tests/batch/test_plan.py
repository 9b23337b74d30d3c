# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A plan has one task for each file, and says what each depends on."""

from pathlib import Path

import pytest

from sweep_addon.batch.job import Job, Render
from sweep_addon.batch.plan import Task, plan
from sweep_addon.core.declared.parameters import ShapeError
from sweep_addon.core.shapes.kinds import GeneralizedCylinder


def job(path, digest="a", **render):
    return Job(GeneralizedCylinder(), Render(**render), digest, Path(path))


def test_a_model_and_a_still_are_one_task_and_a_turn_is_one_for_each_frame():
    jobs = [job("in/knot.toml", frames=3), job("in/ring.toml")]
    built = plan("build", jobs, "out", ".glb")
    assert [Path(task.output).as_posix() for task in built] == ["out/knot.glb", "out/ring.glb"]
    rendered = plan("render", jobs, "out", ".png")
    names = [Path(task.output).name for task in rendered]
    assert names == ["knot_0001.png", "knot_0002.png", "knot_0003.png", "ring.png"]
    assert [task.frame for task in rendered] == [1, 2, 3, 0]
    assert plan("render", jobs[:1], "out", ".png", frame=3) == rendered[2:3]
    assert plan("render", jobs[1:], "out", ".png", frame=1) == rendered[3:]


def test_a_task_is_told_as_a_person_would_tell_it():
    assert Task("render", "a.toml", "b.png", 2).arguments == ("render", "a.toml", "--output", "b.png", "--frame", "2")
    assert Task("build", "a.toml", "b.glb").arguments == ("build", "a.toml", "--output", "b.glb")


def test_whatever_changes_the_output_changes_the_digest():
    base = plan("build", [job("a.toml")], "out", ".glb", "1")[0].digest
    assert plan("build", [job("a.toml")], "elsewhere", ".glb", "1")[0].digest == base
    others = [
        plan("build", [job("a.toml", "b")], "out", ".glb", "1"),
        plan("build", [job("a.toml")], "out", ".stl", "1"),
        plan("build", [job("a.toml")], "out", ".glb", "2"),
        plan("render", [job("a.toml", frames=2)], "out", ".png", "1"),
    ]
    digests = [task.digest for tasks in others for task in tasks]
    assert base not in digests and len(set(digests)) == len(digests)


def test_two_jobs_cannot_write_one_file():
    with pytest.raises(ShapeError) as refusal:
        plan("build", [job("x/a.toml"), job("y/a.toml")], "out", ".glb")
    said, _, way_out = str(refusal.value).replace("\\", "/").rpartition(": ")
    assert said == "y/a.toml: would write a.glb, as x/a.toml does"
    assert "--output-dir" in way_out


def test_a_picture_of_a_turn_and_a_job_of_its_name_cannot_be_one_file():
    jobs = [job("in/turn.toml", frames=2), job("in/turn_0001.toml")]
    assert len(plan("build", jobs, "out", ".glb")) == 2
    for order in (jobs, jobs[::-1]):
        with pytest.raises(ShapeError, match="would write turn_0001.png, as "):
            plan("render", order, "out", ".png")


def test_a_job_that_is_given_twice_is_done_once():
    once = plan("render", [job("in/knot.toml", frames=2)], "out", ".png")
    again = [job(path, frames=2) for path in ("in/knot.toml", "in/knot.toml", "in/../in/knot.toml")]
    assert plan("render", again, "out", ".png") == once


@pytest.mark.parametrize("frame", [-1, 4])
def test_a_picture_that_no_turn_has_is_refused(frame):
    with pytest.raises(ShapeError, match=f"^frame: must be from 1 to 3, the pictures of knot.toml, got {frame}$"):
        plan("render", [job("in/knot.toml", frames=3)], "out", ".png", frame=frame)
