package rasterlab.engine.light.face;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.study.Deviation;

class FaceShadingTest {
    private static final FaceTopic TOPIC = new FaceTopic();
    private static final SurfaceMaterial SHINY = FaceSamples.gray(0.5, 0.4, 40);

    @Property(tries = 150)
    void phongIsTheFormulaAtEveryPoint(@ForAll long seed) {
        var random = new Random(seed);
        double[] corners = random.doubles(9, -1, 1).toArray();
        double[] normals = random.doubles(9, -1, 1).toArray();
        for (int k = 2; k < 9; k += 3) normals[k] = 1.5;
        var material =
                FaceSamples.gray(random.nextDouble(), random.nextDouble(), random.nextInt(200));
        double[] lamp = random.doubles(3, 2, 5).toArray();
        double[] eye = random.doubles(3, 2, 5).toArray();
        var points = FacePoints.grid(FaceSamples.face(corners, normals, lamp, eye, material), 4);
        Deviation deviation =
                TOPIC.compare(
                        points, TOPIC.exact(points, 99), TOPIC.record(method("phong"), points, 99));
        assertTrue(TOPIC.correct(deviation), deviation::toString);
    }

    @Test
    void formulasAreCounted() {
        double[] above = {1, 2, 5};
        var points = FacePoints.grid(FaceSamples.dome(0.4, above, above, SHINY), 4);
        long count = points.weights().length / 3;
        assertEquals(Map.of("formulas", 1L), TOPIC.operations(method("flat"), points));
        assertEquals(Map.of("formulas", 3L), TOPIC.operations(method("gouraud"), points));
        for (String name : List.of("phong", "phong-textbook"))
            assertEquals(Map.of("formulas", count), TOPIC.operations(method(name), points));
    }

    @Test
    void toldEvaluationsAreThoseOfTheFormula() {
        double[] lamp = {1, 2, 5};
        var points = FacePoints.grid(FaceSamples.dome(0.4, lamp, lamp, SHINY), 3);
        var told = new ArrayList<Double>();
        double[] shades =
                ((SteppedFace) method("phong"))
                        .shade(
                                points.face(),
                                points.weights(),
                                (place, normal, intensity) -> {
                                    for (double share : intensity) told.add(share);
                                });
        assertArrayEquals(shades, told.stream().mapToDouble(share -> share).toArray());
    }

    @Test
    void allButFlatAgreeAtTheCorners() {
        double[] above = {1, 2, 5};
        LitFace face = FaceSamples.dome(0.4, above, above, SHINY);
        double[] corners = {1, 0, 0, 0, 1, 0, 0, 0, 1};
        double[] phong = method("phong").shade(face, corners);
        assertArrayEquals(phong, method("gouraud").shade(face, corners), 1e-12);
        assertArrayEquals(phong, method("phong-textbook").shade(face, corners), 1e-12);
    }

    @Test
    void machBandsAreStepsWhenFlatAndKinksByGouraudAndNeitherByPhong() {
        List<LitFace> faces = cylinder(8, 400);
        BrightnessProfile flat = BrightnessProfile.along(method("flat"), faces, 101);
        BrightnessProfile gouraud = BrightnessProfile.along(method("gouraud"), faces, 101);
        BrightnessProfile phong = BrightnessProfile.along(method("phong"), faces, 101);
        assertTrue(flat.largestStep() > 0.1, "flat steps by " + flat.largestStep());
        assertEquals(0, gouraud.largestStep(), 1e-12);
        assertTrue(gouraud.largestKink() > 0.1, "Gouraud bends by " + gouraud.largestKink());
        assertEquals(0, phong.largestStep(), 1e-12);
        assertTrue(phong.largestKink() < 0.02, "Phong bends by " + phong.largestKink());
    }

    /** The front half of a dull cylinder about y, with its radii as normals. */
    private static List<LitFace> cylinder(int facets, double away) {
        var faces = new ArrayList<LitFace>();
        for (int i = 0; i < facets; i++) {
            double from = Math.PI * (i / (double) facets - 0.5);
            double to = Math.PI * ((i + 1) / (double) facets - 0.5);
            double[] corners = {
                Math.sin(from),
                0,
                Math.cos(from),
                Math.sin(to),
                0,
                Math.cos(to), //
                Math.sin(from),
                1,
                Math.cos(from)
            };
            double[] normals = corners.clone();
            normals[7] = 0;
            double[] far = {0, 0, away};
            faces.add(FaceSamples.face(corners, normals, far, far, FaceSamples.gray(0.8, 0, 0)));
        }
        return faces;
    }

    @Test
    void onASphereErrorsShrinkFromFlatByGouraudToPhong() {
        SphereError flat = SphereError.of(method("flat"), 24, 12, SHINY);
        SphereError gouraud = SphereError.of(method("gouraud"), 24, 12, SHINY);
        SphereError phong = SphereError.of(method("phong"), 24, 12, SHINY);
        String all = flat + " " + gouraud + " " + phong;
        assertTrue(flat.mean() > 3 * gouraud.mean(), all);
        assertTrue(gouraud.mean() > 3 * phong.mean(), all);
        assertTrue(phong.worst() < 2, all);
        SphereError fine = SphereError.of(method("phong"), 48, 24, SHINY);
        assertTrue(fine.worst() < 1, fine.toString());
    }

    @Test
    void refusesWeightsThatAreNoMean() {
        LitFace face = FaceSamples.dome(0.4, new double[] {0, 0, 5}, new double[] {0, 0, 5}, SHINY);
        for (var method : TOPIC.methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () -> method.implementation().shade(face, new double[] {1, 1, -1}));
            assertEquals(
                    "points[0] must be weights of 0 or more with the sum 1, got (1.0, 1.0, -1.0)",
                    refusal.getMessage(),
                    method.name());
        }
    }

    private static FaceShader method(String name) {
        return TOPIC.method(name).implementation();
    }
}
