# SPDX-License-Identifier: BSD-3-Clause
"""Draws a result file into a PNG with ParaView:

    xvfb-run -a pvbatch render.py FILE.hdf OUT.png [ARRAY] [--from X,Y,Z] [--step I] [--size W,H] [--width PX]

ARRAY is point or cell data; without it the depth (z). A vector is coloured by its magnitude. The camera looks from
the direction --from (default -0.6,-1,0.5) at the whole model, z up. --step counts states in order of time and
needs ParaView 5.12 or newer; older ones show the newest.
"""
import argparse
import sys

from paraview import simple as pv


def parse(argv):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    numbers = lambda text: [float(word) for word in text.split(",")]
    parser.add_argument("file")
    parser.add_argument("png")
    parser.add_argument("array", nargs="?")
    parser.add_argument("--from", dest="direction", type=numbers, default=[-0.6, -1.0, 0.5])
    parser.add_argument("--step", type=int)
    parser.add_argument("--size", type=numbers, default=[1400, 900])
    parser.add_argument("--width", type=float, default=4.0, help="of lines, in pixels")
    # argparse would read a value such as "-1,0,0" as an option
    joined, words = [], iter(argv)
    for word in words:
        joined.append(f"{word}={next(words, '')}" if word == "--from" else word)
    return parser.parse_args(joined)


def open_result(options):
    reader = pv.VTKHDFReader(FileName=options.file)
    reader.UpdatePipeline()
    times = list(getattr(reader, "TimestepValues", None) or [])
    if options.step is not None and not times:
        sys.exit("this ParaView shows the newest state only: leave --step out")
    time = times[options.step] if options.step is not None else times[-1] if times else None
    if time is not None:
        reader.UpdatePipeline(time)
    return reader, time


def with_depth(reader):
    depth = pv.Calculator(Input=reader, ResultArrayName="z [m]", Function="coordsZ")
    depth.UpdatePipeline()
    return depth, "POINTS", "z [m]"


def find_array(reader, name):
    if not name:
        return with_depth(reader)
    for where, arrays in (("POINTS", reader.PointData), ("CELLS", reader.CellData)):
        if name in arrays.keys():
            return reader, where, name
    known = sorted(set(reader.PointData.keys()) | set(reader.CellData.keys()))
    sys.exit(f"no array '{name}'; there are: {', '.join(known)}")


def show(source, where, name, view, width):
    """Draws the cells with fine edges, and lines and vertices again on top, thick."""
    thin = draw(source, where, name, view, "Surface With Edges", 1.0)
    thin.EdgeColor = [0.35, 0.35, 0.35]
    ropes = pv.ExtractCellsByType(Input=source)
    ropes.CellTypes = ["Line", "Polyline", "Vertex"]
    ropes.UpdatePipeline()
    if ropes.GetDataInformation().GetNumberOfCells():
        draw(ropes, where, name, view, "Surface", width).PointSize = 2.5 * width
    # the range of the colours is that of the whole model, not of the ropes that are drawn last
    information = source.PointData if where == "POINTS" else source.CellData
    array = information[name]
    span = array.GetRange(-1 if array.GetNumberOfComponents() > 1 else 0)
    colours = pv.GetColorTransferFunction(name)
    colours.RescaleTransferFunction(*span)
    thin.SetScalarBarVisibility(view, True)
    bar = pv.GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = name, ""
    bar.TitleColor = bar.LabelColor = [0.0, 0.0, 0.0]
    bar.TitleFontSize = bar.LabelFontSize = 18
    bar.WindowLocation, bar.Position, bar.ScalarBarLength = "Any Location", [0.9, 0.2], 0.6
    bar.AutomaticLabelFormat, bar.LabelFormat, bar.RangeLabelFormat = 0, "%-#.4g", "%-#.4g"
    return span


def draw(source, where, name, view, representation, width):
    display = pv.Show(source, view)
    display.SetRepresentationType(representation)
    display.LineWidth = width
    pv.ColorBy(display, (where, name))
    return display


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    length = sum(x * x for x in a) ** 0.5 or 1.0
    return [x / length for x in a]


def look(view, source, direction):
    """Sets a parallel projection into which the bounding box of the model just fits, left of the colour bar."""
    box = source.GetDataInformation().GetBounds()
    toward = unit(direction)
    up = [0.0, 1.0, 0.0] if abs(toward[2]) > 0.999 else [0.0, 0.0, 1.0]
    right = unit(cross(up, toward))
    up = cross(toward, right)
    corners = [(box[i], box[2 + j], box[4 + k]) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
    spans = [[sum(c * a for c, a in zip(corner, axis)) for corner in corners] for axis in (right, up, toward)]
    middle = [(min(span) + max(span)) / 2 for span in spans]
    half_width, half_height, half_depth = ((max(span) - min(span)) / 2 for span in spans)
    aspect = view.ViewSize[0] / view.ViewSize[1]
    scale = 1.08 * max(half_height, half_width / (aspect * 0.85)) or 1.0
    middle[0] += 0.12 * scale * aspect  # leaves room for the colour bar
    centre = [sum(m * axis[i] for m, axis in zip(middle, (right, up, toward))) for i in range(3)]
    view.CameraParallelProjection = 1
    view.CameraFocalPoint = centre
    view.CameraPosition = [c + (4 * half_depth + 4 * scale) * d for c, d in zip(centre, toward)]
    view.CameraViewUp = up
    view.CameraParallelScale = scale
    pv.Render(view)


def main(argv):
    options = parse(argv)
    reader, time = open_result(options)
    source, where, name = find_array(reader, options.array)
    view = pv.CreateView("RenderView")
    view.ViewSize = [int(s) for s in options.size]
    view.UseColorPaletteForBackground = 0
    view.Background = [1, 1, 1]
    view.OrientationAxesLabelColor = [0, 0, 0]
    if time is not None:
        view.ViewTime = time
    low, high = show(source, where, name, view, options.width)
    look(view, source, options.direction)
    pv.SaveScreenshot(options.png, view, ImageResolution=view.ViewSize)
    print(f"{options.png}: {name} from {low:g} to {high:g}" + (f" at time {time:g}" if time is not None else ""))


if __name__ == "__main__":
    main(sys.argv[1:])
