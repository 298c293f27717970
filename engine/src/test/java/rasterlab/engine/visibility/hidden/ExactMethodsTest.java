package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.buffer.NearnessRange;

/**
 * Every method that claims to be right, against the reference, in every projection. Where surfaces
 * coincide, or edges lie on pixel centres, {@link PixelAnswers} says what else is right.
 */
@Tag("slow")
class ExactMethodsTest {
    private static final boolean FULL = Boolean.getBoolean("rasterlab.full");
    private static final int WIDTH = FULL ? 800 : 320;
    private static final int HEIGHT = FULL ? 600 : 240;
    private static final double ALLOWED = 5e-4;
    private static final long SEED = 1972;
    private static final SphericalView CAMERA = new SphericalView(0.13, 1.47, 500);
    private static final List<String> ORDERS = List.of("newell", "bsp");
    private static final List<String> PIXELS = List.of("scanline", "warnock", "raycast");
    private static final List<String> BUFFERS =
            List.of("z16", "z24", "z32", "zfloat", "reversed-z");

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("scenes")
    void fewPixelsAreWrong(Mesh mesh, SphericalView camera, List<String> methods) {
        for (Projection projection : Projection.values()) {
            ViewedMesh view = TestScenes.seen(mesh, camera, projection, WIDTH, HEIGHT);
            Raster exact = TestScenes.exact(view);
            var answers = new PixelAnswers(view);
            for (String method : methods) {
                Raster picture = TestScenes.picture(method, view);
                double share =
                        (double) answers(answers, method, view).wrong(exact, picture)
                                / WIDTH
                                / HEIGHT;
                double allowed = BUFFERS.contains(method) ? ALLOWED : 0;
                assertTrue(
                        share <= allowed,
                        () ->
                                "%s %s, seed %d: share %s"
                                        .formatted(method, projection, SEED, share));
            }
        }
    }

    /**
     * The answers for a method: to a buffer of whole numbers depths within one of its steps are
     * equal.
     */
    private static PixelAnswers answers(PixelAnswers usual, String method, ViewedMesh view) {
        if (!method.equals("z16")) return usual;
        var range = NearnessRange.of(view);
        return new PixelAnswers(view, (range.nearest() - range.farthest()) / 65_534);
    }

    @Test
    @DisplayName("any answer is right")
    void mostPixelsHaveOneRightAnswer() {
        for (String name : List.of("vase", "torus", "cyclic-overlap", "interpenetrating")) {
            var scene = Scenes.named(name);
            var camera = scene.defaultCamera();
            ViewedMesh view = TestScenes.seen(scene.mesh(), camera, Projection.PERSPECTIVE, 64, 48);
            var answers = new PixelAnswers(view);
            Raster exact = TestScenes.exact(view);
            int undecided = 0;
            for (int i = 0; i < 64 * 48; i++) {
                assertTrue(answers.right(exact.argb()[i] - 1, i % 64, i / 64), name + " " + i);
                if (answers.undecided(i % 64, i / 64)) undecided++;
            }
            assertTrue(undecided <= 3, name + ": " + undecided + " pixels");
        }
    }

    private static List<String> all() {
        return Stream.of(ORDERS, PIXELS, BUFFERS).flatMap(List::stream).toList();
    }

    /** Buffers cannot tell the sheets of this scene apart. */
    private static List<String> allFor(Scene scene) {
        return scene.name().equals("coplanar")
                ? Stream.concat(ORDERS.stream(), PIXELS.stream()).toList()
                : all();
    }

    static Stream<Arguments> scenes() {
        List<Arguments> scenes = new ArrayList<>();
        for (var scene : Scenes.all())
            scenes.add(
                    argumentSet(
                            scene.name() + " is wrong",
                            scene.mesh(),
                            scene.defaultCamera(),
                            allFor(scene)));
        scenes.add(argumentSet("circle is not cut", TestScenes.cycle(), CAMERA, all()));
        Mesh crossing = TestScenes.crossing(FULL ? 400 : 60, 60, SEED);
        scenes.add(argumentSet("crossing planes are not split", crossing, CAMERA, all()));
        scenes.add(
                argumentSet(
                        "faces round the eye are refused",
                        crossing,
                        new SphericalView(0.4, 1, 50),
                        all()));
        scenes.add(
                argumentSet(
                        "eye in the middle of a body sees rounding",
                        Scenes.named("interpenetrating").mesh(),
                        new SphericalView(0.4, 1, SphericalView.NEAREST),
                        all()));
        return scenes.stream();
    }

    @Test
    @DisplayName("cut circle shows a wrong pixel, or its splits are not counted")
    void circleIsExactAndItsSplitsAreCounted() {
        for (Projection projection : List.of(Projection.PERSPECTIVE, Projection.PARALLEL)) {
            ViewedMesh view = TestScenes.seen(TestScenes.cycle(), CAMERA, projection, 800, 600);
            Raster exact = TestScenes.exact(view);
            long misled =
                    PictureDifference.of(exact, TestScenes.picture("painter", view)).wrongPixels();
            assertTrue(misled > 1000, "the painter is wrong in " + misled + " pixels only");
            for (String method : ORDERS) {
                assertArrayEquals(exact.argb(), TestScenes.picture(method, view).argb(), method);
                assertTrue(work(method, view).splits() > 0, method);
            }
            for (String method : PIXELS)
                assertArrayEquals(exact.argb(), TestScenes.picture(method, view).argb(), method);
        }
    }

    @Test
    @DisplayName("later of two sheets in one plane is seen, or no buffer fights over them")
    void ofCoplanarSheetsTheEarlierIsSeen() {
        Scene scene = Scenes.named("coplanar");
        for (Projection projection : List.of(Projection.PERSPECTIVE, Projection.CAVALIER)) {
            SphericalView camera = scene.defaultCamera();
            ViewedMesh view = TestScenes.seen(scene.mesh(), camera, projection, 400, 300);
            Raster exact = TestScenes.exact(view);
            for (String method : List.of("newell", "bsp", "scanline", "warnock"))
                assertArrayEquals(exact.argb(), TestScenes.picture(method, view).argb(), method);
            for (String method : List.of("z16", "z24", "zfloat", "reversed-z")) {
                Raster picture = TestScenes.picture(method, view);
                long wrong = PictureDifference.of(exact, picture).wrongPixels();
                assertTrue(wrong > 200, "%s fights over %d pixels".formatted(method, wrong));
            }
        }
    }

    /**
     * The view is so wide that faces become so narrow, beside their depth, that they have no plane.
     */
    @Test
    @DisplayName("an order fails in its own words, or ends never")
    void ordersRefuseAnEyeInTheMiddleOfLongFaces() {
        Mesh boards = Scenes.named("cyclic-overlap").mesh();
        for (Mesh mesh : List.of(boards, TestScenes.crossing(60, 60, SEED))) {
            var camera = new SphericalView(0.4, 1, SphericalView.NEAREST);
            ViewedMesh view = TestScenes.seen(mesh, camera, Projection.PERSPECTIVE, 320, 240);
            for (String method : ORDERS) {
                var refusal =
                        assertThrows(
                                IllegalArgumentException.class,
                                () -> TestScenes.picture(method, view));
                assertTrue(
                        refusal.getMessage()
                                .startsWith(
                                        "the faces, as this view shows them, cannot be put in"
                                                + " order, but a depth buffer may draw them: "),
                        refusal.getMessage());
            }
        }
    }

    @Test
    @DisplayName("bits of a buffer are spent on what is behind the eye")
    void sixteenBitsAreEnoughFromWithinAHall() {
        Scene scene = Scenes.named("near-plane");
        var fit = PictureFit.of(800, 600, scene.pictureScale());
        var transform = new ViewTransform(scene.defaultCamera(), Projection.PERSPECTIVE);
        var view = new ViewedMesh(scene.mesh(), transform, fit);
        Raster exact = TestScenes.exact(view);
        double share = PictureDifference.of(exact, TestScenes.picture("z16", view)).share();
        assertTrue(share <= ALLOWED, "share " + share);
    }

    @Test
    @DisplayName("where two faces meet in pixel centres either is seen")
    void theNearerBesideACommonEdgeIsSeen() {
        Scene scene = Scenes.named("interpenetrating");
        var fit = PictureFit.of(400, 300, scene.pictureScale());
        var transform = new ViewTransform(scene.defaultCamera(), Projection.CAVALIER);
        var view = new ViewedMesh(scene.mesh(), transform, fit);
        Raster exact = TestScenes.exact(view);
        for (String method : List.of("newell", "bsp", "scanline", "warnock", "z32"))
            assertArrayEquals(exact.argb(), TestScenes.picture(method, view).argb(), method);
    }

    private static VisibilityWork work(String method, ViewedMesh view) {
        var out = new Raster(view.fit().width(), view.fit().height());
        return new Visibilities()
                .named(method)
                .implementation()
                .draw(view, TestScenes.numbers(view.mesh()), out, () -> false);
    }

    @Test
    @DisplayName("convex takes an open, a hollow or a double body")
    void convexDrawsABoxAndRefusesWhatIsNone() {
        for (double rho : new double[] {500, 60, 10}) {
            var camera = new SphericalView(0.5, 1.1, rho);
            ViewedMesh box =
                    TestScenes.seen(TestScenes.box(50), camera, Projection.PERSPECTIVE, 320, 240);
            assertEquals(
                    0,
                    PictureDifference.of(TestScenes.exact(box), TestScenes.picture("convex", box))
                            .wrongPixels(),
                    "rho " + rho);
        }
        assertRefused("face 240 has no neighbour", Scenes.named("vase").mesh());
        Mesh one = TestScenes.box(50);
        double[] xyz = new double[48];
        int[][] faces = new int[12][];
        for (int v = 0; v < 8; v++) {
            xyz[3 * v] = one.x(v) - 80;
            xyz[3 * v + 24] = one.x(v) + 80;
            xyz[3 * v + 1] = xyz[3 * v + 25] = one.y(v);
            xyz[3 * v + 2] = xyz[3 * v + 26] = one.z(v);
        }
        for (int f = 0; f < 6; f++) {
            faces[f] = new int[4];
            faces[f + 6] = new int[4];
            for (int k = 0; k < 4; k++) faces[f + 6][k] = 8 + (faces[f][k] = one.corner(f, k));
        }
        assertRefused("lies outside face", new Mesh(xyz, faces));
    }

    private static void assertRefused(String shown, Mesh mesh) {
        ViewedMesh view = TestScenes.seen(mesh, CAMERA, Projection.PERSPECTIVE, 32, 24);
        var refusal =
                assertThrows(
                        IllegalArgumentException.class, () -> TestScenes.picture("convex", view));
        assertTrue(refusal.getMessage().contains(shown), refusal.getMessage());
    }
}
