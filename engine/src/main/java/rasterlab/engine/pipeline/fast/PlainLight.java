package rasterlab.engine.pipeline.fast;

/** One place after the other, in loops so short that the compiler makes vectors of them. */
final class PlainLight implements LightLoops {
    @Override
    public void cosines(
            int n,
            float[] light,
            float[] x,
            float[] y,
            float[] z,
            float[] nx,
            float[] ny,
            float[] nz,
            float[] far,
            float[] along) {
        float lx = light[0];
        float ly = light[1];
        float lz = light[2];
        lengths(n, x, y, z, far);
        for (int i = 0; i < n; i++) along[i] = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i];
        for (int i = 0; i < n; i++) {
            float twice = 2 * (lx * x[i] + ly * y[i] + lz * z[i]);
            x[i] = far[i] * (ROOM * far[i] - twice);
        }
        for (int i = 0; i < n; i++) z[i] = nx[i] * lx + ny[i] * ly + nz[i] * lz;
        lengths(n, nx, ny, nz, y);
        for (int i = 0; i < n; i++) along[i] = aboveZero(z[i] * far[i] - along[i]);
        for (int i = 0; i < n; i++) far[i] = 1 / (x[i] * y[i]);
        for (int i = 0; i < n; i++) nx[i] = aboveZero(z[i] * (x[i] * far[i]));
        // 0 where no light falls, else 1 but for a sliver of angles: a step without a branch.
        for (int i = 0; i < n; i++) {
            float part = along[i] * far[i];
            ny[i] = part * part * x[i] * Math.min(1, nx[i] * LIT);
        }
    }

    private static void lengths(int n, float[] x, float[] y, float[] z, float[] out) {
        for (int i = 0; i < n; i++)
            out[i] = (float) Math.sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
    }

    /** max(0, v), exactly: Java's own, which heeds the sign of 0, is slower in lanes. */
    private static float aboveZero(float v) {
        return 0.5f * (v + Math.abs(v));
    }

    @Override
    public void channel(
            int n, float steady, float lit, float[] diffuse, float[] highlight, float[] out) {
        for (int i = 0; i < n; i++) out[i] = Math.min(1, steady + lit * diffuse[i] + highlight[i]);
    }
}
