#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Write the tables of README.md, and SUITE/results.csv, from what softshadows bench measured.

    generate.py RESULTS            from RESULTS/SUITE/results.json, rewrite the page between its markers
    generate.py RESULTS --print    print the tables instead

A suite that was not measured has no table, but a line that says so.
"""
import argparse
import csv
import json
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).parent
BEGIN, END = "<!-- generated {} -->", "<!-- end of generated -->"
TIMES = ("static", "dynamic")
MOVES = {"static": "camera moves", "dynamic": "light moves"}
PEERS = ("vtkShadowMapPass", "ray-traced")
LIMIT = 1.05  # what exponents are meant to stay within, against LIMITED
LIMITED = ("triangles", "lights", "pixels")
SUITES = ("scenes", "thesis", "scaling")
AXES = ("triangles", "lights", "pixels", "resolution", "light-size")


def table(rows, head):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def number(value, digits=3):
    """With so many significant digits, and no more than there are."""
    if value is None:
        return "–"
    if abs(value) >= 10 ** (digits - 1):
        return f"{value:.0f}"
    text = f"{value:.{digits}g}"
    return f"{value:.4f}" if "e" in text else text


def measured(case):
    return [entry for entry in case["entries"] if entry.get("time")]


def added(entry, kind):
    return entry["time"][kind]["added"]["median"]


def penumbra(entry):
    """Its RMSE there, or None."""
    return (entry.get("error") or {"penumbra": {"rmse": None}})["penumbra"]["rmse"]


def name_of(entry):
    """`technique` with what is set."""
    setting = " ".join(f"{name}={value}" for name, value in entry["setting"].items())
    return f"`{entry['technique']}`" + (f" {setting}" if setting else "")


def techniques(cases):
    """Of this project, rays left out, in order."""
    found = [e["technique"] for case in cases for e in case["entries"] if e["kind"] == "technique"]
    return [name for name in dict.fromkeys(found) if name not in PEERS]


def machine(suites):
    lines = []
    for name, results in suites.items():
        one = results["machine"]
        gl = results["gl"] or dict.fromkeys(("version", "vendor", "renderer"))
        memory = f", {one['memory_bytes'] / 2 ** 30:.0f} GiB" if one["memory_bytes"] else ""
        libraries = ", ".join(f"{k} {v}" for k, v in results["libraries"].items())
        place = (f"{one['processor']}, {one['cores']} cores{memory}, {one['system']}; "
                 f"OpenGL {gl['version']} of {gl['vendor']}, {gl['renderer']}; {libraries}")
        frames = [e["time"][kind]["frames"] for case in results["cases"] for e in measured(case)
                  for kind in TIMES if e["kind"] != "none"]
        how = f"`{name}` on {results['date'][:10]}"
        how += f", {min(frames)} to {max(frames)} frames a median" if frames else ""
        skipped = sum("skipped" in e for case in results["cases"] for e in case["entries"])
        how += f", {skipped} entries not measured" if skipped else ""
        if lines and lines[-1][0] == place:
            lines[-1][1].append(how)
        else:
            lines.append((place, [how]))
    return [f"* {place}: {'; '.join(hows)}." for place, hows in lines]


def fronts(results):
    lines = []
    for case in results["cases"]:
        entries = {entry["id"]: entry for entry in case["entries"]}
        noise = ((case["reference"] or {}).get("noise") or {}).get("penumbra_rmse")
        lines += [f"**{case['id']}**, {case['scene']['triangles']} triangles, "
                  f"{case['size'][0]} × {case['size'][1]}; the reference's own error "
                  f"{number(noise, 2)}.", ""]
        columns = []
        for kind in TIMES:
            columns.append([(name_of(entries[name]), number(added(entries[name], kind)),
                             number(penumbra(entries[name])))
                            for name in case["fronts"]["penumbra"][kind]])
        height = max(map(len, columns))
        if not height:
            lines += ["Not measured.", ""]
            continue
        rows = zip(*(column + [("", "", "")] * (height - len(column)) for column in columns))
        lines += table([left + right for left, right in rows],
                       [h for kind in TIMES for h in (MOVES[kind], "ms", "error")]) + [""]
    return lines[:-1]


def rays(results):
    head = ["technique"] + [case["id"] + ", " + MOVES[kind]
                            for case in results["cases"] for kind in TIMES]
    rows = []
    for technique in techniques(results["cases"]):
        row = [f"`{technique}`"]
        for case in results["cases"]:
            entries = {entry["id"]: entry for entry in case["entries"]}
            for kind in TIMES:
                factors = [(one["factor"], one["beyond"]) for one in case["against_rays"]
                           if (one["pixels"], one["time"]) == ("penumbra", kind)
                           and entries[one["entry"]]["technique"] == technique
                           and one.get("factor") is not None]
                factor, beyond = max(factors, default=(None, False))
                row.append(("≥ " if beyond else "") + number(factor, 2))
        rows.append(row)
    return table(rows, head)


def loss(case, technique, kind):
    """Of the technique's settings the best time over the fastest other's, and who that is; or None."""
    points = [(added(e, kind), penumbra(e), e["technique"]) for e in measured(case)
              if e["kind"] != "none" and penumbra(e) is not None and added(e, kind) > 0]
    found = []
    for time, error, name in points:
        others = [point for point in points if point[2] != technique and point[1] <= error]
        if name == technique:
            found.append((time / min(others)[0], min(others)[2]) if others else (0.0, None))
    return min(found, key=lambda one: one[0], default=None)


def losses(results):
    rows = []
    for technique in techniques(results["cases"]):
        row, winners = [f"`{technique}`"], []
        for case in results["cases"]:
            texts = []
            for kind in TIMES:
                found = loss(case, technique, kind)
                if found is None:
                    texts.append("–")
                elif found[0] <= 1.0:
                    texts.append("**alone**" if found[1] is None else f"**{number(found[0], 2)}**")
                else:
                    texts.append(number(found[0], 2))
                    winners.append(found[1])
            row.append(" / ".join(texts))
        most = max(dict.fromkeys(winners), key=winners.count) if winners else None
        rows.append(row + [f"`{most}`" if most else "–"])
    return table(rows, ["technique"] + [case["id"] for case in results["cases"]] + ["beaten by"])


def thesis(results):
    lines = []
    for case in results["cases"]:
        if case["size"] != [700, 700]:
            continue
        graded = bool(case["reference"])
        rows = []
        for entry in case["entries"]:
            published = entry.get("published", {})
            row = [entry.get("label", "No shadows" if entry["kind"] == "none" else ""),
                   name_of(entry)]
            if graded:
                here = (entry.get("picture") or {}).get("correctness_percent")
                row += ["–" if value is None else f"{value:.1f}"
                        for value in (here, published.get("correctness"))]
            for kind in TIMES:
                time = entry.get("time")
                row.append(number(time[kind]["ratio"] if time else None, 2))
                row.append(number(published.get(kind + "_ratio"), 2))
            rows.append(row)
        head = ["row", "technique"] + (["correct %", "thesis"] if graded else [])
        head += [text for kind in TIMES for text in (MOVES[kind], "thesis")]
        lines += [f"**{case['id']}** ({case['published']})", "", *table(rows, head), ""]
    return lines[:-1]


def scaling(results):
    found = {(row["axis"], row["technique"], row["time"]): row for row in results["scaling"]}
    axes = [axis for axis in AXES if any(key[0] == axis for key in found)]
    ends = {}
    for (axis, _, _), row in found.items():
        ends.setdefault(axis, []).extend(value for value, _ in row["points"])
    names = list(dict.fromkeys(technique for _, technique, _ in found))
    head = ["technique"] + [f"{axis}, {MOVES[kind]}" for axis in axes for kind in TIMES]
    rows, over = [], []
    for technique in names:
        row = [f"`{technique}`"]
        for axis in axes:
            for kind in TIMES:
                exponent = found.get((axis, technique, kind), {}).get("exponent")
                text = "–" if exponent is None else f"{exponent:.2f}"
                if axis in LIMITED and exponent is not None and exponent > LIMIT:
                    text = f"**{text}**"
                    over.append(f"`{technique}` in {axis} ({MOVES[kind]}, {exponent:.2f})")
                row.append(text)
        rows.append(row)
    spans = ", ".join(f"{axis} {min(v):g} to {max(v):g}" for axis, v in ends.items() if v)
    return table(rows, head) + ["", f"From: {spans}. Above {LIMIT}: " +
                                (", ".join(over) if over else "none") + "."]


PARTS = {"fronts": ("scenes", fronts), "rays": ("scenes", rays), "losses": ("scenes", losses),
         "thesis": ("thesis", thesis), "scaling": ("scaling", scaling)}


def generate(folder):
    """The lines of each part."""
    suites = {}
    for name in SUITES:
        path = folder / name / "results.json"
        if path.exists():
            suites[name] = json.loads(path.read_text())
    parts = {"machine": machine(suites) if suites else ["Nothing was measured yet."]}
    for part, (suite, write) in PARTS.items():
        parts[part] = write(suites[suite]) if suite in suites else ["Not measured yet."]
    return parts


def rounded(text):
    """A figure with five significant digits; other text as it is."""
    try:
        return f"{float(text):.5g}"
    except ValueError:
        return text


def copy_rows(source, target):
    with open(source, newline="") as file:
        rows = [[rounded(text) for text in row] for row in csv.reader(file)]
    target.parent.mkdir(exist_ok=True)
    with open(target, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows(rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("results", type=pathlib.Path, help="output folder of softshadows bench")
    parser.add_argument("--print", action="store_true", help="print the tables instead")
    arguments = parser.parse_args()
    if not any((arguments.results / name / "results.json").exists() for name in SUITES):
        parser.error(f"{arguments.results} has no SUITE/results.json; suites: {', '.join(SUITES)}")
    parts = generate(arguments.results)
    if arguments.print:
        for part, lines in parts.items():
            print(f"## {part}\n")
            print("\n".join(lines) + "\n")
        return 0
    page = HERE / "README.md"
    new = page.read_text()
    for part, lines in parts.items():
        begin = BEGIN.format(part)
        text = "\n".join([begin, "", *lines, "", END])
        new, count = re.subn(re.escape(begin) + ".*?" + re.escape(END), lambda _: text, new,
                             flags=re.S)
        if count != 1:
            print(f"{page} has no place for: {part}", file=sys.stderr)
            return 1
    page.write_text(new)
    for name in SUITES:
        source = arguments.results / name / "results.csv"
        if source.exists():
            copy_rows(source, HERE / name / "results.csv")
    return 0


sys.exit(main())
