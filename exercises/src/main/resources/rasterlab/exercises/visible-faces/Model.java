import java.math.BigDecimal;
import rasterlab.contract.VisibleFaces;

/** Asks for each face on which side of its plane the eye is: n·(eye − c₀) > 0. */
public class Model implements VisibleFaces {
    @Override
    public boolean[] visible(double[] xyz, int[][] faces, double[] eye, double[] inside) {
        double unit = 0;
        for (double value : xyz) unit = Math.max(unit, Math.abs(value));
        for (double value : eye) unit = Math.max(unit, Math.abs(value));
        double scale = unit == 0 ? 1 : Math.scalb(1.0, -Math.getExponent(unit));
        boolean[] visible = new boolean[faces.length];
        for (int f = 0; f < visible.length; f++) visible[f] = side(xyz, faces[f], eye, scale) > 0;
        return visible;
    }

    /** The sign of n·(eye − c₀) for coordinates times a power of 2, which changes no sign. */
    private static int side(double[] xyz, int[] face, double[] eye, double scale) {
        double[] e = way(xyz, face[0], eye, 0, scale);
        double sum = 0;
        double size = 0;
        for (int k = 1; k + 1 < face.length; k++) {
            double[] a = way(xyz, face[0], xyz, face[k], scale);
            double[] b = way(xyz, face[0], xyz, face[k + 1], scale);
            for (int i = 0; i < 3; i++) {
                double one = a[(i + 1) % 3] * b[(i + 2) % 3];
                double other = a[(i + 2) % 3] * b[(i + 1) % 3];
                sum += e[i] * (one - other);
                size += Math.abs(e[i]) * (Math.abs(one) + Math.abs(other));
            }
        }
        // a sum that rounding may have turned is computed once more, without rounding
        return Math.abs(sum) > 1e-12 * size ? (int) Math.signum(sum) : exactSide(xyz, face, eye);
    }

    private static double[] way(double[] xyz, int from, double[] to, int at, double scale) {
        double[] way = new double[3];
        for (int i = 0; i < 3; i++) way[i] = to[3 * at + i] * scale - xyz[3 * from + i] * scale;
        return way;
    }

    private static int exactSide(double[] xyz, int[] face, double[] eye) {
        BigDecimal[] e = exactWay(xyz, face[0], eye, 0);
        BigDecimal sum = BigDecimal.ZERO;
        for (int k = 1; k + 1 < face.length; k++) {
            BigDecimal[] a = exactWay(xyz, face[0], xyz, face[k]);
            BigDecimal[] b = exactWay(xyz, face[0], xyz, face[k + 1]);
            for (int i = 0; i < 3; i++) {
                BigDecimal one = a[(i + 1) % 3].multiply(b[(i + 2) % 3]);
                BigDecimal other = a[(i + 2) % 3].multiply(b[(i + 1) % 3]);
                sum = sum.add(e[i].multiply(one.subtract(other)));
            }
        }
        return sum.signum();
    }

    private static BigDecimal[] exactWay(double[] xyz, int from, double[] to, int at) {
        BigDecimal[] way = new BigDecimal[3];
        for (int i = 0; i < 3; i++)
            way[i] = new BigDecimal(to[3 * at + i]).subtract(new BigDecimal(xyz[3 * from + i]));
        return way;
    }
}
