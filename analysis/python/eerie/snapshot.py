"""A snapshot: what each particle is at one time."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import h5py
import numpy as np
import numpy.typing as npt
import pandas as pd

from .errors import Error, UnknownNameError

_SI = (("M", "kg"), ("L", "m"), ("t", "s"))
_NAMED = {"kg/m/s^2": "Pa", "m^2/s^2": "J/kg"}
_AXES = {3: ("x", "y", "z"), 6: ("xx", "yy", "zz", "xy", "xz", "yz")}


class Snapshot:
    """Arrays of a snapshot by their names in the file: `snapshot["Densities"]`.

    Rows are particles in order of ParticleIDs, whatever their order in the file: row i is the
    same particle in every snapshot of a run. All is in SI; `units` and `descriptions` say which
    unit and what. Coordinates are the exact ones of the solver.
    """

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise Error(f"snapshot {self.path}: there is no such file")
        try:
            with h5py.File(self.path, "r") as file:
                self.time_s = float(file["Header"].attrs["Time"][0])
                self.scene: dict[str, Any] = json.loads(file["Parameters"].attrs["eerie:scene"])
                datasets = {**_datasets(file["PartType0"]), **_datasets(file["State"])}
                self.units = {name: _unit(one) for name, one in datasets.items()}
                self.descriptions = {
                    name: _text(one.attrs.get("Description", "")) for name, one in datasets.items()
                }
                self._places = {name: one.name for name, one in datasets.items()}
                self._order = np.argsort(file["PartType0/ParticleIDs"][:])
        except (OSError, KeyError) as error:
            raise Error(f"snapshot {self.path}: it is not one of eerie's: {error}") from error

    def __repr__(self) -> str:
        return f"eerie.Snapshot({str(self.path)!r})"

    def __len__(self) -> int:
        """How many particles there are."""
        return len(self._order)

    def names(self) -> list[str]:
        """Names of the arrays."""
        return sorted(self._places)

    def __getitem__(self, name: str) -> npt.NDArray[Any]:
        """The array of this name: (N), (N, 3) for vectors, (N, 6) for tensors (xx, yy, zz, xy,
        xz, yz). Raises UnknownNameError."""
        if name not in self._places:
            raise UnknownNameError("array", name, self.names())
        try:
            with h5py.File(self.path, "r") as file:
                return np.asarray(file[self._places[name]][:][self._order])
        except OSError as error:
            raise Error(f"snapshot {self.path}: cannot read {name}: {error}") from error

    def frame(self) -> pd.DataFrame:
        """All arrays as one frame, a row per particle: Densities, Coordinates_x, ..."""
        parts: dict[str, npt.NDArray[Any]] = {}
        units: dict[str, str] = {}
        for name in self.names():
            array = self[name]
            labels = [name] if array.ndim == 1 else [
                f"{name}_{axis}" for axis in _AXES[array.shape[1]]]  # fmt: skip
            parts.update(zip(labels, array.reshape(len(self), -1).T))
            units.update(dict.fromkeys(labels, self.units[name]))
        frame = pd.DataFrame(parts).set_index("ParticleIDs")
        frame.attrs["units"] = {name: units[name] for name in frame.columns}
        return frame

    def yt(self) -> Any:
        """The snapshot as a yt dataset. What yt has without a unit is there with one as
        ("eerie", "Pressures") and so on. Particles are in the order of the file, and positions
        begin at a corner of the box; see docs/formats.md."""
        try:
            import yt
        except ImportError as error:
            raise Error(
                "yt is not installed for this Python: `apt install python3-yt` where Debian's "
                "python3 is used, `pip install yt` elsewhere"
            ) from error
        dataset = yt.load(str(self.path))
        for _, name in [field for field in dataset.field_list if field[0] == "PartType0"]:
            if self.units.get(name) and not dataset.field_info["PartType0", name].units:
                _add_yt_field(dataset, name, self.units[name].replace("^", "**"))
        return dataset


def _add_yt_field(dataset: Any, name: str, unit: str) -> None:
    def values(field: Any, data: Any) -> Any:
        return data.ds.arr(data["PartType0", name].value, unit)

    dataset.add_field(("eerie", name), function=values, units=unit, sampling_type="particle")


def _datasets(group: h5py.Group) -> dict[str, h5py.Dataset]:
    """Without the second names that soft links give."""
    hard = (name for name in group if isinstance(group.get(name, getlink=True), h5py.HardLink))
    return {name: group[name] for name in hard}


def _unit(dataset: h5py.Dataset) -> str:
    """kg/m^3, of the powers of mass, length and time that the file holds."""
    above: list[str] = []
    below: list[str] = []
    for letter, unit in _SI:
        power = int(dataset.attrs.get(f"U_{letter} exponent", [0])[0])
        if power != 0:
            word = unit if abs(power) == 1 else f"{unit}^{abs(power)}"
            (above if power > 0 else below).append(word)
    if not above and not below:
        return ""
    unit = " ".join(above or ["1"]) + ("/" if below else "") + "/".join(below)
    return _NAMED.get(unit, unit)


def _text(value: Any) -> str:
    return value.decode() if isinstance(value, bytes) else str(value)
