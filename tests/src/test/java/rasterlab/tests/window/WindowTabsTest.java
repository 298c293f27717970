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

/** Tabs on their way into the window, which come in several events. */
class WindowTabsTest extends WindowHarness {
    @Test
    void tabBeforeIsSeenUntilTheNewOneIsThereAndTheWindowAnswersMeanwhile() {
        var seen = new ArrayList<Boolean>();
        GuiActionRunner.execute(
                () -> {
                    frame.showTab("polygon");
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
                        frame.showTab(tab);
                });
        await("the tab spline", () -> isSeen("spline"));
        robot.waitForIdle();
        assertEquals("spline", frame.shownTab());
        assertTrue(isSeen("spline"));
        show("exercises");
        show("polygon");
    }

    @Test
    void tabThatIsShownAlreadyCallsOffTheOneOnItsWay() {
        GuiActionRunner.execute(
                () -> {
                    frame.showTab("polygon");
                    frame.showTab("line");
                });
        robot.waitForIdle();
        assertTrue(isSeen("line"));
        assertEquals("line", frame.shownTab());
        press(KeyEvent.VK_DOWN);
        assertTrue(isSeen("line"));
    }

    @Test
    void otherLookMeanwhileShowsTheTabThatWasOnItsWay() {
        var look = LabLook.first(Language.RUSSIAN).with(LabTheme.DARK);
        GuiActionRunner.execute(
                () -> {
                    frame.showTab("exercises");
                    frame.wear(look);
                    frame.showTab("clip");
                    frame.speak(Language.ENGLISH);
                });
        await("the tab clip", () -> isSeen("clip"));
        robot.waitForIdle();
        assertEquals(look.with(Language.ENGLISH), frame.look());
        assertEquals("clip", frame.shownTab());
    }
}
