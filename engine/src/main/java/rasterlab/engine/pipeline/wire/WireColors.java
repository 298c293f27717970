package rasterlab.engine.pipeline.wire;

/**
 * The colours of lines on a background.
 *
 * <p>Black or white, whichever has the higher contrast (L₁ + 0.05)/(L₂ + 0.05), which is then at
 * least 4.58, L being the relative luminance. Hidden parts are half way to the background.
 *
 * <p>Source: W3C, Web Content Accessibility Guidelines 2.1, 2018, "contrast ratio" and "relative
 * luminance".
 *
 * @param seen 0xFFRRGGBB
 * @param hidden 0xFFRRGGBB
 */
record WireColors(int seen, int hidden) {
    private static final double GLARE = 0.05;

    static WireColors on(int backgroundRgb) {
        double luminance =
                0.2126 * linear(backgroundRgb >> 16 & 255)
                        + 0.7152 * linear(backgroundRgb >> 8 & 255)
                        + 0.0722 * linear(backgroundRgb & 255);
        boolean dark = (luminance + GLARE) * (luminance + GLARE) < (1 + GLARE) * GLARE;
        int seen = dark ? 0xFFFFFFFF : 0xFF000000;
        int hidden = (seen >>> 1 & 0x7F7F7F) + (backgroundRgb >>> 1 & 0x7F7F7F);
        return new WireColors(seen, 0xFF000000 | hidden);
    }

    /** Light from a level of sRGB, 0 to 1. */
    private static double linear(int level) {
        double share = level / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
