package rasterlab.engine.line;

import java.util.Map;
import rasterlab.contract.LineRasterizer;
import rasterlab.engine.range.Bounds;

/**
 * How much light a line gets for its length: the requirement of even brightness, measured.
 *
 * <p>A line of n + 1 full pixels at the angle α to its longer axis has the length (n + 1)/cos α, so
 * its brightness falls from 1 at 0° to 0.707 at 45°.
 *
 * @param light levels of all pixels, {@value CoverageLine#FULL} for a full one
 * @param length in the same unit: {@value CoverageLine#FULL} for a pixel
 * @param degrees between the line and its longer axis, 0 to 45
 */
public record LineBrightness(long light, long length, double degrees) {
    private static final int BAND = 15;

    /** Begins the names of the counts. */
    static final String LEVELS = "levels of ";

    public LineBrightness {
        Bounds.require("degrees", degrees, 0, 45);
    }

    /**
     * @throws IllegalArgumentException when the method refuses the segment
     */
    public static LineBrightness of(LineRasterizer method, Segment s) {
        long[] light = {0};
        if (method instanceof CoverageLine shaded)
            shaded.shade(s.x0(), s.y0(), s.x1(), s.y1(), (x, y, coverage) -> light[0] += coverage);
        else method.draw(s.x0(), s.y0(), s.x1(), s.y1(), (x, y) -> light[0] += CoverageLine.FULL);
        long n = s.steps();
        double dx = Math.abs((double) s.x1() - s.x0());
        double dy = Math.abs((double) s.y1() - s.y0());
        double stretch = n == 0 ? 1 : Math.hypot(dx, dy) / n;
        return new LineBrightness(
                light[0],
                Math.round(CoverageLine.FULL * (n + 1) * stretch),
                Math.toDegrees(Math.atan2(Math.min(dx, dy), Math.max(dx, dy))));
    }

    /** Light for a pixel of length; 1 for a row of full pixels. */
    public double perPixel() {
        return (double) light / length;
    }

    void addTo(Map<String, Long> counts) {
        int from = Math.min((int) (degrees / BAND), 2) * BAND;
        String band = " at " + from + "–" + (from + BAND) + "°";
        counts.merge(LEVELS + "light" + band, light, Long::sum);
        counts.merge(LEVELS + "length" + band, length, Long::sum);
    }
}
