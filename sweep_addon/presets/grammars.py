# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The presets that are grammars as a page has them: what they are, where they come from, and what can be pulled.

``python -m sweep_addon.presets.grammars`` prints the table of docs/l_system_presets.md.
"""

import re
import sys

from ..core.shapes import growing
from . import GROWN, PRESETS, shape

SOURCE = re.compile(r"# Source: (.*)\.\n")


def rows():
    """The cells of each preset: its title, what it is, its source, its sliders, and how large it becomes.

    >>> next(rows())[0]
    '**Algae**'
    """
    for preset in PRESETS:
        if preset.group == GROWN:
            plant = shape(preset.name)
            sliders = [f"`{name}`" for name, constant in growing.free(plant.system).items() if constant.low is not None]
            modules = len(growing.read(plant.system).derive(plant.generations, plant.seed))
            sizes = f"{plant.generations}: {modules:,} and {len(plant.mesh().vertices):,}"
            yield f"**{preset.title}**", preset.doc, SOURCE.match(plant.system)[1], " ".join(sliders), sizes


def markdown():
    """The rows as a table."""
    head = "| preset | what it is | source | sliders | generations: modules and vertices |\n|---|---|---|---|---|"
    return "\n".join((head, *(f"| {' | '.join(cells)} |" for cells in rows())))


if __name__ == "__main__":
    sys.stdout.write(f"{markdown()}\n")
