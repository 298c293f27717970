package rasterlab.engine.visibility.hidden;

import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Which faces are right answers at a pixel: one, but where surfaces coincide, meet or end in it.
 *
 * <p>The picture is looked at in eight points round the centre, 2⁻¹⁶ to 2⁻¹⁵ pixel from it. A face
 * is right if it is the nearest in one of them, or if it reaches within that distance and is not
 * behind all that is nearest there. Nothing is right if one of the points shows nothing. Nearnesses
 * within a level, by default 2⁻⁴⁰ of the largest in the scene, are equal.
 */
public final class PixelAnswers {
    private static final double REACH = 0x1p-16;
    private static final double LEVEL = 0x1p-40;
    private static final int[] STEPS_X = {2, 1, -1, -2, -2, -1, 1, 2};
    private static final int[] STEPS_Y = {1, 2, 2, 1, -1, -2, -2, -1};

    private final int width;
    private final Outline[] outlines;
    private final double level;

    public PixelAnswers(ViewedMesh view) {
        this(view, 0);
    }

    /**
     * @param level nearnesses so close are equal too
     */
    PixelAnswers(ViewedMesh view, double level) {
        width = view.fit().width();
        var polygon = new ScreenPolygon(view);
        outlines =
                IntStream.range(0, view.mesh().faceCount())
                        .mapToObj(face -> new Outline(view, polygon, face))
                        .toArray(Outline[]::new);
        double size = 0;
        for (Outline outline : outlines) size = Math.max(size, outline.mostNearness);
        this.level = Math.max(level, LEVEL * size);
    }

    /** The pixels at which a picture has no right answer; faces have their numbers plus 1. */
    long wrong(Raster expected, Raster actual) {
        return IntStream.range(0, expected.argb().length)
                .filter(i -> expected.argb()[i] != actual.argb()[i])
                .filter(i -> !right(actual.argb()[i] - 1, i % width, i / width))
                .count();
    }

    /** Whether a pixel has more than one right answer. */
    boolean undecided(int x, int y) {
        long right =
                IntStream.range(-1, outlines.length)
                        .filter(face -> face < 0 || outlines[face].reaches(x, y))
                        .filter(face -> right(face, x, y))
                        .count();
        return right > 1;
    }

    /**
     * @param face −1 for nothing
     */
    public boolean right(int face, int x, int y) {
        double farthest = Double.POSITIVE_INFINITY;
        for (int k = 0; k < STEPS_X.length; k++) {
            double px = x + REACH * STEPS_X[k];
            double py = y + REACH * STEPS_Y[k];
            double nearest = nearest(px, py);
            if (face >= 0 && outlines[face].holds(px, py))
                if (outlines[face].nearness(px, py) >= nearest - level) return true;
            farthest = Math.min(farthest, nearest);
        }
        if (face < 0) return farthest == Double.NEGATIVE_INFINITY;
        return outlines[face].reaches(x, y) && outlines[face].mostAt(x, y) >= farthest - level;
    }

    private double nearest(double x, double y) {
        double nearest = Double.NEGATIVE_INFINITY;
        for (Outline outline : outlines)
            if (outline.holds(x, y)) nearest = Math.max(nearest, outline.nearness(x, y));
        return nearest;
    }

    /** One face on the picture. */
    private static final class Outline {
        final double mostNearness;
        private final double[] x;
        private final double[] y;
        private final NearnessPlane plane = new NearnessPlane();
        private final boolean edgeOn;

        /**
         * @param polygon of the view, to load the face into
         */
        Outline(ViewedMesh view, ScreenPolygon polygon, int face) {
            polygon.load(view, face);
            x = IntStream.range(0, polygon.size()).mapToDouble(polygon::x).toArray();
            y = IntStream.range(0, polygon.size()).mapToDouble(polygon::y).toArray();
            edgeOn = !plane.load(view, face);
            double[] corners = polygon.eyeCorners();
            double most = 0;
            for (int i = 2; i < corners.length; i += 3) {
                boolean central = view.transform().central();
                double z = corners[i];
                most = Math.max(most, Math.abs(central ? view.transform().distance() / z : z));
            }
            mostNearness = most;
        }

        double nearness(double px, double py) {
            return plane.base + py * plane.perRow + px * plane.perColumn;
        }

        /** The largest within reach of a pixel. */
        double mostAt(int px, int py) {
            if (edgeOn) return mostNearness;
            double slope = Math.abs(plane.perColumn) + Math.abs(plane.perRow);
            return nearness(px, py) + 2 * REACH * slope;
        }

        boolean holds(double px, double py) {
            boolean left = false;
            boolean right = false;
            for (int k = 0, p = x.length - 1; k < x.length; p = k++) {
                double side = (x[k] - x[p]) * (py - y[p]) - (y[k] - y[p]) * (px - x[p]);
                left |= side > 0;
                right |= side < 0;
            }
            return !edgeOn && left != right;
        }

        boolean reaches(double px, double py) {
            for (int k = 0, p = x.length - 1; k < x.length; p = k++)
                if (distance(p, k, px, py) <= 3 * REACH) return true;
            return holds(px, py);
        }

        private double distance(int p, int k, double px, double py) {
            double dx = x[k] - x[p];
            double dy = y[k] - y[p];
            double square = dx * dx + dy * dy;
            double along = square == 0 ? 0 : ((px - x[p]) * dx + (py - y[p]) * dy) / square;
            double t = Math.max(0, Math.min(1, along));
            return Math.hypot(px - x[p] - t * dx, py - y[p] - t * dy);
        }
    }
}
