package rasterlab.engine.light.face;

import java.math.BigDecimal;
import java.math.MathContext;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.shade.ExactShade;
import rasterlab.engine.transform.exact.BigTrig;

/** The formula at each point, everything before it in decimals of 60 digits. */
final class ExactFace {
    private static final MathContext DIGITS = BigTrig.DIGITS;

    private ExactFace() {}

    static double[] shade(FacePoints points) {
        LitFace face = points.face();
        double[] weights = points.weights();
        var shades = new double[weights.length];
        BigDecimal[] normals = unit(face.normals());
        BigDecimal[] corners = big(face.corners());
        for (int i = 0; i < weights.length; i += 3) {
            BigDecimal[] place = mixed(corners, weights, i);
            double[] normal = doubles(mixed(normals, weights, i));
            BigDecimal[] toLight = from(place, face.lamp());
            BigDecimal distance = length(toLight, 0);
            var point =
                    new LitPoint(
                            normal,
                            doubles(toLight),
                            doubles(from(place, face.eye())),
                            distance.doubleValue(),
                            face.material(),
                            face.light(),
                            face.globalAmbient());
            boolean lit = ExactSide.signum(face.normals(), weights, i, toLight) > 0;
            double[] shade = ExactShade.intensity(point, Reflection.PHONG, lit);
            System.arraycopy(shade, 0, shades, i, 3);
        }
        return shades;
    }

    private static BigDecimal[] unit(double[] three) {
        BigDecimal[] unit = big(three);
        for (int k = 0; k < 9; k += 3) {
            BigDecimal length = length(unit, k);
            if (length.signum() == 0) continue;
            for (int c = k; c < k + 3; c++) unit[c] = unit[c].divide(length, DIGITS);
        }
        return unit;
    }

    private static BigDecimal length(BigDecimal[] v, int at) {
        return v[at].pow(2).add(v[at + 1].pow(2)).add(v[at + 2].pow(2)).sqrt(DIGITS);
    }

    private static BigDecimal[] mixed(BigDecimal[] three, double[] weights, int at) {
        var mixed = new BigDecimal[3];
        for (int c = 0; c < 3; c++) {
            mixed[c] = BigDecimal.ZERO;
            for (int k = 0; k < 3; k++)
                mixed[c] = mixed[c].add(three[3 * k + c].multiply(new BigDecimal(weights[at + k])));
        }
        return mixed;
    }

    private static BigDecimal[] from(BigDecimal[] place, double[] to) {
        BigDecimal[] difference = big(to);
        for (int c = 0; c < 3; c++) difference[c] = difference[c].subtract(place[c]);
        return difference;
    }

    private static BigDecimal[] big(double[] values) {
        var big = new BigDecimal[values.length];
        for (int i = 0; i < big.length; i++) big[i] = new BigDecimal(values[i]);
        return big;
    }

    private static double[] doubles(BigDecimal[] values) {
        return new double[] {
            values[0].doubleValue(), values[1].doubleValue(), values[2].doubleValue()
        };
    }
}
