package rasterlab.exercises.drawing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.engine.raster.PixelMark;
import rasterlab.exercises.score.CasePicture;

class TablePicturesTest {
    private static final double[][] RIGHT = {{0.25, 0.5, 1}, {0.1, 0.2, 0.3}};
    private static final TableLabels COLORS = new TableLabels(List.of(), List.of("R", "G", "B"));
    private static final Agreement CLOSE = Agreement.within(1e-9);

    @Test
    void framesTheWrongCellAndNoOther() {
        double[][] actual = {{0.25, 0.5, 1}, {0.1, 0.9, 0.3}};
        Seen seen = seen(actual);
        seen.assertComplete("one wrong cell");
        for (int row = 0; row < 2; row++)
            for (int column = 0; column < 3; column++) {
                int marked =
                        Seen.count(seen.difference(), PixelMark.COLOR, cell(actual, row, column));
                assertEquals(
                        row == 1 && column == 1, marked > 50, row + ", " + column + ": " + marked);
            }
        Rectangle2D wrong = cell(actual, 1, 1);
        var sign = new Rectangle2D.Double(wrong.getX() + 6, wrong.getY() + 6, 14, 14);
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOR, sign) > 10, "no sign");
        assertEquals(0, Seen.count(seen.expected(), PixelMark.COLOR));
        assertEquals(0, Seen.count(seen.actual(), PixelMark.COLOR));
    }

    @Test
    void aCellWithinTheToleranceIsRight() {
        Seen seen = seen(new double[][] {{0.25, 0.5, 1}, {0.1, 0.2 + 1e-10, 0.3}});
        assertEquals(0, Seen.count(seen.difference(), PixelMark.COLOR));
        assertEquals("there is no difference", seen.differenceText("en"));
        assertEquals("различий нет", seen.differenceText("ru"));
    }

    @Test
    void aWrongNumberHasTheDigitsThatTellItFromTheRightOne() {
        double next = Math.nextUp(0.2);
        Seen seen =
                new Seen(
                        TablePictures.of(
                                COLORS,
                                RIGHT,
                                new double[][] {{0.25, 0.5, 1}, {0.1, next, 0.3}},
                                Agreement.within(0)));
        assertFalse(seen.expectedText("en").contains("0.2,"), seen.expectedText("en"));
        assertTrue(seen.expectedText("en").contains("0.20000000000000001"));
        assertTrue(seen.actualText("en").contains("0.20000000000000004"));
        assertTrue(seen.expectedText("en").contains("row 0: (0.25, 0.5, 1)"), "others stay short");
    }

    @Test
    @DisplayName("a Russian picture has decimal points, or whole numbers are drawn twice")
    void numbersAreWrittenAsTheLanguageDoes() {
        double[][] wrong = {{0.25, 0.5, 1}, {0.1, -0.3, 0.3}};
        for (CasePicture one : TablePictures.of(COLORS, RIGHT, wrong, Agreement.within(1e-9)))
            assertFalse(Arrays.equals(one.png("en"), one.png("ru")), one.kind());
        double[][] whole = {{1, 2}};
        for (CasePicture one :
                TablePictures.of(COLORS, whole, new double[][] {{1, 3}}, Agreement.within(1e-9)))
            assertFalse(one.file().hasOwn("ru"), one.kind());
    }

    @Test
    void tellsTheNumbersInBothLanguages() {
        Seen seen = seen(new double[][] {{0.25, 0.5, 1}, {0.1, -0.3, 0.3}});
        assertEquals(
                "a table of numbers; rows: 2, columns: 3; row 0: (0.25, 0.5, 1);"
                        + " row 1: (0.1, −0.3, 0.3)",
                seen.actualText("en"));
        assertEquals(
                "cells that differ: 1 of 6; the first is in row 1, column G:"
                        + " expected 0.2, actual −0.3, difference −0.5",
                seen.differenceText("en"));
        assertEquals(
                "отличается ячеек: 1 из 6; первое отличие в строке 1, столбце G:"
                        + " ожидалось 0,2, получено −0,3, разность −0,5",
                seen.differenceText("ru"));
        assertTrue(seen.actualText("ru").endsWith("строка 1: (0,1; −0,3; 0,3)"));
    }

    @Test
    void aLongTableIsShownAroundItsFirstWrongRow() {
        double[][] expected = new double[100][];
        double[][] actual = new double[100][];
        for (int i = 0; i < 100; i++) {
            expected[i] = new double[] {i % 2 == 0 ? 1 : 0, 1};
            actual[i] = new double[] {i % 2 == 0 ? 1 : 0, i != 70 ? 1 : 0};
        }
        Seen seen =
                new Seen(
                        TablePictures.of(
                                TableLabels.NUMBERS, expected, actual, Agreement.within(0)));
        seen.assertComplete("a long table");
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOR) > 50, "the wrong row is shown");
        assertTrue(seen.difference().getHeight() < 520, "at most 16 rows and two gaps");
        assertTrue(seen.expectedText("en").contains("rows 62 to 77 are shown"));
        assertTrue(seen.expectedText("ru").contains("показаны строки от 62 до 77"));
        assertTrue(seen.differenceText("en").contains("expected 1, actual 0, difference −1"));
    }

    @Test
    void missingAndExtraCellsAreMarkedAndTold() {
        double[][] actual = {{0.25, 0.5, 1}, {0.1, 0.2}, {7}};
        Seen seen = seen(actual);
        seen.assertComplete("rows of other lengths");
        Rectangle2D missing = cell(actual, 1, 2);
        Rectangle2D extra = cell(actual, 2, 0);
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOR, missing) > 50);
        assertTrue(Seen.count(seen.difference(), PixelMark.COLOR, extra) > 50);
        assertEquals(0, Seen.count(seen.difference(), PixelMark.COLOR, cell(actual, 2, 1)));
        assertEquals(
                "cells that differ: 0 of 6; missing cells: 1; extra cells: 1;"
                        + " the first is in row 1, column B: expected 0.3, nothing there",
                seen.differenceText("en"));
    }

    @Test
    void infinitiesAndNoNumbersAgreeWithThemselvesAlone() {
        Agreement within = Agreement.within(Double.POSITIVE_INFINITY);
        double infinity = Double.POSITIVE_INFINITY;
        assertTrue(within.holds(0, 0, infinity, infinity));
        assertTrue(within.holds(0, 0, Double.NaN, Double.NaN));
        assertTrue(within.holds(0, 0, 0.0, -0.0));
        assertTrue(Agreement.within(0.5).holds(0, 0, 1, 1.5), "the tolerance itself is allowed");
        assertFalse(Agreement.within(0.5).holds(0, 0, 1, 1.75));
        assertFalse(within.holds(0, 0, infinity, -infinity));
        assertFalse(within.holds(0, 0, infinity, 1e308));
        assertFalse(within.holds(0, 0, Double.NaN, 1));
        assertThrows(IllegalArgumentException.class, () -> Agreement.within(Double.NaN));
        assertThrows(IllegalArgumentException.class, () -> Agreement.within(-1));
    }

    @Test
    void anyNumbersAndSizesCanBeDrawn() {
        long seed = new Random().nextLong();
        var random = new Random(seed);
        for (int i = 0; i < 60; i++) {
            double[][] expected = table(random);
            double[][] actual = random.nextBoolean() ? table(random) : expected;
            String message = "seed " + seed + ", table " + i;
            var labels = new TableLabels(List.of("\n", "a name that is very long"), List.of(""));
            new Seen(TablePictures.of(labels, expected, actual, Agreement.within(1e-3)))
                    .assertComplete(message);
        }
    }

    private static double[][] table(Random random) {
        var table = new double[random.nextInt(4) == 0 ? random.nextInt(40) : random.nextInt(5)][];
        for (int row = 0; row < table.length; row++) {
            table[row] = new double[random.nextInt(9) == 0 ? random.nextInt(30) : 3];
            for (int i = 0; i < table[row].length; i++)
                table[row][i] =
                        random.nextBoolean()
                                ? random.nextGaussian()
                                : Double.longBitsToDouble(random.nextLong());
        }
        return table;
    }

    private static Seen seen(double[][] actual) {
        return new Seen(TablePictures.of(COLORS, RIGHT, actual, CLOSE));
    }

    private static Rectangle2D cell(double[][] actual, int row, int column) {
        var table = new TableComparison(RIGHT, actual, CLOSE);
        List<Integer> rows = new ShownRange(0, table.rows(), table.rows()).lines();
        List<Integer> columns = new ShownRange(0, 3, 3).lines();
        return new TableSheet(table, COLORS, rows, columns, "en").cell(row, column);
    }
}
