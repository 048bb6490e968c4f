#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Make every picture of the documentation anew: pictures.py [NAME...]

    PYTHONPATH=build/lib/python /usr/bin/python3 Documentation/pictures.py

Into Documentation/pictures: the gallery's ten scripts, a picture for each technique, what fails where in
choosing.md, and the example programs'. With names, those alone. 600 pixels wide, smooth edges, the studio's
light, but for programs that are about lights of their own.
"""

import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE / "examples"))

from vtkmodules.vtkIOImage import vtkPNGWriter  # noqa: E402
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter  # noqa: E402

import gallery  # noqa: E402
import vtksoftshadows  # noqa: E402

# What choosing.md shows: a name, a scene, the technique, and the studio that it fails or shines in.
CASES = {
    "thin-map-pcss": ("flow", "map-pcss", {}),
    "thin-map-soft": ("flow", "map-soft", {}),
    "thin-map-hard": ("flow", "map-hard", {}),
    "large-map-pcss": ("spikes", "map-pcss", {"softness": 1.5}),
    "large-map-soft": ("spikes", "map-soft", {"softness": 1.5}),
    "ground-planar-soft": ("bars", "planar-soft", {"ground": "solid"}),
    "steps-map-soft": ("helix", "map-soft", {"samples": 8}),
    "headlight": ("flow", "map-pcss", None),
}

EXAMPLES = ("one_line", "soft_shadows", "shadow_catcher", "molecule", "translucent", "many_lights",
            "shadow_as_data")


def run_example(name):
    """As a reader runs it."""
    subprocess.run([sys.executable, HERE / "examples" / f"{name}.py", HERE / "pictures" / f"{name}.png"],
                   check=True, stdout=subprocess.DEVNULL)
    print(name, flush=True)


def draw(name, scene, technique, options):
    renderer, window = gallery.make(scene)
    if options is None:
        vtksoftshadows.vtkShadowPass.SetAdvice(False)
        vtksoftshadows.enable(renderer, technique)
    else:
        parameters = {key: value for key, value in options.items() if key == "samples"}
        if technique == "map-soft":
            parameters["midpoint"] = True  # as enable() has it in the studio
        vtksoftshadows.studio(renderer, **{key: value for key, value in options.items()
                                           if key != "samples"})
        vtksoftshadows.enable(renderer, technique, **parameters)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(str(HERE / "pictures" / f"{name}.png"))
    writer.Write()
    print(name, flush=True)


def main():
    techniques = vtksoftshadows.vtkShadowTechniques
    pictures = {name: (name, "map-soft", {}) for name in gallery.SCENES}
    for i in range(techniques.GetNumberOfTechniques()):
        name = techniques.GetName(i)
        ground = "solid" if name.startswith("planar") else "catcher"
        pictures[name] = ("spikes", name, {"ground": ground})
    pictures.update(CASES)
    known = [*pictures, *EXAMPLES]
    unknown = set(sys.argv[1:]) - set(known)
    if unknown:
        sys.exit(f"There is no picture {', '.join(sorted(unknown))}. Known: {', '.join(known)}.")
    for name in sys.argv[1:] or known:
        if name in EXAMPLES:
            run_example(name)
        else:
            draw(name, *pictures[name])


if __name__ == "__main__":
    main()
