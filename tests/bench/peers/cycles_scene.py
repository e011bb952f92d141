"""Builds one Glint scene in Blender and renders it with Cycles on request.

Run by glint-bench: blender -b --factory-startup --debug-cycles --python cycles_scene.py -- SCENE.json THREADS fast|exact
SCENE.json is a scene with every default written, every transform a matrix, no groups and absolute paths (peer_scene.h).
Requests are JSON lines on standard input, {"spp": 64, "seed": 1, "output": "picture.exr"}; each is answered on standard
output by a line "GLINT {...}" with times in seconds. Start reading at main(). Materials are in cycles_materials.py, meshes in
cycles_meshes.py.

Glint's y axis points up, Blender's z axis: (x, y, z) becomes (x, -z, y).
"""

import json
import math
import os
import sys
import time

import bpy
from mathutils import Matrix, Vector

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import cycles_materials  # noqa: E402
import cycles_meshes  # noqa: E402

Z_UP = Matrix(((1, 0, 0, 0), (0, 0, -1, 0), (0, 1, 0, 0), (0, 0, 0, 1)))
POINT_MODIFIER = "Ball"


def vector(xyz):
    return Z_UP @ Vector(xyz)


def matrix_of(item):
    m = item["transform"]["matrix"]
    return Z_UP @ Matrix((m[0:4], m[4:8], m[8:12], (0, 0, 0, 1)))


def look_along(position, axis, up):
    """Blender's cameras and lamps look along their own -z."""
    z = -axis.normalized()
    x = up.cross(z).normalized()
    y = z.cross(x)
    rotation = Matrix((x, y, z)).transposed()
    return Matrix.Translation(position) @ rotation.to_4x4()


def any_up(axis):
    return Vector((0, 0, 1)) if abs(axis.normalized().z) < 0.9 else Vector((1, 0, 0))


def link(name, data, matrix):
    thing = bpy.data.objects.new(name, data)
    thing.matrix_world = matrix
    bpy.context.collection.objects.link(thing)
    return thing


# --- Objects -------------------------------------------------------------------------------------------------------------


def is_black(color):
    return max(color) == 0


def uniform_scale(matrix):
    """The one factor of a matrix that scales all axes alike; else None."""
    lengths = [column.length for column in matrix.to_3x3().transposed()]
    return lengths[0] if max(lengths) - min(lengths) < 1e-9 * max(lengths) else None


def has_right_angles(matrix):
    x, y, z = matrix.to_3x3().transposed()
    return all(abs(a.dot(b)) < 1e-9 * a.length * b.length for a, b in ((x, y), (y, z), (z, x)))


class Objects:
    """Adds each object in the way that Cycles renders best: see add()."""

    def __init__(self, scene, exact):
        self.exact = exact
        self.materials = cycles_materials.Materials(scene, exact)
        self.meshes = cycles_meshes.Meshes(scene)
        self.opaque = self.materials.opaque

    def add(self, item):
        """Opaque balls become points, which Cycles renders as true spheres. Emissive balls, quads and disks become lamps, which
        it samples by solid angle (emissive meshes it samples by area), with a body that only the camera sees glow, as lamps
        are invisible to it. All else becomes a mesh, and with `exact` all that emits."""
        matrix = matrix_of(item)
        emission = item["emission"]
        if is_black(emission):
            if item["shape"]["type"] == "sphere" and uniform_scale(matrix) and self.opaque(item.get("material")):
                self.add_point(item, matrix)
            else:
                link(item["name"], self.mesh(item, emission), matrix @ self.meshes.local(item["shape"]))
        elif not self.exact and not item.get("material") and self.add_lamp(item, matrix):
            self.add_lamp_body(item, matrix)
        else:
            link(item["name"], self.mesh(item, emission), matrix @ self.meshes.local(item["shape"]))

    def mesh(self, item, emission, camera_only=False):
        material = self.materials.get(item.get("material"), emission, item["two_sided"], camera_only)
        return self.meshes.get(item["shape"], material)

    def add_point(self, item, matrix):
        """A mesh of one vertex that geometry nodes turn into a point with a radius."""
        material = self.materials.get(item["material"], (0, 0, 0), False)
        radius = item["shape"]["radius"] * uniform_scale(matrix)
        mesh = bpy.data.meshes.new(item["name"])
        mesh.from_pydata([(0, 0, 0)], [], [])
        ball = link(item["name"], mesh, Matrix.Translation(matrix.to_translation()))
        ball.modifiers.new(POINT_MODIFIER, "NODES").node_group = point_nodes(radius, material)

    def add_lamp(self, item, matrix):
        """True if a lamp of Cycles has exactly this shape."""
        shape, emission = item["shape"], item["emission"]
        kind = shape["type"]
        strength = max(emission)
        if kind == "sphere" and uniform_scale(matrix):
            lamp = bpy.data.lights.new(item["name"], "POINT")
            lamp.shadow_soft_size = shape["radius"] * uniform_scale(matrix)
            lamp.energy = strength * 4 * math.pi**2 * lamp.shadow_soft_size**2
            places = [Matrix.Translation(matrix.to_translation())]
        elif kind in ("quad", "disk") and has_right_angles(matrix):
            x, y, z = (column.length for column in matrix.to_3x3().transposed())
            width, depth = shape["size"] if kind == "quad" else [2 * shape["radius"]] * 2
            lamp = bpy.data.lights.new(item["name"], "AREA")
            lamp.shape = "RECTANGLE" if kind == "quad" else "ELLIPSE"
            lamp.size, lamp.size_y = width * x, depth * z
            area = lamp.size * lamp.size_y * (1 if kind == "quad" else math.pi / 4)
            lamp.energy = strength * 4 * area  # Blender's watts of area lamps are not those of a Lambertian emitter.
            axis = matrix.to_3x3() @ Vector((0, 1, 0))
            places = [look_along(matrix.to_translation(), way, matrix.to_3x3() @ Vector((0, 0, 1)))
                      for way in ([axis, -axis] if item["two_sided"] else [axis])]
        else:
            return False
        finish_lamp(lamp, emission)
        for place in places:
            link(item["name"], lamp, place)
        return True

    def add_lamp_body(self, item, matrix):
        """What the camera sees of a lamp. Behind a lamp that shines to one side it is black and blocks what comes from there."""
        shape = item["shape"]
        place = matrix @ self.meshes.local(shape)
        blocks = shape["type"] != "sphere" and not item["two_sided"]
        if blocks:
            axis = (matrix.to_3x3() @ Vector((0, 1, 0))).normalized()
            place = Matrix.Translation(-1e-4 * place.to_3x3().transposed()[0].length * axis) @ place
        body = link(item["name"] + " body", self.mesh(item, item["emission"], camera_only=True), place)
        if not blocks:
            body.visible_diffuse = body.visible_glossy = body.visible_transmission = body.visible_shadow = False
        if shape["type"] == "sphere":
            cycles_materials.note("ball lamps are disks that face what they light, and block no other light")


def point_nodes(radius, material):
    tree = bpy.data.node_groups.new(POINT_MODIFIER, "GeometryNodeTree")
    tree.inputs.new("NodeSocketGeometry", "Geometry")
    tree.outputs.new("NodeSocketGeometry", "Geometry")
    source, sink = tree.nodes.new("NodeGroupInput"), tree.nodes.new("NodeGroupOutput")
    points, paint = tree.nodes.new("GeometryNodeMeshToPoints"), tree.nodes.new("GeometryNodeSetMaterial")
    points.inputs["Radius"].default_value = radius
    paint.inputs["Material"].default_value = material
    tree.links.new(source.outputs[0], points.inputs["Mesh"])
    tree.links.new(points.outputs[0], paint.inputs["Geometry"])
    tree.links.new(paint.outputs[0], sink.inputs[0])
    return tree


# --- Lights --------------------------------------------------------------------------------------------------------------


def finish_lamp(lamp, color):
    lamp.color = [c / max(color) for c in color]
    lamp.cycles.use_multiple_importance_sampling = True


def add_light(item):
    kind = item["type"]
    color = item["irradiance" if kind == "sun" else "intensity"]
    if not item.get("visible", True) or is_black(color):
        return
    lamp = bpy.data.lights.new(item["name"], kind.upper())
    if kind == "sun":
        lamp.energy, lamp.angle = max(color), math.radians(item["angle_degrees"])
        axis = vector(item["direction"])
        place = look_along(Vector((0, 0, 0)), axis, any_up(axis))
    else:
        lamp.energy, lamp.shadow_soft_size = 4 * math.pi * max(color), 0
        place = Matrix.Translation(vector(item["position"]))
    if kind == "spot":
        outer = math.radians(item["cone_degrees"]) / 2
        inner = outer * (1 - item["blend"])
        lamp.spot_size = 2 * outer
        lamp.spot_blend = (math.cos(inner) - math.cos(outer)) / (1 - math.cos(outer))
        axis = vector(item["target"]) - vector(item["position"])
        place = look_along(vector(item["position"]), axis, any_up(axis))
    finish_lamp(lamp, color)
    link(item["name"], lamp, place)


def set_environment(environment):
    world = bpy.data.worlds.new("World")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    background = nodes["Background"]
    color = environment.get("color") or ([1, 1, 1] if environment["image"] else [0, 0, 0])
    background.inputs["Color"].default_value = (*color, 1)
    background.inputs["Strength"].default_value = environment["intensity"]
    world.cycles_visibility.camera = environment["visible_to_camera"]
    if is_black(color) or environment["intensity"] == 0:
        world.cycles.sampling_method = "NONE"
    if not environment["image"]:
        return
    picture = nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(environment["image"])
    turn = nodes.new("ShaderNodeVectorRotate")
    turn.rotation_type = "Z_AXIS"
    # Blender's pictures begin a quarter turn from Glint's.
    turn.inputs["Angle"].default_value = math.radians(-90 - environment["rotation_degrees"])
    tint = nodes.new("ShaderNodeVectorMath")
    tint.operation = "MULTIPLY"
    tint.inputs[1].default_value = color
    where = nodes.new("ShaderNodeTexCoord")
    links.new(where.outputs["Generated"], turn.inputs["Vector"])
    links.new(turn.outputs[0], picture.inputs["Vector"])
    links.new(picture.outputs["Color"], tint.inputs[0])
    links.new(tint.outputs[0], background.inputs["Color"])


# --- Camera and settings ---------------------------------------------------------------------------------------------------


def set_camera(camera):
    data = bpy.data.cameras.new("Camera")
    data.sensor_fit = "VERTICAL"
    if camera["projection"] == "orthographic":
        data.type, data.ortho_scale = "ORTHO", camera["ortho_height"]
    else:
        data.angle = math.radians(camera["vertical_fov_degrees"])
    position, target = vector(camera["position"]), vector(camera["target"])
    distance = (target - position).length
    data.clip_start, data.clip_end = 1e-4 * distance, 1e6 * distance
    if camera["aperture_radius"] > 0:
        data.dof.use_dof = True
        data.dof.focus_distance = camera.get("focus_distance", distance)
        data.dof.aperture_fstop = data.lens * 1e-3 / (2 * camera["aperture_radius"])
    bpy.context.scene.camera = link("Camera", data, look_along(position, target - position, vector(camera["up"])))


def set_render(film, max_depth, threads):
    """Nothing biased, and no rule that stops early: the same terms for all."""
    scene = bpy.context.scene
    render, cycles = scene.render, scene.cycles
    render.engine, cycles.device = "CYCLES", "CPU"
    render.threads_mode, render.threads = "FIXED", threads
    render.resolution_x, render.resolution_y, render.resolution_percentage = film["width"], film["height"], 100
    render.use_persistent_data = True
    render.image_settings.file_format, render.image_settings.color_mode = "OPEN_EXR", "RGB"
    render.image_settings.color_depth = "32"
    cycles.pixel_filter_type = "BOX"
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_auto_tile = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = cycles.light_sampling_threshold = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    # A path of n interactions has n - 1 bounces.
    bounces = max(0, max_depth - 1)
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
    cycles.volume_bounces, cycles.transparent_max_bounces = 0, max(8, max_depth)


def build(scene, threads, exact):
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    set_render(scene["film"], scene["render"]["max_depth"], threads)
    set_camera(scene["camera"])
    set_environment(scene["environment"])
    objects = Objects(scene, exact)
    for item in scene.get("objects", []):
        objects.add(item)
    for item in scene.get("lights", []):
        add_light(item)


# --- Requests --------------------------------------------------------------------------------------------------------------


def render(request):
    """Wall and processor time of one render with all that belongs to it."""
    scene = bpy.context.scene
    scene.cycles.samples, scene.cycles.seed = request["spp"], request["seed"]
    scene.render.filepath = request["output"]
    wall, processor = time.perf_counter(), time.process_time()
    bpy.ops.render.render(write_still=True)
    return {"wall": time.perf_counter() - wall, "cpu": time.process_time() - processor}


def answer(message):
    print("\nGLINT " + json.dumps(message), flush=True)


def main():
    arguments = sys.argv[sys.argv.index("--") + 1:]
    with open(arguments[0], encoding="utf-8") as file:
        scene = json.load(file)
    started = time.perf_counter()
    build(scene, int(arguments[1]), arguments[2] == "exact")
    answer({"build": time.perf_counter() - started, "notes": sorted(cycles_materials.NOTES)})
    for line in sys.stdin:
        answer(render(json.loads(line)))


main()
