package rasterlab.app.clip.outcome;

import java.util.Arrays;
import java.util.List;

/**
 * Where an answer differs from the exact one: edges that it lacks and edges that are too much.
 *
 * @param missing each as the coordinates of its ends; a point has the same twice
 * @param extra the same
 */
public record WrongParts(List<double[]> missing, List<double[]> extra) {
    /** Largest distance that no picture can show: a billionth of the window. */
    private static final double TOLERANCE = 1e-9;

    static final WrongParts NONE = new WrongParts(List.of(), List.of());

    public WrongParts {
        missing = List.copyOf(missing);
        extra = List.copyOf(extra);
    }

    /**
     * @param unit size of the window or volume; what is not finite is nowhere and left out
     */
    public static WrongParts between(List<double[]> exact, List<double[]> actual, double unit) {
        List<double[]> drawn =
                actual.stream()
                        .filter(edge -> Arrays.stream(edge).allMatch(Double::isFinite))
                        .toList();
        List<double[]> right = over(exact, unit);
        List<double[]> done = over(drawn, unit);
        return new WrongParts(
                times(Edges.minus(right, done, TOLERANCE), unit),
                times(Edges.minus(done, right, TOLERANCE), unit));
    }

    /** The edges measured in units, so that no square of a length is beyond a double. */
    private static List<double[]> over(List<double[]> edges, double unit) {
        return edges.stream()
                .map(edge -> Arrays.stream(edge).map(c -> c / unit).toArray())
                .toList();
    }

    private static List<double[]> times(List<double[]> edges, double unit) {
        return edges.stream()
                .map(edge -> Arrays.stream(edge).map(c -> c * unit).toArray())
                .toList();
    }

    public boolean isEmpty() {
        return missing.isEmpty() && extra.isEmpty();
    }
}
