package rasterlab.engine.scene;

import java.util.function.IntToDoubleFunction;

/** The mean of a face's corners. */
public final class FaceMiddle {
    private FaceMiddle() {}

    /**
     * The mean of one coordinate.
     *
     * @param coordinate of a vertex
     */
    public static double of(Mesh mesh, int face, IntToDoubleFunction coordinate) {
        double sum = 0;
        int corners = mesh.cornerCount(face);
        for (int k = 0; k < corners; k++) sum += coordinate.applyAsDouble(mesh.corner(face, k));
        return sum / corners;
    }
}
