package rasterlab.engine.polygon.triangulation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.study.Deviation;
import rasterlab.engine.study.Hazard;

/** The course asks for a polygon that its shortest-diagonal method cuts wrongly: here is one. */
class WrongPolygonTest {
    private static final TriangulateTopic TOPIC = new TriangulateTopic();
    private static final long SEED = 84;

    private static Points kept() {
        return TOPIC.hazards().stream()
                .filter(hazard -> hazard.name().equals("corner-in-the-ear"))
                .map(Hazard::input)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void aSearchOfRandomPolygonsFindsTheOneThatIsKept() {
        var random = new Random(SEED);
        Points polygon;
        do polygon = Points.of(random.ints(8, 0, 11).asDoubleStream().toArray());
        while (!(simpleCounterClockwise(polygon) && textbookError(polygon).worst() > 1));
        assertEquals(kept(), polygon, "seed " + SEED);
    }

    @Test
    void theFirstTriangleCutHasACornerInsideAndTheSecondTurnsBack() {
        Points polygon = kept();
        Triangles cut = textbook(polygon);
        assertEquals("[2, 3, 0, 2, 0, 1]", cut.toString());
        var exact = new ExactTriangulation(polygon);
        for (int k = 0; k < 3; k++) {
            int from = cut.corner(0, k);
            int to = cut.corner(0, (k + 1) % 3);
            assertEquals(1, exact.doubledArea(from, to, 1).signum(), "corner 1 is inside");
        }
        assertEquals(-1, exact.doubledArea(2, 0, 1).signum(), "the rest goes clockwise");
    }

    @Test
    void theTrianglesCoverMoreThanTwiceThePolygonsArea() {
        Deviation error = textbookError(kept());
        assertTrue(error.worst() > 100, error.toString());
        assertEquals("triangle 1 (2, 0, 1) goes clockwise", error.first());
    }

    /** Erratum: the listing assigns i + 1 to h where j is meant, so j names no corner. */
    @Test
    void asPrintedTheFirstTurnAsksForACornerThatIsNotThere() {
        var printed = TOPIC.method("shortest-diagonal-printed-textbook").implementation();
        for (Points polygon : List.of(Points.of(0, 0, 4, 0, 0, 3), kept())) {
            var crash =
                    assertThrows(
                            ArrayIndexOutOfBoundsException.class,
                            () -> printed.triangulate(polygon.xs(), polygon.ys()));
            assertTrue(crash.getMessage().startsWith("Index -1 "), crash.getMessage());
        }
    }

    /** The triangle that the printed listing fails on is cut with h and j as meant. */
    @Test
    void mendedTheFirstTurnIsRight() {
        assertEquals("[0, 1, 2]", textbook(Points.of(0, 0, 4, 0, 0, 3)).toString());
    }

    private static boolean simpleCounterClockwise(Points polygon) {
        var exact = new ExactTriangulation(polygon);
        return exact.ring().equals(List.of(0, 1, 2, 3)) && exact.simple();
    }

    private static Triangles textbook(Points polygon) {
        return new Triangles(
                new ShortestDiagonalTextbook().triangulate(polygon.xs(), polygon.ys()));
    }

    private static Deviation textbookError(Points polygon) {
        return TOPIC.compare(polygon, new ExactTriangulation(polygon).cut(), textbook(polygon));
    }
}
