#!/usr/bin/env python3
"""Draws the figures of docs/explanation: python3 docs/explanation/drawings/draw.py"""
import html
import math
import pathlib

BLUE, ORANGE, GREY, INK = "#3b7dd8", "#e8863a", "#b8bcc4", "#222"


class Drawing:
    def __init__(self, width, height):
        self.size, self.parts = (width, height), []

    def add(self, tag, text="", **attributes):
        attributes = " ".join(f'{k.replace("_", "-")}="{v}"' for k, v in attributes.items())
        self.parts.append(f"<{tag} {attributes}>{text}</{tag}>" if text else f"<{tag} {attributes}/>")

    def body(self, x, y, a, b=None, colour=BLUE, turn=0):
        self.add("ellipse", cx=x, cy=y, rx=a, ry=b or a, fill=colour, fill_opacity=0.85,
                 stroke=INK, stroke_width=1, transform=f"rotate({turn} {x} {y})")

    def line(self, x1, y1, x2, y2, dash="none", colour=INK, end=False):
        self.add("line", x1=x1, y1=y1, x2=x2, y2=y2, stroke=colour, stroke_width=1.5,
                 stroke_dasharray=dash, **({"marker-end": "url(#tip)"} if end else {}))

    def path(self, d, colour=INK, dash="none", fill="none"):
        self.add("path", d=d, stroke=colour, stroke_width=1.5, fill=fill, stroke_dasharray=dash)

    def say(self, x, y, text, size=13, anchor="middle", colour=INK, style="normal"):
        self.add("text", html.escape(text), x=x, y=y, font_size=size, text_anchor=anchor, fill=colour,
                 font_style=style, font_family="DejaVu Sans, Helvetica, sans-serif")

    def save(self, name):
        w, h = self.size
        tip = ('<defs><marker id="tip" markerWidth="9" markerHeight="8" refX="8" refY="4" '
               f'orient="auto"><path d="M0,0 L9,4 L0,8 z" fill="{INK}"/></marker></defs>')
        text = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {w} {h}" width="{w}" '
                f'height="{h}">\n{tip}\n<rect width="{w}" height="{h}" fill="white"/>\n')
        (pathlib.Path(__file__).parent / f"{name}.svg").write_text(
            text + "\n".join(self.parts) + "\n</svg>\n", encoding="utf8")


def impact():
    """Two bodies at contact: q, v_imp, theta_imp."""
    d = Drawing(560, 290)
    angle = math.radians(35)
    x, y, r, s = 200, 165, 80, 62
    px, py = x + (r + s) * math.cos(angle), y - (r + s) * math.sin(angle)
    d.body(x, y, r)
    d.body(px, py, s, colour=ORANGE)
    d.line(x, y, px, py, dash="5 4")
    d.line(px, py, px - 190, py, end=True)
    d.path(f"M{px - 38},{py} A38,38 0 0 0 {px - 38 * math.cos(angle):.1f},{py + 38 * math.sin(angle):.1f}")
    d.say(px - 196, py + 5, "v_imp", anchor="end")
    d.say(px - 2, py + 34, "θ_imp", size=12, colour="white")
    d.say(x - 20, y + 35, "target", colour="white")
    d.say(px + 8, py - 22, "impactor", colour="white")
    d.say(px + 70, py + 4, "mass q × target", anchor="start")
    d.say(20, 24, "at contact, in the frame of the target", size=12, anchor="start")
    d.say(20, 275, "θ_imp: between relative velocity and line of centres; 0 is head-on", size=12, anchor="start")
    d.save("impact")


def shape():
    """Full lengths a >= b >= c, and the three kinds."""
    d = Drawing(640, 190)
    for x, a, b, name, ratio in ((110, 62, 50, "stout", "b/a = 0.8"), (310, 82, 41, "elongated", "b/a = 0.5"),
                                 (525, 96, 24, "EER", "b/a = 0.25")):
        d.body(x, 85, a, b)
        d.line(x - a, 150, x + a, 150, end=True)
        d.line(x + a, 150, x - a, 150, end=True)
        d.say(x, 168, "a")
        d.line(x, 85 - b, x, 85 + b, colour="white")
        d.say(x + 8, 90, "b", colour="white", anchor="start")
        d.say(x, 25, f"{name}: {ratio}")
    d.save("shape")


def classes():
    """The six outcome classes, for equal bodies."""
    d = Drawing(720, 300)
    cells = [("M  perfect-merging", "largest group ≥ 0.9 of all"), ("H  hit-and-run", "both go on, almost whole"),
             ("D  catastrophic-disruption", "largest group < half of all"),
             ("A  partial-accretion", "target has gained"), ("E  erosion", "target has lost"),
             ("G  graze-and-merge", "touched, parted, met again")]
    for k, (name, meaning) in enumerate(cells):
        x, y = 120 + 240 * (k % 3), 70 + 145 * (k // 3)
        d.say(x, y - 48, name)
        d.say(x, y + 58, meaning, size=11)
        if k == 0:
            d.body(x - 10, y, 60, 30)
            d.body(x + 22, y + 2, 28, 22, colour=ORANGE)
        elif k == 1:
            d.body(x - 55, y + 8, 34)
            d.body(x + 55, y - 8, 34, colour=ORANGE)
            d.line(x - 90, y + 8, x - 112, y + 14, end=True)
            d.line(x + 90, y - 8, x + 112, y - 14, end=True)
        elif k == 2:
            for dx, dy, r, c in ((-70, 5, 20, BLUE), (-25, -15, 16, ORANGE), (5, 18, 19, BLUE),
                                 (45, -10, 14, ORANGE), (80, 10, 10, BLUE), (25, -30, 6, BLUE)):
                d.body(x + dx, y + dy, r, colour=c)
        elif k == 3:
            d.body(x - 25, y, 42, 34)
            d.body(x - 2, y - 12, 14, colour=ORANGE)
            d.body(x + 70, y + 8, 20, colour=ORANGE)
            d.line(x + 92, y + 10, x + 112, y + 14, end=True)
        elif k == 4:
            d.body(x - 40, y, 34)
            for dx, dy, r, c in ((20, -12, 8, BLUE), (45, 14, 12, ORANGE), (75, -8, 14, ORANGE), (15, 22, 6, BLUE)):
                d.body(x + dx, y + dy, r, colour=c)
        else:
            d.body(x - 62, y + 10, 24)
            d.body(x - 12, y - 10, 24, colour=ORANGE)
            d.path(f"M{x - 62},{y - 20} C{x - 50},{y - 46} {x - 20},{y - 46} {x - 10},{y - 38}", dash="4 3")
            d.line(x + 22, y, x + 42, y, end=True)
            d.body(x + 80, y, 34, 20)
            d.body(x + 95, y, 18, 16, colour=ORANGE)
    d.save("classes")


def groups():
    """Remnants, debris, a bound group, and what settled means."""
    d = Drawing(720, 230)
    d.path("M25,110 a105,80 0 1 0 210,0 a105,80 0 1 0 -210,0", dash="6 4")
    d.body(110, 115, 52, 22, turn=-12)
    for x, y in ((60, 60), (180, 70), (205, 120), (170, 160), (70, 165)):
        d.body(x, y, 4, colour=GREY)
    d.say(110, 120, "remnant", size=12, colour="white")
    d.say(172, 66, "debris", size=11, anchor="end")
    d.say(130, 212, "a bound group; settled", size=12)
    d.path("M255,110 a105,80 0 1 0 210,0 a105,80 0 1 0 -210,0", dash="6 4")
    d.body(315, 130, 30)
    d.body(410, 90, 28, colour=ORANGE)
    d.path("M410,60 C390,25 330,40 318,92", dash="4 3")
    d.say(360, 212, "two remnants, one bound group: unsettled", size=12)
    d.body(545, 130, 30)
    d.body(650, 80, 28, colour=ORANGE)
    d.line(512, 140, 490, 148, end=True)
    d.line(680, 70, 704, 62, end=True)
    d.say(600, 212, "two groups that part: settled", size=12)
    d.save("groups")


def ridge():
    """Where EERs lie: v sin(theta) = const."""
    d = Drawing(480, 330)
    x = lambda v: 60 + 15 * (v - 8)
    y = lambda t: 285 - 8 * t
    at = lambda c, v: math.degrees(math.asin(min(1, c / v)))
    d.line(60, 285, 450, 285, end=True)
    d.line(60, 285, 60, 20, end=True)
    speeds = [10 + 0.5 * k for k in range(46)]
    low = [(x(v), y(at(4.3, v))) for v in speeds if at(4.3, v) < 31]
    high = [(x(v), y(at(5.7, v))) for v in speeds if at(5.7, v) < 31]
    points = low + high[::-1]
    d.path("M" + " L".join(f"{a:.0f},{b:.0f}" for a, b in points) + " z", colour="none", fill="#cfe0f7")
    for v in (15, 17.5, 20, 22.5, 25):
        d.body(x(v), y(at(5.1, v)), 13, 4, turn=-15)
    d.say(x(22), y(27), "bodies part,", size=12)
    d.say(x(22), y(25), "then disrupt", size=12)
    d.say(x(12.5), y(7), "everything merges", size=12)
    d.say(x(33), y(12), "v sin θ = const", size=12)
    d.say(255, 318, "impact speed v_imp, cm/s")
    d.say(20, 150, "angle", anchor="start")
    for v in (10, 20, 30):
        d.say(x(v), 301, str(v), size=11)
    for t in (10, 20, 30):
        d.say(52, y(t) + 4, str(t), size=11, anchor="end")
    d.save("ridge")


def scheme():
    """The three flaws of few particles."""
    d = Drawing(720, 210)
    for row in range(3):
        for column in range(4):
            d.body(45 + 40 * column + 14 * (2 - row), 60 + 36 * row, 9, colour=GREY)
    d.line(60, 32, 190, 32, end=True)
    d.line(190, 168, 60, 168, end=True)
    d.line(113, 96, 83, 132, end=True)
    d.line(83, 132, 113, 96, end=True)
    d.say(120, 198, "shear: half of the pairs approach", size=12)
    for px, py in ((290, 60), (325, 75), (300, 105), (340, 118), (375, 92), (410, 70), (360, 55), (395, 130), (290, 140)):
        d.body(px, py, 9, colour=GREY)
    d.say(352, 170, "ρ integrated ≠ ρ of the arrangement", size=12)
    d.say(352, 198, "errors add up; only pressure counts", size=12)
    for column in range(5):
        for row, colour in ((0, ORANGE), (1, ORANGE), (2.44, BLUE), (3.44, BLUE)):
            d.body(545 + 32 * column, 45 + 32 * row, 9, colour=colour)
    d.line(527, 77, 527, 123, end=True)
    d.line(527, 123, 527, 77, end=True)
    d.say(518, 104, "1.44", size=11, anchor="end")
    d.say(600, 198, "surfaces press before they touch", size=12)
    d.save("scheme")


if __name__ == "__main__":
    for draw in (impact, shape, classes, groups, ridge, scheme):
        draw()
