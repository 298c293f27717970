package rasterlab.engine.fill;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.SeedFiller;

/**
 * Small regions filled by hand from the pixel marked o, each named after the mistake it catches.
 */
class FillPictureTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void everyRightMethodFillsExactly(String before, int connectivity, String after) {
        for (SeedFiller method : List.of(new StackFill(), new SpanFill()))
            assertEquals(after, filled(method, before, connectivity), method.getClass().getName());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakesOfTheTextbook")
    void theTextbookMissesThePicture(String before, int connectivity, String after) {
        assertNotEquals(after, filled(new RecursiveTextbookFill(), before, connectivity));
        everyRightMethodFillsExactly(before, connectivity, after);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("hole is filled over", "o... .##. ....", 4, "**** *##* ****"),
                argumentSet(
                        "region behind the hole is forgotten",
                        "..... .###. .#.#. .###. ..o..",
                        4,
                        "***** *###* *#.#* *###* *****"),
                argumentSet("diagonal gap leaks", "o#. #.. ...", 4, "*#. #.. ..."),
                argumentSet("diagonal gap holds", "o#. #.. ...", 8, "*#* #** ***"),
                argumentSet(
                        "diagonal gap of the last column holds",
                        "...# ...# o..# ###.",
                        8,
                        "***# ***# ***# ###*"),
                argumentSet("picture's edge is crossed", ".o.", 8, "***"),
                argumentSet(
                        "second run under a run is forgotten",
                        "..o.. .#.#. #.#.#",
                        4,
                        "***** *#*#* #.#.#"),
                argumentSet("other colours are filled too", "o+. -.. ...", 4, "*+. -.. ..."));
    }

    static Stream<Arguments> mistakesOfTheTextbook() {
        return Stream.of(
                argumentSet("corridor behind the seed", "#.# #o# #.#", 4, "#*# #*# #*#"),
                argumentSet("last column behind the seed", "o... ###. ....", 4, "**** ###* ****"),
                argumentSet("diagonal step", "o# #.", 8, "*# #*"));
    }

    private static String filled(SeedFiller method, String before, int connectivity) {
        List<String> rows = List.of(before.replace('o', '.').split(" "));
        var picture = new TextPicture(rows);
        int seed = before.indexOf('o');
        int stride = rows.get(0).length() + 1;
        method.fill(picture, seed % stride, seed / stride, '*', connectivity);
        return String.join(" ", picture.rows());
    }
}
