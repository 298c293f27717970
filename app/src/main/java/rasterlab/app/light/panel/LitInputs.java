package rasterlab.app.light.panel;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.app.light.ColorChoice;
import rasterlab.app.light.Lamp;
import rasterlab.app.light.LightChoice;
import rasterlab.app.light.LightFrame;
import rasterlab.app.light.LightLabState;
import rasterlab.app.light.PointReading;
import rasterlab.app.light.TopicBodies;
import rasterlab.app.light.TopicMesh;
import rasterlab.contract.LitFace;
import rasterlab.engine.color.Colors;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.normals.TriangleSurface;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.SphericalView;

/**
 * Turns what the lab lights into inputs of the topics about light. An input that was shown stays
 * itself until its lamp, its eye or its material is another.
 */
final class LitInputs {
    private LitInputs() {}

    /** The colour as it was written. */
    static Colors color(ColorChoice choice) {
        return Colors.of(choice.model(), choice.in(choice.model()));
    }

    /**
     * The marked point in the light of the selected lamp; empty where no face is, and until its
     * picture is there.
     */
    static Optional<LitPoints> point(LightLabState state) {
        LightChoice choice = state.choice();
        return given(choice, LitPoints.class)
                .filter(input -> isLitAsShown(choice, input))
                .map(input -> input.points().get(0))
                .or(() -> reading(state).flatMap(point -> point.lit(choice)))
                .map(point -> new LitPoints(List.of(point)));
    }

    /** Returns what is told of the marked point, if that is of the present choice. */
    private static Optional<PointReading> reading(LightLabState state) {
        return state.drawn()
                .filter(drawn -> drawn.choice().equals(state.choice()))
                .flatMap(LightFrame.DrawnFrame::point);
    }

    /**
     * The face in the light of the selected lamp, with the points that were given; of any other
     * body the face at the marked point, with that point. Empty where there is none, and for a sun.
     */
    static Optional<FacePoints> face(LightLabState state) {
        LightChoice choice = state.choice();
        Optional<FacePoints> given = given(choice, FacePoints.class);
        if (given.filter(input -> isLitAsShown(choice, input)).isPresent()) return given;
        if (choice.lamp().kind() == Lamp.LampKind.SUN) return Optional.empty();
        return given.map(input -> relit(input, choice))
                .or(() -> reading(state).flatMap(point -> face(point, choice)));
    }

    private static FacePoints relit(FacePoints input, LightChoice choice) {
        double[] corners = input.face().corners();
        double[] moved = TopicMesh.moved(corners, TopicMesh.middle(corners));
        return new FacePoints(lit(moved, input.face().normals(), choice), input.weights());
    }

    private static LitFace lit(double[] corners, double[] normals, LightChoice choice) {
        Lamp lamp = choice.lamp();
        var eye = choice.camera().eye();
        return new LitFace(
                corners,
                normals,
                new double[] {lamp.x(), lamp.y(), lamp.z()},
                new double[] {eye.x, eye.y, eye.z},
                choice.material().material().surface(),
                lamp.source(),
                choice.model().globalAmbient());
    }

    /** The triangle of the face, cut from its first corner, in which the point lies. */
    private static Optional<FacePoints> face(PointReading point, LightChoice choice) {
        Mesh mesh = choice.body().scene().mesh();
        int face = point.face();
        return IntStream.range(1, mesh.cornerCount(face) - 1)
                .mapToObj(second -> new int[] {0, second, second + 1})
                .max(
                        Comparator.comparingDouble(
                                at -> least(shares(corners(mesh, face, at), point.position()))))
                .map(
                        at -> {
                            double[] corners = corners(mesh, face, at);
                            LitFace lit = lit(corners, normals(mesh, face, at), choice);
                            return new FacePoints(lit, inside(shares(corners, point.position())));
                        });
    }

    private static double least(double[] shares) {
        return Arrays.stream(shares).min().orElseThrow();
    }

    /** The shares, for a point that rounding brought over an edge. */
    private static double[] inside(double[] shares) {
        double a = Math.max(0, Math.min(1, shares[0]));
        double b = Math.max(0, Math.min(1 - a, shares[1]));
        return new double[] {a, b, 1 - a - b};
    }

    private static double[] corners(Mesh mesh, int face, int[] at) {
        var xyz = new double[9];
        for (int i = 0; i < 3; i++) {
            int vertex = mesh.corner(face, at[i]);
            xyz[3 * i] = mesh.x(vertex);
            xyz[3 * i + 1] = mesh.y(vertex);
            xyz[3 * i + 2] = mesh.z(vertex);
        }
        return xyz;
    }

    private static double[] normals(Mesh mesh, int face, int[] at) {
        var normals = new double[9];
        Arrays.setAll(normals, i -> mesh.cornerNormal(face, at[i / 3], i % 3));
        return normals;
    }

    /** The share of each corner in the point, by areas seen along the normal. */
    private static double[] shares(double[] abc, double[] point) {
        double[] whole = cross(abc, 0, abc, 3, abc, 6);
        double all = dot(whole, whole);
        double b = dot(whole, cross(abc, 0, point, 0, abc, 6)) / all;
        double c = dot(whole, cross(abc, 0, abc, 3, point, 0)) / all;
        return new double[] {1 - b - c, b, c};
    }

    /** (q − p) × (r − p), each from a place of its array on. */
    private static double[] cross(double[] p, int pAt, double[] q, int qAt, double[] r, int rAt) {
        var u = new double[3];
        var v = new double[3];
        for (int axis = 0; axis < 3; axis++) {
            u[axis] = q[qAt + axis] - p[pAt + axis];
            v[axis] = r[rAt + axis] - p[pAt + axis];
        }
        return new double[] {
            u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** The body's faces as triangles, each face cut from its first corner. */
    static TriangleSurface body(LightChoice choice) {
        return given(choice, TriangleSurface.class)
                .orElseGet(() -> triangles(choice.body().scene().mesh()));
    }

    private static TriangleSurface triangles(Mesh mesh) {
        var xyz = new double[3 * mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            xyz[3 * v] = mesh.x(v);
            xyz[3 * v + 1] = mesh.y(v);
            xyz[3 * v + 2] = mesh.z(v);
        }
        int[] corners =
                IntStream.range(0, mesh.faceCount())
                        .flatMap(
                                face ->
                                        IntStream.range(1, mesh.cornerCount(face) - 1)
                                                .flatMap(
                                                        second ->
                                                                IntStream.of(0, second, second + 1)
                                                                        .map(
                                                                                at ->
                                                                                        mesh.corner(
                                                                                                face,
                                                                                                at))))
                        .toArray();
        return new TriangleSurface(xyz, corners);
    }

    private static <I> Optional<I> given(LightChoice choice, Class<I> type) {
        return TopicBodies.input(choice.body()).filter(type::isInstance).map(type::cast);
    }

    private static boolean isLitAsShown(LightChoice now, Object input) {
        LightChoice then = TopicBodies.shown(now.body().name(), input, "");
        SphericalView eye = then.camera();
        return now.lamps().equals(then.lamps())
                && now.camera().equals(eye)
                && now.material().equals(then.material())
                && now.ambient() == then.ambient()
                && now.line().equals(then.line());
    }
}
