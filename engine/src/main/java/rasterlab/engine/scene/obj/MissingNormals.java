package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import rasterlab.engine.light.normals.WeightedNormals;

/**
 * Adds normals to the corners that name none: those of the smooth surface that the faces of one
 * smoothing group make, by angles, and the face's own where there is no group, other corners of the
 * face name one, or the faces about the vertex cancel out.
 */
final class MissingNormals {
    private final double[] xyz;
    private final Doubles normals;
    private final Faces faces;

    /** The group's number of a vertex; valid where {@link #usedBy} is the group. */
    private final int[] numberInGroup;

    private final int[] usedBy;

    MissingNormals(Doubles positions, Doubles normals, Faces faces) {
        xyz = positions.all();
        this.normals = normals;
        this.faces = faces;
        numberInGroup = new int[xyz.length / 3];
        usedBy = new int[xyz.length / 3];
    }

    /** Names a normal at every corner of the faces, and gives all normals. */
    double[] complete() {
        Map<Integer, List<Integer>> groups = new TreeMap<>();
        for (int f = 0; f < faces.count(); f++) {
            int missing = 0;
            for (int k = 0; k < faces.corners(f); k++)
                if (faces.normal(f, k) == Faces.NONE) missing++;
            if (missing == 0) continue;
            if (faces.smoothing(f) == 0 || missing < faces.corners(f)) flat(f);
            else groups.computeIfAbsent(faces.smoothing(f), key -> new ArrayList<>()).add(f);
        }
        groups.forEach(this::smooth);
        return normals.all();
    }

    /** Computes the face's vector area, brought to length 1; a face has an area. */
    private void flat(int face) {
        int number = normals.size() / 3;
        double[] sum = new double[3];
        double longest = 0;
        for (int k = 1; k < faces.corners(face); k++)
            for (int axis = 0; axis < 3; axis++)
                longest = Math.max(longest, Math.abs(edge(face, k, axis, 0)));
        int exponent = TinyLengths.exponent(longest);
        for (int k = 1; k + 1 < faces.corners(face); k++)
            for (int axis = 0; axis < 3; axis++) {
                int y = (axis + 1) % 3;
                int z = (axis + 2) % 3;
                sum[axis] +=
                        edge(face, k, y, exponent) * edge(face, k + 1, z, exponent)
                                - edge(face, k, z, exponent) * edge(face, k + 1, y, exponent);
            }
        double length = Math.hypot(Math.hypot(sum[0], sum[1]), sum[2]);
        for (int axis = 0; axis < 3; axis++) normals.add(sum[axis] / length);
        for (int k = 0; k < faces.corners(face); k++)
            if (faces.normal(face, k) == Faces.NONE) faces.setNormal(face, k, number);
    }

    private double edge(int face, int corner, int axis, int exponent) {
        double edge =
                xyz[3 * faces.vertex(face, corner) + axis] - xyz[3 * faces.vertex(face, 0) + axis];
        return exponent == 0 ? edge : Math.scalb(edge, exponent);
    }

    private void smooth(int group, List<Integer> members) {
        var places = new Doubles();
        var triangles = new Ints();
        for (int f : members)
            for (int k = 1; k + 1 < faces.corners(f); k++) {
                triangles.add(number(group, faces.vertex(f, 0), places));
                triangles.add(number(group, faces.vertex(f, k), places));
                triangles.add(number(group, faces.vertex(f, k + 1), places));
            }
        double[] smooth = WeightedNormals.byAngle().normals(places.all(), triangles.all());
        int first = normals.size() / 3;
        for (double coordinate : smooth) normals.add(coordinate);
        for (int f : members) {
            boolean cancelled = false;
            for (int k = 0; k < faces.corners(f); k++) {
                int number = numberInGroup[faces.vertex(f, k)];
                boolean none = isNone(Arrays.copyOfRange(smooth, 3 * number, 3 * number + 3));
                if (!none) faces.setNormal(f, k, first + number);
                cancelled |= none;
            }
            if (cancelled) flat(f);
        }
    }

    private static boolean isNone(double[] normal) {
        return normal[0] == 0 && normal[1] == 0 && normal[2] == 0;
    }

    private int number(int group, int vertex, Doubles places) {
        if (usedBy[vertex] != group) {
            usedBy[vertex] = group;
            numberInGroup[vertex] = places.size() / 3;
            for (int axis = 0; axis < 3; axis++) places.add(xyz[3 * vertex + axis]);
        }
        return numberInGroup[vertex];
    }
}
