package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.scene.Mesh;

/** Puts the flat faces of a {@link Tessellation} together; equal places become one vertex. */
final class FaceGrid {
    private final Tessellation asked;
    private final Map<Place, Integer> vertices = new HashMap<>();
    private final List<int[]> faces = new ArrayList<>();
    private final SurfacePoint point = new SurfacePoint();

    FaceGrid(Tessellation asked) {
        this.asked = asked;
    }

    private record Place(double x, double y, double z) {}

    Mesh mesh() {
        for (Patch patch : asked.shape().patches()) add(patch);
        double[] xyz = new double[3 * vertices.size()];
        vertices.forEach(
                (place, at) -> {
                    xyz[3 * at] = place.x;
                    xyz[3 * at + 1] = place.y;
                    xyz[3 * at + 2] = place.z;
                });
        return new Mesh(xyz, faces.toArray(int[][]::new));
    }

    private void add(Patch patch) {
        int m = asked.uSteps();
        int n = patch.vSteps(asked.vSteps());
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++) {
                double low = patch.v().at(j, n);
                double high = patch.v().at(j + 1, n);
                int lowLeft = vertex(patch, i, low);
                int highLeft = vertex(patch, i, high);
                if (patch.isPole(low)) face(lowLeft, vertex(patch, i + 1, high), highLeft);
                else if (patch.isPole(high)) face(lowLeft, vertex(patch, i + 1, low), highLeft);
                else face(lowLeft, vertex(patch, i + 1, low), vertex(patch, i + 1, high), highLeft);
            }
    }

    private void face(int... corners) {
        faces.add(corners);
    }

    /** Adding 0 makes −0 the 0 that it equals. */
    private int vertex(Patch patch, int i, double v) {
        patch.at(patch.u().at(i, asked.uSteps()), v, point);
        var place = new Place(point.x + 0.0, point.y + 0.0, point.z + 0.0);
        Integer known = vertices.putIfAbsent(place, vertices.size());
        return known == null ? vertices.size() - 1 : known;
    }
}
