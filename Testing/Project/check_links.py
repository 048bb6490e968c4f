#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Links of the pages: what they name in the tree is there, with that heading; the web's are well formed.

    check_links.py [FOLDER]    of the project in FOLDER; by default this one's

Exit 1 after naming each link that leads nowhere. Nothing is asked over the network.
"""

import pathlib
import re
import sys
import urllib.parse

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
CODE = re.compile(r"^```.*?^```$|`[^`\n]*`", re.M | re.S)
HEADING = re.compile(r"^#+ +(.*)$", re.M)


def pages(root):
    yield from sorted(root.glob("*.md"))
    yield from sorted((root / "Documentation").rglob("*.md"))


def anchors(page):
    """Headings as GitHub names them."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S)
    plain = (re.sub(r"[`*]", "", re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)).strip().lower()
             for heading in HEADING.findall(text))
    return {re.sub(r"\s", "-", re.sub(r"[^\w\s-]", "", heading)) for heading in plain}


def check(root):
    """Yield a line for each link that leads nowhere, and each page that no page leads to."""
    reached = {root / "README.md"}
    for page in pages(root):
        name = page.relative_to(root).as_posix()
        for target in LINK.findall(CODE.sub("", page.read_text())):
            parts = urllib.parse.urlsplit(target)
            if parts.scheme:
                if parts.scheme not in ("https", "http") or "." not in parts.netloc:
                    yield f"{name}: {target} is no address of the web"
                continue
            place = (page.parent / urllib.parse.unquote(parts.path)).resolve() if parts.path else page
            if not place.exists() or root not in (place, *place.parents):
                yield f"{name}: {target} is not there"
                continue
            reached.add(place)
            reached.update(place.glob("*.md") if place.is_dir() else ())
            if parts.fragment and parts.fragment not in anchors(place):
                yield f"{name}: {target}: no such heading"
    for page in pages(root):
        if page.resolve() not in reached:
            yield f"{page.relative_to(root).as_posix()}: no page has a link to it"


def main():
    root = (pathlib.Path(sys.argv[1]) if len(sys.argv) > 1
            else pathlib.Path(__file__).parents[2]).resolve()
    broken = list(check(root))
    print("\n".join(broken) or "the links lead somewhere")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
