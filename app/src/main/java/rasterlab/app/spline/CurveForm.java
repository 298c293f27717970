package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;

/**
 * The form that the lab gives its points: one curve of a kind, or Bézier pieces joined end to end.
 */
public enum CurveForm {
    BEZIER("bezier", Curve.Kind.BEZIER, 2, Curve.MOST_BEZIER_POINTS),
    /** Cubics by points 3·i to 3·i + 3. */
    PIECES("pieces", Curve.Kind.BEZIER, 4, 46),
    HERMITE("hermite", Curve.Kind.HERMITE, 4, 4),
    CATMULL_ROM("catmull-rom", Curve.Kind.CATMULL_ROM, 4, 60),
    B_SPLINE("b-spline", Curve.Kind.B_SPLINE, 4, 60);

    /** Fewer points make one span only, and no joint to look at. */
    private static final int SEVERAL = 6;

    private final String code;
    private final Curve.Kind kind;
    private final int least;
    private final int most;

    CurveForm(String code, Curve.Kind kind, int least, int most) {
        this.code = code;
        this.kind = kind;
        this.least = least;
        this.most = most;
    }

    public String code() {
        return code;
    }

    /** The kind of its curves. */
    Curve.Kind kind() {
        return kind;
    }

    /** The form of that code. */
    static CurveForm named(String code) {
        for (CurveForm form : values()) if (form.code.equals(code)) return form;
        throw new IllegalArgumentException("no form of curve is called '" + code + "'");
    }

    /** The form that shows one curve of that kind. */
    static CurveForm of(Curve.Kind kind) {
        return switch (kind) {
            case BEZIER -> BEZIER;
            case HERMITE -> HERMITE;
            case CATMULL_ROM -> CATMULL_ROM;
            case B_SPLINE -> B_SPLINE;
        };
    }

    /** The curves from start to end; only {@link #PIECES} have more than one. */
    List<Curve> curves(List<Place> points) {
        if (this != PIECES) return List.of(curve(points));
        var pieces = new ArrayList<Curve>();
        for (int i = 0; i + 3 < points.size(); i += 3) pieces.add(curve(points.subList(i, i + 4)));
        return pieces;
    }

    private Curve curve(List<Place> points) {
        return new Curve(
                kind,
                points.stream().mapToDouble(Place::x).toArray(),
                points.stream().mapToDouble(Place::y).toArray());
    }

    /** Whether the user may take points away from so many, or add to them when {@code more}. */
    boolean allows(int points, boolean more) {
        int step = this == PIECES ? 3 : 1;
        return more ? points + step <= most : points - step >= least;
    }

    /** Where the handles are: the points, and of Hermite's derivatives the ends of a third. */
    List<Place> handles(List<Place> points) {
        if (this != HERMITE) return points;
        Place start = points.get(0);
        Place end = points.get(1);
        return List.of(
                start,
                end,
                start.plus(points.get(2).x() / 3, points.get(2).y() / 3),
                end.plus(points.get(3).x() / 3, points.get(3).y() / 3));
    }

    /** The points after a change of the form: the same curve where both know it. */
    static List<Place> converted(CurveForm from, List<Place> points, CurveForm to) {
        if (from == HERMITE && to == BEZIER) return bezierOfHermite(points);
        if (from == BEZIER && to == HERMITE && points.size() == 4) return hermiteOfBezier(points);
        if (from == HERMITE || to == HERMITE) return FirstCurves.points(to);
        boolean whole = to != PIECES || points.size() % 3 == 1;
        boolean several = to == BEZIER || points.size() >= SEVERAL;
        return whole && several && points.size() <= to.most ? points : FirstCurves.points(to);
    }

    /** Applies M_hb to [P1, P2, P3, P4]. */
    private static List<Place> hermiteOfBezier(List<Place> b) {
        return List.of(b.get(0), b.get(3), thrice(b.get(0), b.get(1)), thrice(b.get(2), b.get(3)));
    }

    private static Place thrice(Place from, Place to) {
        return new Place(Place.tidy(3 * (to.x() - from.x())), Place.tidy(3 * (to.y() - from.y())));
    }

    private static List<Place> bezierOfHermite(List<Place> h) {
        Place end = h.get(1);
        Place third = HERMITE.handles(h).get(2);
        return List.of(h.get(0), third, end.plus(-h.get(3).x() / 3, -h.get(3).y() / 3), end);
    }

    /** The points once handle {@code index} is at (x, y). */
    List<Place> moved(List<Place> points, int index, Place to, CurveJoining joining) {
        if (this == PIECES) return joining.moved(points, index, to);
        var next = new ArrayList<>(points);
        boolean derivative = this == HERMITE && index >= 2;
        next.set(index, derivative ? thrice(points.get(index - 2), to) : to);
        return next;
    }
}
