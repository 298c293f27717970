package rasterlab.engine.light.shade;

import java.util.List;
import rasterlab.contract.LitPoint;

/**
 * Points to shade one after the other.
 *
 * @param points at least one
 */
public record LitPoints(List<LitPoint> points) {
    public LitPoints {
        points = List.copyOf(points);
        if (points.isEmpty()) throw new IllegalArgumentException("needs at least one point");
    }

    /** The first {@code limit} ones. */
    List<LitPoint> first(int limit) {
        return points.subList(0, Math.min(limit, points.size()));
    }
}
