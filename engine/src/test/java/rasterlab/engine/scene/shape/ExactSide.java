package rasterlab.engine.scene.shape;

import java.math.BigDecimal;

/** Finds on which side of a surface a point of a ray lies, in decimals without rounding. */
final class ExactSide {
    private ExactSide() {}

    /** The sign of the shape's equation at o + t·d: negative inside. */
    static int of(SceneShape shape, double[] line, BigDecimal t) {
        BigDecimal x = coordinate(line, 0, t);
        BigDecimal y = coordinate(line, 1, t);
        BigDecimal z = coordinate(line, 2, t);
        BigDecimal flat = square(x).add(square(y));
        if (shape instanceof Sphere sphere)
            return flat.add(square(z)).compareTo(square(big(sphere.radius())));
        if (shape instanceof Cylinder tube) return flat.compareTo(square(big(tube.radius())));
        if (shape instanceof Torus torus) return torus(torus, flat, z);
        if (shape instanceof Revolution revolution)
            return flat.compareTo(square(radius(revolution.profile, z)));
        throw new IllegalArgumentException("no equation of " + shape);
    }

    private static int torus(Torus torus, BigDecimal flat, BigDecimal z) {
        BigDecimal major = square(big(torus.major()));
        BigDecimal sum = flat.add(square(z)).add(major).subtract(square(big(torus.minor())));
        return square(sum).compareTo(major.multiply(flat).multiply(big(4)));
    }

    private static BigDecimal radius(Profile profile, BigDecimal z) {
        int piece = 0;
        while (piece + 1 < profile.pieces() && z.compareTo(big(profile.knot(piece + 1))) > 0)
            piece++;
        BigDecimal h = z.subtract(big(profile.knot(piece)));
        BigDecimal radius = BigDecimal.ZERO;
        for (int power = 3; power >= 0; power--)
            radius = radius.multiply(h).add(big(profile.c(piece, power)));
        return radius;
    }

    private static BigDecimal coordinate(double[] line, int axis, BigDecimal t) {
        return big(line[axis]).add(t.multiply(big(line[axis + 3])));
    }

    private static BigDecimal square(BigDecimal x) {
        return x.multiply(x);
    }

    private static BigDecimal big(double x) {
        return new BigDecimal(x);
    }
}
