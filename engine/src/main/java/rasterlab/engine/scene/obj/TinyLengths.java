package rasterlab.engine.scene.obj;

/**
 * Brings lengths whose products would vanish near 1, by a power of two, which rounds nothing.
 *
 * <p>A face's area is a product of two lengths and its square one of four, and the smallest double
 * is 2⁻¹⁰⁷⁴; a unit of 2⁻²⁰⁰ leaves room for both and for slivers.
 */
final class TinyLengths {
    private static final double TINY = 0x1p-200;

    private TinyLengths() {}

    /**
     * The exponent to scale with.
     *
     * @param longest of the lengths, at least 0
     * @return 0 where the lengths are not tiny, or all 0
     */
    static int exponent(double longest) {
        return longest > 0 && longest < TINY ? -Math.getExponent(longest) : 0;
    }
}
