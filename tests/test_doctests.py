# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples in the library's docstrings do what they say."""

import doctest
import importlib
from pathlib import Path

import numpy as np
import pytest

CHECKOUT = Path(__file__).resolve().parents[1]
FILES = sorted(file.relative_to(CHECKOUT).with_suffix("") for file in CHECKOUT.glob("sweep_addon/core/**/*.py"))
NAMES = [".".join(file.parts).removesuffix(".__init__") for file in FILES]


@pytest.mark.skipif(np.lib.NumpyVersion(np.__version__) < "2.0.0", reason="NumPy 1 prints its numbers differently")
@pytest.mark.parametrize("name", NAMES)
def test_examples_hold(name):
    module = importlib.import_module(name)
    assert doctest.testmod(module, optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS).failed == 0
