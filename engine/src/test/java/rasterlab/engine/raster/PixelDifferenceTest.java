package rasterlab.engine.raster;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class PixelDifferenceTest {
    private static final int LEAST = Integer.MIN_VALUE;
    private static final int MOST = Integer.MAX_VALUE;

    @Test
    void marksRightMissingAndExtraFromTheTopLeftOfTheBox() {
        var difference =
                PixelDifference.of(recording(-2, -1, -1, -1, 0, 0), recording(-2, -1, 0, 0, 1, 1));
        assertEquals("#-..\n..#.\n...+", text(difference));
        assertEquals(Optional.of(new PixelWindow(-2, -1, 1, 1)), difference.box());
        assertEquals(2, difference.right().size());
        assertEquals(1, difference.missing().size());
        assertEquals(1, difference.extra().size());
        assertFalse(difference.isEmpty());
    }

    @Test
    void countsARepeatedPixelOnce() {
        var difference = PixelDifference.of(recording(3, 3), recording(3, 3, 3, 3));
        assertTrue(difference.isEmpty());
        assertEquals("#", text(difference));
    }

    @Test
    void forgivesWhatTheToleranceAllows() {
        var exact = recording(0, 0, 1, 0, 2, 0);
        var drawn = recording(0, 0, 1, 1, 2, 0);
        var difference = PixelDifference.of(exact, drawn, (x, y) -> x == 1);
        assertTrue(difference.isEmpty());
        assertEquals("#.#\n.#.", text(difference));
    }

    @Test
    void showsNothingWhereThereIsNothing() {
        var difference = PixelDifference.of(recording(), recording());
        assertEquals(Optional.empty(), difference.box());
    }

    @Test
    void cutsAHugeBoxAroundAPixelAndSaysSo() {
        var difference =
                PixelDifference.of(
                        recording(LEAST, LEAST, MOST, MOST, 5, 7), recording(5, 7, 6, 8));
        List<String> rows = text(difference).lines().toList();
        assertEquals(
                "columns -2147483648..-2147483569 of -2147483648..2147483647, rows"
                        + " -2147483648..-2147483609 of -2147483648..2147483647",
                rows.get(0));
        assertEquals(41, rows.size());
        assertEquals("-" + ".".repeat(79), rows.get(1));
    }

    @Test
    void saysWhichPartInEveryCountryInTheSameDigits() {
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
        try {
            var difference = PixelDifference.of(recording(0, 0, 90, 0), recording(0, 0, 90, 0));
            assertEquals(
                    "columns 0..79 of 0..90, rows 0..0 of 0..0",
                    text(difference).lines().findFirst().orElseThrow());
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void keepsTheCutInsideTheBoxAtItsFarCorner() {
        var exact = recording(LEAST, LEAST, MOST, MOST);
        var difference = PixelDifference.of(exact, recording(LEAST, LEAST));
        List<String> rows = difference.text(difference.around(MOST, MOST)).lines().toList();
        assertEquals(41, rows.size());
        assertEquals(".".repeat(79) + "-", rows.get(40));
    }

    @Test
    void showsABoxOfExactlyTheLargestSizeWhole() {
        var difference = PixelDifference.of(recording(0, 0, 79, 39), recording(0, 0, 79, 39));
        assertEquals(40, text(difference).lines().count());
        var wider = PixelDifference.of(recording(0, 0, 80, 39), recording(0, 0, 80, 39));
        assertEquals(41, text(wider).lines().count());
    }

    @Test
    void listsPixelsRowByRowForNegativeCoordinatesToo() {
        PixelSet set = PixelSet.of(recording(MOST, 0, LEAST, 0, -1, 0, 0, 0, 5, -1, LEAST, LEAST));
        var listed = new StringBuilder();
        for (int i = 0; i < set.size(); i++)
            listed.append(set.x(i)).append(' ').append(set.y(i)).append(';');
        assertEquals(
                "-2147483648 -2147483648;5 -1;-2147483648 0;-1 0;0 0;2147483647 0;",
                listed.toString());
        assertTrue(set.contains(LEAST, LEAST) && set.contains(-1, 0));
        assertFalse(set.contains(-1, -1) || set.contains(0, LEAST));
    }

    /** The difference in words around the topmost pixel. */
    private static String text(PixelDifference difference) {
        PixelWindow box = difference.box().orElseThrow();
        return difference.text(difference.around(box.xmin(), box.ymin()));
    }

    static PixelRecording recording(int... xys) {
        var recording = new PixelRecording(100);
        for (int i = 0; i < xys.length; i += 2) recording.plot(xys[i], xys[i + 1]);
        return recording;
    }
}
