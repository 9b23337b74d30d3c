# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The tests that `scripts/test --fast` leaves out are there: one that was renamed would be run again."""

from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[1]


def test_every_slow_test_is_there():
    named = (CHECKOUT / "tests" / "slow.txt").read_text(encoding="utf-8").split()
    parts = [name.split("::") for name in named]
    assert [name for name, (file, test) in zip(named, parts, strict=True) if not is_in(file, test)] == []


def is_in(file, test):
    """Whether a file of the checkout has a test."""
    return (CHECKOUT / file).is_file() and f"def {test}(" in (CHECKOUT / file).read_text(encoding="utf-8")
