package rasterlab.app.coordinates.meeting;

import rasterlab.app.coordinates.figure.StagePoint;
import rasterlab.engine.geometry.Line;
import rasterlab.engine.geometry.Plane;
import rasterlab.engine.geometry.Vector;

/**
 * A picture seen along the plane: to the right along it, up along its normal.
 *
 * <p>A point p has x = (p − p₁)·e / |p₂ − p₁| and y = (p − p₁)·n / (|n|·|p₂ − p₁|) + h, e being the
 * direction in the plane along which the line goes, and h the height of p₁ above the plane; 0 where
 * the plane is out of reach. So the plane is y = 0.
 *
 * @param origin p₁
 * @param right e, of length 1
 * @param up n / |n|
 * @param unit |p₂ − p₁|
 * @param height h, in units
 * @param reached whether the plane is near enough to be drawn
 */
record SideView(
        Vector origin, Vector right, Vector up, double unit, double height, boolean reached) {
    /** The distance from p₁, in units, beyond which nothing is drawn. */
    static final double FARTHEST = 12;

    /**
     * The length below which a direction counts as that of the normal, and any way along the plane
     * will do.
     */
    private static final double UPRIGHT = 1e-9;

    static SideView of(Plane plane, Line line) {
        Vector up = plane.normal().unit();
        Vector along = line.direction().unit();
        Vector flat = along.minus(up.times(up.dot(along)));
        Vector right = flat.length() < UPRIGHT ? sideways(up) : flat.unit();
        double unit = line.direction().length();
        double height = height(plane, line.from()) / unit;
        boolean reached = Math.abs(height) <= FARTHEST;
        return new SideView(line.from(), right, up, unit, reached ? height : 0, reached);
    }

    /** A direction at a right angle to {@code up}. */
    private static Vector sideways(Vector up) {
        Vector axis = Math.abs(up.x()) < 0.6 ? new Vector(1, 0, 0) : new Vector(0, 1, 0);
        return up.cross(axis).unit();
    }

    /** How far a point lies above the plane: f(p) / |n|. */
    static double height(Plane plane, Vector point) {
        return plane.normal().unit().dot(point) - plane.c() / plane.normal().length();
    }

    StagePoint spot(Vector point) {
        Vector away = point.minus(origin);
        return new StagePoint(away.dot(right) / unit, away.dot(up) / unit + height);
    }

    /** The point of the picture's own plane that is seen there. */
    Vector point(double x, double y) {
        return origin.plus(right.times(x * unit)).plus(up.times((y - height) * unit));
    }
}
