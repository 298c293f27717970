package rasterlab.engine.visibility.exact;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;

/**
 * Which faces of a mesh are in one plane: the rule by which the earlier of them is seen.
 *
 * <p>Faces are taken from the largest to the smallest, the size being the longest way from the
 * first corner to another; of equal ones the earlier comes first. A face joins the plane of a
 * larger one where
 *
 * <ul>
 *   <li>each of its corners is within {@link #IN_PLANE}·R of that plane, R being the largest
 *       coordinate of the two faces, and
 *   <li>the two normals of length 1, or one of them turned round, differ by at most {@link
 *       #ONE_NORMAL} in each coordinate;
 * </ul>
 *
 * of several such planes it joins that to which its farthest corner is nearest. Otherwise it begins
 * a plane of its own. So each face is in one plane only, the rule does not depend on the view, and
 * faces of one plane have one depth at each pixel: that of the largest. No face is moved by more
 * than the tolerance.
 *
 * <p>The tolerance must bear the rounding of turned coordinates. Turning a point at distance R by a
 * matrix of doubles moves it by at most some 4·2⁻⁵³·R, so that corners which were in one plane
 * leave it by as much, and a small face's distance from a larger one's plane grows by how many
 * times its own size the larger one is away. 2⁻⁴⁰ is 8192 roundings: enough for many turns one
 * after another and for floors of a thousand tiles, and yet a millionth of a millionth of the size
 * of a scene: what is meant to be apart is farther apart. Normals are compared so that a face as
 * small as the tolerance, which is near every plane through its place, joins none that it is
 * inclined to; a rounded face has its normal right to 2⁻²⁰ as long as it is larger than 2⁻³⁰·R.
 */
final class PlaneClasses {
    /** How far off a plane a corner may be, as a share of the largest coordinate. */
    static final double IN_PLANE = 0x1p-40;

    /** The most by which coordinates of two normals in one plane differ. */
    static final double ONE_NORMAL = 0x1p-20;

    /** A direction in the space of planes in which unlike ones mostly are unlike. */
    private static final double[] KEY = {0.5477, 0.4321, 0.3712, 0.6128};

    /** A margin above the most by which the keys of two planes that are one can differ. */
    private static final double KEY_REACH = 0x1p-16;

    private final Mesh mesh;
    private final double[] size;
    private final double[] largest;
    private final int[] plane;
    private final TreeMap<Double, List<Integer>> founders = new TreeMap<>();

    PlaneClasses(Mesh mesh) {
        this.mesh = mesh;
        int faces = mesh.faceCount();
        size = new double[faces];
        largest = new double[faces];
        plane = new int[faces];
        for (int face = 0; face < faces; face++) measure(face);
        double extent = IntStream.range(0, faces).mapToDouble(f -> largest[f]).max().orElse(0);
        IntStream.range(0, faces)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer face) -> -size[face]))
                .forEach(face -> plane[face] = join(face, extent));
    }

    /** The face in whose plane a face is: the largest there. */
    int of(int face) {
        return plane[face];
    }

    private void measure(int face) {
        int first = mesh.corner(face, 0);
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            double x = mesh.x(v) - mesh.x(first);
            double y = mesh.y(v) - mesh.y(first);
            double z = mesh.z(v) - mesh.z(first);
            size[face] = Math.max(size[face], x * x + y * y + z * z);
            double most = Math.max(Math.abs(mesh.x(v)), Math.abs(mesh.y(v)));
            largest[face] = Math.max(largest[face], Math.max(most, Math.abs(mesh.z(v))));
        }
    }

    private int join(int face, double extent) {
        int best = face;
        double nearest = Double.POSITIVE_INFINITY;
        double key = key(face, extent);
        for (List<Integer> near :
                founders.subMap(key - KEY_REACH, true, key + KEY_REACH, true).values())
            for (int founder : near) {
                double distance = distance(face, founder);
                if (distance < nearest
                        && distance <= IN_PLANE * Math.max(largest[face], largest[founder])
                        && oneNormal(face, founder)) {
                    best = founder;
                    nearest = distance;
                }
            }
        if (best == face) founders.computeIfAbsent(key, k -> new ArrayList<>()).add(face);
        return best;
    }

    /**
     * One number for a plane and for it turned round, near ones for near planes: normals within
     * {@link #ONE_NORMAL} move the offset by up to 3 of it, as a share of the extent.
     */
    private double key(int face, double extent) {
        int v = mesh.corner(face, 0);
        double nx = mesh.normalX(face);
        double ny = mesh.normalY(face);
        double nz = mesh.normalZ(face);
        double offset = nx * (mesh.x(v) / extent) + ny * (mesh.y(v) / extent);
        offset += nz * (mesh.z(v) / extent);
        return Math.abs(KEY[0] * nx + KEY[1] * ny + KEY[2] * nz + KEY[3] * offset);
    }

    /** How far the farthest corner of a face is from the plane of another. */
    private double distance(int face, int of) {
        int at = mesh.corner(of, 0);
        double farthest = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            double distance =
                    mesh.normalX(of) * (mesh.x(v) - mesh.x(at))
                            + mesh.normalY(of) * (mesh.y(v) - mesh.y(at))
                            + mesh.normalZ(of) * (mesh.z(v) - mesh.z(at));
            farthest = Math.max(farthest, Math.abs(distance));
        }
        return farthest;
    }

    private boolean oneNormal(int face, int other) {
        return near(face, other, 1) || near(face, other, -1);
    }

    private boolean near(int face, int other, int turn) {
        return Math.abs(mesh.normalX(face) - turn * mesh.normalX(other)) <= ONE_NORMAL
                && Math.abs(mesh.normalY(face) - turn * mesh.normalY(other)) <= ONE_NORMAL
                && Math.abs(mesh.normalZ(face) - turn * mesh.normalZ(other)) <= ONE_NORMAL;
    }
}
