package rasterlab.tests.bench;

import java.awt.geom.Line2D;

/** The least number of chords with their ends on a cubic, by trying all ends on a fine grid. */
final class LeastChords {
    private static final int GRID = 6000;

    private LeastChords() {}

    /**
     * Goes from each end to the farthest one that the flatness allows, which no other choice beats.
     */
    static int of(double[] x, double[] y, double flatness) {
        double[] px = sampled(x);
        double[] py = sampled(y);
        int chords = 0;
        int from = 0;
        while (from < GRID) {
            int near = from + 1;
            int step = 1;
            while (near + step <= GRID && isFlat(px, py, from, near + step, flatness)) {
                near += step;
                step *= 2;
            }
            for (; step > 0; step /= 2)
                if (near + step <= GRID && isFlat(px, py, from, near + step, flatness))
                    near += step;
            from = near;
            chords++;
        }
        return chords;
    }

    private static double[] sampled(double[] p) {
        var samples = new double[GRID + 1];
        for (int i = 0; i <= GRID; i++) {
            double t = (double) i / GRID;
            double s = 1 - t;
            samples[i] =
                    s * s * s * p[0]
                            + 3 * s * s * t * p[1]
                            + 3 * s * t * t * p[2]
                            + t * t * t * p[3];
        }
        return samples;
    }

    private static boolean isFlat(double[] x, double[] y, int from, int to, double flatness) {
        for (int i = from + 1; i < to; i++)
            if (Line2D.ptSegDist(x[from], y[from], x[to], y[to], x[i], y[i]) > flatness)
                return false;
        return true;
    }
}
