package rasterlab.contract;

/**
 * Fills a triangle into a depth buffer: the z-buffer's inner loop.
 *
 * <p>Whole coordinates are pixel centres; x grows to the right, y down. A pixel belongs to the
 * triangle as to a polygon of {@link PolygonFiller}: a centre on a left or top edge does, on a
 * right or bottom edge it does not. A triangle without area has no pixels. Its corners may go round
 * either way, and may lie outside the picture.
 *
 * <p>Depths lie from 0, at the near plane, to 1, at the far one. They are those after the
 * perspective division and so linear on the screen: the depth of a pixel is that of the plane
 * through the three corners at its centre.
 *
 * <p>A pixel of the triangle is written where its depth is less than the one stored; of equal
 * depths the one stored stays.
 */
@FunctionalInterface
public interface DepthTriangleFiller {
    /** The largest magnitude of a column or row of a corner. */
    int LARGEST = 4096;

    /** Columns and rows of corners are multiples of 1 / this, so that edges are exact in double. */
    int STEPS = 256;

    /** The most columns, and rows, of a picture. */
    int LARGEST_SIDE = 256;

    /**
     * Writes the pixels of the triangle that are nearer than what is stored. Depths may be off by
     * 10⁻¹¹ of the range, or by what an exercise allows. Nothing may be refused.
     *
     * @param x columns of the three corners, multiples of 1/256 from −4096 to 4096
     * @param y rows of the corners, in the same range
     * @param z depths at the corners, 0 to 1
     * @param number of the triangle, from 1 on
     * @param width of the picture: its columns are 0 to width − 1, 1 to 256
     * @param height of the picture: its rows are 0 to height − 1, 1 to 256
     * @param depths stored so far, 0 to 1; that of pixel (x, y) is at y·width + x
     * @param shown number of the triangle seen in each pixel, in the same places; 0 where none is
     */
    void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown);
}
