#!/usr/bin/env python3
"""Writes independent.json: pairs of rotors, their statics, effective masses and spectra, for independent.rs to compare with.

An implementation of its own of Hua, Lim, Peng and Wali (2012), in another language and by other means than the program's:

- statics at 40 decimal digits (mpmath), bearings as whole 6x6 matrices, rigid supports removed from the system;
- first bending modes by transfer matrices at 40 digits: the exponential as a plain Taylor series, springs simply added to the shear force
  and the moment, roots by a fine scan of the determinant and bisection, the integral T by 24-point Gauss on halves of the pieces;
- spectra by a dense complex solve of (14) over all coordinates in numpy.

    python3 -m pip install numpy mpmath
    python3 tests/verification/independent.py > tests/verification/independent.json
"""

import json
import math
import random
import sys

import mpmath as mp
import numpy as np

mp.mp.dps = 40
SAME = 1e-9
ORDER = {"x": 0, "y": 1, "z": 2}
HELD = [0, 1, 2, 3, 5]


class Section:
    def __init__(self, segment, material, theory):
        e, nu, rho = (mp.mpf(material[k]) for k in ("youngs_modulus", "poissons_ratio", "density"))
        d, b = mp.mpf(segment["outer_diameter"]), mp.mpf(segment["inner_diameter"])
        self.a = mp.pi / 4 * (d**2 - b**2)
        self.i = mp.pi / 64 * (d**4 - b**4)
        self.e, self.rho, self.g = e, rho, e / (2 * (1 + nu))
        r2 = (b / d) ** 2
        self.kappa = 6 * (1 + nu) * (1 + r2) ** 2 / ((7 + 6 * nu) * (1 + r2) ** 2 + (20 + 12 * nu) * r2)
        self.timoshenko = theory == "timoshenko"


class Shaft:
    """Stations and what stands on them; every array over all stations, six coordinates each."""

    def __init__(self, design, rotor):
        self.rotor = rotor
        ends, at = [], 0.0
        marks = [0.0]
        for segment in rotor["segments"]:
            n, length = segment["elements"], segment["length"]
            marks += [at + length * i / n for i in range(1, n)]
            at += length
            marks.append(at)
            ends.append((at, Section(segment, design["materials"][segment["material"]], design["beam_theory"])))
        marks += [b["position"] for b in rotor["bodies"] + rotor["bearings"]]
        marks += [rotor["mesh_position"], rotor["drive"]["position"]]
        self.y = []
        for m in sorted(marks):
            if not self.y or m - self.y[-1] > SAME:
                self.y.append(m)
        middles = [(p + q) / 2 for p, q in zip(self.y, self.y[1:])]
        self.sections = [next(s for end, s in ends if m < end) for m in middles]
        self.lengths = [mp.mpf(q) - mp.mpf(p) for p, q in zip(self.y, self.y[1:])]
        self.mesh = self.at(rotor["mesh_position"])
        self.drive = self.at(rotor["drive"]["position"])

    def at(self, position):
        return min(range(len(self.y)), key=lambda i: abs(self.y[i] - position))


def element(s, length):
    """Stiffness and consistent mass, 12 x 12."""
    k, m = mp.zeros(12), mp.zeros(12)

    def put(target, places, signs, block):
        for i, p in enumerate(places):
            for j, q in enumerate(places):
                target[p, q] += signs[i] * signs[j] * block[i][j]

    p = 12 * s.e * s.i / (s.kappa * s.g * s.a * length**2) if s.timoshenko else mp.mpf(0)
    l = length
    c = s.e * s.i / ((1 + p) * l**3)
    bending = [[12, 6 * l, -12, 6 * l], [6 * l, (4 + p) * l**2, -6 * l, (2 - p) * l**2],
               [-12, -6 * l, 12, -6 * l], [6 * l, (2 - p) * l**2, -6 * l, (4 + p) * l**2]]
    bending = [[c * v for v in row] for row in bending]
    # consistent mass from the static shape functions themselves, integrated exactly (Gauss, degree 6)
    mass = [[mp.mpf(0)] * 4 for _ in range(4)]
    for node, weight in GAUSS:
        x = (node + 1) / 2
        w = weight * l / 2
        shape = [(1 - 3 * x**2 + 2 * x**3 + p * (1 - x)) / (1 + p),
                 l * (x - 2 * x**2 + x**3 + p / 2 * (x - x**2)) / (1 + p),
                 (3 * x**2 - 2 * x**3 + p * x) / (1 + p),
                 l * (-(x**2) + x**3 - p / 2 * (x - x**2)) / (1 + p)]
        tilt = [6 / l * (-x + x**2) / (1 + p), (1 - 4 * x + 3 * x**2 + p * (1 - x)) / (1 + p),
                6 / l * (x - x**2) / (1 + p), (-2 * x + 3 * x**2 + p * x) / (1 + p)]
        for i in range(4):
            for j in range(4):
                mass[i][j] += w * s.rho * s.a * shape[i] * shape[j]
                if s.timoshenko:
                    mass[i][j] += w * s.rho * s.i * tilt[i] * tilt[j]
    for target, block in ((k, bending), (m, mass)):
        put(target, [2, 3, 8, 9], [1, 1, 1, 1], block)
        put(target, [0, 5, 6, 11], [1, -1, 1, -1], block)
    ea, gj = s.e * s.a / l, s.g * 2 * s.i / l
    put(k, [1, 7], [1, 1], [[ea, -ea], [-ea, ea]])
    put(k, [4, 10], [1, 1], [[gj, -gj], [-gj, gj]])
    ma, mj = s.rho * s.a * l / 6, s.rho * 2 * s.i * l / 6
    put(m, [1, 7], [1, 1], [[2 * ma, ma], [ma, 2 * ma]])
    put(m, [4, 10], [1, 1], [[2 * mj, mj], [mj, 2 * mj]])
    return k, m


def gauss(n):
    nodes, weights = np.polynomial.legendre.leggauss(n)
    out = []
    for x in nodes:
        x = mp.findroot(lambda t: mp.legendre(n, t), mp.mpf(float(x)))
        slope = n * (x * mp.legendre(n, x) - mp.legendre(n - 1, x)) / (x**2 - 1)
        out.append((x, 2 / ((1 - x**2) * slope**2)))
    return out


GAUSS = gauss(5)
FINE = gauss(24)


def bearing_matrix(bearing):
    """After Kc; zero for a rigid one."""
    k = mp.zeros(6)
    model = bearing["model"]
    if model == "diagonal":
        for i, v in zip(HELD, bearing["k"]):
            k[i, i] = mp.mpf(v)
    elif model == "matrix":
        k = mp.matrix(bearing["k"])
    series = bearing.get("axial_series_stiffness")
    if series is not None:
        v = k[:, 1]
        k = k - v * v.T / (k[1, 1] + series)
    return k


def assemble(shaft):
    """K (bearings, Kc, Khb), M, and the held coordinates."""
    n = 6 * len(shaft.y)
    k, m = mp.zeros(n), mp.zeros(n)
    for i, (s, l) in enumerate(zip(shaft.sections, shaft.lengths)):
        ke, me = element(s, l)
        for p in range(12):
            for q in range(12):
                k[6 * i + p, 6 * i + q] += ke[p, q]
                m[6 * i + p, 6 * i + q] += me[p, q]
    for body in shaft.rotor["bodies"]:
        at = 6 * shaft.at(body["position"])
        for i in (0, 1, 2):
            m[at + i, at + i] += body["mass"]
        for i in (3, 5):
            m[at + i, at + i] += body["diametral_inertia"]
        m[at + 4, at + 4] += body["polar_inertia"]
    held, rigid_axial = set(), []
    u, total = mp.zeros(n, 1), mp.mpf(0)
    for bearing in shaft.rotor["bearings"]:
        at = 6 * shaft.at(bearing["position"])
        b = bearing_matrix(bearing)
        for i in range(6):
            for j in range(6):
                k[at + i, at + j] += b[i, j]
            u[at + i] += b[i, 1]
        total += b[1, 1]
        if bearing["model"] == "rigid":
            for name in bearing["hold"]:
                held.add(at + ORDER[name])
                if name == "y":
                    rigid_axial.append(at + 1)
    bolt = shaft.rotor.get("housing_axial_stiffness")
    if bolt is not None:
        if rigid_axial:
            assert total == 0 and len(rigid_axial) == 1
            held.discard(rigid_axial[0])
            k[rigid_axial[0], rigid_axial[0]] += bolt
        elif total > 0:
            k = k - u * u.T / (total + bolt)
    return k, m, held


def statics(shaft, k, m, held):
    kept = [i for i in range(k.rows) if i not in held and i % 6 != 4]
    sub = mp.matrix([[k[i, j] for j in kept] for i in kept])
    mass = mp.matrix([[m[i, j] for j in kept] for i in kept])
    places = [kept.index(6 * shaft.mesh + i) for i in HELD]
    loads = mp.zeros(len(kept), 5)
    for column, place in enumerate(places):
        loads[place, column] = 1
    shapes = mp.zeros(len(kept), 5)
    inverse = sub**-1
    shapes = inverse * loads
    compliance = mp.matrix([[shapes[p, j] for j in range(5)] for p in places])
    k5 = compliance**-1
    unit = shapes * k5
    guyan5 = unit.T * mass * unit
    out, guyan = mp.zeros(6), [mp.mpf(0)] * 6
    for i, p in enumerate(HELD):
        guyan[p] = guyan5[i, i]
        for j, q in enumerate(HELD):
            out[p, q] = (k5[i, j] + k5[j, i]) / 2
    return out, guyan


def transfer(s, length, w2):
    shear = 1 / (s.kappa * s.g * s.a) if s.timoshenko else mp.mpf(0)
    rotary = s.rho * s.i if s.timoshenko else mp.mpf(0)
    a = mp.matrix([[0, 1, 0, -shear], [0, 0, 1 / (s.e * s.i), 0], [0, -rotary * w2, 0, 1], [s.rho * s.a * w2, 0, 0, 0]])
    a = a * (length / 16)
    # in units that keep the four entries alike
    scale = [mp.mpf(1), 1 / length, s.e * s.i / length**2, s.e * s.i / length**3]
    for i in range(4):
        for j in range(4):
            a[i, j] *= scale[j] / scale[i]
    out, term = mp.eye(4), mp.eye(4)
    for n in range(1, 60):
        term = term * a / n
        out = out + term
        if mp.norm(term, mp.inf) < mp.mpf(10) ** -45:
            break
    for _ in range(4):
        out = out * out
    for i in range(4):
        for j in range(4):
            out[i, j] *= scale[i] / scale[j]
    return out


class Plane:
    def __init__(self, shaft, plane):
        self.shaft = shaft
        n = len(shaft.y)
        self.mass, self.inertia = [mp.mpf(0)] * n, [mp.mpf(0)] * n
        self.springs = [[mp.mpf(0)] * 3 for _ in range(n)]
        self.held = [False] * n
        for body in shaft.rotor["bodies"]:
            at = shaft.at(body["position"])
            self.mass[at] += body["mass"]
            self.inertia[at] += body["diametral_inertia"]
        t, r, sign = (0, 5, -1) if plane == "x" else (2, 3, 1)
        for bearing in shaft.rotor["bearings"]:
            at = shaft.at(bearing["position"])
            b = bearing_matrix(bearing)
            for i, v in enumerate((b[t, t], sign * b[t, r], b[r, r])):
                self.springs[at][i] += v
            if bearing["model"] == "rigid" and plane in bearing["hold"]:
                self.held[at] = True
        self.unknowns = 2 + sum(self.held)

    def march(self, w2, visit=None):
        """Columns: states caused by z0, phi0 and each reaction; rows of conditions."""
        state = mp.zeros(4, self.unknowns)
        state[0, 0] = state[1, 1] = 1
        conditions, used = [], 2
        for i in range(len(self.shaft.y)):
            if self.held[i]:
                conditions.append([state[0, j] for j in range(self.unknowns)])
                state[3, used] += 1
                used += 1
            ktt, ktr, krr = self.springs[i]
            for j in range(self.unknowns):
                z, phi = state[0, j], state[1, j]
                state[3, j] += w2 * self.mass[i] * z - ktt * z - ktr * phi
                state[2, j] += -w2 * self.inertia[i] * phi + krr * phi + ktr * z
            if visit:
                visit(i, state.copy())
            if i < len(self.shaft.sections):
                state = transfer(self.shaft.sections[i], self.shaft.lengths[i], w2) * state
        conditions.append([state[2, j] for j in range(self.unknowns)])
        conditions.append([state[3, j] for j in range(self.unknowns)])
        return mp.matrix(conditions)

    def determinant(self, w):
        conditions = self.march(mp.mpf(w) ** 2)
        for i in range(conditions.rows):
            size = max(abs(conditions[i, j]) for j in range(conditions.cols))
            for j in range(conditions.cols):
                conditions[i, j] /= size
        return mp.det(conditions)

    def first(self, bound):
        """Lowest root below `bound` rad/s (the plane's finite element frequency, which lies above it)."""
        steps = 150
        last_w, last = None, None
        for n in range(1, steps + 2):
            w = mp.mpf(bound) * n / steps
            value = self.determinant(w)
            if last is not None and mp.sign(value) != mp.sign(last):
                break
            last_w, last = w, value
        else:
            raise ValueError("no root")
        low, high = last_w, w
        w = mp.findroot(self.determinant, (low, high), solver="anderson", tol=mp.mpf(10) ** -60, verify=False)
        assert low <= w <= high
        return w

    def mode(self, w):
        conditions = self.march(w**2)
        # null vector: drop one condition, fix one unknown; take the best conditioned choice
        n = conditions.rows
        for i in range(n):
            size = max(abs(conditions[i, j]) for j in range(n))
            for j in range(n):
                conditions[i, j] /= size
        scale = [max(abs(conditions[i, j]) for i in range(n)) for j in range(n)]
        scaled = mp.matrix([[conditions[i, j] / scale[j] for j in range(n)] for i in range(n)])
        u, s, v = mp.svd_r(scaled)
        order = min(range(n), key=lambda i: s[i])
        vector = [v[order, j] / scale[j] for j in range(n)]
        states = {}
        self.march(w**2, lambda i, state: states.__setitem__(i, state))
        unknown = mp.matrix(vector)
        shaft = self.shaft
        total = mp.mpf(0)
        states = {i: state * unknown for i, state in states.items()}
        for i in range(len(shaft.y)):
            z, phi = states[i][0], states[i][1]
            total += self.mass[i] * z**2 + self.inertia[i] * phi**2
            if i == len(shaft.sections):
                break
            s, l = shaft.sections[i], shaft.lengths[i]
            for part in range(2):
                for node, weight in FINE:
                    at = (part + (node + 1) / 2) * l / 2
                    there = transfer(s, at, w**2) * states[i]
                    total += weight * l / 4 * s.rho * s.a * there[0] ** 2
                    if s.timoshenko:
                        total += weight * l / 4 * s.rho * s.i * there[1] ** 2
        z, phi = states[shaft.mesh][0], states[shaft.mesh][1]
        return z, phi, total


def plane_bound(shaft, plane):
    """First frequency of the finite element model of the plane alone, rad/s: a bound from above."""
    rotor = dict(shaft.rotor, housing_axial_stiffness=None)
    k, m, held = assemble(shaft_like(shaft, rotor))
    motions = (0, 5) if plane == "x" else (2, 3)
    kept = [i for i in range(k.rows) if i % 6 in motions and i not in held]
    k = np.array([[float(k[i, j]) for j in kept] for i in kept])
    m = np.array([[float(m[i, j]) for j in kept] for i in kept])
    values = 1 / np.linalg.eigvals(np.linalg.solve(k, m)).real
    return math.sqrt(min(v for v in values if v > 0)) * 1.0001


def shaft_like(shaft, rotor):
    out = object.__new__(Shaft)
    out.__dict__.update(shaft.__dict__)
    out.rotor = rotor
    return out


def bending(shaft, plane, k_ll, guyan):
    p = Plane(shaft, plane)
    w = p.first(plane_bound(shaft, plane))
    z, phi, total = p.mode(w)
    t, r, sign = (0, 5, -1) if plane == "x" else (2, 3, 1)
    k11, k12, k22 = k_ll[t, t], sign * k_ll[t, r], k_ll[r, r]
    tilt = mp.inf if z == 0 else abs(phi) * mp.sqrt(k22) / (abs(z) * mp.sqrt(k11))
    mass = inertia = None
    if tilt < 1e-6:
        mass = k11 / w**2
    elif tilt > 1e6:
        inertia = k22 / w**2
    else:
        mass, inertia = (k11 + k12 * phi / z) / w**2, (k22 + k12 * z / phi) / w**2
    mass = mass if mass is not None and mass > 0 else None
    inertia = inertia if inertia is not None and inertia > 0 else None
    strain = z**2 * k11 + 2 * z * phi * k12 + phi**2 * k22
    return {
        "frequency_hz": float(w / (2 * mp.pi)),
        "mass": float(guyan[t] if mass is None else mass),
        "inertia": float(guyan[r] if inertia is None else inertia),
        "energy_residual": float(1 - strain / (w**2 * total)),
        "mass_fallback": mass is None,
        "inertia_fallback": inertia is None,
        "tilt": float(min(tilt, mp.mpf(10) ** 30)),
    }


def mesh_vector(vectors):
    x, y, z = vectors["point"]
    n = np.array(vectors["line_of_action"], dtype=float)
    n = n / np.linalg.norm(n)
    return np.array([*n, y * n[2] - z * n[1], z * n[0] - x * n[2], x * n[1] - y * n[0]])


def rotor_models(design, side):
    """(figures, {kind: (K, M, h)})"""
    rotor = design[side]
    shaft = Shaft(design, rotor)
    k, m, held = assemble(shaft)
    k_ll, guyan = statics(shaft, k, m, held)
    modes = {plane: bending(shaft, plane, k_ll, guyan) for plane in "xz"}
    parts = [(s.rho * s.a * l, s.rho * s.i * l + s.rho * s.a * l**3 / 12, s.rho * 2 * s.i * l, y + l / 2)
             for s, l, y in zip(shaft.sections, shaft.lengths, map(mp.mpf, shaft.y))]
    parts += [(mp.mpf(b["mass"]), mp.mpf(b["diametral_inertia"]), mp.mpf(b["polar_inertia"]),
               mp.mpf(shaft.y[shaft.at(b["position"])])) for b in rotor["bodies"]]
    total = sum(p[0] for p in parts)
    centroid = sum(p[0] * p[3] for p in parts) / total
    polar = sum(p[2] for p in parts)
    diametral = sum(p[1] + p[0] * (p[3] - centroid) ** 2 for p in parts)
    figures = {"shaft_bearing_stiffness": [[float(k_ll[i, j]) for j in range(6)] for i in range(6)],
               "mass": float(total), "polar_inertia": float(polar), "diametral_inertia": float(diametral),
               "centroid": float(centroid), "bending": modes}
    sign = 1 if side == "pinion" else -1
    vector = sign * mesh_vector(design["mesh"][side])
    kt, inertia = rotor["drive"]["torsional_stiffness"], rotor["drive"]["inertia"]
    kept = [i for i in range(k.rows) if i not in held]
    n = len(kept)
    fk, fm, fh = np.zeros((n + 1, n + 1)), np.zeros((n + 1, n + 1)), np.zeros(n + 1)
    fk[:n, :n] = [[float(k[i, j]) for j in kept] for i in kept]
    fm[:n, :n] = [[float(m[i, j]) for j in kept] for i in kept]
    for i in range(6):
        if 6 * shaft.mesh + i in kept:
            fh[kept.index(6 * shaft.mesh + i)] = vector[i]
    join(fk, kept.index(6 * shaft.drive + 4), n, kt)
    fm[n, n] = inertia
    low, high = sorted((shaft.mesh, shaft.drive))
    series = 1 / (1 / mp.mpf(kt) + sum(l / (s.g * 2 * s.i) for s, l in list(zip(shaft.sections, shaft.lengths))[low:high]))
    models = {"fe": (fk, fm, fh)}
    x, z = modes["x"], modes["z"]
    diagonals = {"enhanced": [x["mass"], total, z["mass"], z["inertia"], polar, x["inertia"]],
                 "basic": [total, total, total, diametral, polar, diametral]}
    for kind, diagonal in diagonals.items():
        lk = np.zeros((7, 7))
        lk[:6, :6] = figures["shaft_bearing_stiffness"]
        join(lk, 4, 6, float(series))
        models[kind] = (lk, np.diag([float(d) for d in diagonal] + [inertia]), np.append(vector, 0.0))
    return figures, models


def join(k, i, j, spring):
    k[i, i] += spring
    k[j, j] += spring
    k[i, j] -= spring
    k[j, i] -= spring


def spectrum(design, pinion, gear, lines):
    n, m = len(pinion[2]), len(gear[2])
    k, mass = np.zeros((n + m, n + m)), np.zeros((n + m, n + m))
    for target, i in ((k, 0), (mass, 1)):
        target[:n, :n], target[n:, n:] = pinion[i], gear[i]
    h = np.append(pinion[2], gear[2])
    scale = 1 / np.sqrt(np.diag(k) + 1e7 * np.diag(mass))
    k, mass, h = k * np.outer(scale, scale), mass * np.outer(scale, scale), h * scale
    e, km = design["mesh"]["transmission_error"], design["mesh"]["stiffness"]
    force, delta = [], []
    for f in lines:
        w = 2 * math.pi * f
        s = 1.0 if design["damping_model"] == "hysteretic" else w
        mesh = km * (1 + 1j * s * design["mesh"]["damping"])
        system = k * (1 + 1j * s * design["structural_damping"]) - w * w * mass + mesh * np.outer(h, h)
        d = h @ np.linalg.solve(system, h * mesh * e)
        delta.append(d)
        force.append(mesh * (d - e))
    return {"force_re": [v.real for v in force], "force_im": [v.imag for v in force],
            "delta_re": [v.real for v in delta], "delta_im": [v.imag for v in delta]}


def solve(design):
    lines = design["lines_hz"]
    pinion, pinion_models = rotor_models(design, "pinion")
    gear, gear_models = rotor_models(design, "gear")
    spectra = {kind: spectrum(design, pinion_models[kind], gear_models[kind], lines) for kind in pinion_models}
    return {"pinion": pinion, "gear": gear, "spectra": spectra}


# ---- designs

STEEL = {"youngs_modulus": 206e9, "poissons_ratio": 0.3, "density": 7850.0}
TITANIUM = {"youngs_modulus": 112e9, "poissons_ratio": 0.34, "density": 4430.0}


def segment(length, outer, inner=0.0, material="steel", elements=1):
    return {"length": length, "outer_diameter": outer, "inner_diameter": inner, "material": material, "elements": elements}


def body(position, mass, diametral, polar):
    return {"position": position, "mass": mass, "diametral_inertia": diametral, "polar_inertia": polar}


def diagonal(position, *k, kc=None):
    return {"position": position, "model": "diagonal", "k": list(k), "axial_series_stiffness": kc}


def rigid(position, hold):
    return {"position": position, "model": "rigid", "hold": list(hold), "axial_series_stiffness": None}


def coupled(position, seed, size=5e8, radius=0.02, kc=None):
    rng = random.Random(seed)
    b = [[(1.0 if i == j else 0.0) + rng.uniform(-0.5, 0.5) for j in range(5)] for i in range(5)]
    scale = [math.sqrt(size)] * 3 + [radius * math.sqrt(size)] * 2
    k = [[0.0] * 6 for _ in range(6)]
    for i, p in enumerate(HELD):
        for j, q in enumerate(HELD):
            k[p][q] = k[q][p] = scale[i] * scale[j] * sum(b[i][m] * b[j][m] for m in range(5))
    return {"position": position, "model": "matrix", "k": k, "axial_series_stiffness": kc}


def rotor(segments, bodies, bearings, mesh, drive=None, khb=None, kt=1.2e4, inertia=0.02):
    length = 0.0
    for s in segments:
        length += s["length"]
    return {"mesh_position": mesh, "housing_axial_stiffness": khb, "segments": segments, "bodies": bodies, "bearings": bearings,
            "drive": {"position": length if drive is None else drive, "torsional_stiffness": kt, "inertia": inertia}}


def plain_gear():
    return rotor([segment(0.06, 0.06, 0.025), segment(0.05, 0.055), segment(0.11, 0.05, elements=2), segment(0.04, 0.042)],
                 [body(0.025, 3.67, 6e-3, 1.1e-2), body(0.06, 5.0, 9e-3, 1.1e-2)],
                 [diagonal(0.11, 7e8, 2.2e8, 7e8, 2e5, 2e5), diagonal(0.22, 6e8, 2.2e8, 8e8, 1.6e5, 1.6e5)],
                 0.025, kt=1e4, inertia=0.3)


def pair(name, pinion, gear=None, theory="timoshenko", damping="hysteretic"):
    viscous = damping == "viscous"
    return {"name": name, "beam_theory": theory, "damping_model": damping,
            "structural_damping": 2.5e-6 if viscous else 0.03,
            "lines_hz": [5.0, 37.0, 150.0, 333.0, 512.0, 700.0, 998.0, 1300.0, 1700.0, 2200.0, 2900.0, 3700.0, 5000.0],
            "materials": {"steel": STEEL, "titanium": TITANIUM},
            "mesh": {"stiffness": 6.4e8, "damping": 4e-6 if viscous else 0.06, "transmission_error": 5e-6,
                     "pinion": {"point": [0.002, -0.0035, 0.027], "line_of_action": [0.76975, -0.62285, 0.1398]},
                     "gear": {"point": [0.0, 0.0, 0.0764936], "line_of_action": [-0.76975, 0.1398, -0.62285]}},
            "pinion": pinion, "gear": gear or plain_gear()}


def overhung(bearings, **more):
    segments = [segment(0.036, 0.044), segment(0.019, 0.040), segment(0.075, 0.036, 0.012, elements=2),
                segment(0.04, 0.028, 0.008, "titanium", 2)]
    return rotor(segments, [body(0.018, 0.6, 3e-4, 2.6e-4)], bearings, more.pop("mesh", 0.018), **more)


def straddle(bearings, head, khb=None):
    return rotor([segment(0.1, 0.036, elements=2), segment(0.1, 0.036, elements=2)], [head], bearings, 0.1, drive=0.2, khb=khb)


def randoms():
    out = []
    rng = random.Random(20120612)
    for number in range(8):
        rotors = []
        for side in range(2):
            segments = [segment(round(rng.uniform(0.03, 0.1), 4), round(rng.uniform(0.028, 0.06), 4), material=rng.choice(["steel", "titanium"]),
                                elements=rng.choice([1, 2])) for _ in range(rng.randint(2, 4))]
            for s in segments:
                s["inner_diameter"] = rng.choice([0.0, round(0.4 * s["outer_diameter"], 5)])
            ends = [0.0]
            for s in segments:
                ends.append(ends[-1] + s["length"])
            places = ends + [(p + q) / 2 for p, q in zip(ends, ends[1:])]
            low, high = sorted(rng.sample(places, 2))
            while high - low < 0.3 * ends[-1]:
                low, high = sorted(rng.sample(places, 2))
            kc = rng.choice([None, 9e8])
            first = rng.choice([lambda p: coupled(p, rng.random(), kc=kc), lambda p: diagonal(p, 6e8, 2.5e8, 5e8, 1.5e5, 9e4, kc=kc)])(low)
            second = rng.choice([lambda p: coupled(p, rng.random(), 3e8, 0.015), lambda p: diagonal(p, 5e8, 1.8e8, 4e8, 0.0, 6e4),
                                 lambda p: diagonal(p, 2e8, 0.0, 9e8, 8e4, 0.0)])(high)
            bodies = [body(rng.choice(places), round(rng.uniform(0.3, 4), 3), 1.5e-3, 2e-3) for _ in range(rng.randint(0, 2))]
            rotors.append(rotor(segments, bodies, [first, second], rng.choice(places), rng.choice(places), rng.choice([None, 6e8])))
        out.append(pair(f"random {number + 1}", rotors[0], rotors[1], rng.choice(["timoshenko", "euler-bernoulli"]),
                        rng.choice(["hysteretic", "viscous"])))
    return out


def designs():
    head = body(0.1, 1.2, 6e-4, 9e-4)
    heavy = body(0.1, 0.4, 0.02, 0.03)
    d = diagonal
    two = [d(0.055, 6e8, 2.5e8, 6e8, 1.5e5, 1.5e5), d(0.13, 5e8, 1.8e8, 5e8, 8e4, 8e4)]
    left, right = d(0.0, 4e8, 2e8, 3e8, 5e4, 4e4), d(0.2, 4e8, 2e8, 3e8, 5e4, 4e4)
    yield pair("symmetric straddle, the mode does not tilt", straddle([left, right], head))
    yield pair("symmetric straddle, Euler-Bernoulli, viscous", straddle([left, right], head), None, "euler-bernoulli", "viscous")
    yield pair("symmetric straddle on rigid bearings", straddle([rigid(0.0, "xyz"), rigid(0.2, "xz")], head))
    soft = [d(0.0, 1e7, 2e8, 2e7, 0.0, 0.0), d(0.2, 1e7, 2e8, 2e7, 0.0, 0.0)]
    yield pair("symmetric straddle that pitches first, the mesh does not move", straddle(soft, heavy))
    yield pair("nearly symmetric straddle", straddle([left, d(0.2, 4.001e8, 2e8, 3.001e8, 5e4, 4e4)], head))
    yield pair("coupled bearings", overhung([coupled(0.055, 1), coupled(0.13, 2)]))
    yield pair("coupled bearings, Kc and Khb", overhung([coupled(0.055, 3, kc=9e8), coupled(0.13, 4, kc=4e8)], khb=6e8), damping="viscous")
    yield pair("Khb instead of the rigid axial support", overhung([rigid(0.055, "xyz"), rigid(0.13, "xz")], khb=6e8))
    yield pair("Khb beside axially free elastic ones", overhung([rigid(0.055, "xyz"), d(0.13, 5e8, 0.0, 4e8, 8e4, 8e4)], khb=6e8))
    yield pair("rigid bearings, no bolt", overhung([rigid(0.055, "xyz"), rigid(0.13, "xz")]), theory="euler-bernoulli")
    yield pair("rigid and elastic at one station", overhung([rigid(0.055, "x"), coupled(0.055, 5), two[1]], khb=5e8))
    yield pair("two bearings at one station", overhung([d(0.13, 3e8, 1e8, 2e8, 1e4, 2e4), coupled(0.13, 6), two[0]], khb=5e8))
    yield pair("held in one plane, elastic in the other", overhung([rigid(0.055, "z"), two[0], rigid(0.13, "xy")]))
    yield pair("bearing, mesh and drive at the shaft's ends",
               overhung([d(0.0, 6e8, 2.5e8, 6e8, 1.5e5, 1.5e5), d(0.17, 5e8, 1.8e8, 5e8, 8e4, 8e4)], mesh=0.17, drive=0.0))
    yield pair("mesh at the shaft's start, overhung far", overhung(two, mesh=0.0, drive=0.17))
    yield pair("drive at the mesh station", overhung(two, drive=0.018))
    on = overhung(two)
    on["bodies"].append(body(0.055, 2.0, 2e-3, 3e-3))
    yield pair("body on a bearing", on)
    yield pair("translations only", overhung([d(0.055, 6e8, 2.5e8, 6e8, 0.0, 0.0), d(0.13, 5e8, 0.0, 5e8, 0.0, 0.0)]))
    yield pair("very stiff beside very soft", overhung([d(0.055, 6e12, 2.5e8, 6e4, 1.5e5, 1.5e5), d(0.13, 5e8, 1e3, 5e11, 8e4, 1e8)]))
    yield from randoms()


def main():
    out = []
    for design in designs():
        print(design["name"], file=sys.stderr)
        out.append({"design": design, "expected": solve(design)})
    print("[\n" + ",\n".join(json.dumps(case) for case in out) + "\n]")


if __name__ == "__main__":
    main()
