package rasterlab.engine.visibility.order;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import net.jqwik.api.Assume;
import net.jqwik.api.Example;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import rasterlab.engine.study.Deviation;

@Tag("slow")
class DepthOrderPropertyTest {
    private static final DepthOrderTopic TOPIC = new DepthOrderTopic();
    private static final List<String> RIGHT = List.of("newell", "bsp");

    private static void assertRight(Sight sight, long seed) {
        Assume.that(DepthOrderFullTest.inRange(sight));
        for (String name : RIGHT) {
            Painting painting = TOPIC.record(TOPIC.method(name).implementation(), sight, 1_000_000);
            Deviation deviation = PaintingComparison.compare(sight, painting);
            assertTrue(
                    TOPIC.correct(deviation),
                    () -> name + ", seed " + seed + ": " + deviation + " " + painting);
        }
    }

    private static double[] eye(Random random) {
        return new double[] {
            random.nextDouble(300, 500), random.nextDouble(-500, 500), random.nextDouble(-500, 500)
        };
    }

    @Property(tries = 120)
    void disjointTrianglesAreOrdered(
            @ForAll @IntRange(min = 1, max = 4) int cells, @ForAll long seed) {
        var random = new Random(seed);
        assertRight(new Sight(DepthOrderWorkloads.triangles(cells, random), eye(random)), seed);
    }

    /** Long triangles from wall to wall: circles and crossings without number. */
    @Property(tries = 150)
    void trianglesThroughEachOtherAreCutAndOrdered(
            @ForAll @IntRange(min = 2, max = 9) int count, @ForAll long seed) {
        assertRight(throughEachOther(count, seed), seed);
    }

    /** Triangle 3 is cut twice near one point, whose two corners turn the edge between them. */
    @Example
    void anEdgeBetweenTwoCornersOfCutsThatAllButMeetPartsNothing() {
        assertRight(throughEachOther(8, 2564), 2564);
    }

    private static Sight throughEachOther(int count, long seed) {
        var random = new Random(seed);
        var triangles = new double[count][];
        for (int k = 0; k < count; k++) triangles[k] = random.doubles(9, -100, 100).toArray();
        return new Sight(triangles, eye(random));
    }

    /** Planes coincide on a grid, corners touch edges, and eyes lie in planes. */
    @Property(tries = 600)
    void squaresOnAGridAreOrdered(
            @ForAll @IntRange(min = 2, max = 8) int count, @ForAll long seed) {
        var random = new Random(seed);
        var squares = new double[count][];
        for (int k = 0; k < count; k++) squares[k] = square(random);
        double[] eye = {9, random.nextInt(-2, 3), random.nextInt(-2, 3)};
        assertRight(new Sight(squares, eye), seed);
    }

    /** A square of the grid [−2, 2]³ at right angles to an axis, or slanting at half of one. */
    private static double[] square(Random random) {
        int axis = random.nextInt(3);
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        int side = random.nextInt(1, 4);
        int slant = random.nextInt(-1, 2);
        int[] from = {random.nextInt(-2, 2), random.nextInt(-2, 2), random.nextInt(-2, 2)};
        int[][] steps = {{0, 0}, {side, 0}, {side, side}, {0, side}};
        var square = new double[12];
        for (int i = 0; i < 4; i++) {
            square[3 * i + u] = from[u] + steps[i][0];
            square[3 * i + v] = from[v] + steps[i][1];
            square[3 * i + axis] = from[axis] + slant * steps[i][0];
        }
        return square;
    }

    /** Bars of thin tilted strips round a middle: circles of any length. */
    @Property(tries = 120)
    void circlesOfBarsAreOrdered(@ForAll @IntRange(min = 3, max = 9) int bars, @ForAll long seed) {
        var random = new Random(seed);
        double tilt = random.nextDouble(0.5, 3);
        var all = new double[bars][12];
        for (int k = 0; k < bars; k++) {
            double angle = 2 * Math.PI * k / bars + random.nextDouble(0.1);
            double[][] ends = {
                {-9, -2.5, -tilt}, {9, -2.5, tilt}, {9, -1.5, tilt}, {-9, -1.5, -tilt}
            };
            for (int i = 0; i < 4; i++) {
                all[k][3 * i] = ends[i][2];
                all[k][3 * i + 1] = ends[i][0] * Math.cos(angle) - ends[i][1] * Math.sin(angle);
                all[k][3 * i + 2] = ends[i][0] * Math.sin(angle) + ends[i][1] * Math.cos(angle);
            }
        }
        assertRight(new Sight(all, new double[] {60, random.nextDouble(-5, 5), 1}), seed);
    }
}
