package rasterlab.app.coordinates.list;

import java.util.Arrays;
import java.util.Map;
import rasterlab.engine.transform.matrix.NamedMatrices;

/** The numbers with which a matrix is added to a list. */
final class FirstNumbers {
    private static final Map<String, double[]> NUMBERS =
            Map.ofEntries(
                    Map.entry("SCALE2D", new double[] {2, 1}),
                    Map.entry("SHEAR2D", new double[] {0, 0.5}),
                    Map.entry("TRANSL2D", new double[] {2, 1}),
                    Map.entry("TRANSL3D", new double[] {4, 2, 0}),
                    Map.entry("SCALE3D", new double[] {0.5}),
                    Map.entry("ROTAXIS", new double[] {0, 0, 0, 1, 2, 2, 37}),
                    Map.entry("TRIMETRIC", new double[] {-30, 20}),
                    Map.entry("PERSPECTIVE", new double[] {0, 0, -0.05}),
                    Map.entry("CENTRAL", new double[] {20}),
                    Map.entry("CENTRAL_ORIGIN", new double[] {20}),
                    Map.entry("NORMALIZE", new double[] {10, 5, 5, 20}),
                    Map.entry("CANONICAL", new double[] {0.5}),
                    Map.entry("VIEW_LEFT", new double[] {30, 70, 20}),
                    Map.entry("VIEW_RIGHT", new double[] {30, 70, 20}),
                    Map.entry("LOOKAT", new double[] {12, -16, 9, 0, 0, 0, 0, 0, 1}),
                    Map.entry("GL_ORTHO", new double[] {-10, 10, -10, 10, 1, 100}),
                    Map.entry("GL_FRUSTUM", new double[] {-1, 1, -1, 1, 2, 100}),
                    Map.entry("GL_PERSPECTIVE", new double[] {40, 1.5, 1, 100}),
                    Map.entry("VIEWPORT", new double[] {0, 0, 800, 600, 0, 1}));

    private static final double[] IDENTITY_2D = {
        1, 0, 0, //
        0, 1, 0, //
        0, 0, 1
    };

    private static final double[] IDENTITY_3D = {
        1, 0, 0, 0, //
        0, 1, 0, 0, //
        0, 0, 1, 0, //
        0, 0, 0, 1
    };

    private FirstNumbers() {}

    static double[] of(String name, int dimension) {
        if (name.equals(ListItem.FREE)) return dimension == 2 ? IDENTITY_2D : IDENTITY_3D;
        if (NUMBERS.containsKey(name)) return NUMBERS.get(name);
        int count = NamedMatrices.named(name).numbers();
        double usual = name.startsWith("ROT") ? 30 : name.startsWith("SCALE") ? 2 : 0;
        var numbers = new double[count];
        Arrays.fill(numbers, usual);
        return numbers;
    }
}
