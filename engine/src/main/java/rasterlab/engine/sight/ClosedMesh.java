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

    /** Vertices at one place must be one vertex; a mesh that repeats them counts as open. */
    static boolean is(Mesh mesh) {
        var there = new long[mesh.totalCorners()];
        var back = new long[there.length];
        int at = 0;
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                long from = mesh.corner(f, k);
                long to = mesh.corner(f, (k + 1) % mesh.cornerCount(f));
                if (from == to) continue;
                there[at] = from << 32 | to;
                back[at++] = to << 32 | from;
            }
        Arrays.sort(there, 0, at);
        Arrays.sort(back, 0, at);
        for (int i = 1; i < at; i++) if (there[i] == there[i - 1]) return false;
        return Arrays.equals(there, 0, at, back, 0, at);
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
