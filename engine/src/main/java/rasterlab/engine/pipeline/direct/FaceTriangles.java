package rasterlab.engine.pipeline.direct;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.TriangleMesh;

/**
 * Faces of a mesh as fans of triangles, whose vertices are the faces' corners in their order: two
 * faces share none, and what they have at one place has bit-equal coordinates.
 */
final class FaceTriangles {
    /** Where red, green, blue and alpha begin in 0xAARRGGBB. */
    private static final int[] SHIFT = {16, 8, 0, 24};

    private final Mesh mesh;
    private final int[] faces;
    private final int corners;

    /**
     * @param faces in the order in which they are drawn
     */
    FaceTriangles(Mesh mesh, int[] faces) {
        this.mesh = mesh;
        this.faces = faces;
        int sum = 0;
        for (int face : faces) sum += mesh.cornerCount(face);
        corners = sum;
    }

    /** Places, normals and texture coordinates. */
    TriangleMesh uncolored() {
        float[][] place = new float[3][corners];
        float[][] normal = new float[3][corners];
        float[][] texture = new float[2][corners];
        int at = 0;
        for (int f : faces)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++) {
                int v = mesh.corner(f, k);
                put(place, at, mesh.x(v), mesh.y(v), mesh.z(v));
                put(
                        normal,
                        at,
                        mesh.cornerNormal(f, k, 0),
                        mesh.cornerNormal(f, k, 1),
                        mesh.cornerNormal(f, k, 2));
                put(texture, at, mesh.textureS(f, k), mesh.textureT(f, k));
            }
        return TriangleMesh.of(place[0], place[1], place[2], fans())
                .withNormals(normal[0], normal[1], normal[2])
                .withTexture(texture[0], texture[1]);
    }

    /**
     * The same with colours.
     *
     * @param faceArgb one colour 0xAARRGGBB per face of the whole mesh
     */
    TriangleMesh flat(int[] faceArgb) {
        float[][] rgba = new float[4][corners];
        int at = 0;
        for (int f : faces)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++)
                for (int c = 0; c < 4; c++) rgba[c][at] = (faceArgb[f] >>> SHIFT[c] & 255) / 255f;
        return uncolored().withColors(rgba[0], rgba[1], rgba[2], rgba[3]);
    }

    /**
     * The same with colours.
     *
     * @param cornerRgba four shares for each corner of the whole mesh
     */
    TriangleMesh smooth(float[] cornerRgba) {
        float[][] rgba = new float[4][corners];
        int at = 0;
        for (int f : faces)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++)
                for (int c = 0; c < 4; c++)
                    rgba[c][at] = cornerRgba[4 * (mesh.firstCorner(f) + k) + c];
        return uncolored().withColors(rgba[0], rgba[1], rgba[2], rgba[3]);
    }

    /** Makes triangles with the corners' own colours, opaque. */
    TriangleMesh tinted() {
        float[][] rgba = new float[4][corners];
        int at = 0;
        for (int f : faces)
            for (int k = 0; k < mesh.cornerCount(f); k++, at++) {
                for (int c = 0; c < 3; c++) rgba[c][at] = (float) mesh.color(f, k, c);
                rgba[3][at] = 1;
            }
        return uncolored().withColors(rgba[0], rgba[1], rgba[2], rgba[3]);
    }

    private static void put(float[][] into, int at, double... values) {
        for (int i = 0; i < values.length; i++) into[i][at] = (float) values[i];
    }

    private int[] fans() {
        int[] triangles = new int[3 * (corners - 2 * faces.length)];
        int at = 0;
        int first = 0;
        for (int f : faces) {
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
