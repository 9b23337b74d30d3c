# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Shapes as objects of a Blender scene, and back."""

from contextvars import ContextVar

import bpy
from mathutils import Matrix

from ..core.contours import Mixed
from ..core.declared.names import titled
from ..core.declared.parameters import ShapeError, at, parameters, require, spelled
from ..core.later import later
from ..core.shapes.kinds import SHAPES, SWEPT
from ..core.shapes.machined_stock import MachinedStock
from ..core.shapes.offset_surface import OffsetSurface
from ..core.shapes.operand import Operand
from ..core.shapes.plant import Plant
from ..core.stations.sampling import rendered
from . import meshes, rna
from .placing import attach
from .recognizing import is_sweep

arcs, beside, curves, models = (later(f"bridge.{name}") for name in ("arcs", "beside", "curves", "models"))
axis_curves, grove, trees = later("bridge.axis_curves"), later("bridge.grove"), later("bridge.trees")

SLOTS = 2  # of materials: of sides and of ends
SHAPE = {spelled(shape, "_").upper(): shape for shape in SHAPES}
GROWN = spelled(Plant, "_").upper()
MILLED = spelled(MachinedStock, "_").upper()
WRITTEN = {GROWN: "system", MILLED: "program"}  # the parameter that is a text, which people may edit
GOES_ON = ContextVar("goes_on", default=False)  # whether a script does, once a mesh is made: it is not to be empty


def new_mesh(shape, name=None, **objects):
    """A mesh of a shape: live where the extension is enabled, else just its faces.

    Parameters
    ----------
    shape : a shape
    name : str, optional
    **objects : bpy.types.Object
        Objects that stand for parameters of the shape, as ``trajectory=curve``.

    Raises
    ------
    ShapeError
        Nothing is left behind.
    """
    require(isinstance(shape, SHAPES), "must be a shape", shape, "shape")
    mesh = bpy.data.meshes.new(name or title(type(shape)))
    try:
        if hasattr(mesh, "sweep"):
            rna.assign(mesh.sweep, shape, **objects)
            if mesh.sweep.error:
                raise ShapeError.read(mesh.sweep.error)
        else:
            require(not objects, "must not be given where the extension is not enabled", list(objects), "objects")
            meshes.write(mesh, shape.mesh(dtype="f4"))
    except ShapeError:
        bpy.data.meshes.remove(mesh)
        raise
    for _ in range(len(mesh.materials), SLOTS):
        mesh.materials.append(None)
    return mesh


def to_object(shape, name=None, **objects):
    """A shape as a live object of the scene; a tree as one with Boolean modifiers.

    Parameters
    ----------
    shape : a shape, a solid or a tree
    name : str, optional
        Of the object and its mesh; by default the shape's.
    **objects : bpy.types.Object
        Stand for parameters of a shape, as ``trajectory=curve``, which it follows from then on.

    Returns
    -------
    bpy.types.Object
        Linked to the scene's collection. Its parameters are ``object.data.sweep``; the operands of a tree are its
        children, in a collection of their own.

    Raises
    ------
    ShapeError
        Where the shape cannot be made; the scene is as it was.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> tube = sw.to_object(sw.GeneralizedCylinder(trajectory=sw.trajectories.Line()), "tube")
    >>> tube.data.sweep.generalized_cylinder.contour_circle_points = 8
    >>> len(tube.data.vertices)
    16

    A pipe along a curve of the scene, which follows what becomes of that:

    >>> import bpy
    >>> curve = bpy.data.curves.new("rail", "CURVE")
    >>> curve.splines.new("POLY").points.add(1)
    >>> curve.splines[0].points[1].co = (0, 0, 2, 1)
    >>> rail = bpy.data.objects.new("rail", curve)
    >>> bpy.context.scene.collection.objects.link(rail)
    >>> pipe = sw.to_object(sw.GeneralizedCylinder(sw.contours.Circle(0.05)), "pipe", trajectory=rail)
    >>> pipe.parent == rail, len(pipe.data.vertices)
    (True, 128)
    """
    require(name is None or isinstance(name, str), "must be text", name, "name")
    require_standing(type(shape), objects)
    if isinstance(shape, Operand) and not isinstance(shape, SHAPES):
        return grove.to_object(shape, name)
    token = GOES_ON.set(True)
    try:
        mesh = new_mesh(shape, name, **objects)
    finally:
        GOES_ON.reset(token)
    ob = bpy.data.objects.new(mesh.name, mesh)
    bpy.context.scene.collection.objects.link(ob)
    if carrier(type(shape)) in objects:
        attach(ob, objects[carrier(type(shape))])
    if has_poly_lines(mesh):
        axis_curves.show(ob)
    return ob


def require_standing(shape, objects):
    """Refuse objects for which a class of shapes has no place."""
    places = [p.name for p in parameters(shape) if p.accepts] if shape in SHAPES else []
    for key, ob in objects.items():
        require(key in places, f"must be one of {', '.join(places)}" if places else "must not be given", key, "object")
        require(isinstance(ob, bpy.types.Object), "must be an object of the scene", ob, key)


def from_object(ob):
    """The shape that an object shows, with its input objects read into it; of one with Boolean modifiers the tree.

    Parameters
    ----------
    ob : bpy.types.Object
        One that ``to_object`` or the sidebar made, or any mesh with Boolean modifiers.

    Returns
    -------
    A shape; of a trajectory of several splines, that along the first. Or a `Tree`, in the space of the object; or a
    `SweptSolid`, where a sweep or a tree moves.

    Raises
    ------
    ShapeError
        Where the object is no sweep and no tree, or its parameters are refused.

    Examples
    --------
    >>> import sweep_addon as sw
    >>> shape = sw.GeneralizedCylinder(contour=sw.contours.Circle(0.3))
    >>> sw.from_object(sw.to_object(shape)) == shape
    True
    """
    known = isinstance(ob, bpy.types.Object)
    require(known and is_made(ob), "must be a sweep", ob.name if known else ob, "object")
    return values(ob)[0]


def values(ob):
    """What an object shows: its tree, or its shapes."""
    if trees.is_tree(ob) or trees.generator_of(ob):
        return [trees.read(ob)]
    return shapes(ob.data)


def is_made(ob):
    """Whether an object says how its mesh is made: by parameters, or by set operations."""
    return is_sweep(ob) or ob is not None and ob.type == "MESH" and trees.is_tree(ob)


def is_swept(ob):
    """Whether an object's mesh is made from parameters by sweeping, and no grammar."""
    return is_sweep(ob) and SHAPE[ob.data.sweep.kind] in SWEPT


def is_grown(mesh):
    """Whether a mesh is made of a grammar, whose text may be edited."""
    sweep = getattr(mesh, "sweep", None)  # None where the extension is not enabled
    return sweep is not None and sweep.kind == GROWN


def is_written(mesh):
    """Whether a mesh is made of a text that people may edit: of a grammar, or of a program of a machine."""
    sweep = getattr(mesh, "sweep", None)  # None where the extension is not enabled
    return sweep is not None and sweep.kind in WRITTEN


def text_of(mesh):
    """The group that holds the text a mesh is made of, and its parameter's name."""
    return getattr(mesh.sweep, mesh.sweep.kind.lower()), WRITTEN[mesh.sweep.kind]


def is_united(ob):
    """Whether an object is a plant whose tubes are one solid, or will be as soon as that is made."""
    if not (is_sweep(ob) and is_grown(ob.data)):
        return False
    group = ob.data.sweep.plant
    return group.output == "TUBES" and group.output_tubes_united


def has_poly_lines(mesh):
    """Whether a mesh is made of a grammar as poly-lines that are to be curves."""
    return is_grown(mesh) and mesh.sweep.plant.output == "CURVES"


def carrier(shape):
    """The name of the parameter in whose object's space the mesh of a shape's class is: the path, if it has one.

    None where nothing stands for objects.
    """
    names = [p.name for p in parameters(shape)]
    return next((name for name in ("trajectory", "contour", "body", "part") if name in names), None)


def suited(shape, given):
    """A shape to begin with for some objects.

    A rotation is about an axis that the contour does not cross; the direction of a PD curve is the path's own tilt.
    """
    if hasattr(shape, "along_curve"):
        return shape.along_curve()
    if not hasattr(shape, "beside"):
        return shape()
    return shape.beside(curves.contour(given["contour"], scaled=False))


def title(shape):
    """The name of a shape's class for people."""
    return titled(shape)


def group_of(mesh):
    """The shape's class, and the property group that holds its parameters."""
    return SHAPE[mesh.sweep.kind], getattr(mesh.sweep, mesh.sweep.kind.lower())


def inputs(mesh):
    """The objects that stand for parameters of a mesh, by the parameter's name."""
    shape, group = group_of(mesh)
    return rna.objects(group, parameters(shape))


def shapes(mesh, depsgraph=None):
    """The shapes that a mesh is made of: one, or one for each spline of its trajectory.

    With a depsgraph, the mesh is an evaluated one and objects are read as they are in it; with that of a render, shapes
    are sampled as renders ask for.
    """
    shape, group = group_of(mesh)
    paths, along = {}, rna.objects(group, parameters(shape)).get("trajectory")

    def resolve(ob, p, number=0):
        with at(p.name):
            if ob.type == "MESH":
                models.require_apart(mesh, ob)
                return models.triangles(ob, depsgraph, p.name != carrier(shape))
            if "FONT" in p.accepts:
                rounded = arcs.outline if shape is OffsetSurface else curves.outline
                return (curves.contour if Mixed in p.kinds else rounded)(ob, depsgraph, p.name != carrier(shape))
            if p.name != "trajectory":
                known = paths["trajectory"][number] if along else None
                return beside.value(ob, p, along, known, number, depsgraph)
            if p.name not in paths:
                paths[p.name] = curves.trajectories(ob, depsgraph)
        return paths[p.name][number]

    first = rna.read(group, shape, resolve)
    count = max(map(len, paths.values()), default=1)
    others = (rna.read(group, shape, lambda ob, p, i=i: resolve(ob, p, i)) for i in range(1, count))
    found = [first, *others]
    return [rendered(each) for each in found] if depsgraph and depsgraph.mode == "RENDER" else found


def renders_otherwise(mesh):
    """Whether a render makes a mesh in its own way: samples it otherwise, or does not wait for its solid."""
    if mesh.sweep.solid:
        return True
    _, group = group_of(mesh)
    samples = getattr(group, "samples", "")
    return bool(getattr(group, f"samples_{samples.lower()}_render", 0))


def is_editable_sweep(ob):
    """Whether an object is a sweep whose parameters may be changed."""
    return is_sweep(ob) and ob.data.is_editable


def forget(mesh):
    """Keep a mesh and forget what it was made from."""
    parameters_of_shape = mesh.sweep.kind.lower()  # they use the input objects, which could not be deleted for good
    mesh.sweep.kind = "NONE"
    kept = ("made", "topology", "texture", "mark", "rings", "error", "told", "places", "looked_at", "solid", "edited")
    for name in (parameters_of_shape, *kept):
        mesh.sweep.property_unset(name)


def use(ob, parameter, curve):
    """Let a curve object stand for a parameter of a sweep; one in whose space the sweep is stands where that stood."""
    shape, group = group_of(ob.data)
    setattr(group, f"{parameter}_object", curve)
    setattr(group, parameter, "OBJECT")
    if parameter == carrier(shape):
        curve.parent, curve.matrix_local = ob.parent, ob.matrix_local.copy()
        ob.parent = curve
        ob.matrix_basis.identity()
    elif parameter == "direction":
        curve.parent = group.trajectory_object  # in whose space it was made
    else:
        place, turn, _ = ob.matrix_world.decompose()  # an outline is scaled as its object is, but not as the sweep is
        curve.matrix_world = Matrix.LocRotScale(place, turn, None)
        curve.location.x += 2 * max(ob.dimensions) or 1.0
