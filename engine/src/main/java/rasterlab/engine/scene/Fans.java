package rasterlab.engine.scene;

import java.util.ArrayList;
import java.util.List;

/**
 * A mesh whose faces are cut into fans of triangles about their first corners; a triangle without
 * an area, at corners in one line, is left out.
 *
 * @param mesh of triangles over the same vertices
 * @param faceOf the face that each triangle was cut from
 */
public record Fans(Mesh mesh, int[] faceOf) {

    /** A triangle by its corners in a face. */
    private record Part(int face, int[] corners) {}

    static Fans of(Mesh whole) {
        List<Part> parts = new ArrayList<>();
        for (int f = 0; f < whole.faceCount(); f++)
            for (int k = 1; k + 1 < whole.cornerCount(f); k++) {
                int[] triangle = vertices(whole, f, 0, k, k + 1);
                if (MeshCheck.spansArea(whole.coordinates(), triangle))
                    parts.add(new Part(f, new int[] {0, k, k + 1}));
            }
        return new Fans(mesh(whole, parts), parts.stream().mapToInt(part -> part.face).toArray());
    }

    private static Mesh mesh(Mesh whole, List<Part> parts) {
        int[][] triangles =
                parts.stream()
                        .map(part -> vertices(whole, part.face, part.corners))
                        .toArray(int[][]::new);
        var mesh = new Mesh(whole.coordinates(), triangles);
        if (whole.hasNormals()) mesh = mesh.withNormals(normals(whole, parts));
        if (whole.hasTexture()) mesh = mesh.withTexture(texture(whole, parts));
        return mesh;
    }

    private static int[] vertices(Mesh mesh, int face, int... corners) {
        int[] vertices = new int[corners.length];
        for (int c = 0; c < corners.length; c++) vertices[c] = mesh.corner(face, corners[c]);
        return vertices;
    }

    private static double[] normals(Mesh whole, List<Part> parts) {
        double[] normals = new double[9 * parts.size()];
        int at = 0;
        for (Part part : parts)
            for (int corner : part.corners)
                for (int axis = 0; axis < 3; axis++)
                    normals[at++] = whole.cornerNormal(part.face, corner, axis);
        return normals;
    }

    private static double[] texture(Mesh whole, List<Part> parts) {
        double[] texture = new double[6 * parts.size()];
        int at = 0;
        for (Part part : parts)
            for (int corner : part.corners) {
                texture[at++] = whole.textureS(part.face, corner);
                texture[at++] = whole.textureT(part.face, corner);
            }
        return texture;
    }
}
