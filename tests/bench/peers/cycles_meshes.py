"""Glint's shapes as meshes for Cycles: fine enough that a finer one gives the same picture, shared by all objects that look alike.

Curved sides are smooth-shaded; a ball is an icosphere of 81 920 triangles (4e-5 of its radius within the true ball), a cylinder
or cone has 512 sides, a torus 512 x 256 quads.
"""

import math

import bmesh
import bpy
from mathutils import Matrix

SIDES = 512
ICOSPHERE_SUBDIVISIONS = 7
TORUS_RING, TORUS_TUBE = 512, 256


class Meshes:
    def __init__(self, scene):
        self.made = {}
        self.reach = max([10.0] + [max(abs(item["transform"]["matrix"][i]) for i in (3, 7, 11))
                                   for item in scene.get("objects", [])])

    def get(self, shape, material):
        """The mesh in the canonical size of local(): with one material, shared."""
        kind = shape["type"]
        ratio = shape["minor_radius"] / shape["major_radius"] if kind == "torus" else 0
        key = (kind, ratio, material.name)
        if key not in self.made:
            mesh = self.build(kind, ratio)
            mesh.materials.append(material)
            self.made[key] = mesh
        return self.made[key]

    @staticmethod
    def local(shape):
        """From the canonical mesh to the shape's own size."""
        kind = shape["type"]
        if kind in ("sphere", "disk"):
            return Matrix.Scale(shape["radius"], 4)
        if kind == "box":
            return Matrix.Diagonal((*(0.5 * s for s in shape["size"]), 1))
        if kind == "quad":
            return Matrix.Diagonal((0.5 * shape["size"][0], 1, 0.5 * shape["size"][1], 1))
        if kind in ("cylinder", "cone"):
            return Matrix.Diagonal((shape["radius"], 0.5 * shape["height"], shape["radius"], 1))
        if kind == "torus":
            return Matrix.Scale(shape["major_radius"], 4)
        return Matrix.Identity(4)

    def build(self, kind, ratio):
        if kind == "sphere":
            return icosphere()
        vertices, faces, smooth = {
            "box": box, "quad": quad, "disk": disk, "plane": lambda: plane(self.reach), "cylinder": cylinder, "cone": cone,
            "torus": lambda: torus(ratio),
        }[kind]()
        mesh = bpy.data.meshes.new(kind)
        mesh.from_pydata(vertices, [], faces)
        mesh.polygons.foreach_set("use_smooth", smooth)
        mesh.validate()
        return mesh


def icosphere():
    form = bmesh.new()
    bmesh.ops.create_icosphere(form, subdivisions=ICOSPHERE_SUBDIVISIONS, radius=1)
    mesh = bpy.data.meshes.new("sphere")
    form.to_mesh(mesh)
    form.free()
    mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
    return mesh


def circle(y, radius=1.0):
    angles = [2 * math.pi * i / SIDES for i in range(SIDES)]
    return [(radius * math.cos(a), y, radius * math.sin(a)) for a in angles]


def flat(vertices, faces):
    return vertices, faces, [False] * len(faces)


def box():
    vertices = [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    return flat(vertices, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def quad():
    return flat([(-1, 0, -1), (-1, 0, 1), (1, 0, 1), (1, 0, -1)], [(0, 1, 2, 3)])


def disk():
    return flat(circle(0), [tuple(reversed(range(SIDES)))])


def plane(reach):
    """Square frames, each four times as wide as the one within: large triangles near the camera would cost Cycles accuracy."""
    vertices, faces = [], [(0, 1, 2, 3)]
    for step in range(9):
        size = 4 * reach * 4**step
        vertices += [(-size, 0, -size), (-size, 0, size), (size, 0, size), (size, 0, -size)]
        if step:
            inner, outer = 4 * (step - 1), 4 * step
            for i in range(4):
                j = (i + 1) % 4
                faces.append((outer + i, outer + j, inner + j, inner + i))
    return flat(vertices, faces)


def cylinder():
    """The caps have their own vertices, so that the rim stays sharp."""
    n = SIDES
    vertices = circle(-1) + circle(1) + circle(-1) + circle(1)
    sides = [(i, n + i, n + (i + 1) % n, (i + 1) % n) for i in range(n)]
    caps = [tuple(range(2 * n, 3 * n)), tuple(reversed(range(3 * n, 4 * n)))]
    return vertices, sides + caps, [True] * n + [False] * 2


def cone():
    """An apex for every side: shared, it would bend the normals around it."""
    n = SIDES
    vertices = circle(-1) + [(0, 1, 0)] * n + circle(-1)
    sides = [(i, n + i, (i + 1) % n) for i in range(n)]
    return vertices, sides + [tuple(range(2 * n, 3 * n))], [True] * n + [False]


def torus(ratio):
    vertices = []
    for i in range(TORUS_RING):
        a = 2 * math.pi * i / TORUS_RING
        for j in range(TORUS_TUBE):
            b = 2 * math.pi * j / TORUS_TUBE
            distance = 1 + ratio * math.cos(b)
            vertices.append((distance * math.cos(a), ratio * math.sin(b), distance * math.sin(a)))
    at = lambda i, j: (i % TORUS_RING) * TORUS_TUBE + j % TORUS_TUBE  # noqa: E731
    faces = [(at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j))
             for i in range(TORUS_RING) for j in range(TORUS_TUBE)]
    return vertices, faces, [True] * len(faces)
