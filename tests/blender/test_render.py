# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What is rendered: a render evaluates on its own and gives nothing back, so that a test of frames alone proves little.

The camera looks straight down on 4 m by 4 m; what a sweep covers in a picture is compared with its area from above.
"""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy", reason="needs Blender, and this host has none")

from scenes import add, curve, extent, parameters_of, places, select, square, straight, sweep, text

import sweep_addon as sw

FRAMES, PIXELS, FIELD = (1, 2, 3), 64, 4.0


@pytest.fixture
def render(scene, tmp_path):
    """A function that renders the frames and tells the area covered in each, in square metres."""
    camera = add("camera", bpy.data.cameras.new("camera"))
    camera.location.z, camera.data.type, camera.data.ortho_scale = 20, "ORTHO", FIELD
    scene.camera = camera
    settings = scene.render
    settings.engine, scene.cycles.samples, settings.film_transparent = "CYCLES", 16, True
    settings.resolution_x = settings.resolution_y = PIXELS
    settings.image_settings.file_format, settings.image_settings.color_mode = "PNG", "RGBA"
    settings.filepath = str(tmp_path / "###")
    scene.frame_start, scene.frame_end = FRAMES[0], FRAMES[-1]

    def covered():
        bpy.ops.render.render(animation=True)
        return [area(tmp_path / f"{frame:03}.png") for frame in FRAMES]

    return covered


def area(path):
    image = bpy.data.images.load(str(path))
    alpha = np.array(image.pixels[:]).reshape(-1, 4)[:, 3]
    return alpha.sum() * (FIELD / PIXELS) ** 2


def key(data, path, values):
    """Keyframes of a property, one value for each frame; the first is the one shown."""
    for frame, value in zip(FRAMES, values, strict=True):
        owner, _, name = path.rpartition(".")
        setattr(data.path_resolve(owner) if owner else data, name, value)
        data.keyframe_insert(path, frame=frame)
    bpy.context.scene.frame_set(FRAMES[0])


def test_keyframed_parameter_is_rendered_and_the_shown_frame_comes_back(scene, render):
    ob = sweep()
    key(ob.data, "sweep.generalized_cylinder.contour_circle_radius", (0.5, 1.0, 1.5))
    assert render() == pytest.approx([np.pi * r * r for r in (0.5, 1.0, 1.5)], rel=0.03)
    assert extent(ob) == pytest.approx((1, 1, 2))


def test_driven_parameter_is_rendered(scene, render):
    ob = sweep()
    driver = ob.data.driver_add("sweep.generalized_cylinder.contour_circle_radius").driver
    driver.type, driver.expression = "SCRIPTED", "frame / 2"
    scene.frame_set(1)
    assert render() == pytest.approx([np.pi * r * r for r in (0.5, 1.0, 1.5)], rel=0.03)
    assert extent(ob) == pytest.approx((1, 1, 2))


def test_animated_contour_object_is_rendered(scene, render):
    profile = square()
    ob = sweep(contour=profile)
    key(profile, "scale", ((1, 1, 1), (2, 1, 1), (2, 3, 1)))
    assert render() == pytest.approx([1, 2, 6], rel=0.03)
    assert extent(ob) == pytest.approx((1, 1, 2))


def test_animated_points_of_the_trajectory_are_rendered(scene, render):
    path = curve("POLY", [(-1.5, 0, 0), (0, 0, 0)])
    ob = sweep(trajectory=path)
    key(path.data, "splines[0].points[1].co", ((-0.5, 0, 0, 1), (0.5, 0, 0, 1), (1.5, 0, 0, 1)))
    assert render() == pytest.approx([1, 2, 3], rel=0.03)
    assert extent(ob) == pytest.approx((1, 1, 1))


def test_animated_hook_of_the_trajectory_is_rendered(scene, render):
    path, handle = curve("POLY", [(-1.5, 0, 0), (-0.5, 0, 0)]), add("handle", None)
    hook = path.modifiers.new("Hook", "HOOK")
    hook.object = handle
    hook.vertex_indices_set([1])
    ob = sweep(trajectory=path)
    key(handle, "location", ((0, 0, 0), (1, 0, 0), (2, 0, 0)))
    assert render() == pytest.approx([1, 2, 3], rel=0.03)
    assert extent(ob) == pytest.approx((1, 1, 1))


def test_animated_text_is_rendered(scene, render):
    letter = text("I")
    ob = sweep(contour=letter)
    key(letter.data, "size", (1.0, 1.5, 2.0))
    narrow, wide, widest = render()
    assert (wide / narrow, widest / narrow) == pytest.approx((1.5**2, 2**2), rel=0.1)
    assert extent(ob)[0] == pytest.approx(letter.dimensions.x, rel=1e-2)


def test_animated_trajectory_object_takes_the_sweep_along(scene, render):
    path = straight()
    sweep(trajectory=path)
    key(path, "location", ((0, 0, 0), (2, 0, 0), (5, 0, 0)))  # in the picture, half out of it, out of it
    whole = np.pi / 4
    assert render() == pytest.approx([whole, whole / 2, 0], abs=0.03)


def test_a_refused_frame_renders_the_last_mesh(scene, render):
    ob = sweep()
    key(ob.data, "sweep.generalized_cylinder.contour_circle_radius", (0.5, 1.0, 0.0))
    assert render() == pytest.approx([np.pi / 4, np.pi, np.pi], rel=0.03)
    assert ob.data.sweep.error == "" and extent(ob) == pytest.approx((1, 1, 2))


def test_a_still_of_another_frame_leaves_the_shown_one(scene, render, tmp_path):
    ob = sweep()
    key(ob.data, "sweep.generalized_cylinder.contour_circle_radius", (0.5, 1.0, 1.5))
    scene.frame_set(2)
    scene.render.filepath = str(tmp_path / "still")
    bpy.ops.render.render(write_still=True)
    assert area(tmp_path / "still.png") == pytest.approx(np.pi, rel=0.03)
    assert parameters_of(ob).contour_circle_radius == 1 and extent(ob) == pytest.approx((2, 2, 2))


def test_the_end_of_a_render_in_a_window_brings_the_shown_frame_back(scene):
    """There, unlike in background, no change of frame follows the last picture."""
    ob = sweep()
    ob.data.keyframe_insert("sweep.generalized_cylinder.contour_circle_radius", frame=1)
    last, shown = sweep(contour=sw.contours.Circle(2.0)), places(ob.data)
    ends = [*bpy.app.handlers.render_complete, *bpy.app.handlers.render_cancel]
    ends = [handler for handler in ends if handler.__module__.startswith("bl_ext.user_default.sweep_addon")]
    assert len(ends) == 2
    for end in ends:
        ob.data.vertices.foreach_set("co", places(last.data).ravel())
        ob.data.sweep.made = last.data.sweep.made
        end(scene)
        assert np.array_equal(places(ob.data), shown)


RING = 2 * np.pi * 1.5 * 0.2  # square metres that a ring of 1.5 m covers from above, its wire 0.2 m thick


def ring(samples, **more):
    """A ring, which with three contours covers much less."""
    return sweep(
        contour=sw.contours.Circle(0.1), trajectory=sw.trajectories.Arc(1.5, 2 * np.pi), samples=samples, **more
    )


@pytest.mark.parametrize(
    "samples", [sw.sampling.Count(3, render=200), sw.sampling.Tolerance(1.0, render=0.001)], ids=["count", "tolerance"]
)
def test_a_render_is_sampled_finer_than_what_is_shown(scene, render, tmp_path, samples):
    """A still and an animation, of a shape that nothing else moves."""
    ob = ring(samples)
    shown = places(ob.data)
    assert len(shown) < 20 * 64
    scene.render.filepath = str(tmp_path / "still")
    bpy.ops.render.render(write_still=True)
    assert area(tmp_path / "still.png") == pytest.approx(RING, rel=0.03)
    assert np.array_equal(places(ob.data), shown) and not ob.data.sweep.edited
    scene.render.filepath = str(tmp_path / "###")
    assert render() == pytest.approx([RING] * 3, rel=0.03)
    bpy.context.view_layer.update()
    assert np.array_equal(places(ob.data), shown) and not ob.data.sweep.edited


def test_a_bake_has_the_sampling_of_renders_and_leaves_what_is_shown(scene):
    ob, seen = ring(sw.sampling.Count(3, render=200)), []
    shown = places(ob.data)
    scene.render.engine, scene.cycles.samples = "CYCLES", 1
    material = bpy.data.materials.new("baked")
    if bpy.app.version < (5, 0):
        material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.active = nodes.new("ShaderNodeTexImage")
    nodes.active.image = bpy.data.images.new("baked", 8, 8)
    ob.data.materials[0] = ob.data.materials[1] = material

    def look(scene, depsgraph):
        if depsgraph.mode == "RENDER":
            seen.append(len(ob.data.vertices))

    bpy.app.handlers.depsgraph_update_post.append(look)
    select(ob)
    assert bpy.ops.object.bake(type="NORMAL") == {"FINISHED"}
    bpy.app.handlers.depsgraph_update_post.remove(look)
    bpy.context.view_layer.update()
    assert seen == [200 * 64] and np.array_equal(places(ob.data), shown)


def test_an_export_may_have_the_sampling_of_renders(scene, tmp_path):
    """As those of Alembic and USD do where nobody says otherwise."""
    ob, counts = ring(sw.sampling.Count(3, render=200)), []
    for mode in ("DAG_EVAL_RENDER", "DAG_EVAL_VIEWPORT"):
        bpy.ops.wm.obj_export(filepath=str(tmp_path / "ring.obj"), export_eval_mode=mode)
        bpy.context.view_layer.update()
        counts.append((tmp_path / "ring.obj").read_text().count("\nv "))
        assert len(ob.data.vertices) == 3 * 64 and not ob.data.sweep.edited
    assert counts == [200 * 64, 3 * 64]


def test_without_a_sampling_of_its_own_a_render_is_as_shown(scene, render):
    coarse = ring(sw.sampling.Count(3))
    assert max(render()) < 0.8 * RING and len(coarse.data.vertices) == 3 * 64


def test_a_finer_render_follows_keyframes_and_curves(scene, render):
    path = curve("BEZIER", [(-1, -1.5, 0, 0, -1.5, 0, 1, -1.5, 0), (1, 1.5, 0, 0, 1.5, 0, -1, 1.5, 0)])
    ob = sweep(contour=sw.contours.Circle(0.1), trajectory=path, samples=sw.sampling.Count(2, render=100))
    key(ob.data, "sweep.generalized_cylinder.contour_circle_radius", (0.1, 0.2, 0.1))
    (length,) = (trajectory.length() for trajectory in [sw.from_object(ob).trajectory])
    assert length > 3.2  # of 3 m
    assert render() == pytest.approx([0.2 * length, 0.4 * length, 0.2 * length], rel=0.03)
    assert len(ob.data.vertices) == 2 * 64 and extent(ob)[2] == pytest.approx(0.2, rel=1e-2)


def test_viewport_sampling_may_be_the_finer_one(scene, render):
    """As Blender's curves allow it; the parameter's own unit decides."""
    ob = ring(sw.sampling.Count(100, render=3))
    assert max(render()) < 0.8 * RING and len(ob.data.vertices) == 100 * 64


@pytest.mark.parametrize(
    ("kind", "value", "refusal"),
    [
        ("COUNT", 1, "samples.render: must be 0 or at least 2, got 1"),
        ("TOLERANCE", 1e-12, "samples.render: must be 0 or at least 1e-09"),
    ],
)
def test_a_sampling_that_no_render_could_have_is_refused(scene, kind, value, refusal):
    ob = sweep()
    parameters_of(ob).samples = kind
    setattr(parameters_of(ob), f"samples_{kind.lower()}_render", value)
    assert refusal in ob.data.sweep.error
