"""A frame of an exported point cache, drawn by Blender's Cycles:
blender --background --python with_blender.py -- FOLDER PICTURE.png FRAME"""

import math
import sys

import bpy
from mathutils import Vector

folder, picture, frame = sys.argv[sys.argv.index("--") + 1:]

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.wm.obj_import(filepath=f"{folder}/mesh.obj")
(cloth,) = bpy.context.selected_objects
cache = cloth.modifiers.new("motion", "MESH_CACHE")
cache.cache_format, cache.filepath, cache.frame_start = "PC2", f"{folder}/motion.pc2", 1
smooth = cloth.modifiers.new("smooth", "SUBSURF")
smooth.render_levels = smooth.levels = 2
for polygon in cloth.data.polygons:
    polygon.use_smooth = True


def material(name, colour, roughness, sheen=0.0):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = made.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Sheen"].default_value = sheen
    return made


cloth.data.materials.clear()
cloth.data.materials.append(material("velvet", (0.40, 0.012, 0.025), 0.7, sheen=0.35))
bpy.ops.mesh.primitive_plane_add(size=40.0, location=(0.0, 0.0, 0.0))
bpy.context.object.data.materials.append(material("floor", (0.34, 0.24, 0.16), 0.4))
bpy.ops.mesh.primitive_plane_add(size=40.0, location=(0.0, 2.6, 0.0), rotation=(math.pi / 2, 0.0, 0.0))
bpy.context.object.data.materials.append(material("wall", (0.62, 0.66, 0.68), 0.9))
bpy.ops.mesh.primitive_cylinder_add(radius=0.018, depth=2.7, location=(0.0, 0.0, 2.315), rotation=(0.0, math.pi / 2, 0.0))
bpy.context.object.data.materials.append(material("rail", (0.5, 0.36, 0.16), 0.3))

bpy.ops.object.light_add(type="AREA", location=(-2.4, -2.6, 3.6))
light = bpy.context.object
light.data.energy, light.data.size = 260.0, 1.6
light.rotation_euler = (Vector((0.2, 0.2, 1.1)) - light.location).to_track_quat("-Z", "Y").to_euler()
scene = bpy.context.scene
scene.world = bpy.data.worlds.new("world")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs[0].default_value = (0.75, 0.82, 0.95, 1.0)
scene.world.node_tree.nodes["Background"].inputs[1].default_value = 0.35

bpy.ops.object.camera_add(location=(0.7, -5.6, 1.45))
camera = bpy.context.object
camera.rotation_euler = (Vector((-0.12, 0.0, 1.2)) - camera.location).to_track_quat("-Z", "Y").to_euler()
camera.data.lens = 58.0
scene.camera = camera
scene.frame_set(int(frame))
scene.render.engine = "CYCLES"
scene.cycles.device, scene.cycles.samples, scene.cycles.max_bounces = "CPU", 32, 4
scene.cycles.use_denoising = False  # Debian's build has no denoiser
scene.view_settings.view_transform = "Filmic"
scene.render.resolution_x, scene.render.resolution_y = 800, 560
scene.render.filepath = picture
bpy.ops.render.render(write_still=True)
