package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;

/** Polygons and pieces of them, back to front: an output of topic {@code depth-order}. */
public final class Painting {
    private final List<Piece> pieces = new ArrayList<>();

    /**
     * A polygon or a piece of it.
     *
     * @param polygon number of the polygon
     * @param corners x, y, z of each corner
     */
    public record Piece(int polygon, double[] corners) {
        public Piece {
            corners = corners.clone();
        }

        /** Whether it is the polygon as given. */
        public boolean whole(double[] given) {
            return Arrays.equals(corners, given);
        }
    }

    /** Adds what is painted next. */
    public void add(int polygon, double[] corners) {
        pieces.add(new Piece(polygon, corners));
    }

    /** The faces that are painted, first to last. */
    public List<Piece> pieces() {
        return List.copyOf(pieces);
    }

    int size() {
        return pieces.size();
    }

    @Override
    public String toString() {
        return pieces.stream()
                .map(piece -> "" + piece.polygon)
                .collect(Collectors.joining(", ", "[", "]"));
    }
}
