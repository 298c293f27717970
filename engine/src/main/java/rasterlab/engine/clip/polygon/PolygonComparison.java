package rasterlab.engine.clip.polygon;

import java.util.Arrays;
import java.util.List;
import rasterlab.engine.study.Deviation;

/**
 * How far clipped polygons are from the exact pieces: the area only one of the two covers, as a
 * share of the window's, and how many pieces are missing or too many.
 *
 * <p>Pieces are counted, not paired: where two are joined by a bridge, one is missing. A piece that
 * goes clockwise, by more than the rounding of its corners, is extra, and so is a place that stands
 * for a corner which has to stay.
 */
final class PolygonComparison {
    /**
     * The area, over the square of the largest coordinate, that the rounding of a piece's corners
     * may turn to the other side: no piece of so little area has a direction.
     */
    private static final double ROUNDING = 0x1p-50;

    private PolygonComparison() {}

    static Deviation compare(PolygonInWindow input, List<double[]> exact, List<double[]> actual) {
        double[] window = input.window();
        double[] subject = input.subject();
        long missing = Math.max(0, exact.size() - actual.size());
        long extra = Math.max(0, actual.size() - exact.size());
        for (double[] piece : actual)
            if (!isPlace(piece))
                return new Deviation(
                        1, exact.size(), actual.size(), exact.size(), text(piece) + " is no place");
        double share = share(window, exact, actual);
        List<double[]> clockwise = actual.stream().filter(piece -> clockwise(piece)).toList();
        String first = first(exact, actual, share);
        if (first.isEmpty() && !clockwise.isEmpty())
            first = text(clockwise.get(0)) + " goes clockwise";
        extra += clockwise.size();
        var moved = KeptCorners.firstMoved(subject, exact, actual);
        if (moved.isPresent()) {
            extra++;
            if (first.isEmpty()) first = text(moved.get()) + " is a corner that has to stay";
        }
        return new Deviation(share, missing, extra, exact.size(), first);
    }

    /** Whether it has an x and a y of each corner, all of them finite. */
    private static boolean isPlace(double[] piece) {
        return piece.length > 0
                && piece.length % 2 == 0
                && Arrays.stream(piece).allMatch(Double::isFinite);
    }

    private static boolean clockwise(double[] piece) {
        int x = PolygonArea.exponent(piece, 0, 2);
        int y = PolygonArea.exponent(piece, 1, 2);
        return PolygonArea.of(PolygonArea.scaled(piece, -x, -y)) < -ROUNDING;
    }

    /**
     * The area of one only as a share of the window's. All x are first divided by one power of 2
     * and all y by another, which no share depends on, so that the largest are about 1 and no area
     * is beyond a double.
     */
    private static double share(double[] window, List<double[]> exact, List<double[]> actual) {
        int x = PolygonArea.exponent(window, 0, 2);
        int y = PolygonArea.exponent(window, 1, 2);
        for (double[] piece : actual) {
            x = Math.max(x, PolygonArea.exponent(piece, 0, 2));
            y = Math.max(y, PolygonArea.exponent(piece, 1, 2));
        }
        double area = AreaBetween.of(scaled(exact, -x, -y), scaled(actual, -x, -y));
        return area == 0 ? 0 : area / Math.abs(PolygonArea.of(PolygonArea.scaled(window, -x, -y)));
    }

    private static List<double[]> scaled(List<double[]> pieces, int byX, int byY) {
        return pieces.stream().map(piece -> PolygonArea.scaled(piece, byX, byY)).toList();
    }

    private static String first(List<double[]> exact, List<double[]> actual, double share) {
        if (exact.size() != actual.size())
            return actual.size()
                    + (actual.size() == 1 ? " piece where " : " pieces where ")
                    + exact.size()
                    + (exact.size() == 1 ? " is right" : " are right")
                    + sample(actual);
        if (share == 0) return "";
        return "a share of " + share + " of the window is covered by one of the two only";
    }

    private static String sample(List<double[]> actual) {
        return actual.isEmpty() ? "" : "; the first is " + text(actual.get(0));
    }

    private static String text(double[] xy) {
        return Arrays.toString(xy);
    }
}
