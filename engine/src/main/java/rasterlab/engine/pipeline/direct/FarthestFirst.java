package rasterlab.engine.pipeline.direct;

import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Faces in the order of the mean depth of their corners, the farthest first; of equal ones, the
 * first in the mesh first.
 *
 * <p>A radix sort from the lowest digit on, whose cost is linear: with comparisons, half a million
 * faces took longer to sort than to draw.
 */
final class FarthestFirst {
    private static final int DIGIT_BITS = 11;
    private static final int DIGITS = 1 << DIGIT_BITS;

    private FarthestFirst() {}

    /**
     * @param faces in ascending order; it is written to
     */
    static int[] sorted(ViewedMesh view, int[] faces) {
        long[] keys = new long[faces.length];
        for (int i = 0; i < faces.length; i++) keys[i] = key(-meanDepth(view, faces[i]));
        long[] otherKeys = new long[faces.length];
        int[] other = new int[faces.length];
        for (int shift = 0; shift < Long.SIZE; shift += DIGIT_BITS) {
            int[] next = starts(keys, shift);
            if (next.length == 0) continue;
            for (int i = 0; i < faces.length; i++) {
                int at = next[digit(keys[i], shift)]++;
                otherKeys[at] = keys[i];
                other[at] = faces[i];
            }
            long[] sortedKeys = otherKeys;
            otherKeys = keys;
            keys = sortedKeys;
            int[] sorted = other;
            other = faces;
            faces = sorted;
        }
        return faces;
    }

    private static double meanDepth(ViewedMesh view, int face) {
        Mesh mesh = view.mesh();
        int corners = mesh.cornerCount(face);
        double sum = 0;
        for (int k = 0; k < corners; k++) sum += view.eyeZ(mesh.corner(face, k));
        return sum / corners;
    }

    /** A number without a sign that is greater where the depth is: with −0 below 0. */
    private static long key(double depth) {
        long bits = Double.doubleToLongBits(depth);
        return bits >= 0 ? bits ^ Long.MIN_VALUE : ~bits;
    }

    private static int digit(long key, int shift) {
        return (int) (key >>> shift) & DIGITS - 1;
    }

    /** Where the keys of each digit go; nothing where all have the same one. */
    private static int[] starts(long[] keys, int shift) {
        int[] starts = new int[DIGITS + 1];
        for (long key : keys) starts[digit(key, shift) + 1]++;
        for (int d = 0; d < DIGITS; d++) {
            if (starts[d + 1] == keys.length) return new int[0];
            starts[d + 1] += starts[d];
        }
        return starts;
    }
}
