package rasterlab.app.polygon.outcome;

import java.util.List;

/**
 * Which of the figure's points are inside.
 *
 * @param inside by the method, point after point; none where it refused
 * @param exact as many as there are points
 * @param sides what the method asked about the first point
 * @param pointwise whether the steps are its answers, point after point: those of a method that
 *     tells no sides, such as the user's program
 */
public record InsideAnswer(
        List<Boolean> inside, List<Boolean> exact, List<AskedSide> sides, boolean pointwise)
        implements PolygonAnswer {
    /**
     * A side that a method looked at.
     *
     * @param from number of a corner
     * @param to number of another one; the same where the method asks about a corner
     * @param value what decides
     */
    public record AskedSide(int from, int to, double value) {}

    public InsideAnswer {
        inside = List.copyOf(inside);
        exact = List.copyOf(exact);
        sides = List.copyOf(sides);
    }

    /** Whether the method judged a point, and wrongly. */
    public boolean isWrong(int point) {
        return point < inside.size() && !inside.get(point).equals(exact.get(point));
    }

    @Override
    public int steps() {
        return pointwise ? inside.size() : sides.size();
    }
}
