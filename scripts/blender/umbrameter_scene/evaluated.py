# SPDX-License-Identifier: Apache-2.0
"""What a scene is when Blender renders it: modifiers, instances and visibility of the render, not of the viewport.

Blender hands that out to render engines only, so here is one that draws nothing.
"""
import contextlib
import dataclasses

import bpy
import numpy

from . import masks
from .said import Refused, last_line

LEFT_OUT = {"VOLUME": "volumes are left out", "CURVES": "hair curves are left out", "POINTCLOUD": "point clouds are left out",
            "GPENCIL": "grease pencil drawings are left out"}


@dataclasses.dataclass
class Primitive:
    """Triangles of one material."""
    material: str
    positions: numpy.ndarray
    normals: object  # None: flat
    uvs: object  # None: no mask, or no texture coordinates
    triangles: numpy.ndarray
    mask: object = None


@dataclasses.dataclass
class Instance:
    name: str
    mesh: tuple  # key in Evaluated.meshes
    matrix: numpy.ndarray  # Blender's world from the mesh's own numbers


@dataclasses.dataclass
class LightInstance:
    name: str
    object_name: str
    matrix: numpy.ndarray
    values: dict
    folder: str = ""  # of its pictures


@dataclasses.dataclass
class Evaluated:
    meshes: dict = dataclasses.field(default_factory=dict)  # key -> (name, primitives)
    instances: list = dataclasses.field(default_factory=list)
    lights: list = dataclasses.field(default_factory=list)

    def triangle_count(self):
        counts = {key: sum(len(p.triangles) for p in primitives) for key, (_, primitives) in self.meshes.items()}
        return sum(counts[instance.mesh] for instance in self.instances)

    def corners(self):
        """Of the bounding boxes of all instances, in Blender's world; N x 3."""
        corners = []
        for instance in self.instances:
            for primitive in self.meshes[instance.mesh][1]:
                low, high = primitive.positions.min(axis=0), primitive.positions.max(axis=0)
                box = numpy.array([[x, y, z, 1.0] for x in (low[0], high[0]) for y in (low[1], high[1]) for z in (low[2], high[2])])
                corners.append((box @ instance.matrix.T)[:, :3])
        return numpy.concatenate(corners)


class Reader(bpy.types.RenderEngine):
    bl_idname = "UMBRAMETER_READER"
    bl_label = "Umbrameter reads the scene"
    read = None  # what to do with the dependency graph
    problem = None

    def render(self, depsgraph):
        try:
            Reader.read(depsgraph)
        except Exception as problem:  # Blender would print and forget it
            Reader.problem = problem


@contextlib.contextmanager
def changed(thing, **values):
    before = {name: getattr(thing, name) for name in values}
    for name, value in values.items():
        setattr(thing, name, value)
    try:
        yield
    finally:
        for name, value in before.items():
            setattr(thing, name, value)


def with_render_depsgraph(scene, read):
    """Calls read(depsgraph) with that of the first view layer's render."""
    Reader.read, Reader.problem = read, None
    bpy.utils.register_class(Reader)
    try:
        with changed(scene.render, engine=Reader.bl_idname, use_compositing=False, use_sequencer=False, use_border=False,
                     resolution_percentage=100):
            bpy.ops.render.render(layer=scene.view_layers[0].name)
    except RuntimeError as why:
        raise Refused(f"Blender does not render the scene: {last_line(str(why))}") from None
    finally:
        bpy.utils.unregister_class(Reader)
    if Reader.problem:
        raise Reader.problem


def read(depsgraph, said):
    found = Evaluated()
    known_masks = masks.Masks(said)
    for instance in depsgraph.object_instances:
        thing = instance.object
        if thing.type in LEFT_OUT:
            said.add(LEFT_OUT[thing.type], thing.name)
        if not instance.is_instance:
            say_particles(thing, said)
        if not instance.show_self:
            continue
        matrix = numpy.array(instance.matrix_world, dtype=float)
        if thing.type == "LIGHT":
            found.lights.append(LightInstance(thing.name, thing.original.name, matrix, light_values(thing.data)))
        if thing.type == "MESH":
            add_mesh(found, thing, matrix, known_masks, said)
    return found


def add_mesh(found, thing, matrix, known_masks, said):
    materials = [slot.material for slot in thing.material_slots] or list(thing.data.materials)
    key = (thing.data.as_pointer(), tuple(material.name if material else "" for material in materials))
    if key not in found.meshes:
        found.meshes[key] = (thing.data.name, read_mesh(thing, materials, known_masks, said))
    if not found.meshes[key][1]:
        return  # points and edges
    if not numpy.isfinite(matrix).all():
        said.add("objects whose place is not finite are left out", thing.name)
        return
    say_visibility(thing, said)
    found.instances.append(Instance(thing.name, key, matrix))


def read_mesh(thing, materials, known_masks, said):
    """Its primitives, one a material in use; empty where there are no faces."""
    mesh = thing.to_mesh()
    try:
        if hasattr(mesh, "calc_normals_split"):
            mesh.calc_normals_split()
        mesh.calc_loop_triangles()
        return split_by_material(mesh, thing.name, materials, known_masks, said)
    finally:
        thing.to_mesh_clear()


def gather(things, name, shape, dtype):
    values = numpy.empty(int(numpy.prod(shape)), dtype=dtype)
    things.foreach_get(name, values)
    return values.reshape(shape)


def split_by_material(mesh, name, materials, known_masks, said):
    count = len(mesh.loop_triangles)
    if count == 0:
        return []
    loops = gather(mesh.loop_triangles, "loops", (count, 3), numpy.int32)
    corners = gather(mesh.loop_triangles, "vertices", (count, 3), numpy.int32)
    slots = gather(mesh.loop_triangles, "material_index", (count,), numpy.int32)
    is_smooth = gather(mesh.loop_triangles, "use_smooth", (count,), bool)
    positions = gather(mesh.vertices, "co", (len(mesh.vertices), 3), numpy.float32)[corners]
    normals = gather(mesh.loops, "normal", (len(mesh.loops), 3), numpy.float32)[loops]
    if not numpy.isfinite(positions).all():
        said.add("meshes with positions that are not finite are left out", name)
        return []
    # A flat face that is bent has two triangles of two normals.
    flat = numpy.cross(positions[:, 1] - positions[:, 0], positions[:, 2] - positions[:, 0])
    flat /= numpy.maximum(numpy.linalg.norm(flat, axis=1, keepdims=True), 1e-30)
    normals[~is_smooth] = flat[~is_smooth][:, None, :]
    primitives = []
    slots = numpy.minimum(slots, max(len(materials) - 1, 0))
    for slot in numpy.unique(slots):
        chosen = slots == slot
        material = materials[slot] if materials else None
        mask = known_masks.of(material) if material else None
        uvs = texture_points(mesh, mask, loops[chosen], name, said) if mask else None
        shading = normals[chosen] if is_smooth[chosen].any() else None
        primitives.append(merge_corners(material.name if material else "", positions[chosen], shading, uvs, mask))
    return primitives


def texture_points(mesh, mask, loops, name, said):
    """Where the mask's picture lies at each corner, v upwards. Without any, Blender takes (0, 0)."""
    layers = mesh.uv_layers
    layer = layers.get(mask.uv_layer) if mask.uv_layer else next((l for l in layers if l.active_render), None)
    if layer is None:
        said.add("meshes with a mask but without its texture coordinates show one texel of it", name)
        return None
    points = gather(layer.data, "uv", (len(layer.data), 2), numpy.float32)[loops].astype(float)
    points = points @ mask.uv_transform[:2, :2].T + mask.uv_transform[:2, 2]
    if mask.extension != "REPEAT" and (points.min() < -1e-6 or points.max() > 1.0 + 1e-6):
        said.add("masks that do not repeat in Blender are repeated outside their picture", name)
    return points.astype(numpy.float32)


def merge_corners(material, positions, normals, uvs, mask):
    """Corners of equal numbers become one vertex."""
    parts = [part.reshape(-1, part.shape[-1]) for part in (positions, normals, uvs) if part is not None]
    rows = numpy.ascontiguousarray(numpy.concatenate(parts, axis=1), dtype=numpy.float32)
    as_bytes = rows.view(numpy.dtype((numpy.void, rows.shape[1] * rows.itemsize))).ravel()
    _, first, index = numpy.unique(as_bytes, return_index=True, return_inverse=True)
    rows = rows[first]
    after_normals = 3 if normals is None else 6
    return Primitive(material, rows[:, :3], None if normals is None else rows[:, 3:6],
                     None if uvs is None else rows[:, after_normals:], index.reshape(-1, 3).astype(numpy.uint32), mask)


def light_values(data):
    """Of an evaluated light: it may be animated."""
    names = ("type", "shape", "size", "size_y", "spread", "shadow_soft_size", "angle", "spot_size", "energy", "use_shadow")
    values = {name: getattr(data, name) for name in names if hasattr(data, name)}
    values["casts_in_cycles"] = data.cycles.cast_shadow
    values["is_portal"] = data.type == "AREA" and data.cycles.is_portal
    values["has_nodes"] = data.use_nodes and any(node.type not in ("EMISSION", "OUTPUT_LIGHT") for node in data.node_tree.nodes)
    return values


def say_visibility(thing, said):
    if not (thing.visible_camera and thing.visible_shadow):
        said.add("objects hidden from the camera or from shadow rays are seen by both", thing.name)
    if thing.is_holdout or thing.is_shadow_catcher:
        said.add("holdouts and shadow catchers are plain surfaces", thing.name)


def say_particles(thing, said):
    for system in thing.particle_systems:
        settings = system.settings
        if settings.render_type in ("PATH", "HALO", "LINE", "BILLBOARD"):
            kind = "hair strands" if settings.type == "HAIR" else "particles drawn as halos, lines or paths"
            said.add(f"{kind} are left out", f"{thing.name}/{system.name}")
