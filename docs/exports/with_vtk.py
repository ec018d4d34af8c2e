"""Three frames of an exported series, drawn by VTK and coloured by speed:
with_vtk.py motion.pvd PICTURE.png SECONDS…"""

import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

series, picture, times = Path(sys.argv[1]), sys.argv[2], [float(time) for time in sys.argv[3:]]
listed = [(float(entry.get("timestep")), entry.get("file")) for entry in ElementTree.parse(series).iter("DataSet")]

colours = vtk.vtkColorTransferFunction()
for speed, colour in ((0.0, (0.20, 0.28, 0.52)), (0.35, (0.22, 0.54, 0.70)), (0.7, (0.60, 0.80, 0.64)),
                      (1.0, (0.98, 0.88, 0.58))):
    colours.AddRGBPoint(speed, *colour)

window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(1600, 620)
window.SetMultiSamples(8)
for number, time in enumerate(times):
    moment, file = min(listed, key=lambda entry: abs(entry[0] - time))
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(series.parent / file))
    reader.Update()
    data = reader.GetOutput()
    speed = numpy_to_vtk(np.linalg.norm(vtk_to_numpy(data.GetPointData().GetArray("velocity")), axis=1))
    speed.SetName("speed")
    data.GetPointData().SetScalars(speed)
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(data)
    normals.SplittingOff()
    smooth = vtk.vtkLoopSubdivisionFilter()
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(normals.GetOutputPort())
    smooth.SetInputConnection(triangles.GetOutputPort())
    smooth.SetNumberOfSubdivisions(1)
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(smooth.GetOutputPort())
    mapper.SetLookupTable(colours)
    mapper.InterpolateScalarsBeforeMappingOn()
    cloth = vtk.vtkActor()
    cloth.SetMapper(mapper)
    cloth.GetProperty().SetInterpolationToPhong()
    cloth.GetProperty().SetAmbient(0.25)
    cloth.GetProperty().SetDiffuse(0.85)
    cloth.GetProperty().SetSpecular(0.15)
    renderer = vtk.vtkRenderer()
    renderer.SetViewport(number / len(times), 0.0, (number + 1) / len(times), 1.0)
    renderer.SetBackground(0.93, 0.94, 0.95)
    renderer.AddActor(cloth)
    label = vtk.vtkTextActor()
    label.SetInput(f"{moment:.2f} s")
    label.GetTextProperty().SetColor(0.2, 0.2, 0.2)
    label.GetTextProperty().SetFontSize(30)
    label.SetPosition(24, 20)
    renderer.AddActor2D(label)
    for place, strength in (((-3.0, 4.0, 5.0), 0.55), ((4.0, 2.0, 4.0), 0.3), ((0.0, 0.5, 6.0), 0.15)):
        light = vtk.vtkLight()
        light.SetPosition(*place)
        light.SetFocalPoint(0.0, 1.2, 0.0)
        light.SetIntensity(strength)
        renderer.AddLight(light)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(0.8, 1.6, 8.0)
    camera.SetFocalPoint(0.0, 1.2, 0.0)
    camera.SetViewAngle(25.0)
    renderer.ResetCameraClippingRange()
    window.AddRenderer(renderer)
window.Render()
grabber = vtk.vtkWindowToImageFilter()
grabber.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetFileName(picture)
writer.SetInputConnection(grabber.GetOutputPort())
writer.Write()
