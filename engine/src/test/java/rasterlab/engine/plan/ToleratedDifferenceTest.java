package rasterlab.engine.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.engine.raster.Raster;

class ToleratedDifferenceTest {
    @ParameterizedTest(name = "an edge moved by {0} within {1} px: {2}")
    @CsvSource({
        "0, 0.1, true",
        "1, 0.5, true",
        "1, 1, true",
        "2, 1, false",
        "2, 1.1, true",
        "3, 2, false"
    })
    void edgeMayMoveAsFarAsTheToleranceSays(int by, double pixels, boolean within) {
        var tolerance = new Tolerance(pixels, 4, 0);
        assertEquals(
                within,
                ToleratedDifference.of(edge(8, 200), edge(8 + by, 200), tolerance)
                        .within(tolerance));
    }

    @Test
    void levelsBeyondTheToleranceCount() {
        var tolerance = new Tolerance(1, 4, 0);
        assertEquals(0, ToleratedDifference.of(edge(8, 200), edge(8, 204), tolerance).wrong());
        assertEquals(128, ToleratedDifference.of(edge(8, 200), edge(8, 205), tolerance).wrong());
    }

    @Test
    void whatIsMissingCountsAsWhatIsTooMuch() {
        var tolerance = new Tolerance(1, 4, 0);
        var dot = edge(0, 0);
        dot.argb()[8 * 16 + 8] = 0xFFFFFFFF;
        assertEquals(1, ToleratedDifference.of(dot, edge(0, 0), tolerance).wrong());
        assertEquals(1, ToleratedDifference.of(edge(0, 0), dot, tolerance).wrong());
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY, 65})
    void toleranceOfNoPixelsIsRefused(double pixels) {
        assertThrows(IllegalArgumentException.class, () -> new Tolerance(pixels, 1, 0));
    }

    @ParameterizedTest
    @ValueSource(doubles = {-1, Double.NaN, 256})
    void levelsOutOfRangeAreRefused(double levels) {
        assertThrows(IllegalArgumentException.class, () -> new Tolerance(1, levels, 0));
        assertThrows(IllegalArgumentException.class, () -> new Tolerance(1, 1, levels));
    }

    /** 16×16: black up to a column, grey from there. */
    private static Raster edge(int column, int level) {
        var raster = new Raster(16, 16);
        for (int i = 0; i < 256; i++)
            raster.argb()[i] = 0xFF000000 | (i % 16 < column ? 0 : 0x010101 * level);
        return raster;
    }
}
