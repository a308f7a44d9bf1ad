#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A peer for the comparison alone: the problems in FEniCSx, as its user would write them. It shares no source with tiretherm.

Trilinear hexahedra (in two dimensions bilinear quadrilaterals) on a graded mesh, SDIRK of order 2 with growing steps; k(T)
by fixed-point iteration. PETSc solves: conjugate gradients with incomplete Cholesky, in two dimensions Cholesky by MUMPS.
Call: dolfinx_blocks.py PROBLEM [steps [finer]]; prints one line per moment and probe. finer: cells along each edge, as a factor.
Forms are compiled at the first call and kept in FEniCSx's own cache.
"""
import sys

import numpy as np
import ufl
from dolfinx import fem, mesh
from dolfinx.fem.petsc import assemble_matrix, assemble_vector
from mpi4py import MPI
from petsc4py import PETSc

AIR, HEAT = 23.0, 1100.0 * 1800.0
GAMMA = 1.0 - np.sqrt(0.5)


def edges(*segments):
    out = [0.0]
    for to, cells, ratio in segments:
        widths = ratio ** np.linspace(0.0, 1.0, cells) if cells > 1 else np.ones(1)
        out.extend(out[-1] + (to - out[-1]) * np.cumsum(widths) / widths.sum())
    return np.array(out)


class Block:
    """The last coordinate is the depth."""

    def __init__(self, name, finer):
        cells = lambda n: round(finer * n)
        self.slab, self.nonlinear = name != "section", name == "slab_nonlinear"
        if self.slab:
            side = edges((7.5e-3, cells(6), 1.0), (30e-3, cells(8), 3.0))
            lines = [side, side, edges((3e-3, cells(10), 4.2), (15e-3, cells(50), 0.6))]
            self.moments = [10.0, 60.0, 300.0, 600.0]
            made = mesh.create_box(MPI.COMM_WORLD, [np.zeros(3), np.ones(3)], [len(e) - 1 for e in lines],
                                   mesh.CellType.hexahedron)
        else:
            lines = [np.linspace(0, 0.225, cells(225) + 1), np.linspace(0, 0.015, cells(30) + 1)]
            self.moments = [60.0, 300.0, 600.0, 1200.0]
            made = mesh.create_rectangle(MPI.COMM_WORLD, [np.zeros(2), np.ones(2)], [len(e) - 1 for e in lines],
                                         mesh.CellType.quadrilateral)
        for axis, line in enumerate(lines):
            x = made.geometry.x[:, axis]
            made.geometry.x[:, axis] = line[np.rint(x * (len(line) - 1)).astype(int)]
        depth = len(lines) - 1
        self.V = V = fem.FunctionSpace(made, ("CG", 1))
        self.T = fem.Function(V)
        u, v = ufl.TrialFunction(V), ufl.TestFunction(V)
        facets, marks = self.faces(made, lines, depth)
        tags = mesh.meshtags(made, made.topology.dim - 1, facets, marks)
        dx = ufl.Measure("dx", made, metadata={"quadrature_degree": 2})
        ds = ufl.Measure("ds", made, subdomain_data=tags, metadata={"quadrature_degree": 2})
        if self.slab:
            top = ufl.lt(ufl.SpatialCoordinate(made)[depth], 3e-3)
            if self.nonlinear:
                k = ufl.conditional(top, 0.29 + 0.0094 * (self.T - 20.0), 0.060 + 0.0002 * (self.T - 20.0))
            else:
                k = ufl.conditional(top, 0.478, 0.064)
            films, source = {1: 10.0, 2: 10.0}, 0.0
        else:
            k, films, source = fem.Constant(made, PETSc.ScalarType(0.25)), {1: 60.0, 2: 10.0, 3: 20.0}, 1e5
        film = sum(h * u * v * ds(mark) for mark, h in films.items())
        heat = sum(h * AIR * v * ds(mark) for mark, h in films.items()) + source * v * dx
        fast = {"cffi_extra_compile_args": ["-O3", "-march=native", "-ffast-math"]}
        self.stiffness = fem.form(k * ufl.inner(ufl.grad(u), ufl.grad(v)) * dx + film, jit_params=fast)
        self.M = assemble_matrix(fem.form(HEAT * u * v * dx))
        self.M.assemble()
        self.K = assemble_matrix(self.stiffness)
        self.K.assemble()
        self.A = self.M.duplicate()
        self.heat = assemble_vector(fem.form(heat))
        if self.slab:  # the edge of the spot cuts facets: many points on a plain rule
            x = ufl.SpatialCoordinate(made)
            fine = ufl.Measure("ds", made, subdomain_data=tags, metadata={"quadrature_degree": 20})
            spot = assemble_vector(fem.form(ufl.conditional(ufl.lt(x[0] ** 2 + x[1] ** 2, 5.6419e-3**2), 1.0, 0.0) * v * fine(1)))
            self.heat.axpy(0.25 / spot.sum(), spot)
        self.solver = PETSc.KSP().create(MPI.COMM_WORLD)
        if self.slab:
            self.solver.setType("cg")
            self.solver.getPC().setType("icc")
            self.solver.setTolerances(rtol=1e-5, atol=1e-50)
        else:
            self.solver.setType("preonly")
            self.solver.getPC().setType("cholesky")
            self.solver.getPC().setFactorSolverType("mumps")
        self.at = {name: self.vertex(made, V, place) for name, place in self.places(lines).items()}

    @staticmethod
    def faces(made, lines, depth):
        dim, found, marks = made.topology.dim, [], []
        for mark, axis, place in ((1, depth, 0.0), (2, depth, lines[depth][-1]), (3, 0, 0.0), (3, 0, lines[0][-1])):
            here = mesh.locate_entities_boundary(made, dim - 1, lambda x: np.isclose(x[axis], place))
            found.append(here)
            marks.append(np.full(len(here), mark, dtype=np.int32))
        found, marks = np.concatenate(found), np.concatenate(marks)
        order = np.argsort(found)
        return found[order], marks[order]

    def places(self, lines):
        middle = 0.0 if self.slab else lines[0][len(lines[0]) // 2]
        at = {"top": 0.0, "bottom": lines[-1][-1]}
        if not self.slab:
            at["centre"] = lines[-1][len(lines[-1]) // 2]
        return {name: np.array(([middle, 0.0, z] if self.slab else [middle, z, 0.0])) for name, z in at.items()}

    @staticmethod
    def vertex(made, V, place):
        return int(np.argmin(np.linalg.norm(V.tabulate_dof_coordinates() - place, axis=1)))

    def conduct(self, T):
        if self.nonlinear:
            T.copy(self.T.vector)
            self.K.zeroEntries()
            assemble_matrix(self.K, self.stiffness)
            self.K.assemble()

    def set_matrix(self, s):
        self.M.copy(self.A, PETSc.Mat.Structure.SAME_NONZERO_PATTERN)
        self.A.axpy(s, self.K, PETSc.Mat.Structure.SAME_NONZERO_PATTERN)
        self.solver.setOperators(self.A)

    def print(self, t, T):
        for name, vertex in self.at.items():
            print(f"{t:g} {name} {T[vertex]:.6f}")


def march(block, steps):
    """Steps that grow by a constant factor; in two dimensions they double instead, so that a factor serves several."""
    end, t = block.moments[-1], 0.0
    growth = 300.0 ** (1.0 / steps)
    dt = smallest = end * (growth - 1.0) / (growth**steps - 1.0)
    factored = None
    T = block.heat.duplicate()
    T.set(AIR)
    stage, right, change, q1, flow, slope = (T.duplicate() for _ in range(6))
    for moment in block.moments:
        while t < moment - 1e-9:
            left = moment - t
            if block.slab:
                h = left if left < 1.5 * dt else 0.5 * left if left < 3 * dt else dt
            else:
                h = smallest * 2.0 ** np.floor(np.log2(max(dt / smallest, 1.0)))
                h = left / np.ceil(left / h - 1e-9)
            T.copy(stage)
            for s in range(2):
                stage.axpy((GAMMA if s == 0 else 1.0 - GAMMA) * h, slope)  # the guess goes on as the last step went
                for _ in range(8):
                    block.conduct(stage)
                    if block.nonlinear or factored is None or abs(h / factored - 1.0) > 1e-6:
                        block.set_matrix(GAMMA * h)
                        factored = h
                    block.K.mult(stage, flow)
                    flow.aypx(-1.0, block.heat)
                    T.copy(change)
                    change.axpy(-1.0, stage)
                    block.M.mult(change, right)
                    right.axpy(GAMMA * h, flow)
                    if s == 1:
                        right.axpy((1.0 - GAMMA) * h, q1)
                    block.solver.solve(right, change)
                    stage.axpy(1.0, change)
                    if not block.nonlinear or change.norm(PETSc.NormType.INFINITY) < 0.05:
                        break
                if s == 0:
                    block.conduct(stage)
                    block.K.mult(stage, q1)
                    q1.aypx(-1.0, block.heat)
            slope.waxpy(-1.0, T, stage)
            slope.scale(1.0 / h)
            stage.copy(T)
            t += h
            dt *= growth
        t = moment
        block.print(t, T.array_r)


if __name__ == "__main__":
    march(Block(sys.argv[1], float(sys.argv[3]) if len(sys.argv) > 3 else 1.0), int(sys.argv[2]) if len(sys.argv) > 2 else 34)
