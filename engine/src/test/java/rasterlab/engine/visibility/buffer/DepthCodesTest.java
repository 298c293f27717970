package rasterlab.engine.visibility.buffer;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;

class DepthCodesTest {
    private static final NearnessRange RANGE = new NearnessRange(1, 1e-3);

    private static final List<DepthCodes> ALL =
            List.of(
                    new FixedCodes(16, 16, RANGE),
                    new FixedCodes(24, 8, RANGE),
                    new FixedCodes(32, 16, RANGE),
                    new NearnessCodes(),
                    new ReversedCodes(RANGE));

    @Test
    @DisplayName("a nearer surface has a larger code, or one beyond a plane wraps around")
    void nearerIsSmaller() {
        double[] falling = {1e30, 9, 1, 0.5, 0.1, 0.0015, 1e-3, 1e-9, 0, -1e30};
        for (DepthCodes codes : ALL) {
            int before = Integer.MIN_VALUE;
            for (double nearness : falling) {
                int code = code(codes, nearness, 0);
                assertTrue(code >= before, codes + " at " + nearness);
                assertTrue(code < DepthCodes.EMPTY, codes + ": far plane looks empty");
                before = code;
            }
            assertTrue(code(codes, 0.5, 0) < code(codes, 0.1, 0), codes.toString());
        }
    }

    @Test
    @DisplayName("negative nearnesses of parallel views are ordered by their sign bits")
    void negativeFloatsAreInOrder() {
        var codes = new NearnessCodes();
        double[] falling = {3, 1e-9, 0, -1e-9, -2, -500};
        for (int i = 1; i < falling.length; i++)
            assertTrue(code(codes, falling[i - 1], 0) < code(codes, falling[i], 0));
        assertEquals(code(codes, 0.0, 0), code(codes, -0.0, 0));
    }

    @Test
    @DisplayName("a steep step overflows the sum")
    void steepStepsStayInRange() {
        for (DepthCodes codes : ALL) {
            var row = new int[8192];
            codes.row(-1e12, 1e9, 0, row.length, row);
            for (int i = 1; i < row.length; i++) assertTrue(row[i] <= row[i - 1], codes + " " + i);
        }
    }

    private static int code(DepthCodes codes, double nearness, int x) {
        var row = new int[1];
        codes.row(nearness, 0, x, x + 1, row);
        return row[0];
    }
}
