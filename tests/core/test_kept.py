# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results are kept for equal questions as long as all fit into so many bytes; the one asked for last always is."""

import numpy as np
import pytest

from sweep_addon.core.kept import MOST_BYTES, kept

THIRD = MOST_BYTES // 3


@pytest.fixture
def made():
    """The sizes for which a result was made, and the function that makes and keeps them; it takes no memory."""
    sizes = []

    @kept
    def result(number, size):
        sizes.append(number)
        return np.broadcast_to(np.zeros(1, np.uint8), size)

    return sizes, result


def test_an_equal_question_has_the_result_that_was_made(made):
    numbers, result = made
    assert result(1, 10) is result(1, 10) and result(2, 10) is not result(1, 10)
    assert numbers == [1, 2]


def test_what_was_asked_for_longest_ago_makes_room(made):
    """Three of a third fit; a fourth takes the place of the second, as the first was asked for again."""
    numbers, result = made
    for number in (1, 2, 3, 1, 4):
        result(number, THIRD)
    assert numbers == [1, 2, 3, 4]
    for number in (1, 3, 4, 2):
        result(number, THIRD)
    assert numbers == [1, 2, 3, 4, 2]


def test_one_that_is_larger_than_all_room_stays_until_the_next(made):
    numbers, result = made
    for number in (1, 1, 2, 2, 1):
        result(number, 2 * MOST_BYTES)
    assert numbers == [1, 2, 1]


def test_room_comes_back_however_often_results_come_and_go(made):
    numbers, result = made
    for number in range(1000):
        result(number, MOST_BYTES)
    del numbers[:]
    for number in (1, 2, 3, 1, 2, 3):
        result(number, THIRD)
    assert numbers == [1, 2, 3]
