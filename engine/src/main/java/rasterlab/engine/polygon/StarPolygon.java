package rasterlab.engine.polygon;

import java.util.Random;

/** Polygons without crossings that have corners of every kind. */
public final class StarPolygon {
    private StarPolygon() {}

    /**
     * A counter-clockwise polygon round the origin, its corners at equal angles and random
     * distances between a fifth of {@code radius} and all of it; so every ray from the origin meets
     * it once.
     *
     * @param corners at least 3
     */
    public static Points of(int corners, double radius, Random random) {
        var x = new double[corners];
        var y = new double[corners];
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * i / corners;
            double distance = radius * (0.2 + 0.8 * random.nextDouble());
            x[i] = distance * StrictMath.cos(angle);
            y[i] = distance * StrictMath.sin(angle);
        }
        return new Points(x, y);
    }
}
