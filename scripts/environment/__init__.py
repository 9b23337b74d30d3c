# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the scripts run in: Pythons, virtual environments, a Blender. Standard library only, Python 3.9 and newer."""

import os
from pathlib import Path

CHECKOUT = Path(__file__).resolve().parents[2]
BUILD = CHECKOUT / "build"
CACHE = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "sweep-addon"


class SetupError(Exception):
    """Something could not be had: one sentence that says why, and the way out."""
