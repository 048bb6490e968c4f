# SPDX-License-Identifier: BSD-3-Clause
"""Parameters for the thesis's own settings: which faces a map holds, and look-ups without branching."""

import numpy as np

from shadow_testing import Scene, Stage, TestCase, create, has_parameter, main, technique_names, \
    visibility


class Faces(TestCase):
    def look(self, stage, technique, **parameters):
        """Visibility, and a picture of the map."""
        shadows = create(technique, resolution=512, **parameters)
        stage.render(shadows)
        seen = visibility(shadows).copy()
        shadows.SetDebugView("map")
        return seen, stage.render(shadows)

    def names(self):
        return [name for name in technique_names() if has_parameter(name, "faces")]

    def stage(self, mirrored=False):
        stage = Stage()
        stage.add_floor()
        for actor in (stage.add_box((-0.8, 0.3, 1.0), (1, 1, 1.2)),
                      stage.add_sphere((0.9, -0.5, 1.3), 0.6)):
            actor.SetScale(-1 if mirrored else 1, 1, 1)
        stage.add_light()
        stage.look_at((3.5, -6.5, 4.5), (0.2, 0.2, 0.3))
        return stage

    def test_front_faces_are_the_first(self):
        # Of closed bodies the first layer is of faces that are turned to the light: the same map.
        self.assertIn("map-hard", self.names())
        for mirrored in (False, True):
            stage = self.stage(mirrored)
            for name in self.names():
                options = {"midpoint": "off"} if has_parameter(name, "midpoint") else {}
                with self.subTest(technique=name, mirrored=mirrored):
                    both, front, back = (self.look(stage, name, faces=faces, **options)
                                         for faces in ("both", "front", "back"))
                    self.assertTrue((front[0] == both[0]).all())
                    self.assertTrue((front[1] == both[1]).all())
                    # The back ones lie elsewhere, and throw the same shadow, but for texels at its edge.
                    self.assertGreater((back[1] != both[1]).any(axis=2).mean(), 0.01)
                    self.assertLess((np.abs(back[0] - both[0]) > 0.5).mean(), 0.05)

    def test_flat_casters_have_no_sides(self):
        scene = Scene("blocker")
        for name in self.names():
            options = {"midpoint": "off"} if has_parameter(name, "midpoint") else {}
            with self.subTest(technique=name):
                both, front, back = (self.look(scene, name, faces=faces, **options)
                                     for faces in ("both", "front", "back"))
                self.assertTrue((front[0] == both[0]).all())
                self.assertTrue((back[0] == both[0]).all())


class Branching(TestCase):
    def test_all_compares(self):
        # What is partly lit with branching was compared in whole; only what the ring decided can differ.
        scene = Scene("basic")
        for name in ("map-jitter", "map-combined"):
            seen = []
            for branching in ("on", "off"):
                shadows = create(name, branching=branching, skipping="off", resolution=1024)
                scene.render(shadows)
                seen.append(visibility(shadows).copy())
            on, off = seen
            with self.subTest(technique=name):
                partly = (on > 0) & (on < 1)
                self.assertGreater(partly.sum(), 200)
                self.assertLess((np.abs(on - off) > 1e-6)[partly].mean(), 0.02)
                missed = (on != off) & ~partly
                self.assertGreater(missed.sum(), 0)  # a thin shadow between the ring's points
                self.assertLess(np.abs(on - off).mean(), 0.02)


if __name__ == "__main__":
    main()
