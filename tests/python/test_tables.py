"""Tables are those of the command line, bit for bit."""

import os
import tempfile
import unittest

import mien
import numpy as np
from vtkmodules.vtkIOXML import vtkXMLStructuredGridWriter
from programs import mien as command


class TablesTest(unittest.TestCase):
    def assert_same_rows(self, table, rows, skipped=()):
        self.assertEqual(table.row_count, len(rows))
        for mine, theirs in zip(table.rows(), rows):
            for name in set(mine) & set(theirs) - set(skipped):
                if theirs[name] is None:
                    self.assertTrue(np.isnan(mine[name]), name)
                else:
                    self.assertEqual(mine[name], theirs[name], name)

    def test_spectrum(self):
        table = mien.Face(harmonics=8).animate("joy").spectrum()
        self.assert_same_rows(table, command("spectrum", "-N", "8", "--expression", "joy")["modes"], skipped=["mode"])
        self.assertIn("rms_mm", table)

    def test_continuity(self):
        table = mien.Face(scheme="four-curve").continuity()
        report = command("continuity", "--scheme", "four-curve")
        self.assert_same_rows(table, report["seams"] + [report["all"]])
        self.assertGreater(table["g1_max_deg"].max(), 90.0)

    def test_sweep(self):
        table = mien.Face().sweep("0.5,1,2", ["spline", "tangent"])
        rows = command("sweep", "--a", "0.5,1,2", "--scheme", "spline,tangent")["samples"]
        self.assert_same_rows(table, rows)
        self.assert_same_rows(mien.Face().sweep([0.5, 1, 2], ["spline", "tangent"]), rows)

    def test_fitted_tables(self):
        face, joy = mien.Face(precision="double"), mien.Face(precision="double").animate("joy")
        fitted = mien.fit_table(face.grid(), joy.grid())
        with tempfile.TemporaryDirectory() as folder:
            files = [os.path.join(folder, name) for name in ("neutral.vts", "joy.vts")]
            for file, one in zip(files, (face, joy)):
                writer = vtkXMLStructuredGridWriter()
                writer.SetInputData(one.grid())
                writer.SetFileName(file)
                writer.Write()
            rows = command("fdt", "fit", "--neutral", files[0], "--expression", files[1])["regions"]
        for row in rows:
            for axis in "ab":
                row.update({f"{axis}{i + 1}": value for i, value in enumerate(row[axis])})
        self.assert_same_rows(fitted, rows)

    def test_a_surface_lies_on_itself(self):
        surface = mien.Face().surface()
        distances = mien.compare(surface, surface)
        self.assertEqual(list(distances["direction"]), ["to reference", "from reference"])
        self.assertEqual(distances["max_mm"].max(), 0.0)
        moved = mien.compare(mien.Face().animate("joy").surface(), surface)
        self.assertGreater(moved["max_mm"].max(), 1.0)


if __name__ == "__main__":
    unittest.main()
