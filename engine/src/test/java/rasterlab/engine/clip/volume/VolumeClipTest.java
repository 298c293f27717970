package rasterlab.engine.clip.volume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.VolumeClipper;
import rasterlab.engine.study.LimitReached;
import rasterlab.engine.study.Method;

class VolumeClipTest {
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final VolumeClipTopic TOPIC = VolumeCases.TOPIC;

    @Test
    void course5EachBitOfTheSixIsItsPlane() {
        double zmin = 0.25;
        assertEquals(0, CohenSutherland6.code(zmin, 0.5, -0.5, 0.5));
        assertEquals(1, CohenSutherland6.code(zmin, 0, 0.6, 0.5));
        assertEquals(2, CohenSutherland6.code(zmin, 0, -0.6, 0.5));
        assertEquals(4, CohenSutherland6.code(zmin, 0.6, 0, 0.5));
        assertEquals(8, CohenSutherland6.code(zmin, -0.6, 0, 0.5));
        assertEquals(16, CohenSutherland6.code(zmin, 0, 0, 1.5));
        assertEquals(32, CohenSutherland6.code(zmin, 0, 0, 0.125));
        assertEquals(1 + 4 + 16, CohenSutherland6.code(zmin, 3, 3, 2));
        assertEquals(32, CohenSutherland6.code(zmin, 0, 0, 0));
        assertEquals(1 + 2 + 4 + 8 + 32, CohenSutherland6.code(zmin, 0, 0, -1));
        assertEquals(1 + 8 + 32, CohenSutherland6.code(zmin, -3, 3, -1));
    }

    @Test
    void course5TheMatrixTakesTheNearCornerTo110AndTheFarTo111() {
        double zmin = 0.25;
        assertArrayEquals(new double[] {1, 1, 0}, divided(zmin, zmin, zmin, zmin));
        assertArrayEquals(new double[] {1, 1, 1}, divided(zmin, 1, 1, 1));
        assertArrayEquals(new double[] {-1, 1, 1}, divided(zmin, -1, 1, 1));
    }

    private static double[] divided(double zmin, double x, double y, double z) {
        double[] h = HomogeneousClip.canonical(zmin, x, y, z);
        return new double[] {h[0] / h[3], h[1] / h[3], h[2] / h[3]};
    }

    @Test
    void behindTheEyeIsNotFoldedToTheFront() {
        for (var method : VolumeCases.rightMethods())
            assertTrue(
                    VolumeCases.clip(method.implementation(), 0.1, 0.1, 0.1, -0.5, 0, 0, -0.9)
                            .isEmpty(),
                    method.name());
    }

    @Test
    void course5DividingFirstKeepsWhatIsNotBetweenTheEnds() {
        // from (0, 0, −1) to (0, 0, 0.5), zmin = 1/4: Z = (−1 − 1/4)/(3/4·−1) = 5/3 and Z = 2/3, so
        // the box keeps Z = 1..2/3, z = 1..0.5, where z = 0.25..0.5 is right
        var first = TOPIC.method("divide-first-textbook").implementation();
        assertArrayEquals(
                new double[] {0, 0, 1, 0, 0, 0.5},
                VolumeCases.clip(first, 0.25, 0, 0, -1, 0, 0, 0.5).orElseThrow(),
                1e-15);
    }

    @Test
    void theMatrixsDivisionsAreCounted() {
        assertEquals(0, divisions("cohen-sutherland-6", 0, 0, 0.5, 0, 0, 0.75));
        assertEquals(2, divisions("homogeneous", 0, 0, 0.5, 0, 0, 0.75));
        assertEquals(1, divisions("cohen-sutherland-6", 0, 0, 0.5, 0, 0, 1.5));
        assertEquals(3, divisions("homogeneous", 0, 0, 0.5, 0, 0, 1.5));
        assertEquals(9, divisions("divide-first-textbook", 0, 0, 0.5, 0, 0, 1.5));
    }

    private static long divisions(String method, double... ends) {
        var input = new SegmentsInVolume(0.25, List.of(ends));
        return TOPIC.operations(TOPIC.method(method).implementation(), input).get("divisions");
    }

    @Test
    void aMethodThatSendsForEverIsStopped() {
        VolumeClipper endless =
                (zmin, x0, y0, z0, x1, y1, z1, out) -> {
                    while (true) out.segment(x0, y0, z0, x1, y1, z1);
                };
        var input = new SegmentsInVolume(0.25, List.of(new double[6]));
        assertThrows(LimitReached.class, () -> TOPIC.record(endless, input, 1_000));
    }

    @Test
    @Tag("slow")
    void noRandomSegmentIsMisjudged() {
        IntStream.range(0, FULL ? 1_000 : 20)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            double zmin = VolumeCases.randomZmin(random);
                            for (int i = 0; i < 1_000; i++)
                                VolumeCases.assertRight(zmin, VolumeCases.randomSegment(random));
                        });
    }

    @Test
    @Tag("slow")
    void noSegmentThatTouchesOrJustMissesIsMisjudged() {
        IntStream.range(0, FULL ? 100_000 : 5_000)
                .parallel()
                .forEach(
                        seed -> {
                            var random = new Random(seed);
                            double zmin = VolumeCases.randomZmin(random);
                            VolumeCases.assertRight(zmin, VolumeCases.adversary(random, zmin));
                        });
    }

    /** Halves meet edges, corners and the eye exactly, again and again. */
    @Test
    void everySegmentOfASmallGridIsRight() {
        IntStream.range(0, 15_625)
                .parallel()
                .forEach(
                        i -> {
                            double[] ends = new double[6];
                            for (int k = 0, rest = i; k < 6; k++, rest /= 5)
                                ends[k] = rest % 5 / 2.0 - (k % 3 == 2 ? 0.5 : 1);
                            VolumeCases.assertRight(0.5, ends);
                        });
    }

    /**
     * The segment goes past two planes' edge by the last bit, where enter and leave cannot be told
     * apart.
     */
    @Test
    void whatPassesAnEdgeWithinRoundingIsHandedOver() {
        double zmin = 0.28092317220248836;
        double[] ends = {
            -0.8270626826963425,
            -0.1133614272232579,
            0.33069211255419134,
            -0.3142451386671449,
            0.3142451386671451,
            0.314245138667145
        };
        for (var method : VolumeCases.rightMethods())
            assertTrue(handsOver(method, zmin, ends), method.name());
        VolumeCases.assertRight(zmin, ends);
    }

    /** W − Z is 10⁻⁹·(1 − z): of its 53 bits 30 are gone, as depth buffers know. */
    @Test
    void aFarPlaneThatRoundingHidesIsHandedOverByHomogeneousOnly() {
        double[] ends = {0, 0, 0.5, 0, 0, 1.5};
        for (var method : VolumeCases.rightMethods())
            assertEquals(
                    method.name().equals("homogeneous"),
                    handsOver(method, 1e-9, ends),
                    method.name());
        VolumeCases.assertRight(1e-9, ends);
    }

    /** An ordinary cut is decided in doubles. */
    @Test
    void whatIsCutInTheMiddleOfAPlaneIsNotHandedOver() {
        for (var method : VolumeCases.rightMethods())
            assertFalse(handsOver(method, 0.25, 0, 0, 0.5, 0.125, 0, 1.5), method.name());
    }

    private static boolean handsOver(Method<VolumeClipper> method, double zmin, double... ends) {
        var stepped = (SteppedVolumeClipper) method.implementation();
        VolumeWalk walk = VolumeClipTopic.walk(stepped, zmin, ends);
        while (walk.advance()) continue;
        return walk.unsure();
    }

    static Stream<Arguments> refused() {
        var cases = new ArrayList<Arguments>();
        var names =
                List.of(
                        "x of end 0",
                        "y of end 0",
                        "z of end 0",
                        "x of end 1",
                        "y of end 1",
                        "z of end 1");
        for (var method : VolumeCases.rightMethods()) {
            for (int i = 0; i < 6; i++)
                for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
                    double[] ends = {0, 0, 0.5, 0.1, 0.1, 0.6};
                    ends[i] = bad;
                    cases.add(Arguments.of(method, 0.1, ends, names.get(i)));
                }
            for (double zmin : new double[] {0, -0.5, 1, 2, Double.NaN})
                cases.add(Arguments.of(method, zmin, new double[] {0, 0, 0.5, 0, 0, 9}, "zmin"));
        }
        return cases.stream();
    }

    @ParameterizedTest
    @MethodSource("refused")
    void numbersThatAreNotFiniteAndEmptyVolumesAreRefusedByName(
            Method<VolumeClipper> method, double zmin, double[] ends, String name) {
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> VolumeCases.clip(method.implementation(), zmin, ends));
        assertTrue(refusal.getMessage().startsWith(name + " must be "), refusal.getMessage());
    }

    @Test
    void everyWorkloadHasItsShareOfVisibleSegments() {
        for (var workload : TOPIC.workloads())
            for (var input : workload.inputs())
                assertEquals(workload.size(), TOPIC.exact(input, 1_000).kept(), workload.name());
    }

    @Test
    void fewSegmentsOfAStudyAreHandedOver() {
        for (var workload : TOPIC.workloads())
            for (var method : VolumeCases.rightMethods()) {
                long handedOver = 0;
                for (var input : workload.inputs())
                    handedOver +=
                            TOPIC.operations(method.implementation(), input).get("handed over");
                assertTrue(handedOver < 30, method.name() + " hands over " + handedOver);
            }
    }
}
