package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.tests.bench.window.WindowContent;

/** Tabs on their way into the window, which come in several events. */
class WindowTabsTest extends WindowHarness {
    @Test
    void tabBeforeIsSeenUntilTheNewOneIsThereAndTheWindowAnswersMeanwhile() {
        var seen = new ArrayList<Boolean>();
        GuiActionRunner.execute(
                () -> {
                    WindowContent.of(frame).show("polygon");
                    note(seen);
                });
        await("the tab polygon", () -> isSeen("polygon"));
        robot.waitForIdle();
        List<Boolean> before = seen.stream().takeWhile(line -> line).toList();
        assertTrue(before.size() >= 3, "events with the old tab: " + before);
        assertFalse(isSeen("line"));
    }

    /** Whether the old tab is seen, in each event until it is not. */
    private void note(List<Boolean> seen) {
        seen.add(isSeen("line"));
        if (isSeen("line")) EventQueue.invokeLater(() -> note(seen));
    }

    @Test
    void lastChosenTabIsShownWhateverWasOnItsWay() {
        GuiActionRunner.execute(
                () -> {
                    for (String tab : List.of("exercises", "polygon", "clip", "spline"))
                        WindowContent.of(frame).show(tab);
                });
        await("the tab spline", () -> isSeen("spline"));
        robot.waitForIdle();
        assertEquals("spline", WindowContent.of(frame).shown());
        assertTrue(isSeen("spline"));
        show("exercises");
        show("polygon");
    }

    @Test
    void tabThatIsShownAlreadyCallsOffTheOneOnItsWay() {
        GuiActionRunner.execute(
                () -> {
                    WindowContent.of(frame).show("polygon");
                    WindowContent.of(frame).show("line");
                });
        robot.waitForIdle();
        assertTrue(isSeen("line"));
        assertEquals("line", WindowContent.of(frame).shown());
        press(KeyEvent.VK_DOWN);
        assertTrue(isSeen("line"));
    }

    @Test
    void otherLookMeanwhileShowsTheTabThatWasOnItsWay() {
        var look = LabLook.first(Language.RUSSIAN).with(LabTheme.DARK);
        GuiActionRunner.execute(
                () -> {
                    WindowContent.of(frame).show("exercises");
                    frame.wear(look);
                    WindowContent.of(frame).show("clip");
                    frame.wear(frame.look().with(Language.ENGLISH));
                });
        await("the tab clip", () -> isSeen("clip"));
        robot.waitForIdle();
        assertEquals(look.with(Language.ENGLISH), frame.look());
        assertEquals("clip", WindowContent.of(frame).shown());
    }
}
