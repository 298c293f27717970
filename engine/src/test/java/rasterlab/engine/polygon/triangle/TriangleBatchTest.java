package rasterlab.engine.polygon.triangle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Random;
import java.util.function.DoubleSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import rasterlab.engine.polygon.ExactMembership;
import rasterlab.engine.polygon.NearSides;
import rasterlab.engine.polygon.Points;

@Tag("slow")
class TriangleBatchTest {
    private static final long SEED = 511;
    private static final int COUNT = 1_300;

    @Test
    void pointsOfAPictureAreJudgedAsOneByOne() {
        var random = new Random(SEED);
        for (int round = 0; round < 50; round++) {
            DoubleSupplier whole = () -> random.nextInt(40);
            assertAsRobust(corners(whole), points(whole), "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void pointsNearTheSidesAreJudgedAsOneByOne() {
        var random = new Random(SEED);
        for (int round = 0; round < 50; round++) {
            double far = Math.scalb(1.0, random.nextInt(400) - 200);
            Points corners = corners(() -> far * random.nextGaussian());
            Points near = NearSides.of(corners, COUNT, 2, random);
            assertAsRobust(corners, near, "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void needlesAndPointsFarOutAreJudgedAsOneByOne() {
        var random = new Random(SEED);
        for (int round = 0; round < 200; round++) {
            double thin = Math.scalb(1.0, -random.nextInt(60));
            Points corners =
                    Points.of(
                            random.nextGaussian(),
                            random.nextGaussian(),
                            random.nextGaussian(),
                            random.nextGaussian(),
                            0,
                            0);
            double mu = random.nextDouble();
            Points needle =
                    Points.of(
                            corners.x(0),
                            corners.y(0),
                            corners.x(1),
                            corners.y(1),
                            mu * corners.x(0) + (1 - mu) * corners.x(1) + thin,
                            mu * corners.y(0) + (1 - mu) * corners.y(1));
            Points points =
                    points(() -> Math.scalb(random.nextGaussian(), random.nextInt(120) - 60));
            assertAsRobust(needle, points, "seed " + SEED + ", round " + round);
        }
    }

    /** An error grows out there with the distance, and only a triangle with area outgrows it. */
    @Test
    void pointsFarOutAlongANeedleAreJudgedAsOneByOne() {
        var random = new Random(SEED);
        for (int round = 0; round < 100; round++) {
            double dx = random.nextGaussian();
            double dy = random.nextGaussian();
            double thin = Math.scalb(1.0, -30 - random.nextInt(25));
            Points needle =
                    Points.of(0.3, 0.7, 0.3 + dx, 0.7 + dy, 0.3 + 0.3 * dx, 0.7 + 0.3 * dy + thin);
            var xy = new double[2 * COUNT];
            for (int i = 0; i < xy.length; i += 2) {
                double mu = Math.scalb(random.nextGaussian(), random.nextInt(60));
                xy[i] = 0.3 + mu * dx;
                xy[i + 1] = 0.7 + mu * dy;
            }
            assertAsRobust(needle, Points.of(xy), "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void noAreaHugeAndTinyAreJudgedAsOneByOne() {
        var random = new Random(SEED);
        DoubleSupplier whole = () -> random.nextInt(9);
        for (double factor : new double[] {1e307, 1e150, 1e-150, 1e-300, Double.MIN_VALUE})
            assertAsRobust(
                    corners(whole).scaled(factor), points(whole).scaled(factor), "by " + factor);
        assertAsRobust(Points.of(1, 1, 3, 3, 7, 7), points(whole), "one line");
        assertAsRobust(Points.of(4, 4, 4, 4, 4, 4), points(whole), "one point");
    }

    /** Where one product after the other leaves the range of doubles. */
    @Test
    void productsAboutToOverflowAreJudgedExactly() {
        var random = new Random(SEED);
        for (int round = 0; round < 120; round++) {
            double size = Math.scalb(1.0, 500 + random.nextInt(41));
            Points corners = corners(() -> size * random.nextDouble());
            Points points = points(() -> size * random.nextDouble());
            assertExact(corners, points, "seed " + SEED + ", round " + round);
        }
    }

    @Test
    void numbersThatAreNoneAreRefused() {
        for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(
                    IllegalArgumentException.class, () -> new TriangleBatch(0, bad, 1, 0, 1, 1));
            var batch = new TriangleBatch(0, 0, 8, 0, 0, 8);
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    batch.judge(
                                            new double[] {1, bad}, new double[2], new boolean[2]));
            assertEquals("coordinate 0 must be finite, got " + bad, refusal.getMessage());
        }
    }

    @Test
    void countsThatDifferAreRefused() {
        var batch = new TriangleBatch(0, 0, 8, 0, 0, 8);
        assertThrows(
                IllegalArgumentException.class,
                () -> batch.judge(new double[2], new double[2], new boolean[1]));
    }

    private static Points corners(DoubleSupplier coordinate) {
        return Points.of(six(coordinate));
    }

    private static double[] six(DoubleSupplier coordinate) {
        var values = new double[6];
        for (int i = 0; i < 6; i++) values[i] = coordinate.getAsDouble();
        return values;
    }

    private static Points points(DoubleSupplier coordinate) {
        var values = new double[2 * COUNT];
        for (int i = 0; i < values.length; i++) values[i] = coordinate.getAsDouble();
        return Points.of(values);
    }

    private static boolean[] judged(Points t, Points points) {
        var inside = new boolean[points.size()];
        new TriangleBatch(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2))
                .judge(points.xs(), points.ys(), inside);
        return inside;
    }

    private static void assertExact(Points t, Points points, String where) {
        boolean[] judged = judged(t, points);
        var exact = new ExactMembership(t);
        var robust = new RobustTriangle();
        for (int i = 0; i < judged.length; i++) {
            double x = points.x(i);
            double y = points.y(i);
            boolean inside = exact.contains(x, y);
            String point = where + ", " + t + " (" + x + ", " + y + ")";
            assertEquals(inside, judged[i], point);
            assertEquals(
                    inside,
                    robust.contains(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y),
                    point);
        }
    }

    private static void assertAsRobust(Points t, Points points, String where) {
        boolean[] judged = judged(t, points);
        var robust = new RobustTriangle();
        for (int i = 0; i < judged.length; i++) {
            double x = points.x(i);
            double y = points.y(i);
            boolean inside = robust.contains(t.x(0), t.y(0), t.x(1), t.y(1), t.x(2), t.y(2), x, y);
            assertEquals(inside, judged[i], where + ", " + t + " (" + x + ", " + y + ")");
        }
    }
}
