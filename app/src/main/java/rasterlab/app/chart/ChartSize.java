package rasterlab.app.chart;

/**
 * How large a chart is laid out.
 *
 * @param width in units of which its type is 14 high
 * @param height in the same units
 * @param dots of the picture in each unit
 */
public record ChartSize(int width, int height, double dots) {
    /** The size of files. */
    public static final ChartSize USUAL = new ChartSize(ChartLook.WIDTH, ChartLook.HEIGHT, 1);

    /** A chart that is smaller, in its own type, is laid out so large and made smaller. */
    private static final int LEAST_WIDTH = 720;

    private static final int LEAST_HEIGHT = 480;

    /**
     * The size of a chart that fills a stage, in type as large as the window's.
     *
     * @param width of the stage in view units, at least 1
     * @param height of the stage in view units, at least 1
     * @param wanted size of the window's type, 1 for the usual one
     */
    public static ChartSize filling(int width, int height, double wanted) {
        return filling(width, height, wanted, LEAST_WIDTH, LEAST_HEIGHT);
    }

    /**
     * The size of a chart that fills a stage and needs more or less room.
     *
     * @param leastWidth smaller than which the chart is not laid out, in its own units
     * @param leastHeight the same of its height
     */
    public static ChartSize filling(
            int width, int height, double wanted, int leastWidth, int leastHeight) {
        double type =
                Math.min(
                        wanted,
                        Math.min(width / (double) leastWidth, height / (double) leastHeight));
        return new ChartSize(
                (int) Math.round(width / type), (int) Math.round(height / type), Math.max(1, type));
    }
}
