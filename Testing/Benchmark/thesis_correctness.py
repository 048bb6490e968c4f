#!/usr/bin/env python3
"""Correctness of each technique as Zapotocky's thesis measures it (table 5.4), beside the thesis's.

    PYTHONPATH=build/lib/python /usr/bin/python3 Testing/Benchmark/thesis_correctness.py [--write DIR]

Share of colour bytes within 4/255 of the paragon, here `ray-traced` with 1024 rays, on the scene
`basic` at 700 x 700. The thesis shows its scene, but does not give it: view and light here are such
that no shadow and the hard shadow score what they score there, 57 and 88 to 89 %.
"""
import argparse
import pathlib

from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow, vtkWindowToImageFilter

import vtksoftshadows as vss

SIZE = 700
# (name, parameters, the thesis's correctness on basic and on midpoint maps)
ROWS = [
    ("none", {}, 57.193),
    ("map-hard", {}, 89.251),
    ("map-hard", {"midpoint": "on"}, 88.770),
    ("map-soft", {"samples": 64, "resolution": 1024}, 99.549),
    ("map-soft", {"samples": 64, "resolution": 1024, "midpoint": "on"}, 99.416),
    ("map-pcf", {}, 90.699),
    ("map-pcf", {"midpoint": "on"}, 90.710),
    ("map-blur", {}, 90.699),
    ("map-blur", {"midpoint": "on"}, 90.710),
    ("map-blur", {"blur": "plain"}, 90.699),
    ("map-jitter", {}, 93.925),
    ("map-jitter", {"midpoint": "on"}, 94.008),
    ("map-pcss", {"midpoint": "off"}, 94.994),
    ("map-pcss", {}, 95.756),
    ("map-combined", {"midpoint": "off"}, 94.560),
    ("map-combined", {}, 95.325),
    ("planar-hard", {}, 88.348),
    ("planar-soft", {"samples": 64}, 95.759),
    ("planar-fake", {}, 92.288),
    ("volume-hard", {}, 88.113),
    ("volume-soft", {"samples": 64, "counting": "z-pass"}, 99.939),
    ("volume-soft", {"samples": 64, "counting": "z-fail"}, 99.942),
    ("volume-soft", {"samples": 64, "counting": "xor"}, 94.078),
]


def grab(window):
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    image.ShouldRerenderOff()
    image.Update()
    return image.GetOutput()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--write", type=pathlib.Path, help="folder for pictures and differences")
    parser.add_argument("--light", type=float, nargs=3, default=(-5.2, -4.6, 5.2))
    parser.add_argument("--side", type=float, default=0.8, help="of the square light")
    parser.add_argument("--camera", type=float, nargs=3, default=(2.5, -4.0, 6.5))
    parser.add_argument("--focus", type=float, nargs=3, default=(1.2, 0.8, 0.0))
    arguments = parser.parse_args()

    renderer = vtkRenderer()
    window = vtkRenderWindow()
    window.SetOffScreenRendering(True)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    vss.vtkShadowScenes.Build("basic", renderer)
    light = renderer.GetLights().GetItemAsObject(0)
    light.SetPosition(*arguments.light)
    light.SetWidth(arguments.side)
    light.SetHeight(arguments.side)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*arguments.camera)
    camera.SetFocalPoint(*arguments.focus)
    renderer.ResetCameraClippingRange()

    def write(name, image):
        if arguments.write:
            arguments.write.mkdir(parents=True, exist_ok=True)
            writer = vtkPNGWriter()
            writer.SetInputData(image)
            writer.SetFileName(str(arguments.write / f"{name}.png"))
            writer.Write()

    paragon = vss.vtkShadowTechniques.Create("ray-traced")
    paragon.SetParameter("samples", "1024")
    renderer.SetPass(paragon)
    reference = grab(window)
    write("paragon", reference)
    print(f"{'technique':40} {'here':>8} {'thesis':>8}")
    for name, parameters, thesis in ROWS:
        shadows = None if name == "none" else vss.vtkShadowTechniques.Create(name)
        for key, value in parameters.items():
            shadows.SetParameter(key, str(value))
        renderer.SetPass(shadows)
        metrics = vss.vtkPictureMetrics()
        metrics.SetReference(reference)
        metrics.SetImage(grab(window))
        metrics.Update()
        label = " ".join([name] + [f"{key}={value}" for key, value in parameters.items()])
        write(label.replace(" ", "-"), metrics.GetImage())
        write(label.replace(" ", "-") + "-difference", metrics.GetDifferenceImage())
        print(f"{label:40} {metrics.GetCorrectness():8.3f} {thesis:8.3f}", flush=True)
    renderer.SetPass(None)


main()
