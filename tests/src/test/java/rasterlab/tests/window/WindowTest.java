package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComboBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import org.assertj.swing.core.MouseButton;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;
import rasterlab.app.coordinates.CoordinatesRoom;
import rasterlab.app.coordinates.figure.CoordinatesMode;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.shell.LabTabs;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabSettings;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.app.shell.settings.SettingsFile;
import rasterlab.app.visibility.VisibilityRoom;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.tests.bench.window.WindowContent;

/** The window under a real display, by mouse and keyboard. */
class WindowTest extends WindowHarness {
    private static final int WRONG = PictureDifference.WRONG;

    @Test
    void showsLitPixelsOnTheStage() {
        int lit = LabRooms.card("line").colors().of("bresenham").getRGB();
        await("lit pixels are shown", () -> colors("stage").contains(lit));
        assertTrue(colors("stage").size() > 3, "blank stage");
    }

    @Test
    void dragMovesAnEndAndUndoBringsItBack() {
        Segment before = segment();
        Component end = window.robot().finder().findByName(frame, "end.B");
        var center = new Point(end.getWidth() / 2, end.getHeight() / 2);
        robot.pressMouse(end, center, MouseButton.LEFT_BUTTON);
        robot.moveMouse(end, center.x - 60, center.y - 90);
        robot.moveMouse(end, center.x - 120, center.y - 120);
        robot.releaseMouseButtons();
        robot.waitForIdle();
        assertNotEquals(before, segment());
        assertEquals(before.x0(), segment().x0());
        window.button("undo").click();
        await("what was before is back", () -> segment().equals(before));
    }

    @Test
    void stepsBackAndForthAndPlaysToTheEnd() {
        int last = models.of(new LineRoom()).last();
        window.button("player.back").click();
        window.button("player.back").click();
        robot.waitForIdle();
        assertEquals(last - 2, models.of(new LineRoom()).step());
        window.button("player.toStart").click();
        robot.waitForIdle();
        assertEquals(1, models.of(new LineRoom()).step());
        window.button("player.play").click();
        await("the end is played to", () -> models.of(new LineRoom()).step() == last);
    }

    @Test
    void marksTheWrongPixels() {
        show("visibility");
        window.comboBox("method").selectItem("painter-textbook");
        assertFalse(colors("stage").contains(WRONG), "marked unasked");
        window.checkBox("difference").click();
        await("wrong pixels are marked", () -> colors("stage").contains(WRONG));
        window.checkBox("difference").click();
        await("marks are gone", () -> !colors("stage").contains(WRONG));
    }

    @Test
    void countsTheWrongPixelsOfTheTextbookPainter() {
        show("visibility");
        window.button("chip.rounded").click();
        await(
                "the difference is counted",
                () -> models.of(new VisibilityRoom()).state().difference().isPresent());
        assertTrue(
                models.of(new VisibilityRoom()).state().difference().orElseThrow().wrongPixels()
                        > 0);
    }

    @Test
    void languageAndThemeChangeWhileTheTabStays() {
        show("visibility");
        window.comboBox("language").selectItem(Language.RUSSIAN.ordinal());
        await("Russian", () -> frame.language() == Language.RUSSIAN);
        assertEquals("visibility", WindowContent.of(frame).shown());
        int light = window.robot().finder().findByName(frame, "tabs").getBackground().getRGB();
        window.button("look").click();
        window.menuItem("theme.dark").click();
        await("dark", () -> frame.look().theme() == LabTheme.DARK);
        int dark = window.robot().finder().findByName(frame, "tabs").getBackground().getRGB();
        assertTrue((dark & 255) < (light & 255), "background did not darken");
        assertEquals("visibility", WindowContent.of(frame).shown());
    }

    @Test
    void titleOfTheShownTabIsWholeInTheProjectorsType() {
        LabLook usual = frame.look();
        for (String tab : List.of("opengl", "study", "visibility", "exercises", "coordinates")) {
            GuiActionRunner.execute(() -> frame.wear(usual));
            show(tab);
            GuiActionRunner.execute(
                    () -> frame.wear(usual.with(Language.RUSSIAN).with(LabTheme.PROJECTOR)));
            await("the title of " + tab + " is in sight", this::titleIsWhole);
        }
    }

    /** Whether the title is whole; not while a new look is put on, when there are no titles. */
    private boolean titleIsWhole() {
        return GuiActionRunner.execute(
                () ->
                        robot
                                .finder()
                                .findAll(
                                        frame,
                                        part ->
                                                part instanceof JTabbedPane
                                                        && "tabs".equals(part.getName()))
                                .stream()
                                .map(JTabbedPane.class::cast)
                                .anyMatch(WindowTest::titleIsWhole));
    }

    private static boolean titleIsWhole(JTabbedPane pane) {
        Rectangle title = pane.getBoundsAt(pane.getSelectedIndex());
        boolean free =
                Stream.of(pane.getComponents())
                        .filter(part -> part.isVisible() && part.getWidth() > 0)
                        .noneMatch(part -> part.getBounds().intersects(title));
        return free && new Rectangle(pane.getSize()).contains(title);
    }

    @Test
    void noTextIsCutInRussian() {
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        var faults = new ArrayList<String>();
        for (Dimension size : SIZES) {
            window.resizeTo(size);
            for (String tab : LabTabs.NAMES) {
                show(tab);
                for (String text : GuiActionRunner.execute(() -> cut(frame.getContentPane())))
                    faults.add(tab + " in " + size.width + "×" + size.height + ": " + text);
            }
        }
        assertEquals(List.of(), faults);
    }

    @Test
    void everyControlCanBeNamedByAssistiveTechnology() {
        for (String tab : LabTabs.NAMES) {
            show(tab);
            List<String> nameless = GuiActionRunner.execute(() -> nameless(frame.getContentPane()));
            assertEquals(List.of(), nameless, tab);
        }
        for (CoordinatesMode mode : CoordinatesMode.values()) {
            show("coordinates");
            GuiActionRunner.execute(() -> models.of(new CoordinatesRoom()).show(mode));
            robot.waitForIdle();
            List<String> nameless = GuiActionRunner.execute(() -> nameless(frame.getContentPane()));
            assertEquals(List.of(), nameless, mode.name());
        }
    }

    @Test
    void closingKeepsTabAndLanguage() throws Exception {
        show("visibility");
        GuiActionRunner.execute(() -> frame.wear(frame.look().with(Language.RUSSIAN)));
        GuiActionRunner.execute(frame::dispose);
        await("settings are written", () -> Files.exists(settings()));
        LabSettings kept =
                new SettingsFile(settings(), each -> problems.add(each.toString()))
                        .load(LabSettings.first(Language.ENGLISH));
        assertEquals("visibility", kept.tab());
        assertEquals(Language.RUSSIAN, kept.look().language());
        assertFalse(kept.bounds().isEmpty());
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
