# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The version of the Python package, read from the extension's manifest; all else is in pyproject.toml."""

import tomllib
from pathlib import Path

from setuptools import setup

setup(version=tomllib.loads(Path(__file__).with_name("blender_manifest.toml").read_text())["version"])
