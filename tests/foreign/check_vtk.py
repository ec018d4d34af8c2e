"""Holds vtp, ply and obj, as VTK's own readers read them, against the CSV: check_vtk.py FOLDER CLOTH…"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from motion_of_csv import Motion, same_faces, same_lines, same_numbers

folder, cloths = Path(sys.argv[1]), sys.argv[2:]
motion = Motion(folder, cloths)


def read(reader, file):
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(file))
    reader.SetFileName(str(file))
    reader.Update()
    assert not failures and reader.GetErrorCode() == 0, f"VTK can't read {file}"
    return reader.GetOutput()


def cells(array):
    ends = vtk_to_numpy(array.GetOffsetsArray()).tolist()
    masses = vtk_to_numpy(array.GetConnectivityArray()).tolist()
    return [masses[a:b] for a, b in zip(ends, ends[1:])]


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


for number, (frame, time) in enumerate(zip(motion.frames, motion.times)):
    faces, lines, lone = motion.shape(number)
    faces = [face for sheet in faces.values() for face in sheet]
    name = f"frame-{frame:06d}"
    vtp = read(vtk.vtkXMLPolyDataReader(), folder / "vtp" / f"{name}.vtp")
    assert vtp.GetFieldData().GetArray("TimeValue").GetValue(0) == time
    same_numbers(points(vtp), motion.position[number], name)
    same_numbers(vtk_to_numpy(vtp.GetPointData().GetArray("velocity")), motion.velocity[number], name)
    same_faces(cells(vtp.GetPolys()), faces, name)
    same_lines(cells(vtp.GetLines()), lines, name)
    assert [cell[0] for cell in cells(vtp.GetVerts())] == lone
    tension = vtk_to_numpy(vtp.GetCellData().GetArray("tension"))[len(lone):len(lone) + len(lines)]
    links = vtk_to_numpy(vtp.GetCellData().GetArray("link"))[len(lone):len(lone) + len(lines)]
    same_numbers(tension, motion.tension[number][links], name)
    # VTK reads both of these in single precision.
    single = motion.position[number].astype("<f4")
    for reader, ending in ((vtk.vtkPLYReader(), "ply"), (vtk.vtkOBJReader(), "obj")):
        data = read(reader, folder / ending / f"{name}.{ending}")
        same_numbers(points(data), single, f"{name}.{ending}")
        same_faces(cells(data.GetPolys()), faces, f"{name}.{ending}")
    same_lines(cells(data.GetLines()), lines, f"{name}.obj")
    assert [cell[0] for cell in cells(data.GetVerts())] == lone
listed = ElementTree.parse(folder / "vtp" / "motion.pvd").iter("DataSet")
same_numbers([float(entry.get("timestep")) for entry in listed], motion.times, "motion.pvd")
print(f"VTK {vtk.VTK_VERSION}: vtp exactly, ply and obj in single precision: {len(motion.frames)} frames are as the "
      "CSV says")
