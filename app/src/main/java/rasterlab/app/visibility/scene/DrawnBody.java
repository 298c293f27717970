package rasterlab.app.visibility.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.engine.polygon.Points;
import rasterlab.engine.polygon.triangulation.Triangles;
import rasterlab.engine.polygon.triangulation.TriangulateTopic;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.faces.SeenFaces;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;

/**
 * A body that is drawn: as it is where the tab's methods can be given the same; otherwise only what
 * a method of the topic calls visible of it.
 *
 * @param mesh about the mean of the corners
 * @param numbers of the body's face that each face of the mesh is, or is a part of
 * @param eye x, y, z from the mean of the corners
 * @param radius to the farthest corner
 * @param drawnBy the visibility method that draws it; empty where any may
 */
record DrawnBody(
        Mesh mesh,
        int[] numbers,
        double[] eye,
        double radius,
        Optional<String> drawnBy,
        List<ShownDifference> differences) {
    /** Draws faces in their order, as is done with those that a method calls visible. */
    private static final String AS_FOUND = "none";

    /** Draws all faces, where no method has said which are visible. */
    private static final String ALL = "raycast";

    /** World units to the farthest corner of a body whose own magnitude no eye can look at. */
    private static final double REACH = 64;

    private static final double[] UNKNOWN = {};

    static DrawnBody of(Body body, String method) {
        double[] middle = new Body(body.xyz(), body.faces(), body.eye(), UNKNOWN).insideOrMean();
        double[] xyz = TopicView.minus(body.xyz(), middle);
        double[] eye = TopicView.minus(body.eye(), middle);
        double rho = length(eye, 0);
        boolean near = TopicView.reachable(rho) && farthest(xyz) >= SphericalView.NEAREST;
        int exponent = near ? 0 : Math.getExponent(REACH / farthest(xyz));
        double[] sized = scaled(xyz, exponent);
        int[] all = IntStream.range(0, body.faces().length).toArray();
        boolean known = body.inside().length > 0;
        Optional<Mesh> whole = near && !known ? mesh(sized, body.faces()) : Optional.empty();
        double[] from = scaled(eye, exponent);
        return whole.map(
                        mesh ->
                                new DrawnBody(
                                        mesh,
                                        all,
                                        from,
                                        farthest(sized),
                                        Optional.empty(),
                                        List.of()))
                .orElseGet(() -> found(body, method, sized, from, exponent));
    }

    private static DrawnBody found(
            Body body, String method, double[] xyz, double[] eye, int exponent) {
        var differences = new ArrayList<ShownDifference>();
        Optional<SeenFaces> found = visible(body, method);
        int[] drawn =
                IntStream.range(0, body.faces().length)
                        .filter(face -> found.isEmpty() || found.get().visible(face))
                        .toArray();
        differences.add(
                found.isEmpty()
                        ? ShownDifference.of(ShownDifference.ShownDifferenceKind.FACES_ALL)
                        : ShownDifference.of(
                                ShownDifference.ShownDifferenceKind.FACES_FOUND,
                                method,
                                drawn.length,
                                found.get().size()));
        if (exponent != 0)
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.SCALED, exponent));
        var faces = new ArrayList<int[]>();
        var numbers = new ArrayList<Integer>();
        boolean all = true;
        for (int face : drawn) {
            List<int[]> pieces = pieces(xyz, body.faces()[face]);
            all &= !pieces.isEmpty();
            faces.addAll(pieces);
            pieces.forEach(piece -> numbers.add(face));
        }
        if (!all)
            differences.add(
                    ShownDifference.of(ShownDifference.ShownDifferenceKind.FACES_WITHOUT_AREA));
        return new DrawnBody(
                new Mesh(xyz, faces.toArray(int[][]::new)),
                numbers.stream().mapToInt(Integer::intValue).toArray(),
                eye,
                farthest(xyz),
                Optional.of(found.isEmpty() ? ALL : AS_FOUND),
                differences);
    }

    /** The faces seen; empty where the method refuses, or none is asked. */
    private static Optional<SeenFaces> visible(Body body, String method) {
        if (method.isEmpty()) return Optional.empty();
        var topic = new VisibleFacesTopic();
        try {
            return Optional.of(
                    topic.record(topic.method(method).implementation(), body, body.faces().length));
        } catch (IllegalArgumentException refused) {
            return Optional.empty();
        }
    }

    private static Optional<Mesh> mesh(double[] xyz, int[]... faces) {
        try {
            return Optional.of(new Mesh(xyz, faces));
        } catch (IllegalArgumentException broken) {
            return Optional.empty();
        }
    }

    /** The face itself, or the triangles that it is cut into, of those with an area. */
    private static List<int[]> pieces(double[] xyz, int[] face) {
        if (mesh(xyz, face).isPresent()) return List.of(face);
        var pieces = new ArrayList<int[]>();
        Triangles cut = triangles(xyz, face);
        for (int t = 0; t < cut.size(); t++) {
            int[] piece = {face[cut.corner(t, 0)], face[cut.corner(t, 1)], face[cut.corner(t, 2)]};
            if (mesh(xyz, piece).isPresent()) pieces.add(piece);
        }
        return pieces;
    }

    /**
     * The triangles of a face seen along the axis in which it is flattest, so that they go round as
     * it does.
     */
    private static Triangles triangles(double[] xyz, int[] face) {
        var n = new double[3];
        for (int i = 0; i < face.length; i++)
            for (int axis = 0; axis < 3; axis++)
                n[axis] += across(xyz, face[i], face[(i + 1) % face.length], axis);
        int flattest = 0;
        for (int axis = 1; axis < 3; axis++)
            if (Math.abs(n[axis]) > Math.abs(n[flattest])) flattest = axis;
        int right = (flattest + 1) % 3;
        int up = (flattest + 2) % 3;
        var corners =
                new Points(
                        Arrays.stream(face).mapToDouble(v -> xyz[3 * v + right]).toArray(),
                        Arrays.stream(face).mapToDouble(v -> xyz[3 * v + up]).toArray());
        var topic = new TriangulateTopic();
        try {
            return topic.record(
                    topic.method("ear-clipping").implementation(), corners, topic.mostItems());
        } catch (IllegalArgumentException noArea) {
            return new Triangles(); // Only what is no polygon is refused.
        }
    }

    /** A coordinate of the cross product of two corners. */
    private static double across(double[] xyz, int a, int b, int axis) {
        int right = (axis + 1) % 3;
        int up = (axis + 2) % 3;
        return xyz[3 * a + right] * xyz[3 * b + up] - xyz[3 * a + up] * xyz[3 * b + right];
    }

    private static double farthest(double[] xyz) {
        double farthest = 0;
        for (int i = 0; i < xyz.length; i += 3) farthest = Math.max(farthest, length(xyz, i));
        return farthest;
    }

    private static double length(double[] xyz, int at) {
        return Math.hypot(Math.hypot(xyz[at], xyz[at + 1]), xyz[at + 2]);
    }

    /** Times a power of two, which rounds nothing. */
    private static double[] scaled(double[] xyz, int exponent) {
        return Arrays.stream(xyz).map(x -> Math.scalb(x, exponent)).toArray();
    }
}
