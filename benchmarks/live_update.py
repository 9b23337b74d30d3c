# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""From a property that is set to the mesh that Blender shows, beside other ways to the same tube."""

from dataclasses import replace

import numpy as np
from measuring import medians, short, table, tell, verdict
from peers import Bevel, CurveToMesh, FromPydata, curve, evaluated, ring, trimesh_sweep

from bl_ext.user_default import sweep_addon as sw

SIZES = {(1_000, 32): 60, (10_000, 64): 15}  # contours and points: rounds
NODE, TEXTURED = "Curve to Mesh node, no UVs", "Curve to Mesh node, UVs in true lengths"
TWIST, NEW = "twist, which keeps UVs", "new topology"
RADIUS, PITCH, FORMULA = "radius of the contour", "pitch of the trajectory", "formula of a scale"
BARE, LAID = ", no UVs or attributes", ", with UVs and attributes"
PYDATA, TRIMESH = "`from_pydata`, places and faces known beforehand", "trimesh `sweep_polygon`, not in Blender"
ALONE = "twist, not in Blender: the arrays alone"
INTRODUCTION = """
### Live update

A tube along a helix of 5 turns, from a property that is set to the mesh that Blender shows: milliseconds, and how many
times that of Blender's own node in the same run. The measurements take turns, in an order that is drawn anew for each
of {rounds} rounds; medians. Every value is new. A turn is two changes: the first comes after other work, as when a
value is typed; the second, *dragged*, comes after one of its own kind. The node always makes everything anew. Its usual
set-up with UVs stands beside the bare node, and every change that changes UVs is measured with them, as by default, and
with a tube that has none. What is not in Blender ends with arrays that nobody sees.
"""


def measured(contours, points, rounds):
    """The median milliseconds of every way to change a tube of that size: after other work, and dragged."""
    tube = sw.GeneralizedCylinder(
        contour=sw.contours.Circle(0.1, points=points),
        trajectory=sw.trajectories.Helix(),
        samples=sw.sampling.Count(contours),
    )
    path = tube.trajectory.evaluate(np.linspace(*tube.trajectory.domain, contours))
    node, textured = (CurveToMesh(curve(path), points, texture=texture) for texture in (False, True))
    bevel, written, swept = Bevel(path, points), FromPydata(tube.mesh()), trimesh_sweep()
    actions = {
        TWIST: setter(tube, "twist_constant_value", lambda i: 0.01 * i),
        **changes(tube, contours, 0, LAID),
        **changes(replace(tube, texture="none", attributes=False), contours, 1, BARE),
        NODE: lambda i: node.set_radius(0.1 + 0.001 * i),
        TEXTURED: lambda i: textured.set_radius(0.1 + 0.001 * i),
        "Curve bevel, with UVs by sample number": lambda i: bevel.set_radius(0.1 + 0.001 * i),
        PYDATA: written.write,
        ALONE: lambda i: replace(tube, twist=0.02 + 0.01 * i).mesh(np.float32),
    }
    if swept:
        corners = ring(0.1, points)
        actions[TRIMESH] = lambda i: swept((1 + 0.001 * i) * corners, path)
    same_size = {len(node.mesh().vertices), len(textured.mesh().vertices), len(written.places)}
    assert same_size == {contours * points}, same_size
    return [{TRIMESH: None} | times for times in medians(actions, rounds)]


def changes(tube, contours, number, suffix):
    """What changes texture coordinates too, where there are any; to values that no other number's changes have met."""
    lawful = replace(tube, scale_x="1 + t")
    return {
        RADIUS + suffix: setter(tube, "contour_circle_radius", lambda i: 0.1 + 0.001 * (2 * i + number)),
        PITCH + suffix: setter(tube, "trajectory_helix_pitch", lambda i: 0.5 + 0.001 * (2 * i + number)),
        FORMULA + suffix: setter(lawful, "scale_x_formula_text", lambda i: f"1 + 0.001*{2 * i + number}*t"),
        NEW + suffix: setter(tube, "samples_count_contours", lambda i: contours - 2 * i - number),
    }


def setter(tube, name, value):
    """Sets a property of a live object of its own to a new value in each round, and asks for the mesh."""
    ob = sw.to_object(tube)
    group = ob.data.sweep.generalized_cylinder

    def action(number):
        setattr(group, name, value(number))
        evaluated(ob)

    return action


def rows(results):
    """The rows of the table: for each size and kind of change milliseconds and the ratio to the node."""
    names = [name for name in results[0] if name != TRIMESH]
    for name in [*names, TRIMESH]:
        row = [name]
        for times in results:
            taken = times[name]
            row += ["not installed", ""] if taken is None else [short(taken), short(taken / times[NODE])]
        yield row


def targets(times):
    """What was asked for at the large size."""
    for name in (TWIST, RADIUS + BARE, PITCH + BARE, FORMULA + BARE):
        yield f"- {name}, to the node without UVs: {verdict(times[name] / times[NODE], 1)}"
    for name in (RADIUS + LAID, PITCH + LAID, FORMULA + LAID):
        yield f"- {name}, to the node with UVs: {verdict(times[name] / times[TEXTURED], 1)}"
    yield f"- {NEW + LAID}, to the node without UVs: {verdict(times[NEW + LAID] / times[NODE], 8)}"
    for name in (PYDATA, TRIMESH):
        if times[name] is not None:
            yield f"- {name}, to {TWIST}: {short(times[name] / times[TWIST])}, at least 10 asked: " + (
                "reached" if times[name] >= 10 * times[TWIST] else "missed"
            )
    if times[TRIMESH] is not None:
        yield f"- {TRIMESH}, to {ALONE}: {short(times[TRIMESH] / times[ALONE])}"


def main():
    results, titles = [], [""]
    for (contours, points), rounds in SIZES.items():
        results += measured(contours, points, rounds)
        titles += [f"{contours:,} x {points}, ms", "to the node", "dragged, ms", "to the node"]
    page = [INTRODUCTION.format(rounds=" and ".join(map(str, SIZES.values()))), table(titles, rows(results))]
    for kind, times in zip(("after other work", "dragged"), results[-2:], strict=True):
        page += [f"\nTargets at the large size, {kind}:\n", *targets(times)]
    tell("\n".join(page))


main()
