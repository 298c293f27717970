package rasterlab.engine.polygon.scan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;
import static rasterlab.contract.FillRule.EVEN_ODD;
import static rasterlab.contract.FillRule.NON_ZERO;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.FillRule;
import rasterlab.contract.PolygonFiller;

/** Small polygons drawn by hand, each named after the mistake it catches. */
class PolygonPictureTest {
    private static final List<PolygonFiller> RIGHT =
            List.of(new ScanlinePolygon(), new EdgeFunctionPolygon());

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void fillsExactly(String picture, FillRule rule, double[] corners) {
        for (PolygonFiller method : RIGHT)
            assertEquals(
                    picture,
                    drawn(method, rule, corners, picture),
                    method.getClass().getSimpleName());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void theNaiveOneMissesThePicture(String picture, FillRule rule, double[] corners) {
        assertNotEquals(picture, drawn(new NaivePolygon(), rule, corners, picture));
    }

    /** Two spans in each of four rows, in the last only one; eight columns, four edges. */
    @Test
    void noEdgeFunctionIsEvaluatedTwice() {
        PolygonTask task = PolygonTask.of(EVEN_ODD, 12, 12, 1, 1, 9, 1, 9, 5, 5, 0.5, 1, 5);
        SpanWalk walk =
                new EdgeFunctionPolygon()
                        .walk(task.x(), task.y(), task.rule(), task.width(), task.height());
        int spans = 0;
        while (walk.advance()) spans++;
        assertEquals(7, spans);
        assertEquals(8 * 4 * 4, walk.operations().get("edge functions"));
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "right and bottom edges are filled too",
                        ".... .##. .##. ....",
                        EVEN_ODD,
                        new double[] {1, 1, 3, 1, 3, 3, 1, 3}),
                argumentSet(
                        "corner counts twice",
                        "#.... ##... ###.. ##... #....",
                        EVEN_ODD,
                        new double[] {0, -0.5, 2.75, 2, 0, 4.5}),
                argumentSet(
                        "peak on a row is lit",
                        "..... ..... ..#.. .###. .....",
                        EVEN_ODD,
                        new double[] {2, 1, 4, 3.5, 0, 3.5}),
                argumentSet(
                        "doubly wound middle is empty",
                        "####. ##### ##### .####",
                        NON_ZERO,
                        new double[] {0, 0, 4, 0, 4, 3, 1, 3, 1, 1, 5, 1, 5, 4, 1, 4, 1, 3, 0, 3}),
                argumentSet(
                        "there and back again is a line",
                        ".... .... ....",
                        EVEN_ODD,
                        new double[] {0, 0, 3, 2}));
    }

    private static String drawn(
            PolygonFiller method, FillRule rule, double[] corners, String like) {
        String[] rows = like.split(" ");
        var cells = new char[rows.length][rows[0].length()];
        for (char[] row : cells) Arrays.fill(row, '.');
        PolygonTask task = PolygonTask.of(rule, cells[0].length, cells.length, corners);
        method.fill(
                task.x(),
                task.y(),
                rule,
                task.width(),
                task.height(),
                (y, from, to) -> Arrays.fill(cells[y], from, to, '#'));
        return Arrays.stream(cells).map(String::new).collect(Collectors.joining(" "));
    }
}
