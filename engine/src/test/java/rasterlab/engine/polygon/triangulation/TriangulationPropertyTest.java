package rasterlab.engine.polygon.triangulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Tag;
import net.jqwik.api.constraints.IntRange;
import rasterlab.contract.Triangulator;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.StarPolygon;
import rasterlab.engine.study.Deviation;

@Tag("slow")
class TriangulationPropertyTest {
    private static final TriangulateTopic TOPIC = new TriangulateTopic();
    private static final List<String> ORDERS = List.of("shortest-diagonal", "ear-clipping");

    @Property(tries = 150)
    void bothOrdersCoverTheAreaExactlyWhicheverWayRound(
            @ForAll @IntRange(min = 3, max = 40) int corners, @ForAll long seed) {
        Points polygon = StarPolygon.of(corners, 100, new Random(seed));
        for (Points way : List.of(polygon, polygon.reversed()))
            for (String order : ORDERS) assertCovered(way, order);
    }

    /** Random corners on a small grid: repeated, collinear, touching, crossing. */
    @Property(tries = 1_500)
    void smallGridsAreCutRightOrRefused(
            @ForAll @IntRange(min = 3, max = 9) int corners,
            @ForAll @IntRange(min = 2, max = 6) int grid,
            @ForAll long seed) {
        var random = new Random(seed);
        Points polygon = Points.of(random.ints(2L * corners, 0, grid).asDoubleStream().toArray());
        boolean simple = new ExactTriangulation(polygon).simple();
        for (String order : ORDERS)
            if (simple) assertCovered(polygon, order);
            else
                assertThrows(
                        IllegalArgumentException.class,
                        () -> cut(polygon, order),
                        order + " " + polygon);
    }

    /** Squares cut out of a square, each joined by a bridge to the one before. */
    @Property(tries = 200)
    void holesOnBridgesStayOpenWhicheverWayRound(
            @ForAll @IntRange(min = 1, max = 9) int holes, @ForAll long seed) {
        var random = new Random(seed);
        Points polygon = Keyholes.of(holes, random);
        var area = BigDecimal.valueOf(2L * Keyholes.area(holes));
        for (Points way : List.of(polygon, polygon.reversed())) {
            assertEquals(
                    0, area.compareTo(new ExactTriangulation(way).doubledArea()), way::toString);
            assertTrue(new ExactTriangulation(way).simple(), way::toString);
            for (String order : ORDERS) assertCovered(way, order);
        }
    }

    /**
     * Walls of a staircase on a grid: many corners on straight lines, nothing convex to hurry by.
     */
    @Property(tries = 100)
    void skylinesWithCornersOnStraightSidesAreCovered(
            @ForAll @IntRange(min = 1, max = 20) int towers, @ForAll long seed) {
        var random = new Random(seed);
        var xy = new double[4 * towers + 4];
        int size = 0;
        for (int i = 0; i < towers; i++) {
            double height = 1 + random.nextInt(4);
            xy[size++] = towers - i;
            xy[size++] = height;
            xy[size++] = towers - i - 1;
            xy[size++] = height;
        }
        xy[size++] = 0;
        xy[size++] = 0;
        xy[size++] = towers;
        xy[size] = 0;
        for (String order : ORDERS) assertCovered(Points.of(xy), order);
    }

    @Property(tries = 150)
    void fanCutsWhatItTakesRight(
            @ForAll @IntRange(min = 3, max = 7) int corners, @ForAll long seed) {
        var random = new Random(seed);
        Points polygon = Points.of(random.ints(2L * corners, 0, 5).asDoubleStream().toArray());
        Triangles fan;
        try {
            fan = cut(polygon, "fan");
        } catch (IllegalArgumentException refused) {
            return;
        }
        assertEquals(Deviation.NONE.worst(), compare(polygon, fan).worst(), polygon.toString());
    }

    private static void assertCovered(Points polygon, String order) {
        Triangles triangles = cut(polygon, order);
        var exact = new ExactTriangulation(polygon);
        BigDecimal covered = BigDecimal.ZERO;
        for (int t = 0; t < triangles.size(); t++)
            covered =
                    covered.add(
                            exact.doubledArea(
                                            triangles.corner(t, 0),
                                            triangles.corner(t, 1),
                                            triangles.corner(t, 2))
                                    .abs());
        assertEquals(0, exact.doubledArea().compareTo(covered), order + " " + polygon);
        assertEquals("", compare(polygon, triangles).first(), order + " " + polygon);
    }

    private static Triangles cut(Points polygon, String order) {
        Triangulator method = TOPIC.method(order).implementation();
        return TOPIC.record(method, polygon, Integer.MAX_VALUE);
    }

    private static Deviation compare(Points polygon, Triangles triangles) {
        return TOPIC.compare(polygon, new ExactTriangulation(polygon).cut(), triangles);
    }
}
