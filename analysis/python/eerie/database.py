"""A campaign's database, read through its documented views."""

from __future__ import annotations

import os
import sqlite3
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pandas as pd

from . import columns, program
from .errors import Error, UnknownNameError
from .job import Job

_APPLICATION_ID = 0x65657269  # "eeri"
_OLDEST_SCHEMA = 5  # later ones only add columns to the views

_POINT = ("q", "phi_d_deg", "v_imp_cm_per_s", "theta_imp_deg")
_JOB_COLUMNS = ("id AS job", "hash", "state", *_POINT, "v_over_v_esc", "particles_per_target",
                "seed", "fidelity", "settings")  # fmt: skip


class Database:
    """Reads a campaign. Each question opens the file for itself and reads what is there now."""

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = Path(path)
        if not self.path.is_file():
            raise Error(
                f"database {self.path}: there is no such file; "
                f"`eerie run SWEEP --db {self.path}` makes it"
            )
        with _Reading(self.path) as connection:
            _require_ours(connection, self.path)

    def __repr__(self) -> str:
        return f"eerie.open({str(self.path)!r})"

    def results(self) -> pd.DataFrame:
        """One row per finished job: its point, its outcome, its run."""
        return self._view("results")

    def remnants(self) -> pd.DataFrame:
        """One row per remnant of at least 100 particles."""
        return self._view("remnants")

    def maps(self) -> pd.DataFrame:
        """One row per point and settings: means over all jobs there."""
        return self._view("maps")

    def jobs(self) -> pd.DataFrame:
        """One row per job, finished or not, with its state and point."""
        frame = self.query(f"SELECT {', '.join(_JOB_COLUMNS)} FROM jobs ORDER BY id")
        return frame.set_index("job", drop=False).rename_axis(None)

    def query(self, sql: str, parameters: Sequence[Any] = ()) -> pd.DataFrame:
        """What the SQL selects, with units by the names of the columns."""
        with _Reading(self.path) as connection:
            try:
                frame = pd.read_sql_query(sql, connection, params=tuple(parameters))
            except (pd.errors.DatabaseError, sqlite3.Error) as error:
                raise Error(f"database {self.path}: {error}") from error
        for name in frame.columns[frame.isna().all()]:  # nothing says that they are numbers
            frame[name] = frame[name].astype(float)
        frame.attrs["units"] = columns.units_of(frame.columns)
        return frame

    def map(
        self,
        quantity: str = "b_over_a",
        *,
        q: float | None = None,
        phi_d: float | None = None,
        fidelity: str | None = None,
        settings: int | None = None,
    ) -> pd.DataFrame:
        """A quantity of the view `maps`: theta_imp_deg down, v_imp_cm_per_s across.

        q, phi_d (deg), fidelity and settings (the database's number) may be left out where the
        database has one of each. Points without a result are NaN. Units of the quantity and of
        both axes are in .attrs["units"]. Raises UnknownNameError, and Error where the choice
        leaves no point or several settings.
        """
        points = self.maps()
        if quantity not in points.columns:
            raise UnknownNameError("quantity", quantity, points.columns)
        choice = {"q": q, "phi_d_deg": phi_d, "fidelity": fidelity, "settings": settings}
        chosen = _chosen(points, choice, self.path)
        for name, hint in (("q", "q="), ("phi_d_deg", "phi_d="), ("settings", "settings=")):
            _require_one(chosen, name, hint, self.path)
        table = chosen.pivot(index="theta_imp_deg", columns="v_imp_cm_per_s", values=quantity)
        table.attrs = {
            "quantity": quantity,
            "units": columns.units_of((quantity, "theta_imp_deg", "v_imp_cm_per_s")),
        }
        return table

    def job(self, name: int | str) -> Job:
        """A job by its number in this database, or by the first digits of its hash."""
        jobs = self.query("SELECT id, hash FROM jobs")
        found = jobs[jobs["id"] == name] if isinstance(name, int) else jobs[
            jobs["hash"].str.startswith(name)]  # fmt: skip
        if len(found) != 1:
            count = "no job" if found.empty else f"{len(found)} jobs"
            raise Error(
                f"database {self.path}: {count} of {name!r}; `.jobs()` lists numbers and hashes"
            )
        return Job(self, int(found["id"].iloc[0]), str(found["hash"].iloc[0]))

    def jobs_folder(self) -> Path:
        """Where the job directories are."""
        stored = self.query("SELECT value FROM settings WHERE key = 'jobs_folder'")["value"]
        if len(stored) > 0:
            return Path(stored.iloc[0])
        file = self.path.resolve()
        return file.with_name(file.name + ".jobs")

    def ask(self, command: str, *arguments: str) -> Any:
        """What a command of the program says of this database, as its --json.

        `campaign.ask("threshold", "--q", "1")` has the fitted ridge. Raises ProgramError.
        """
        return program.ask(command, "--db", str(self.path), *arguments)

    def _view(self, name: str) -> pd.DataFrame:
        frame = self.query(f"SELECT * FROM {name}")
        for column in columns.FLAGS[name]:
            frame[column] = frame[column].astype("boolean" if frame[column].hasnans else bool)
        return frame


class _Reading:
    """A connection that can only read, for a `with`."""

    def __init__(self, path: Path) -> None:
        self._path = path

    def __enter__(self) -> sqlite3.Connection:
        file = self._path.resolve()
        name = f"file:{quote(str(file))}"
        try:
            return self._opened(f"{name}?mode=ro")
        except sqlite3.OperationalError as error:
            log = file.with_name(file.name + "-wal")
            if log.exists() and log.stat().st_size > 0:
                raise Error(
                    f"database {self._path}: {error}; it lies where this user cannot write and a "
                    "manager has not closed it: copy the file and its -wal elsewhere"
                ) from error
            # A place where SQLite cannot make its log's index: read the file as it is.
            return self._opened(f"{name}?immutable=1")

    def _opened(self, uri: str) -> sqlite3.Connection:
        self._connection = sqlite3.connect(uri, uri=True, timeout=10)
        try:
            self._connection.execute("SELECT count(*) FROM sqlite_master")
        except sqlite3.Error as error:
            self._connection.close()
            if isinstance(error, sqlite3.OperationalError):
                raise
            raise Error(f"database {self._path}: {error}; give another file") from error
        return self._connection

    def __exit__(self, *_: object) -> None:
        self._connection.close()


def _require_ours(connection: sqlite3.Connection, path: Path) -> None:
    try:
        (application,) = connection.execute("PRAGMA application_id").fetchone()
        (version,) = connection.execute("PRAGMA user_version").fetchone()
    except sqlite3.Error as error:
        raise Error(f"database {path}: {error}; give another file") from error
    if application != _APPLICATION_ID:
        raise Error(f"database {path}: it is not one of eerie's; give another file")
    if version < _OLDEST_SCHEMA:
        raise Error(
            f"database {path}: its schema has version {version} and this package reads versions "
            f"from {_OLDEST_SCHEMA} on; `eerie doctor --fix --db {path}` brings it up to date"
        )


def _chosen(points: pd.DataFrame, choice: dict[str, Any], path: Path) -> pd.DataFrame:
    for name, wanted in choice.items():
        if wanted is None:
            continue
        left = points[points[name] == wanted]
        if left.empty:
            there = sorted({str(value) for value in points[name].dropna()}) or ["none"]
            raise Error(
                f"database {path}: no point has {name} = {wanted}; there are {', '.join(there)}"
            )
        points = left
    if points.empty:
        raise Error(f"database {path}: it has no jobs; `eerie run SWEEP --db {path}` adds some")
    return points


def _require_one(points: pd.DataFrame, name: str, hint: str, path: Path) -> None:
    values = points[name].unique()
    if len(values) > 1:
        there = ", ".join(str(value) for value in sorted(values))
        raise Error(f"database {path}: points have several {name}: {there}; choose by {hint}")
