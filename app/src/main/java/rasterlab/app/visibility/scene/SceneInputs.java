package rasterlab.app.visibility.scene;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.joml.Vector3d;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.Sight;

/**
 * The scene that is looked at, as inputs of the topics about hidden surfaces. An input that was
 * shown stays itself until it is looked at from elsewhere.
 */
public final class SceneInputs {
    /** Pixels of a picture whose faces an answer can still tell one by one. */
    private static final int WIDTH = 80;

    private static final int HEIGHT = 60;

    private SceneInputs() {}

    /**
     * The faces in a small picture, or in one as large as that of the input that was shown; empty
     * where only depths between two planes are drawn, which no input says.
     */
    public static Optional<SurfaceView> surfaces(VisibilityChoice choice) {
        if (choice.look().near() > 0 || Double.isFinite(choice.look().far()))
            return Optional.empty();
        Scene scene = choice.shown().scene();
        Projection projection = Projection.named(choice.projection());
        Optional<SurfaceView> given = given(choice, SurfaceView.class);
        boolean same =
                given.isPresent()
                        && isSeenAsGiven(choice)
                        && choice.zoom() == 1
                        && given.get().view().transform().projection() == projection;
        if (same) return given;
        PictureFit size =
                given.map(view -> view.view().fit())
                        .orElseGet(() -> new PictureFit(WIDTH, HEIGHT, 1));
        double scale = scene.pictureScale() * choice.zoom();
        return Optional.of(
                SurfaceView.of(
                        scene.mesh(),
                        choice.camera(),
                        projection,
                        PictureFit.of(size.width(), size.height(), scale)));
    }

    /** The body and the eye. */
    public static Body body(VisibilityChoice choice) {
        Optional<Body> given = given(choice, Body.class);
        if (given.isPresent() && isSeenAsGiven(choice)) return given.get();
        Mesh mesh = choice.shown().scene().mesh();
        Vector3d eye = choice.camera().eye();
        int[][] faces =
                IntStream.range(0, mesh.faceCount())
                        .mapToObj(face -> corners(mesh, face))
                        .toArray(int[][]::new);
        return new Body(xyz(mesh), faces, new double[] {eye.x, eye.y, eye.z}, new double[0]);
    }

    /** The faces as the eye sees them: it looks along z, x grows to the right and y upward. */
    public static Sight sight(VisibilityChoice choice) {
        Optional<Sight> given = given(choice, Sight.class);
        if (given.isPresent() && isSeenAsGiven(choice)) return given.get();
        Mesh mesh = choice.shown().scene().mesh();
        var transform = new ViewTransform(choice.camera(), Projection.PERSPECTIVE);
        double[][] polygons =
                IntStream.range(0, mesh.faceCount())
                        .mapToObj(face -> seen(mesh, corners(mesh, face), transform))
                        .toArray(double[][]::new);
        return new Sight(polygons, new double[3]);
    }

    private static <I> Optional<I> given(VisibilityChoice choice, Class<I> type) {
        return choice.shown().given().filter(type::isInstance).map(type::cast);
    }

    private static boolean isSeenAsGiven(VisibilityChoice choice) {
        return choice.camera().equals(choice.shown().scene().defaultCamera());
    }

    private static int[] corners(Mesh mesh, int face) {
        return IntStream.range(0, mesh.cornerCount(face))
                .map(corner -> mesh.corner(face, corner))
                .toArray();
    }

    private static double[] xyz(Mesh mesh) {
        return IntStream.range(0, mesh.vertexCount())
                .mapToObj(v -> List.of(mesh.x(v), mesh.y(v), mesh.z(v)))
                .flatMap(List::stream)
                .mapToDouble(Double::doubleValue)
                .toArray();
    }

    private static double[] seen(Mesh mesh, int[] corners, ViewTransform transform) {
        var seen = new double[3 * corners.length];
        Arrays.setAll(
                seen,
                i -> {
                    int v = corners[i / 3];
                    return transform.toEye(i % 3, mesh.x(v), mesh.y(v), mesh.z(v));
                });
        return seen;
    }
}
