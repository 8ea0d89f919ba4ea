#!/usr/bin/env python3
# Copyright (c) 2026 The authors of Delaunay_from_surface_3
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Renders the pictures of the manual from what the programs of the project write. The target `renders` of CMake calls
it. Needs Python with VTK 9, NumPy and Pillow (Debian: python3-vtk9 python3-numpy python3-pil) and a display, such as
that of xvfb-run.

  render.py INPUTS OUTPUTS [PICTURE...]

In the folder INPUTS are
  elephant.vtu    delaunay_from_surface elephant.off --mark-inside --output elephant.vtu
  elephant.off    that mesh
  fine.vtu        the same of refined_elephant.off, for the medial axis
  nets.vtk, first_round.vtk, path.vtk     write_scenes elephant.off INPUTS
  cut.vtk         write_cut_and_subgraph genus_3.off cut.vtk
  elephant_surface.off                    reconstruct_surface elephant.off elephant_surface.off
"""

import argparse
import os

import numpy as np
import vtk
from PIL import Image
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

ORANGE, BLUE, STEEL, RED, GREY, INK = (
    (1.0, 0.66, 0.22), (0.72, 0.82, 0.93), (0.20, 0.38, 0.60), (0.80, 0.13, 0.16), (0.86, 0.87, 0.89),
    (0.16, 0.20, 0.27))
FINER = 2  # pixels that become one, in each direction


def save_small(picture, file_name, largest=30000):
    """As well as fits into so many bytes: first quality goes down, then size."""
    for share in (1, 0.8, 0.65, 0.55, 0.45):
        size = [round(share * side) for side in picture.size]
        smaller = picture.convert("RGBa").resize(size, Image.LANCZOS).convert("RGBA")
        for quality in (84, 66, 50, 35):
            smaller.save(file_name, quality=quality, alpha_quality=40, method=6)
            if os.path.getsize(file_name) < largest:
                return


class Scene:
    """One picture, without a background: it is rendered before black and before white, and the difference tells how
    much of the background is seen."""

    def __init__(self, width, height, panels=1):
        self.size = width, height
        self.window = vtk.vtkRenderWindow()
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(int(FINER * width), int(FINER * height))
        self.window.SetAlphaBitPlanes(1)
        self.renderers = []
        for i in range(panels):
            renderer = vtk.vtkRenderer()
            renderer.SetViewport(i / panels, 0, (i + 1) / panels, 1)
            renderer.RemoveAllLights()
            for place, strength in (((-0.6, 1.0, 1.2), 0.62), ((1.0, 0.1, 0.8), 0.30), ((0, -1, 0.6), 0.16)):
                light = vtk.vtkLight()
                light.SetLightTypeToCameraLight()
                light.SetPosition(*place)
                light.SetIntensity(strength)
                renderer.AddLight(light)
            self.window.AddRenderer(renderer)
            self.renderers.append(renderer)

    def add(self, data, color=None, panel=0, opacity=1.0, edges=None, width=0.5, smooth=False, line_width=None):
        """Data without a colour have one at each cell or point: unsigned char, RGB."""
        mapper = vtk.vtkPolyDataMapper()
        mapper.SetInputData(data)
        mapper.SetScalarVisibility(color is None)
        actor = vtk.vtkActor()
        actor.SetMapper(mapper)
        look = actor.GetProperty()
        if color is not None:
            look.SetColor(*color)
        look.SetOpacity(opacity)
        look.SetAmbient(0.36)
        look.SetDiffuse(0.84)
        look.SetSpecular(0.06)
        if smooth:
            look.SetInterpolationToPhong()
        else:
            look.SetInterpolationToFlat()
        if edges is not None:
            look.EdgeVisibilityOn()
            look.SetEdgeColor(*edges)
            look.SetLineWidth(FINER * width)
        if line_width is not None:
            look.SetLineWidth(FINER * line_width)
        if opacity < 1:
            self.renderers[panel].SetUseDepthPeeling(1)
            self.renderers[panel].SetMaximumNumberOfPeels(8)
        self.renderers[panel].AddActor(actor)

    def look(self, towards, up=(0, 1, 0), zoom=1.0, bounds=None, shift=(0, 0)):
        """All panels from the same side, in parallel projection."""
        for renderer in self.renderers:
            camera = renderer.GetActiveCamera()
            camera.ParallelProjectionOn()
            camera.SetFocalPoint(0, 0, 0)
            camera.SetPosition(*(-np.asarray(towards, float)))
            camera.SetViewUp(*up)
            renderer.ResetCamera(*([bounds] if bounds else []))
            camera.Zoom(zoom)
            camera.SetWindowCenter(*shift)

    def pixels(self, background):
        for renderer in self.renderers:
            renderer.SetBackground(*background)
        self.window.Render()
        grab = vtk.vtkWindowToImageFilter()
        grab.SetInput(self.window)
        grab.SetInputBufferTypeToRGB()
        grab.ReadFrontBufferOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1].astype(float)

    def write(self, file_name, on_white=False):
        dark, light = self.pixels((0, 0, 0)), self.pixels((1, 1, 1))
        alpha = 1 - np.clip((light - dark).mean(axis=2) / 255, 0, 1)
        color = np.where(alpha[..., None] > 0, dark / np.maximum(alpha, 1e-6)[..., None], 0)
        rgba = np.dstack([np.clip(color, 0, 255), 255 * alpha]).round().astype(np.uint8)
        small = Image.fromarray(rgba, "RGBA").convert("RGBa").resize(self.size, Image.LANCZOS).convert("RGBA")
        small = small.crop(small.getchannel("A").point(lambda a: 255 if a > 3 else 0).getbbox())
        if on_white:  # half the bytes
            small = Image.alpha_composite(Image.new("RGBA", small.size, "white"), small)
        save_small(small, file_name)
        print(f"{file_name}: {small.size[0]} x {small.size[1]}, {os.path.getsize(file_name) / 1000:.0f} kB")


# --- data ---

def read(folder, name):
    reader = {".vtu": vtk.vtkXMLUnstructuredGridReader, ".vtk": vtk.vtkGenericDataObjectReader}[name[-4:]]()
    reader.SetFileName(os.path.join(folder, name))
    reader.Update()
    data = reader.GetOutput()
    if data is None or data.GetNumberOfPoints() == 0:
        raise SystemExit(f"render.py: cannot read {name} in {folder}")
    return data


def read_off(file_name):
    """Points and triangles."""
    with open(file_name, encoding="utf-8") as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    points, faces = int(words[1]), int(words[2])
    places = np.array(words[4:4 + 3 * points], float).reshape(-1, 3)
    return places, np.array(words[4 + 3 * points:4 + 3 * points + 4 * faces], int).reshape(-1, 4)[:, 1:]


def points_of(data):
    return vtk_to_numpy(data.GetPoints().GetData()).astype(float)


def corners_of(grid):
    """Four numbers of points for each tetrahedron."""
    return vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 4)


def cell_data(grid, name):
    return vtk_to_numpy(grid.GetCellData().GetArray(name))


def polydata(points, polygons):
    """Polygons are an array with a row each, or a list of lists."""
    data, places, cells = vtk.vtkPolyData(), vtk.vtkPoints(), vtk.vtkCellArray()
    places.SetData(numpy_to_vtk(np.ascontiguousarray(points, float), deep=1))
    data.SetPoints(places)
    if isinstance(polygons, np.ndarray):
        ends = np.arange(0, polygons.size + 1, polygons.shape[1])
        cells.SetData(numpy_to_vtkIdTypeArray(ends, deep=1), numpy_to_vtkIdTypeArray(polygons.ravel().astype(np.int64),
                                                                                     deep=1))
    else:
        for polygon in polygons:
            cells.InsertNextCell(len(polygon), polygon)
    data.SetPolys(cells)
    return data


def smooth(surface):
    normals = vtk.vtkPolyDataNormals()
    normals.SetInputData(surface)
    normals.SplittingOff()
    normals.ConsistencyOff()
    normals.Update()
    return normals.GetOutput()


FACETS = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))


def tetrahedra(points, corners, size=1.0):
    """Their facets, each cell drawn smaller around its centre, all seen from outside."""
    places = points[corners]
    centers = places.mean(axis=1, keepdims=True)
    places = centers + size * (places - centers)
    turned = np.einsum("ij,ij->i", np.cross(places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]),
                       places[:, 3] - places[:, 0]) < 0
    numbers = np.arange(4 * len(corners)).reshape(-1, 4)
    numbers[turned] = numbers[turned][:, [0, 2, 1, 3]]
    return polydata(places.reshape(-1, 3), numbers[:, FACETS].reshape(-1, 3))


def balls(places, radius):
    """A ball at each place."""
    ball = vtk.vtkSphereSource()
    ball.SetRadius(radius)
    ball.SetThetaResolution(20)
    ball.SetPhiResolution(14)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(polydata(places, []))
    glyphs.SetSourceConnection(ball.GetOutputPort())
    glyphs.ScalingOff()
    glyphs.Update()
    return glyphs.GetOutput()


def tubes(lines, radius):
    """Around the lines of polydata."""
    clean = vtk.vtkPolyData()
    clean.SetPoints(lines.GetPoints())
    clean.SetLines(lines.GetLines())
    tube = vtk.vtkTubeFilter()
    tube.SetInputData(clean)
    tube.SetRadius(radius)
    tube.SetNumberOfSides(10)
    tube.CappingOn()
    tube.Update()
    return tube.GetOutput()


def diameter(points):
    return float(np.linalg.norm(points.max(axis=0) - points.min(axis=0)))


# --- pictures ---

def add_cut_open(scene, inputs, panel):
    """A quarter of the surface is taken away, and what is inside there. Cells inside are orange; of those outside the
    shorter ones behind the quarter are shown, in blue."""
    grid = read(inputs, "elephant.vtu")
    places, faces = read_off(os.path.join(inputs, "elephant.off"))
    points, corners = points_of(grid), corners_of(grid)
    depth, side = np.median(places @ VIEW), places[:, 0].min() + 0.56 * np.ptp(places[:, 0])

    def taken_away(centers):
        return (centers @ VIEW < depth) & (centers[:, 0] < side)

    cells = points[corners]
    centers = cells.mean(axis=1)
    inside = cell_data(grid, "inside") > 0
    longest = np.linalg.norm(cells[:, (0, 0, 0, 1, 1, 2)] - cells[:, (1, 2, 3, 2, 3, 3)], axis=2).max(axis=1)
    behind = (cells @ VIEW).max(axis=1) > depth
    outside = ~inside & behind & ~taken_away(centers) & (centers[:, 0] < side) & (longest < 0.15 * diameter(points))
    skin = faces[~taken_away(places[faces].mean(axis=1))]
    scene.add(smooth(polydata(places, skin)), GREY, panel, smooth=True)
    near = inside & ~taken_away(centers) & (centers[:, 0] < side + 0.08 * np.ptp(places[:, 0]))
    scene.add(tetrahedra(points, corners[near], 0.86), ORANGE, panel, edges=(0.62, 0.36, 0.04))
    scene.add(tetrahedra(points, corners[outside], 0.86), BLUE, panel, edges=(0.42, 0.53, 0.66))


VIEW = np.array((-0.10, -0.08, -1.0))  # of the elephant


def cut_open(inputs, file_name):
    scene = Scene(800, 930)
    add_cut_open(scene, inputs, 0)
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name)


def surface_and_cut(inputs, file_name):
    """Left the surface, right the triangulation cut open."""
    places, faces = read_off(os.path.join(inputs, "elephant.off"))
    scene = Scene(1500, 870, panels=2)
    scene.add(polydata(places, faces), GREY, 0, edges=(0.45, 0.50, 0.58), width=0.6)
    add_cut_open(scene, inputs, 1)
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name)


def nets(inputs, file_name):
    """The points of the first rounds, those of the last in orange."""
    data = read(inputs, "nets.vtk")
    points = points_of(data)
    rounds = vtk_to_numpy(data.GetPointData().GetArray("round"))
    last = rounds.max()
    shown = [h for h in range(last + 1) if (rounds <= h).sum() > 30][:4]
    size = diameter(points)
    scene = Scene(1290, 355, panels=len(shown))
    for panel, h in enumerate(shown):
        scene.add(smooth(data), GREY, panel, smooth=True)
        radius = size * (0.016, 0.011, 0.0075, 0.005)[panel]
        scene.add(balls(points[rounds < h], radius), STEEL, panel, smooth=True)
        scene.add(balls(points[rounds == h], radius), ORANGE, panel, smooth=True)
    print("nets:", [(int((rounds <= h).sum()), h) for h in shown], "of", len(points))
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name, on_white=True)


def trace(inputs, file_name):
    """A path of T through the first round's triangulation, and the cells that it enters."""
    grid, path = read(inputs, "first_round.vtk"), read(inputs, "path.vtk")
    places, faces = read_off(os.path.join(inputs, "elephant.off"))
    points, corners = points_of(grid), corners_of(grid)
    entered = cell_data(grid, "entered") > 0
    scene = Scene(700, 870)
    scene.add(smooth(polydata(places, faces)), GREY, opacity=0.28, smooth=True)
    scene.add(tetrahedra(points, corners[entered], 0.97), ORANGE, opacity=0.36, edges=INK, width=0.6)
    scene.add(tubes(path, 0.006 * diameter(points)), RED, smooth=True)
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name)


def cut_and_subgraph(inputs, file_name):
    """Left the cut graph, right the subgraph."""
    data = read(inputs, "cut.vtk")
    part = cell_data(data, "part")  # lines come first
    lines = vtk_to_numpy(data.GetLines().GetConnectivityArray()).reshape(-1, 2)
    faces = vtk_to_numpy(data.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = points_of(data)
    size = diameter(points)
    scene = Scene(1600, 560, panels=2)
    for panel, (number, color, radius) in enumerate(((2, RED, 0.005), (1, STEEL, 0.0028))):
        scene.add(smooth(polydata(points, faces)), GREY, panel, smooth=True)
        chosen = vtk.vtkPolyData()
        chosen.SetPoints(data.GetPoints())
        chosen.SetLines(polydata(points, lines[part[:len(lines)] == number]).GetPolys())
        scene.add(tubes(chosen, radius * size), color, panel, smooth=True)
    scene.look((0, 0.5, -1), zoom=1.5)
    scene.write(file_name)


def circumcenters(places):
    """Of tetrahedra: rows of four places."""
    edges = places[:, 1:] - places[:, :1]
    squares = np.einsum("ijk,ijk->ij", edges, edges)
    flat = np.abs(np.linalg.det(edges)) < 1e-12 * np.prod(np.sqrt(squares), axis=1)
    edges[flat] = np.eye(3)
    centers = places[:, 0] + np.linalg.solve(2 * edges, squares[..., None])[..., 0]
    return centers, ~flat


def medial_polygons(grid, least_ratio):
    """The Voronoi polygons of long Delaunay edges inside: those whose edge is at least this share of the diameter of
    the balls around its ends, as in T. K. Dey, W. Zhao: Approximating the medial axis from the Voronoi diagram with a
    convergence guarantee, 2004. Returns centres, polygons and the radius at each."""
    points, corners = points_of(grid), corners_of(grid)
    inside = cell_data(grid, "inside") > 0
    centers, is_sound = circumcenters(points[corners])
    radii = np.linalg.norm(centers - points[corners[:, 0]], axis=1)
    pairs = np.concatenate([np.sort(corners[:, [a, b]], axis=1)
                            for a, b in ((0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3))])
    cells = np.tile(np.arange(len(corners)), 6)
    keys = pairs[:, 0].astype(np.int64) * len(points) + pairs[:, 1]
    order = np.argsort(keys, kind="stable")
    pairs, cells, keys = pairs[order], cells[order], keys[order]
    starts = np.flatnonzero(np.r_[True, keys[1:] != keys[:-1]])
    ends = np.r_[starts[1:], len(keys)]
    lengths = np.linalg.norm(points[pairs[starts, 1]] - points[pairs[starts, 0]], axis=1)
    is_long = lengths >= least_ratio * 2 * np.minimum.reduceat(radii[cells], starts)
    is_whole = np.logical_and.reduceat((inside & is_sound)[cells], starts) & (ends - starts > 2)
    polygons, values = [], []
    for start, end in zip(starts[is_long & is_whole], ends[is_long & is_whole]):
        polygon = cells[start:end]
        along = points[pairs[start, 1]] - points[pairs[start, 0]]
        u = np.cross(along, np.eye(3)[np.abs(along).argmin()])
        v = np.cross(along, u)
        flat = centers[polygon] - centers[polygon].mean(axis=0)
        turn = np.arctan2(flat @ v / np.linalg.norm(v), flat @ u / np.linalg.norm(u))
        polygons.append(polygon[np.argsort(turn)].tolist())
        values.append(radii[polygon].mean())
    return centers, polygons, np.array(values)


def ramp(values):
    """From blue (small) to orange to red (large), as RGB."""
    stops = np.array([[49, 84, 140], [120, 170, 200], [245, 190, 90], [225, 110, 40], [160, 30, 35]], float)
    share = (values - values.min()) / np.ptp(values) * (len(stops) - 1)
    low = np.minimum(share.astype(int), len(stops) - 2)
    rest = (share - low)[:, None]
    return (stops[low] * (1 - rest) + stops[low + 1] * rest).astype(np.uint8)


def medial_axis(inputs, file_name):
    """Voronoi polygons inside, coloured by the radius of the ball around them, in the translucent surface."""
    grid = read(inputs, "fine.vtu")
    centers, polygons, radii = medial_polygons(grid, 0.5)
    axis = polydata(centers, polygons)
    axis.GetCellData().SetScalars(numpy_to_vtk(ramp(np.minimum(radii, np.quantile(radii, 0.995))), deep=1))
    points = points_of(grid)
    places, faces = read_off(os.path.join(inputs, "elephant.off"))
    scene = Scene(700, 870)
    scene.add(axis)
    scene.add(smooth(polydata(places, faces)), GREY, opacity=0.22, smooth=True)
    scene.look(VIEW, zoom=1.35, bounds=np.column_stack([points.min(axis=0), points.max(axis=0)]).ravel().tolist())
    scene.write(file_name)


def cloud_and_surface(inputs, file_name):
    """Left the points, right the surface that the advancing front makes of them."""
    places, faces = read_off(os.path.join(inputs, "elephant_surface.off"))
    scene = Scene(1500, 870, panels=2)
    scene.add(balls(places, 0.0028 * diameter(places)), STEEL, 0, smooth=True)
    scene.add(polydata(places, faces), GREY, 1, edges=(0.45, 0.50, 0.58), width=0.6)
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name, on_white=True)


def alpha_triangles(points, corners, alpha):
    """The triangles of the alpha complex that do not have tetrahedra of it on both sides."""
    centers, is_sound = circumcenters(points[corners])
    radii = np.where(is_sound, np.linalg.norm(centers - points[corners[:, 0]], axis=1), np.inf)
    facets = np.sort(corners[:, FACETS], axis=2).reshape(-1, 3)
    apexes, balls_of_cells = corners[:, [3, 2, 1, 0]].ravel(), np.repeat(radii, 4)
    triangles, of_facets, counts = np.unique(facets, axis=0, return_inverse=True, return_counts=True)
    a, b, c = (points[triangles[:, k]] for k in range(3))
    normals = np.cross(b - a, c - a)
    middles = a + (np.cross(normals, b - a) * ((c - a) ** 2).sum(axis=1, keepdims=True)
                   + np.cross(c - a, normals) * ((b - a) ** 2).sum(axis=1, keepdims=True)) / (
                       2 * (normals ** 2).sum(axis=1, keepdims=True))
    own = np.linalg.norm(middles - a, axis=1)
    least = np.full(len(triangles), np.inf)
    np.minimum.at(least, of_facets, balls_of_cells)
    is_empty = np.ones(len(triangles), dtype=bool)
    np.logical_and.at(is_empty, of_facets, np.linalg.norm(points[apexes] - middles[of_facets], axis=1) > own[of_facets])
    filled = np.bincount(of_facets, weights=balls_of_cells <= alpha)
    return triangles[(np.where(is_empty, own, least) <= alpha) & (filled < 2)]


def alpha_shapes(inputs, file_name):
    """Of the same points, for three radii."""
    grid = read(inputs, "elephant.vtu")
    points, corners = points_of(grid), corners_of(grid)
    scene = Scene(1500, 600, panels=3)
    for panel, share in enumerate((0.009, 0.02, 0.12)):
        triangles = alpha_triangles(points, corners, share * diameter(points))
        print("alpha_shapes:", share * diameter(points), len(triangles))
        scene.add(balls(points, 0.0022 * diameter(points)), STEEL, panel, smooth=True)
        scene.add(polydata(points, triangles), ORANGE, panel, edges=(0.62, 0.36, 0.04), width=0.5)
    scene.look(VIEW, zoom=1.35)
    scene.write(file_name, on_white=True)


PICTURES = {"cut_open": cut_open, "surface_and_cut": surface_and_cut, "nets": nets, "trace": trace, "cut_and_subgraph": cut_and_subgraph,
            "medial_axis": medial_axis, "cloud_and_surface": cloud_and_surface, "alpha_shapes": alpha_shapes}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("inputs", metavar="INPUTS", help="the folder of what the programs wrote")
    parser.add_argument("outputs", metavar="OUTPUTS", help="the folder of the pictures, WebP")
    parser.add_argument("pictures", nargs="*", metavar="PICTURE", help=f"{', '.join(PICTURES)}; otherwise all")
    arguments = parser.parse_args()
    for name in arguments.pictures or PICTURES:
        PICTURES[name](arguments.inputs, os.path.join(arguments.outputs, f"{name}.webp"))


if __name__ == "__main__":
    main()
