import java.util.Arrays;
import rasterlab.contract.PolygonClipper;
import rasterlab.contract.PolygonSink;

/** Cuts the polygon by the line of one side after the other. */
public class Model implements PolygonClipper {
    @Override
    public void clip(double[] window, double[] subject, PolygonSink out) {
        double[] sides = counterClockwise(window);
        double[] ring = counterClockwise(subject);
        for (int a = 0; a < sides.length; a += 2) {
            int b = (a + 2) % sides.length;
            ring = cut(ring, sides[a], sides[a + 1], sides[b], sides[b + 1]);
        }
        if (ring.length >= 6 && area(ring) > 1e-12 * area(sides)) out.polygon(ring);
    }

    private static double[] counterClockwise(double[] ring) {
        if (area(ring) >= 0) return ring;
        double[] turned = new double[ring.length];
        for (int i = 0; i < ring.length; i += 2) {
            turned[i] = ring[ring.length - 2 - i];
            turned[i + 1] = ring[ring.length - 1 - i];
        }
        return turned;
    }

    private static double area(double[] ring) {
        double twice = 0;
        for (int i = 2; i + 3 < ring.length; i += 2) {
            double ax = ring[i] - ring[0];
            double ay = ring[i + 1] - ring[1];
            twice += ax * (ring[i + 3] - ring[1]) - ay * (ring[i + 2] - ring[0]);
        }
        return twice / 2;
    }

    /** The part to the left of the line from a to b, or on it. */
    private static double[] cut(double[] ring, double ax, double ay, double bx, double by) {
        double[] left = new double[2 * ring.length];
        int size = 0;
        for (int p = 0; p < ring.length; p += 2) {
            int q = (p + 2) % ring.length;
            double d = (bx - ax) * (ring[p + 1] - ay) - (by - ay) * (ring[p] - ax);
            double e = (bx - ax) * (ring[q + 1] - ay) - (by - ay) * (ring[q] - ax);
            if (d >= 0) {
                left[size++] = ring[p];
                left[size++] = ring[p + 1];
            }
            if (d < 0 && e > 0 || d > 0 && e < 0) {
                double t = d / (d - e);
                left[size++] = ring[p] + t * (ring[q] - ring[p]);
                left[size++] = ring[p + 1] + t * (ring[q + 1] - ring[p + 1]);
            }
        }
        return Arrays.copyOf(left, size);
    }
}
