# SPDX-License-Identifier: BSD-3-Clause
"""Curves on logarithmic axes as SVG, for the plots of docs/performance.md."""
import math

WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 640, 400, 70, 110, 30, 55


class Axis:
    """Numbers of one axis to places on the paper, and its marks at 1, 2 and 5."""

    def __init__(self, values, margin, begin, end):
        self.low, self.high = math.log10(min(values)) - margin, math.log10(max(values)) + margin
        self.begin, self.end = begin, end

    def __call__(self, value):
        return self.begin + (math.log10(value) - self.low) / (self.high - self.low) * (self.end - self.begin)

    def marks(self):
        values = [digit * 10.0**power for power in range(math.floor(self.low), math.ceil(self.high) + 1) for digit in (1, 2, 5)]
        return [value for value in values if self.low <= math.log10(value) <= self.high]


def logarithmic(title, of_x, of_y, curves, note=""):
    """The text of an SVG file. `curves`: name to (colour, [(x, y, whether the point is large)])"""
    points = [point for _, rows in curves.values() for point in rows]
    x = Axis([point[0] for point in points], 0.05, LEFT, WIDTH - RIGHT)
    y = Axis([point[1] for point in points], 0.1, HEIGHT - BOTTOM, TOP)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}" '
           'font-family="DejaVu Sans, sans-serif" font-size="12">', f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
           f'<text x="{LEFT}" y="18" font-size="14">{title}</text>']
    out += [f'<path d="M{x(v):.1f} {TOP}V{HEIGHT - BOTTOM}" stroke="#ddd"/>'
            f'<text x="{x(v):.1f}" y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{v:g}</text>' for v in x.marks()]
    out += [f'<path d="M{LEFT} {y(v):.1f}H{WIDTH - RIGHT}" stroke="#ddd"/>'
            f'<text x="{LEFT - 6}" y="{y(v) + 4:.1f}" text-anchor="end">{v:g}</text>' for v in y.marks()]
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 12}" text-anchor="middle">{of_x}</text>'
               f'<text transform="translate(18 {(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)" text-anchor="middle">{of_y}</text>')
    for i, (name, (colour, rows)) in enumerate(curves.items()):
        path = "L".join(f"{x(px):.1f} {y(py):.1f}" for px, py, _ in sorted(rows))
        out.append(f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        out += [f'<circle cx="{x(px):.1f}" cy="{y(py):.1f}" r="{6 if large else 3.5}" fill="{colour}"/>' for px, py, large in rows]
        out.append(f'<text x="{WIDTH - RIGHT + 10}" y="{TOP + 20 + 18 * i}" fill="{colour}">{name}</text>')
    if note:
        out.append(f'<text x="{WIDTH - RIGHT + 10}" y="{TOP + 24 + 18 * len(curves)}" font-size="10">{note}</text>')
    return "\n".join([*out, "</svg>"]) + "\n"
