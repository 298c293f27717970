package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.scene.shape.Cylinder;
import rasterlab.engine.scene.shape.Revolution;
import rasterlab.engine.scene.shape.ShapeSurfaces;

class ShapeStepsTest {
    @ParameterizedTest(name = "a cylinder of {0} sides is as far from the round one as κs²/8 says")
    @ValueSource(ints = {6, 12, 48, 200})
    void chordRisesByItsArc(int sides) {
        var steps = ShapeSteps.of(Cylinder.open(50, 100), sides, 1);
        double rise = 50 * (1 - Math.cos(Math.PI / sides));
        double bound = Math.pow(2 * Math.PI * 50 / sides, 2) / (8 * 50);
        assertTrue(steps.sag() >= rise, steps + " below " + rise);
        assertTrue(steps.sag() <= 1.11 * bound, steps + " above " + bound);
        assertEquals(sides, steps.faces());
    }

    @ParameterizedTest(name = "{0} in detail {1} is taken for other steps")
    @CsvSource({"sphere, 32", "torus, 48", "globe, 20", "torus, 100", "revolution, 40"})
    void stepsOfAMeshAreFound(String name, int detail) {
        Scene scene = Scenes.named(name, detail);
        var shapes = ((ShapeSurfaces) scene.surfaces().orElseThrow()).shapes();
        ShapeSteps found = ShapeSteps.found(scene, shapes.get(0), 0).orElseThrow();
        assertEquals(detail, found.u());
        assertEquals(detail / 2, found.v());
        assertEquals(scene.mesh().faceCount(), found.faces());
    }

    @ParameterizedTest(name = "a look at a few places of {0} finds more than one at all")
    @ValueSource(strings = {"sphere", "torus", "globe", "revolution", "sphere-and-cylinder"})
    void firstLookIsABoundFromBelow(String name) {
        Scene scene = Scenes.named(name, 20);
        for (var shape : ((ShapeSurfaces) scene.surfaces().orElseThrow()).shapes())
            for (int u = 4; u < 90; u += 17) {
                var glance = ShapeSteps.atLeast(shape, u, u / 2);
                var whole = ShapeSteps.of(shape, u, u / 2);
                assertTrue(glance.sag() <= whole.sag(), glance + " above " + whole);
                assertTrue(glance.bend() <= whole.bend(), glance + " above " + whole);
                assertTrue(glance.sag() >= whole.sag() / 4, glance + " says little of " + whole);
            }
    }

    @Test
    @DisplayName("a disc, whose faces lie in its plane, is cut finer than the wall it closes")
    void flatPartsNeedNoStepsOfTheirOwn() {
        var closed = ShapeSteps.of(Cylinder.closed(50, 100), 24, 1);
        var open = ShapeSteps.of(Cylinder.open(50, 100), 24, 1);
        assertEquals(open.sag(), closed.sag(), 1e-9);
        assertEquals(open.bend(), closed.bend(), 1e-9);
    }

    @Test
    @DisplayName(
            "a profile that bends both ways is taken for straight, since its middle is on the chord")
    void profileIsComparedAtMorePlacesThanTheMiddle() {
        var wave =
                new Revolution(
                        new double[] {-2, -1, 0, 1, 2},
                        new double[] {5, 6, 5, 4, 5},
                        SplineEnds.natural(),
                        false,
                        false);
        assertTrue(ShapeSteps.of(wave, 400, 1).sag() > 0.9, "rises and falls by 1");
    }
}
