package rasterlab.engine.texture.filter;

/** When a footprint counts as a point, which shows the texel it lies in. */
final class Footprint {
    /** A footprint of less, in texels, has no area. */
    private static final double NO_AREA = 1e-12;

    private Footprint() {}

    static boolean isPoint(
            double dsdx, double dtdx, double dsdy, double dtdy, int width, int height) {
        double area = dsdx * width * (dtdy * height) - dtdx * height * (dsdy * width);
        return Math.abs(area) < NO_AREA;
    }
}
