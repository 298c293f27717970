package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.ModelThread;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
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
        Path file = tent(folder);
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

    private Path tent(Path folder) throws IOException {
        return Files.writeString(
                folder.resolve("tent.obj"),
                "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    }

    /** As at the next start. */
    private VisibilityChoice restarted(VisibilityLabModel next) {
        next.bringBack(model.kept());
        next.keptFiles().bringBack(model.keptFiles().kept());
        return next.state().choice();
    }

    private VisibilityLabModel next() {
        return new VisibilityLabModel(
                (request, cancelled) -> new Raster(request.width(), request.height()),
                thread,
                failure -> {
                    throw new AssertionError(failure);
                });
    }

    @Test
    @DisplayName("a model from a file, or its camera, is gone after a restart")
    void modelOfAFileComesBackAsItWasSeen(@TempDir Path folder) throws IOException {
        choose();
        open(tent(folder));
        model.turn(0.3, 0.1);
        model.choose(choice -> choice.zoomed(1.5));
        VisibilityChoice left = model.state().choice();
        try (VisibilityLabModel next = next()) {
            restarted(next);
            assertEquals(model.keptFiles().kept(), next.keptFiles().kept(), "closed too soon");
            thread.settle(next::settle);
            VisibilityChoice opened = next.state().choice();
            assertEquals("tent.obj", opened.scene());
            assertEquals(left.camera(), opened.camera());
            assertEquals(left.zoom(), opened.zoom());
            assertEquals(left.look(), opened.look());
            assertEquals(left.visibility(), opened.visibility());
            assertFalse(next.history().undoable(), "opening is something to undo");
            assertEquals(model.keptFiles().kept(), next.keptFiles().kept());
            assertEquals("", next.state().problem());
        }
    }

    @Test
    @DisplayName("a picture on the lab's own scene is gone after a restart")
    void pictureOnASceneComesBack(@TempDir Path folder) throws IOException {
        model.choose(choice -> choice.withScene("globe"));
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        open(file);
        try (VisibilityLabModel next = next()) {
            restarted(next);
            thread.settle(next::settle);
            assertEquals(Optional.of(file), next.state().choice().shown().image());
            assertEquals("globe", next.state().choice().scene());
        }
    }

    @Test
    @DisplayName("a file that is gone leaves the lab empty, or is asked for at every start")
    void sceneOfTheLabStandsForAFileThatIsGone(@TempDir Path folder) throws IOException {
        Path file = tent(folder);
        open(file);
        Files.delete(file);
        try (VisibilityLabModel next = next()) {
            VisibilityChoice inItsPlace = restarted(next);
            thread.settle(next::settle);
            assertEquals(inItsPlace, next.state().choice());
            String problem = next.state().problem();
            assertEquals(file + ": no such file to read; the scene vase is shown instead", problem);
            assertEquals(
                    file + ": такого файла нет; вместо неё показана сцена vase",
                    Complaints.said(Language.RUSSIAN, problem));
            assertEquals(OpenedFiles.NONE, next.keptFiles().kept());
        }
    }

    @Test
    @DisplayName("a file that is read late takes the place of what was chosen meanwhile")
    void laterChoiceStays(@TempDir Path folder) throws IOException {
        open(tent(folder));
        try (VisibilityLabModel next = next()) {
            restarted(next);
            next.choose(choice -> choice.withScene("globe"));
            assertEquals(OpenedFiles.NONE, next.keptFiles().kept());
            thread.settle(next::settle);
            assertEquals("globe", next.state().choice().scene());
        }
    }
}
