package rasterlab.engine.scene.obj;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class BrokenObjTest {
    private static final String NOTHING =
            "a.obj: no face with an area, no line and no point is in it";
    private static final String LEFT =
            "; no face with an area, no line and no point is in the file";

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(String obj, String message) {
        var refusal = assertThrows(BrokenFileException.class, () -> Texts.read(obj));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                square(
                        "vertex 99 is let in",
                        "f 1 2 99",
                        "face corner 3 names vertex 99; there are 4"),
                square(
                        "vertex 0 is let in",
                        "f 0 1 2",
                        "face corner 1 names vertex 0; there are 4, counted from 1 or back from -1"),
                square(
                        "vertex −5 of 4 is let in",
                        "f 1 2 -5",
                        "face corner 3 names vertex -5; there are 4"),
                square(
                        "a number beyond int wraps round",
                        "f 1 2 4294967299",
                        "face corner 3 names vertex 4294967299; there are 4"),
                square(
                        "a word is a corner",
                        "f 1 2 x",
                        "face corner 3 is 'x'; allowed are v, v/vt, v//vn and v/vt/vn"),
                square(
                        "a lone minus is a corner",
                        "f 1 2 -",
                        "face corner 3 is '-'; allowed are v, v/vt, v//vn and v/vt/vn"),
                line("NaN is a coordinate", "v 0 NaN 0", number("v", 2, "NaN")),
                line("an infinity is a coordinate", "v Infinity 0 0", number("v", 1, "Infinity")),
                line("1e999 is a coordinate", "v 0 0 1e999", number("v", 3, "1e999")),
                line("Java's suffix is a number", "v 0 0 1d", number("v", 3, "1d")),
                line("a lone point is a number", "v 0 0 .", number("v", 3, ".")),
                line("two coordinates are let in", "v 0 0", "'v' needs at least 3 numbers, got 2"),
                line(
                        "a decimal comma is another fault",
                        "v 0 0,5 0",
                        "'v' has a decimal comma in number 2, '0,5'; decimals are written with a"
                                + " point"),
                line(
                        "a comment within a number is a comment",
                        "v 0 0 -1.#IND00",
                        number("v", 3, "-1.#IND00")),
                line(
                        "coordinates behind a comment sign are read",
                        "v 0 0 # 1",
                        "'v' needs at least 3 numbers, got 2"),
                line(
                        "a file of curves is empty without a word",
                        "curv 0 1 1 2",
                        "'curv' cannot be read; faces, lines and points are, curves and surfaces are"
                                + " not; no face with an area, no line and no point is in the file"),
                argumentSet(
                        "a letter is a model without faces, and no line is named",
                        "# to whom it may concern\no desk\nDear reader,\nno model is here.",
                        "a.obj:3: 'Dear' begins no line of a Wavefront model, which has v, vt, vn,"
                                + " f, s, usemtl, mtllib, o, g, l and p; no face with an area, no"
                                + " line and no point is in the file"),
                argumentSet("an empty file is a model", "", NOTHING),
                square(
                        "a model of nothing but slivers is a model, or its line is not named",
                        "f 1 2 1",
                        "face without area or too thin to be seen was left out" + LEFT),
                square(
                        "a line to a vertex that is not there is not named",
                        "l 1 9\np 8",
                        "'l' was left out: face corner 2 names vertex 9; there are 4" + LEFT),
                square(
                        "a point that is not there is not named",
                        "p 9\nl 1 8",
                        "'p' was left out: face corner 1 names vertex 9; there are 4" + LEFT),
                square(
                        "a line of one vertex is not named",
                        "l 1",
                        "'l' of too few vertices was left out" + LEFT),
                square(
                        "a face of two corners is not named",
                        "f 1 2\ncurv 0 1 1 2",
                        "a face of fewer than 3 corners was left out" + LEFT));
    }

    private static String number(String keyword, int at, String got) {
        return "'%s' needs a number in ±1.0E18 as number %d, got '%s'".formatted(keyword, at, got);
    }

    private static Arguments square(String mistake, String more, String message) {
        return square(mistake, more, 5, message);
    }

    private static Arguments square(String mistake, String more, int line, String message) {
        return argumentSet(mistake, Texts.SQUARE + more, "a.obj:" + line + ": " + message);
    }

    private static Arguments line(String mistake, String line, String message) {
        return line(mistake, line, 1, message);
    }

    private static Arguments line(String mistake, String text, int line, String message) {
        return argumentSet(mistake, text, "a.obj:" + line + ": " + message);
    }

    @Test
    @DisplayName("a line without end fills the memory")
    void refusesLongLines() {
        var refusal =
                assertThrows(
                        BrokenFileException.class,
                        () -> Texts.read("\nv " + "1".repeat(TextLines.LONGEST)));
        assertEquals(
                "a.obj:2: the line is longer than the 1048576 characters allowed",
                refusal.getMessage());
    }
}
