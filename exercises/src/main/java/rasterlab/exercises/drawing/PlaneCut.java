package rasterlab.exercises.drawing;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Cuts figures to a box. Java2D draws nothing useful from coordinates of 10³⁰⁸, and doubles lose
 * the place where so long a segment crosses a small box: decimals of enough digits keep it.
 */
final class PlaneCut {
    /** Digits of a crossing; a double has up to 1074 binary places behind up to 309 digits. */
    private static final MathContext DIGITS = new MathContext(700);

    /** A side of the box: the coordinate that decides, its limit, and on which side to be. */
    private record Side(boolean horizontal, BigDecimal limit, boolean above) {
        boolean keeps(Exact point) {
            int order = (horizontal ? point.x : point.y).compareTo(limit);
            return above ? order >= 0 : order <= 0;
        }

        /** Where the segment between two points, one of them kept, crosses the side's line. */
        Exact crossing(Exact one, Exact other) {
            BigDecimal from = horizontal ? one.x : one.y;
            BigDecimal to = horizontal ? other.x : other.y;
            BigDecimal start = horizontal ? one.y : one.x;
            BigDecimal end = horizontal ? other.y : other.x;
            BigDecimal across =
                    end.subtract(start)
                            .multiply(limit.subtract(from))
                            .divide(to.subtract(from), DIGITS)
                            .add(start)
                            .round(DIGITS);
            return horizontal ? new Exact(limit, across) : new Exact(across, limit);
        }
    }

    private record Exact(BigDecimal x, BigDecimal y) {
        static Exact of(CasePoint point) {
            return new Exact(new BigDecimal(point.x()), new BigDecimal(point.y()));
        }

        CasePoint rounded() {
            return new CasePoint(x.doubleValue(), y.doubleValue());
        }
    }

    private final PlaneBox box;
    private final List<Side> sides;

    PlaneCut(PlaneBox box) {
        this.box = box;
        sides =
                List.of(
                        new Side(true, new BigDecimal(box.x().low()), true),
                        new Side(true, new BigDecimal(box.x().high()), false),
                        new Side(false, new BigDecimal(box.y().low()), true),
                        new Side(false, new BigDecimal(box.y().high()), false));
    }

    /**
     * The two ends of a segment's part in the box; empty where it has none.
     *
     * @param one finite
     * @param other finite
     */
    Optional<List<CasePoint>> segment(CasePoint one, CasePoint other) {
        if (box.contains(one) && box.contains(other)) return Optional.of(List.of(one, other));
        if (isBeside(one, other)) return Optional.empty();
        Exact from = Exact.of(one);
        Exact to = Exact.of(other);
        for (Side side : sides) {
            boolean keepsFrom = side.keeps(from);
            boolean keepsTo = side.keeps(to);
            if (!keepsFrom && !keepsTo) return Optional.empty();
            if (!keepsFrom) from = side.crossing(from, to);
            if (!keepsTo) to = side.crossing(to, from);
        }
        return Optional.of(List.of(from.rounded(), to.rounded()));
    }

    /**
     * The vertices of a polygon's part in the box; edges may run along the border where the polygon
     * comes back in.
     *
     * @param vertices finite
     */
    List<CasePoint> polygon(List<CasePoint> vertices) {
        if (vertices.stream().allMatch(box::contains)) return vertices;
        List<Exact> kept = vertices.stream().map(Exact::of).toList();
        for (Side side : sides) kept = kept(kept, side);
        return kept.stream().map(Exact::rounded).toList();
    }

    private static List<Exact> kept(List<Exact> vertices, Side side) {
        var kept = new ArrayList<Exact>();
        for (int i = 0; i < vertices.size(); i++) {
            Exact before = vertices.get((i + vertices.size() - 1) % vertices.size());
            Exact vertex = vertices.get(i);
            if (side.keeps(before) != side.keeps(vertex)) kept.add(side.crossing(before, vertex));
            if (side.keeps(vertex)) kept.add(vertex);
        }
        return kept;
    }

    /** Whether both points lie beyond the same side. */
    private boolean isBeside(CasePoint one, CasePoint other) {
        return Math.max(one.x(), other.x()) < box.x().low()
                || Math.min(one.x(), other.x()) > box.x().high()
                || Math.max(one.y(), other.y()) < box.y().low()
                || Math.min(one.y(), other.y()) > box.y().high();
    }
}
