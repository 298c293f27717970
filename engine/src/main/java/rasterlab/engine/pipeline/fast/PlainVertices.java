package rasterlab.engine.pipeline.fast;

/** One vertex after the other. */
final class PlainVertices implements VertexLoops {
    @Override
    public boolean allSeen(int n, float[] x, float[] y, float[] z, float[] w) {
        for (int i = 0; i < n; i++) if (ClipCode.of(x[i], y[i], z[i], w[i]) != 0) return false;
        return true;
    }

    @Override
    public void place(
            int n, float[] x, float[] y, float[] w, Subpixels subpixels, long[] places, int from) {
        for (int i = 0; i < n; i++) {
            double nearness = 1.0 / w[i];
            int pixelX = subpixels.x(x[i] * nearness);
            places[from + i] = ScreenVertices.place(pixelX, subpixels.y(y[i] * nearness));
        }
    }

    @Override
    public void depths(int n, float[] z, float[] w) {
        for (int i = 0; i < n; i++) {
            double nearness = 1.0 / w[i];
            z[i] = (float) (0.5 + 0.5 * (z[i] * nearness));
            w[i] = (float) nearness;
        }
    }
}
