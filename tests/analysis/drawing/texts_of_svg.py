"""Prints the words of each text element of an SVG file, each ended by a NUL."""
import sys
import xml.etree.ElementTree as tree

svg = "{http://www.w3.org/2000/svg}"
root = tree.parse(sys.argv[1]).getroot()
assert root.tag == svg + "svg", root.tag
for element in root.iter():
    kind = element.tag.replace(svg, "")
    assert kind in ("svg", "title", "desc", "g", "defs", "rect", "path", "circle", "use", "text",
                    "tspan", "clipPath", "polygon", "polyline", "line", "image", "style", "a",
                    "filter", "feFlood", "feComposite", "feOffset", "pattern"), kind
    if kind == "text":
        sys.stdout.buffer.write("".join(element.itertext()).encode() + b"\0")
