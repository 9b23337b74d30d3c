# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The manifest's version is the version: package metadata and CHANGELOG agree with it."""

import importlib.metadata
import re
import tomllib
from pathlib import Path

import pytest

import sweep_addon as sw
from sweep_addon.batch.command import main

CHECKOUT = Path(__file__).resolve().parents[1]
MANIFEST = tomllib.loads((CHECKOUT / "blender_manifest.toml").read_text(encoding="utf-8"))


def test_newest_heading_of_the_changelog_is_the_version():
    headings = re.findall(r"^## \[?(\d+\.\d+\.\d+)", (CHECKOUT / "CHANGELOG.md").read_text(encoding="utf-8"), re.M)
    assert headings[0] == MANIFEST["version"]


def test_package_metadata_has_the_version():
    try:
        version = importlib.metadata.version("sweep-addon")
    except importlib.metadata.PackageNotFoundError:
        pytest.skip("the package is not installed in this Python")
    assert version == MANIFEST["version"]


def test_manifest_keeps_to_the_platform_s_limits():
    assert len(MANIFEST["tagline"]) <= 64
    assert all(len(reason) <= 64 and not reason.endswith(".") for reason in MANIFEST["permissions"].values())


def test_the_library_and_the_command_line_say_it(capsys):
    assert sw.__version__ == MANIFEST["version"]
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"sweep {MANIFEST['version']}\n"
