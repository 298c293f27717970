package rasterlab.app.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.normals.NormalsTopic;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.SphericalView;

/**
 * The surface of an input of a topic about light.
 *
 * @param differences in what it is other than the input's
 */
public record TopicMesh(Mesh mesh, List<ShownDifference> differences) {
    /** World units from the middle to the farthest corner of a body that has no lamp and eye. */
    private static final double REACH = 64;

    /** Half the side of the face around a single point; its light is nearly that of the point. */
    private static final double PATCH = 0.02;

    /** Faces along and across a floor, and world units by which it goes on. */
    private static final int TILES = 24;

    private static final double BEYOND = 0.7;

    /** Lengths of the first edge by which a corner is moved off it. */
    private static final double ASIDE = 2;

    private static final double UNIT = 1e-9;

    /**
     * @param method of topic {@code vertex-normals} whose normals the corners have; "" for none
     */
    static TopicMesh of(Object input, String method) {
        if (input instanceof FacePoints points) return face(points.face());
        if (input instanceof LitPoints points) return point(points.points().get(0));
        return body((TriangleSurface) input, method);
    }

    private static TopicMesh face(LitFace face) {
        double[] corners = moved(face.corners(), middle(face.corners()));
        try {
            return new TopicMesh(triangle(corners, face.normals()), List.of());
        } catch (IllegalArgumentException noArea) {
            return new TopicMesh(
                    triangle(bent(corners, face.normals()), face.normals()),
                    List.of(ShownDifference.of(ShownDifference.ShownDifferenceKind.CORNER_MOVED)));
        }
    }

    /** Corners on a line, the last of them moved off it, square to the first normal. */
    private static double[] bent(double[] corners, double[] n) {
        double x = corners[3] - corners[0];
        double y = corners[4] - corners[1];
        double z = corners[5] - corners[2];
        double[] bent = corners.clone();
        bent[6] += ASIDE * (n[1] * z - n[2] * y);
        bent[7] += ASIDE * (n[2] * x - n[0] * z);
        bent[8] += ASIDE * (n[0] * y - n[1] * x);
        return moved(bent, middle(bent));
    }

    private static TopicMesh point(LitPoint point) {
        var spot = SpotPlace.of(point);
        if (spot.isPresent()) return new TopicMesh(floor(spot.get().x()), List.of());
        if (point.distance() == 0) return new TopicMesh(floor(0), List.of());
        double[] corners = {-PATCH, -PATCH, 0, 2 * PATCH, -PATCH, 0, -PATCH, 2 * PATCH, 0};
        double[] n = point.normal();
        double[] normals = IntStream.range(0, corners.length).mapToDouble(i -> n[i % 3]).toArray();
        return new TopicMesh(
                triangle(corners, normals),
                Math.abs(UnitVector.length(n) - 1) <= UNIT
                        ? List.of()
                        : List.of(
                                ShownDifference.of(
                                        ShownDifference.ShownDifferenceKind.NORMAL_LENGTH,
                                        n[0],
                                        n[1],
                                        n[2])));
    }

    /**
     * A floor level with the point, from beyond it to beyond the middle, to see the light around
     * it.
     */
    private static Mesh floor(double pointX) {
        double from = Math.min(0, pointX) - BEYOND;
        double wide = Math.abs(pointX) + 2 * BEYOND;
        int across = TILES + 1;
        var xyz = new double[3 * across * across];
        var faces = new ArrayList<int[]>();
        for (int i = 0; i < across * across; i++) {
            xyz[3 * i] = from + wide * (i % across) / TILES;
            xyz[3 * i + 1] = wide * ((double) (i / across) / TILES - 0.5);
            if (i % across < TILES && i / across < TILES)
                faces.add(new int[] {i, i + 1, i + across + 1, i + across});
        }
        return new Mesh(xyz, faces.toArray(int[][]::new));
    }

    private static Mesh triangle(double[] corners, double[] normals) {
        return new Mesh(corners, new int[][] {{0, 1, 2}}).withNormals(unit(normals));
    }

    /** Each brought to length 1; (0, 0, 0) becomes the z axis. */
    private static double[] unit(double[] normals) {
        var unit = new double[normals.length];
        for (int i = 0; i < normals.length; i += 3) {
            double[] one = Arrays.copyOfRange(normals, i, i + 3);
            if (!UnitVector.normalize(one)) one[2] = 1;
            System.arraycopy(one, 0, unit, i, 3);
        }
        return unit;
    }

    /** Made larger by a power of two, which changes no normal. */
    private static TopicMesh body(TriangleSurface bare, String method) {
        var differences = new ArrayList<ShownDifference>();
        double[] xyz = moved(bare.vertices(), middle(bare.vertices()));
        int exponent = Math.getExponent(REACH / largest(xyz));
        if (!(largest(bare.vertices()) >= SphericalView.NEAREST))
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.SCALED, exponent));
        double[] larger = Arrays.stream(xyz).map(x -> Math.scalb(x, exponent)).toArray();
        var faces = new ArrayList<int[]>();
        int[] corners = bare.triangles();
        for (int at = 0; at < corners.length; at += 3) {
            int[] face = Arrays.copyOfRange(corners, at, at + 3);
            if (hasArea(larger, face)) faces.add(face);
        }
        if (faces.size() < corners.length / 3)
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.FACES_WITHOUT_AREA));
        var mesh = new Mesh(larger, faces.toArray(int[][]::new));
        if (!method.isEmpty()) mesh = withNormals(mesh, bare, method, differences);
        return new TopicMesh(mesh, List.copyOf(differences));
    }

    private static boolean hasArea(double[] xyz, int[] face) {
        try {
            return new Mesh(xyz, new int[][] {face}).faceCount() == 1;
        } catch (IllegalArgumentException noArea) {
            return false;
        }
    }

    /** The normals that the method finds for the input's own numbers. */
    private static Mesh withNormals(
            Mesh mesh, TriangleSurface bare, String method, List<ShownDifference> differences) {
        var topic = new NormalsTopic();
        double[] found =
                topic.record(topic.method(method).implementation(), bare, Integer.MAX_VALUE)
                        .coordinates();
        var normals = new double[3 * mesh.totalCorners()];
        var kinds = EnumSet.noneOf(ShownDifference.ShownDifferenceKind.class);
        for (int f = 0; f < mesh.faceCount(); f++)
            for (int c = 0; c < mesh.cornerCount(f); c++) {
                int at = 3 * mesh.corner(f, c);
                double[] one = Arrays.copyOfRange(found, at, at + 3);
                double length = UnitVector.length(one);
                if (!(Math.abs(length - 1) <= UNIT))
                    kinds.add(ShownDifference.ShownDifferenceKind.NORMALS_LENGTHENED);
                if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
                    kinds.add(ShownDifference.ShownDifferenceKind.FACE_NORMAL);
                    for (int axis = 0; axis < 3; axis++) one[axis] = mesh.cornerNormal(f, c, axis);
                }
                UnitVector.normalize(one);
                System.arraycopy(one, 0, normals, 3 * (mesh.firstCorner(f) + c), 3);
            }
        if (kinds.contains(ShownDifference.ShownDifferenceKind.FACE_NORMAL))
            kinds.remove(ShownDifference.ShownDifferenceKind.NORMALS_LENGTHENED);
        kinds.forEach(kind -> differences.add(ShownDifference.of(kind)));
        return mesh.withNormals(normals);
    }

    private static double largest(double[] xyz) {
        return Arrays.stream(xyz).map(Math::abs).max().orElse(0);
    }

    public static double[] middle(double[] xyz) {
        var middle = new double[3];
        for (int i = 0; i < xyz.length; i++) middle[i % 3] += xyz[i] / (xyz.length / 3);
        return middle;
    }

    public static double[] moved(double[] xyz, double[] middle) {
        var moved = new double[xyz.length];
        for (int i = 0; i < xyz.length; i++) moved[i] = xyz[i] - middle[i % 3];
        return moved;
    }
}
