package rasterlab.engine.spline.curve;

import java.util.ArrayDeque;
import java.util.function.ToDoubleFunction;
import rasterlab.contract.Curve;

/**
 * Halves Bézier pieces of any degree by de Casteljau's triangle until a test calls them flat.
 *
 * <p>Pieces yet to come wait on a stack, the next on top; what was passed and what waits always
 * make up the whole curve. A test may call a bent piece flat, but whatever it says, halving ends
 * with pieces 2⁻³⁰ long.
 */
final class HalvingWalk implements CurveWalk {
    private static final double SHORTEST = 0x1p-30;

    private record Piece(BezierPoints points, double width) {}

    private final Curve curve;
    private final double flatness;
    private final ToDoubleFunction<BezierPoints> bound;
    private final ArrayDeque<Piece> waiting = new ArrayDeque<>();
    private double x;
    private double y;
    private double u;
    private double decision;
    private int span = -1;
    private long splits;

    /**
     * @param bound what the test takes for the distance of a piece from its chord, in pixels
     */
    HalvingWalk(Curve curve, double flatness, ToDoubleFunction<BezierPoints> bound) {
        this.curve = curve;
        this.flatness = Flatness.left(curve, flatness, 1);
        this.bound = bound;
        WangCount.ofAll(curve, new BezierPoints(curve), this.flatness);
    }

    @Override
    public boolean advance() {
        if (waiting.isEmpty()) {
            if (span == curve.spans() - 1) return false;
            span++;
            var whole = new BezierPoints(curve);
            whole.load(span);
            waiting.push(new Piece(whole, 1));
            u = 0;
            if (span == 0) {
                x = whole.x[0];
                y = whole.y[0];
                return true;
            }
        }
        Piece piece = waiting.pop();
        decision = bound.applyAsDouble(piece.points);
        while (decision > flatness && piece.width > SHORTEST) {
            piece = halved(piece);
            decision = bound.applyAsDouble(piece.points);
        }
        x = piece.points.x[piece.points.degree()];
        y = piece.points.y[piece.points.degree()];
        u += piece.width;
        return true;
    }

    /** Puts the second half on the stack and returns the first. */
    private Piece halved(Piece piece) {
        BezierPoints second = piece.points;
        BezierPoints first = second.firstHalf();
        waiting.push(new Piece(second, piece.width / 2));
        splits++;
        return new Piece(first, piece.width / 2);
    }

    @Override
    public double x() {
        return x;
    }

    @Override
    public double y() {
        return y;
    }

    @Override
    public double t() {
        return (span + u) / curve.spans();
    }

    @Override
    public double decision() {
        return decision;
    }

    @Override
    public long splits() {
        return splits;
    }
}
