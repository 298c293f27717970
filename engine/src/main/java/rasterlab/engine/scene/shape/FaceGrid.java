package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import rasterlab.engine.scene.Mesh;

/**
 * Puts the flat faces of a {@link Tessellation} together; equal places become one vertex.
 *
 * <p>Each corner has the surface's normal and texture coordinates of its own side of a seam; at a
 * pole those of the middle of the step of u.
 */
final class FaceGrid {
    private final Tessellation asked;
    private final Map<Place, Integer> vertices = new HashMap<>();
    private final List<int[]> faces = new ArrayList<>();
    private final DoubleStream.Builder normals = DoubleStream.builder();
    private final DoubleStream.Builder texture = DoubleStream.builder();
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
        return new Mesh(xyz, faces.toArray(int[][]::new))
                .withNormals(normals.build().toArray())
                .withTexture(texture.build().toArray());
    }

    private void add(Patch patch) {
        int m = asked.uSteps();
        int n = patch.vSteps(asked.vSteps());
        for (int i = 0; i < m; i++)
            for (int j = 0; j < n; j++) {
                double low = patch.v().at(j, n);
                double high = patch.v().at(j + 1, n);
                int[] face = new int[4];
                int corners = 0;
                face[corners++] = corner(patch, i, 0, low);
                if (!patch.isPole(low)) face[corners++] = corner(patch, i, 1, low);
                face[corners++] = corner(patch, i, 1, high);
                if (!patch.isPole(high)) face[corners++] = corner(patch, i, 0, high);
                faces.add(Arrays.copyOf(face, corners));
            }
    }

    /** The vertex at step i + next, whose normal and texture coordinates are put down. */
    private int corner(Patch patch, int i, int next, double v) {
        int m = asked.uSteps();
        if (patch.isPole(v)) {
            patch.at(patch.u().between(i, m), v, point);
            putLook();
        }
        patch.at(patch.u().at(i + next, m), v, point);
        if (!patch.isPole(v)) putLook();
        return vertex();
    }

    private void putLook() {
        normals.add(point.normalX).add(point.normalY).add(point.normalZ);
        texture.add(point.s).add(point.t);
    }

    /** Adding 0 makes −0 the 0 that it equals. */
    private int vertex() {
        var place = new Place(point.x + 0.0, point.y + 0.0, point.z + 0.0);
        Integer known = vertices.putIfAbsent(place, vertices.size());
        return known == null ? vertices.size() - 1 : known;
    }
}
