# SPDX-License-Identifier: BSD-3-Clause
"""Shows the temperature fields of this folder (field.pvd) in ParaView 5.9 or later.

In ParaView:  File > Load State, and choose this file.  Or: paraview --state=field_view.py
A picture:    pvbatch field_view.py PICTURE.png [SECONDS]

The folder may be moved. This file is written by `tiretherm run` and replaced by the next run into this folder.
"""
import os
import sys

from paraview.simple import *

# VALUES OF THE RUN
TEMPERATURE = "temperature [degC]"
SOLID = KIND in ("ring", "block")
INK = [0.1, 0.1, 0.1]
BODY = (0.6, 0.45)  # ambient and diffuse light


def folder():
    """Where this file is; ParaView's option --script does not say it: then the folder that it was started in."""
    places = [os.path.dirname(os.path.abspath(__file__))] if "__file__" in globals() else []
    for place in [*places, os.getcwd()]:
        if os.path.exists(os.path.join(place, "field.pvd")):
            return place
    raise RuntimeError("field.pvd is not beside field_view.py: use File > Load State, or paraview --state=field_view.py")


def give_names(array, names):
    """Layers and zones are coloured and named by their numbers."""
    okabe_ito = [0x0072B2, 0xE69F00, 0x009E73, 0xCC79A7, 0x56B4E9, 0xD55E00, 0xF0E442, 0x999999]
    colours = GetColorTransferFunction(array)
    colours.InterpretValuesAsCategories = 1
    colours.AnnotationsInitialized = 1
    colours.Annotations = [text for i, name in enumerate(names) for text in (str(i), name)]
    rgb = [okabe_ito[i % len(okabe_ito)] for i in range(len(names))]
    colours.IndexedColors = [(colour >> shift & 255) / 255 for colour in rgb for shift in (16, 8, 0)]


def show_field(source, view, association):
    display = Show(source, view)
    ColorBy(display, (association, TEMPERATURE))
    display.SetScalarBarVisibility(view, True)
    display.Ambient, display.Diffuse = BODY if SOLID else (1.0, 0.0)  # a plane in its true colours
    return display


def far_half(source, name):
    """What is beyond y = 0, so that one looks onto the cut."""
    half = Clip(registrationName=name, Input=source, ClipType="Plane")
    half.ClipType.Origin, half.ClipType.Normal, half.Invert = [0.0, 0.0, 0.0], [0.0, 1.0, 0.0], 0
    return half


def hide_field(source, view, association):
    """Ready in the pipeline: a click on its eye shows it."""
    display = show_field(source, view, association)
    display.Ambient, display.Diffuse = BODY
    Hide(source, view)


def show_text(view, name, text, where, size):
    source = Text(registrationName=name, Text=text)
    display = Show(source, view)
    display.WindowLocation = "Any Location" if view_has_any_location(display) else display.WindowLocation
    display.Position = where
    display.FontSize, display.Color = size, INK


def view_has_any_location(display):
    """From version 5.10 on; "AnyLocation" before."""
    return "Any Location" in display.GetProperty("WindowLocation").Available


def show_time(source, view):
    words = ('("%d h " % (time_value // 3600) if time_value >= 3600 else "") + '
             '("%d min " % (time_value % 3600 // 60) if time_value >= 60 else "") + "%g s" % round(time_value % 60, 3)')
    annotation = PythonAnnotation(registrationName="time", Input=source, Expression=words)
    display = Show(annotation, view)
    display.WindowLocation = "Any Location" if view_has_any_location(display) else display.WindowLocation
    display.Position = [0.03, 0.88]
    display.FontSize, display.Color = 14, INK


def show_axes(view):
    """A frame in metres with ticks, of x and z around a plane; a line has none."""
    grid = view.AxesGrid
    grid.Visibility = 1
    tire = KIND in ("section", "ring")
    grid.XTitle = "from the centre plane / m" if tire else "x / m"
    grid.YTitle = "y / m"
    grid.ZTitle = "radius / m" if KIND == "section" else "z / m"
    grid.ShowGrid = 0
    for axis in "XYZ":
        for part in ("Title", "Label"):
            setattr(grid, axis + part + "Color", INK)
            setattr(grid, axis + part + "FontSize", 14)
    grid.GridColor = [0.5, 0.5, 0.5]
    if not SOLID:
        grid.AxesToLabel = 1 + 4 + 8 + 32


def look(view, bounds):
    """Straight onto a plane, obliquely at a body, from the side of y < 0: outboard is on the left."""
    middle = [0.5 * (bounds[2 * i] + bounds[2 * i + 1]) for i in range(3)]
    size = max(bounds[2 * i + 1] - bounds[2 * i] for i in range(3))
    towards = [0.55, -1.0, 0.45] if SOLID else [0.0, -1.0, 0.0]
    view.CameraPosition = [m + 4.0 * size * t for m, t in zip(middle, towards)]
    view.CameraFocalPoint = middle
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.CameraParallelProjection = 1
    wide, high = bounds[1] - bounds[0], bounds[5] - bounds[4]
    shape = view.ViewSize[0] / max(view.ViewSize[1], 1)
    view.CameraParallelScale = (0.8 * size if SOLID else max(0.75 * high, 0.7 * wide / shape))


def main():
    here = folder()
    field = PVDReader(registrationName="field.pvd", FileName=os.path.join(here, "field.pvd"))
    field.UpdatePipeline(END)
    association = "POINTS" if field.PointData.GetArray(TEMPERATURE) is not None else "CELLS"
    bounds = field.GetDataInformation().GetBounds()

    view = GetActiveViewOrCreate("RenderView")
    view.Background = [1.0, 1.0, 1.0]
    if hasattr(view, "UseColorPaletteForBackground"):
        view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 1 if SOLID else 0

    colours = GetColorTransferFunction(TEMPERATURE)
    colours.ApplyPreset("Inferno (matplotlib)", True)
    give_names("layer", LAYERS)
    if ZONES:
        give_names("zone", ZONES)

    shown = far_half(field, "half of the " + KIND) if SOLID else field
    display = show_field(shown, view, association)
    if KIND == "nodes":
        display.PointSize, display.RenderPointsAsSpheres = 60.0, 1
    if KIND == "layers":
        display.LineWidth = 40.0
    if SOLID:
        hide_field(field, view, association)
    elif KIND in ("section", "disc"):
        outside = ExtractSurface(registrationName="plane", Input=field)
        body = RotationalExtrusion(registrationName="whole tire" if KIND == "section" else "whole specimen", Input=outside)
        body.Resolution, body.Angle = 90, 270.0 if KIND == "section" else 180.0
        body.RotationAxis = [1.0, 0.0, 0.0] if KIND == "section" else [0.0, 0.0, 1.0]
        Hide(outside, view)
        hide_field(body, view, association)

    lines = os.path.join(here, "field_borders.vtu")
    if os.path.exists(lines):
        borders = XMLUnstructuredGridReader(registrationName="borders of layers and zones", FileName=[lines])
        display = Show(far_half(borders, "half of the borders") if SOLID else borders, view)
        display.AmbientColor = display.DiffuseColor = [1.0, 1.0, 1.0] if not SOLID else INK
        display.LineWidth = 1.5

    # One scale over all times; after the first Show, which takes that of the first time.
    colours.AutomaticRescaleRangeMode = "Never"
    colours.RescaleTransferFunction(LOWEST, HIGHEST if HIGHEST > LOWEST else LOWEST + 1.0)
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "temperature / °C", ""
    bar.TitleColor = bar.LabelColor = INK
    bar.TitleFontSize, bar.LabelFontSize, bar.ScalarBarThickness = 16, 14, 18
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-#.4g", "%-#.4g"
    bar.Visibility = 1
    show_text(view, "title", TITLE, [0.03, 0.94], 18)
    if KIND in ("nodes", "layers"):
        show_text(view, "depth", "outer surface above, %.4g mm deep" % (1e3 * (bounds[5] - bounds[4])), [0.03, 0.82], 14)
    if STEADY:
        show_text(view, "state", "steady state", [0.03, 0.88], 14)
    else:
        show_time(field, view)
        show_text(view, "hottest", "hottest of all times: %.1f °C at %g s" % (HIGHEST, HOTTEST_TIME), [0.03, 0.02], 12)
    show_axes(view)
    Render(view)  # the first one sets the camera itself
    look(view, bounds)

    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    GetTimeKeeper().Time = scene.AnimationTime = END
    SetActiveSource(field)
    Render(view)
    return view


def save(view, picture, seconds):
    GetAnimationScene().AnimationTime = seconds
    view.ViewTime = seconds
    view.ViewSize = [1200, 900]
    SaveScreenshot(picture, view, ImageResolution=[1200, 900])


shown_view = main()
if len(sys.argv) > 1 and sys.argv[1].endswith(".png"):
    save(shown_view, sys.argv[1], float(sys.argv[2]) if len(sys.argv) > 2 else END)
