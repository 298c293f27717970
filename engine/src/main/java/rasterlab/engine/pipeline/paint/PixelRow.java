package rasterlab.engine.pipeline.paint;

/**
 * The pixels of one face in one row while they go from stage to stage; each thread has its own.
 *
 * <p>Pixel i of the row is column {@code from + i} of the picture. It lies in the triangle of the
 * face's corners 0, {@code fan[i]} and {@code fan[i] + 1}, whose weights sum up to 1.
 */
final class PixelRow {
    final int[] fan;
    final double[] weight0;
    final double[] weight1;
    final double[] weight2;

    /** View z: the distance along the middle line of sight, in world units. */
    final double[] depth;

    /** The colours so far, 0xAARRGGBB. */
    final int[] argb;

    int size;

    PixelRow(int width) {
        fan = new int[width];
        weight0 = new double[width];
        weight1 = new double[width];
        weight2 = new double[width];
        depth = new double[width];
        argb = new int[width];
    }
}
