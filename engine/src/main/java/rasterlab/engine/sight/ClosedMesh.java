package rasterlab.engine.sight;

import java.util.Arrays;
import rasterlab.engine.scene.Mesh;

/**
 * Whether a mesh has no rim: each edge is walked once each way, so that what is seen of a back is
 * hidden by a front.
 *
 * <p>A line of sight from outside enters such a body before it leaves it: the first face that it
 * meets shows its front.
 */
final class ClosedMesh {
    private ClosedMesh() {}

    /**
     * Vertices at one place must be one vertex; a mesh that repeats them counts as open.
     *
     * <p>Each edge stands in two lists: with its end in that of its start, and with its start in
     * that of its end. As a face leaves each vertex that it comes to, both lists of a vertex are
     * equally long. The mesh is closed where they hold the same vertices, each once. Such lists are
     * short, so that this takes hardly longer than reading the edges.
     */
    static boolean is(Mesh mesh) {
        var first = new int[mesh.vertexCount() + 1];
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++)
                if (mesh.corner(f, k) != end(mesh, f, k)) first[mesh.corner(f, k) + 1]++;
        for (int v = 1; v < first.length; v++) first[v] += first[v - 1];
        var ends = new int[first[first.length - 1]];
        var starts = new int[ends.length];
        int[] nextEnd = first.clone();
        int[] nextStart = first.clone();
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int from = mesh.corner(f, k);
                int to = end(mesh, f, k);
                if (from == to) continue;
                ends[nextEnd[from]++] = to;
                starts[nextStart[to]++] = from;
            }
        return alike(first, ends, starts);
    }

    /** The vertex at which a face's k-th edge ends. */
    private static int end(Mesh mesh, int face, int k) {
        return mesh.corner(face, k + 1 < mesh.cornerCount(face) ? k + 1 : 0);
    }

    /** Whether the lists of each vertex hold the same numbers, each once; they are put in order. */
    private static boolean alike(int[] first, int[] ends, int[] starts) {
        for (int v = 0; v + 1 < first.length; v++) {
            Arrays.sort(ends, first[v], first[v + 1]);
            Arrays.sort(starts, first[v], first[v + 1]);
            for (int i = first[v]; i < first[v + 1]; i++)
                if (ends[i] != starts[i] || i > first[v] && ends[i] == ends[i - 1]) return false;
        }
        return true;
    }

    /** Six times the volume within, which is above 0 where fronts are outside. */
    static double volume(Mesh mesh) {
        double sum = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 1; k + 1 < mesh.cornerCount(f); k++)
                sum += triple(mesh, mesh.corner(f, 0), mesh.corner(f, k), mesh.corner(f, k + 1));
        return sum;
    }

    private static double triple(Mesh m, int a, int b, int c) {
        return m.x(a) * (m.y(b) * m.z(c) - m.z(b) * m.y(c))
                - m.y(a) * (m.x(b) * m.z(c) - m.z(b) * m.x(c))
                + m.z(a) * (m.x(b) * m.y(c) - m.y(b) * m.x(c));
    }
}
