package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.TriangleMesh;

/**
 * Faces of a mesh as the pipeline reads them: fans of triangles over vertices. All of it depends on
 * the scene alone, so it is made once and serves every view, as a buffer in OpenGL's memory does.
 *
 * <p>A vertex stands for all corners that are alike bit for bit, or for one corner alone where
 * faces are told apart. What two faces have at one place has bit-equal coordinates either way.
 */
final class PackedFaces {
    private final Mesh mesh;
    private final int[] faces;
    private final PackedCorners corners;
    private final TriangleMesh triangles;

    /** Where each face's triangles begin, and where the last one's end. */
    private final int[] firstTriangle;

    private PackedFaces(Mesh mesh, int[] faces, boolean apart) {
        this.mesh = mesh;
        this.faces = faces;
        corners = new PackedCorners(mesh, faces, apart);
        firstTriangle = new int[faces.length + 1];
        for (int i = 0; i < faces.length; i++)
            firstTriangle[i + 1] = firstTriangle[i] + mesh.cornerCount(faces[i]) - 2;
        triangles = corners.mesh(fans());
    }

    /** Packs faces whose light does not tell one face at a vertex from another. */
    static PackedFaces shared(Mesh mesh, int[] faces) {
        return new PackedFaces(mesh, faces, false);
    }

    /** Packs faces that each have vertices of their own. */
    static PackedFaces apart(Mesh mesh, int[] faces) {
        return new PackedFaces(mesh, faces, true);
    }

    private int[] fans() {
        int[] fans = new int[3 * firstTriangle[faces.length]];
        int at = 0;
        int first = 0;
        for (int face : faces) {
            int count = mesh.cornerCount(face);
            for (int k = 1; k + 1 < count; k++) {
                fans[at++] = corners.vertex(first);
                fans[at++] = corners.vertex(first + k);
                fans[at++] = corners.vertex(first + k + 1);
            }
            first += count;
        }
        return fans;
    }

    Mesh mesh() {
        return mesh;
    }

    PackedCorners corners() {
        return corners;
    }

    /** All triangles, in the order in which the faces were packed. */
    TriangleMesh triangles() {
        return triangles;
    }

    /**
     * The triangles of some of the faces.
     *
     * @param drawn in the order of drawing; all of them packed, and packed in ascending order
     *     unless they are just the packed ones
     */
    TriangleMesh triangles(int[] drawn) {
        if (Arrays.equals(drawn, faces)) return triangles;
        int count = 0;
        for (int face : drawn) count += mesh.cornerCount(face) - 2;
        int[] chosen = new int[3 * count];
        int at = 0;
        for (int face : drawn) {
            int from = 3 * firstTriangle[placeOf(face)];
            int end = at + 3 * (mesh.cornerCount(face) - 2);
            while (at < end) chosen[at++] = triangles.triangles()[from++];
        }
        return triangles.withTriangles(chosen);
    }

    private int placeOf(int face) {
        return faces.length == mesh.faceCount() ? face : Arrays.binarySearch(faces, face);
    }
}
