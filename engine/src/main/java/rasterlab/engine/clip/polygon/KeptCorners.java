package rasterlab.engine.clip.polygon;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/** Whether the subject's corners that are left are where they were. */
final class KeptCorners {
    private KeptCorners() {}

    /**
     * The first corner of the subject, x and y, that the exact pieces have and the others have not,
     * digit for digit. Corners on straight edges may be left out.
     */
    static Optional<double[]> firstMoved(
            double[] subject, List<double[]> exact, List<double[]> actual) {
        if (exact.size() != actual.size()) return Optional.empty();
        Set<List<Double>> given = places(List.of(subject));
        Set<List<Double>> left = places(actual);
        for (double[] piece : exact)
            for (int i = 0; i < piece.length; i += 2) {
                List<Double> place = place(piece, i);
                if (given.contains(place) && !left.contains(place) && turns(piece, i))
                    return Optional.of(new double[] {piece[i], piece[i + 1]});
            }
        return Optional.empty();
    }

    private static Set<List<Double>> places(List<double[]> polygons) {
        var places = new HashSet<List<Double>>();
        for (double[] polygon : polygons)
            for (int i = 0; i < polygon.length; i += 2) places.add(place(polygon, i));
        return places;
    }

    /** Adding 0 makes one zero of the two. */
    private static List<Double> place(double[] polygon, int i) {
        return List.of(polygon[i] + 0.0, polygon[i + 1] + 0.0);
    }

    private static boolean turns(double[] piece, int i) {
        int before = (i + piece.length - 2) % piece.length;
        int after = (i + 2) % piece.length;
        double ax = piece[i] - piece[before];
        double ay = piece[i + 1] - piece[before + 1];
        double bx = piece[after] - piece[i];
        double by = piece[after + 1] - piece[i + 1];
        return ax * by - ay * bx != 0;
    }
}
