package rasterlab.engine.light.face;

import rasterlab.engine.raster.Raster;

/** Brightness along a line of a picture, and what the eye makes of it. */
public final class SeenBrightness {
    /** How much neighbours take from what a place of the eye reports. */
    private static final double INHIBITION = 1.2;

    private SeenBrightness() {}

    /**
     * The mean of red, green and blue, 0 to 1, at places evenly spread from one end to the other;
     * between pixel centres it is mixed from the four around.
     *
     * @param fromX column of one end, from 0 to the last one; whole numbers are pixel centres
     * @param samples at least 2
     */
    public static double[] along(
            Raster picture, double fromX, double fromY, double toX, double toY, int samples) {
        if (samples < 2)
            throw new IllegalArgumentException("samples must be at least 2, got " + samples);
        var brightness = new double[samples];
        for (int i = 0; i < samples; i++) {
            double share = i / (samples - 1.0);
            brightness[i] =
                    at(picture, fromX + share * (toX - fromX), fromY + share * (toY - fromY));
        }
        return brightness;
    }

    private static double at(Raster picture, double x, double y) {
        int column = (int) Math.floor(x);
        int row = (int) Math.floor(y);
        int right = Math.min(column + 1, picture.width() - 1);
        int below = Math.min(row + 1, picture.height() - 1);
        double toRight = x - column;
        double down = y - row;
        return (1 - down)
                        * ((1 - toRight) * mean(picture, column, row)
                                + toRight * mean(picture, right, row))
                + down
                        * ((1 - toRight) * mean(picture, column, below)
                                + toRight * mean(picture, right, below));
    }

    private static double mean(Raster picture, int x, int y) {
        int argb = picture.argb(x, y);
        return ((argb >> 16 & 255) + (argb >> 8 & 255) + (argb & 255)) / 765.0;
    }

    /**
     * The brightness that the eye reports: each place is held down by its neighbourhood, b + 1.2·(b
     * − mean), the mean over {@code reach} samples on each side; so it overshoots at steps and at
     * bends.
     *
     * <p>Source: E. Mach, 1865 (the report depends on the second derivative); F. Ratliff, Mach
     * Bands: Quantitative Studies on Neural Networks in the Retina, 1965 (lateral inhibition).
     *
     * @param reach samples on each side, at least 1
     */
    public static double[] reported(double[] brightness, int reach) {
        var reported = new double[brightness.length];
        for (int i = 0; i < reported.length; i++) {
            double sum = 0;
            for (int k = -reach; k <= reach; k++)
                sum += brightness[Math.max(0, Math.min(reported.length - 1, i + k))];
            double mean = sum / (2 * reach + 1);
            reported[i] = brightness[i] + INHIBITION * (brightness[i] - mean);
        }
        return reported;
    }
}
