#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a case of OpenFOAM's chtMultiRegionFoam into the working folder: two solid regions for the slab, one for the section.

Call: case.py slab_linear|slab_nonlinear DISC RINGS FAR TREAD BULK STEPS LONGEST PASSES, or
      case.py section WIDE HIGH STEPS LONGEST
Plan of the slab's quarter: an O-grid by blockMesh, whose arcs are the light's edge. Numbers of cells: DISC along the square in
its middle, RINGS and FAR outwards, TREAD and BULK downwards; WIDE and HIGH are odd, so that the centre is that of a cell. Steps
grow by a constant factor as those of the other peers; the second-order scheme is `backward`. The light is part of the air's
temperature (q / h). PASSES: over the regions and k(T) in a step.
"""
import math
import pathlib
import sys

AIR, H = 296.15, 10.0
R, SIDE, FLUX = 5.6419e-3, 30e-3, 1e4
HEAD = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"


def write(path, text, kind="dictionary"):
    file = pathlib.Path(path)
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(HEAD.format(kind, file.name) + text)


def slab_mesh(low, high, patches, plan, cells, expansion):
    n, rings, far = plan
    s = math.sqrt(0.5)
    corners = [(0, 0), (0.75 * R, 0), (0.62 * R, 0.62 * R), (0, 0.75 * R), (R, 0), (s * R, s * R), (0, R), (SIDE, 0), (SIDE, SIDE),
               (0, SIDE)]
    points = [(x, y, z) for z in (low, high) for x, y in corners]
    blocks = [((0, 1, 2, 3), n, n, 1), ((1, 4, 5, 2), rings, n, 1), ((3, 2, 5, 6), n, rings, 1), ((4, 7, 8, 5), far, n, 6),
              ((6, 5, 8, 9), n, far, 6)]
    text = "vertices (" + " ".join(f"({x:.9g} {y:.9g} {z:.9g})" for x, y, z in points) + ");\nblocks (\n"
    for i, (around, nx, ny, grading) in enumerate(blocks):
        x, y = (grading, 1) if i == 3 else (1, grading)
        vertices = " ".join(map(str, [*around, *(c + 10 for c in around)]))
        text += f"hex ({vertices}) ({nx} {ny} {cells}) simpleGrading ({x} {y} {expansion})\n"
    text += ");\nedges (\n"
    for a, b, angle in ((4, 5, 22.5), (5, 6, 67.5)):
        x, y = R * math.cos(math.radians(angle)), R * math.sin(math.radians(angle))
        text += "".join(f"arc {a + k} {b + k} ({x:.9g} {y:.9g} {z:.9g})\n" for k, z in ((0, low), (10, high)))
    faces = {"disc": [(0, 1, 2, 3), (1, 4, 5, 2), (3, 2, 5, 6)], "around": [(4, 7, 8, 5), (6, 5, 8, 9)]}
    text += ");\nboundary (\n"
    for name, kind, which, shift in patches:
        listed = " ".join("(" + " ".join(str(c + shift) for c in face) + ")" for part in which for face in faces[part])
        text += f"{name} {{ {kind} faces ({listed}); }}\n"
    return text + ");\ndefaultPatch { name sides; type wall; }\n"


def section_mesh(nx, nz):
    points = [(x, y, z) for z in (-0.015, 0) for y in (0, 0.01) for x in (0, 0.225)]
    return ("vertices (" + " ".join(f"({x} {y} {z})" for x, y, z in points) + ");\n"
            f"blocks (hex (0 1 3 2 4 5 7 6) ({nx} 1 {nz}) simpleGrading (1 1 1));\nboundary (\n"
            "top { type wall; faces ((4 5 7 6)); }\nbottom { type wall; faces ((0 1 3 2)); }\n"
            "left { type wall; faces ((0 2 6 4)); }\nright { type wall; faces ((1 3 7 5)); }\n);\n"
            "defaultPatch { name sides; type empty; }\n")


def material(k, slope):
    """k at 0 K and its slope: a polynomial where it has a slope, else the constant laws, which are cheaper."""
    if slope:
        kinds, zeros = ("polynomial", "hPolynomial", "icoPolynomial"), "0 0 0 0 0 0"
        laws = (f"transport {{ kappaCoeffs<8> ({k} {slope} {zeros}); }} "
                f"thermodynamics {{ Hf 0; Sf 0; CpCoeffs<8> (1800 0 {zeros}); }} "
                f"equationOfState {{ rhoCoeffs<8> (1100 0 {zeros}); }}")
    else:
        kinds = ("constIso", "hConst", "rhoConst")
        laws = f"transport {{ kappa {k}; }} thermodynamics {{ Hf 0; Cp 1800; }} equationOfState {{ rho 1100; }}"
    return (f"thermoType {{ type heSolidThermo; mixture pureMixture; transport {kinds[0]}; thermo {kinds[1]}; "
            f"equationOfState {kinds[2]}; specie specie; energy sensibleEnthalpy; }}\n"
            f"mixture {{ specie {{ molWeight 1; }} {laws} }}\n")


def film(h, air=AIR):
    return (f"{{ type externalWallHeatFluxTemperature; mode coefficient; h uniform {h}; Ta constant {air}; "
            f"kappaMethod solidThermo; value uniform {AIR}; }}")


INTERFACE = ("{ type compressible::turbulentTemperatureCoupledBaffleMixed; Tnbr T; kappaMethod solidThermo; "
             f"value uniform {AIR}; }}")


def region(name, mesh, law, boundary, relative=0.01):
    write(f"system/{name}/blockMeshDict", mesh)
    write(f"system/{name}/fvSchemes", "ddtSchemes { default backward; }\ngradSchemes { default Gauss linear; }\n"
          "divSchemes { default none; }\nlaplacianSchemes { default Gauss linear corrected; }\n"
          "interpolationSchemes { default linear; }\nsnGradSchemes { default corrected; }\n")
    solver = f"solver PCG; preconditioner DIC; tolerance 1e-9; relTol {relative}"
    write(f"system/{name}/fvSolution", f"solvers {{ h {{ {solver}; }} hFinal {{ {solver}; }} }}\n"
          "PIMPLE { nNonOrthogonalCorrectors 0; }\n")
    write(f"constant/{name}/thermophysicalProperties", law)
    fields = "\n".join(f"{patch} {kind}" for patch, kind in boundary.items())
    write(f"0/{name}/T", f"dimensions [0 0 0 1 0 0 0];\ninternalField uniform {AIR};\nboundaryField {{\n{fields}\n}}\n",
          "volScalarField")
    flat = "\n".join(f"{patch} {'{ type empty; }' if 'empty' in kind else '{ type calculated; value uniform 1e5; }'}"
                     for patch, kind in boundary.items())
    write(f"0/{name}/p", f"dimensions [1 -1 -2 0 0 0 0];\ninternalField uniform 1e5;\nboundaryField {{\n{flat}\n}}\n",
          "volScalarField")


def step_ends(moments, steps, longest):
    """As the other peers: each step a constant factor longer; those before a moment are stretched to end there."""
    end, t = moments[-1], 0.0
    growth = 300.0 ** (1.0 / steps)
    dt, out = end * (growth - 1.0) / (growth**steps - 1.0), [0.0]
    for moment in moments:
        while t < moment - 1e-9:
            left = moment - t
            dt = min(dt, longest)
            t += left if left < 1.5 * dt else 0.5 * left if left < 3 * dt else dt
            dt *= growth
            out.append(t)
    return out


def main():
    problem, settings = sys.argv[1], list(map(int, sys.argv[2:]))
    zero = "{ type zeroGradient; }"
    if problem == "section":
        nx, nz, steps, longest = settings
        moments, regions, top, passes = [60.0, 300.0, 600.0, 1200.0], "rubber", "top", 1
        region("rubber", section_mesh(nx, nz), material(0.25, 0),
               {"top": film(60), "bottom": film(10), "left": film(20), "right": film(20), "sides": "{ type empty; }"}, 1e-5)
        write("constant/rubber/fvOptions", "heat { type scalarSemiImplicitSource; active yes; selectionMode all; "
              "volumeMode specific; injectionRateSuSp { h (1e5 0); } }\n")
    else:
        *plan, tread, bulk, steps, longest, passes = settings
        moments, regions, top = [10.0, 60.0, 300.0, 600.0], "tread bulk", "lit"
        laws = [material(k + slope * 20.0, 0) if problem == "slab_linear" else material(k - slope * 293.15, slope)
                for k, slope in ((0.29, 0.0094), (0.060, 0.0002))]
        beside = "type mappedWall; sampleMode nearestPatchFace; samplePatch interface; sampleRegion"
        whole = ["disc", "around"]
        region("tread", slab_mesh(-3e-3, 0, [("lit", "type wall;", ["disc"], 10), ("top", "type wall;", ["around"], 10),
                                            ("interface", f"{beside} bulk;", whole, 0)], plan, tread, 1 / 4.2), laws[0],
               {"lit": film(H, AIR + FLUX / H), "top": film(H), "interface": INTERFACE, "sides": zero})
        region("bulk", slab_mesh(-15e-3, -3e-3, [("interface", f"{beside} tread;", whole, 10), ("bottom", "type wall;", whole, 0)],
                                 plan, bulk, 1 / 1.2), laws[1], {"interface": INTERFACE, "bottom": film(H), "sides": zero})
    write("constant/regionProperties", f"regions (fluid () solid ({regions}));\n")
    write("constant/g", "dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 0);\n", "uniformDimensionedVectorField")
    write("system/fvSchemes", "ddtSchemes { default backward; }\n")
    write("system/fvSolution", f"PIMPLE {{ nOuterCorrectors {passes}; }}\n")
    ends = step_ends(moments, steps, longest)
    first_step = ends[1] / 1.2  # chtMultiRegionFoam lengthens it
    table = " ".join(f"({a:.10g} {b - a if a else first_step:.10g})" for a, b in zip(ends, ends[1:])) + f" ({ends[-1]:.10g} 1)"
    sample = lambda region, patch: (f"{region}_{patch} {{ type surfaces; libs (sampling); region {region}; surfaceFormat raw; "
                                    f"fields (T); interpolationScheme cell; "
                                    f"surfaces {{ {patch} {{ type patch; patches ({patch}); }} }} }}\n")
    probe = "middle { type probes; libs (sampling); region rubber; fields (T); probeLocations ((0.1125 0.005 -0.0075)); }\n"
    first = regions.split()[0]
    write("system/controlDict", "application chtMultiRegionFoam;\n"
          f"startFrom startTime; startTime 0; stopAt endTime; endTime {moments[-1]};\n"
          f"deltaT {first_step:.10g}; adjustTimeStep yes; maxCo 1e9; maxDi 1e9; maxDeltaT 1e9;\n"
          "writeControl runTime; writeInterval 1e9; timePrecision 12;\nfunctions {\n"
          f"steps {{ type setTimeStep; libs (utilityFunctionObjects); deltaT table ({table}); }}\n"
          f"{sample(first, top)}{sample(regions.split()[-1], 'bottom')}{probe if problem == 'section' else ''}}}\n")


if __name__ == "__main__":
    main()
