package rasterlab.engine.visibility.triangle;

import java.util.Arrays;
import rasterlab.contract.DepthTriangleFiller;

/**
 * A picture of triangles, row by row.
 *
 * @param width of the picture
 * @param shown number of the triangle in each pixel, the first is 1; 0 where the background is
 * @param depths stored in each pixel
 */
public record ShownTriangles(int width, int[] shown, double[] depths) {
    /** Fills the triangles in their order. */
    static ShownTriangles by(DepthTriangleFiller method, DepthTriangles input) {
        ShownTriangles picture = empty(input);
        for (int t = 0; t < input.triangles().size(); t++)
            method.fill(
                    input.axis(t, 0),
                    input.axis(t, 1),
                    input.axis(t, 2),
                    t + 1,
                    input.width(),
                    input.height(),
                    picture.depths,
                    picture.shown);
        return picture;
    }

    static ShownTriangles empty(DepthTriangles input) {
        var depths = new double[input.pixels()];
        Arrays.fill(depths, input.background());
        return new ShownTriangles(input.width(), new int[depths.length], depths);
    }

    int covered() {
        int covered = 0;
        for (int number : shown) if (number != 0) covered++;
        return covered;
    }
}
