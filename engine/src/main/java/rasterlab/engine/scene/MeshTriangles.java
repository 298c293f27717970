package rasterlab.engine.scene;

/**
 * The faces of a {@link Mesh} as fans of triangles. Faces share no vertices, so each keeps its flat
 * normal; corners at one place have bit-equal coordinates.
 */
final class MeshTriangles {
    private final Mesh mesh;
    private final int count;

    MeshTriangles(Mesh mesh) {
        this.mesh = mesh;
        int corners = 0;
        for (int f = 0; f < mesh.faceCount(); f++) corners += mesh.cornerCount(f);
        count = corners;
    }

    TriangleMesh withoutColors() {
        float[][] place = new float[3][count];
        float[][] normal = new float[3][count];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++) {
                int v = mesh.corner(f, k);
                put(place, at, mesh.x(v), mesh.y(v), mesh.z(v));
                put(normal, at, mesh.normalX(f), mesh.normalY(f), mesh.normalZ(f));
            }
        return TriangleMesh.of(place[0], place[1], place[2], fans())
                .withNormals(normal[0], normal[1], normal[2]);
    }

    TriangleMesh colored(int[] faceRgb) {
        if (faceRgb.length != mesh.faceCount())
            throw new IllegalArgumentException(
                    "one colour for each of %d faces is needed, got %d"
                            .formatted(mesh.faceCount(), faceRgb.length));
        float[][] color = new float[3][count];
        float[] alpha = new float[count];
        java.util.Arrays.fill(alpha, 1);
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++)
                put(
                        color,
                        at,
                        (faceRgb[f] >> 16 & 255) / 255.0,
                        (faceRgb[f] >> 8 & 255) / 255.0,
                        (faceRgb[f] & 255) / 255.0);
        return withoutColors().withColors(color[0], color[1], color[2], alpha);
    }

    private static void put(float[][] into, int at, double a, double b, double c) {
        into[0][at] = (float) a;
        into[1][at] = (float) b;
        into[2][at] = (float) c;
    }

    /** A face of n corners gives n − 2 triangles about its first corner. */
    private int[] fans() {
        int[] triangles = new int[3 * (count - 2 * mesh.faceCount())];
        int at = 0;
        int first = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            for (int k = 1; k + 1 < mesh.cornerCount(f); k++) {
                triangles[at++] = first;
                triangles[at++] = first + k;
                triangles[at++] = first + k + 1;
            }
            first += mesh.cornerCount(f);
        }
        return triangles;
    }
}
