package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.PieceSink;
import rasterlab.engine.study.Mutant;

/** Polygons put in order with one mistake. */
final class DepthOrderMutants {
    private static final DepthOrder RIGHT = new Bsp();

    private DepthOrderMutants() {}

    static List<Mutant<DepthOrder>> all() {
        return List.of(
                new Mutant<>(
                        "nearest-first", "one-behind-the-other", DepthOrderMutants::nearestFirst),
                new Mutant<>("mean-depth-decides", "mean-mis-sorts", new MeanZ()),
                new Mutant<>(
                        "whole-depths",
                        "rounded-to-one-depth",
                        byDepth(xyz -> Math.rint(mean(xyz, xyz.length / 3)))),
                new Mutant<>(
                        "last-corner-left-out",
                        "fourth-corner-left-out",
                        byDepth(xyz -> mean(xyz, xyz.length / 3 - 1))),
                new Mutant<>(
                        "eye-at-the-origin",
                        "eye-on-the-other-side",
                        (polygons, eye, out) -> RIGHT.order(polygons, new double[3], out)),
                new Mutant<>(
                        "nearest-corner-decides",
                        "nearest-corner-mis-sorts",
                        byDepth(DepthOrderMutants::nearest)),
                new Mutant<>("nothing-cut", "circle-of-three", DepthOrderMutants::uncut),
                new Mutant<>(
                        "one-piece-each", "through-each-other", DepthOrderMutants::onePieceEach),
                new Mutant<>(
                        "behind-the-eye-dropped",
                        "behind-the-eye",
                        DepthOrderMutants::withoutThoseBehind),
                new Mutant<>(
                        "normal-overflows",
                        "huge",
                        (polygons, eye, out) -> {
                            if (overflows(polygons)) uncut(polygons, eye, out);
                            else RIGHT.order(polygons, eye, out);
                        }));
    }

    private record Piece(int polygon, double[] corners) {}

    private static List<Piece> right(double[][] polygons, double[] eye) {
        var pieces = new ArrayList<Piece>();
        RIGHT.order(polygons, eye, (polygon, corners) -> pieces.add(new Piece(polygon, corners)));
        return pieces;
    }

    private static void nearestFirst(double[][] polygons, double[] eye, PieceSink out) {
        List<Piece> pieces = right(polygons, eye);
        Collections.reverse(pieces);
        for (Piece piece : pieces) out.piece(piece.polygon, piece.corners);
    }

    private static void uncut(double[][] polygons, double[] eye, PieceSink out) {
        var painted = new HashSet<Integer>();
        for (Piece piece : right(polygons, eye))
            if (painted.add(piece.polygon)) out.piece(piece.polygon, polygons[piece.polygon]);
    }

    private static void onePieceEach(double[][] polygons, double[] eye, PieceSink out) {
        var painted = new HashSet<Integer>();
        for (Piece piece : right(polygons, eye))
            if (painted.add(piece.polygon)) out.piece(piece.polygon, piece.corners);
    }

    private static void withoutThoseBehind(double[][] polygons, double[] eye, PieceSink out) {
        for (Piece piece : right(polygons, eye))
            if (nearest(polygons[piece.polygon]) >= eye[2]) out.piece(piece.polygon, piece.corners);
    }

    private static boolean overflows(double[][] polygons) {
        for (double[] xyz : polygons)
            for (double value : xyz) if (Double.isInfinite(value * value)) return true;
        return false;
    }

    /** The eye looks along z. */
    private static DepthOrder byDepth(ToDoubleFunction<double[]> depth) {
        return (polygons, eye, out) ->
                IntStream.range(0, polygons.length)
                        .boxed()
                        .sorted(Comparator.comparingDouble(k -> -depth.applyAsDouble(polygons[k])))
                        .forEach(k -> out.piece(k, polygons[k]));
    }

    private static double mean(double[] xyz, int corners) {
        double sum = 0;
        for (int i = 0; i < corners; i++) sum += xyz[3 * i + 2];
        return sum / corners;
    }

    private static double nearest(double[] xyz) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 2; i < xyz.length; i += 3) least = Math.min(least, xyz[i]);
        return least;
    }
}
