package rasterlab.engine.pipeline.paint;

import java.util.function.IntToDoubleFunction;
import rasterlab.engine.scene.Mesh;

/** The mean of a face's corners. */
final class FaceMiddle {
    private FaceMiddle() {}

    /**
     * @param coordinate of a vertex
     */
    static double of(Mesh mesh, int face, IntToDoubleFunction coordinate) {
        double sum = 0;
        int corners = mesh.cornerCount(face);
        for (int k = 0; k < corners; k++) sum += coordinate.applyAsDouble(mesh.corner(face, k));
        return sum / corners;
    }
}
