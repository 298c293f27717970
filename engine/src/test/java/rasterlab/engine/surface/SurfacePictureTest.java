package rasterlab.engine.surface;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.FillRule;
import rasterlab.engine.raster.Raster;

/** Small drawings by brush and pen, each named after the mistake it catches. */
class SurfacePictureTest {
    private static final Brush INK = Brush.solid('#');

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("brushes")
    void aBrushFillsTheSquare(String picture, Brush brush) {
        var raster = new Raster(7, 5);
        double[] x = {1, 6, 6, 1};
        double[] y = {1, 1, 4, 4};
        new DrawingSurface(raster).fill(x, y, FillRule.EVEN_ODD, brush);
        assertEquals(picture, text(raster));
    }

    static Stream<Arguments> brushes() {
        return Stream.of(
                argumentSet(
                        "rows begin at the figure",
                        "....... ....... .#####. ....... .......",
                        Brush.rows('#', 2)),
                argumentSet(
                        "columns begin at the figure",
                        "....... ...#... ...#... ...#... .......",
                        Brush.columns('#', 3)),
                argumentSet(
                        "falling lines rise",
                        "....... .#..#.. ..#..#. ...#... .......",
                        Brush.falling('#', 3)),
                argumentSet(
                        "rising lines fall",
                        "....... ..#..#. .#..#.. ...#... .......",
                        Brush.rising('#', 3)),
                argumentSet(
                        "pattern begins at the figure",
                        "....... .*#*#*. .#*#*#. .*#*#*. .......",
                        Brush.pattern(new int[][] {{'*', '#'}, {'#', '*'}})),
                argumentSet(
                        "what lies below is wiped out",
                        "....... .*****. .#####. .*****. .......",
                        Brush.rows('#', 2).over(Brush.solid('*'))));
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("pens")
    void aPenDrawsTheLine(String picture, Pen pen, double[] x, double[] y) {
        String[] rows = picture.split(" ");
        var raster = new Raster(rows[0].length(), rows.length);
        new DrawingSurface(raster).draw(x, y, pen, INK);
        assertEquals(picture, text(raster));
    }

    static Stream<Arguments> pens() {
        double[] right = {1, 9};
        return Stream.of(
                argumentSet(
                        "width is taken for half the width",
                        "........... .########.. .########.. ...........",
                        new Pen(2, false),
                        right,
                        new double[] {2, 2}),
                argumentSet(
                        "dash and gap change places",
                        "........... .###..###.. ...........",
                        new Pen(1, false, 3, 2),
                        right,
                        new double[] {1, 1}),
                argumentSet(
                        "dashes begin anew at a corner",
                        "........ .###..## .......# ........ ........ ........",
                        new Pen(1, false, 3, 2),
                        new double[] {1, 7, 7},
                        new double[] {1, 1, 5}),
                argumentSet(
                        "round end is square",
                        "......... ..###.... .#####... #######.. .#####... ..###.... .........",
                        new Pen(4.2, true),
                        new double[] {2, 4},
                        new double[] {3, 3}));
    }

    @Test
    void aRoundPenMakesADotOfTwoEqualPoints() {
        assertEquals(".... .##. .##. ....", dot(new Pen(2.1, true)));
        assertEquals(".... .##. .##. ....", dot(new Pen(2.1, true, 3, 2)));
        assertEquals(".... .... .... ....", dot(new Pen(2.1, false)));
    }

    private static String dot(Pen pen) {
        var raster = new Raster(4, 4);
        double[] place = {1.5, 1.5};
        new DrawingSurface(raster).draw(place, place, pen, INK);
        return text(raster);
    }

    /** The sides of the widest pens would be pixels and pixels off with 32 corners. */
    @ParameterizedTest(name = "a pen of radius {0} is angular")
    @ValueSource(doubles = {0.1, 0.25, 1, 20, 52, 53, 1000, 500_000})
    void aRoundEndIsWithinAQuarterPixelOfTheCircle(double radius) {
        int corners = Pen.corners(radius);
        assertTrue(radius * (1 - Math.cos(Math.PI / corners)) <= 0.25 + 1e-9, corners + " corners");
        assertTrue(corners < 4_000, corners + " corners");
    }

    @Test
    void whatWasHandedOverOrOutCannotBeChangedLater() {
        double[] dashes = {3, 2};
        var pen = new Pen(1, false, dashes);
        dashes[0] = 0;
        pen.dashes()[1] = 0;
        assertArrayEquals(new double[] {3, 2}, pen.dashes());
        int[][] tile = {{'#'}};
        Brush brush = Brush.pattern(tile);
        tile[0][0] = '*';
        tile[0] = new int[0];
        assertEquals('#', brush.color(5, 5));
    }

    @Test
    void badPensAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new Pen(0, false));
        assertThrows(IllegalArgumentException.class, () -> new Pen(Double.NaN, false));
        assertThrows(IllegalArgumentException.class, () -> new Pen(1, false, 3));
        assertThrows(IllegalArgumentException.class, () -> new Pen(1, false, 3, 0));
        assertThrows(IllegalArgumentException.class, () -> Brush.rows('#', 0));
        assertThrows(IllegalArgumentException.class, () -> Brush.pattern(new int[][] {{}}));
        var surface = new DrawingSurface(new Raster(9, 9));
        double[] endless = {0, 1e300};
        assertThrows(
                IllegalArgumentException.class,
                () -> surface.draw(endless, endless, new Pen(1, false, 1, 1), INK));
    }

    private static String text(Raster raster) {
        var text = new StringBuilder();
        for (int y = 0; y < raster.height(); y++) {
            if (y > 0) text.append(' ');
            for (int x = 0; x < raster.width(); x++) {
                int cell = raster.argb(x, y);
                text.append(cell == 0 ? '.' : (char) cell);
            }
        }
        return text.toString();
    }
}
