package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.TriangleMesh;

/**
 * The corners of faces as vertices, one array for each number: those that light reads as doubles.
 */
final class PackedCorners {
    /**
     * How many vertices at one place a corner is compared with, the newest first: around a cone's
     * tip each face has another normal, and nothing is to be shared.
     */
    private static final int LOOKS = 16;

    private static final int NONE = -1;

    private final Mesh mesh;

    /** The vertex of each corner, counted through the packed faces. */
    private final int[] vertexOf;

    /** A face, and its corner, that each vertex was made of. */
    private int[] faceOf;

    private int[] cornerOf;
    private int count;

    /** World units. */
    final double[] x;

    final double[] y;
    final double[] z;

    /** Normals out of the front, of length 1. */
    final double[] nx;

    final double[] ny;
    final double[] nz;

    /**
     * @param apart whether each corner has a vertex of its own
     */
    PackedCorners(Mesh mesh, int[] faces, boolean apart) {
        this.mesh = mesh;
        int corners = 0;
        for (int face : faces) corners += mesh.cornerCount(face);
        vertexOf = new int[corners];
        faceOf = new int[corners];
        cornerOf = new int[corners];
        if (apart) addAll(faces);
        else shareAlike(faces);
        faceOf = Arrays.copyOf(faceOf, count);
        cornerOf = Arrays.copyOf(cornerOf, count);
        x = new double[count];
        y = new double[count];
        z = new double[count];
        nx = new double[count];
        ny = new double[count];
        nz = new double[count];
        for (int i = 0; i < count; i++) place(i, faceOf[i], cornerOf[i]);
    }

    private void addAll(int[] faces) {
        for (int face : faces)
            for (int k = 0; k < mesh.cornerCount(face); k++) {
                vertexOf[count] = count;
                add(face, k);
            }
    }

    private int add(int face, int corner) {
        faceOf[count] = face;
        cornerOf[count] = corner;
        return count++;
    }

    private void shareAlike(int[] faces) {
        int[] newest = new int[mesh.vertexCount()];
        Arrays.fill(newest, NONE);
        int[] older = new int[vertexOf.length];
        int at = 0;
        for (int face : faces)
            for (int k = 0; k < mesh.cornerCount(face); k++) {
                int place = mesh.corner(face, k);
                int vertex = alike(newest[place], older, face, k);
                if (vertex == NONE) {
                    vertex = add(face, k);
                    older[vertex] = newest[place];
                    newest[place] = vertex;
                }
                vertexOf[at++] = vertex;
            }
    }

    private int alike(int newest, int[] older, int face, int corner) {
        int looks = 0;
        for (int v = newest; v != NONE && looks < LOOKS; v = older[v], looks++)
            if (alike(faceOf[v], cornerOf[v], face, corner)) return v;
        return NONE;
    }

    /** Whether two corners at one place have all else alike, too. */
    private boolean alike(int face, int corner, int otherFace, int other) {
        for (int k = 0; k < 3; k++)
            if (!same(mesh.cornerNormal(face, corner, k), mesh.cornerNormal(otherFace, other, k))
                    || !same(mesh.color(face, corner, k), mesh.color(otherFace, other, k)))
                return false;
        return same(mesh.textureS(face, corner), mesh.textureS(otherFace, other))
                && same(mesh.textureT(face, corner), mesh.textureT(otherFace, other));
    }

    /** Tells 0 from −0. */
    private static boolean same(double a, double b) {
        return Double.doubleToRawLongBits(a) == Double.doubleToRawLongBits(b);
    }

    private void place(int i, int face, int corner) {
        int v = mesh.corner(face, corner);
        x[i] = mesh.x(v);
        y[i] = mesh.y(v);
        z[i] = mesh.z(v);
        nx[i] = mesh.cornerNormal(face, corner, 0);
        ny[i] = mesh.cornerNormal(face, corner, 1);
        nz[i] = mesh.cornerNormal(face, corner, 2);
    }

    /** The vertex of a corner, counted through the packed faces. */
    int vertex(int corner) {
        return vertexOf[corner];
    }

    /** A face that has a vertex: the only one where faces are told apart. */
    int faceOf(int vertex) {
        return faceOf[vertex];
    }

    /** The vertices with triangles over them: with all that they have, in floats. */
    TriangleMesh mesh(int[] triangles) {
        float[] s = new float[count];
        float[] t = new float[count];
        for (int i = 0; i < count; i++) {
            s[i] = (float) mesh.textureS(faceOf[i], cornerOf[i]);
            t[i] = (float) mesh.textureT(faceOf[i], cornerOf[i]);
        }
        TriangleMesh packed =
                TriangleMesh.of(floats(x), floats(y), floats(z), triangles)
                        .withNormals(floats(nx), floats(ny), floats(nz))
                        .withTexture(s, t);
        return mesh.hasColors() ? colored(packed) : packed;
    }

    /** The mesh with the corners' own colours, opaque. */
    private TriangleMesh colored(TriangleMesh packed) {
        float[][] rgb = new float[3][count];
        for (int c = 0; c < 3; c++)
            for (int i = 0; i < count; i++)
                rgb[c][i] = (float) mesh.color(faceOf[i], cornerOf[i], c);
        float[] opaque = new float[count];
        Arrays.fill(opaque, 1);
        return packed.withColors(rgb[0], rgb[1], rgb[2], opaque);
    }

    private static float[] floats(double[] values) {
        float[] floats = new float[values.length];
        for (int i = 0; i < floats.length; i++) floats[i] = (float) values[i];
        return floats;
    }
}
