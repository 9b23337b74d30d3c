# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plans: how the program of an expression is calculated, with a place for each value, so that none is searched for."""

import numpy as np

from .functions import Question


class Plan:
    """The steps of a program.

    Answers become numbers only where somebody calculates with them.

    Parameters
    ----------
    names : tuple of str
    program : tuple
        As those of an expression.
    number : bool
        Whether what it comes to becomes one too.

    Attributes
    ----------
    rest : list
        What is in the places behind those of the names: numbers, and nothing yet where results go.
    steps : list of [callable, tuple of int, int]
        Functions, the places of what they take, and those of their results.
    last : int
        Where what it comes to is.
    """

    def __init__(self, names, program, number=True):
        numbers = [np.float64(step) for step in program if not isinstance(step, (str, tuple))]
        self.steps, waiting, answers = [], [], {}  # by places, which step has answered
        here, after = len(names), len(names) + len(numbers)
        free, end = [], after
        for step in program:
            if isinstance(step, str):
                waiting.append(names.index(step))
            elif isinstance(step, tuple):
                function, count = step
                taken = tuple(waiting[-count:])
                del waiting[-count:]
                free += [place for place in taken if place >= after]
                if not free:
                    free.append(end)
                    end += 1
                asked = [answers.pop(place, None) for place in taken]
                place = free.pop()
                if isinstance(function, Question):
                    answers[place] = len(self.steps)
                    function = function.asked if None in asked else function.of_answers
                else:
                    self.count(asked)
                self.steps.append([function, taken, place])
                waiting.append(place)
            else:
                waiting.append(here)
                here += 1
        (self.last,) = waiting
        if number:
            self.count([answers.get(self.last)])
        self.rest = numbers + [None] * (end - after)

    def count(self, answers):
        """Let what some steps answer become numbers."""
        for step in answers:
            if step is not None:
                self.steps[step][0] = Question(self.steps[step][0])

    def result(self, values):
        """What the program comes to, of values in the order of the names."""
        values = [*values, *self.rest]
        for function, taken, place in self.steps:
            if len(taken) == 2:  # as most have
                first, second = taken
                values[place] = function(values[first], values[second])
            else:
                values[place] = function(*[values[each] for each in taken])
        return values[self.last]
