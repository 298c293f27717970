package rasterlab.engine.visibility.buffer;

/**
 * (nearness − farthest)/(nearest − farthest) as a float: 1 on the near plane, 0 on the far plane,
 * where floats are densest as perspective crowds depths together. The code is minus its bits.
 */
final class ReversedCodes implements DepthCodes {
    private final double farthest;
    private final double scale;

    ReversedCodes(NearnessRange range) {
        farthest = range.farthest();
        scale = range.scale();
    }

    @Override
    public void row(double base, double perColumn, int from, int to, int[] codes) {
        for (int x = from; x < to; x++) {
            float reversed = (float) ((base + x * perColumn - farthest) * scale);
            codes[x - from] = -Float.floatToRawIntBits(Math.max(0f, Math.min(1f, reversed)));
        }
    }

    /** The depth of a code, from 1 on the near plane to 0 on the far one. */
    @Override
    public double depth(int code) {
        return Float.intBitsToFloat(-code);
    }

    @Override
    public boolean largerIsNearer() {
        return true;
    }
}
