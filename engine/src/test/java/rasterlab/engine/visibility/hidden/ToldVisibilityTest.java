package rasterlab.engine.visibility.hidden;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.contract.DepthOrder;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.pipeline.FaceDrawing;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.WrongLength;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityStep;
import rasterlab.engine.visibility.faces.VisibleFacesTopic;
import rasterlab.engine.visibility.order.DepthOrderTopic;
import rasterlab.engine.visibility.painter.PiecesWalk;

/** Pictures drawn by methods that the renderer is given instead of their names. */
class ToldVisibilityTest {
    private static final String MINE = "mine";

    private final Renderer renderer = new Renderer();

    @AfterEach
    void close() {
        renderer.close();
    }

    private static RenderRequest request(String scene, String visibility, Projection projection) {
        Scene shown = Scenes.named(scene);
        return new RenderRequest(
                shown, visibility, "flat", projection.code(), shown.defaultCamera(), 200, 150);
    }

    private static RenderRequest given(String scene, Visibility method) {
        RenderRequest named = request(scene, "none", Projection.PERSPECTIVE);
        return named.with(named.look().withVisibility(MINE, method));
    }

    private Raster drawn(RenderRequest request) {
        return renderer.render(request, () -> false);
    }

    private static VisibleFaces backFace() {
        return new VisibleFacesTopic().method("back-face").implementation();
    }

    private static DepthOrder order(String name) {
        return new DepthOrderTopic().method(name).implementation();
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube", "vase"})
    void facesThatAMethodCallsVisibleAreThoseOfTheMethodOfThatName(String scene) {
        assertArrayEquals(
                drawn(request(scene, "back-face", Projection.PERSPECTIVE)).argb(),
                drawn(given(scene, Visibilities.by(backFace()))).argb());
    }

    @Test
    void whatItDoesNotCallVisibleIsNotDrawn() {
        VisibleFaces none = (xyz, faces, eye, inside) -> new boolean[faces.length];
        int[] pixels = drawn(given("cube", Visibilities.by(none))).argb();
        int background = 0xFF000000 | Scenes.named("cube").backgroundRgb();
        for (int pixel : pixels) assertEquals(background, pixel);
    }

    @Test
    void itIsToldWhereTheEyeIsInTheWorld() {
        var eyes = new ArrayList<double[]>();
        VisibleFaces asked =
                (xyz, faces, eye, inside) -> {
                    eyes.add(eye);
                    return backFace().visible(xyz, faces, eye, inside);
                };
        RenderRequest request = given("cube", Visibilities.by(asked));
        drawn(request);
        double rho = request.camera().rho();
        double[] eye = eyes.get(0);
        assertEquals(1, eyes.size());
        assertEquals(rho, Math.sqrt(eye[0] * eye[0] + eye[1] * eye[1] + eye[2] * eye[2]), 1e-9);
    }

    @Test
    void anAnswerForFewerFacesIsRefused() {
        VisibleFaces two = (xyz, faces, eye, inside) -> new boolean[2];
        var refusal =
                assertThrows(WrongLength.class, () -> drawn(given("cube", Visibilities.by(two))));
        assertEquals(2, refusal.got());
    }

    @Test
    void aParallelViewHasNoEyeToTellOf() {
        RenderRequest named = request("cube", "none", Projection.ISOMETRIC);
        RenderRequest request =
                named.with(named.look().withVisibility(MINE, Visibilities.by(backFace())));
        var refusal = assertThrows(IllegalArgumentException.class, () -> drawn(request));
        assertTrue(refusal.getMessage().contains("perspective"), refusal.getMessage());
    }

    @ParameterizedTest
    @ValueSource(strings = {"cube", "vase", "cyclic-overlap"})
    void anOrderWithPiecesDrawsTheExactPicture(String scene) {
        Raster exact = drawn(request(scene, Renderer.REFERENCE, Projection.PERSPECTIVE));
        Raster actual = drawn(given(scene, Visibilities.by(order("bsp"))));
        assertEquals(0, PictureDifference.of(exact, actual).wrongPixels());
    }

    @Test
    void aWrongOrderIsSeen() {
        DepthOrder backwards =
                (polygons, eye, out) -> {
                    var pieces = new ArrayList<Object[]>();
                    order("bsp")
                            .order(polygons, eye, (k, xyz) -> pieces.add(0, new Object[] {k, xyz}));
                    pieces.forEach(one -> out.piece((Integer) one[0], (double[]) one[1]));
                };
        Raster exact = drawn(request("vase", Renderer.REFERENCE, Projection.PERSPECTIVE));
        Raster actual = drawn(given("vase", Visibilities.by(backwards)));
        assertTrue(PictureDifference.of(exact, actual).wrongPixels() > 100);
    }

    @Test
    void itsStepsAreThePiecesInItsOrder() {
        RenderRequest request = given("cyclic-overlap", Visibilities.by(order("bsp")));
        FaceDrawing drawing = FaceDrawing.of(request).orElseThrow();
        assertTrue(drawing.hasSteps());
        var walk = (PiecesWalk) drawing.walk(drawing.blank());
        int steps = 0;
        int cut = 0;
        while (walk.advance()) {
            var step = assertInstanceOf(VisibilityStep.FaceDrawn.class, walk.step());
            assertEquals(++steps, step.value());
            if (walk.piece().isPresent()) cut++;
        }
        assertTrue(cut > 0 && steps > cut, steps + " steps, " + cut + " pieces");
    }

    @Test
    void aPieceOfNoPolygonIsRefused() {
        DepthOrder beyond = (polygons, eye, out) -> out.piece(polygons.length, polygons[0]);
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> drawn(given("cube", Visibilities.by(beyond))));
        assertTrue(refusal.getMessage().startsWith("piece 0: polygon must be from 0 to "));
    }

    @Test
    void aPieceBehindTheEyeIsRefused() {
        DepthOrder behind =
                (polygons, eye, out) -> out.piece(0, new double[] {0, 0, 1, 1, 0, 1, 0, 1, -1});
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> drawn(given("cube", Visibilities.by(behind))));
        assertTrue(refusal.getMessage().endsWith("got z = -1.0"), refusal.getMessage());
    }

    @Test
    void aGivenMethodHasANameOfItsOwn() {
        RenderRequest named = request("cube", "none", Projection.PERSPECTIVE);
        for (String taken : List.of("bsp", Renderer.AUTO, Renderer.REFERENCE, Renderer.SURFACES))
            assertThrows(
                    IllegalArgumentException.class,
                    () -> named.look().withVisibility(taken, Visibilities.by(backFace())));
    }

    @Test
    void anotherNameTakesItsPlaceAgain() {
        RenderRequest request = given("cube", Visibilities.by(backFace()));
        assertFalse(request.withVisibility("bsp").look().given().isPresent());
    }
}
