package rasterlab.engine.visibility.order;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.scene.Mesh;

/**
 * A polygon, or a piece of one, which keeps the plane of the whole.
 *
 * @param polygon its number in the input
 * @param corners x, y, z of each corner in the world
 * @param seen the same corners in seen coordinates
 * @param turn 1 if the cross product of each edge's two ends has the polygon on its positive side,
 *     −1 if on its negative one
 * @param cuts those that made this piece
 */
record Facet(
        int polygon, double[] corners, double[] seen, EyePlane plane, int turn, List<Cut> cuts) {
    Facet {
        Bounds.requireSign("turn", turn);
    }

    /** A whole polygon. */
    static Facet whole(int polygon, double[] corners, double[] seen) {
        var face = new int[seen.length / 3];
        for (int i = 0; i < face.length; i++) face[i] = i;
        try {
            var mesh = new Mesh(seen, new int[][] {face});
            double[] normal = NarrowNormal.of(seen);
            var plane = EyePlane.through(seen, normal[0], normal[1], normal[2]);
            double along =
                    mesh.normalX(0) * plane.nx()
                            + mesh.normalY(0) * plane.ny()
                            + mesh.normalZ(0) * plane.nz();
            // det(p₀, p₁, p₂) has the sign of c, which is not above 0, where both normals agree.
            return new Facet(polygon, corners, seen, plane, along > 0 ? -1 : 1, List.of());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(
                    e.getMessage().replaceFirst("^face 0", "polygon " + polygon), e);
        }
    }

    /**
     * The pieces on the near and on the far side of a plane, in this order; both have corners
     * beyond the tolerance.
     */
    List<Facet> cut(EyePlane by) {
        return List.of(side(by, true), side(by, false));
    }

    private Facet side(EyePlane by, boolean near) {
        int sign = near ? 1 : -1;
        var kept = new Corners(seen.length / 3 + 1);
        int count = seen.length / 3;
        for (int i = 0; i < count; i++) {
            int next = (i + 1) % count;
            double here = sign * by.at(seen, i);
            double there = sign * by.at(seen, next);
            if (here >= 0) kept.add(i, next, 0);
            if (here > 0 && there < 0 || here < 0 && there > 0)
                kept.add(i, next, here / (here - there));
        }
        return new Facet(
                polygon, kept.inWorld(), kept.inSeen(), plane, turn, with(Cut.of(plane, by, near)));
    }

    private List<Cut> with(Cut cut) {
        var all = new ArrayList<>(cuts);
        all.add(cut);
        return List.copyOf(all);
    }

    /** The corners of a piece, in both spaces. */
    private final class Corners {
        private final double[] world;
        private final double[] piece;
        private int size;

        Corners(int most) {
            world = new double[3 * most + 3];
            piece = new double[3 * most + 3];
        }

        /** Adds the point at t from corner i to corner j. */
        void add(int i, int j, double t) {
            for (int axis = 0; axis < 3; axis++, size++) {
                world[size] = between(corners[3 * i + axis], corners[3 * j + axis], t);
                piece[size] = between(seen[3 * i + axis], seen[3 * j + axis], t);
            }
        }

        private double between(double from, double to, double t) {
            return t == 0 || from == to ? from : (1 - t) * from + t * to;
        }

        double[] inWorld() {
            return Arrays.copyOf(world, size);
        }

        double[] inSeen() {
            return Arrays.copyOf(piece, size);
        }
    }
}
