package rasterlab.engine.border;

import java.util.List;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;

/** Faces in space and eyes that see them. */
final class VisibilityBorders {
    private VisibilityBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(
                        new VisibleFacesTopic(),
                        VisibilityBorders::body,
                        (method, body, message) ->
                                method.equals("convex-segment") && message.contains("inside")));
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
