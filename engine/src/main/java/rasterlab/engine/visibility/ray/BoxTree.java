package rasterlab.engine.visibility.ray;

import java.util.Arrays;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;

/**
 * Boxes round the faces of a mesh, each but the smallest round two others: a ray that misses a box
 * meets no face in it.
 *
 * <p>Faces are halved by the middles of their boxes along the widest axis. Node k has the children
 * 2k + 1 and 2k + 2; all leaves are on one level and hold up to four faces each.
 *
 * <p>Source: S. M. Rubin, T. Whitted, A 3-dimensional representation for fast rendering of complex
 * scenes, SIGGRAPH 1980, pp. 110–116.
 */
final class BoxTree {
    private static final int FACES_PER_LEAF = 4;

    private final FaceBoxes around;
    private final int[] faces;
    private final int firstLeaf;
    private final double[] boxes;

    BoxTree(Mesh mesh) {
        around = new FaceBoxes(mesh);
        int count = mesh.faceCount();
        int levels = 0;
        while ((long) FACES_PER_LEAF << levels < count) levels++;
        firstLeaf = (1 << levels) - 1;
        boxes = new double[6 * (2 * firstLeaf + 1)];
        Integer[] order = IntStream.range(0, count).boxed().toArray(Integer[]::new);
        build(0, order, 0, count);
        faces = Arrays.stream(order).mapToInt(Integer::intValue).toArray();
    }

    private void build(int node, Integer[] order, int from, int to) {
        for (int axis = 0; axis < 3; axis++) {
            double least = Double.POSITIVE_INFINITY;
            double most = Double.NEGATIVE_INFINITY;
            for (int i = from; i < to; i++) {
                least = Math.min(least, around.least(order[i], axis));
                most = Math.max(most, around.most(order[i], axis));
            }
            boxes[6 * node + axis] = least;
            boxes[6 * node + 3 + axis] = most;
        }
        if (node >= firstLeaf) return;
        int axis = widest(node);
        Arrays.sort(
                order,
                from,
                to,
                (a, b) -> Double.compare(around.middle(a, axis), around.middle(b, axis)));
        int middle = from + to >>> 1;
        build(2 * node + 1, order, from, middle);
        build(2 * node + 2, order, middle, to);
    }

    private int widest(int node) {
        int widest = 0;
        for (int axis = 1; axis < 3; axis++)
            if (extent(node, axis) > extent(node, widest)) widest = axis;
        return widest;
    }

    private double extent(int node, int axis) {
        return boxes[6 * node + 3 + axis] - boxes[6 * node + axis];
    }

    /** Lets the ray try every face it may meet. */
    void cast(RayHits ray) {
        if (faces.length > 0 && ray.entry(boxes, 0) < Double.POSITIVE_INFINITY)
            visit(0, 0, faces.length, ray);
    }

    /** Two faces of the mesh, each pair once. */
    @FunctionalInterface
    interface PairSink {
        void pair(int one, int other);
    }

    /** Hands out the pairs of faces whose boxes have a point in common. */
    void overlaps(PairSink out) {
        if (faces.length > 0) overlaps(0, 0, faces.length, 0, 0, faces.length, out);
    }

    private void overlaps(int a, int fromA, int toA, int b, int fromB, int toB, PairSink out) {
        if (apart(a, b)) return;
        if (a >= firstLeaf) {
            for (int i = fromA; i < toA; i++)
                for (int j = a == b ? i + 1 : fromB; j < toB; j++)
                    if (!around.apart(faces[i], faces[j])) out.pair(faces[i], faces[j]);
            return;
        }
        int middleA = fromA + toA >>> 1;
        int middleB = fromB + toB >>> 1;
        int nextA = 2 * a + 1;
        int nextB = 2 * b + 1;
        overlaps(nextA, fromA, middleA, nextB, fromB, middleB, out);
        overlaps(nextA, fromA, middleA, nextB + 1, middleB, toB, out);
        if (a != b) overlaps(nextA + 1, middleA, toA, nextB, fromB, middleB, out);
        overlaps(nextA + 1, middleA, toA, nextB + 1, middleB, toB, out);
    }

    private boolean apart(int a, int b) {
        for (int axis = 0; axis < 3; axis++)
            if (boxes[6 * a + axis] > boxes[6 * b + 3 + axis]
                    || boxes[6 * b + axis] > boxes[6 * a + 3 + axis]) return true;
        return false;
    }

    private void visit(int node, int from, int to, RayHits ray) {
        if (node >= firstLeaf) {
            for (int i = from; i < to; i++) ray.tryFace(faces[i]);
            return;
        }
        int middle = from + to >>> 1;
        int one = 2 * node + 1;
        double first = ray.entry(boxes, 6 * one);
        double second = ray.entry(boxes, 6 * one + 6);
        if (first <= second) {
            if (ray.reaches(first)) visit(one, from, middle, ray);
            if (ray.reaches(second)) visit(one + 1, middle, to, ray);
        } else {
            if (ray.reaches(second)) visit(one + 1, middle, to, ray);
            if (ray.reaches(first)) visit(one, from, middle, ray);
        }
    }
}
