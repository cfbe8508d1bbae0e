#!/usr/bin/env python3
"""Fails where words of a figure lie outside its page or on each other.

usage: figures.py FILE.svg...
It reads figures as eerie draws them: text in a group that translates and may rotate. Widths are
those of DejaVu Sans, in which the figures are set.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as tree

SVG = "{http://www.w3.org/2000/svg}"
TOLERANCE = 0.3  # pt; words may touch


def widths():
    """Advance widths of regular and bold letters, in 1/1000 em, from the program's own table."""
    source = (pathlib.Path(__file__).parents[2] / "analysis/drawing/letter_widths.cpp").read_text()
    tables = re.findall(r"= \{([\d,\s]+)\}", source)
    return [[int(w) for w in table.split(",") if w.strip()] for table in tables[:2]]


REGULAR, BOLD = widths()


def width(text, size, bold):
    table = BOLD if bold else REGULAR
    return sum(size * (0.66 if not " " <= c <= "~" else table[ord(c) - 32] / 1000)
               for c in text.replace("\u200b", "").replace("\u00a0", " "))


def runs(element, size, bold):
    """(text, size, bold) of an element's pieces; gnuplot leaves behind empty ones."""
    if element.text:
        yield element.text, size, bold
    for child in element:
        child_size = float(child.get("font-size", size))
        yield from runs(child, child_size, bold or child.get("font-weight") == "bold")


def boxes(path):
    """(words, left, top, right, bottom) of each text on the page."""
    root = tree.parse(path).getroot()
    page = [float(x) for x in root.get("viewBox").split()]
    found = []
    for group in root.iter(SVG + "g"):
        place = re.match(r"translate\(([-\d.]+),([-\d.]+)\)(?: rotate\(([-\d.]+)\))?",
                         group.get("transform", ""))
        if not place:
            continue
        x, y, turn = float(place[1]), float(place[2]), float(place[3] or 0)
        for text in group.findall(SVG + "text"):
            pieces = list(runs(text, float(group.get("font-size", 7)), False))
            words = "".join(p[0] for p in pieces)
            if not words.strip():
                continue
            long, high = sum(width(*p) for p in pieces), max(p[1] for p in pieces)
            start = {"middle": -long / 2, "end": -long}.get(group.get("text-anchor"), 0)
            lowered = max((float(t.get("dy", "0").rstrip("px")) for t in text.iter()), default=0)
            along, across = (start, start + long), (-0.74 * high, 0.1 * high + max(lowered, 0))
            if turn:
                found.append((words, x + across[0], y - along[1], x + across[1], y - along[0]))
            else:
                found.append((words, x + along[0], y + across[0], x + along[1], y + across[1]))
    return page, found


def faults(path):
    page, found = boxes(path)
    assert found, f"{path}: no words in it"
    for words, left, top, right, bottom in found:
        if left < -TOLERANCE or top < -TOLERANCE or right > page[2] + TOLERANCE or \
                bottom > page[3] + TOLERANCE:
            yield f"'{words}' lies outside the page"
    for k, a in enumerate(found):
        for b in found[:k]:
            wide = min(a[3], b[3]) - max(a[1], b[1])
            high = min(a[4], b[4]) - max(a[2], b[2])
            if wide > TOLERANCE and high > TOLERANCE:
                yield f"'{a[0]}' lies on '{b[0]}'"


def main():
    bad = [f"{path}: {fault}" for path in sys.argv[1:] for fault in faults(path)]
    print("\n".join(bad) if bad else f"{len(sys.argv) - 1} figures, no words on each other")
    sys.exit(bool(bad))


if __name__ == "__main__":
    main()
