package rasterlab.exercises.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.engine.raster.PixelRecording;
import rasterlab.exercises.document.OwnJson;

/** The changes by which a wrong answer comes from the right one are found, and no others. */
class KnownChangesTest {
    private static final String POINTS = "{'points': [[1, 2], [3, 5], [7.5, 4]]}";

    @ParameterizedTest(name = "{0} is not found")
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "negated | {'points': [[-1, -2], [-3, -5], [-7.5, -4]]}",
                "second-negated | {'points': [[1, -2], [3, -5], [7.5, -4]]}",
                "first-and-second-swapped | {'points': [[2, 1], [5, 3], [4, 7.5]]}",
                "reversed | {'points': [[7.5, 4], [3, 5], [1, 2]]}",
                "last-left-out | {'points': [[1, 2], [3, 5]]}",
                "first-again-at-the-end | {'points': [[1, 2], [3, 5], [7.5, 4], [1, 2]]}",
                "column-after-column | {'points': [[1, 3], [7.5, 2], [5, 4]]}",
                "fractions-cut-off | {'points': [[1, 2], [3, 5], [7, 4]]}",
                "scaled-2 | {'points': [[2, 4], [6, 10], [15, 8]]}"
            })
    void aChangeOfTheWholeAnswerIsFound(String change, String answer) throws IOException {
        assertEquals(List.of("changed-" + change), found(POINTS, answer));
    }

    @Test
    void anAnswerThatIsWrongInOnePlaceAloneIsNoChange() throws IOException {
        assertEquals(List.of(), found(POINTS, "{'points': [[1, 2], [3, -5], [7.5, 4]]}"));
    }

    @Test
    void numbersWithNoMoreDigitsThanAFloatAreFound() throws IOException {
        String inFloat =
                "{'shares': [0.10000000149011612, 0.20000000298023224, 0.699999988079071]}";
        assertEquals(List.of("changed-float"), found("{'shares': [0.1, 0.2, 0.7]}", inFloat));
    }

    @Test
    void numbersAboveOneWhereOneIsRightAreFound() throws IOException {
        String right = "{'shares': [1, 0.5, 0.25]}";
        assertEquals(List.of("changed-not-cut-at-1"), found(right, "{'shares': [1.5, 0.5, 0.25]}"));
    }

    @Test
    void twoValuesAreTooFewToTell() throws IOException {
        assertEquals(List.of(), found("{'points': [[1, 2]]}", "{'points': [[2, 1]]}"));
    }

    @Test
    void whatAChangeLeavesAsItIsCannotTellItApart() throws IOException {
        String symmetric = "{'points': [[1, 1], [3, 3], [4, 4]]}";
        var json = OwnJson.MAPPER.readTree(symmetric.replace('\'', '"'));
        assertTrue(KnownChanges.leaves("changed-first-and-second-swapped", json));
        assertFalse(KnownChanges.leaves("changed-negated", json));
    }

    @ParameterizedTest(name = "{0} is not found")
    @CsvSource(
            delimiter = '|',
            value = {
                "moved | .##.. .#.#. .#... .####",
                "mirrored-left-right | ..## .#.# ...# ####",
                "mirrored-up-down | #### #... #.#. ##..",
                "x-and-y-swapped | #### #..# .#.# ...#",
                "first-row-left-out | .... #.#. #... ####",
                "last-column-left-out | ##.. #.#. #... ###.",
                "run-ends-early | #... .... .... ###.",
                "rows-filled | ##.. ###. #... ####"
            })
    void aChangeOfTheWholePictureIsFound(String change, String picture) {
        List<String> found = codes(KnownChanges.of(pixels("##.. #.#. #... ####"), pixels(picture)));
        assertTrue(found.contains("changed-" + change), found.toString());
    }

    @Test
    void onePixelTooFewIsNoChange() {
        List<Cause> found =
                KnownChanges.of(pixels("##.. #.#. #... ####"), pixels("##.. #.#. .... ####"));
        assertEquals(List.of(), found);
    }

    @Test
    void everyChangeIsSaid() {
        Stream.of(Change.values()).map(Change::word).forEach(KnownChangesTest::assertSaid);
        Stream.of(PixelChange.values())
                .map(one -> one.name().toLowerCase(Locale.ROOT).replace('_', '-'))
                .forEach(KnownChangesTest::assertSaid);
    }

    private static void assertSaid(String word) {
        assertTrue(Message.isKnown("change." + word), word);
    }

    private static List<String> found(String right, String actual) throws IOException {
        return codes(
                KnownChanges.of(
                        OwnJson.MAPPER.readTree(right.replace('\'', '"')),
                        OwnJson.MAPPER.readTree(actual.replace('\'', '"'))));
    }

    private static List<String> codes(List<Cause> causes) {
        return causes.stream().map(Cause::code).toList();
    }

    /** The pixels of rows of characters. */
    private static PixelRecording pixels(String picture) {
        var pixels = new PixelRecording(100);
        String[] rows = picture.split(" ");
        for (int y = 0; y < rows.length; y++)
            for (int x = 0; x < rows[y].length(); x++)
                if (rows[y].charAt(x) == '#') pixels.plot(x, y);
        return pixels;
    }
}
