# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The examples in the library's docstrings do what they say."""

import doctest
import importlib
import importlib.util
from pathlib import Path

import numpy as np
import pytest

import sweep_addon

CHECKOUT = Path(__file__).resolve().parents[1]
FILES = sorted(file.relative_to(CHECKOUT).with_suffix("") for file in CHECKOUT.glob("sweep_addon/**/*.py"))
NAMES = [".".join(file.parts).removesuffix(".__init__") for file in FILES if file.name != "__main__"]
CORE = "sweep_addon.core"
CASES = [pytest.param(name, marks=pytest.mark.thorough if name.startswith(CORE) else ()) for name in NAMES]
BLENDERS = {"bpy", "bpy_extras", "bmesh", "mathutils"}


@pytest.mark.skipif(np.lib.NumpyVersion(np.__version__) < "2.0.0", reason="NumPy 1 prints its numbers differently")
@pytest.mark.parametrize("name", CASES)
def test_examples_hold(name):
    try:
        # By its own name: by another it would be loaded once more, and hide a function of its package named as it is.
        module = importlib.import_module(sweep_addon.__name__ + name.removeprefix("sweep_addon"))
    except ModuleNotFoundError as missing:
        if missing.name not in BLENDERS or importlib.util.find_spec("bpy"):
            raise
        pytest.skip("needs Blender, and this host has none")
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS)
    for test in doctest.DocTestFinder().find(module):
        if test.examples:  # before each it asks of every file that was imported whether it has changed
            runner.run(test)
    assert not runner.failures
