package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.engine.light.UnitVector;

/** One point of a face, as the topic {@code shade} asks for it. */
final class FacePoint {
    private FacePoint() {}

    /**
     * @param place x, y, z of the point
     * @param normal there, of any length
     */
    static LitPoint of(LitFace face, double[] place, double[] normal) {
        double[] toLight = difference(face.lamp(), place);
        return new LitPoint(
                normal,
                toLight,
                difference(face.eye(), place),
                UnitVector.length(toLight),
                face.material(),
                face.light(),
                face.globalAmbient());
    }

    /** The mean of three vectors by weights. */
    static double[] mixed(double[] three, double a, double b, double c) {
        return new double[] {
            a * three[0] + b * three[3] + c * three[6],
            a * three[1] + b * three[4] + c * three[7],
            a * three[2] + b * three[5] + c * three[8]
        };
    }

    static double[] difference(double[] to, double[] from) {
        return new double[] {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    }

    /** Brings each of three vectors to length 1; (0, 0, 0) stays. */
    static double[] unit(double[] three) {
        var unit = new double[9];
        for (int i = 0; i < 9; i += 3) {
            double[] one = {three[i], three[i + 1], three[i + 2]};
            UnitVector.normalize(one);
            System.arraycopy(one, 0, unit, i, 3);
        }
        return unit;
    }

    /**
     * @throws IllegalArgumentException if three weights are no mean
     */
    static void requireWeights(double[] weights) {
        if (weights.length % 3 != 0)
            throw new IllegalArgumentException(
                    "weights must be 3 for each point, got " + weights.length + " in all");
        int wrong = firstNoMean(weights);
        if (wrong < 0) return;
        throw new IllegalArgumentException(
                "points[%d] must be weights of 0 or more with the sum 1, got (%s, %s, %s)"
                        .formatted(
                                wrong,
                                weights[3 * wrong],
                                weights[3 * wrong + 1],
                                weights[3 * wrong + 2]));
    }

    /** The number of the first point whose three weights are no mean; -1 where there is none. */
    private static int firstNoMean(double[] weights) {
        for (int i = 0; i + 2 < weights.length; i += 3) {
            double sum = weights[i] + weights[i + 1] + weights[i + 2];
            boolean mean = weights[i] >= 0 && weights[i + 1] >= 0 && weights[i + 2] >= 0;
            if (!mean || !(Math.abs(sum - 1) <= 1e-9)) return i / 3;
        }
        return -1;
    }
}
