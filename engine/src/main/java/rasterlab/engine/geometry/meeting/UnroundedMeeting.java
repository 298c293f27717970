package rasterlab.engine.geometry.meeting;

import rasterlab.contract.LinePlane;
import rasterlab.engine.geometry.Expansion;
import rasterlab.engine.range.Finite;

/**
 * The formula with both sums kept without error: μ = (c − n·p₁) / (n·p₂ − n·p₁), or μ = (n·a −
 * n·p₁) / (n·p₂ − n·p₁) where a point a of the plane is known.
 *
 * <p>Only the two sums and their quotient are rounded, so μ is off by at most 4·2⁻⁵³ of itself and
 * n·p* is 0 exactly where the line is parallel. Where rounding would take μ across 0 or 1, it stays
 * on its side: whether the point is behind p₁, between or beyond p₂ is told without error. All
 * coordinates of one kind are multiplied by one power of two, which leaves μ as it is; those not 0
 * have to be within 2⁴⁰⁰ of the largest, so that every product's error is a double.
 *
 * <p>Source: exact sums after J. R. Shewchuk, Adaptive precision floating-point arithmetic and fast
 * robust geometric predicates, Discrete & Computational Geometry 18, 1997, pp. 305–363.
 */
final class UnroundedMeeting implements LinePlane {
    private static final double SMALLEST_PART = 0x1p-400;
    private static final double SMALLEST_C = 0x1p-900;
    private static final double LARGEST_C = 0x1p900;

    /** A distance greater than the error of μ where it is about 1. */
    private static final double NEAR_1 = 0x1p-50;

    @Override
    public double meetsThrough(double[] normal, double[] point, double[] from, double[] through) {
        Finite.require("normal coordinate", normal);
        Finite.require("point coordinate", point);
        requireFinite(from, through);
        double[] n = near1(normal, -Math.getExponent(largest(normal)));
        double size = Math.max(largest(point), Math.max(largest(from), largest(through)));
        int by = -Math.getExponent(size);
        double[] inPlane = near1(point, by);
        double[] start = near1(from, by);
        var rise = new Expansion(12);
        for (int axis = 0; axis < 3; axis++) {
            rise.addProduct(n[axis], inPlane[axis]);
            rise.addProduct(-n[axis], start[axis]);
        }
        return mu(rise, slope(n, start, near1(through, by)));
    }

    @Override
    public double meets(double[] normal, double c, double[] from, double[] through) {
        Finite.require("normal coordinate", normal);
        Finite.require("c", c);
        requireFinite(from, through);
        int byNormal = -Math.getExponent(largest(normal));
        int byPoint = -Math.getExponent(Math.max(largest(from), largest(through)));
        double scaledC = Math.scalb(c, byNormal + byPoint);
        double size = Math.abs(scaledC);
        if (c != 0 && !(size >= SMALLEST_C && size <= LARGEST_C))
            throw new IllegalArgumentException(
                    "c must be 0 or within 2⁹⁰⁰ of the largest n·p, got " + c);
        double[] n = near1(normal, byNormal);
        double[] start = near1(from, byPoint);
        var rise = new Expansion(7);
        rise.add(scaledC);
        for (int axis = 0; axis < 3; axis++) rise.addProduct(-n[axis], start[axis]);
        return mu(rise, slope(n, start, near1(through, byPoint)));
    }

    private static void requireFinite(double[] from, double[] through) {
        Finite.require("point coordinate", from);
        Finite.require("point coordinate", through);
    }

    /** n·p₂ − n·p₁. */
    private static Expansion slope(double[] n, double[] start, double[] end) {
        var slope = new Expansion(12);
        for (int axis = 0; axis < 3; axis++) {
            slope.addProduct(n[axis], end[axis]);
            slope.addProduct(-n[axis], start[axis]);
        }
        return slope;
    }

    private static double mu(Expansion rise, Expansion slope) {
        if (slope.sign() == 0)
            throw new IllegalArgumentException(
                    "line must not be parallel to the plane, but n·p* is 0");
        double mu = rise.value() / slope.value();
        Finite.require("μ", mu);
        int side = rise.sign() * slope.sign();
        if (side < 0) return Math.min(mu, -Double.MIN_VALUE);
        if (side == 0 || Math.abs(mu - 1) > NEAR_1) return mu;
        var beyond = new Expansion(24);
        beyond.subtract(slope);
        beyond.add(rise);
        return beyond.sign() * slope.sign() > 0 ? Math.max(mu, Math.nextUp(1.0)) : Math.min(mu, 1);
    }

    private static double largest(double[] xyz) {
        return Math.max(Math.abs(xyz[0]), Math.max(Math.abs(xyz[1]), Math.abs(xyz[2])));
    }

    private static double[] near1(double[] xyz, int by) {
        var scaled = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            scaled[axis] = Math.scalb(xyz[axis], by);
            if (xyz[axis] != 0 && Math.abs(scaled[axis]) < SMALLEST_PART)
                throw new IllegalArgumentException(
                        "coordinates must be 0 or within 2⁴⁰⁰ of the largest, got " + xyz[axis]);
        }
        return scaled;
    }
}
