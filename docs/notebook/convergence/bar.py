#!/usr/bin/env python3
"""The bar into which an impact draws both bodies, snapshot by snapshot, as CSV.

Usage: bar.py FOLDER... > bar.csv        (folders of `eerie solve`, with snapshots)

line_per_km: mass within 6 m of the middle over all mass and length, 1/km. bulk and integrated:
density of the inner matter (within 40 m of the middle along the bar, and one standard deviation
across it), kg/m^3; bulk counts particles with one kernel, h = 7.7 m, for all particle numbers.
pressing: part of the inner particles that have pressure.
"""

import glob
import os
import sys

import h5py
import numpy as np
from scipy.spatial import cKDTree

H = 7.7  # m


def kernel(q):
    w = np.where(q < 1, 1 - 1.5 * q**2 + 0.75 * q**3, 0.25 * np.clip(2 - q, 0, None) ** 3)
    return w / np.pi / H**3


def row(path):
    with h5py.File(path) as file:
        gas = file["PartType0"]
        time = float(np.ravel(file["Header"].attrs["Time"])[0])
        x, mass = gas["Coordinates"][:], float(gas["Masses"][0])
        rho, pressure = gas["Densities"][:], gas["Pressures"][:]
    x = x - x.mean(axis=0)
    _, axes = np.linalg.eigh(np.cov(x.T))
    b, a, along = (x @ axes).T
    near = np.flatnonzero(np.abs(along) < 40)
    inner = near[a[near] ** 2 / a[near].var() + b[near] ** 2 / b[near].var() < 1]
    tree = cKDTree(x)
    bulk = [mass * kernel(np.linalg.norm(x[tree.query_ball_point(x[i], 2 * H)] - x[i], axis=1) / H).sum()
            for i in inner]
    return (time, np.mean(np.abs(along) < 6) / 0.012, np.mean(bulk), rho[inner].mean(), np.mean(pressure[inner] > 0))


print("run,time_s,line_per_km,bulk_kg_per_m3,integrated_kg_per_m3,pressing")
for folder in sys.argv[1:]:
    for path in sorted(glob.glob(folder + "/snapshot_*.hdf5"))[1:]:
        time, line, bulk, integrated, pressing = row(path)
        if time <= 12600:
            print(f"{os.path.basename(folder)},{time:.0f},{line:.3f},{bulk:.0f},{integrated:.0f},{pressing:.3f}", flush=True)
