import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;

/** A tree of half-spaces: the far side of a plane, what lies in it, the near side. */
public class Model implements DepthOrder {
    /** The tolerance as a share of the largest coordinate, which is about 1 here. */
    private static final double ON_THE_PLANE = 1e-13;

    /** A polygon or a piece of one, in units in which the largest coordinate is about 1. */
    private record Piece(int polygon, double[] xyz) {}

    @Override
    public void order(double[][] polygons, double[] eye, PieceSink out) {
        double largest = 0;
        for (double value : eye) largest = Math.max(largest, Math.abs(value));
        for (double[] one : polygons)
            for (double value : one) largest = Math.max(largest, Math.abs(value));
        int exponent = Math.getExponent(largest);
        List<Piece> all = new ArrayList<>();
        for (int k = 0; k < polygons.length; k++)
            all.add(new Piece(k, scaled(polygons[k], -exponent)));
        paint(
                all,
                scaled(eye, -exponent),
                (k, xyz) -> out.piece(k, scaled(xyz, exponent)));
    }

    private static double[] scaled(double[] values, int exponent) {
        double[] scaled = new double[values.length];
        for (int i = 0; i < scaled.length; i++) scaled[i] = Math.scalb(values[i], exponent);
        return scaled;
    }

    private void paint(List<Piece> pieces, double[] eye, PieceSink out) {
        if (pieces.isEmpty()) return;
        double[] plane = plane(pieces.get(0).xyz);
        List<Piece> before = new ArrayList<>();
        List<Piece> on = new ArrayList<>();
        List<Piece> behind = new ArrayList<>();
        on.add(pieces.get(0));
        for (Piece piece : pieces.subList(1, pieces.size())) {
            double[] front = part(piece.xyz, plane, 1);
            double[] back = part(piece.xyz, plane, -1);
            if (front.length == 0 && back.length == 0) on.add(piece);
            if (front.length > 0) before.add(new Piece(piece.polygon, front));
            if (back.length > 0) behind.add(new Piece(piece.polygon, back));
        }
        boolean eyeBefore = side(eye, 0, plane) > 0;
        paint(eyeBefore ? behind : before, eye, out);
        for (Piece piece : on) out.piece(piece.polygon, piece.xyz);
        paint(eyeBefore ? before : behind, eye, out);
    }

    /** The unit normal and the distance from the origin. */
    private static double[] plane(double[] p) {
        double[] n = new double[4];
        for (int k = 3; k + 5 < p.length; k += 3)
            for (int i = 0; i < 3; i++) {
                int j = (i + 1) % 3;
                int l = (i + 2) % 3;
                n[i] += (p[k + j] - p[j]) * (p[k + 3 + l] - p[l]);
                n[i] -= (p[k + l] - p[l]) * (p[k + 3 + j] - p[j]);
            }
        double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        for (int i = 0; i < 3; i++) n[i] /= length;
        n[3] = n[0] * p[0] + n[1] * p[1] + n[2] * p[2];
        return n;
    }

    private static double side(double[] p, int at, double[] plane) {
        double d = plane[0] * p[at] + plane[1] * p[at + 1] + plane[2] * p[at + 2] - plane[3];
        return Math.abs(d) <= ON_THE_PLANE ? 0 : d;
    }

    /** The part on that side of the plane; empty where no vertex is off the plane there. */
    private static double[] part(double[] p, double[] plane, int sign) {
        double[] part = new double[p.length + 6];
        int size = 0;
        boolean any = false;
        for (int a = 0; a < p.length; a += 3) {
            int b = (a + 3) % p.length;
            double atA = sign * side(p, a, plane);
            double atB = sign * side(p, b, plane);
            any |= atA > 0;
            if (atA >= 0) for (int i = 0; i < 3; i++) part[size++] = p[a + i];
            if (atA * atB < 0)
                for (int i = 0; i < 3; i++)
                    part[size++] = p[a + i] + atA / (atA - atB) * (p[b + i] - p[a + i]);
        }
        return any && size >= 9 ? Arrays.copyOf(part, size) : new double[0];
    }
}
