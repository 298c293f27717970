package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;

/** Two pictures beside each other, each higher than wide. */
class FilledPicturesTest {
    private static final int WIDE = 826;
    private static final int HIGH = 620;
    private static final int HALF = (WIDE - StagePictures.GAP) / 2;

    private final StagePictures stage =
            new StagePictures(
                    Renderer.visibilityMethods(),
                    OwnVisibility.of(new OwnMethods(), "depth-order"),
                    WIDE,
                    HIGH);

    private static VisibilityChoice two(String scene) {
        return VisibilityChoice.first().withScene(scene).withComparison("newell");
    }

    @Test
    void sceneIsLargerThanInAPictureOfUsualProportions() {
        VisibilityChoice choice = two("cyclic-overlap");
        assertTrue(
                stage.filling(choice).zoom() >= 1.2 * choice.zoom(),
                () -> "zoom " + stage.filling(choice).zoom() + " of " + choice.zoom());
    }

    @Test
    void zoomEnlargesTwoPicturesByAsMuchAsOne() {
        VisibilityChoice choice = two("cyclic-overlap");
        double filled = stage.filling(choice).zoom();
        for (double factor : new double[] {0.5, 0.8, 1.25, 2})
            assertEquals(filled * factor, stage.filling(choice.zoomed(factor)).zoom(), 1e-9);
    }

    @Test
    void onePictureIsDrawnByTheChosenZoom() {
        VisibilityChoice one = two("cyclic-overlap").withComparison("");
        assertEquals(one, stage.filling(one));
    }

    @ParameterizedTest(name = "a turned scene leaves its picture: {0}")
    @ValueSource(strings = {"cyclic-overlap", "interpenetrating", "coplanar", "torus"})
    void sceneStaysInItsPictureHoweverItIsTurned(String scene) {
        VisibilityChoice choice = two(scene);
        assertTrue(stage.filling(choice).zoom() > choice.zoom(), "the pictures are not filled");
        double rho = choice.camera().rho();
        for (double theta = 0; theta < 6; theta += 0.7)
            for (double phi = 0.1; phi < 3; phi += 0.5)
                requireInside(choice.withCamera(new SphericalView(theta, phi, rho)));
    }

    private void requireInside(VisibilityChoice choice) {
        var view = new ViewTransform(choice.camera(), Projection.named(choice.projection()));
        double scale = stage.filling(choice).zoom() * choice.shown().scene().pictureScale();
        PictureFit fit = PictureFit.of(HALF, HIGH, scale);
        Mesh mesh = choice.shown().scene().mesh();
        for (int v = 0; v < mesh.vertexCount(); v++) {
            double z = view.toEye(2, mesh.x(v), mesh.y(v), mesh.z(v));
            double by = choice.camera().rho() / z;
            double x = fit.toPixelX(by * view.toEye(0, mesh.x(v), mesh.y(v), mesh.z(v)));
            double y = fit.toPixelY(by * view.toEye(1, mesh.x(v), mesh.y(v), mesh.z(v)));
            String place = "(%f, %f) from %s".formatted(x, y, choice.camera());
            assertTrue(x >= 0 && x <= HALF && y >= 0 && y <= HIGH, place);
        }
    }
}
