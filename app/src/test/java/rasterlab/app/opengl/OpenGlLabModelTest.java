package rasterlab.app.opengl;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.language.Complaints;
import rasterlab.app.language.Language;
import rasterlab.app.opengl.call.GlCall;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.software.Deviations;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.outcome.Pipe;
import rasterlab.engine.raster.Raster;

@Tag("slow")
class OpenGlLabModelTest {
    private static final GlReport REPORT = new GlReport("2.1", "tested", 64, 8, 32, true);

    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final OpenGlLabModel model = new OpenGlLabModel(this::locked, failures::add);

    /** The model's one thread: whoever has the lock. */
    private void locked(Runnable command) {
        synchronized (failures) {
            command.run();
        }
    }

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private List<String> calls(Setting setting) {
        return model.state().calls().stream()
                .filter(call -> call.setting().equals(Optional.of(setting)))
                .map(GlCall::text)
                .toList();
    }

    @Test
    void settingShowsItsCall() {
        model.resize(64, 48);
        model.set(Setting.SCENE, "quad");
        model.set(Setting.ENV_MODE, "GL_DECAL");
        assertEquals(
                List.of("glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_DECAL)"),
                calls(Setting.ENV_MODE));
        assertEquals(Setting.ENV_MODE, model.state().touched());
    }

    @Test
    void stateThatIsOffIsSwitchedOffByACall() {
        model.resize(64, 48);
        assertEquals(List.of("glDisable(GL_CULL_FACE)"), calls(Setting.CULL_FACE));
        model.set(Setting.CULL_FACE, "GL_FRONT");
        assertEquals(
                List.of("glEnable(GL_CULL_FACE)", "glCullFace(GL_FRONT)"),
                calls(Setting.CULL_FACE));
    }

    @Test
    void sceneBringsItsTexture() {
        model.set(Setting.SCENE, "globe");
        assertTrue(model.state().choice().is(Setting.TEXTURE_2D, "on"));
        model.set(Setting.SCENE, "sphere");
        assertTrue(model.state().choice().is(Setting.TEXTURE_2D, "off"));
    }

    @Test
    void unknownOptionIsRefusedAndNothingChanges() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class, () -> model.set(Setting.BLEND, "GL_DECAL"));
        assertTrue(refused.getMessage().contains("blend must be one of off"));
        assertEquals(GlChoice.first(), model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void dragIsOneChangeForUndo() {
        model.beginDrag();
        for (int i = 0; i < 5; i++) model.move(choice -> choice.turned(10, 4));
        model.endDrag();
        assertEquals(83, model.state().choice().turn());
        model.history().undo();
        assertEquals(GlChoice.first(), model.state().choice());
        assertFalse(model.history().undoable());
    }

    @Test
    void turningGoesRoundAndTiltStops() {
        model.move(choice -> choice.turned(-40, 200));
        assertEquals(353, model.state().choice().turn());
        assertEquals(90, model.state().choice().tilt());
        model.move(choice -> choice.dollied(100));
        assertEquals(GlChoice.FARTHEST, model.state().choice().distance());
    }

    @Test
    void windowsPictureIsComparedWithTheSoftwareOne() throws InterruptedException {
        model.attach();
        model.resize(64, 48);
        model.settle();
        Raster first = model.state().pictures().software().orElseThrow();
        model.set(Setting.SCENE, "globe");
        model.settle();
        assertSame(first, model.state().pictures().software().get(), "the window's to draw");
        GlFrame frame = model.frame().orElseThrow();
        var black = new Raster(64, 48);
        black.clear(0xFF000000);
        model.drawn(frame, black, REPORT);
        model.settle();
        assertEquals(Optional.of(REPORT), model.state().report());
        assertEquals(Optional.of(black), model.state().pictures().openGl());
        long off = model.state().pictures().difference().orElseThrow().plain().wrongPixels();
        assertEquals(64 * 48, off);
    }

    @Test
    void softwareHalfIsThereWithoutAWindow() throws InterruptedException {
        model.resize(64, 48);
        model.settle();
        assertEquals(64, model.state().pictures().software().orElseThrow().width());
        assertTrue(
                model.state().missing().isPresent()
                        != model.state().pictures().openGl().isPresent());
    }

    @Test
    void windowThatGoesIsReplaced() throws InterruptedException {
        model.attach();
        model.resize(64, 48);
        model.detach();
        model.settle();
        assertTrue(model.state().pictures().software().isPresent());
    }

    @Test
    void imageBecomesTheTexture(@TempDir Path folder) throws IOException, InterruptedException {
        Path file = folder.resolve("flag.png");
        var image = new BufferedImage(5, 3, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 2, 0xFF8040);
        ImageIO.write(image, "png", file.toFile());
        model.resize(64, 48);
        model.open(file);
        model.settle();
        var texture = model.frame().orElseThrow().texture().orElseThrow();
        assertEquals(5, texture.width());
        assertEquals(0xFFFF8040, texture.level(0).texel(0, 0), "the lower left texel");
        model.set(Setting.IMAGE, "checker");
        model.set(Setting.IMAGE, "file");
        assertEquals("flag.png", model.state().choice().file().orElseThrow().name());
    }

    @Test
    @DisplayName("an image from a file makes the lab forget its states and the view")
    void keepsWhatDoesNotDependOnTheFile(@TempDir Path folder)
            throws IOException, InterruptedException {
        model.set(Setting.SCENE, "globe");
        model.set(Setting.BLEND, Setting.BLEND.options().get(1));
        model.move(choice -> choice.turned(40, 12));
        GlChoice before = model.state().choice();
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        model.open(file);
        model.settle();
        assertTrue(model.state().choice().is(Setting.IMAGE, "file"));
        assertEquals(before, model.kept());
    }

    @Test
    @DisplayName("an opened image, or that it is not the texture, is forgotten at a restart")
    void imageComesBackAsItWasUsed(@TempDir Path folder) throws IOException, InterruptedException {
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        model.open(file);
        model.settle();
        model.set(Setting.TEXTURE_2D, "off");
        for (String image : List.of("file", "checker")) {
            model.set(Setting.IMAGE, image);
            try (var next = new OpenGlLabModel(this::locked, failures::add)) {
                locked(() -> next.restore(model.kept()));
                locked(() -> next.keptImage().restore(model.keptImage().kept()));
                next.settle();
                GlChoice opened = next.state().choice();
                assertEquals(model.state().choice().options(), opened.options());
                assertEquals(file.toAbsolutePath(), opened.file().orElseThrow().file());
                assertEquals(model.keptImage().kept(), next.keptImage().kept());
                assertFalse(next.history().undoable());
            }
        }
    }

    @Test
    @DisplayName("an image that is gone is not told, or only until the window has its size")
    void imageThatIsGoneIsNamed(@TempDir Path folder) throws IOException, InterruptedException {
        Path file = folder.resolve("flag.png");
        locked(() -> model.keptImage().restore(new KeptImage(Optional.of(file), true)));
        model.settle();
        model.resize(64, 48);
        String problem = model.state().problem().orElseThrow();
        assertEquals(
                file + ": no such file to read; an image of the lab is shown instead", problem);
        assertEquals(GlChoice.first(), model.state().choice());
        assertEquals(Setting.IMAGE, model.state().touched());
    }

    @Test
    @DisplayName("a broken file opened meanwhile costs the image that is coming back, unsaid")
    void brokenFileDoesNotStopAnImageThatComesBack(@TempDir Path folder)
            throws IOException, InterruptedException {
        Path file = folder.resolve("flag.png");
        ImageIO.write(new BufferedImage(4, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        Path broken = Files.writeString(folder.resolve("broken.png"), "no picture");
        locked(
                () -> {
                    model.keptImage().restore(new KeptImage(Optional.of(file), true));
                    model.open(broken);
                });
        model.settle();
        assertEquals(file, model.state().choice().file().orElseThrow().file());
        String problem = model.state().problem().orElseThrow();
        assertTrue(problem.startsWith(broken.toString()), problem);
    }

    private String problemWith(Path file) throws InterruptedException {
        model.open(file);
        model.settle();
        assertEquals(GlChoice.first(), model.state().choice());
        return model.state().problem().orElseThrow();
    }

    @Test
    void brokenImageIsNamed(@TempDir Path folder) throws IOException, InterruptedException {
        Path file = folder.resolve("half.png");
        var bytes = new java.io.ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(40, 40, BufferedImage.TYPE_INT_RGB), "png", bytes);
        Files.write(file, java.util.Arrays.copyOf(bytes.toByteArray(), 45));
        String problem = problemWith(file);
        assertTrue(problem.startsWith(file + ": the picture is cut off"), problem);
    }

    @Test
    void fileThatIsNoImageIsNamed(@TempDir Path folder) throws IOException, InterruptedException {
        Path file = Files.writeString(folder.resolve("notes.txt"), "no picture at all");
        String problem = problemWith(file);
        assertTrue(problem.startsWith(file + ": is not a picture that can be read"), problem);
    }

    @Test
    void folderAndMissingFileAreNamed(@TempDir Path folder) throws InterruptedException {
        assertEquals(folder + ": is a folder, not a picture", problemWith(folder));
        Path none = folder.resolve("none.png");
        assertEquals(none + ": no such file to read", problemWith(none));
    }

    @Test
    void pipeIsNotWaitedFor(@TempDir Path folder) throws Exception {
        Path pipe = Pipe.at(folder.resolve("pipe.png"));
        String problem = problemWith(pipe);
        assertEquals(pipe + ": is a device, pipe or socket, not a picture", problem);
        assertEquals(
                pipe + ": это устройство, канал или сокет, а не изображение",
                Complaints.translated(Language.RUSSIAN, problem));
    }

    /** The test takes every order of the two choices. */
    @Test
    void decalWithoutColorsStaysAndIsNamed() {
        GlChoice quad = GlChoice.first().with(Setting.SCENE, "quad");
        GlChoice decal = quad.with(Setting.ENV_MODE, "GL_DECAL");
        for (String components : new String[] {"1", "2"}) {
            GlChoice last = decal.with(Setting.COMPONENTS, components);
            GlChoice first =
                    quad.with(Setting.COMPONENTS, components).with(Setting.ENV_MODE, "GL_DECAL");
            assertEquals(first, last);
            assertEquals(List.of(Deviations.DECAL), Deviations.of(last));
        }
        assertEquals(List.of(), Deviations.of(decal));
    }

    @Test
    void imageLargerThanOpenGlTakesIsNamed(@TempDir Path folder)
            throws IOException, InterruptedException {
        model.attach();
        model.resize(64, 48);
        model.drawn(model.frame().orElseThrow(), new Raster(64, 48), REPORT);
        Path file = folder.resolve("wide.png");
        ImageIO.write(new BufferedImage(65, 2, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        assertEquals(
                file + ": has 65×2 pixels; a texture has from 1×1 to 64×64", problemWith(file));
    }

    @Test
    void everyViewIsAChoiceOfItsOwn() {
        for (GlView view : GlView.values()) {
            model.reset();
            model.show(view);
            assertFalse(model.state().choice().equals(GlChoice.first()), view.code());
        }
    }
}
