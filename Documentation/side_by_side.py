#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every technique on several scenes in the same light, beside the reference: Documentation/gallery.

    side_by_side.py COMMAND [SCENE...]      draw all scenes, or these, and write the page anew
    side_by_side.py COMMAND --no-times ...  the same without times, for a machine that others use
    side_by_side.py COMMAND --check SCENE   measure a scene again: exit 1 where the page's errors are other ones

COMMAND is build/bin/softshadows. Pictures are small; errors and times are of pictures of that size.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent / "gallery"
SCENES = ("isosurface", "streamtubes", "molecule", "terrain")
SIZE = "200x150"
OPTIONS = ("--samples-per-pixel", "0", "--reference-samples", "256", "--frames", "2")
COLUMNS = 4
LEFT_OUT = ("none", "auto")  # auto is one of the others, by the times of the day


def measure(command, scene, folder, *options):
    told = subprocess.run([command, "compare", "--scene", scene, "--size", SIZE, *OPTIONS, "--json",
                           "-o", folder, *options], check=True, capture_output=True, text=True).stdout
    return json.loads(told)


def page_of(scene, figures, times):
    """A table: the reference, then the techniques, the least error first."""
    techniques = [one for one in figures["techniques"] if "skipped" not in one
                  and one["technique"] not in LEFT_OUT]
    techniques.sort(key=lambda one: one["visibility"]["rmse"])
    light = figures["scene"]["light"]["shape"]
    cells = [f"![reference]({scene}-reference.png)<br>the truth: {figures['reference']['samples']} rays "
             f"a pixel"]
    for one in techniques:
        name = one["technique"]
        cells.append(f"![{name}]({scene}-{name}.png)<br>[`{name}`](../techniques/{name}.md): "
                     f"RMSE {one['visibility']['rmse']:.4f}" +
                     (f", {one['added_milliseconds']:.0f} ms" if times else ""))
    while len(cells) % COLUMNS:
        cells.append("")
    lines = [f"# `{scene}`", "", f"{figures['scene']['triangles']:,} triangles, light: {light}.", "",
             "|" + " |" * COLUMNS, "|" + "---|" * COLUMNS]
    lines += ["| " + " | ".join(cells[i:i + COLUMNS]) + " |" for i in range(0, len(cells), COLUMNS)]
    skipped = [one["technique"] for one in figures["techniques"] if "skipped" in one]
    if skipped:
        lines += ["", "Not here, for it has no light of this shape: " + ", ".join(skipped) + "."]
    others = " · ".join(f"[{other}]({other}.md)" for other in SCENES if other != scene)
    return "\n".join(lines + ["", f"Others: {others}. [Gallery](../gallery.md)."]) + "\n"


def draw(command, scene, times):
    for old in FOLDER.glob(f"{scene}-*.png"):
        old.unlink()
    with tempfile.TemporaryDirectory() as folder:
        figures = measure(command, scene, folder)
        for picture in pathlib.Path(folder).glob("*.png"):
            if not picture.stem.endswith("-difference") and picture.stem not in LEFT_OUT:
                (FOLDER / f"{scene}-{picture.name}").write_bytes(picture.read_bytes())
    (FOLDER / f"{scene}.md").write_text(page_of(scene, figures, times))
    print(scene, flush=True)


def check(command, scene):
    """The page's errors, with room for the last digits of other machines' drawing."""
    said = {name: float(error) for name, error in re.findall(
        r"\[`([\w-]+)`\]\(\S+\): RMSE ([\d.]+)", (FOLDER / f"{scene}.md").read_text())}
    with tempfile.TemporaryDirectory() as folder:
        figures = measure(command, scene, folder, "--techniques", ",".join(said))
    found = {one["technique"]: one["visibility"]["rmse"] for one in figures["techniques"]
             if one["technique"] in said}
    stale = [f"{name}: {said[name]} on the page, {found[name]:.4f} now" for name in said
             if abs(found[name] - said[name]) > 0.001 + 0.05 * said[name]]
    print("\n".join(stale) or f"{scene}: {len(said)} errors are as the page says")
    return 1 if stale or not said else 0


def main():
    command, *words = sys.argv[1:]
    if words[:1] == ["--check"]:
        return check(command, words[1])
    times = "--no-times" not in words
    FOLDER.mkdir(exist_ok=True)
    for scene in [word for word in words if word != "--no-times"] or SCENES:
        draw(command, scene, times)
    return 0


if __name__ == "__main__":
    sys.exit(main())
