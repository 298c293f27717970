package rasterlab.engine.clip.volume;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.VolumeClipper;
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
        for (var method : TOPIC.methods())
            assertTrue(
                    VolumeCases.clip(method.implementation(), 0.1, 0.1, 0.1, -0.5, 0, 0, -0.9)
                            .isEmpty(),
                    method.name());
    }

    @Test
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
        for (var method : TOPIC.methods()) {
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
            for (var method : TOPIC.methods()) {
                long handedOver = 0;
                for (var input : workload.inputs())
                    handedOver +=
                            TOPIC.operations(method.implementation(), input).get("handed over");
                assertTrue(handedOver < 30, method.name() + " hands over " + handedOver);
            }
    }
}
