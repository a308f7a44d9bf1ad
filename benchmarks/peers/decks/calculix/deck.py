#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes PROBLEM.inp for CalculiX (ccx): quadratic bricks (DC3D20), a *STEP for each doubling of the time.

Call: deck.py slab_linear|slab_nonlinear DISC RINGS FAR TREAD BULK GROWTH LONGEST, or deck.py section WIDE HIGH GROWTH LONGEST.
Plan of the slab's quarter: a square in the disc's middle, rings to its edge, rings on to the sides, so that the light's edge
runs along edges of elements. Numbers of elements: DISC along the square's sides, RINGS and FAR outwards, TREAD and BULK
downwards. *HEAT TRANSFER is implicit Euler: an increment is GROWTH of the time passed, and LONGEST at most.
"""
import math
import sys

R, SIDE, AIR, FLUX = 5.6419e-3, 30e-3, 23.0, 1e4


def graded(first, to, cells, ratio):
    widths = [ratio ** (i / max(cells - 1, 1)) for i in range(cells)]
    return [first + (to - first) * sum(widths[:i]) / sum(widths) for i in range(cells + 1)]


def between(a, b, share):
    return tuple(p + (q - p) * share for p, q in zip(a, b))


def slab_plan(n, rings, outer):
    """Patches of the plan: a function of (u, v) in 0..1, numbers of elements along u and v, and whether it is lit."""
    square = lambda u, v: (u * (0.62 + 0.13 * (1 - v)) * R, v * (0.62 + 0.13 * (1 - u)) * R)
    arc = lambda v: (R * math.cos(v * math.pi / 4), R * math.sin(v * math.pi / 4))
    edge = lambda v: (SIDE, SIDE * v)
    stretch = graded(0.0, 1.0, 2 * outer, 6.0)

    def place(u):  # along the outer rings, graded
        at = u * 2 * outer
        i = min(int(at + 1e-9), 2 * outer - 1)
        return stretch[i] + (stretch[i + 1] - stretch[i]) * (at - i)

    swap = lambda f: (lambda u, v: f(v, u)[::-1])
    ring = lambda u, v: between(square(1.0, v), arc(v), u)
    far = lambda u, v: between(arc(v), edge(v), place(u))
    return [(square, n, n, True), (ring, rings, n, True), (swap(ring), n, rings, True),
            (far, outer, n, False), (swap(far), n, outer, False)]


def mesh(plan, levels):
    """Nodes {(x, y, z): number} and elements (20 numbers, layer, mark of the patch); levels: depths of elements' faces."""
    number, elements = {}, []

    def node(f, i, j, nu, nv, z):
        x, y = f(i / (2 * nu), j / (2 * nv))
        return number.setdefault((round(x, 9), round(y, 9), round(z, 9)), len(number) + 1)

    around = [(0, 0), (2, 0), (2, 2), (0, 2)]
    middles = [(1, 0), (2, 1), (1, 2), (0, 1)]
    for layer, (top, bottom) in enumerate(zip(levels, levels[1:])):
        for f, nu, nv, mark in plan:
            for a in range(nu):
                for b in range(nv):
                    at = lambda ij, z: node(f, 2 * a + ij[0], 2 * b + ij[1], nu, nv, -z)
                    elements.append(([at(p, z) for z in (bottom, top) for p in around] +
                                     [at(p, z) for z in (bottom, top) for p in middles] +
                                     [at(p, 0.5 * (bottom + top)) for p in around], layer, mark))
    return number, elements


def listed(name, kind, numbers):
    numbers = list(numbers)
    return [f"*{kind}, {kind}={name}", *(", ".join(map(str, numbers[i : i + 12])) + "," for i in range(0, len(numbers), 12))]


def slab(linear, disc, rings, far, tread, bulk):
    levels = graded(0.0, 3e-3, tread, 3.0) + graded(3e-3, 15e-3, bulk, 1.2)[1:]
    number, elements = mesh(slab_plan(disc, rings, far), levels)
    ids = range(1, len(elements) + 1)
    of = lambda chosen: [i for i, e in zip(ids, elements) if chosen(e)]
    last = len(levels) - 2
    sets = (listed("TREAD", "ELSET", of(lambda e: e[1] < tread)) + listed("BULK", "ELSET", of(lambda e: e[1] >= tread)) +
            listed("TOP", "ELSET", of(lambda e: e[1] == 0)) + listed("LIT", "ELSET", of(lambda e: e[1] == 0 and e[2])) +
            listed("BOTTOM", "ELSET", of(lambda e: e[1] == last)))
    laws = {"TREAD": (0.29, 0.0094), "BULK": (0.060, 0.0002)}
    materials = []
    for name, (k, slope) in laws.items():
        table = [k + slope * 20.0] if linear else [f"{k + slope * (T - 20.0)}, {T}" for T in (0.0, 300.0)]
        materials += [f"*MATERIAL, NAME={name}", "*DENSITY", "1100.", "*SPECIFIC HEAT", "1800.", "*CONDUCTIVITY", *map(str, table),
                      f"*SOLID SECTION, ELSET={name}, MATERIAL={name}"]
    films = ["*FILM", f"TOP, F2, {AIR}, 10.", f"BOTTOM, F1, {AIR}, 10.", "*DFLUX", f"LIT, S2, {FLUX}"]
    probes = {"top": number[0.0, 0.0, 0.0], "bottom": number[0.0, 0.0, -15e-3]}
    return number, elements, sets, materials, films, probes, [10.0, 60.0, 300.0, 600.0]


def section(nx, nz):
    half = graded(0.0, 0.1125, nx // 2, 6.0)
    xs = half + [0.225 - x for x in half[-2::-1]]
    strip = lambda a: (lambda u, v: (xs[a] + (xs[a + 1] - xs[a]) * u, 0.01 * v))
    number, elements = mesh([(strip(a), 1, 1, a) for a in range(nx)], [0.015 * i / nz for i in range(nz + 1)])
    ids = range(1, len(elements) + 1)
    of = lambda chosen: [i for i, e in zip(ids, elements) if chosen(e)]
    sets = (listed("ALL", "ELSET", ids) + listed("TOP", "ELSET", of(lambda e: e[1] == 0)) +
            listed("BOTTOM", "ELSET", of(lambda e: e[1] == nz - 1)) +
            listed("LEFT", "ELSET", of(lambda e: e[2] == 0)) + listed("RIGHT", "ELSET", of(lambda e: e[2] == nx - 1)))
    materials = ["*MATERIAL, NAME=RUBBER", "*DENSITY", "1100.", "*SPECIFIC HEAT", "1800.", "*CONDUCTIVITY", "0.25",
                 "*SOLID SECTION, ELSET=ALL, MATERIAL=RUBBER"]
    films = ["*FILM", f"TOP, F2, {AIR}, 60.", f"BOTTOM, F1, {AIR}, 10.", f"LEFT, F6, {AIR}, 20.", f"RIGHT, F4, {AIR}, 20.",
             "*DFLUX", "ALL, BF, 1e5"]
    probes = {"top": number[0.1125, 0.0, 0.0], "bottom": number[0.1125, 0.0, -0.015], "centre": number[0.1125, 0.0, -0.0075]}
    return number, elements, sets, materials, films, probes, [60.0, 300.0, 600.0, 1200.0]


def steps(moments, growth, longest, films):
    """A *STEP to each moment and, between them, to each doubling of the time; its increments are equal."""
    lines, t = [], 0.0
    ends = [moments[0] * 0.5**i for i in range(8, 0, -1)]
    for a, b in zip(moments, moments[1:]):
        pieces = max(1, round(math.log2(b / a)))
        ends += [a * (b / a) ** (i / pieces) for i in range(pieces)]
    for end in [*ends, moments[-1]]:
        increments = math.ceil((end - t) / min(longest, growth * 0.5 * (end + t)) - 0.3)
        lines += [f"*STEP, INC={increments + 1}", "*HEAT TRANSFER, DIRECT, SOLVER=ITERATIVE SCALING",
                  f"{(end - t) / increments:.12g}, {end - t:.12g}", *([] if t else films)]
        lines += ["*NODE PRINT, NSET=PROBES, FREQUENCY=10000", *(["NT"] if end in moments else []), "*END STEP"]
        t = end
    return lines


def main():
    problem, counts, (growth, longest) = sys.argv[1], map(int, sys.argv[2:-2]), map(float, sys.argv[-2:])
    number, elements, sets, materials, films, probes, moments = section(*counts) if problem == "section" else \
        slab(problem == "slab_linear", *counts)
    lines = ["*NODE, NSET=NALL", *(f"{n}, {x:.9g}, {y:.9g}, {z:.9g}" for (x, y, z), n in number.items()),
             "*ELEMENT, TYPE=DC3D20"]
    for i, (nodes, _, _) in enumerate(elements, 1):
        lines += [f"{i}, " + ", ".join(map(str, nodes[:10])) + ",", ", ".join(map(str, nodes[10:]))]
    lines += sets + listed("PROBES", "NSET", probes.values()) + materials
    lines += ["*INITIAL CONDITIONS, TYPE=TEMPERATURE", f"NALL, {AIR}", *steps(moments, growth, longest, films)]
    with open(f"{problem}.inp", "w") as file:
        file.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
