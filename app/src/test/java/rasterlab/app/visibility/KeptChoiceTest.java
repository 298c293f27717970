package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.ModelThread;
import rasterlab.engine.raster.Raster;

class KeptChoiceTest {
    private static final double ROUNDING = 1e-9;

    private final ModelThread thread = new ModelThread();
    private final VisibilityLabModel model =
            new VisibilityLabModel(
                    (request, cancelled) -> new Raster(request.width(), request.height()),
                    thread,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        model.close();
    }

    private void choose() {
        model.choose(
                choice ->
                        choice.withVisibility("warnock")
                                .withComparison("z24")
                                .withShading("phong")
                                .withProjection("isometric")
                                .withView(StageView.DEPTHS));
        model.turn(0.7, 0.2);
        model.retreat(1.25);
        model.choose(choice -> choice.zoomed(2));
    }

    private void open(Path file) {
        model.open(file);
        thread.settle(model::settle);
        assertEquals("", model.state().problem());
    }

    @Test
    @DisplayName("a model from a file makes the lab forget method, camera and view")
    void keepsWhatDoesNotDependOnTheFile(@TempDir Path folder) throws IOException {
        choose();
        VisibilityChoice vase = model.state().choice();
        Path file =
                Files.writeString(
                        folder.resolve("tent.obj"),
                        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
        open(file);
        model.look(
                Cameras.turned(
                        model.state().choice().camera(),
                        vase.camera().thetaRadians()
                                - model.state().choice().camera().thetaRadians(),
                        vase.camera().phiRadians() - model.state().choice().camera().phiRadians()));
        model.retreat(1.25);
        model.choose(choice -> choice.zoomed(2));

        VisibilityChoice kept = model.kept();
        assertEquals(vase.camera().thetaRadians(), kept.camera().thetaRadians(), ROUNDING);
        assertEquals(vase.camera().phiRadians(), kept.camera().phiRadians(), ROUNDING);
        assertEquals(vase.camera().rho(), kept.camera().rho(), ROUNDING * vase.camera().rho());
        assertEquals(vase, kept.withCamera(vase.camera()));
    }

    @Test
    @DisplayName("a picture on the lab's own scene makes the lab forget the scene")
    void keepsTheSceneUnderAPicture(@TempDir Path folder) throws IOException {
        model.choose(choice -> choice.withScene("globe"));
        choose();
        VisibilityChoice globe = model.state().choice();
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        open(file);
        assertEquals(globe, model.kept());
    }
}
