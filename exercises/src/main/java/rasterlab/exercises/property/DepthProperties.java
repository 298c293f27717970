package rasterlab.exercises.property;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import rasterlab.engine.visibility.triangle.DepthTriangles;

/** Properties of the depth buffer: it shows the same in whatever order triangles come. */
final class DepthProperties {
    static final List<Property<DepthTriangles, DepthTriangles.TrianglePicture>> ALL =
            List.of(
                    new Property<>(
                            "depth-triangle",
                            "order-independence",
                            DepthProperties::areDifferent,
                            Relation.changed(
                                    DepthProperties::reversed, DepthProperties::renumbered)));

    private DepthProperties() {}

    /** Whether all triangles differ: of the same triangle again, the first one stays. */
    private static boolean areDifferent(DepthTriangles input) {
        List<double[]> triangles = input.triangles();
        for (int i = 0; i < triangles.size(); i++)
            for (int j = 0; j < i; j++)
                if (Arrays.equals(triangles.get(i), triangles.get(j))) return false;
        return triangles.size() > 1;
    }

    private static DepthTriangles reversed(DepthTriangles input) {
        List<double[]> back = new ArrayList<>(input.triangles());
        Collections.reverse(back);
        return new DepthTriangles(back, input.width(), input.height(), input.background());
    }

    /** Each pixel shows the same triangle, by its number in the other order. */
    private static DepthTriangles.TrianglePicture renumbered(
            DepthTriangles input, DepthTriangles.TrianglePicture answer) {
        int count = input.triangles().size();
        int[] shown =
                Arrays.stream(answer.shown()).map(one -> one == 0 ? 0 : count + 1 - one).toArray();
        return new DepthTriangles.TrianglePicture(answer.width(), shown, answer.depths().clone());
    }
}
