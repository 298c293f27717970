package rasterlab.engine.pipeline.fast;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class OwnedPixelsTest {
    /** Corners run counter-clockwise on the picture: down on the left, then to the right. */
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void coversExactly(String picture, float[] xy) {
        String[] rows = picture.split(" ");
        int width = rows[0].length();
        var mesh = PixelSpace.mesh(xy, 0, 1, 2);
        var view = PixelSpace.view(width, rows.length, Culling.BACK);
        int[] counts = Coverage.of(mesh, view, width, rows.length).counterClockwise;
        var drawn = new StringBuilder();
        for (int i = 0; i < counts.length; i++) {
            if (i > 0 && i % width == 0) drawn.append(' ');
            drawn.append(counts[i] == 0 ? '.' : (char) ('0' + counts[i]));
        }
        assertEquals(picture, drawn.toString());
    }

    static Stream<Arguments> mistakes() {
        return Stream.of(
                argumentSet(
                        "a left edge on centres is not owned",
                        ".1.. .11. .... ....",
                        new float[] {1, -0.5f, 1, 2, 3.5f, 2}),
                argumentSet(
                        "a level top edge is not owned",
                        ".... .11. .1.. ....",
                        new float[] {1, 1, 1, 3, 3, 1}),
                argumentSet(
                        "a right edge on centres is owned",
                        "...1 ..11 .111 ....",
                        new float[] {4, -1, 0, 3, 4, 3}),
                argumentSet(
                        "a triangle between centres is drawn",
                        ".... .... ....",
                        new float[] {1.1f, 1.1f, 1.1f, 1.9f, 1.9f, 1.9f}),
                argumentSet(
                        "what is left of the picture is wrapped",
                        "1... 1... 1... 1...",
                        new float[] {-3, -9, -3, 20, 0.5f, 1}),
                argumentSet("the only pixel is missed", "1", new float[] {-9, -9, -9, 9, 9, 0}));
    }
}
