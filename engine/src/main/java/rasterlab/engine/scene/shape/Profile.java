package rasterlab.engine.scene.shape;

import java.util.Arrays;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.spline.function.CubicSpline;

/**
 * The radius of a {@link Revolution} by height: on piece i, with h = z − z[i], {@code r = c₀ + c₁·h
 * + c₂·h² + c₃·h³}.
 */
final class Profile {
    private final double[] z;
    private final double[] c;

    /**
     * @param radii above 0, or 0 at the ends; the spline too stays above 0 between the ends
     */
    Profile(double[] z, double[] radii, SplineEnds ends) {
        c = new CubicSpline().coefficients(z, radii, ends);
        this.z = z.clone();
        for (double height : z) Size.requireCoordinate("profile's z", height);
        Size.require("profile's height", top() - bottom());
        Size.require("profile's largest radius", Arrays.stream(radii).max().orElse(0));
        for (int i = 0; i < radii.length; i++) {
            boolean end = i == 0 || i == radii.length - 1;
            if (!(radii[i] >= (end ? 0 : SceneShape.SMALLEST)))
                throw new IllegalArgumentException(
                        "profile's radius %d must be %s, got %s"
                                .formatted(i, end ? "at least 0" : "above 0", radii[i]));
        }
        for (int i = 0; i < pieces(); i++) requireAbove0(i);
    }

    /** A cubic between values above 0 is lowest where its slope is 0. */
    private void requireAbove0(int piece) {
        double width = z[piece + 1] - z[piece];
        var slope = new Polynomial(2);
        double[] f = slope.start(2);
        f[0] = c(piece, 1) * width;
        f[1] = 2 * c(piece, 2) * width * width;
        f[2] = 3 * c(piece, 3) * width * width * width;
        int roots = slope.roots(0, 1);
        for (int k = 0; k < roots; k++) {
            double at = z[piece] + width * slope.root(k);
            boolean end = at == bottom() || at == top();
            if (!end && !(radius(piece, at) > 0))
                throw new IllegalArgumentException(
                        "profile's spline must stay above 0, at z = %s it is %s"
                                .formatted(at, radius(piece, at)));
        }
    }

    int pieces() {
        return z.length - 1;
    }

    double bottom() {
        return z[0];
    }

    double top() {
        return z[z.length - 1];
    }

    /** z where this piece begins and the one before ends. */
    double knot(int i) {
        return z[i];
    }

    /** The coefficient of h to the power {@code power}. */
    double c(int piece, int power) {
        return c[4 * piece + power];
    }

    /** The radius there, which rounding does not make negative. */
    double radius(double at) {
        return Math.max(0, radius(piece(at), at));
    }

    private double radius(int piece, double at) {
        double h = at - z[piece];
        return c(piece, 0) + h * (c(piece, 1) + h * (c(piece, 2) + h * c(piece, 3)));
    }

    /** The slope dr/dz. */
    double slope(double at) {
        int piece = piece(at);
        double h = at - z[piece];
        return c(piece, 1) + h * (2 * c(piece, 2) + h * 3 * c(piece, 3));
    }

    private int piece(double at) {
        int found = Arrays.binarySearch(z, at);
        int below = found >= 0 ? found : -found - 2;
        return Math.max(0, Math.min(below, pieces() - 1));
    }

    /** A distance from the origin that no point of the surface exceeds. */
    double reach() {
        double widest = 0;
        for (int i = 0; i < pieces(); i++) {
            double width = z[i + 1] - z[i];
            double most =
                    Math.abs(c(i, 0))
                            + width
                                    * (Math.abs(c(i, 1))
                                            + width
                                                    * (Math.abs(c(i, 2))
                                                            + width * Math.abs(c(i, 3))));
            widest = Math.max(widest, most);
        }
        return Math.hypot(widest, Math.max(Math.abs(bottom()), Math.abs(top())));
    }
}
