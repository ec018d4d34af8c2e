"""Holds pc2 with its mesh, and glb, as Blender plays them, against the CSV. Run by read_back.sh:
blender --background --python check_blender.py -- FOLDER CLOTH…"""

import sys
from pathlib import Path

import bpy
import numpy as np

folder, cloths = Path(sys.argv[sys.argv.index("--") + 1]), sys.argv[sys.argv.index("--") + 2:]
sys.path.insert(0, str(Path(__file__).parent))
from motion_of_csv import Motion, same_faces  # noqa: E402

np.bool = bool  # Debian 12's Blender asks its NumPy for a name that this has no more
motion = Motion(folder, cloths)
epsilon = 1.2e-7 * max(1.0, np.abs(motion.position).max())  # m, the last place of single precision out there


def start_anew():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    return bpy.context.scene


def places_now(thing):
    mesh = thing.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
    return np.array([vertex.co for vertex in mesh.vertices])


def check_pc2():
    scene = start_anew()
    bpy.ops.wm.obj_import(filepath=str(folder / "pc2" / "mesh.obj"))
    (mesh,) = bpy.context.selected_objects
    faces, _, lone = motion.shape(0)
    of_mesh = [mass for mass in range(len(motion.names)) if mass not in lone]
    same_faces([tuple(of_mesh[v] for v in polygon.vertices) for polygon in mesh.data.polygons],
               [face for sheet in faces.values() for face in sheet], "mesh.obj")
    cache = mesh.modifiers.new("motion", "MESH_CACHE")
    cache.cache_format, cache.filepath = "PC2", str(folder / "pc2" / "motion.pc2")
    cache.frame_start = 1  # the first sample on Blender's first frame
    worst = 0.0
    for number, place in enumerate(motion.position):
        scene.frame_set(number + 1)
        worst = max(worst, np.abs(places_now(mesh) - place[of_mesh]).max())
    assert worst < 2 * epsilon, f"pc2: off by {worst} m"
    # Y is up in the files, Z in Blender: the importer has turned the mesh.
    assert np.allclose(np.array(mesh.matrix_world)[:3, :3] @ [0, 1, 0], [0, 0, 1], atol=1e-6)
    return worst


def check_glb():
    scene = start_anew()
    bpy.ops.import_scene.gltf(filepath=str(folder / "motion.glb"))
    worst = 0.0
    for number, time in enumerate(motion.times):
        frame = (time - motion.times[0]) * scene.render.fps
        scene.frame_set(int(frame), subframe=frame - int(frame))
        for sheet in cloths:
            masses = [i for i, place in motion.places.items() if place[0] == sheet]
            x, y, z = motion.position[number][masses].T
            worst = max(worst, np.abs(places_now(bpy.data.objects[sheet]) - np.stack([x, -z, y], 1)).max())
    assert worst < 4 * epsilon, f"glb: off by {worst} m"
    return worst


print(f"Blender {bpy.app.version_string}: {len(motion.frames)} frames are as the CSV says: pc2 within "
      f"{check_pc2():.1e} m, glb within {check_glb():.1e} m")
