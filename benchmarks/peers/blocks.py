#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A peer for the comparison alone: the script that an engineer at home in SciPy would write. It shares no source with tiretherm.

A block of graded cells with k(T) by layers, by finite volumes in NumPy; SDIRK of order 2 with growing steps. In three
dimensions conjugate gradients, preconditioned by the tridiagonal systems through the thickness (LAPACK pttrf, pttrs); in two
a sparse factor (splu), kept while the step is the same.
Call: blocks.py PROBLEM [steps [finer]]; prints one line per moment and probe. finer: slab's cells along each edge, as a factor.
"""
import sys

import numpy as np
import scipy.sparse as sparse
from scipy.linalg.lapack import dpttrf, dpttrs
from scipy.sparse.linalg import splu

AIR, HEAT = 23.0, 1100.0 * 1800.0
GAMMA = 1.0 - np.sqrt(0.5)


def edges(*segments):
    out = [0.0]
    for to, cells, ratio in segments:
        widths = ratio ** np.linspace(0.0, 1.0, cells) if cells > 1 else np.ones(1)
        out.extend(out[-1] + (to - out[-1]) * np.cumsum(widths) / widths.sum())
    return np.array(out)


class Block:
    """Arrays [nx, ny, nz]; z through the thickness."""

    def __init__(self, name, finer):
        cells = lambda n: round(finer * n)
        self.slab = name != "section"
        if self.slab:
            side = edges((7.5e-3, cells(5), 1.0), (30e-3, cells(11), 3.0))
            self.edges = [side, side, edges((3e-3, cells(8), 4.2), (15e-3, cells(50), 0.8))]
            self.h_top = self.h_bottom = 10.0
            self.h_side, self.source, self.moments = 0.0, 0.0, [10.0, 60.0, 300.0, 600.0]
        else:
            self.edges = [np.linspace(0, 0.225, 451), np.array([0.0, 1.0]), np.linspace(0, 0.015, 61)]
            self.h_top, self.h_bottom, self.h_side = 60.0, 10.0, 20.0
            self.source, self.moments = 1e5, [60.0, 300.0, 600.0, 1200.0]
        self.d = [np.diff(e) for e in self.edges]
        self.mid = [0.5 * (e[1:] + e[:-1]) for e in self.edges]
        self.shape = tuple(len(d) for d in self.d)
        dx, dy, dz = np.ix_(*self.d)
        self.area = [dy * dz + 0 * dx, dx * dz + 0 * dy, dx * dy + 0 * dz]
        self.C = HEAT * dx * dy * dz
        top = (self.mid[2] < 3e-3) & self.slab
        self.nonlinear = name == "slab_nonlinear"
        self.k0 = np.where(top, 0.29 if self.nonlinear else 0.478, 0.060 if self.nonlinear else 0.064) if self.slab else 0.25
        self.k1 = np.where(top, 0.0094, 0.0002) if self.nonlinear else 0.0
        self.spot = self.light() if self.slab else 0.0

    def light(self):
        x, y, inside = *self.edges[:2], np.zeros(self.shape[:2])
        points = (np.arange(64) + 0.5) / 64
        for i in range(self.shape[0]):
            for j in range(self.shape[1]):
                u, v = x[i] + points * self.d[0][i], y[j] + points * self.d[1][j]
                inside[i, j] = np.mean(u[:, None] ** 2 + v[None, :] ** 2 < 5.6419e-3**2)
        return inside * 0.25 / np.sum(inside * self.area[2][:, :, 0])

    def conduct(self, T):
        k = self.k0 + self.k1 * (T - 20.0)
        self.k = k = np.broadcast_to(k, self.shape)
        self.G = []
        for axis in range(3):
            half = np.moveaxis(0.5 * self.d[axis].reshape([-1 if a == axis else 1 for a in range(3)]) / k, axis, 0)
            area = np.moveaxis(np.broadcast_to(self.area[axis], self.shape), axis, 0)
            self.G.append(np.moveaxis(area[:-1] / (half[1:] + half[:-1]), 0, axis))
        self.out = np.zeros(self.shape)
        dz, dx = self.d[2], self.d[0]
        at_top = self.area[2][:, :, 0] / (1.0 / self.h_top + 0.5 * dz[0] / k[:, :, 0])
        self.out[:, :, 0] += at_top
        self.out[:, :, -1] += self.area[2][:, :, -1] / (1.0 / self.h_bottom + 0.5 * dz[-1] / k[:, :, -1])
        if self.h_side:
            for i in (0, -1):
                self.out[i] += self.area[0][i] / (1.0 / self.h_side + 0.5 * dx[i] / k[i])
        self.heat = self.source * self.C / HEAT
        if self.slab:
            self.heat[:, :, 0] += at_top * self.spot / self.h_top
        self.row = self.out.copy()
        for axis, G in enumerate(self.G):
            low, high = [slice(None)] * 3, [slice(None)] * 3
            low[axis], high[axis] = slice(None, -1), slice(1, None)
            self.row[tuple(low)] += G
            self.row[tuple(high)] += G

    def couple(self, T):
        """Off-diagonal part of K T, with the sign turned."""
        q = np.zeros(self.shape)
        q[:-1] += self.G[0] * T[1:]
        q[1:] += self.G[0] * T[:-1]
        q[:, :-1] += self.G[1] * T[:, 1:]
        q[:, 1:] += self.G[1] * T[:, :-1]
        q[:, :, :-1] += self.G[2] * T[:, :, 1:]
        q[:, :, 1:] += self.G[2] * T[:, :, :-1]
        return q

    def flow(self, T):
        return self.heat + self.out * AIR - self.row * T + self.couple(T)

    def lines(self, s):
        beside = np.zeros(self.shape)
        beside[:, :, :-1] = -s * self.G[2]
        self.diagonal = self.C + s * self.row
        self.pivot, self.lower, _ = dpttrf(self.diagonal.ravel(), beside.ravel()[:-1])

    def solve_iteratively(self, s, right, tolerance):
        x, r = np.zeros(self.shape), right.copy()
        precondition = lambda v: dpttrs(self.pivot, self.lower, v.ravel())[0].reshape(self.shape)
        z = precondition(r)
        p, rz = z.copy(), np.vdot(r, z)
        while np.max(np.abs(r) / self.diagonal) > tolerance:
            w = self.diagonal * p - s * self.couple(p)
            step = rz / np.vdot(p, w)
            x += step * p
            r -= step * w
            z = precondition(r)
            rz, before = np.vdot(r, z), rz
            p = z + rz / before * p
        return x

    def factor(self, s):
        n, diagonals, offsets = self.C.size, [(self.C + s * self.row).ravel()], [0]
        strides = (self.shape[1] * self.shape[2], self.shape[2], 1)
        for axis, stride in enumerate(strides):
            beside = np.zeros(self.shape)
            low = [slice(None)] * 3
            low[axis] = slice(None, -1)
            beside[tuple(low)] = -s * self.G[axis]
            if self.shape[axis] > 1:
                diagonals += [beside.ravel()[: n - stride]] * 2
                offsets += [stride, -stride]
        return splu(sparse.diags(diagonals, offsets, format="csc"), permc_spec="MMD_AT_PLUS_A",
                    options={"SymmetricMode": True}, diag_pivot_thresh=0.0)

    def surface(self, T, end):
        to_cell = 2.0 * self.k[:, :, end] / self.d[2][end]
        h = self.h_top if end == 0 else self.h_bottom
        return (h * AIR + (self.spot if end == 0 else 0.0) + to_cell * T[:, :, end]) / (h + to_cell)

    def print(self, t, T):
        self.conduct(T)
        top, bottom = self.surface(T, 0), self.surface(T, -1)
        if self.slab:
            a, b = self.mid[0][0] ** 2, self.mid[0][1] ** 2
            even = lambda u, v: u + (u - v) * a / (b - a)
            for name, f in (("top", top), ("bottom", bottom)):
                print(f"{t:g} {name} {even(even(f[0, 0], f[0, 1]), even(f[1, 0], f[1, 1])):.6f}")
            return
        i, m = self.shape[0] // 2, self.shape[2] // 2
        print(f"{t:g} top {top[i - 1 : i + 1].mean():.6f}")
        print(f"{t:g} bottom {bottom[i - 1 : i + 1].mean():.6f}")
        print(f"{t:g} centre {T[i - 1 : i + 1, :, m - 1 : m + 1].mean():.6f}")


def march(block, steps):
    """Steps that grow by a constant factor; in two dimensions they double instead, so that a factor serves several."""
    end, t = block.moments[-1], 0.0
    growth = 300.0 ** (1.0 / steps)
    dt = end * (growth - 1.0) / (growth**steps - 1.0)
    smallest, kept = dt, {}
    T = np.full(block.shape, AIR)
    block.conduct(T)
    for moment in block.moments:
        while t < moment - 1e-9:
            left = moment - t
            if block.slab:
                h = left if left < 1.5 * dt else 0.5 * left if left < 3 * dt else dt
            else:
                h = smallest * 2.0 ** np.floor(np.log2(max(dt / smallest, 1.0)))
                h = left / np.ceil(left / h - 1e-9)
            known, q1, stage = T, None, T.copy()
            for s in range(2):
                for _ in range(8):
                    if block.nonlinear:
                        block.conduct(stage)
                    right = block.C * (T - stage) + GAMMA * h * block.flow(stage)
                    if s == 1:
                        right += (1.0 - GAMMA) * h * q1
                    if block.slab:
                        block.lines(GAMMA * h)
                        change = block.solve_iteratively(GAMMA * h, right, 2e-4)
                    else:
                        key = round(np.log(h) * 1e6)
                        if key not in kept:
                            kept = {key: block.factor(GAMMA * h)}
                        change = kept[key].solve(right.ravel()).reshape(block.shape)
                    stage = stage + change
                    if not block.nonlinear or np.max(np.abs(change)) < 0.02:
                        break
                if s == 0:
                    if block.nonlinear:
                        block.conduct(stage)
                    q1 = block.flow(stage)
            T = stage
            t += h
            dt *= growth
        t = moment
        block.print(t, T)


if __name__ == "__main__":
    march(Block(sys.argv[1], float(sys.argv[3]) if len(sys.argv) > 3 else 1.0), int(sys.argv[2]) if len(sys.argv) > 2 else 34)
