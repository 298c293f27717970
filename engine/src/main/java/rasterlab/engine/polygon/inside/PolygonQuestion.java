package rasterlab.engine.polygon.inside;

import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/**
 * Whether a point near a corner is in the polygon: one of its edges rises to it, the other is
 * level, so that a ray from its left passes the corner and runs along that edge.
 */
final class PolygonQuestion implements PointQuestion<ShapeAndPoints, Membership> {
    /** Where the corner is: so many neighbours above the least x and y. */
    private static final double AT_X = Spacing.DOUBLE.above(HALF, 43);

    private static final double AT_Y = Spacing.DOUBLE.above(HALF, 64);
    private static final Points POLYGON =
            Points.of(-23.5, -35.5, 12.5, -35.5, 12.5, AT_Y, AT_X, AT_Y);

    @Override
    public double left(Spacing spacing) {
        return HALF;
    }

    @Override
    public double low(Spacing spacing) {
        return HALF;
    }

    @Override
    public ShapeAndPoints input(Spacing spacing, double x, double y) {
        return new ShapeAndPoints(POLYGON, Points.of(x, y));
    }

    @Override
    public boolean yes(Membership output) {
        return output.inside(0);
    }
}
