package rasterlab.engine.polygon.inside;

import rasterlab.engine.range.Finite;

/**
 * One way round a polygon, edge by edge, for one point.
 *
 * <p>A new walk stands before the first edge, which joins corner 0 to corner 1. {@link #count} is
 * what the edges so far add up to; the method says which counts mean inside.
 */
public abstract class EdgeWalk {
    final double[] polygonX;
    final double[] polygonY;
    final double x;
    final double y;
    private int edge = -1;
    private int count;

    /**
     * @throws IllegalArgumentException if there are fewer than 3 corners, or a coordinate is NaN or
     *     infinite
     */
    EdgeWalk(double[] polygonX, double[] polygonY, double x, double y) {
        Finite.requirePoints("corner", polygonX, polygonY, 3);
        Finite.require("point coordinate", x, y);
        this.polygonX = polygonX;
        this.polygonY = polygonY;
        this.x = x;
        this.y = y;
    }

    /** Looks at the next edge; false when there is none, or the answer is settled. */
    public final boolean advance() {
        if (edge + 1 == polygonX.length || settled()) return false;
        edge++;
        int to = edge + 1 == polygonX.length ? 0 : edge + 1;
        count += crossing(polygonX[edge], polygonY[edge], polygonX[to], polygonY[to]);
        return true;
    }

    /** The change of the count by the edge from (fromX, fromY) to (toX, toY). */
    abstract int crossing(double fromX, double fromY, double toX, double toY);

    /** Whether the answer is known before the last edge. */
    boolean settled() {
        return false;
    }

    /** The answer, once {@link #advance} has returned false. */
    public abstract boolean inside();

    /** Number of the edge looked at last, 0 being the first. */
    public final int edge() {
        return edge;
    }

    public final int count() {
        return count;
    }
}
