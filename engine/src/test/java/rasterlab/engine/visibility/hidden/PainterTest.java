package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.FlatPaint;

/**
 * Two faces: a band, x over the columns −40 to 40, and a small square in front of it or behind it.
 * The pixel in the square's middle tells who was drawn last.
 */
class PainterTest {
    private static final int BAND = 0xFF0000FF;
    private static final int SQUARE = 0xFFFFFFFF;

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void showsAtTheSquare(String method, double[] band, double square, int column, int color) {
        double[] xyz = {
            band[0],
            -40,
            -9,
            band[1],
            40,
            -9,
            band[1],
            40,
            9,
            band[0],
            -40,
            9, //
            square,
            column - 3,
            -3,
            square,
            column + 3,
            -3,
            square,
            column + 3,
            3,
            square,
            column - 3,
            3
        };
        List<int[]> faces = new ArrayList<>();
        faces.add(new int[] {1, 2, 3, 0});
        faces.add(new int[] {4, 5, 6, 7});
        var view = SideView.parallel(new Mesh(xyz, faces.toArray(int[][]::new)), 101, 41);
        var out = new Raster(101, 41);
        new Visibilities()
                .named(method)
                .implementation()
                .draw(view, new FlatPaint(new int[] {BAND, SQUARE}, new int[0]), out, () -> false);
        assertEquals(Integer.toHexString(color), Integer.toHexString(out.argb(50 + column, 20)));
    }

    /** The band's first three corners lie at band[1], band[1] and band[0]; x grows to the eye. */
    static Stream<Arguments> mistakes() {
        double[] slope = {-100, 100};
        double[] level = {0, 0};
        return Stream.of(
                argumentSet("painter draws near first", "painter", level, 20, 0, SQUARE),
                argumentSet("painter shows what is behind", "painter", level, -20, 0, BAND),
                argumentSet("textbook draws near first", "painter-textbook", level, 20, 0, SQUARE),
                argumentSet("raycast takes the farthest", "raycast", level, 20, 0, SQUARE),
                argumentSet("zfloat takes the farthest", "zfloat", level, 20, 0, SQUARE),
                argumentSet("equal depths are reordered", "painter", level, 0, 0, SQUARE),
                argumentSet("zfloat lets an equal depth win", "zfloat", level, 0, 0, BAND),
                argumentSet("raycast lets an equal depth win", "raycast", level, 0, 0, BAND),
                argumentSet("zfloat sorts whole faces", "zfloat", slope, -30, -20, SQUARE),
                argumentSet("raycast sorts whole faces", "raycast", slope, -30, -20, SQUARE),
                argumentSet("painter is no longer fooled", "painter", slope, -30, -20, BAND),
                argumentSet("painter averages three corners", "painter", slope, 20, 30, SQUARE),
                argumentSet(
                        "textbook averages all corners", "painter-textbook", slope, 20, 30, BAND),
                argumentSet(
                        "textbook does not round depths",
                        "painter-textbook",
                        new double[] {0.4, 0.4},
                        -0.3,
                        0,
                        SQUARE));
    }
}
