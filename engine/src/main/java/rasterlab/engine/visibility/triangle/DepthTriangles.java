package rasterlab.engine.visibility.triangle;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.DepthTriangleFiller;

/**
 * Triangles in the order of drawing, over a background of one depth.
 *
 * @param triangles x, y and depth of three corners of each, 1 to 64 of them
 * @param width of the picture, 1 to 256
 * @param height of the picture, 1 to 256; width times height times the triangles at most 1048576
 * @param background the depth stored in every pixel before, 0 to 1
 */
public record DepthTriangles(List<double[]> triangles, int width, int height, double background) {
    static final int MOST = 64;
    static final int MOST_LOOKS = 1 << 20;

    public DepthTriangles {
        require("number of triangles", triangles.size(), MOST);
        require("width", width, DepthTriangleFiller.LARGEST_SIDE);
        require("height", height, DepthTriangleFiller.LARGEST_SIDE);
        require("pixels times triangles", width * height * triangles.size(), MOST_LOOKS);
        if (!(background >= 0 && background <= 1))
            throw new IllegalArgumentException("background must be from 0 to 1, got " + background);
        triangles = triangles.stream().map(double[]::clone).toList();
        for (int t = 0; t < triangles.size(); t++)
            for (int i = 0; i < 9; i++) check(t, i, triangles.get(t)[i]);
    }

    private static void require(String name, int value, int most) {
        if (value < 1 || value > most)
            throw new IllegalArgumentException(
                    "%s must be from 1 to %d, got %d".formatted(name, most, value));
    }

    private static void check(int triangle, int i, double value) {
        boolean depth = i % 3 == 2;
        int least = depth ? 0 : -DepthTriangleFiller.LARGEST;
        int most = depth ? 1 : DepthTriangleFiller.LARGEST;
        String place = "triangles[%d][%d].%s".formatted(triangle, i / 3, "xyz".charAt(i % 3));
        if (!(value >= least && value <= most))
            throw new IllegalArgumentException(
                    "%s must be from %d to %d, got %s".formatted(place, least, most, value));
        if (!depth && value * DepthTriangleFiller.STEPS % 1 != 0)
            throw new IllegalArgumentException(
                    "%s must be a multiple of 1/%d, got %s"
                            .formatted(place, DepthTriangleFiller.STEPS, value));
    }

    int pixels() {
        return width * height;
    }

    /** Column, row or depth of a triangle's corners. */
    double[] axis(int triangle, int axis) {
        double[] corners = triangles.get(triangle);
        return new double[] {corners[axis], corners[3 + axis], corners[6 + axis]};
    }

    /**
     * A picture of triangles, row by row.
     *
     * @param width of the picture
     * @param shown number of the triangle in each pixel, the first is 1; 0 where the background is
     * @param depths stored in each pixel
     */
    public record TrianglePicture(int width, int[] shown, double[] depths) {
        /** Fills the triangles in their order. */
        static TrianglePicture by(DepthTriangleFiller method, DepthTriangles input) {
            TrianglePicture picture = empty(input);
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

        static TrianglePicture empty(DepthTriangles input) {
            var depths = new double[input.pixels()];
            Arrays.fill(depths, input.background());
            return new TrianglePicture(input.width(), new int[depths.length], depths);
        }
    }
}
