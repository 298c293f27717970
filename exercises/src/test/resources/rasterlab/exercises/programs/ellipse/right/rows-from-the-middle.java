import java.math.BigInteger;
import rasterlab.contract.EllipseRasterizer;
import rasterlab.contract.Pixels;

/** Whole numbers alone: of each row the pixels between its own column and the one of the next row. */
public class RowByRow implements EllipseRasterizer {
    @Override
    public void draw(int cx, int cy, int a, int b, Pixels out) {
        int[] byColumn = new int[a + 1];
        int row = b;
        for (int u = 0; u <= a; u++) {
            while (row > 0 && tooFar(u, row, a, b)) row--;
            byColumn[u] = row;
        }
        int column = a;
        for (int v = 0; v <= b; v++) {
            while (column > 0 && tooFar(v, column, b, a)) column--;
            for (int u = 0; u <= a; u++) if (u == column || byColumn[u] == v) send(cx, cy, u, v, out);
        }
    }

    private static void send(int cx, int cy, int u, int v, Pixels out) {
        for (int x = -u; x <= u; x += Math.max(1, 2 * u))
            for (int y = -v; y <= v; y += Math.max(1, 2 * v)) out.plot(cx + x, cy + y);
    }

    private static boolean tooFar(long u, long v, long a, long b) {
        BigInteger left = square((2 * v - 1) * a);
        BigInteger right = square(2 * b).multiply(BigInteger.valueOf((a - u) * (a + u)));
        return left.compareTo(right) >= 0;
    }

    private static BigInteger square(long n) {
        return BigInteger.valueOf(n).pow(2);
    }
}
