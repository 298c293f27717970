package rasterlab.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import org.assertj.swing.core.BasicRobot;
import org.assertj.swing.core.ComponentLookupScope;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.core.Robot;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.FrameFixture;
import org.assertj.swing.timing.Condition;
import org.assertj.swing.timing.Pause;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.language.Language;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.LabModels;
import rasterlab.app.shell.LabSettings;
import rasterlab.app.shell.LabTheme;
import rasterlab.app.shell.SettingsFile;
import rasterlab.engine.line.Segment;

/** The window under a real display, by mouse and keyboard. */
@Timeout(60)
class WindowTest {
    @TempDir Path folder;
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final List<String> problems = new CopyOnWriteArrayList<>();
    private Robot robot;
    private FrameFixture window;
    private LabFrame frame;
    private LabModels models;

    @BeforeEach
    void open() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        robot = BasicRobot.robotWithNewAwtHierarchy();
        robot.settings().componentLookupScope(ComponentLookupScope.SHOWING_ONLY);
        frame =
                GuiActionRunner.execute(
                        () -> {
                            LabTheme.LIGHT.install();
                            models = LabModels.first(failures::add);
                            return new LabFrame(
                                    models,
                                    LabSettings.first(Language.ENGLISH),
                                    new SettingsFile(settings(), problems::add),
                                    failures::add);
                        });
        window = new FrameFixture(robot, frame);
        window.show(new Dimension(1280, 720));
    }

    @AfterEach
    void close() {
        if (window == null) return;
        window.cleanUp();
        await("settings are written", () -> Files.exists(settings()));
        GuiActionRunner.execute(() -> {}); // The closed window's own event has run to its end.
        assertEquals(List.of(), failures);
        assertEquals(List.of(), problems);
    }

    private Path settings() {
        return folder.resolve("window.properties");
    }

    @Test
    void showsLitPixelsOnTheStage() {
        robot.waitForIdle();
        Set<Integer> colours = colours("stage");
        assertTrue(colours.contains(MethodColours.of("bresenham").getRGB()), "no lit pixel");
        assertTrue(colours.size() > 3, "blank stage");
    }

    @Test
    void dragMovesAnEndAndUndoBringsItBack() {
        Segment before = segment();
        Component end = window.robot().finder().findByName(frame, "end.B");
        var centre = new Point(end.getWidth() / 2, end.getHeight() / 2);
        robot.pressMouse(end, centre, MouseButton.LEFT_BUTTON);
        robot.moveMouse(end, centre.x - 60, centre.y - 90);
        robot.moveMouse(end, centre.x - 120, centre.y - 120);
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertNotEquals(before, segment());
        assertEquals(before.x0(), segment().x0());
        window.button("undo").click();
        robot.waitForIdle();
        assertEquals(before, segment());
    }

    @Test
    void tabChoosesTheEndThatTheArrowsMove() {
        Segment before = segment();
        focus("end.A");
        press(KeyEvent.VK_RIGHT);
        press(KeyEvent.VK_TAB);
        robot.pressKey(KeyEvent.VK_SHIFT);
        press(KeyEvent.VK_DOWN);
        robot.releaseKey(KeyEvent.VK_SHIFT);
        robot.waitForIdle();
        var moved = new Segment(before.x0() + 1, before.y0(), before.x1(), before.y1() + 10);
        assertEquals(moved, segment());
    }

    @Test
    void stepsBackAndForthAndPlaysToTheEnd() {
        int last = models.line().last();
        window.button("player.back").click();
        window.button("player.back").click();
        robot.waitForIdle();
        assertEquals(last - 2, models.line().step());
        window.button("player.toStart").click();
        robot.waitForIdle();
        assertEquals(1, models.line().step());
        window.button("player.play").click();
        await("the end is played to", () -> models.line().step() == last);
    }

    @Test
    void arrowKeysTurnTheVaseAsInTheCoursework() {
        show("visibility");
        double theta = theta();
        await("the vase is drawn", () -> colours("stage").size() > 40);
        focus("stage");
        press(KeyEvent.VK_RIGHT);
        press(KeyEvent.VK_RIGHT);
        await("two steps", () -> Math.abs(theta() - theta - 0.06 * Math.PI) < 1e-9);
        await(
                "the new view is drawn",
                () ->
                        models.visibility()
                                .state()
                                .picture()
                                .orElseThrow()
                                .request()
                                .camera()
                                .equals(models.visibility().state().choice().camera()));
    }

    @Test
    void countsTheWrongPixelsOfTheTextbookPainter() {
        show("visibility");
        window.button("chip.rounded").click();
        await(
                "the difference is counted",
                () -> models.visibility().state().difference().isPresent());
        assertTrue(models.visibility().state().difference().orElseThrow().wrongPixels() > 0);
    }

    @Test
    void languageAndThemeChangeWhileTheTabStays() {
        show("visibility");
        window.comboBox("language").selectItem(Language.RUSSIAN.ordinal());
        await("Russian", () -> frame.language() == Language.RUSSIAN);
        assertEquals("visibility", frame.shownTab());
        int light = window.robot().finder().findByName(frame, "tabs").getBackground().getRGB();
        window.button("theme").click();
        await("dark", () -> frame.theme() == LabTheme.DARK);
        int dark = window.robot().finder().findByName(frame, "tabs").getBackground().getRGB();
        assertTrue((dark & 255) < (light & 255), "background did not darken");
        assertEquals("visibility", frame.shownTab());
    }

    @ParameterizedTest(name = "Russian does not fit: {0}×{1}, {2}")
    @CsvSource({"900, 600, line", "900, 600, visibility", "1280, 720, line"})
    void noTextIsCutInRussian(int width, int height, String tab) {
        GuiActionRunner.execute(() -> frame.speak(Language.RUSSIAN));
        window.resizeTo(new Dimension(width, height));
        show(tab);
        robot.waitForIdle();
        assertEquals(List.of(), GuiActionRunner.execute(() -> cut(frame.getContentPane())));
    }

    @Test
    void everyControlCanBeNamedByAssistiveTechnology() {
        for (String tab : List.of("line", "visibility")) {
            show(tab);
            List<String> nameless = GuiActionRunner.execute(() -> nameless(frame.getContentPane()));
            assertEquals(List.of(), nameless, tab);
        }
    }

    @Test
    void closingKeepsTabAndLanguage() throws Exception {
        show("visibility");
        GuiActionRunner.execute(() -> frame.speak(Language.RUSSIAN));
        GuiActionRunner.execute(frame::dispose);
        await("settings are written", () -> Files.exists(settings()));
        LabSettings kept =
                new SettingsFile(settings(), problems::add)
                        .load(LabSettings.first(Language.ENGLISH));
        assertEquals("visibility", kept.tab());
        assertEquals(Language.RUSSIAN, kept.language());
        assertFalse(kept.bounds().isEmpty());
    }

    private void show(String tab) {
        GuiActionRunner.execute(() -> frame.showTab(tab));
        robot.waitForIdle();
    }

    private void focus(String name) {
        robot.focusAndWaitForFocusGain(window.robot().finder().findByName(frame, name));
    }

    private void press(int key) {
        robot.pressAndReleaseKey(key);
        robot.waitForIdle();
    }

    private Segment segment() {
        return GuiActionRunner.execute(() -> models.line().state().choice().segment());
    }

    private double theta() {
        return models.visibility().state().choice().camera().thetaRadians();
    }

    private static void await(String what, BooleanSupplier held) {
        Pause.pause(
                new Condition(what) {
                    @Override
                    public boolean test() {
                        return held.getAsBoolean();
                    }
                });
    }

    /** The colours, as opaque RGB, of what the display shows of a component. */
    private Set<Integer> colours(String name) {
        Component shown = window.robot().finder().findByName(frame, name);
        var place = new Rectangle(shown.getLocationOnScreen(), shown.getSize());
        BufferedImage picture = captured(place);
        var colours = new HashSet<Integer>();
        for (int y = 0; y < picture.getHeight(); y++)
            for (int x = 0; x < picture.getWidth(); x++)
                colours.add(0xFF000000 | picture.getRGB(x, y));
        return colours;
    }

    private static BufferedImage captured(Rectangle place) {
        try {
            return new java.awt.Robot().createScreenCapture(place);
        } catch (java.awt.AWTException e) {
            throw new AssertionError("this display cannot be captured", e);
        }
    }

    private static List<String> cut(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (!child.isShowing()) continue;
            boolean text =
                    child instanceof JLabel
                            || child instanceof AbstractButton
                            || child instanceof JComboBox;
            int needed = child.getPreferredSize().width;
            if (text && child.getName() != null && child.getWidth() < needed)
                found.add(child.getName() + " needs " + needed + ", has " + child.getWidth());
            if (child instanceof Container inner && !(child instanceof JComboBox))
                found.addAll(cut(inner));
        }
        return found;
    }

    private static List<String> nameless(Container container) {
        var found = new ArrayList<String>();
        for (Component child : container.getComponents()) {
            if (!child.isShowing()) continue;
            boolean control = child.getName() != null && child.isFocusable();
            String name =
                    child.getAccessibleContext() == null
                            ? null
                            : child.getAccessibleContext().getAccessibleName();
            boolean frameOnly =
                    child instanceof JLabel
                            || child instanceof JPanel
                            || child instanceof JScrollPane;
            if (control && !frameOnly && (name == null || name.isBlank()))
                found.add(child.getClass().getSimpleName() + " " + child.getName());
            if (child instanceof Container inner && !(child instanceof JComboBox))
                found.addAll(nameless(inner));
        }
        return found;
    }
}
