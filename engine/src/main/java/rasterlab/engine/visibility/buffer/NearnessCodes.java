package rasterlab.engine.visibility.buffer;

/** Nearness itself as a float, whatever the range: about 2⁻²⁴ of z is told apart everywhere. */
final class NearnessCodes implements DepthCodes {
    @Override
    public void row(double base, double perColumn, int from, int to, int[] codes) {
        for (int x = from; x < to; x++) {
            // Adding 0 makes −0 and 0 one.
            int bits = Float.floatToRawIntBits((float) (base + x * perColumn) + 0f);
            // Bits of negative floats run the other way; ~ lets the larger nearness be smaller.
            codes[x - from] = ~(bits ^ (bits >> 31 & Integer.MAX_VALUE));
        }
    }

    /** The nearness. */
    @Override
    public double depth(int code) {
        int turned = ~code;
        return Float.intBitsToFloat(turned ^ (turned >> 31 & Integer.MAX_VALUE));
    }

    @Override
    public boolean largerIsNearer() {
        return true;
    }
}
