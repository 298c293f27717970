package rasterlab.app.spline;

import rasterlab.engine.range.Bounds;

/**
 * The function at one place.
 *
 * @param piece from 0
 * @param s x − x[piece]
 * @param slope first derivative there
 * @param second second derivative there
 */
public record FunctionAt(int piece, double s, double x, double y, double slope, double second) {
    public FunctionAt {
        Bounds.requireAtLeast("piece", piece, 0);
    }

    /**
     * @param share of the way from the first to the last knot, in [0, 1]
     * @param drawing with at least one piece
     */
    static FunctionAt of(FunctionChoice choice, FunctionDrawing drawing, double share) {
        double[] knots = choice.x();
        double x = knots[0] + share * (knots[knots.length - 1] - knots[0]);
        int piece = choice.problem().piece(x);
        double s = x - knots[piece];
        double[] k = drawing.coefficients().get(piece);
        return new FunctionAt(
                piece,
                s,
                x,
                k[0] + s * (k[1] + s * (k[2] + s * k[3])),
                k[1] + s * (2 * k[2] + s * 3 * k[3]),
                2 * k[2] + 6 * k[3] * s);
    }
}
