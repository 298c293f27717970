package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import javax.swing.JTextArea;
import org.assertj.swing.core.BasicRobot;
import org.assertj.swing.core.ComponentLookupScope;
import org.assertj.swing.core.Robot;
import org.assertj.swing.edt.GuiActionRunner;
import org.assertj.swing.fixture.FrameFixture;
import org.assertj.swing.timing.Condition;
import org.assertj.swing.timing.Pause;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.canvas.file.LastChosen;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.shell.LabFrame;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.labs.LabsFile;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.study.StudyView;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.line.Segment;
import rasterlab.tests.bench.window.WindowContent;
import rasterlab.tests.display.OwnDisplay;

/** The lab's window, open on a real display while a test runs; its failures fail the test. */
@Tag("slow")
@Timeout(300)
@ExtendWith(OwnDisplay.class)
abstract class WindowHarness {
    /**
     * The time that a slow machine that does something else besides may need for what is awaited.
     */
    private static final long LIMIT_MILLIS = 100_000;

    /** The longest that the robot can be told to wait for what it looks for itself. */
    private static final int ROBOT_MILLIS = 60_000;

    /** The sizes of the smallest window, of one on a laptop, and of one on a large screen. */
    static final List<Dimension> SIZES =
            List.of(new Dimension(900, 600), new Dimension(1280, 720), new Dimension(2560, 1440));

    @TempDir Path folder;
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    final List<String> problems = new CopyOnWriteArrayList<>();
    Robot robot;
    FrameFixture window;
    LabFrame frame;
    LabModels models;

    @BeforeEach
    void open() {
        assumeFalse(GraphicsEnvironment.isHeadless(), "no display");
        robot = BasicRobot.robotWithNewAwtHierarchy();
        robot.settings().componentLookupScope(ComponentLookupScope.SHOWING_ONLY);
        robot.settings().timeoutToBeVisible(ROBOT_MILLIS);
        robot.settings().timeoutToFindPopup(ROBOT_MILLIS);
        robot.settings().timeoutToFindSubMenu(ROBOT_MILLIS);
        robot.settings().idleTimeout(ROBOT_MILLIS);
        frame =
                GuiActionRunner.execute(
                        () -> {
                            LabTheme.LIGHT.install();
                            models = LabModels.first(failures::add);
                            return new LabFrame(
                                    models,
                                    new LabSettings(
                                            LabLook.first(Language.ENGLISH),
                                            "line",
                                            Optional.empty(),
                                            false,
                                            true,
                                            LastChosen.NONE),
                                    Language.ENGLISH,
                                    new SettingsFile(
                                            settings(), each -> problems.add(each.toString())),
                                    LabsFile.nextTo(
                                            settings(), each -> problems.add(each.toString())),
                                    failures::add);
                        });
        window = new FrameFixture(robot, frame);
        show(frame, new Dimension(1280, 720));
        var asked = new AtomicLong(System.nanoTime());
        await("the window has the keyboard", () -> hasKeyboard(asked));
        robot.waitForIdle();
    }

    /** The robot's own way gives a window 20 s to open, some of which it takes to be made. */
    private static void show(LabFrame frame, Dimension size) {
        GuiActionRunner.execute(
                () -> {
                    frame.pack();
                    frame.setLocation(100, 100);
                    frame.setSize(size);
                    frame.setVisible(true);
                });
        await("the window is shown", frame::isShowing);
    }

    /** A display without a window manager may refuse a window that is not seen yet: asks again. */
    private boolean hasKeyboard(AtomicLong asked) {
        if (frame.isFocused()) return true;
        if (System.nanoTime() - asked.get() > TimeUnit.SECONDS.toNanos(2)) {
            GuiActionRunner.execute(() -> frame.requestFocus());
            asked.set(System.nanoTime());
        }
        return false;
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

    Path settings() {
        return folder.resolve("window.properties");
    }

    /** Shows the table of hazards of the tab of speed and accuracy, which opens on its chart. */
    final void showHazards() {
        show("study");
        GuiActionRunner.execute(() -> models.study().show(StudyView.HAZARDS));
        robot.waitForIdle();
    }

    /** Shows the tab, which is made in several steps, some of them in the background. */
    void show(String tab) {
        GuiActionRunner.execute(() -> WindowContent.of(frame).show(tab));
        await("the tab " + tab, () -> isSeen(tab));
        robot.waitForIdle();
    }

    /** Whether a component of that name is seen; a tab's panel has the tab's name. */
    boolean isSeen(String name) {
        return !robot.finder()
                .findAll(frame, part -> name.equals(part.getName()) && part.isShowing())
                .isEmpty();
    }

    void focus(String name) {
        robot.focusAndWaitForFocusGain(window.robot().finder().findByName(frame, name));
    }

    void press(int key) {
        robot.pressAndReleaseKey(key);
        robot.waitForIdle();
    }

    Segment segment() {
        return GuiActionRunner.execute(() -> models.of(new LineRoom()).state().choice().segment());
    }

    double theta() {
        return models.of(new VisibilityRoom()).state().choice().camera().thetaRadians();
    }

    static void await(String what, BooleanSupplier held) {
        Pause.pause(
                new Condition(what) {
                    @Override
                    public boolean test() {
                        return held.getAsBoolean();
                    }
                },
                LIMIT_MILLIS);
    }

    /** The colours, as opaque RGB, of what the display shows of a component. */
    Set<Integer> colors(String name) {
        BufferedImage picture = captured(name);
        var colors = new HashSet<Integer>();
        for (int y = 0; y < picture.getHeight(); y++)
            for (int x = 0; x < picture.getWidth(); x++)
                colors.add(0xFF000000 | picture.getRGB(x, y));
        return colors;
    }

    /** The picture of a component on the display. */
    BufferedImage captured(String name) {
        Component shown = window.robot().finder().findByName(frame, name);
        var place = new Rectangle(shown.getLocationOnScreen(), shown.getSize());
        try {
            return new java.awt.Robot().createScreenCapture(place);
        } catch (java.awt.AWTException e) {
            throw new AssertionError("this display cannot be captured", e);
        }
    }

    /** The text above the buttons of the shown tab, "" where there is none. */
    String status() {
        return window
                .robot()
                .finder()
                .findAll(frame, part -> "status".equals(part.getName()) && part.isShowing())
                .stream()
                .map(part -> ((JTextArea) part).getText())
                .findFirst()
                .orElse("");
    }
}
