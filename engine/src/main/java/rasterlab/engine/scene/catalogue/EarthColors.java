package rasterlab.engine.scene.catalogue;

/**
 * The colours of an earth that never was: land where a sum of waves is high, ice about the poles.
 *
 * <p>All waves go round a whole number of times, so there is no seam at longitude 0.
 */
final class EarthColors {
    private static final double SHORE = 0.35;
    private static final double DESERT = 0.55;
    private static final double ICE = 1.2;

    private EarthColors() {}

    /**
     * @param longitude 0 to 2π
     * @param latitude −π/2 to π/2
     */
    static int rgb(double longitude, double latitude) {
        double height = height(longitude, latitude);
        if (Math.abs(latitude) + 0.1 * Math.sin(4 * longitude) * Math.cos(latitude) > ICE)
            return 0xF2F6FA;
        if (height < SHORE) return mixed(0x123F7A, 0x3F8FC8, Math.max(0, (height + 1.5) / 1.85));
        double dryness = Math.cos(4 * latitude) * Math.min(1, 2 * (height - SHORE));
        return dryness > DESERT ? 0xD9B871 : mixed(0x3E8E41, 0x8A7A4A, (height - SHORE) / 1.3);
    }

    private static double height(double longitude, double latitude) {
        double wide = Math.sin(2 * longitude + 1.3 * Math.sin(3 * latitude) + 0.7);
        double middle = 0.6 * Math.sin(3 * longitude - 2 * latitude + 1.1);
        double small = 0.3 * Math.sin(7 * longitude + 5 * latitude) * Math.cos(6 * latitude);
        double tiny = 0.12 * Math.sin(17 * longitude - 11 * latitude);
        return (wide + middle + small + tiny) * Math.sqrt(Math.cos(latitude));
    }

    private static int mixed(int from, int to, double share) {
        double within = Math.min(1, share);
        int mixed = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
            int a = from >> shift & 255;
            int b = to >> shift & 255;
            mixed |= (int) Math.round(a + within * (b - a)) << shift;
        }
        return mixed;
    }
}
