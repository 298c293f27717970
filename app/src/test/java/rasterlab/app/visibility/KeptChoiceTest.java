package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.Cameras;
import rasterlab.app.visibility.scene.OpenedFiles;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.app.visibility.scene.VisibilityChoice;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.obj.UpAxis;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.transform.SphericalView;

class KeptChoiceTest {
    private static final String UP =
            ": y is taken to point up; the chooser of the axis turns the model";

    private static final double ROUNDING = 1e-9;

    private final ModelThread thread = new ModelThread();
    private final VisibilityLabModel model =
            new VisibilityLabModel(
                    new OwnMethods(),
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
        model.dolly(1.25);
        model.choose(choice -> choice.zoomed(2));
    }

    private void open(Path file) {
        model.open(file);
        thread.settle(model::settle);
        boolean model = file.toString().endsWith(".obj");
        assertEquals(model ? file + UP : "", this.model.state().problem());
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
        model.dolly(1.25);
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

    /** The choice as at the next start. */
    private VisibilityChoice restarted(VisibilityLabModel next) {
        next.restore(model.kept());
        next.keptFiles().restore(model.keptFiles().kept());
        return next.state().choice();
    }

    private VisibilityLabModel next() {
        return new VisibilityLabModel(
                new OwnMethods(),
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
                    Complaints.translated(Language.RUSSIAN, problem));
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

    @Test
    @DisplayName("what was chosen while a file was read is taken back when it is shown")
    void choicesMeanwhileStay(@TempDir Path folder) throws IOException {
        choose();
        open(tent(folder));
        VisibilityChoice left = model.state().choice();
        try (VisibilityLabModel next = next()) {
            restarted(next);
            next.choose(choice -> choice.zoomed(1.25).with(choice.look().withCue(0.4)));
            next.turn(0.25, 0);
            thread.settle(next::settle);
            VisibilityChoice opened = next.state().choice();
            assertEquals("tent.obj", opened.scene());
            assertEquals(1.25 * left.zoom(), opened.zoom(), ROUNDING);
            assertEquals(0.4, opened.look().cue());
            SphericalView turned = Cameras.turned(left.camera(), 0.25, 0);
            assertEquals(turned.thetaRadians(), opened.camera().thetaRadians(), ROUNDING);
            assertEquals(turned.rho(), opened.camera().rho(), ROUNDING * turned.rho());
        }
    }

    @Test
    @DisplayName("a broken file opened meanwhile costs the scene that is coming back, unsaid")
    void brokenFileDoesNotStopOneThatComesBack(@TempDir Path folder) throws IOException {
        open(tent(folder));
        Path broken = Files.writeString(folder.resolve("broken.obj"), "v 0 zero 0\n");
        try (VisibilityLabModel next = next()) {
            restarted(next);
            next.open(broken);
            thread.settle(next::settle);
            thread.settle(next::settle);
            assertEquals("tent.obj", next.state().choice().scene());
            String problem = next.state().problem();
            assertTrue(problem.startsWith(broken + ":1"), problem);
        }
    }

    @Test
    @DisplayName(
            "a scene that is gone, or a broken file opened meanwhile, is told for a moment only")
    void goneFileIsToldBesideABrokenOne(@TempDir Path folder) throws IOException {
        Path file = tent(folder);
        open(file);
        Files.delete(file);
        try (VisibilityLabModel next = next()) {
            restarted(next);
            Path broken = Files.writeString(folder.resolve("broken.obj"), "v 0 zero 0\n");
            next.open(broken);
            thread.settle(next::settle);
            thread.settle(next::settle);
            String second = file + ": no such file to read; the scene vase is shown instead";
            String both = next.state().problem();
            assertTrue(both.endsWith("; besides, " + second), both);
            String first = both.substring(0, both.length() - ("; besides, " + second).length());
            assertTrue(first.startsWith(broken + ":1"), first);
            assertFalse(first.contains("besides"), first);
            assertEquals(
                    Complaints.translated(Language.RUSSIAN, first)
                            + "; кроме того, "
                            + Complaints.translated(Language.RUSSIAN, second),
                    Complaints.translated(Language.RUSSIAN, both));
        }
    }

    @Test
    @DisplayName("a picture that has lost its colours costs the scene for the environment chosen")
    void decalIsGivenUpForAGrayPicture(@TempDir Path folder) throws IOException {
        model.choose(choice -> choice.withScene("globe"));
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        open(file);
        var decal = Optional.of(TextureEnvironment.Mode.DECAL);
        model.choose(choice -> choice.with(choice.look().withEnvironment(decal).withCue(0.4)));
        assertEquals(decal, model.state().choice().look().change().environment());
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_BYTE_GRAY), "png", file.toFile());
        try (VisibilityLabModel next = next()) {
            restarted(next);
            thread.settle(next::settle);
            assertEquals("", next.state().problem());
            VisibilityChoice opened = next.state().choice();
            assertEquals(Optional.of(file), opened.shown().image());
            assertEquals(1, opened.shown().fewestComponents());
            assertEquals(Optional.empty(), opened.look().change().environment());
            assertEquals(0.4, opened.look().cue());
        }
    }

    @Test
    @DisplayName("a scene that cannot be seen as it was is dropped without a word of its file")
    void fileOfAViewThatIsNotIsNamed(@TempDir Path folder) throws IOException {
        Path file = tent(folder);
        VisibilityChoice before = model.state().choice();
        model.keptFiles()
                .restore(
                        new OpenedFiles(
                                Optional.of(
                                        new OpenedFiles.View(
                                                Optional.of(file),
                                                Optional.empty(),
                                                before.camera(),
                                                99,
                                                before.look())),
                                UpAxis.Y));
        thread.settle(model::settle);
        assertEquals(before, model.state().choice());
        String problem = model.state().problem();
        assertEquals(
                file
                        + ": zoom must be in [0.25, 32.0], got 99.0; the scene vase is shown"
                        + " instead",
                problem);
        assertEquals(
                file
                        + ": увеличение должно быть в [0,25; 32], получено 99; вместо неё показана"
                        + " сцена vase",
                Complaints.translated(Language.RUSSIAN, problem));
    }

    @Test
    @DisplayName("a texture without colours is refused for a decal in English")
    void missingColorsAreSaidInBothLanguages() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> new TextureEnvironment(TextureEnvironment.Mode.DECAL, 1, 0));
        assertEquals(
                "режиму DECAL нужна текстура из 3 или 4 компонентов, получено 1",
                Complaints.translated(Language.RUSSIAN, refused.getMessage()));
    }

    @Test
    @DisplayName("a picture that is gone takes the model under it with it")
    void modelComesBackWithoutAPictureThatIsGone(@TempDir Path folder) throws IOException {
        Path model =
                Files.writeString(
                        folder.resolve("wall.obj"),
                        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                + "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n");
        Path picture = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", picture.toFile());
        open(model);
        open(picture);
        this.model.turn(0.3, 0.1);
        VisibilityChoice left = this.model.state().choice();
        Files.delete(picture);
        try (VisibilityLabModel next = next()) {
            restarted(next);
            thread.settle(next::settle);
            VisibilityChoice opened = next.state().choice();
            assertEquals("wall.obj", opened.scene());
            assertEquals(Optional.empty(), opened.shown().image());
            assertEquals(left.camera(), opened.camera());
            String problem = next.state().problem();
            assertEquals(
                    picture
                            + ": no such file to read; the scene wall.obj is shown without the"
                            + " picture",
                    problem);
            assertEquals(
                    picture + ": такого файла нет; сцена wall.obj показана без изображения",
                    Complaints.translated(Language.RUSSIAN, problem));
        }
    }
}
