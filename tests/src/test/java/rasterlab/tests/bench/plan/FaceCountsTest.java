package rasterlab.tests.bench.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.scene.shape.Cylinder;
import rasterlab.engine.scene.shape.Patch;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.Sphere;
import rasterlab.engine.scene.shape.Torus;
import rasterlab.tests.bench.language.BenchWords;

class FaceCountsTest {
    @ParameterizedTest(name = "a plan of {0} has more faces than it may")
    @ValueSource(strings = {"sphere", "torus", "revolution"})
    void plansHaveFewFaces(String scene) {
        FaceCounts counts = FaceCounts.of(scene, 2);
        assertTrue(counts.fewest() > 100, counts.toString());
        assertTrue(counts.planned() >= counts.fewest(), counts.toString());
        assertTrue(counts.ratio() <= FaceCounts.MOST, counts.toString());
    }

    @ParameterizedTest(name = "with {0} units allowed other steps have fewer faces")
    @CsvSource({"0.4", "1", "3"})
    void noOtherStepsHaveFewerFaces(double most) {
        for (Patch patch : List.of(patch(new Sphere(50)), patch(new Torus(60, 20)))) {
            FewestFaces found = FewestFaces.of(patch, 0, most, 60, 40);
            int fewest = 60 * 40;
            for (int u = 3; u <= 60; u++)
                for (int v = 3; v <= 40; v++)
                    if (u * v < fewest && FewestFaces.distance(patch, u, v) <= most) fewest = u * v;
            assertEquals(fewest, found.faces(), found.toString());
        }
    }

    @Test
    void sidesOfACylinderAreOffByTheRiseOfTheirArc() {
        double rise = 50 * (1 - Math.cos(Math.PI / 12));
        Patch wall = Cylinder.open(50, 100).patches().get(0);
        assertEquals(rise, FewestFaces.distance(wall, 12, 3), 1e-9);
    }

    @Test
    @DisplayName("a line of the table lacks a number, or tells another ratio than its numbers")
    void lineTellsTheRatioOfItsNumbers() {
        assertEquals(
                "torus within 0.50 px | planned 230 | fewest 200 | 1.150 | 1.15 | yes",
                new FaceCounts("torus", 0.5, 230, 200).line(BenchWords.ENGLISH));
        assertEquals(
                "vase within 1.00 px | planned 300 | fewest 200 | 1.500 | 1.15 | no",
                new FaceCounts("vase", 1, 300, 200).line(BenchWords.ENGLISH));
    }

    private static Patch patch(SceneShape shape) {
        return shape.patches().get(0);
    }
}
