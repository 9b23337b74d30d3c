# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The verb remove: its answer on standard output, and 0, 1 or 2."""

import re
import sys

import pytest

import sweep_addon as sw
from sweep_addon.batch.command import main

pytest.importorskip("fcl", reason="removal paths are asked of python-fcl")

SQUARE = sw.contours.Rectangle(0.4, 0.4)


@pytest.fixture
def jobs(tmp_path):
    """Job files of a plug, of a plate in whose hole it stands, and of a closed box around that hole."""
    frame = sw.contours.Outline(
        [[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(-0.2, -0.2), (0.2, -0.2), (0.2, 0.2), (-0.2, 0.2)]]
    )
    shapes = {
        "plug": sw.TranslationalSweep(SQUARE, height=0.2),
        "plate": sw.TranslationalSweep(frame, height=0.2),
        "shell": sw.solids.Ball(3.0) - sw.solids.Ball(2.5),
        "sheet": sw.TranslationalSweep(SQUARE, height=0.2, start="open"),
    }
    for name, shape in shapes.items():
        (tmp_path / f"{name}.toml").write_text(sw.dump(shape))
    return {name: str(tmp_path / f"{name}.toml") for name in shapes}


def test_a_path_is_told_with_its_certificate(jobs, capsys):
    assert main(["remove", jobs["plug"], jobs["plate"]]) == 0
    first, second = capsys.readouterr().out.splitlines()
    assert first == f"{jobs['plug']}: A straight way of 0.201 m"
    assert second == f"{jobs['plug']}: 0.6 mm deep in others at most, certified"


def test_where_there_is_none_it_ends_with_1(jobs, capsys):
    assert main(["remove", jobs["plug"], jobs["plate"], jobs["shell"]]) == 1
    assert capsys.readouterr().out == f"{jobs['plug']}: None: shell encloses the part\n"


def test_jobs_of_one_name_in_two_folders_are_two_parts(jobs, tmp_path, capsys):
    """Neither of which is left out: the shell holds the plug, whichever comes first."""
    (tmp_path / "other").mkdir()
    same = tmp_path / "other" / "plate.toml"
    same.write_text((tmp_path / "shell.toml").read_text())
    for others in ([jobs["plate"], str(same)], [str(same), jobs["plate"]]):
        assert main(["remove", jobs["plug"], *others]) == 1
        assert capsys.readouterr().out == f"{jobs['plug']}: None: {same} encloses the part\n"


@pytest.fixture
def caged(tmp_path):
    """Job files of a prism, and of a box in which it can move, but whose windows are too narrow for it."""
    kernel = sw.TranslationalSweep(SQUARE, height=0.2)
    box = sw.solids.Block(1, 1, 1) - sw.solids.Block(0.5, 0.5, 0.5) - sw.solids.Block(0.1, 0.1, 2.0)
    for name, shape in (("kernel", kernel), ("cage", box)):
        (tmp_path / f"{name}.toml").write_text(sw.dump(shape))
    return [str(tmp_path / f"{name}.toml") for name in ("kernel", "cage")]


def test_the_budget_is_how_many_poses_are_tried(caged, capsys):
    """More than those that were looked at for straight ways, with which a search of any budget begins."""
    tried = []
    for budget in ("0", "400"):
        assert main(["remove", *caged, "--budget", budget]) == 1
        tried.append(int(re.search(r"(\d+) poses were tried", capsys.readouterr().out)[1]))
    assert 200 <= tried[1] - tried[0] <= 800


def test_on_a_terminal_it_is_shown_how_far_the_search_is_and_taken_away_again(caged, capsys, monkeypatch):
    assert main(["remove", *caged, "--budget", "40"]) == 1
    assert capsys.readouterr().err == ""
    monkeypatch.setattr(sys.stderr, "isatty", lambda: True, raising=False)
    assert main(["remove", *caged, "--budget", "40"]) == 1
    told = capsys.readouterr().err
    assert told.startswith(f"\r\033[Ksearching a way out for {caged[0]}: 0%") and told.endswith("\r\033[K")


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["sheet", "plate"], "part: "),
        (["plug", "plug"], "plug: overlaps the part by"),
        (["plug", "plate", "--tolerance", "-1"], "tolerance: must be a number of metres, more than 0, got -1"),
        (["plug", "plate", "--budget", "-1"], "budget: must be a whole number, 0 or more, got -1"),
        (["plug", "plate", "--tolerance", "some"], "must be a number, got"),
    ],
)
def test_wrong_input_ends_with_2_and_a_sentence(jobs, capsys, arguments, said):
    assert main(["remove", *(jobs.get(word, word) for word in arguments)]) == 2
    told = capsys.readouterr()
    assert said in told.err and told.err.count("\n") == 1 and told.out == ""
