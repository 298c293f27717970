package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.app.line.PixelCoverage.Shade;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.line.Segment;
import rasterlab.engine.line.WuLine;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelWindow;

class PixelCoverageTest {
    private static final Segment SEGMENT = new Segment(0, 0, 11, 4);

    private static PixelCoverage exact(Segment segment) {
        return PixelCoverage.exact(segment, new LineTopic().exact(segment, LineDrawing.LIMIT));
    }

    private static PixelCoverage wu(Segment segment, int limit) {
        return PixelCoverage.of(new WuLine(), segment, limit);
    }

    @Test
    void stepHasBothItsPixels() {
        assertEquals(List.of(new Shade(1, 0, 0, 255)), wu(SEGMENT, 99).at(1));
        assertEquals(
                List.of(new Shade(3, 2, 1, 185), new Shade(3, 2, 0, 70)), wu(SEGMENT, 99).at(3));
        assertEquals(22, wu(SEGMENT, 99).shades().size());
    }

    @Test
    void endsAfterSoManySteps() {
        assertEquals(4, wu(SEGMENT, 4).steps()[wu(SEGMENT, 4).steps().length - 1]);
        assertEquals(List.of(), wu(SEGMENT, 4).at(5));
    }

    @Test
    void windowLeavesOutWhatLiesBeside() {
        PixelCoverage seen = wu(SEGMENT.in(new PixelWindow(2, 1, 5, 1)), 99);
        assertEquals(List.of(new Shade(1, 2, 1, 185)), seen.at(1));
        for (Shade shade : seen.shades())
            assertTrue(shade.y() == 1 && shade.x() >= 2 && shade.x() <= 5, shade.toString());
    }

    @Test
    void exactCoverageIsThatOfWuInAllDirections() {
        long seed = 20250611;
        var random = new Random(seed);
        for (int i = 0; i < 300; i++) {
            var segment = new Segment(part(random), part(random), part(random), part(random));
            PixelCoverage exact = exact(segment);
            PixelCoverage drawn = wu(segment, LineDrawing.LIMIT);
            String where = segment + ", seed " + seed;
            assertTrue(drawn.worst(exact) <= 1, where);
            assertTrue(drawn.differenceFrom(exact).isEmpty(), where);
        }
    }

    private static int part(Random random) {
        return random.nextInt(401) - 200;
    }

    /** The picture that the lab once drew: the nearest pixels as whole blocks. */
    @Test
    void wholeBlocksAreTooMuchAndLeaveTheirNeighboursOut() {
        PixelCoverage exact = exact(SEGMENT);
        var blocks =
                new PixelCoverage(
                        exact.shades().stream()
                                .filter(shade -> shade.level() >= 128)
                                .map(shade -> new Shade(shade.step(), shade.x(), shade.y(), 255))
                                .toList());
        PixelDifference difference = blocks.differenceFrom(exact);
        assertEquals(10, difference.missing().size());
        assertEquals(10, difference.extra().size());
        assertEquals(2, difference.right().size());
        assertEquals(116, blocks.worst(exact));
    }
}
