"""Surfaces for the tests of meshes, made by code."""
import math

import numpy as np

import yade.superquadric as sq


def revolved(profile, sides, name='bin'):
    """The surface of revolution of a `profile` of points (r, z) from axis to axis, or from axis to rim, as `sides` flat strips; it faces outward
    for profiles that go from the bottom up."""
    points, rings = [], []
    for r, z in profile:
        count = sides if r > 0 else 1
        rings.append([len(points) + i for i in range(count)])
        points += [(r * math.cos(2 * math.pi * i / sides), r * math.sin(2 * math.pi * i / sides), z) for i in range(count)]
    triangles = []
    for below, above in zip(rings, rings[1:]):
        for i in range(sides):
            a, b, c, d = below[i % len(below)], below[(i + 1) % sides % len(below)], above[i % len(above)], above[(i + 1) % sides % len(above)]
            triangles += ([(a, b, d)] if a != b else []) + ([(a, d, c)] if c != d else [])
    return sq.TriangleMesh(np.array(points), np.array(triangles), name)


def cube(size=1.0):
    """The cube [0, size]^3, facing outward."""
    corners = [[size * (i >> axis & 1) for axis in range(3)] for i in range(8)]
    return sq.TriangleMesh(corners, sq.regions.BOX_TRIANGLES, 'cube')
