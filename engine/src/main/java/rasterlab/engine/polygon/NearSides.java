package rasterlab.engine.polygon;

import java.util.Random;

/** Points that hardly any method judges rightly: as near to a polygon's edges as doubles allow. */
public final class NearSides {
    private NearSides() {}

    /**
     * {@code count} points, each a place on an edge rounded to doubles and then moved by up to
     * {@code ulps} of its own steps in x and y.
     */
    public static Points of(Points corners, int count, int ulps, Random random) {
        var x = new double[count];
        var y = new double[count];
        for (int i = 0; i < count; i++) {
            int from = random.nextInt(corners.size());
            int to = (from + 1) % corners.size();
            double mu = random.nextDouble();
            x[i] = moved((1 - mu) * corners.x(from) + mu * corners.x(to), ulps, random);
            y[i] = moved((1 - mu) * corners.y(from) + mu * corners.y(to), ulps, random);
        }
        return new Points(x, y);
    }

    private static double moved(double value, int ulps, Random random) {
        double moved = value;
        int steps = random.nextInt(2 * ulps + 1) - ulps;
        for (int i = 0; i < Math.abs(steps); i++)
            moved = steps > 0 ? Math.nextUp(moved) : Math.nextDown(moved);
        return moved;
    }
}
