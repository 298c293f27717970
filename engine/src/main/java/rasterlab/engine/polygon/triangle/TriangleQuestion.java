package rasterlab.engine.polygon.triangle;

import rasterlab.engine.polygon.Membership;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.ShapeAndPoints;
import rasterlab.engine.predicate.PointQuestion;
import rasterlab.engine.predicate.Spacing;

/**
 * Whether a point near a side is in the triangle; the side lies on 3(x − ½) = 2(y − ½), on which
 * rounded products do not cancel as they would on y = x.
 */
final class TriangleQuestion implements PointQuestion<ShapeAndPoints, Membership> {
    private static final Points TRIANGLE = Points.of(-23.5, -35.5, 12.5, -35.5, 12.5, 18.5);

    /** A triangle in whole numbers whose cross products are beyond an int. */
    private static final Points LARGE = TRIANGLE.scaled(4096);

    /** The point at half, in the large triangle. */
    private static final double WHOLE = 4096 * HALF;

    @Override
    public double left(Spacing spacing) {
        return spacing == Spacing.WHOLE ? WHOLE : HALF;
    }

    @Override
    public double low(Spacing spacing) {
        return left(spacing);
    }

    @Override
    public Spacing spacing(String method) {
        return switch (method) {
            case "sign-int" -> Spacing.WHOLE;
            case "sign-float" -> Spacing.FLOAT;
            default -> Spacing.DOUBLE;
        };
    }

    @Override
    public ShapeAndPoints input(Spacing spacing, double x, double y) {
        return new ShapeAndPoints(spacing == Spacing.WHOLE ? LARGE : TRIANGLE, Points.of(x, y));
    }

    @Override
    public boolean yes(Membership output) {
        return output.inside(0);
    }
}
