"""Particles of a job are those of its files, particle by particle and in SI."""

import json
import os
import subprocess
import sys
import unittest

import eerie
import h5py
import numpy as np
from small_campaign import campaign


class Jobs(unittest.TestCase):
    def setUp(self):
        self.job = campaign().job(int(campaign().results()["job"].iloc[0]))

    def test_a_job_has_its_scene_its_result_and_its_remnants(self):
        result = json.loads((self.job.folder / "result.json").read_text())
        self.assertEqual(result["scene_hash"], self.job.hash)
        self.assertEqual(self.job.scene, json.loads((self.job.folder / "scene.json").read_text()))
        self.assertEqual(self.job.result()["class"], result["analysis"]["outcome"]["class"])
        self.assertEqual(
            list(self.job.remnants()["mass_kg"]),
            [one["mass_kg"] for one in result["analysis"]["remnants"]],
        )
        self.assertEqual(self.job.hash, campaign().job(self.job.hash[:8]).hash)

    def test_snapshots_come_in_order_of_time_and_end_with_the_last_state(self):
        snapshots = self.job.snapshots()
        times = [one.time_s for one in snapshots]
        self.assertEqual(times, sorted(times))
        self.assertGreaterEqual(len(times), 4)
        self.assertEqual(snapshots[-1].path, self.job.final().path)
        self.assertEqual(snapshots[0].time_s, 0)
        self.assertEqual(self.job.history().attrs["units"]["time_s"], "s")

    def test_a_row_is_the_same_particle_in_every_snapshot(self):
        first, last = self.job.snapshots()[0], self.job.final()
        self.assertEqual(len(last), 200)
        for one in (first, last):
            self.assertTrue(np.array_equal(one["ParticleIDs"], np.arange(len(one))))
        self.assertTrue(np.array_equal(first["BodyIDs"], last["BodyIDs"]))
        with h5py.File(last.path) as file:
            in_file = np.flatnonzero(file["PartType0/ParticleIDs"][:] == 7)[0]
            self.assertTrue(np.array_equal(last["Coordinates"][7], file["State/Coordinates"][in_file]))
            self.assertEqual(last["Pressures"][7], file["PartType0/Pressures"][in_file])

    def test_units_are_those_of_mechanics(self):
        final = self.job.final()
        # Masses add up to what the database says; densities are about that of rock.
        mass = final["Masses"].sum()
        largest = self.job.remnants().iloc[0]
        self.assertAlmostEqual(largest["mass_kg"] / mass, largest["mass_over_total"], places=9)
        self.assertEqual(
            {name: final.units[name] for name in ("Masses", "Densities", "Velocities",
             "Pressures", "InternalEnergies", "Coordinates", "BodyIDs")},
            {"Masses": "kg", "Densities": "kg/m^3", "Velocities": "m/s", "Pressures": "Pa",
             "InternalEnergies": "J/kg", "Coordinates": "m", "BodyIDs": ""},
        )  # fmt: skip
        # The bodies of the first snapshot meet at the sum of their radii, with the impact speed.
        first, scene = self.job.snapshots()[0], self.job.scene
        of_impactor = first["BodyIDs"] == 1
        between = [
            first[name][of_impactor].mean(axis=0) - first[name][~of_impactor].mean(axis=0)
            for name in ("Coordinates", "Velocities")
        ]
        speed = 100 * np.linalg.norm(between[1])  # cm/s; before contact it is slower
        self.assertLess(speed, scene["impact"]["v_imp_cm_per_s"])
        self.assertGreater(speed, 0.8 * scene["impact"]["v_imp_cm_per_s"])
        self.assertGreater(np.linalg.norm(between[0]), 2 * scene["target"]["radius_m"])

    def test_a_frame_holds_every_array_with_its_unit(self):
        final = self.job.final()
        frame = final.frame()
        self.assertEqual(len(frame), len(final))
        self.assertTrue(np.array_equal(frame["Coordinates_y"], final["Coordinates"][:, 1]))
        self.assertTrue(
            np.array_equal(frame["DeviatoricStresses_xz"], final["DeviatoricStresses"][:, 4])
        )
        self.assertEqual(frame.attrs["units"]["DeviatoricStresses_xz"], "Pa")

    def test_a_damaged_snapshot_is_refused_by_name(self):
        damaged = self.job.folder.parent / "damaged.hdf5"
        whole = self.job.final().path.read_bytes()
        damaged.write_bytes(whole[: len(whole) // 3])
        self.addCleanup(damaged.unlink)
        self.assertRaisesRegex(eerie.Error, "damaged.hdf5", eerie.Snapshot, damaged)
        self.assertRaisesRegex(eerie.Error, "no such file", eerie.Snapshot, "none.hdf5")


class Yt(unittest.TestCase):
    def setUp(self):
        self.final = campaign().job(1).final()

    def test_yt_has_time_and_units(self):
        import yt

        yt.set_log_level("error")
        dataset = self.final.yt()
        data = dataset.all_data()
        self.assertEqual(float(dataset.current_time.to("s")), self.final.time_s)
        ids = np.asarray(data["PartType0", "ParticleIDs"]).astype(int)
        for name, unit in (("Pressures", "Pa"), ("DeviatoricStresses", "Pa")):
            values = data["eerie", name]
            self.assertEqual(str(values.units), unit)
            self.assertTrue(np.array_equal(values.value[np.argsort(ids)], self.final[name]))
        speed = data["PartType0", "particle_velocity_x"].to("m/s").value[np.argsort(ids)]
        np.testing.assert_allclose(speed, self.final["Velocities"][:, 0], rtol=1e-12)

    def test_without_yt_it_says_what_to_install(self):
        script = (
            "import sys; sys.modules['yt'] = None\n"
            "import eerie\n"
            "snapshot = eerie.Snapshot(sys.argv[1])\n"
            "assert len(snapshot['Masses']) == 200\n"
            "try: snapshot.yt()\n"
            "except eerie.Error as error: print(error)\n"
        )
        said = subprocess.run(
            [sys.executable, "-c", script, self.final.path],
            check=True, capture_output=True, text=True, env=os.environ,
        ).stdout  # fmt: skip
        self.assertIn("apt install python3-yt", said)


if __name__ == "__main__":
    unittest.main()
