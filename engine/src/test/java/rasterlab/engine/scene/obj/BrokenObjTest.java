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
                        "a texture place that is not there is let in",
                        "f 1/1 2/1 3/1",
                        "face corner 1 names texture place 1; there are 0"),
                square(
                        "a normal that is not there is let in",
                        "vn 0 0 1\nf 1//1 2//1 3//2",
                        6,
                        "face corner 3 names normal 2; there are 1"),
                square("two corners are a face", "f 1 2", "a face needs at least 3 corners, got 2"),
                square(
                        "a word is a corner",
                        "f 1 2 x",
                        "face corner 3 is 'x'; allowed are v, v/vt, v//vn and v/vt/vn"),
                square(
                        "a slash too many is passed over",
                        "f 1 2 3////",
                        "face corner 3 is '3////'; allowed are v, v/vt, v//vn and v/vt/vn"),
                square(
                        "a lone minus is a corner",
                        "f 1 2 -",
                        "face corner 3 is '-'; allowed are v, v/vt, v//vn and v/vt/vn"),
                square(
                        "corners of two forms are let in",
                        "vn 0 0 1\nf 1//1 2 3//1",
                        6,
                        "face corner 2 is '2' but corner 1 is '1//1'; give all corners one form"),
                line("NaN is a coordinate", "v 0 NaN 0", number("v", 2, "NaN")),
                line("an infinity is a coordinate", "v Infinity 0 0", number("v", 1, "Infinity")),
                line("1e999 is a coordinate", "v 0 0 1e999", number("v", 3, "1e999")),
                line("Java's suffix is a number", "v 0 0 1d", number("v", 3, "1d")),
                line("a lone point is a number", "v 0 0 .", number("v", 3, ".")),
                line("two coordinates are let in", "v 0 0", "'v' needs 3 to 7 numbers, got 2"),
                line(
                        "half a colour is let in",
                        "v 0 0 0 1 1",
                        "'v' needs 3 numbers, and 1, 3 or 4 more, got 5"),
                line(
                        "a colour of 255 is let in",
                        "v 0 0 0 255 0 0",
                        "'v' needs a number from 0 to 1.0 as number 4, got '255'"),
                line(
                        "a normal without length is divided by 0",
                        "vn 0 0 0",
                        "normal (0.0, 0.0, 0.0) has no direction"),
                line(
                        "a missing material file is passed over",
                        "mtllib lost.mtl",
                        "there is no material file 'lost.mtl'"),
                line("a file without name is asked for", "mtllib", "'mtllib' needs a name"),
                line(
                        "a missing material is passed over",
                        "mtllib m.mtl\nusemtl green",
                        2,
                        "there is no material 'green'; the files above have red, blue sky"),
                line(
                        "a material without any file is passed over",
                        "usemtl red",
                        "there is no material 'red', and no 'mtllib' above names a file that has any"),
                line(
                        "a curve is left out of the picture",
                        "curv 0 1 1 2",
                        "'curv' cannot be read; faces ('f') are, curves and surfaces are not"),
                line(
                        "smoothing on is group 1",
                        "s on",
                        "'s' needs a number in ±1.0E18 as number 1, got 'on'"),
                square(
                        "a face that crosses itself is cut",
                        "v 9 1 0\nf 1 3 5 4",
                        6,
                        "face cannot be cut into triangles: edges may meet only at the corner they"
                                + " share, but those from corners 0 and 2 meet elsewhere"),
                square(
                        "two halves that cancel out are left out unseen",
                        "f 1 3 2 4",
                        "face crosses itself: seen from anywhere its parts cancel out"),
                argumentSet(
                        "a letter is a model without faces, and no line is named",
                        "# to whom it may concern\no desk\nDear reader,\nno model is here.",
                        "a.obj:3: 'Dear' begins no line of a Wavefront model, which has v, vt, vn,"
                                + " f, s, usemtl, mtllib, o, g, l and p; no face with an area is in"
                                + " the file"),
                argumentSet("an empty file is a model", "", "a.obj: no face with an area is in it"),
                argumentSet(
                        "a model of nothing but slivers is a model",
                        Texts.SQUARE + "f 1 2 1",
                        "a.obj: no face with an area is in it"));
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

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("materialMistakes")
    void refusesMaterials(String mtl, String message) {
        var refusal =
                assertThrows(
                        BrokenFileException.class,
                        () -> Texts.read("mtllib m.mtl\n" + Texts.SQUARE + "f 1 2 3", mtl));
        assertEquals("m.mtl:" + message, refusal.getMessage());
        assertEquals("m.mtl", refusal.file());
    }

    static Stream<Arguments> materialMistakes() {
        return Stream.of(
                argumentSet(
                        "a value belongs to no material",
                        "Kd 1 1 1",
                        "1: 'Kd' comes before the first 'newmtl'"),
                argumentSet(
                        "a colour above 1 is let in",
                        "newmtl a\nKd 1 1.5 1",
                        "2: 'Kd' needs a number from 0 to 1.0 as number 2, got '1.5'"),
                argumentSet(
                        "two thirds of a colour are let in",
                        "newmtl a\nKd 1 1",
                        "2: 'Kd' needs 3 numbers, got 2"),
                argumentSet(
                        "half a lighting model is let in",
                        "newmtl a\nillum 1.5",
                        "2: 'illum' needs a whole number, got '1.5'"),
                argumentSet(
                        "options of a texture are passed over",
                        "newmtl a\n\nmap_Kd -s 2 2 2 wood.png",
                        "3: 'map_Kd' is read without options, got '-s 2 2 2 wood.png'"),
                argumentSet("a material has no name", "newmtl", "1: 'newmtl' needs a name"));
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

    @Test
    @DisplayName("a bent face of any size is cut")
    void refusesBentFacesOfManyCorners() {
        var text = new StringBuilder();
        int corners = FaceCutter.MOST_CORNERS + 1;
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            text.append("v %s %s %s%n".formatted(Math.cos(angle), Math.sin(angle), i % 2));
        }
        text.append("f");
        for (int i = 1; i <= corners; i++) text.append(' ').append(i);
        var refusal = assertThrows(BrokenFileException.class, () -> Texts.read(text.toString()));
        assertEquals(
                "a.obj:1002: a face that is not flat or not convex may have 1000 corners, got 1001",
                refusal.getMessage());
    }
}
