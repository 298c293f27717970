package rasterlab.engine.visibility.triangle;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.Arrays;
import java.util.Optional;
import rasterlab.contract.DepthTriangleFiller;

/**
 * The exact picture of triangles: areas in whole steps of the corners' grid, which no long
 * overflows, and depths of 40 digits at every pixel.
 */
final class ExactTriangles {
    private static final MathContext DIGITS = new MathContext(40);

    private final DepthTriangles input;

    ExactTriangles(DepthTriangles input) {
        this.input = input;
    }

    DepthTriangles.TrianglePicture picture() {
        DepthTriangles.TrianglePicture picture = DepthTriangles.TrianglePicture.empty(input);
        for (int at = 0; at < input.pixels(); at++) {
            BigDecimal nearest = new BigDecimal(input.background());
            for (int t = 0; t < input.triangles().size(); t++) {
                Optional<BigDecimal> depth = depth(t, at);
                if (depth.isEmpty() || depth.get().compareTo(nearest) >= 0) continue;
                nearest = depth.get();
                picture.shown()[at] = t + 1;
            }
            picture.depths()[at] = nearest.doubleValue();
        }
        return picture;
    }

    double background() {
        return input.background();
    }

    /** The depth of a triangle in a pixel that belongs to it. */
    Optional<BigDecimal> depth(int triangle, int at) {
        double[] corners = input.triangles().get(triangle);
        var x = new long[3];
        var y = new long[3];
        for (int i = 0; i < 3; i++) {
            x[i] = steps(corners[3 * i]) - steps(at % input.width());
            y[i] = steps(corners[3 * i + 1]) - steps(at / input.width());
        }
        var weights = new long[3];
        for (int i = 0; i < 3; i++) {
            int a = (i + 1) % 3;
            int b = (i + 2) % 3;
            weights[i] = x[a] * y[b] - x[b] * y[a];
        }
        long area = weights[0] + weights[1] + weights[2];
        if (area == 0) return Optional.empty();
        BigDecimal sum = BigDecimal.ZERO;
        for (int i = 0; i < 3; i++) {
            int side = Long.signum(weights[i]) * Long.signum(area);
            if (side < 0 || side == 0 && !owned(x, y, i, Long.signum(area)))
                return Optional.empty();
            BigDecimal weight = BigDecimal.valueOf(weights[i]);
            sum = sum.add(weight.multiply(new BigDecimal(corners[3 * i + 2])));
        }
        return Optional.of(sum.divide(BigDecimal.valueOf(area), DIGITS));
    }

    private static long steps(double place) {
        return (long) (place * DepthTriangleFiller.STEPS);
    }

    /** Centres on it belong to the right of an edge, and below a level one. */
    private static boolean owned(long[] x, long[] y, int corner, int turn) {
        int a = (corner + 1) % 3;
        int b = (corner + 2) % 3;
        long down = turn * (y[b] - y[a]);
        return down < 0 || down == 0 && turn * (x[b] - x[a]) > 0;
    }

    /** Whether the very same corners were drawn before, which decides a tie without rounding. */
    boolean again(int triangle) {
        return input.triangles().subList(0, triangle).stream()
                .anyMatch(one -> Arrays.equals(one, input.triangles().get(triangle)));
    }
}
