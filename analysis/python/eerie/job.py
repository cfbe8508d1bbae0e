"""One job: its scene, its rows of the views, and the files of its directory."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pandas as pd

from . import columns
from .errors import Error
from .snapshot import Snapshot

if TYPE_CHECKING:
    from .database import Database


class Job:
    """A job of a database."""

    def __init__(self, database: Database, number: int, hash_: str) -> None:
        self.database = database
        self.number = number
        self.hash = hash_

    def __repr__(self) -> str:
        return f"{self.database!r}.job({self.hash[:8]!r})"

    @property
    def folder(self) -> Path:
        """Its job directory, whose files docs/job-directory.md describes."""
        return self.database.jobs_folder() / self.hash[:16]

    @property
    def scene(self) -> dict[str, Any]:
        """The whole scene, defaults filled in."""
        stored = self.database.query(
            "SELECT scene FROM job_scenes WHERE job_id = ?", (self.number,)
        )
        return dict(json.loads(stored["scene"].iloc[0]))

    def result(self) -> pd.Series:
        """Its row of `results`. Raises Error while it has none."""
        found = self._rows(self.database.results())
        if found.empty:
            raise Error(f"job {self.hash[:8]} has no result; `eerie show {self.hash[:8]}` says why")
        row = found.iloc[0]
        row.attrs = found.attrs
        return row

    def remnants(self) -> pd.DataFrame:
        """Its rows of `remnants`, the most massive first."""
        return self._rows(self.database.remnants()).sort_values("rank", ignore_index=True)

    def history(self) -> pd.DataFrame:
        """Remnants and energies over simulated time (history.csv)."""
        frame = pd.read_csv(self._file("history.csv"))
        frame.attrs["units"] = columns.units_of(frame.columns)
        return frame

    def snapshots(self) -> list[Snapshot]:
        """Its snapshots in order of time, the last state (final.hdf5) included."""
        names = sorted(self._file("").glob("snapshot_*.hdf5"))
        names += [file for file in (self.folder / "final.hdf5",) if file.exists()]
        return sorted((Snapshot(file) for file in names), key=lambda one: one.time_s)

    def final(self) -> Snapshot:
        """The last state. Raises Error while there is none."""
        return Snapshot(self._file("final.hdf5"))

    def _rows(self, view: pd.DataFrame) -> pd.DataFrame:
        return view[view["job"] == self.number]

    def _file(self, name: str) -> Path:
        file = self.folder / name
        if not file.exists():
            raise Error(
                f"job {self.hash[:8]}: there is no {file}; "
                f"`eerie show {self.hash[:8]} --db {self.database.path}` says how far it is"
            )
        return file
