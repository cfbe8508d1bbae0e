"""Calls the program. What it computes is never computed here."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import tempfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from .errors import Error, ProgramError

if TYPE_CHECKING:
    from .database import Database


def find() -> str:
    """The program: the environment's EERIE, or `eerie` on the PATH. Raises Error."""
    given = os.environ.get("EERIE")
    found = shutil.which(given or "eerie")
    if found is None:
        where = f"EERIE is {given!r}, which is no program" if given else "it is not on the PATH"
        raise Error(f"the program eerie was not found: {where}; set EERIE=/where/it/is/eerie")
    return found


def ask(command: str, *arguments: str) -> Any:
    """What a command of the program says, as its --json. Raises ProgramError."""
    return json.loads(_call([command, *arguments, "--json"]))


def run(
    sweep: str | os.PathLike[str] | Mapping[str, Any],
    *,
    db: str | os.PathLike[str] = "eerie.sqlite",
    fidelity: str | None = None,
    overrides: Mapping[str, Any] | None = None,
    workers: int | None = None,
    threads_per_job: int | None = None,
) -> Database:
    """Runs every job of a sweep that is not done yet, and gives the database.

    `sweep` is a sweep file, or what would stand in one. `overrides` are fields of the scene by
    path: {"numerics.particles_per_target": 5000}. Ctrl-C stops with checkpoints: run again to go
    on. Raises ProgramError, also where some job failed (code 1): the database has the others.
    """
    from .database import Database

    options = ["--db", os.fspath(db)]
    for name, value in (
        ("--fidelity", fidelity),
        ("--workers", workers),
        ("--threads-per-job", threads_per_job),
    ):
        if value is not None:
            options += [name, str(value)]
    for field, value in (overrides or {}).items():
        options += ["--set", f"{field}={value if isinstance(value, str) else json.dumps(value)}"]
    if isinstance(sweep, Mapping):
        with tempfile.TemporaryDirectory(prefix="eerie-") as folder:
            file = Path(folder) / "sweep.json"
            file.write_text(json.dumps(sweep), encoding="utf-8")
            _call(["run", str(file), *options, "--json"])
    else:
        _call(["run", os.fspath(sweep), *options, "--json"])
    return Database(db)


def _call(words: list[str]) -> str:
    with subprocess.Popen(
        [find(), *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    ) as program:
        try:
            said, complaint = program.communicate()
        except KeyboardInterrupt:
            program.communicate()  # Ctrl-C reached it too: it writes checkpoints before it ends
            raise
    if program.returncode != 0:
        raise ProgramError(["eerie", *words], program.returncode, complaint)
    return said
