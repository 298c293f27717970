package rasterlab.engine.light.face;

import java.math.BigDecimal;
import rasterlab.contract.LitFace;

/**
 * The side of a face's mixed normal on which its lamp is, on which the whole highlight hangs.
 *
 * <p>Where rounding could decide, the sign of n·l is found from the numbers given. With l the
 * unrounded way to the lamp, n·l is the sum of wₖ·(nₖ·l)/|nₖ| over the corners: three fractions of
 * roots, which are compared by their squares.
 */
final class LampSide {
    /** A computed n·l is off by less than this share of the largest numbers that went into it. */
    private static final double SURE = 1e-14;

    /** The number below which products have lost digits. */
    private static final double SMALLEST = 1e-280;

    private LampSide() {}

    /**
     * Whether n·l is above 0.
     *
     * @param weights three of each point, those of this one from {@code at} on
     * @param normal their mean of the corners' unit normals, rounded
     * @param toLamp from the point to the lamp, rounded
     */
    static boolean isLit(LitFace face, double[] weights, int at, double[] normal, double[] toLamp) {
        double product = 0;
        double size = 0;
        for (int c = 0; c < 3; c++) {
            product += normal[c] * toLamp[c];
            size += Math.abs(toLamp[c]);
        }
        for (double corner : face.corners()) size = Math.max(size, Math.abs(corner));
        if (Math.abs(product) > SURE * size + SMALLEST) return product > 0;
        return signum(face, weights, at) > 0;
    }

    private static int signum(LitFace face, double[] weights, int at) {
        var way = new BigDecimal[3];
        for (int c = 0; c < 3; c++) {
            way[c] = new BigDecimal(face.lamp()[c]);
            for (int k = 0; k < 3; k++)
                way[c] = way[c].subtract(product(weights[at + k], face.corners()[3 * k + c]));
        }
        var along = new BigDecimal[3];
        var square = new BigDecimal[3];
        for (int k = 0; k < 3; k++) {
            along[k] = BigDecimal.ZERO;
            square[k] = BigDecimal.ZERO;
            for (int c = 0; c < 3; c++) {
                double n = face.normals()[3 * k + c];
                along[k] = along[k].add(product(weights[at + k], n).multiply(way[c]));
                square[k] = square[k].add(product(n, n));
            }
            if (square[k].signum() == 0) square[k] = BigDecimal.ONE;
        }
        return RootSum.signum(
                along[0].multiply(square[1]).multiply(square[2]),
                along[1].multiply(square[2]),
                square[0].multiply(square[1]),
                along[2].multiply(square[1]),
                square[0].multiply(square[2]));
    }

    private static BigDecimal product(double a, double b) {
        return new BigDecimal(a).multiply(new BigDecimal(b));
    }
}
