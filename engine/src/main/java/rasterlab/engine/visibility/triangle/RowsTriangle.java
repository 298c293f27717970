package rasterlab.engine.visibility.triangle;

/**
 * Each row begins with the depth at its first pixel's centre and steps on by ∂z/∂x.
 *
 * <p>Source: E. Catmull, A subdivision algorithm for computer display of curved surfaces, 1974.
 */
final class RowsTriangle implements SteppedTriangle {
    @Override
    public RowsWalk walk(double[] x, double[] y, double[] z, int width, int height) {
        return new RowsWalk(x, y, z, width, height);
    }

    @Override
    public void fill(
            double[] x,
            double[] y,
            double[] z,
            int number,
            int width,
            int height,
            double[] depths,
            int[] shown) {
        RowsWalk walk = walk(x, y, z, width, height);
        while (walk.advance()) {
            int at = walk.y() * width + walk.x();
            if (!(walk.depth() < depths[at])) continue;
            depths[at] = walk.depth();
            shown[at] = number;
        }
    }
}
