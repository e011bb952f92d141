"""Glint's materials as shader nodes for Cycles. What Cycles has no equal of is put in NOTES: there the two pictures may differ,
because the physics does."""

import bpy

NOTES = set()


def note(text):
    NOTES.add(text)


def rgba(color):
    return (*color, 1)


def value_of(field, default):
    """The constant of a field; textures are not drawn by Glint either."""
    return default if isinstance(field, dict) else field


class Graph:
    """Building shader nodes: each method gives back an output socket."""

    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def node(self, kind, inputs=None, **settings):
        made = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(made, name, value)
        for name, value in (inputs or {}).items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, made.inputs[name])
            else:
                made.inputs[name].default_value = value
        return made

    def shader(self, kind, inputs=None, **settings):
        return self.node("ShaderNode" + kind, inputs, **settings).outputs[0]

    def math(self, operation, *operands):
        return self.node("ShaderNodeMath", dict(enumerate(operands)), operation=operation).outputs[0]

    def mix(self, factor, a, b):
        return self.shader("MixShader", {0: factor, 1: a, 2: b})

    def add(self, a, b):
        return b if a is None else self.shader("AddShader", {0: a, 1: b})

    def backfacing(self):
        return self.node("ShaderNodeNewGeometry").outputs["Backfacing"]

    def sheet_fresnel(self, ior):
        """Fresnel reflectance from outside whichever side is seen: the node itself turns the index on the back."""
        back = self.backfacing()
        index = self.math("ADD", self.math("MULTIPLY", back, 1 / ior - ior), ior)
        return self.node("ShaderNodeFresnel", {"IOR": index}).outputs[0]


class Materials:
    def __init__(self, scene, exact):
        """`exact`: rough surfaces keep their energy, as Glint's do, at Cycles' price for it."""
        self.documents = {m["name"]: m for m in scene.get("materials", [])}
        self.microfacets = "MULTI_GGX" if exact else "GGX"
        self.made = {}

    def get(self, name, emission, two_sided, camera_only=False):
        """The Blender material for an object: its document material (none: black) and what it emits."""
        glows = max(emission) > 0
        key = (name, tuple(emission), two_sided, camera_only)
        if key not in self.made:
            self.made[key] = self.build(name, emission if glows else None, two_sided, camera_only)
        return self.made[key]

    def opaque(self, name):
        """No ray goes through: points are only ever hit from outside."""
        if not name:
            return True
        document = self.documents[name]
        kind = document["type"]
        if kind == "mix":
            return all(part != "clear" and self.opaque(part) for part in (document["a"], document["b"]))
        return kind in ("diffuse", "mirror", "metal", "glossy") or (kind == "phong" and document["refraction"] == 0)

    def build(self, name, emission, two_sided, camera_only):
        material = bpy.data.materials.new(name or "Black")
        material.use_nodes = True
        graph = Graph(material.node_tree)
        output = graph.node("ShaderNodeOutputMaterial")
        surface = self.surface(graph, name) if name else None
        if emission:
            surface = graph.add(surface, self.glow(graph, emission, two_sided, camera_only))
            material.cycles.sample_as_light = not camera_only
        if surface is None:
            surface = graph.shader("BsdfDiffuse", {"Color": (0, 0, 0, 1)})
        graph.tree.links.new(surface, output.inputs["Surface"])
        volume = self.volume(graph, name)
        if volume:
            material.cycles.homogeneous_volume = True
            graph.tree.links.new(volume, output.inputs["Volume"])
        return material

    @staticmethod
    def glow(graph, emission, two_sided, camera_only):
        strength = 1.0
        if camera_only:
            strength = graph.node("ShaderNodeLightPath").outputs["Is Camera Ray"]
        if not two_sided:
            strength = graph.math("MULTIPLY", strength, graph.math("SUBTRACT", 1.0, graph.backfacing()))
        return graph.shader("Emission", {"Color": rgba(emission), "Strength": strength})

    def volume(self, graph, name):
        document = self.documents.get(name, {})
        fades = value_of(document.get("absorption"), [0, 0, 0]) or [0, 0, 0]
        inside = document.get("type") == "glass" and not document["thin"]
        inside = inside or (document.get("type") == "phong" and document["refraction"] > 0)
        if not inside or max(fades) == 0:
            return None
        strongest = max(fades)
        color = [1 - f / strongest for f in fades]
        return graph.shader("VolumeAbsorption", {"Color": rgba(color), "Density": strongest})

    def surface(self, graph, name):
        document = self.documents[name]
        return getattr(self, document["type"])(graph, document)

    def distribution(self, m):
        return self.microfacets if m["roughness"] > 0 else "SHARP"

    def note_loss(self, m):
        if m["roughness"] > 0 and self.microfacets == "GGX":
            note("light lost between the microfacets of rough surfaces stays lost")

    def diffuse(self, graph, m):
        return graph.shader("BsdfDiffuse", {"Color": rgba(m["color"])})

    def mirror(self, graph, m):
        return graph.shader("BsdfGlossy", {"Color": rgba(m["color"]), "Roughness": 0.0}, distribution="SHARP")

    def metal(self, graph, m):
        note("metal: its Fresnel curve follows a dielectric's instead of Schlick's")
        self.note_loss(m)
        inputs = {"Base Color": rgba(m["color"]), "Metallic": 1.0, "Roughness": m["roughness"]}
        return graph.shader("BsdfPrincipled", inputs, distribution=self.microfacets)

    def glass(self, graph, m):
        if m["priority"] != 0:
            note("glass: priorities are not known, overlapping glasses show all their boundaries")
        if m["thin"]:
            return self.sheet(graph, m)
        self.note_loss(m)
        return graph.shader("BsdfGlass", {"Color": (1, 1, 1, 1), "Roughness": m["roughness"], "IOR": m["ior"]},
                            distribution=self.distribution(m))

    def sheet(self, graph, m):
        """All inner reflections of a thin sheet: 2F / (1 + F) is reflected, the rest goes straight on."""
        if m["roughness"] > 0:
            note("rough sheets blur reflections only")
        fresnel = graph.sheet_fresnel(m["ior"])
        share = graph.math("DIVIDE", graph.math("MULTIPLY", fresnel, 2.0), graph.math("ADD", fresnel, 1.0))
        reflection = graph.shader("BsdfGlossy", {"Color": (1, 1, 1, 1), "Roughness": m["roughness"]},
                                  distribution=self.distribution(m))
        return graph.mix(share, graph.shader("BsdfTransparent"), reflection)

    def translucent(self, graph, m):
        return graph.add(graph.shader("BsdfDiffuse", {"Color": rgba(m["reflectance"])}),
                         graph.shader("BsdfTranslucent", {"Color": rgba(m["transmittance"])}))

    def glossy(self, graph, m):
        note("glossy: a mix by Fresnel's law, whose base ignores the angle at which light leaves the coat")
        coat = graph.shader("BsdfGlossy", {"Color": (1, 1, 1, 1), "Roughness": m["roughness"]},
                            distribution=self.distribution(m))
        base = graph.shader("BsdfDiffuse", {"Color": rgba(m["color"])})
        return graph.mix(graph.sheet_fresnel(m["ior"]), base, coat)

    def phong(self, graph, m):
        parts = [m["diffuse"], m["specular"], m["reflection"], m["refraction"]]
        kd, ks, kr, kt = (part / max(1.0, sum(parts)) for part in parts)
        tint = m["color"]
        out = None
        if kd > 0:
            out = graph.add(out, graph.shader("BsdfDiffuse", {"Color": rgba([kd * c for c in tint])}))
        if ks > 0:
            note("phong: its highlight becomes a microfacet lobe of the same width")
            alpha = (2 / (m["exponent"] + 2))**0.5 / 2  # Half vectors turn half as far as reflected directions.
            out = graph.add(out, graph.shader("BsdfGlossy", {"Color": (ks, ks, ks, 1), "Roughness": alpha**0.5},
                                              distribution="BECKMANN"))
        if kr > 0:
            out = graph.add(out, graph.shader("BsdfGlossy", {"Color": rgba([kr * c for c in tint]), "Roughness": 0.0},
                                              distribution="SHARP"))
        if kt > 0:
            note("phong: beyond the critical angle its refracted ray ends")
            out = graph.add(out, graph.shader("BsdfRefraction", {"Color": (kt, kt, kt, 1), "Roughness": 0.0, "IOR": m["ior"]},
                                              distribution="SHARP"))
        return out or graph.shader("BsdfDiffuse", {"Color": (0, 0, 0, 1)})

    def mix(self, graph, m):
        parts = [graph.shader("BsdfTransparent") if part == "clear" else self.surface(graph, part) for part in (m["a"], m["b"])]
        return graph.mix(m["amount"], *parts)
