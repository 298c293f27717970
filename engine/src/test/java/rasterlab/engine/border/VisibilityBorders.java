package rasterlab.engine.border;

import static rasterlab.contract.DepthTriangleFiller.STEPS;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.DepthTriangleFiller;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.triangle.DepthTriangleTopic;
import rasterlab.engine.visibility.triangle.DepthTriangles;

/** Faces in space and eyes that see them, and triangles in a depth buffer. */
final class VisibilityBorders {
    private VisibilityBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(
                        new VisibleFacesTopic(),
                        VisibilityBorders::body,
                        (method, body, message) ->
                                method.equals("convex-segment") && message.contains("inside")),
                Border.of(new DepthTriangleTopic(), VisibilityBorders::triangles));
    }

    /** Corners anywhere in their range, or around the picture. */
    private static DepthTriangles triangles(Draws draws) {
        var triangles = new ArrayList<double[]>();
        for (int left = 1 + draws.pick(3); left > 0; left--) {
            int reach = draws.coin() ? DepthTriangleFiller.LARGEST : 12;
            var corners = new double[9];
            for (int i = 0; i < 9; i++)
                corners[i] =
                        i % 3 == 2
                                ? draws.number(0, 1)
                                : draws.whole(-reach * STEPS, reach * STEPS) / (double) STEPS;
            triangles.add(corners);
        }
        return new DepthTriangles(
                triangles, 1 + draws.pick(20), 1 + draws.pick(9), draws.number(0, 1));
    }

    private static Body body(Draws draws) {
        int vertices = 3 + draws.pick(3);
        double[] xyz = draws.numbers(3 * vertices);
        var faces = new int[1 + draws.pick(3)][];
        for (int f = 0; f < faces.length; f++) {
            faces[f] = new int[3 + draws.pick(2)];
            for (int i = 0; i < faces[f].length; i++) faces[f][i] = draws.pick(vertices);
        }
        return new Body(xyz, faces, draws.numbers(3), draws.numbers(draws.coin() ? 3 : 0));
    }
}
