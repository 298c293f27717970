package rasterlab.engine.polygon.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.FillRule;

class PolygonRefusalTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refusesWithPlaceAndValue(String message, double[] x, double[] y, int width, int height) {
        for (var method : new PolygonFillTopic().methods()) {
            var refusal =
                    assertThrows(
                            IllegalArgumentException.class,
                            () ->
                                    method.implementation()
                                            .fill(
                                                    x,
                                                    y,
                                                    FillRule.EVEN_ODD,
                                                    width,
                                                    height,
                                                    (row, from, to) -> {}));
            assertEquals(message, refusal.getMessage());
        }
    }

    static Stream<Arguments> mistakes() {
        double[] good = {1, 2, 3};
        return Stream.of(
                argumentSet(
                        "NaN compares as left of everything",
                        "x of corner 1 must be a number from -1e100 to 1e100, got NaN",
                        new double[] {1, Double.NaN, 3},
                        good,
                        9,
                        9),
                argumentSet(
                        "infinite row loops for ever",
                        "y of corner 2 must be a number from -1e100 to 1e100, got Infinity",
                        good,
                        new double[] {1, 2, Double.POSITIVE_INFINITY},
                        9,
                        9),
                argumentSet(
                        "corner without a row",
                        "a polygon needs as many x as y, got 3 and 2",
                        good,
                        new double[] {1, 2},
                        9,
                        9),
                argumentSet(
                        "picture without pixels",
                        "picture size must be from 1×1 to 8192×8192 pixels, got 0×9",
                        good,
                        good,
                        0,
                        9));
    }

    @Test
    void aTaskThatIsNoneIsRefused() {
        double[] three = {1, 2, 3};
        assertRefused(
                "a polygon needs as many x as y, got 3 and 2",
                () -> new PolygonTask(three, new double[2], FillRule.EVEN_ODD, 9, 9));
        assertRefused(
                "picture size must be from 1×1 to 8192×8192 pixels, got 9×0",
                () -> new PolygonTask(three, three, FillRule.EVEN_ODD, 9, 0));
        assertRefused(
                "corners need an even count of numbers, got 3",
                () -> PolygonTask.of(FillRule.EVEN_ODD, 9, 9, three));
    }

    private static void assertRefused(String message, Executable task) {
        var refusal = assertThrows(IllegalArgumentException.class, task);
        assertEquals(message, refusal.getMessage());
    }

    @Test
    void tooManyEdgeFunctionsAreRefusedBeforeTheFirst() {
        int n = 1_000_000;
        var x = new double[n];
        var y = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = i % 1000;
            y[i] = i % 2 * 999.5;
        }
        assertThrows(
                IllegalArgumentException.class,
                () ->
                        new EdgeFunctionPolygon()
                                .fill(x, y, FillRule.EVEN_ODD, 1000, 1000, (row, from, to) -> {}));
    }

    /** A circle of a million corners: its area, and a row's length, to a pixel. */
    @Test
    void aMillionCornersAreFilled() {
        int n = 1_000_000;
        var x = new double[n];
        var y = new double[n];
        for (int i = 0; i < n; i++) {
            x[i] = 500 + 400 * Math.cos(2 * Math.PI * i / n);
            y[i] = 500 + 400 * Math.sin(2 * Math.PI * i / n);
        }
        var pixels = new long[1];
        new ScanlinePolygon()
                .fill(
                        x,
                        y,
                        FillRule.NON_ZERO,
                        1000,
                        1000,
                        (row, from, to) -> pixels[0] += to - from);
        assertEquals(Math.PI * 400 * 400, pixels[0], 400);
    }

    @Test
    void theEmptyPolygonOwnsNothing() {
        for (var method : new PolygonFillTopic().methods())
            method.implementation()
                    .fill(
                            new double[0],
                            new double[0],
                            FillRule.NON_ZERO,
                            9,
                            9,
                            (row, from, to) -> {
                                throw new AssertionError(method.name() + " fills row " + row);
                            });
    }
}
