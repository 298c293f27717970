package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import javax.swing.JTextArea;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.JComboBoxFixture;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.opengl.GlView;
import rasterlab.app.opengl.OpenGlLabState;
import rasterlab.app.opengl.OpenGlRoom;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.Group;
import rasterlab.app.opengl.state.Setting;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.raster.Raster;
import rasterlab.tests.bench.window.WindowContent;

/** The OpenGL lab's window under a real display, by mouse and keyboard. */
class WindowOpenGlTest extends WindowHarness {
    @BeforeEach
    void showOpenGl() {
        if (window == null) return;
        show("opengl");
        await("both pictures or a reason", () -> settled(state()));
        Assumptions.assumeTrue(state().missing().isEmpty(), () -> state().missing().get());
        awaitOpenGlsWindow();
    }

    /** Waits for OpenGL's window, which comes in an event of its own, maybe after both pictures. */
    private void awaitOpenGlsWindow() {
        await("OpenGL's window", () -> isSeen("opengl.canvas"));
    }

    private OpenGlLabState state() {
        return GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).state());
    }

    private GlChoice choice() {
        return state().choice();
    }

    /** Whether the pictures are there and have the size that is wanted now. */
    private boolean settled(OpenGlLabState state) {
        if (state.missing().isPresent()) return true;
        var frame = GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).frame());
        return frame.isPresent()
                && state.pictures()
                        .openGl()
                        .filter(picture -> picture.width() == frame.get().width())
                        .filter(picture -> picture.height() == frame.get().height())
                        .isPresent()
                && state.pictures().difference().isPresent();
    }

    private Component named(String name) {
        return window.robot().finder().findByName(frame, name);
    }

    private Raster picture() {
        await("the pictures", () -> settled(state()));
        return state().pictures().openGl().orElseThrow();
    }

    private Set<Integer> drawn() {
        return IntStream.of(picture().argb()).boxed().collect(Collectors.toSet());
    }

    @Test
    void screenShowsWhatOpenGlHasDrawn() {
        awaitOpenGlsWindow();
        await("OpenGL's window has its picture", () -> colors("opengl.canvas").equals(drawn()));
        assertTrue(drawn().size() > 100, "only " + drawn().size() + " colours");
    }

    @Test
    void bothHalvesAgreeInTheWindow() {
        picture();
        double share = state().pictures().difference().orElseThrow().plain().share();
        assertTrue(share <= 1e-4, "share " + share);
    }

    @Test
    void dragOverOpenGlsWindowTurnsTheSceneAndIsOneChange() {
        GlChoice before = choice();
        Component canvas = named("opengl.canvas");
        var middle = new Point(canvas.getWidth() / 2, canvas.getHeight() / 2);
        robot.pressMouse(canvas, middle, MouseButton.LEFT_BUTTON);
        robot.moveMouse(canvas, middle.x + 30, middle.y);
        robot.moveMouse(canvas, middle.x + 60, middle.y + 20);
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertNotEquals(before.turn(), choice().turn());
        assertNotEquals(before.tilt(), choice().tilt());
        window.button("undo").click();
        await("what was before is back", () -> choice().equals(before));
    }

    @Test
    void keysTurnAndMoveTheEye() {
        focus("software.picture");
        GlChoice before = choice();
        press(KeyEvent.VK_RIGHT);
        assertEquals(before.turn() + 5, choice().turn());
        press(KeyEvent.VK_UP);
        assertEquals(before.tilt() - 5, choice().tilt());
        press(KeyEvent.VK_MINUS);
        assertTrue(choice().distance() > before.distance());
    }

    @Test
    void everySettingIsChosenInItsList() {
        for (Group group : Group.values()) {
            window.comboBox("group").selectItem(group.ordinal());
            robot.waitForIdle();
            for (Setting setting : group.settings()) {
                select(setting.code(), 1);
                assertEquals(setting.options().get(1), choice().get(setting), setting.code());
                GuiActionRunner.execute(
                        () -> models.of(new OpenGlRoom()).set(setting, setting.options().get(0)));
            }
        }
    }

    private static int selected(JComboBoxFixture box) {
        return GuiActionRunner.execute(() -> box.target().getSelectedIndex());
    }

    /**
     * Selects an item, again where the click missed: a list that opens over OpenGL's window may
     * come up late.
     */
    private void select(String list, int item) {
        JComboBoxFixture box = window.comboBox(list);
        for (int turn = 0; turn < 3 && selected(box) != item; turn++) {
            box.selectItem(item);
            robot.waitForIdle();
        }
    }

    @Test
    void everyViewIsBroughtByItsChip() {
        for (GlView view : GlView.values()) {
            window.button("chip." + view.code()).click();
            robot.waitForIdle();
            assertEquals(view.choice(), choice(), view.code());
        }
        window.button("reset").click();
        robot.waitForIdle();
        assertEquals(GlChoice.first(), choice());
    }

    @Test
    void otherLanguageAndThemeHaveAWindowOfTheirOwn() {
        Component old = named("opengl.canvas");
        GuiActionRunner.execute(
                () -> {
                    models.of(new OpenGlRoom()).set(Setting.SCENE, "globe");
                    frame.wear(frame.look().with(Language.RUSSIAN));
                    frame.wear(frame.look().with(LabTheme.DARK));
                });
        robot.waitForIdle();
        assertNotSame(old, named("opengl.canvas"));
        GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).set(Setting.SCENE, "quad"));
        screenShowsWhatOpenGlHasDrawn();
    }

    @Test
    void hiddenAndShownAgainItDrawsOn() {
        Set<Integer> before = drawn();
        show("line");
        GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).set(Setting.SCENE, "globe"));
        show("opengl");
        await("the picture of the other scene", () -> !drawn().equals(before));
        screenShowsWhatOpenGlHasDrawn();
        assertTrue(choice().is(Setting.SCENE, "globe"));
    }

    /** Each of them takes OpenGL's window away, or lets it come, before the last one has come. */
    @Test
    void tabsAndLanguagesInQuickSuccessionLeaveAWindowThatDraws() {
        for (int round = 0; round < 5; round++) {
            Language language = Language.values()[round % 2];
            GuiActionRunner.execute(
                    () -> {
                        WindowContent.of(frame).show("opengl");
                        frame.wear(frame.look().with(language));
                        WindowContent.of(frame).show("line");
                    });
            GuiActionRunner.execute(() -> WindowContent.of(frame).show("opengl"));
        }
        show("opengl");
        awaitOpenGlsWindow();
        GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).set(Setting.SCENE, "globe"));
        screenShowsWhatOpenGlHasDrawn();
    }

    @Test
    void pictureFollowsTheWindowsSize() {
        for (var size : List.of(new Dimension(900, 600), new Dimension(1500, 1000))) {
            GuiActionRunner.execute(() -> frame.setSize(size));
            robot.waitForIdle();
            await(
                    "a picture as large as its window",
                    () -> picture().width() == named("opengl.canvas").getWidth());
            screenShowsWhatOpenGlHasDrawn();
        }
    }

    @Test
    void droppedOrOpenedImageIsTheTextureAndABrokenOneIsNamed() throws IOException {
        Path file = folder.resolve("own.png");
        ImageIO.write(new BufferedImage(12, 7, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
        GuiActionRunner.execute(
                () -> {
                    models.of(new OpenGlRoom()).set(Setting.SCENE, "quad");
                    models.of(new OpenGlRoom()).open(file);
                });
        await("the image is the texture", () -> choice().is(Setting.IMAGE, "file"));
        assertTrue(window.label("file.value").text().contains("own.png"));
        Path broken = Files.writeString(folder.resolve("broken.png"), "no image");
        GuiActionRunner.execute(() -> models.of(new OpenGlRoom()).open(broken));
        await(
                "the reason",
                () ->
                        named("problem") instanceof JTextArea reason
                                && reason.isShowing()
                                && reason.getText().contains("broken.png"));
    }

    @Test
    void pixelUnderTheMouseIsRead() {
        picture();
        robot.moveMouse(named("software.picture"), new Point(40, 30));
        await("a reading", () -> window.label("reading").text().contains("(40, 30)"));
    }
}
