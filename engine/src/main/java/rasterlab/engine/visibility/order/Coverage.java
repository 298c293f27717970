package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Whether the pieces of each polygon cover it once: one piece that is the polygon itself, or pieces
 * that lie in it, do not overlap, and have its area in all.
 *
 * <p>Pieces with rounded corners may be off by 10⁻⁹ of the polygon's size.
 */
final class Coverage {
    private static final double ALLOWED = 1e-9;

    private final Sight sight;
    private long missing;
    private double worst;
    private String first = "";

    Coverage(Sight sight, Painting painting) {
        this.sight = sight;
        var pieces = new ArrayList<List<double[]>>();
        for (int k = 0; k < sight.size(); k++) pieces.add(new ArrayList<>());
        for (Painting.Piece piece : painting.pieces())
            pieces.get(piece.polygon()).add(piece.corners());
        for (int k = 0; k < sight.size(); k++) look(k, pieces.get(k));
    }

    private void look(int polygon, List<double[]> pieces) {
        double[] given = sight.polygons()[polygon];
        if (pieces.size() == 1 && Arrays.equals(pieces.get(0), given)) return;
        var flat = new FlatPolygon(given);
        double area = 0;
        boolean within = true;
        for (double[] piece : pieces) {
            area += flat.area(piece);
            within &= flat.holds(piece, ALLOWED);
        }
        double off = Math.abs(area / flat.area(given) - 1);
        if (off <= ALLOWED * pieces.size() && within && !overlap(flat, pieces)) return;
        missing++;
        worst = Math.max(worst, Math.max(1e-6, 100 * off));
        if (first.isEmpty()) first = fault(polygon, pieces.size(), within);
    }

    private static String fault(int polygon, int pieces, boolean within) {
        if (pieces == 0) return "polygon " + polygon + " is not painted";
        return within
                ? "the pieces of polygon " + polygon + " do not cover it once"
                : "a piece of polygon " + polygon + " reaches out of it";
    }

    private static boolean overlap(FlatPolygon flat, List<double[]> pieces) {
        for (int i = 1; i < pieces.size(); i++)
            for (int k = 0; k < i; k++)
                if (!flat.apart(pieces.get(i), pieces.get(k), ALLOWED)) return true;
        return false;
    }

    long missing() {
        return missing;
    }

    /** The largest difference of area, in percent. */
    double percent() {
        return worst;
    }

    String first() {
        return first;
    }
}
