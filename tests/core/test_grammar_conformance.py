# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grammars of "The Algorithmic Beauty of Plants" have the words, sizes and figures that cpfg and L-Py give them."""

import json
from hashlib import sha256
from pathlib import Path

import numpy as np
import pytest

from sweep_addon.core.grammars import LSystem

ENTRIES = json.loads((Path(__file__).parents[1] / "data" / "abop.json").read_text())["entries"]
CERTAIN = [entry for entry in ENTRIES if not entry["stochastic"]]


def text(entry):
    """An entry as somebody would type it."""
    lines = [f"#names {', '.join(entry['names'])}"] if "names" in entry else []
    lines += [f"#define {name} {value}" for name, value in entry.get("consts", {}).items()]
    lines += [f"#ignore {entry['ignore']}"] if "ignore" in entry else []
    lines += [f"#angle {entry['angle']}"] if "angle" in entry else []
    tropism = entry.get("tropism")
    lines += [f"#tropism {' '.join(map(str, tropism['T']))} {tropism['e']}"] if tropism else []
    lines += [f"#generations {entry['iterations']}", f"axiom: {entry['axiom']}", *entry["rules"]]
    return "\n".join(lines)


def by_id(entries):
    return pytest.mark.parametrize("entry", entries, ids=[entry["id"] for entry in entries])


def test_the_set_is_whole():
    assert len(ENTRIES) == 56 and len(CERTAIN) == 55


@by_id(CERTAIN)
def test_words_are_those_of_the_book(entry):
    system, final = LSystem.parse(text(entry)), entry["final"]
    assert [str(system.derive(n)) for n in range(len(entry["words"]))] == entry["words"]

    word = system.derive()
    letters = str(word)
    assert (len(word), len(letters)) == (final["modules"], final["string_length"])
    assert sha256(letters.encode()).hexdigest() == final["sha256"]
    assert {name: word.count(name) for name in final["symbol_counts"]} == final["symbol_counts"]
    brackets = np.cumsum([letter == "[" for letter in letters]) - np.cumsum([letter == "]" for letter in letters])
    assert brackets.max() == final["max_bracket_depth"]
    for told, total in final.get("param_sums", {}).items():
        name, _, number = told.rpartition(".")
        found = [k for k, (other, count) in enumerate(word.tables.symbols) if other == name and count > int(number)]
        assert word.columns[int(number)][np.isin(word.symbols, found)].sum() == pytest.approx(total, rel=1e-8)


@by_id(CERTAIN)
def test_every_generation_has_its_size(entry):
    told, system = entry["modules_per_generation"], LSystem.parse(text(entry))
    sizes = dict(enumerate(told["first"])) | {entry["iterations"]: told["last"]} if isinstance(told, dict) else told
    wanted = sizes.items() if isinstance(sizes, dict) else enumerate(sizes)
    assert all(len(system.derive(generation)) == size for generation, size in wanted)


@by_id([entry for entry in ENTRIES if entry["stochastic"]])
def test_a_word_of_chance_stays_within_its_bounds(entry):
    system, (least, most) = LSystem.parse(text(entry)), entry["bounds_modules"]
    sizes = [len(system.derive(seed=seed)) for seed in range(200)]
    assert least <= min(sizes) < max(sizes) <= most
    growth = entry["expected"]["mean_F_growth_factor"] ** entry["iterations"]
    segments = [system.derive(seed=seed).count("F") for seed in range(200)]
    spread = np.std(segments) / np.sqrt(len(segments))
    assert abs(np.mean(segments) - growth) < 4 * spread


@by_id(ENTRIES)
def test_reading_what_a_system_is_written_as_gives_the_same_system(entry):
    system = LSystem.parse(text(entry))
    again = LSystem.parse(str(system))
    assert str(again) == str(system)
    assert str(again.derive(3, seed=5)) == str(system.derive(3, seed=5))
