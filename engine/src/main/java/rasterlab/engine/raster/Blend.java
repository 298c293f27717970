package rasterlab.engine.raster;

/**
 * Colours laid over colours: 0xAARRGGBB, not multiplied by their alpha.
 *
 * <p>Source: T. Porter, T. Duff, Compositing digital images, Computer Graphics (SIGGRAPH) 18(3),
 * 1984, operator "over".
 */
public final class Blend {
    private Blend() {}

    /**
     * {@code above} over {@code below}: with α the upper alpha and β the lower one times 1 − α,
     * alpha = α + β and colour = (α·above + β·below)/alpha.
     *
     * @return each channel right to one level
     */
    public static int over(int above, int below) {
        if ((above & below) >>> 24 == 255) return above;
        double front = (above >>> 24) / 255.0;
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
