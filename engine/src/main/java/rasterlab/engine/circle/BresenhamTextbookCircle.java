package rasterlab.engine.circle;

import rasterlab.contract.Pixels;
import rasterlab.engine.raster.Work;

/**
 * A circle by the nearest of three pixels as the text describes it, with the faults of doing just
 * that in ints.
 *
 * <p>The distances |√(u² + v²) − r| of the pixels to the side, diagonally and below are compared.
 * From r = 46,341 on u² + v² does not fit into 32 bits: its root is that of another number or none,
 * no comparison holds and the walk falls straight down. Each pixel of the octant is mirrored eight
 * times whether its images differ or not, so those on axes and diagonals are sent twice, and the
 * one pixel of a circle without radius eight times.
 *
 * <p>Source: article "Coordinate systems: world, object, observer and screen", section on circles
 * and ellipses, fig. 7.
 */
public final class BresenhamTextbookCircle implements SteppedCircle {
    @Override
    public void draw(int centerX, int centerY, int radius, Pixels out) {
        Mirror.about(centerX, centerY, radius, radius, out);
        var walk = new Walk(radius);
        while (walk.advance()) eight(centerX, centerY, walk.u, walk.v, out);
    }

    private static void eight(int centerX, int centerY, int u, int v, Pixels out) {
        for (int signU = -1; signU <= 1; signU += 2)
            for (int signV = -1; signV <= 1; signV += 2) {
                out.plot(centerX + signU * u, centerY + signV * v);
                out.plot(centerX + signU * v, centerY + signV * u);
            }
    }

    @Override
    public ArcWalk walk(int radius) {
        return new Walk(radius);
    }

    @Override
    public String decisionFormula() {
        return "|√(u² + v²) − r| of the pixel, the smallest of three; its squares in 32 bits";
    }

    @Override
    public ArcWork work() {
        return new ArcWork(new Work(8, 6, 0, 0, 3), 3, Work.NONE, Work.NONE);
    }

    private static final class Walk implements ArcWalk {
        private final int radius;
        private int u;
        private int v;
        private boolean begun;

        Walk(int radius) {
            this.radius = radius;
            v = radius;
        }

        @Override
        public boolean advance() {
            if (!begun) {
                begun = true;
                return true;
            }
            if (u >= v) return false;
            choose();
            return u <= v;
        }

        private void choose() {
            double side = distance(u + 1, v);
            double diagonal = distance(u + 1, v - 1);
            double below = distance(u, v - 1);
            if (side <= diagonal && side <= below) {
                u++;
            } else if (diagonal <= below) {
                u++;
                v--;
            } else {
                v--;
            }
        }

        private double distance(int u, int v) {
            return Math.abs(Math.sqrt(u * u + v * v) - radius);
        }

        @Override
        public int u() {
            return u;
        }

        @Override
        public int v() {
            return v;
        }

        @Override
        public double decision() {
            return distance(u, v);
        }
    }
}
