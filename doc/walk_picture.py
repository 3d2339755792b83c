#!/usr/bin/env python3
"""Makes a picture of walk.md: walk_picture.py FOLDER PICTURE.png. FOLDER is that of a 3D run on one rank. With VTK (python3-vtk9); without a screen by xvfb-run.

As ParaView does: Warp By Vector (displacement, 20 times), coloured by von_mises, Surface With Edges.
"""
import sys

import vtk

folder, picture = sys.argv[1:3]
reader = vtk.vtkXMLUnstructuredGridReader()
reader.SetFileName(f"{folder}/bodies_0000.0.vtu")

warp = vtk.vtkWarpVector()
warp.SetInputConnection(reader.GetOutputPort())
warp.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "displacement")
warp.SetScaleFactor(20)

colours = vtk.vtkLookupTable()
colours.SetHueRange(0.667, 0)
mapper = vtk.vtkDataSetMapper()
mapper.SetInputConnection(warp.GetOutputPort())
mapper.SetScalarModeToUsePointFieldData()
mapper.SelectColorArray("von_mises")
mapper.SetScalarRange(0, 250)
mapper.SetLookupTable(colours)
actor = vtk.vtkActor()
actor.SetMapper(mapper)
actor.GetProperty().EdgeVisibilityOn()
actor.GetProperty().SetEdgeColor(0.3, 0.3, 0.3)

bar = vtk.vtkScalarBarActor()
bar.SetLookupTable(colours)
bar.SetTitle("von_mises\n")
bar.SetNumberOfLabels(6)
bar.SetLabelFormat("%.0f")
bar.UnconstrainedFontSizeOn()
for text in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
    text.SetColor(0, 0, 0)
    text.SetFontSize(12)
    text.ItalicOff()
bar.SetPosition(0.02, 0.03)
bar.SetWidth(0.1)
bar.SetHeight(0.42)

renderer = vtk.vtkRenderer()
renderer.SetBackground(1, 1, 1)
renderer.AddActor(actor)
renderer.AddActor(bar)
window = vtk.vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(680, 360)
window.AddRenderer(renderer)
camera = renderer.GetActiveCamera()
camera.SetPosition(40, 60, 90)
camera.SetFocalPoint(-14, 8, 3)
camera.SetViewUp(0, 1, 0)
renderer.ResetCamera()
camera.Zoom(1.75)
renderer.ResetCameraClippingRange()
window.Render()

image = vtk.vtkWindowToImageFilter()
image.SetInput(window)
writer = vtk.vtkPNGWriter()
writer.SetFileName(picture)
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
