package rasterlab.engine.light;

/** Gives a face its intensity. Stateless, safe to use from several threads. */
@FunctionalInterface
public interface Shading {
    /** The share of a face's own colour that is seen, 0 to 1. */
    double intensity(FaceSide side);

    /**
     * Each channel times the intensity, rounded to the nearest level, a tie to the even one.
     *
     * @param rgb 0xRRGGBB
     * @param intensity cut to 0 to 1
     * @return opaque 0xFFRRGGBB
     */
    static int shade(int rgb, double intensity) {
        double share = Math.max(0, Math.min(1, intensity));
        int red = (int) Math.rint((rgb >> 16 & 255) * share);
        int green = (int) Math.rint((rgb >> 8 & 255) * share);
        int blue = (int) Math.rint((rgb & 255) * share);
        return 0xFF000000 | red << 16 | green << 8 | blue;
    }
}
