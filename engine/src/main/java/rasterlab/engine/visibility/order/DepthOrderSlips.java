package rasterlab.engine.visibility.order;

import java.util.Comparator;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import rasterlab.contract.DepthOrder;
import rasterlab.engine.study.Slip;

/** Polygons painted in an order that has little to do with the eye, or under other numbers. */
final class DepthOrderSlips {
    private DepthOrderSlips() {}

    static List<Slip<DepthOrder>> of(DepthOrder right) {
        return List.of(
                Slip.of("painted-as-given", sorted((polygons, eye) -> i -> i)),
                Slip.of("last-given-first", sorted((polygons, eye) -> i -> -i)),
                Slip.of(
                        "sorted-by-z",
                        sorted((polygons, eye) -> i -> -mean(polygons[i], 2)),
                        sorted((polygons, eye) -> i -> mean(polygons[i], 2))),
                Slip.of(
                        "first-vertex-decides",
                        sorted((polygons, eye) -> i -> -distance(polygons[i], 0, eye))),
                Slip.of(
                        "numbers-from-1",
                        (polygons, eye, out) ->
                                right.order(
                                        polygons,
                                        eye,
                                        (polygon, corners) -> out.piece(polygon + 1, corners))),
                Slip.of(
                        "whole-for-each-piece",
                        (polygons, eye, out) ->
                                right.order(
                                        polygons,
                                        eye,
                                        (polygon, corners) ->
                                                out.piece(polygon, polygons[polygon]))));
    }

    private interface Key {
        /** Gives what a polygon is sorted by, the least first. */
        IntToDoubleFunction of(double[][] polygons, double[] eye);
    }

    private static DepthOrder sorted(Key key) {
        return (polygons, eye, out) -> {
            IntToDoubleFunction by = key.of(polygons, eye);
            IntStream.range(0, polygons.length)
                    .boxed()
                    .sorted(Comparator.comparingDouble(by::applyAsDouble))
                    .forEach(i -> out.piece(i, polygons[i]));
        };
    }

    private static double mean(double[] corners, int axis) {
        double sum = 0;
        for (int i = axis; i < corners.length; i += 3) sum += corners[i];
        return sum * 3 / corners.length;
    }

    private static double distance(double[] corners, int from, double[] eye) {
        return Math.hypot(
                corners[from] - eye[0],
                Math.hypot(corners[from + 1] - eye[1], corners[from + 2] - eye[2]));
    }
}
