"""Surfaces and curves are those of the command line, bit for bit."""

import os
import unittest

import mien
import numpy as np
from programs import DATA, array_of, points_of, written

DEMO = os.path.join(DATA, "animation", "demo.fap")


class FaceTest(unittest.TestCase):
    def assert_same_surface(self, face, *options):
        grid, expected = face.grid(), written("surface", ".vts", *options)
        np.testing.assert_array_equal(points_of(grid), points_of(expected))
        self.assertEqual(points_of(grid).dtype, points_of(expected).dtype)
        for name in ("Normals", "TextureCoordinates"):
            np.testing.assert_array_equal(array_of(grid, name), array_of(expected, name))

    def test_surfaces_equal_those_of_the_command_line(self):
        face = mien.Face()
        self.assert_same_surface(face)
        self.assert_same_surface(face.replace(scheme="four-curve", a=2, harmonics=8, resolution=(29, 20)), "--scheme",
                                 "four-curve", "-a", "2", "-N", "8", "--resolution", "29x20")
        self.assert_same_surface(face.replace(precision="double").animate(joy=0.8, surprise=0.2), "--expression",
                                 "joy:0.8,surprise:0.2", "--precision", "double")
        self.assert_same_surface(face.animate(faps={53: 200, 54: 150}), "--set", "53=200,54=150")
        self.assert_same_surface(face.animate(fap=DEMO, index=139), "--fap", DEMO, "--index", "139")
        self.assert_same_surface(face.deform("surprise", 0.5), "--fdt", "surprise:0.5")

    def test_polygons_are_those_of_the_written_mesh(self):
        surface, expected = mien.Face().animate("joy").surface(), written("surface", ".vtp", "--expression", "joy")
        self.assertEqual(len(surface.polygons), expected.GetNumberOfPolys())
        self.assertEqual(surface.normals.shape, surface.points.shape)
        self.assertEqual(set(np.unique(surface.cell_data["PatchId"])), set(range(9)))
        corners = surface.points[surface.quads]
        outwards = np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1])
        middle = corners.mean(axis=1) - surface.points.mean(axis=0)
        self.assertGreater(np.einsum("ij,ij", outwards, middle), 0.0)

    def test_curves_equal_those_of_the_command_line(self):
        curves, expected = mien.Face().animate("surprise").curves(), written("curves", ".vtp", "--expression", "surprise")
        self.assertEqual(list(curves)[:2] + list(curves)[21:23], ["C1", "C2", "C22", "C22'"])
        np.testing.assert_array_equal(np.concatenate(list(curves.values())), points_of(expected))

    def test_a_face_never_changes(self):
        face = mien.Face()
        before, state = face.surface().points.copy(), face.state
        joy = face.animate("joy")
        self.assertGreater(np.abs(joy.surface().points - before).max(), 5.0)
        np.testing.assert_array_equal(face.surface().points, before)
        self.assertEqual(face.state, state)
        self.assertEqual(joy.neutral(), face)
        state["surface"]["scheme"] = "tangent"
        self.assertEqual(face.state["surface"]["scheme"], "spline")

    def test_arrays_outlive_their_face(self):
        points = mien.Face().animate("joy").surface().points
        np.testing.assert_array_equal(points, mien.Face().animate("joy").surface().points)

    def test_a_state_gives_the_face_again(self):
        face = mien.Face(a=[1, 2, 3, 4, 5, 6, 7, 8, 9]).animate("fear", faps={3: 100}).deform("joy", -0.5)
        self.assertEqual(mien.Face(state=face.state), face)
        self.assertEqual(hash(mien.Face(state=face.state)), hash(face))

    def test_an_animation_has_its_times(self):
        face = mien.Face().animate(fap=DEMO)
        self.assertEqual(len(face.times), 301)
        self.assertEqual(len(mien.Face().times), 0)
        face.source.UpdateTimeStep(face.times[139])
        np.testing.assert_array_equal(points_of(face.source.GetOutput()),
                                      points_of(mien.Face().animate(fap=DEMO, index=139).grid()))
        shown = next(frame for i, frame in enumerate(face.frames()) if i == 2)
        np.testing.assert_array_equal(points_of(shown.grid()), points_of(face.animate(fap=DEMO, index=2).grid()))

    def test_motion_is_that_of_the_surfaces(self):
        face = mien.Face(precision="double")
        joy = face.animate("joy")
        motion = joy.motion()
        np.testing.assert_array_equal(motion.point_data["MotionVector"], points_of(joy.grid()) - points_of(face.grid()))
        back = face.motion(joy)
        np.testing.assert_array_equal(back.point_data["Magnitude"], motion.point_data["Magnitude"])


if __name__ == "__main__":
    unittest.main()
