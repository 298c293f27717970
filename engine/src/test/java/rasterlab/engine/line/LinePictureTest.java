package rasterlab.engine.line;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.contract.LineRasterizer;
import rasterlab.contract.Pixels;
import rasterlab.engine.study.Method;

/** Small lines drawn by hand, each named after the mistake it catches. */
class LinePictureTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void everyRightMethodDrawsThePicture(String picture, Segment segment) {
        for (var method : new LineTopic().methods())
            if (!method.faulty())
                drawn(picture, segment, method.implementation()).assertMatches(method.name());
        drawn(picture, segment, LinePictureTest::exactly).assertMatches("exact line");
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakesOfTheTextbooks")
    void textbookMethodMissesThePicture(String method, String picture, Segment segment) {
        Method<LineRasterizer> faulty = new LineTopic().method(method);
        assertFalse(drawn(picture, segment, faulty.implementation()).matches(), method);
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet("last pixel is dropped", "####", new Segment(0, 0, 3, 0)),
                argumentSet("single point is skipped or doubled", "#", new Segment(0, 0, 0, 0)),
                argumentSet("steep line leaves gaps", "#. #. .# .#", new Segment(0, 0, 1, 3)),
                argumentSet("leftward line draws nothing", "..## ##..", new Segment(3, 0, 0, 1)),
                argumentSet(
                        "leftward loop starts on the wrong side", "####", new Segment(3, 0, 0, 0)),
                argumentSet(
                        "upward line is drawn downward",
                        "...## .##.. #....",
                        new Segment(0, 2, 4, 0)),
                argumentSet("vertical divides by zero", "# # #", new Segment(0, 0, 0, 2)),
                argumentSet("upward vertical starts one too low", "# # #", new Segment(0, 2, 0, 0)),
                argumentSet("diagonal steps across late", "#.. .#. ..#", new Segment(0, 0, 2, 2)),
                argumentSet(
                        "falling diagonal keeps its column",
                        "..# .#. #..",
                        new Segment(2, 0, 0, 2)),
                argumentSet("tie goes to the larger row", "##. ..#", new Segment(0, 0, 2, 1)),
                argumentSet("tie depends on the direction", "##. ..#", new Segment(2, 1, 0, 0)),
                argumentSet("tie upward stays on the near row", ".## #..", new Segment(0, 1, 2, 0)),
                argumentSet("tie upward from the far end", ".## #..", new Segment(2, 0, 0, 1)),
                argumentSet(
                        "steep tie goes to the larger column", "#. #. .#", new Segment(0, 0, 1, 2)),
                argumentSet(
                        "steep tie depends on the direction", ".# #. #.", new Segment(1, 0, 0, 2)));
    }

    static Stream<Arguments> mistakesOfTheTextbooks() {
        var naive = "naive-textbook";
        var bresenham = "bresenham-textbook";
        var first = "bresenham-first-textbook";
        var pascal = "bresenham-pascal-textbook";
        return Stream.of(
                argumentSet("gaps when steep", naive, "#. #. .# .#", new Segment(0, 0, 1, 3)),
                argumentSet("nothing leftward", naive, "..## ##..", new Segment(3, 0, 0, 1)),
                argumentSet("rubbish on verticals", naive, "# # #", new Segment(0, 0, 0, 2)),
                argumentSet("larger row on ties", naive, "##. ..#", new Segment(0, 0, 2, 1)),
                argumentSet("wrong start leftward", bresenham, "####", new Segment(3, 0, 0, 0)),
                argumentSet("wrong start upward", bresenham, "# # #", new Segment(0, 2, 0, 0)),
                argumentSet("gaps in the first", first, "#. #. .# .#", new Segment(0, 0, 1, 3)),
                argumentSet("first knows no left", first, "..## ##..", new Segment(3, 0, 0, 1)),
                argumentSet("row only grows", pascal, "...# .##. #...", new Segment(0, 2, 3, 0)),
                argumentSet("vertical is a point", pascal, "# # #", new Segment(0, 0, 0, 2)),
                argumentSet("point doubled", bresenham, "#", new Segment(0, 0, 0, 0)),
                argumentSet("near row on ties", bresenham, ".## #..", new Segment(0, 1, 2, 0)));
    }

    private static TextCanvas drawn(String picture, Segment segment, LineRasterizer method) {
        var canvas = new TextCanvas(picture, 0, 0);
        method.draw(segment.x0(), segment.y0(), segment.x1(), segment.y1(), canvas);
        return canvas;
    }

    private static void exactly(int x0, int y0, int x1, int y1, Pixels out) {
        var exact = new ExactLine(new Segment(x0, y0, x1, y1));
        for (long k = 0; k < exact.size(); k++) out.plot(exact.x(k), exact.y(k));
    }
}
