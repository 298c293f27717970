package rasterlab.engine.clip.segment;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The nine regions around a window and what their codes decide. */
class RegionCodeTest {
    private static final double[] PLACES = {-5, 5, 15};

    private static int code(double x, double y) {
        return new CohenSutherland.WindowSides(0, 0, 10, 10).code(x, y);
    }

    /** Bits from the left: 4 left of the window, 3 right of it, 2 below, 1 above. */
    @ParameterizedTest
    @CsvSource({
        "-5, 15, 1001", " 5, 15, 0001", "15, 15, 0101",
        "-5,  5, 1000", " 5,  5, 0000", "15,  5, 0100",
        "-5, -5, 1010", " 5, -5, 0010", "15, -5, 0110",
    })
    void course5EachOfTheNineRegionsHasItsCode(double x, double y, String bits) {
        assertEquals(Integer.parseInt(bits, 2), code(x, y));
    }

    @Test
    void windowAndMethodsTellTheSameCode() {
        var window = new ClipWindow(0, 0, 10, 10);
        for (double x : PLACES)
            for (double y : PLACES) assertEquals(code(x, y), window.code(x, y), x + ", " + y);
        assertEquals(0, window.code(Double.NaN, 5));
    }

    @Test
    void course5ASideBelongsToTheWindow() {
        for (double x : new double[] {0, 10})
            for (double y : new double[] {0, 10}) assertEquals(0, code(x, y));
        assertEquals(CohenSutherland.RIGHT, code(Math.nextUp(10.0), 10));
        assertEquals(
                CohenSutherland.LEFT | CohenSutherland.BOTTOM, code(-Double.MIN_VALUE, -1e-300));
    }

    /** c0 ∧ c1 ≠ 0 rejects, c0 ∨ c1 = 0 accepts, else the segment is cut: all 81 pairs. */
    @Test
    void course5TheTruthTableOfTwoCodesDecides() {
        var counts = new int[3];
        for (int from = 0; from < 9; from++)
            for (int to = 0; to < 9; to++) {
                double x0 = PLACES[from % 3];
                double y0 = PLACES[from / 3];
                double x1 = PLACES[to % 3];
                double y1 = PLACES[to / 3];
                boolean rejected = (code(x0, y0) & code(x1, y1)) != 0;
                boolean accepted = (code(x0, y0) | code(x1, y1)) == 0;
                var walk = new CohenSutherland().walk(0, 0, 10, 10, x0, y0, x1, y1);
                boolean cut = walk.advance();
                assertEquals(!rejected && !accepted, cut, from + " to " + to);
                var sent = new int[1];
                if (!cut) walk.send((ax, ay, bx, by) -> sent[0]++);
                if (!cut) assertEquals(accepted ? 1 : 0, sent[0], from + " to " + to);
                counts[rejected ? 0 : accepted ? 1 : 2]++;
            }
        assertEquals(1, counts[1], "pairs accepted");
        // four sides with three regions each: 4·3·3 pairs, those of a corner with itself twice
        assertEquals(4 * 9 - 4, counts[0], "pairs rejected");
        assertEquals(81 - 1 - 32, counts[2], "pairs cut");
    }
}
