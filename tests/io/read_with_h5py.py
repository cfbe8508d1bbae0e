"""Opens a snapshot with h5py and prints what it sees: N, time, then x y z rho mass h by id (SI)."""
import json
import sys

import h5py
import numpy as np

with h5py.File(sys.argv[1], "r") as file:
    gas = file["PartType0"]
    order = np.argsort(gas["ParticleIDs"][:])
    x = (gas["Coordinates"][:] + file["Header"].attrs["CoordinatesOffset"])[order]
    exact = file["State/Coordinates"][:][order]
    assert np.allclose(x, exact, rtol=0, atol=1e-9 * np.abs(exact).max())
    assert np.all(gas["Coordinates"][:] >= 0)
    assert np.all(gas["Coordinates"][:] <= file["Header"].attrs["BoxSize"])
    for name, target in [("SmoothingLength", "SmoothingLengths"), ("Density", "Densities"),
                         ("InternalEnergy", "InternalEnergies")]:
        assert gas.get(name, getlink=True).path == target
    for name in gas:
        for attribute in ("U_M exponent", "U_L exponent", "U_t exponent", "a-scale exponent"):
            assert gas[name].attrs[attribute].shape == (1,), (name, attribute)
    assert file["VTKHDF/PointData/Densities"] == gas["Densities"]
    assert json.loads(file["Parameters"].attrs["eerie:scene"])["impact"]["v_imp_cm_per_s"] == 20.1
    columns = [*exact.T, gas["Densities"][:][order], gas["Masses"][:][order],
               gas["SmoothingLengths"][:][order]]
    print("h5py", len(order), repr(file["Header"].attrs["Time"][0].item()))
    for i, row in enumerate(zip(*columns)):
        print(i, *(repr(value.item()) for value in row))
