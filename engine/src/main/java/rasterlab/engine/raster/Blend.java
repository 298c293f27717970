package rasterlab.engine.raster;

/**
 * Colours laid over colours: 0xAARRGGBB, not multiplied by their alpha.
 *
 * <p>Source: T. Porter, T. Duff, Compositing digital images, Computer Graphics (SIGGRAPH) 18(3),
 * 1984, operator "over".
 */
public final class Blend {
    /** The coverage of a pixel wholly covered. */
    public static final int WHOLE = 256;

    private Blend() {}

    /**
     * {@code above} over {@code below}, of which it covers a share.
     *
     * @param coverage 0 to {@value #WHOLE}, the share in 256ths
     * @return each channel right to one level
     */
    public static int over(int above, int below, int coverage) {
        return (above & below) >>> 24 == 255
                ? mix(above, below, coverage)
                : overAlpha(above, below, coverage);
    }

    /**
     * Two opaque colours: below + (above − below)·coverage/256, rounded, two channels at a time.
     */
    private static int mix(int above, int below, int coverage) {
        int rest = WHOLE - coverage;
        int redBlue = (above & 0xFF00FF) * coverage + (below & 0xFF00FF) * rest + 0x800080;
        int green = (above & 0xFF00) * coverage + (below & 0xFF00) * rest + 0x8000;
        return 0xFF000000 | redBlue >>> 8 & 0xFF00FF | green >>> 8 & 0xFF00;
    }

    /** alpha = αₐ + α_b·(1 − αₐ); colour = (αₐ·a + α_b·(1 − αₐ)·b)/alpha, αₐ being covered. */
    private static int overAlpha(int above, int below, int coverage) {
        double front = (above >>> 24) * coverage / (255.0 * WHOLE);
        double back = (below >>> 24) / 255.0 * (1 - front);
        double alpha = front + back;
        if (alpha == 0) return 0;
        return (int) Math.round(255 * alpha) << 24
                | channel(above, below, 16, front, back) << 16
                | channel(above, below, 8, front, back) << 8
                | channel(above, below, 0, front, back);
    }

    private static int channel(int above, int below, int shift, double front, double back) {
        double mixed = front * (above >>> shift & 0xFF) + back * (below >>> shift & 0xFF);
        return (int) Math.round(mixed / (front + back));
    }
}
