package rasterlab.engine.scene;

import java.util.HashMap;
import java.util.Map;
import rasterlab.contract.VertexNormals;

/**
 * A mesh whose corners get their normals from the faces around their vertices.
 *
 * <p>Vertices in one place, up to {@value #TOGETHER} of the mesh's radius, count as one: a closed
 * surface has no seam. A corner without a normal has that of its face.
 */
public final class SmoothedMesh {
    /** Rounding may part what belongs together by so much. */
    private static final double TOGETHER = 1e-9;

    private SmoothedMesh() {}

    /**
     * @param method of topic {@code vertex-normals} that gives normals of length 1
     */
    public static Mesh of(Mesh mesh, VertexNormals method) {
        int[] place = places(mesh);
        var xyz = new double[3 * mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            xyz[3 * v] = mesh.x(v);
            xyz[3 * v + 1] = mesh.y(v);
            xyz[3 * v + 2] = mesh.z(v);
        }
        double[] found = method.normals(xyz, triangles(mesh, place));
        var normals = new double[3 * mesh.totalCorners()];
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                put(mesh, f, found, place[mesh.corner(f, k)], normals, mesh.firstCorner(f) + k);
        return mesh.withNormals(normals);
    }

    private static void put(
            Mesh mesh, int face, double[] found, int vertex, double[] normals, int corner) {
        double x = found[3 * vertex];
        double y = found[3 * vertex + 1];
        double z = found[3 * vertex + 2];
        boolean none = x == 0 && y == 0 && z == 0;
        normals[3 * corner] = none ? mesh.normalX(face) : x;
        normals[3 * corner + 1] = none ? mesh.normalY(face) : y;
        normals[3 * corner + 2] = none ? mesh.normalZ(face) : z;
    }

    /** The first vertex in the same place, for each vertex. */
    private static int[] places(Mesh mesh) {
        double radius = 0;
        for (int v = 0; v < mesh.vertexCount(); v++)
            radius =
                    Math.max(
                            radius,
                            Math.max(
                                    Math.abs(mesh.x(v)),
                                    Math.max(Math.abs(mesh.y(v)), Math.abs(mesh.z(v)))));
        double grid = TOGETHER * radius;
        record Cell(long x, long y, long z) {}
        Map<Cell, Integer> first = new HashMap<>();
        var place = new int[mesh.vertexCount()];
        for (int v = 0; v < place.length; v++) {
            var cell =
                    new Cell(
                            Math.round(mesh.x(v) / grid),
                            Math.round(mesh.y(v) / grid),
                            Math.round(mesh.z(v) / grid));
            Integer known = first.putIfAbsent(cell, v);
            place[v] = known == null ? v : known;
        }
        return place;
    }

    /** Each face as a fan about its first corner. */
    private static int[] triangles(Mesh mesh, int[] place) {
        var triangles = new int[3 * (mesh.totalCorners() - 2 * mesh.faceCount())];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 1; k + 1 < mesh.cornerCount(f); k++) {
                triangles[at++] = place[mesh.corner(f, 0)];
                triangles[at++] = place[mesh.corner(f, k)];
                triangles[at++] = place[mesh.corner(f, k + 1)];
            }
        return triangles;
    }
}
