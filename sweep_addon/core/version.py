# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The version of this program, from the one place where it is written: the extension's manifest."""

from importlib import metadata
from pathlib import Path

MANIFEST = Path(__file__).parents[2] / "blender_manifest.toml"


def version():
    """The version, as ``0.1.0``: of the extension or checkout, or of the installed package that was made from it."""
    if MANIFEST.is_file():
        import tomllib

        return tomllib.loads(MANIFEST.read_text(encoding="utf-8"))["version"]
    return metadata.version("sweep-addon")
