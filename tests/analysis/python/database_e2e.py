"""The package's frames say what the program says."""

import math
import os
import shutil
import sqlite3
import unittest

import eerie
import small_campaign
from small_campaign import campaign


class Frames(unittest.TestCase):
    def test_every_view_has_the_rows_units_and_truth_values_of_the_program(self):
        for view in ("results", "remnants", "maps"):
            frame, said = getattr(campaign(), view)(), small_campaign.rows("--of", view)
            self.assertEqual(len(frame), len(said["data"]), view)
            self.assertGreater(len(frame), 0, view)
            for field in said["schema"]["fields"]:
                name = field["name"]
                self.assertEqual(frame.attrs["units"][name], field.get("unit", ""), (view, name))
                is_flag = str(frame[name].dtype).lower().startswith("bool")
                self.assertEqual(is_flag, field["type"] == "boolean", (view, name))
            self.assertEqual(list(frame.columns), [f["name"] for f in said["schema"]["fields"]])
            for column in ("q", "v_imp_cm_per_s", "b_over_a", "settings"):
                self.assertEqual(
                    sorted(frame[column]), sorted(row[column] for row in said["data"]), column
                )

    def test_the_map_holds_each_point_where_it_belongs(self):
        table = campaign().map("b_over_a", q=1, phi_d=40)
        self.assertEqual(list(table.index), [10, 15])
        self.assertEqual(list(table.columns), [15, 20])
        self.assertEqual(table.attrs["units"]["v_imp_cm_per_s"], "cm/s")
        for row in small_campaign.rows()["data"]:
            self.assertEqual(
                table.loc[row["theta_imp_deg"], row["v_imp_cm_per_s"]], row["b_over_a"]
            )
        self.assertTrue((campaign().map("class") == campaign().map("class", q=1)).all(axis=None))

    def test_jobs_are_there_before_they_have_results(self):
        path = small_campaign.folder() / "submitted.sqlite"
        sweep = small_campaign.folder() / "two.json"
        sweep.write_text('{"name": "two", "grid": {"v_imp_cm_per_s": [15, 20]}}')
        small_campaign.program("submit", sweep, "--db", path)
        waiting = eerie.open(path)
        self.assertEqual(list(waiting.jobs()["state"]), ["pending", "pending"])
        self.assertEqual(len(waiting.results()), 0)
        self.assertTrue(math.isnan(waiting.map().loc[15, 20]))
        job = waiting.job(2)
        self.assertEqual(job.scene["impact"]["v_imp_cm_per_s"], 20)
        for ask in (job.result, job.snapshots, job.history, job.final):
            self.assertRaisesRegex(eerie.Error, f"eerie show {job.hash[:8]}", ask)

    def test_several_settings_are_never_mixed_in_one_map(self):
        path = small_campaign.folder() / "settings.sqlite"
        sweep = {"name": "settings", "grid": {"numerics.particles_per_target": [100, 200]}}
        both = eerie.run(sweep, db=path, overrides={"end.time_s": 100})
        self.assertRaisesRegex(eerie.Error, "several settings: 1, 2", both.map)
        self.assertEqual(both.map("done", settings=2).shape, (1, 1))
        self.assertRaisesRegex(eerie.Error, "no point has settings = 3", both.map, settings=3)


class Refusals(unittest.TestCase):
    def refuses(self, path, words):
        self.assertRaisesRegex(eerie.Error, words, eerie.open, path)

    def test_files_that_are_no_database_are_refused_with_the_reason(self):
        folder = small_campaign.folder()
        (folder / "text.sqlite").write_text("not a database at all" * 100)
        sqlite3.connect(folder / "other.sqlite").execute("CREATE TABLE t (x)").connection.close()
        self.refuses(folder / "none.sqlite", "no such file; `eerie run SWEEP --db")
        self.refuses(folder, "no such file")
        self.refuses(folder / "text.sqlite", "not a database; give another file")
        self.refuses(folder / "other.sqlite", "not one of eerie's")

    def test_an_older_schema_is_refused_with_what_brings_it_up_to_date(self):
        old = small_campaign.folder() / "old.sqlite"
        shutil.copy(campaign().path, old)
        with sqlite3.connect(old) as connection:
            connection.execute("PRAGMA user_version = 4")
        connection.close()
        self.refuses(old, "schema has version 4.*eerie doctor --fix")

    def test_unknown_quantities_and_arrays_come_with_the_nearest_names(self):
        with self.assertRaisesRegex(eerie.UnknownNameError, "closest are b_over_a"):
            campaign().map("b_ovr_a")
        with self.assertRaisesRegex(eerie.UnknownNameError, "closest are Densities"):
            campaign().job(1).final()["density"]
        with self.assertRaisesRegex(eerie.Error, "no job of 'zz'"):
            campaign().job("zz")
        with self.assertRaisesRegex(eerie.Error, r"no point has phi_d_deg = 41; there are 40\.0"):
            campaign().map(phi_d=41)

    def test_nothing_can_be_written_through_the_package(self):
        with self.assertRaisesRegex(eerie.Error, "readonly"):
            campaign().query("DELETE FROM jobs")
        self.assertEqual(len(campaign().jobs()), 4)

    def test_a_database_where_nothing_can_be_written_is_read_as_it_is(self):
        folder = small_campaign.folder() / "theirs"
        folder.mkdir()
        path = folder / "a b#c?.sqlite"
        shutil.copy(campaign().path, path)
        folder.chmod(0o555)
        self.addCleanup(folder.chmod, 0o755)
        small_campaign.folder().chmod(0o755)
        child = os.fork()
        if child == 0:
            if os.geteuid() == 0:  # root may write anywhere
                os.setgid(65534)
                os.setuid(65534)
            read = len(eerie.open(path).results())
            os._exit(0 if read == 4 and [p.name for p in folder.iterdir()] == [path.name] else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)


if __name__ == "__main__":
    unittest.main()
