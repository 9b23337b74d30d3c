# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Many jobs at once: each its own output, and a wrong one stops no others."""

import sys
from pathlib import Path

import pytest

import sweep_addon as sw
from sweep_addon.batch import verbs
from sweep_addon.batch.command import main
from sweep_addon.batch.run import Result

CHECKOUT = Path(__file__).parents[2]
PRISM = sw.GeneralizedCylinder(sw.contours.Rectangle(width=0.5, height=0.25), sw.trajectories.Line(end=(0, 0, 2)))


@pytest.fixture
def job(tmp_path):
    path = tmp_path / "tube.toml"
    path.write_text(sw.dump(PRISM) + "\n[render]\n")
    return path


def test_one_picture_of_many_turns(scene, job, capsys, monkeypatch):
    monkeypatch.setattr(verbs, "run", lambda tasks, *_: [Result(task, "done") for task in tasks])
    job.write_text(job.read_text() + "frames = 4\n")
    folder = job.with_name("out")
    assert main(["render", str(job), "--output-dir", str(folder), "--frame", "5"]) == 2
    assert capsys.readouterr().err == "frame: must be from 1 to 4, the pictures of tube.toml, got 5\n"
    assert not folder.exists()
    assert main(["render", str(job), str(job), "--output-dir", str(folder), "--frame", "3"]) == 0
    assert capsys.readouterr().out == f"{folder / 'tube_0003.png'}\n"


def test_many_jobs_are_built_in_processes_and_only_once(blender_module, scene, job, capsys, monkeypatch):
    monkeypatch.chdir(CHECKOUT)
    monkeypatch.setattr(verbs, "program", lambda arguments: (sys.executable, "-m", "sweep_addon"))
    other = job.with_name("other.toml")
    other.write_text(job.read_text())
    folder = job.parent / "out"
    line = ["build", str(job), str(other), "--output-dir", str(folder), "--format", "stl", "--parallel", "2"]
    assert main(line) == 0
    assert sorted(capsys.readouterr().out.split()) == [str(folder / "other.stl"), str(folder / "tube.stl")]
    times = {path: path.stat().st_mtime_ns for path in folder.glob("*.stl")}
    assert main(line) == 0 and {path: path.stat().st_mtime_ns for path in folder.glob("*.stl")} == times
    said = capsys.readouterr()
    assert said.err.splitlines() == ["1 of 2: tube.stl skipped", "2 of 2: other.stl skipped", "2 skipped"]
    assert sorted(said.out.split()) == sorted(map(str, times))
    other.write_text(job.read_text() + "ground = false\n")
    assert main(line) == 0
    changed = {path.name for path in folder.glob("*.stl") if path.stat().st_mtime_ns != times[path]}
    assert changed == {"other.stl"}


def test_a_wrong_job_is_told_of_and_the_others_are_done(scene, job, capsys, monkeypatch):
    monkeypatch.setattr(verbs, "run", lambda tasks, *_: [Result(task, "done") for task in tasks])
    wrong, folder = job.with_name("wrong.toml"), job.with_name("out")
    wrong.write_text("kind = 3")
    assert main(["build", str(wrong), str(job), "--output-dir", str(folder)]) == 2
    said = capsys.readouterr()
    assert said.out == f"{folder / 'tube.blend'}\n"
    refusal, summary = said.err.splitlines()
    assert refusal.startswith(f"{wrong}:1: kind: must be ")
    assert summary == "1 done, 1 refused: wrong.toml"


def test_the_last_line_says_what_became_of_many_jobs(scene, job, capsys, monkeypatch):
    states = iter(["done", "failed", "skipped", "done"])
    monkeypatch.setattr(verbs, "run", lambda tasks, *_: [Result(task, next(states), "it broke") for task in tasks])
    others = [job.with_name(f"{name}.toml") for name in ("other", "third")]
    for path in others:
        path.write_text(job.read_text())
    folder = str(job.with_name("out"))
    assert main(["build", *map(str, [job, *others]), "--output-dir", folder]) == 1
    assert capsys.readouterr().err.splitlines()[-1] == "1 done, 1 skipped, 1 failed: other.blend"
    assert main(["build", str(job), "--output-dir", folder]) == 0
    assert capsys.readouterr().err == ""


def test_a_summary_names_no_more_than_fit_on_a_line():
    refused = [f"jobs/{number}.toml" for number in range(25)]
    assert verbs.summary({"done": [], "refused": refused}).endswith(
        ": 0.toml, 1.toml, 2.toml, 3.toml, 4.toml, 5.toml, 6.toml, 7.toml, 8.toml, 9.toml, and 15 more"
    )
