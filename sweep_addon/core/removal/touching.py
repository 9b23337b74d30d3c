# SPDX-FileCopyrightText: 2026 Sweep contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether bodies touch, and how far apart they are: the one place that asks python-fcl.

Its ``continuousCollide`` is not asked: it misses walls that are crossed in one step, and spoils the objects that it is
given. A body wholly inside another touches nothing for it, so that is asked of `Body.depths`.
"""

import numpy as np

from ..declared.parameters import ShapeError

MISSING = "needs the library python-fcl, which is missing here: pip install python-fcl"
UNITS = 2.0**20  # of fcl are a metre, some micrometres each: see `hull_tree`
FEW = 3  # bodies are asked one by one, in less time than it takes to call back from a tree of them


def library():
    """The module fcl, or a refusal that says how to get it."""
    try:
        import fcl
    except ImportError as error:
        raise ShapeError(f"A removal path {MISSING}") from error
    return fcl


def hull_tree(vertices, triangles):
    """Triangles in the form of fcl: places (n, 3) in metres, and the vertices of each (t, 3).

    Triangles of less than 1.6e-8 square units are lines for fcl: it says that they are farther than they are, or 0. In
    metres that would be all of less than a fifth of a millimetre, so they are told in smaller units: by a power of two,
    which rounds nothing.
    """
    model = library().BVHModel()
    model.beginModel(len(vertices), len(triangles))
    model.addSubModel(np.ascontiguousarray(UNITS * vertices, np.float64), np.ascontiguousarray(triangles, np.int32))
    model.endModel()
    return model


class Surroundings:
    """Surfaces that stand still, of which it is asked how near others are.

    Parameters
    ----------
    bodies : list of Body
    """

    def __init__(self, bodies):
        self.fcl, self.bodies = library(), list(bodies)
        self.standing = [self.fcl.CollisionObject(body.model) for body in self.bodies]
        self.manager = self.fcl.DynamicAABBTreeCollisionManager()
        self.manager.registerObjects(self.standing)
        self.manager.setup()

    def touched(self, moving):
        """Whether something moving, an ``fcl.CollisionObject``, has a point in common with any of the surfaces."""
        if len(self.standing) <= FEW:
            asked, result = self.fcl.CollisionRequest(), self.fcl.CollisionResult()
            return any(self.fcl.collide(standing, moving, asked, result) for standing in self.standing)
        data = self.fcl.CollisionData()
        self.manager.collide(moving, data, self.fcl.defaultCollisionCallback)
        return data.result.is_collision

    def clearance(self, moving):
        """How far something moving is from the nearest surface: in metres, 0 where they meet."""
        data = self.fcl.DistanceData()
        self.manager.distance(moving, data, self.fcl.defaultDistanceCallback)
        return max(float(data.result.min_distance), 0.0) / UNITS

    def touching(self, moving):
        """The numbers of the bodies whose surfaces something moving has a point in common with."""
        found = set()
        for number, standing in enumerate(self.standing):
            result = self.fcl.CollisionResult()
            if self.fcl.collide(standing, moving, self.fcl.CollisionRequest(), result):
                found.add(number)
        return found


class Moving:
    """A surface that is asked for in many poses.

    Parameters
    ----------
    vertices : (n, 3) float array
    triangles : (t, 3) int array
    """

    def __init__(self, vertices, triangles):
        self.fcl, self.vertices, self.triangles = library(), vertices, triangles
        self.object = self.fcl.CollisionObject(hull_tree(vertices, triangles))

    def at(self, pose):
        """The same in a `Pose`."""
        self.object.setTransform(self.fcl.Transform(pose.matrix, UNITS * pose.origin))
        return self.object
