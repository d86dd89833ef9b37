# Burl in Blender: solid materials without unwrapping. The panel "Burl" of the 3D view's side bar has two buttons. *Carve* gives the
# selected meshes one of Burl's materials. *Bake my nodes* turns a material's own procedural nodes into pictures. Either way the program
# `burl` makes an atlas of the mesh and its pictures, and the mesh gets a UV layer "Burl" and a Principled material of them.
# Install: Edit > Preferences > Add-ons > Install, choose this file. docs/guide/blender.md tells more.
import json
import math
import os
import shutil
import subprocess
import tempfile

import bmesh
import bpy
import numpy
from bpy.props import CollectionProperty, EnumProperty, FloatProperty, FloatVectorProperty, IntProperty, StringProperty

bl_info = {
    "name": "Burl",
    "author": "The Burl contributors",
    "version": (1, 0, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Side bar > Burl",
    "description": "Solid materials and procedural nodes baked without unwrapping",
    "doc_url": "",
    "category": "Material",
}

LAYER = "Burl"


class BurlError(Exception):
    """A sentence for the user."""


# ---------------------------------------------------------------- nodes to recipes


class Unsupported(BurlError):
    """Nodes that no recipe can express, each with its path."""

    def __init__(self, problems):
        shown = "; ".join(dict.fromkeys(problems))
        super().__init__(f"These nodes cannot be baked by Burl: {shown}.")


POINT = {"node": "point"}


def numbers(red, green, blue):
    return {"node": "combine", "red": red, "green": green, "blue": blue}


def channel(color, name):
    return {"node": "split", "input": color, "channel": name}


def vector_math(operation, a, b=0, c=0, scale=1.0):
    return {"node": "blender_vector_math", "operation": operation, "a": a, "b": b, "c": c, "scale": scale}


def math_of(operation, a, b=0, c=0):
    return {"node": "blender_math", "operation": operation, "a": a, "b": b, "c": c}


def affine(matrix, at=POINT):
    rows = [float(matrix[row][column]) for row in range(3) for column in range(4)]
    return {"node": "transform", "matrix": rows, "input": at}


def hex_of(color):
    """The nearest sRGB code of a colour in linear light."""
    codes = []
    for x in color[:3]:
        x = min(max(x, 0.0), 1.0)
        x = 12.92 * x if x <= 0.0031308 else 1.055 * x ** (1 / 2.4) - 0.055
        codes.append(round(255 * x))
    return "#%02x%02x%02x" % tuple(codes)


# What Blender 4 calls inputs of the Principled BSDF.
LATER_NAMES = {"Specular": "Specular IOR Level", "Clearcoat": "Coat Weight", "Clearcoat Roughness": "Coat Roughness",
               "Transmission": "Transmission Weight", "Emission": "Emission Color", "Subsurface": "Subsurface Weight",
               "Sheen": "Sheen Weight"}


def input_of(node, name):
    return node.inputs[name if name in node.inputs else LATER_NAMES[name]]


def is_tint(value):
    """Whether a tint does something: Specular Tint was a number since Blender 2.8, and is a colour from 4.0 on."""
    return value > 0 if isinstance(value, (int, float)) else any(x != 1 for x in tuple(value)[:3])


class Translator:
    """The nodes of a material as a recipe for one object. What cannot be translated is collected in `problems`, with its path."""

    def __init__(self, material, thing):
        self.material, self.thing = material, thing
        self.define, self.known, self.problems, self.notes = {}, {}, [], []
        self.uv_layer = None  # the mesh's UV layer that nodes read

    # A value is a pair: the JSON of a node, and what it is: "number", "vector" or "color".

    def wanted(self, value, kind):
        """The JSON of a value where a number, vector or color is wanted."""
        node, own = value
        if kind != "number" or own == "number":
            return node
        if isinstance(node, (int, float)):
            return node
        if own == "color":
            return channel(node, "luminance")
        third = 1 / 3
        return channel(vector_math("dot_product", node, numbers(third, third, third)), "red")

    def fail(self, stack, node, why=""):
        path = " > ".join([group.name for group in stack] + [node.name])
        self.problems.append(f"{path} ({why or node.bl_label})")
        return 0.0, "number"

    def constant(self, socket):
        if socket.type == "RGBA":
            return numbers(*[float(x) for x in socket.default_value[:3]]), "color"
        if socket.type == "VECTOR":
            return numbers(*[float(x) for x in socket.default_value[:3]]), "vector"
        return float(socket.default_value), "number"

    def link_of(self, socket):
        return socket.links[0] if socket.is_linked and socket.links and not socket.links[0].is_muted else None

    def source_of(self, socket):
        """The link that brings an input its value, once it has passed reroutes; None: there is none."""
        link = self.link_of(socket)
        while link and link.is_valid and link.from_node.bl_idname == "NodeReroute":  # a cycle is not valid
            link = self.link_of(link.from_node.inputs[0])
        return link

    def value(self, stack, socket):
        """The value of an input."""
        link = self.link_of(socket)
        if link:
            return self.output(stack, link.from_node, link.from_socket)
        if socket.hide_value and socket.type == "VECTOR":
            return self.generated(), "vector"
        return self.constant(socket)

    def number(self, stack, socket):
        return self.wanted(self.value(stack, socket), "number")

    def triple(self, stack, socket):
        return self.wanted(self.value(stack, socket), "vector")

    def generated(self):
        mesh = self.thing.data
        size = [2 * x if x else 1.0 for x in mesh.texspace_size]
        offset = [0.5 - at / long for at, long in zip(mesh.texspace_location, size)]
        node = {"node": "transform", "scale": [1 / x for x in size], "translate": offset, "input": POINT}
        return self.named("generated", "generated", node)

    def named(self, key, name, node):
        """The name that stands for a node from now on."""
        if not isinstance(node, dict):
            return node
        if key not in self.known:
            base = "".join(c if c.isalnum() else "_" for c in name.lower()).strip("_") or "node"
            unique, count = base, 1
            while unique in self.define:
                count += 1
                unique = f"{base}_{count}"
            self.define[unique] = node
            self.known[key] = unique
        return self.known[key]

    def output(self, stack, node, socket):
        """The value of a node's output; nodes in groups are found by the stack of group nodes that lead to them."""
        key = (tuple(group.as_pointer() for group in stack), node.as_pointer(), socket.identifier)
        if key not in self.known:
            value, kind = self.translate(stack, node, socket)
            self.known[key] = self.named((key, "name"), node.name, value), kind
        return self.known[key]

    def translate(self, stack, node, socket):
        if node.mute:
            for link in node.internal_links:
                if link.to_socket == socket:
                    return self.value(stack, link.from_socket)
            return self.constant(socket)
        if node.bl_idname == "NodeReroute":
            return self.value(stack, node.inputs[0])
        if node.bl_idname == "ShaderNodeGroup":
            return self.group_output(stack, node, socket)
        if node.bl_idname == "NodeGroupInput":
            outer = next(s for s in stack[-1].inputs if s.identifier == socket.identifier)
            return self.value(stack[:-1], outer)
        handler = HANDLERS.get(node.bl_idname)
        return handler(self, stack, node, socket) if handler else self.fail(stack, node)

    def group_output(self, stack, node, socket):
        ends = [n for n in node.node_tree.nodes if n.bl_idname == "NodeGroupOutput" and n.is_active_output] if node.node_tree else []
        if not ends:
            return self.fail(stack, node, "a group without output")
        inner = next(s for s in ends[0].inputs if s.identifier == socket.identifier)
        return self.value(stack + [node], inner)

    # The material.

    def surface(self):
        tree = self.material.node_tree
        if not self.material.use_nodes or tree is None:
            raise BurlError(f"The material \"{self.material.name}\" uses no nodes.")
        out = tree.get_output_node("CYCLES") or tree.get_output_node("ALL")
        link = self.source_of(out.inputs["Surface"]) if out else None
        if not link:
            raise BurlError(f"The material \"{self.material.name}\" has no surface.")
        displacement = self.link_of(out.inputs["Displacement"])
        if displacement:
            self.fail([], displacement.from_node, "displacement")
        if self.link_of(out.inputs["Volume"]):
            self.notes.append("Volume is left out")
        if link.from_node.mute:
            self.fail([], link.from_node, f"a muted {link.from_node.bl_label}")
        return [], link.from_node

    def recipe(self, size):
        stack, node = self.surface()
        material, bump = {}, {}
        if node.bl_idname == "ShaderNodeBsdfPrincipled":
            bump = self.principled(stack, node, material)
        elif node.bl_idname == "ShaderNodeBsdfDiffuse":
            material["base_color"] = self.base(self.value(stack, node.inputs["Color"]))
            material["roughness"] = 1.0
            self.leave_out(node, ("Roughness",))
            bump = self.bump(stack, node, node.inputs["Normal"])
        elif node.bl_idname == "ShaderNodeEmission":
            material["base_color"] = {"node": "constant", "value": "#000000"}
            self.emission(stack, node.inputs["Color"], node.inputs["Strength"], material)
        else:
            self.fail(stack, node)
        if self.problems:
            raise Unsupported(self.problems)
        recipe = {"burl": 1, "name": self.material.name, "atlas": {"size": size}, "solid": {"space": "object"}}
        if self.define:
            recipe["define"] = self.define
        recipe["material"] = material
        if bump:
            recipe["bump"] = bump
        return recipe

    def base(self, value):
        node, kind = value
        return node if isinstance(node, (dict, str)) else numbers(node, node, node)

    def principled(self, stack, node, material):
        material["base_color"] = self.base(self.value(stack, node.inputs["Base Color"]))
        limited = (("Metallic", "metallic"), ("Roughness", "roughness"), ("Clearcoat", "clearcoat"), ("Transmission", "transmission"),
                   ("Clearcoat Roughness", "clearcoat_roughness"), ("Alpha", "opacity"))
        for name, ours in limited:
            value = self.number(stack, input_of(node, name))
            if isinstance(value, (int, float)):
                value = min(max(value, 0.0), 1.0)
            if not (ours == "opacity" and value == 1.0):
                material[ours] = value
        specular = self.number(stack, input_of(node, "Specular"))
        if isinstance(specular, (int, float)):
            if specular > 0.5:
                self.notes.append("Specular above 0.5 counts as 0.5")
            material["specular"] = min(2 * specular, 1.0)
        else:
            material["specular"] = math_of("multiply", specular, 2.0)
        if not self.link_of(node.inputs["IOR"]):
            material["ior"] = max(float(node.inputs["IOR"].default_value), 1.0)
        self.emission(stack, input_of(node, "Emission"), node.inputs["Emission Strength"], material)
        self.leave_out(node, ("Subsurface", "Anisotropic", "Sheen"))
        if material["transmission"] and "Transmission Roughness" in node.inputs:
            self.leave_out(node, ("Transmission Roughness",))
        for name in ("Clearcoat Normal", "Coat Normal", "Tangent", "Specular Tint", "Coat Tint", "IOR"):
            if name in node.inputs and (self.link_of(node.inputs[name]) or name.endswith(" Tint") and is_tint(node.inputs[name].default_value)):
                self.notes.append(f"{name} is left out")
        for name, usual in (("Coat IOR", 1.5), ("Thin Film Thickness", 0.0), ("Diffuse Roughness", 0.0)):  # of Blender 4
            if name in node.inputs and (self.link_of(node.inputs[name]) or node.inputs[name].default_value != usual):
                self.notes.append(f"{name} is left out")
        return self.bump(stack, node, node.inputs["Normal"])

    def leave_out(self, node, names):
        """Notes those of the inputs that are linked or not 0, which no picture says."""
        for name in names:
            if self.link_of(input_of(node, name)) or input_of(node, name).default_value:
                self.notes.append(f"{name} is left out")

    def emission(self, stack, color, strength, material):
        linked = self.link_of(color) or self.link_of(strength)
        if not linked and (not any(color.default_value[:3]) or not strength.default_value):
            return
        light = self.base(self.value(stack, color))
        if self.link_of(strength):
            light = {"node": "scale", "a": light, "b": self.number(stack, strength)}
        else:
            material["emissive_strength"] = float(strength.default_value)
        material["emissive"] = light

    def bump(self, stack, node, socket):
        link = self.source_of(socket)
        if not link:
            return {}
        source = link.from_node
        if source.mute:  # what goes into its Normal goes through
            through = [inner.from_socket for inner in source.internal_links if inner.to_socket == link.from_socket]
            if through and through[0].name == "Normal":
                return self.bump(stack, node, through[0])
        if source.mute or source.bl_idname != "ShaderNodeBump":
            self.fail(stack, source, f"{source.bl_label} at {node.name}'s Normal")
            return {}
        if self.link_of(source.inputs["Normal"]) or self.link_of(source.inputs["Strength"]) or self.link_of(source.inputs["Distance"]):
            self.fail(stack, source, "a Bump whose Strength, Distance or Normal is linked")
            return {}
        height = source.inputs["Strength"].default_value * source.inputs["Distance"].default_value
        return {"height": -height if source.invert else height, "input": self.number(stack, source.inputs["Height"])}


def texture_coordinates(t, stack, node, socket):
    if socket.name == "Generated":
        return t.generated(), "vector"
    if socket.name == "Object":
        if node.object is None:
            return POINT, "vector"
        return affine(node.object.matrix_world.inverted_safe() @ t.thing.matrix_world), "vector"
    if socket.name == "UV":
        return uv_of(t, stack, node, "")
    return t.fail(stack, node, f"Texture Coordinate {socket.name}")


def uv_map(t, stack, node, socket):
    return uv_of(t, stack, node, node.uv_map)


def uv_of(t, stack, node, name):
    """The mesh's own texture coordinates, whose rows the OBJ file counts from the bottom and a recipe from the top."""
    layers = t.thing.data.uv_layers
    name = name or next((layer.name for layer in layers if layer.active_render), "")
    if name not in layers:
        return t.fail(stack, node, f"a UV layer \"{name}\" that the mesh does not have")
    if t.uv_layer not in (None, name):
        return t.fail(stack, node, "a second UV layer")
    t.uv_layer = name
    upright = {"node": "transform", "scale": [1, -1, 1], "translate": [0, 1, 0], "input": POINT}
    return {"node": "mesh_uv", "input": upright}, "vector"


def geometry(t, stack, node, socket):
    if socket.name == "Position":
        return affine(t.thing.matrix_world), "vector"
    return t.fail(stack, node, f"Geometry {socket.name}")


def mapping(t, stack, node, socket):
    scale, turn, move = node.inputs["Scale"], node.inputs["Rotation"], node.inputs["Location"]
    at = t.triple(stack, node.inputs["Vector"])
    if t.link_of(turn):
        return t.fail(stack, node, "Mapping with a linked Rotation")
    kind = node.vector_type
    rotation = turn.default_value.to_matrix().to_4x4()
    factor, offset = t.triple(stack, scale), t.triple(stack, move)
    if kind == "TEXTURE":
        inner = vector_math("subtract", at, offset)
        return vector_math("divide", rotated(rotation.transposed(), inner), factor), "vector"
    if kind == "NORMAL":
        return vector_math("normalize", rotated(rotation, vector_math("divide", at, factor))), "vector"
    scaled = rotated(rotation, vector_math("multiply", at, factor))
    return (scaled if kind == "VECTOR" else vector_math("add", scaled, offset)), "vector"


def rotated(matrix, node):
    rows = [tuple(float(x) for x in matrix[row][:3]) for row in range(3)]
    if rows == [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]:
        return node
    parts = [channel(vector_math("dot_product", node, numbers(*row)), "red") for row in rows]
    return numbers(*parts)


def texture(t, stack, node, ours, inputs):
    """A node of a texture, whose inputs have the names in `inputs`; a vector that is not linked is the generated one."""
    if getattr(node, "texture_mapping", None) and mapped_itself(node.texture_mapping):
        t.fail(stack, node, "a texture with a mapping of its own")
    ours["vector"] = t.triple(stack, node.inputs["Vector"]) if t.link_of(node.inputs["Vector"]) else t.generated()
    for name, key in inputs:
        ours[key] = t.number(stack, node.inputs[name])
    return ours


def mapped_itself(own):
    return any(own.translation) or any(own.rotation) or tuple(own.scale) != (1.0, 1.0, 1.0)


def only_3d(t, stack, node):
    """The failure of a texture in other than three dimensions, or with settings that Blender 3.4 does not have; None: there is none."""
    later = {"Lacunarity": 2.0} if hasattr(node, "noise_type") else {"Detail": 0.0} if hasattr(node, "voronoi_dimensions") else {}
    changed = any(name in node.inputs and (node.inputs[name].is_linked or node.inputs[name].default_value != usual)
                  for name, usual in later.items())
    if changed or getattr(node, "noise_type", "FBM") != "FBM" or getattr(node, "normalize", None) is hasattr(node, "voronoi_dimensions"):
        return t.fail(stack, node, f"{node.bl_label} with settings of Blender 4")
    dimensions = getattr(node, "noise_dimensions", None) or getattr(node, "musgrave_dimensions", None) or node.voronoi_dimensions
    return None if dimensions == "3D" else t.fail(stack, node, f"{node.bl_label} in {dimensions}")


def noise(t, stack, node, socket):
    color = socket.name == "Color"
    ours = {"node": "blender_noise_color" if color else "blender_noise"}
    names = (("Scale", "scale"), ("Detail", "detail"), ("Roughness", "roughness"), ("Distortion", "distortion"))
    return only_3d(t, stack, node) or (texture(t, stack, node, ours, names), "color" if color else "number")


def musgrave(t, stack, node, socket):
    ours = {"node": "blender_musgrave", "kind": node.musgrave_type.lower().replace("_multifractal", "")}
    names = [(n, n.lower()) for n in ("Scale", "Detail", "Dimension", "Lacunarity", "Offset", "Gain")]
    return only_3d(t, stack, node) or (texture(t, stack, node, ours, names), "number")


def voronoi(t, stack, node, socket):
    ours = {"node": "blender_voronoi", "feature": node.feature.lower(), "metric": node.distance.lower()}
    if socket.name in ("Color", "Position"):
        ours |= {"node": "blender_voronoi_color", "gives": socket.name.lower()}
    names = [(n, n.lower()) for n in ("Scale", "Smoothness", "Exponent", "Randomness")]
    kind = {"Color": "color", "Position": "vector"}.get(socket.name, "number")
    return only_3d(t, stack, node) or (texture(t, stack, node, ours, names), kind)


def grey_or_color(node, socket, value):
    return (value, "color") if socket.name == "Color" else (value, "number")


def wave(t, stack, node, socket):
    direction = node.bands_direction if node.wave_type == "BANDS" else node.rings_direction
    ours = {"node": "blender_wave", "kind": node.wave_type.lower(),
            "direction": direction.lower() if direction in "XYZ" else "all",
            "profile": {"SIN": "sine", "SAW": "saw", "TRI": "triangle"}[node.wave_profile]}
    names = (("Scale", "scale"), ("Distortion", "distortion"), ("Detail", "detail"), ("Detail Scale", "detail_scale"),
             ("Detail Roughness", "detail_roughness"), ("Phase Offset", "phase"))
    return grey_or_color(node, socket, texture(t, stack, node, ours, names))


def magic(t, stack, node, socket):
    ours = {"node": "blender_magic", "depth": node.turbulence_depth}
    value = texture(t, stack, node, ours, (("Scale", "scale"), ("Distortion", "distortion")))
    return (value, "color") if socket.name == "Color" else (t.wanted((value, "vector"), "number"), "number")


def gradient(t, stack, node, socket):
    kind = {"QUADRATIC_SPHERE": "quadratic_sphere"}.get(node.gradient_type, node.gradient_type.lower())
    return grey_or_color(node, socket, texture(t, stack, node, {"node": "blender_gradient", "kind": kind}, ()))


def brick(t, stack, node, socket):
    names = (("Scale", "scale"), ("Mortar Size", "mortar"), ("Mortar Smooth", "smooth"), ("Bias", "bias"), ("Brick Width", "width"),
             ("Row Height", "height"))
    ours = {"node": "blender_brick", "gives": "mortar", "offset": node.offset, "offset_frequency": node.offset_frequency,
            "squash": node.squash, "squash_frequency": node.squash_frequency}
    mortar = texture(t, stack, node, ours, names)
    if socket.name == "Fac":
        return mortar, "number"
    first, second = t.triple(stack, node.inputs["Color1"]), t.triple(stack, node.inputs["Color2"])
    bricks = {"node": "blender_mix", "amount": mortar | {"gives": "tint"}, "a": first, "b": second}
    return {"node": "blender_mix", "amount": mortar, "a": bricks, "b": t.triple(stack, node.inputs["Mortar"])}, "color"


def checker(t, stack, node, socket):
    check = texture(t, stack, node, {"node": "blender_checker"}, (("Scale", "scale"),))
    if socket.name == "Fac":
        return check, "number"
    first, second = t.triple(stack, node.inputs["Color1"]), t.triple(stack, node.inputs["Color2"])
    return {"node": "blender_mix", "amount": check, "a": second, "b": first}, "color"


def white_noise(t, stack, node, socket):
    color = socket.name == "Color"
    ours = {"node": "blender_white_noise_color" if color else "blender_white_noise"}
    return only_3d(t, stack, node) or (texture(t, stack, node, ours, ()), "color" if color else "number")


def ramp_of(fac, stops):
    """Colours that go linearly from stop to stop, exactly: a chain of mixes."""
    node = numbers(*stops[0][1])
    for (low, _), (high, color) in zip(stops, stops[1:]):
        share = {"node": "remap", "in_low": low, "in_high": high, "input": fac}
        node = {"node": "mix", "a": node, "b": numbers(*color), "amount": share}
    return node


def color_ramp(t, stack, node, socket):
    if socket.name == "Alpha":
        return t.fail(stack, node, "the Alpha of a Color Ramp")
    ramp, fac = node.color_ramp, t.number(stack, node.inputs["Fac"])
    elements = [(e.position, tuple(float(x) for x in e.color[:3])) for e in ramp.elements]
    if ramp.color_mode == "RGB" and ramp.interpolation == "LINEAR" and len(elements) <= 12:
        return ramp_of(fac, elements), "color"
    if ramp.color_mode == "RGB" and ramp.interpolation == "CONSTANT" and len(elements) <= 12:
        steps = [elements[0]]
        for (_, before), (position, color) in zip(elements, elements[1:]):
            steps.append((position, color))
        node = numbers(*steps[0][1])
        for position, color in steps[1:]:
            share = {"node": "remap", "in_low": position, "in_high": position, "input": fac}
            node = {"node": "mix", "a": node, "b": numbers(*color), "amount": share}
        return node, "color"
    return table_of(fac, lambda x: ramp.evaluate(x), 256), "color"


def table_of(fac, function, steps):
    """A colour map of values at steps + 1 places from 0 to 1."""
    stops = [[i / steps, hex_of(function(i / steps))] for i in range(steps + 1)]
    return {"node": "color_map", "wrap": "clamp", "stops": stops, "input": fac}


def curves(t, stack, node, socket):
    if t.number(stack, node.inputs["Fac"]) != 1.0:
        return t.fail(stack, node, "RGB Curves with a Fac other than 1")
    curve = node.mapping
    curve.initialize()
    color = t.triple(stack, node.inputs["Color"])
    parts = []
    for i, name in enumerate(("red", "green", "blue")):
        def value(x, i=i):
            y = curve.evaluate(curve.curves[i], curve.evaluate(curve.curves[3], x))
            return (y, y, y)
        parts.append(channel(table_of(channel(color, name), value, 64), "red"))
    return numbers(*parts), "color"


def mix(t, stack, node, socket):
    """Mix, and Mix RGB of older files."""
    old = node.bl_idname == "ShaderNodeMixRGB"
    data = "RGBA" if old else node.data_type
    if old:
        amount, a, b = node.inputs
        clamp, limit, mode = True, node.use_clamp, node.blend_type
    else:
        if data == "VECTOR" and node.factor_mode == "NON_UNIFORM":
            return t.fail(stack, node, "Mix with a vector as factor")
        ends = {"FLOAT": "Float", "VECTOR": "Vector", "RGBA": "Color"}[data]
        by_identifier = {s.identifier: s for s in node.inputs}
        amount, a, b = by_identifier["Factor_Float"], by_identifier["A_" + ends], by_identifier["B_" + ends]
        clamp, limit, mode = node.clamp_factor, data == "RGBA" and node.clamp_result, node.blend_type if data == "RGBA" else "MIX"
    share = t.number(stack, amount)
    if clamp:
        share = min(max(share, 0.0), 1.0) if isinstance(share, float) else {"node": "clamp", "input": share}
    if data == "FLOAT":
        return {"node": "mix", "a": t.number(stack, a), "b": t.number(stack, b), "amount": share}, "number"
    node = {"node": "blender_mix", "mode": mode.lower(), "amount": share, "a": t.triple(stack, a), "b": t.triple(stack, b)}
    if limit:
        node = limited(node, 0, 1)
    return node, "color" if data == "RGBA" else "vector"


def limited(node, low, high):
    return vector_math("minimum", vector_math("maximum", node, low), high)


def math_node(t, stack, node, socket):
    a, b, c = [t.number(stack, s) for s in node.inputs[:3]]
    value = math_of(node.operation.lower(), a, b, c)
    return ({"node": "clamp", "input": value} if node.use_clamp else value), "number"


def vector_node(t, stack, node, socket):
    a, b, c = [t.triple(stack, s) for s in node.inputs[:3]]
    value = vector_math(node.operation.lower(), a, b, c, t.number(stack, node.inputs[3]))
    return (channel(value, "red"), "number") if socket.name == "Value" else (value, "vector")


def map_range(t, stack, node, socket):
    if node.data_type != "FLOAT":
        return t.fail(stack, node, "Map Range of vectors")
    names = (("Value", "input"), ("From Min", "from_low"), ("From Max", "from_high"), ("To Min", "to_low"), ("To Max", "to_high"),
             ("Steps", "steps"))
    by_identifier = {s.identifier: s for s in node.inputs}
    ours = {"node": "blender_map_range", "curve": node.interpolation_type.lower()}
    ours |= {key: t.number(stack, by_identifier[name]) for name, key in names}
    if node.clamp and node.interpolation_type in ("LINEAR", "STEPPED"):
        low, high = math_of("minimum", ours["to_low"], ours["to_high"]), math_of("maximum", ours["to_low"], ours["to_high"])
        return math_of("minimum", math_of("maximum", ours, low), high), "number"
    return ours, "number"


def clamp_node(t, stack, node, socket):
    value, low, high = [t.number(stack, s) for s in node.inputs[:3]]
    if node.clamp_type == "RANGE":
        low, high = math_of("minimum", low, high), math_of("maximum", low, high)
    return math_of("minimum", math_of("maximum", value, low), high), "number"


def separate(t, stack, node, socket):
    value = t.triple(stack, node.inputs[0])
    mode = getattr(node, "mode", "RGB")
    if mode == "HSV":
        value = {"node": "blender_to_hsv", "input": value}
    elif mode != "RGB":
        return t.fail(stack, node, f"{node.bl_label} in {mode}")
    return channel(value, ("red", "green", "blue")[list(node.outputs).index(socket)]), "number"


def combine(t, stack, node, socket):
    parts = [t.number(stack, s) for s in node.inputs[:3]]
    mode = getattr(node, "mode", "RGB")
    if mode == "HSV":
        return {"node": "blender_from_hsv", "hue": parts[0], "saturation": parts[1], "value": parts[2]}, "color"
    if mode != "RGB":
        return t.fail(stack, node, f"{node.bl_label} in {mode}")
    return numbers(*parts), "vector" if "XYZ" in node.bl_idname else "color"


def hue_saturation(t, stack, node, socket):
    names = (("Hue", "hue"), ("Saturation", "saturation"), ("Value", "value"), ("Fac", "amount"))
    ours = {"node": "blender_hue_saturation", "input": t.triple(stack, node.inputs["Color"])}
    return ours | {key: t.number(stack, node.inputs[name]) for name, key in names}, "color"


def contrast(t, stack, node, socket):
    return {"node": "blender_contrast", "input": t.triple(stack, node.inputs["Color"]), "bright": t.number(stack, node.inputs["Bright"]),
            "contrast": t.number(stack, node.inputs["Contrast"])}, "color"


def invert(t, stack, node, socket):
    color = t.triple(stack, node.inputs["Color"])
    return {"node": "blender_mix", "amount": t.number(stack, node.inputs["Fac"]), "a": color, "b": vector_math("subtract", 1, color)}, "color"


def gamma(t, stack, node, socket):
    return {"node": "blender_gamma", "input": t.triple(stack, node.inputs["Color"]), "gamma": t.number(stack, node.inputs["Gamma"])}, "color"


def grey(t, stack, node, socket):
    return channel(t.triple(stack, node.inputs["Color"]), "luminance"), "number"


def own_value(t, stack, node, socket):
    return t.constant(node.outputs[0])


HANDLERS = {
    "ShaderNodeTexCoord": texture_coordinates, "ShaderNodeUVMap": uv_map, "ShaderNodeNewGeometry": geometry, "ShaderNodeMapping": mapping,
    "ShaderNodeTexNoise": noise, "ShaderNodeTexMusgrave": musgrave, "ShaderNodeTexVoronoi": voronoi, "ShaderNodeTexWave": wave,
    "ShaderNodeTexMagic": magic, "ShaderNodeTexGradient": gradient, "ShaderNodeTexBrick": brick, "ShaderNodeTexChecker": checker,
    "ShaderNodeTexWhiteNoise": white_noise, "ShaderNodeValToRGB": color_ramp, "ShaderNodeRGBCurve": curves, "ShaderNodeMix": mix,
    "ShaderNodeMixRGB": mix, "ShaderNodeMath": math_node, "ShaderNodeVectorMath": vector_node, "ShaderNodeMapRange": map_range,
    "ShaderNodeClamp": clamp_node, "ShaderNodeSeparateXYZ": separate, "ShaderNodeSeparateRGB": separate,
    "ShaderNodeSeparateColor": separate, "ShaderNodeCombineXYZ": combine, "ShaderNodeCombineRGB": combine,
    "ShaderNodeCombineColor": combine, "ShaderNodeHueSaturation": hue_saturation, "ShaderNodeBrightContrast": contrast,
    "ShaderNodeInvert": invert, "ShaderNodeGamma": gamma, "ShaderNodeRGBToBW": grey, "ShaderNodeValue": own_value,
    "ShaderNodeRGB": own_value,
}


# ---------------------------------------------------------------- the program


def program():
    """The path of the program burl."""
    preferences = bpy.context.preferences.addons.get(__name__)
    path = preferences.preferences.program if preferences else ""
    found = shutil.which(bpy.path.abspath(path) if path else "burl")
    if not found:
        raise BurlError("The program burl was not found; set its path in the add-on's preferences.")
    return found


def run(*arguments, folder=None):
    """The output of the program; its own sentence where it fails."""
    done = subprocess.run([program(), *arguments], cwd=folder, capture_output=True, text=True)
    if done.returncode:
        lines = [line for line in done.stderr.splitlines() if line.strip()] or ["burl failed."]
        raise BurlError(lines[-1])
    return done.stdout


# ---------------------------------------------------------------- meshes out and in


def loops_of(mesh):
    """The vertices and the loops of each triangle, and its polygon."""
    mesh.calc_loop_triangles()
    count = len(mesh.loop_triangles)
    loops, polygons = numpy.empty(3 * count, numpy.int32), numpy.empty(count, numpy.int32)
    mesh.loop_triangles.foreach_get("loops", loops)
    mesh.loop_triangles.foreach_get("polygon_index", polygons)
    vertices = numpy.empty(len(mesh.loops), numpy.int32)
    mesh.loops.foreach_get("vertex_index", vertices)
    return vertices[loops].reshape(-1, 3), loops.reshape(-1, 3), polygons


def points_of(mesh, y_up):
    points = numpy.empty(3 * len(mesh.vertices), numpy.float32)
    mesh.vertices.foreach_get("co", points)
    points = points.reshape(-1, 3)
    return (points[:, [0, 2, 1]] * numpy.array([1, 1, -1], numpy.float32) if y_up else points) + numpy.float32(0)  # no -0


def numbered(own, output):
    """Numbers of the mesh's points and of the output's, the same where points are, whatever the order of either."""
    both = numpy.concatenate([own, output.astype(numpy.float32) + numpy.float32(0)])
    _, same = numpy.unique(both, axis=0, return_inverse=True)
    return same.ravel()[: len(own)], same.ravel()[len(own) :]


def write_obj(mesh, path, y_up, uv_layer=None):
    """Writes the triangles of a mesh with the normals of its corners, and their texture coordinates in a layer."""
    triangles, loops, _ = loops_of(mesh)
    points = points_of(mesh, y_up)
    normals = numpy.empty(3 * len(mesh.loops), numpy.float32)
    if hasattr(mesh, "corner_normals"):  # Blender 4.1
        mesh.corner_normals.foreach_get("vector", normals)
    else:
        mesh.calc_normals_split()
        mesh.loops.foreach_get("normal", normals)
    normals = normals.reshape(-1, 3)
    if y_up:
        normals = normals[:, [0, 2, 1]] * [1, 1, -1]
    corners, form, places = numpy.stack([triangles, loops], axis=2).reshape(-1, 6) + 1, "f %d//%d %d//%d %d//%d\n", numpy.zeros((0, 2))
    if uv_layer:
        places = numpy.empty(2 * len(mesh.loops), numpy.float32)
        mesh.uv_layers[uv_layer].data.foreach_get("uv", places)
        places = places.reshape(-1, 2)
        corners, form = numpy.stack([triangles, loops, loops], axis=2).reshape(-1, 9) + 1, "f %d/%d/%d %d/%d/%d %d/%d/%d\n"
    with open(path, "w") as file:
        for line, rows in (("v %.9g %.9g %.9g\n", points), ("vt %.9g %.9g\n", places), ("vn %.6g %.6g %.6g\n", normals), (form, corners)):
            file.write("".join(line % tuple(row) for row in rows.tolist()))


def read_obj(path):
    """Points, texture coordinates and, per triangle, the numbers of its points and of their texture coordinates."""
    rows = {"v": [], "vt": [], "f": []}
    with open(path) as file:
        for line in file:
            kind, _, rest = line.partition(" ")
            if kind in rows:
                rows[kind].append(rest)
    points, places = (numpy.array(" ".join(rows[kind]).split(), float).reshape(-1, width) for kind, width in (("v", 3), ("vt", 2)))
    corners = numpy.array(" ".join(rows["f"]).replace("/", " ").split(), int).reshape(len(rows["f"]), 3, -1)
    return points, places.astype(numpy.float32), corners[:, :, :2] - 1


def pieces_of(triangles, faces, points):
    """For each triangle of the mesh the first of the output's faces that show it, and one more than the last: one face, or several
    where Burl cut it. Both have the numbers of their corners' points."""
    def area(corners):
        a, b, c = points[corners]
        return float(numpy.linalg.norm(numpy.cross(b - a, c - a)))

    shown, at, begins, ends = faces.tolist(), 0, [], []
    for corners in triangles.tolist():
        begins.append(at)
        if at < len(shown) and shown[at] == corners:
            at += 1
        else:
            total, covered = area(corners), 0.0
            while at < len(shown) and covered < total * (1 - 1e-6):
                covered += area(shown[at])
                at += 1
        ends.append(at)
    if at != len(shown):
        raise BurlError("The atlas that came back does not fit the mesh.")
    return numpy.array(begins), numpy.array(ends)


def apply_atlas(mesh, path, y_up):
    """Gives the mesh the atlas's texture coordinates as the layer "Burl". Polygons whose triangles lie apart in the atlas, or were
    cut, become triangles; returns their number."""
    points, places, faces = read_obj(path)
    triangles, loops, polygons = loops_of(mesh)
    own_points = points_of(mesh, y_up)
    own_numbers, their_numbers = numbered(own_points, points)
    by_number = numpy.empty((max(own_numbers.max(), their_numbers.max()) + 1, 3))
    by_number[own_numbers] = own_points
    by_number[their_numbers] = points
    faces[:, :, 0] = their_numbers[faces[:, :, 0]]
    begins, ends = pieces_of(own_numbers[triangles], faces[:, :, 0], by_number)
    if LAYER in mesh.uv_layers:
        mesh.uv_layers.remove(mesh.uv_layers[LAYER])
    layer = mesh.uv_layers.new(name=LAYER, do_init=False)
    whole = ends - begins == 1
    corners = places[faces[begins[whole], :, 1]]
    uvs = numpy.zeros((len(mesh.loops), 2), numpy.float32)
    uvs[loops[whole].ravel()] = corners.reshape(-1, 2)
    apart = (uvs[loops[whole]] != corners).any(axis=(1, 2))
    split = set(polygons[whole][apart].tolist()) | set(polygons[~whole].tolist())
    layer.data.foreach_set("uv", uvs.ravel())
    mesh.uv_layers.active = layer
    layer.active_render = True
    if split:
        if y_up:
            by_number = by_number[:, [0, 2, 1]] * [1, -1, 1]
        runs = zip(zip(begins.tolist(), ends.tolist()), polygons.tolist())
        cut_polygons(mesh, split, runs, own_numbers, by_number, places, faces)
    return len(split)


def cut_polygons(mesh, split, runs, own_numbers, points, places, faces):
    """Replaces polygons by the atlas's triangles. Points that Burl added become vertices once."""
    body = bmesh.new()
    body.from_mesh(mesh)
    body.faces.ensure_lookup_table()
    layer = body.loops.layers.uv[LAYER]
    old_faces = {polygon: body.faces[polygon] for polygon in split}
    edges = {edge for face in old_faces.values() for edge in face.edges}
    made, between = {}, {}
    for (begin, end), polygon in runs:
        if polygon not in split:
            continue
        old = old_faces[polygon]
        corner_of = {int(own_numbers[v.index]): v for v in old.verts}
        for face in faces[begin:end].tolist():
            for v, _ in face:
                if v not in corner_of and v not in made:
                    made[v], ends = new_vertex(body, old, points[v])
                    between[made[v]] = ends
            corners = [corner_of[v] if v in corner_of else made[v] for v, _ in face]
            if len(set(corners)) < 3 or body.faces.get(corners):  # no area, or there already
                continue
            new = body.faces.new(corners, old)
            for loop, (_, place) in zip(new.loops, face):
                copy_corner(body, loop, old, between)
                loop[layer].uv = places[place]
    for face in old_faces.values():
        body.faces.remove(face)
    for edge in edges:
        if edge.is_valid and not edge.link_faces:
            body.edges.remove(edge)
    body.to_mesh(mesh)
    body.free()
    mesh.update()


def copy_corner(body, loop, face, between):
    """Gives a corner what the face's corner at its vertex has; at a new vertex texture coordinates from both ends of its edge."""
    corners = {corner.vert: corner for corner in face.loops}
    if loop.vert in corners:
        loop.copy_from(corners[loop.vert])
        return
    first, second, share = between[loop.vert]
    if first not in corners or second not in corners:
        return
    loop.copy_from(corners[first])
    for layer in body.loops.layers.uv.values():
        loop[layer].uv = corners[first][layer].uv.lerp(corners[second][layer].uv, share)


def new_vertex(body, face, point):
    """A vertex at a point, with the weights of the face's edge that is nearest to it; that edge's ends and the share of the way."""
    best, nearest = None, math.inf
    for edge in face.edges:
        a, b = (numpy.array(v.co) for v in edge.verts)
        along = b - a
        share = float(numpy.clip(numpy.dot(point - a, along) / max(float(numpy.dot(along, along)), 1e-30), 0, 1))
        far = float(numpy.linalg.norm(a + share * along - point))
        if far < nearest:
            best, nearest = (edge, share), far
    vertex = body.verts.new([float(x) for x in point])
    vertex.copy_from_vert_interp(list(best[0].verts), best[1])
    vertex.co = [float(x) for x in point]
    return vertex, (*best[0].verts, best[1])


# ---------------------------------------------------------------- materials


def free_path(folder, name):
    """The path of a new file in the folder: of that name, or with -2, -3 and so on before its extension."""
    stem, extension = os.path.splitext(name)
    path, number = os.path.join(folder, name), 1
    while os.path.lexists(path):
        number += 1
        path = os.path.join(folder, f"{stem}-{number}{extension}")
    return path


def picture(path, name, color, save_beside):
    """An image of the .blend from a file of the bake: packed, or saved beside the .blend, where no file is replaced."""
    if save_beside:
        target = free_path(bpy.path.abspath("//"), os.path.basename(path))
        shutil.copyfile(path, target)
        image = bpy.data.images.load(target)
        image.filepath = bpy.path.relpath(target)
    else:
        image = bpy.data.images.load(path)
        image.pack()
        image.filepath = "//" + os.path.basename(path)
    image.name = name
    image.colorspace_settings.name = "sRGB" if color else "Non-Color"
    return image


CHANNELS = {"metallic": "Metallic", "roughness": "Roughness", "clearcoat": "Clearcoat", "clearcoat_roughness": "Clearcoat Roughness",
            "transmission": "Transmission", "opacity": "Alpha", "specular": "Specular"}


# What no input of the Principled BSDF shows, each with the value that does nothing.
LEFT_OUT = {"sheen": "#000000", "occlusion": 1}


def principled_of(name, files, settings, transparent, save_beside):
    """A Principled material of the pictures of a bake, by channel, and of the recipe's constants."""
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    surface = next(node for node in nodes if node.bl_idname == "ShaderNodeBsdfPrincipled")  # its name depends on the language
    uv = nodes.new("ShaderNodeUVMap")
    uv.uv_map = LAYER
    uv.location = (-900, 0)

    def image_node(channel_name, color):
        node = nodes.new("ShaderNodeTexImage")
        node.image = picture(files[channel_name], f"{name} {channel_name}", color, save_beside)
        node.label = channel_name
        node.location = (-600, 300 - 280 * len([n for n in nodes if n.bl_idname == "ShaderNodeTexImage"]))
        links.new(uv.outputs[0], node.inputs[0])
        return node

    for ours, socket in CHANNELS.items():
        if isinstance(settings.get(ours), (int, float)):
            input_of(surface, socket).default_value = settings[ours] * (0.5 if ours == "specular" else 1)
    surface.inputs["IOR"].default_value = settings.get("ior", 1.5)
    base = image_node("base_color", True)
    links.new(base.outputs["Color"], surface.inputs["Base Color"])
    if transparent:
        links.new(base.outputs["Alpha"], surface.inputs["Alpha"])
        material.blend_method = "HASHED"
    for ours in files:
        if ours in ("metallic", "roughness", "clearcoat", "clearcoat_roughness", "transmission"):
            links.new(image_node(ours, False).outputs["Color"], input_of(surface, CHANNELS[ours]))
    if "specular" in files:
        half = nodes.new("ShaderNodeMath")
        half.operation, half.inputs[1].default_value = "MULTIPLY", 0.5
        links.new(image_node("specular", False).outputs["Color"], half.inputs[0])
        links.new(half.outputs[0], input_of(surface, "Specular"))
    emissive = settings.get("emissive")
    surface.inputs["Emission Strength"].default_value = settings.get("emissive_strength", 1.0)
    if "emissive" in files:
        links.new(image_node("emissive", True).outputs["Color"], input_of(surface, "Emission"))
    else:  # Blender 4's new materials have a white one
        light = linear_of(emissive) if isinstance(emissive, str) and emissive.startswith("#") else (0, 0, 0)
        input_of(surface, "Emission").default_value = (*light, 1)
    if "normal" in files:
        bend = nodes.new("ShaderNodeNormalMap")
        bend.uv_map = LAYER
        bend.location = (-300, -500)
        links.new(image_node("normal", False).outputs["Color"], bend.inputs["Color"])
        links.new(bend.outputs[0], surface.inputs["Normal"])
    return material


def linear_of(code):
    """Linear light of "#rrggbb"."""
    result = []
    for i in (1, 3, 5):
        x = int(code[i : i + 2], 16) / 255
        result.append(x / 12.92 if x <= 0.04045 else ((x + 0.055) / 1.055) ** 2.4)
    return result


class Bake:
    """A bake of one mesh: the program's work first, and what changes the .blend after it, so that an error changes nothing."""

    def __init__(self, folder, thing, recipe_arguments, size, y_up, name, uv_layer):
        if not thing.data.polygons:
            raise BurlError(f"\"{thing.name}\" has no faces.")
        if len(thing.data.uv_layers) == 8 and LAYER not in thing.data.uv_layers:
            raise BurlError(f"\"{thing.name}\" has eight UV layers already; remove one.")
        self.folder, self.thing, self.y_up, self.name = tempfile.mkdtemp(dir=folder), thing, y_up, name
        self.stem = bpy.path.clean_name(f"{thing.name} {name}")
        write_obj(thing.data, self.path("mesh.obj"), y_up, uv_layer)
        arguments = ("mesh.obj", "-o", self.stem + ".obj", *recipe_arguments, "--size", str(size), "--atlas", "chart", "--json")
        self.report = json.loads(run("bake", *arguments, folder=self.folder))

    def path(self, file):
        return os.path.join(self.folder, file)

    def pictures(self):
        """The bake's pictures by channel."""
        files = {"base_color": self.path(self.stem + ".png")}
        for output in self.report["outputs"]:
            rest = os.path.basename(output)[len(self.stem) + 1 :]
            if output.endswith(".png") and rest != "png":
                files[rest[: -len(".png")]] = self.path(os.path.basename(output))
        return files

    def apply(self, save_beside):
        """Gives the mesh its texture coordinates and material; returns sentences on polygons that were cut and on what is left out."""
        mesh = self.thing.data
        with open(self.path(self.stem + ".mtl")) as file:
            transparent = "map_d" in file.read()
        cut = apply_atlas(mesh, self.path(self.stem + ".obj"), self.y_up)
        settings = self.report["recipe"].get("material", {})
        title = f"{self.thing.name} {self.name}"
        files = self.pictures()
        material = principled_of(title, files, settings, transparent, save_beside)
        mesh.materials.clear()
        mesh.materials.append(material)
        mesh.polygons.foreach_set("material_index", numpy.zeros(len(mesh.polygons), numpy.int32))
        said = [f"{cut} polygons of \"{self.thing.name}\" became triangles, because a seam of the atlas crosses them."] if cut else []
        lost = [name for name, nothing in LEFT_OUT.items() if name in files or settings.get(name, nothing) != nothing]
        if lost:
            said.append(f"\"{self.thing.name}\": Principled has no place for the material's {' and '.join(lost)}.")
        return " ".join(said)


# ---------------------------------------------------------------- the panel


class BurlPreferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    program: StringProperty(name="Program", description="Path of the program burl; empty: the one on PATH", subtype="FILE_PATH")

    def draw(self, context):
        self.layout.prop(self, "program")


class BurlControl(bpy.types.PropertyGroup):
    about: StringProperty()
    is_color: bpy.props.BoolProperty()
    low: FloatProperty()
    high: FloatProperty()
    number: FloatProperty(get=lambda self: self.get("number", 0.0),
                          set=lambda self, x: self.__setitem__("number", min(max(x, self.low), self.high)), precision=4)
    color: FloatVectorProperty(subtype="COLOR_GAMMA", min=0, max=1)


cached_materials = []


def list_of_materials(self, context):
    """The materials that the program has, as an enumeration."""
    if not cached_materials:
        try:
            for known in json.loads(run("list", "materials", "--json")):
                cached_materials.append((known["name"], known["name"], known["text"]))
        except BurlError:
            return [("", "the program burl was not found", "Set its path in the add-on's preferences")]
    return cached_materials


def at_path(recipe, path):
    for key in path.split("."):
        recipe = recipe[int(key)] if isinstance(recipe, list) else recipe[key]
    return recipe


def material_chosen(settings, context):
    try:
        fill_controls(settings)
    except BurlError:  # the button says what is wrong
        settings.controls.clear()


def fill_controls(settings):
    """The controls of the chosen material, at the values that it has by itself."""
    settings.controls.clear()
    if not settings.material:
        return
    recipe = json.loads(run("show", settings.material, "--json"))
    for control in recipe.get("controls", []):
        value = at_path(recipe, control["sets"][0].split("=")[0].strip())
        item = settings.controls.add()
        item.name, item.about, item.is_color = control["name"], control.get("about", ""), isinstance(value, str)
        if item.is_color:
            item.color = [int(value[i : i + 2], 16) / 255 for i in (1, 3, 5)]
        else:
            item.low, item.high = control["range"]
            item.number = value


class BurlSettings(bpy.types.PropertyGroup):
    material: EnumProperty(name="Material", items=list_of_materials, update=material_chosen)
    controls: CollectionProperty(type=BurlControl)
    size: IntProperty(name="Size", description="Side of the pictures in texels", default=1024, min=16, max=16384)
    pictures: EnumProperty(name="Pictures", items=[("PACK", "Packed", "In the .blend"), ("FILES", "Files", "Beside the .blend")])


def selected_meshes(context):
    things = [thing for thing in context.selected_objects if thing.type == "MESH"]
    if not things:
        raise BurlError("Select a mesh.")
    if len({thing.data for thing in things}) < len(things):
        raise BurlError("Two of the selected objects share a mesh; select one of them, or make the mesh single-user.")
    if any(thing.data.library for thing in things):
        raise BurlError("A selected mesh belongs to another .blend; make it local first.")
    return things


class BurlOperator:
    """One step of undo for all selected meshes; errors of Burl become reports."""
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return context.mode == "OBJECT"

    def execute(self, context):
        settings = context.scene.burl
        try:
            if settings.pictures == "FILES" and not bpy.data.filepath:
                raise BurlError("Save the .blend first, so that pictures can lie beside it.")
            with tempfile.TemporaryDirectory(prefix="burl-") as folder:
                jobs = [(thing, *self.job(thing, settings, folder)) for thing in selected_meshes(context)]
                bakes = [Bake(folder, thing, arguments, settings.size, *rest) for thing, arguments, *rest in jobs]
                said = [one.apply(settings.pictures == "FILES") for one in bakes]
            for sentence in filter(None, said):
                self.report({"INFO"}, sentence)
        except BurlError as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class BURL_OT_carve(BurlOperator, bpy.types.Operator):
    bl_idname = "burl.carve"
    bl_label = "Carve"
    bl_description = "Give the selected meshes the chosen material of Burl"

    def job(self, thing, settings, folder):
        if not settings.material:
            raise BurlError("Choose a material.")
        if not settings.controls:
            fill_controls(settings)
        arguments = ["--recipe", settings.material]
        for control in settings.controls:
            code = "#%02x%02x%02x" % tuple(round(255 * x) for x in control.color)
            arguments += ["--set", f"{control.name}={code if control.is_color else repr(round(control.number, 9))}"]
        return arguments, True, settings.material, None


class BURL_OT_bake_nodes(BurlOperator, bpy.types.Operator):
    bl_idname = "burl.bake_nodes"
    bl_label = "Bake my nodes"
    bl_description = "Bake the procedural nodes of the selected meshes' materials, without unwrapping"

    def job(self, thing, settings, folder):
        material = thing.active_material
        if material is None:
            raise BurlError(f"\"{thing.name}\" has no material.")
        if len({slot.material for slot in thing.material_slots}) > 1:
            raise BurlError(f"\"{thing.name}\" has several materials; bake one at a time on meshes of their own.")
        translator = Translator(material, thing)
        recipe = translator.recipe(settings.size)
        for note in dict.fromkeys(translator.notes):
            self.report({"WARNING"}, f"{material.name}: {note}.")
        path = os.path.join(folder, f"{thing.as_pointer()}.json")
        with open(path, "w") as file:
            json.dump(recipe, file)
        return ["--recipe", path], False, material.name, translator.uv_layer


class BURL_PT_panel(bpy.types.Panel):
    bl_label = "Burl"
    bl_space_type, bl_region_type, bl_category = "VIEW_3D", "UI", "Burl"

    def draw(self, context):
        settings, layout = context.scene.burl, self.layout
        layout.prop(settings, "size")
        layout.prop(settings, "pictures", expand=True)
        layout.separator()
        layout.prop(settings, "material")
        for control in settings.controls:
            row = layout.row()
            row.prop(control, "color" if control.is_color else "number", text=control.name)
            if control.about:
                layout.label(text=control.about)
        layout.operator("burl.carve")
        layout.separator()
        layout.operator("burl.bake_nodes")


classes = (BurlPreferences, BurlControl, BurlSettings, BURL_OT_carve, BURL_OT_bake_nodes, BURL_PT_panel)


def register():
    for one in classes:
        bpy.utils.register_class(one)
    bpy.types.Scene.burl = bpy.props.PointerProperty(type=BurlSettings)


def unregister():
    del bpy.types.Scene.burl
    for one in reversed(classes):
        bpy.utils.unregister_class(one)


if __name__ == "__main__":
    register()
