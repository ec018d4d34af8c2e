"""Holds npz, vtp and pc2 against the CSV: check_arrays.py FOLDER CLOTH… It reads them by NumPy and what their
formats' descriptions say."""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pandas as pd

from motion_of_csv import Motion, same_faces, same_lines, same_numbers

folder, cloths = Path(sys.argv[1]), sys.argv[2:]
motion = Motion(folder, cloths)


def check_npz():
    arrays = np.load(folder / "motion.npz")
    same_numbers(arrays["frame"], motion.frames, "frame")
    same_numbers(arrays["time"], motion.times, "time")
    assert list(arrays["name"]) == motion.names, "names differ"
    for name in ("position", "velocity", "tension", "rest_length", "broken"):
        wanted = getattr(motion, name)
        if name == "tension":
            wanted = np.where(motion.broken, np.nan, wanted)
        same_numbers(arrays[name], wanted, name)
    same_numbers(arrays["link_ends"], motion.ends, "link_ends")
    last = motion.broken_at[-1]
    same_numbers(arrays["broken_at"], np.where(np.isnan(last), np.inf, last), "broken_at")
    assert np.isfinite(arrays["mass"]).all() and arrays["pinned"].dtype == bool
    families = {"structural": False, "diagonals": True, "skip_one": True}
    same_numbers([families[f] for f in arrays["link_family"]],
                 [motion._holds_shape(i) for i in range(len(motion.ends))], "link_family")
    quads = motion.shape(0)[0]
    assert len(arrays["triangles"]) >= 2 * sum(len(faces) for faces in quads.values()) and motion.frames[0] == 1


def check_tables():
    for table, columns in (("energy", ["kinetic", "potential", "elastic", "total", "pin_work", "load_work",
                                       "contact_work", "broken_energy"]),
                           ("orientations", ["qw", "qx", "qy", "qz"])):
        csv = pd.read_csv(folder / f"{table}.csv", float_precision="round_trip")
        arrays = np.load(folder / f"{table}.npz")
        if table == "energy":
            for column in columns:
                same_numbers(arrays[column], csv[column].to_numpy(), column)
            same_numbers(csv["total"], csv["kinetic"] + csv["potential"] + csv["elastic"], "total")
        else:
            same_numbers(arrays["orientation"], csv[columns].to_numpy().reshape(len(motion.frames), -1, 4), table)


class Vtp:
    """A file of VTK's XML format whose arrays lie raw behind it: eight bytes for how long each is, and it."""

    types = {"Float64": "<f8", "Int64": "<i8", "Int8": "<i1"}

    def __init__(self, file):
        head, _, self.raw = file.read_bytes().partition(b'<AppendedData encoding="raw">\n_')
        self.tree = ElementTree.fromstring(head + b"</VTKFile>")
        assert self.tree.get("header_type") == "UInt64" and self.tree.get("byte_order") == "LittleEndian"
        self.piece = self.tree.find("PolyData/Piece")
        assert self.raw[self._end():].split() == [b"</AppendedData>", b"</VTKFile>"]

    def _end(self):
        offsets = [int(e.get("offset")) for e in self.tree.iter("DataArray") if e.get("format") == "appended"]
        return max(offset + 8 + int.from_bytes(self.raw[offset:offset + 8], "little") for offset in offsets)

    def array(self, element, name):
        array = self.piece.find(f"{element}/DataArray[@Name='{name}']")
        offset = int(array.get("offset"))
        size = int.from_bytes(self.raw[offset:offset + 8], "little")
        numbers = np.frombuffer(self.raw[offset + 8:offset + 8 + size], self.types[array.get("type")])
        components = int(array.get("NumberOfComponents"))
        return numbers.reshape(-1, components) if components > 1 else numbers

    def cells(self, element):
        ends = self.array(element, "offsets")
        assert len(ends) == int(self.piece.get(f"NumberOf{element}"))
        masses = self.array(element, "connectivity").tolist()
        return [masses[begin:end] for begin, end in zip([0, *ends[:-1]], ends)]


def listed(name):
    return [(float(e.get("timestep")), folder / "vtp" / e.get("file"))
            for e in ElementTree.parse(folder / "vtp" / name).iter("DataSet")]


def check_vtp():
    same_numbers([time for time, _ in listed("motion.pvd")], motion.times, "times in motion.pvd")
    for number, (time, file) in enumerate(listed("motion.pvd")):
        vtp = Vtp(file)
        faces, lines, points = motion.shape(number)
        assert float(vtp.tree.find("PolyData/FieldData/DataArray").text) == time
        same_numbers(vtp.array("Points", "position"), motion.position[number], file.name)
        same_numbers(vtp.array("PointData", "velocity"), motion.velocity[number], file.name)
        same_faces(vtp.cells("Polys"), [face for sheet in faces.values() for face in sheet], file.name)
        same_lines(vtp.cells("Lines"), lines, file.name)
        assert [cell[0] for cell in vtp.cells("Verts")] == points, f"{file.name}: points differ"
    same_numbers([time for time, _ in listed("links.pvd")], motion.times, "times in links.pvd")
    for number, (time, file) in enumerate(listed("links.pvd")):
        vtp = Vtp(file)
        whole = np.flatnonzero(~motion.broken[number])
        same_numbers(vtp.array("CellData", "link"), whole, file.name)
        same_numbers(np.array(vtp.cells("Lines")), motion.ends[whole], file.name)
        same_numbers(vtp.array("CellData", "tension"), motion.tension[number][whole], file.name)
        same_numbers(vtp.array("CellData", "strain"), motion.strain[number][whole], file.name)


def check_pc2():
    cache = (folder / "pc2" / "motion.pc2").read_bytes()
    head = np.frombuffer(cache[12:32], "<i4")
    rates = np.frombuffer(cache[20:28], "<f4")
    faces, _, lone = motion.shape(0)
    of_mesh = [mass for mass in range(len(motion.names)) if mass not in lone]
    count, masses = len(motion.frames), len(of_mesh)
    assert cache[:12] == b"POINTCACHE2\0" and head[0] == 1
    assert (head[1], head[4]) == (masses, count) and list(rates) == [1.0, 1.0]
    points = np.frombuffer(cache[32:], "<f4").reshape(count, masses, 3)
    same_numbers(points, motion.position[:, of_mesh].astype("<f4"), "motion.pc2")
    lines = (folder / "pc2" / "mesh.obj").read_text().splitlines()
    vertices = [[float(word) for word in line.split()[1:]] for line in lines if line.startswith("v ")]
    same_numbers(vertices, motion.position[0][of_mesh], "mesh.obj")
    same_faces([[of_mesh[int(word) - 1] for word in line.split()[1:]] for line in lines if line.startswith("f ")],
               [face for sheet in faces.values() for face in sheet], "mesh.obj")


for check in (check_npz, check_tables, check_vtp, check_pc2):
    check()
print(f"npz, vtp, pc2: {len(motion.frames)} frames of {len(motion.names)} masses are as the CSV says")
