package rasterlab.tests.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import javax.swing.JButton;
import javax.swing.JComboBox;
import javax.swing.JMenuItem;
import javax.swing.MenuSelectionManager;
import org.assertj.swing.edt.GuiActionRunner;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;

/** Chooses another language in the window. */
class WindowLanguageTest extends WindowHarness {
    /** Events between which a tab is made, at least. */
    private static final int PARTS = 5;

    @Test
    void windowAnswersWhileItsTabIsMadeInTheOtherLanguage() {
        var seen = new CopyOnWriteArrayList<Language>();
        GuiActionRunner.execute(
                () -> {
                    choose(Language.RUSSIAN);
                    note(seen);
                });
        await("Russian", () -> seen.contains(Language.RUSSIAN));
        assertTrue(Collections.frequency(seen, Language.ENGLISH) > PARTS, seen::toString);
    }

    /** Notes the language in each event, until the window speaks Russian. */
    private void note(List<Language> seen) {
        seen.add(frame.language());
        if (frame.language() == Language.ENGLISH) EventQueue.invokeLater(() -> note(seen));
    }

    @Test
    void languageChosenLastIsSpoken() {
        GuiActionRunner.execute(
                () -> {
                    choose(Language.RUSSIAN);
                    choose(Language.ENGLISH);
                });
        letAllEventsPass();
        assertEquals(Language.ENGLISH, frame.language());
        GuiActionRunner.execute(
                () -> {
                    choose(Language.RUSSIAN);
                    choose(Language.ENGLISH);
                    choose(Language.RUSSIAN);
                });
        await("Russian", () -> frame.language() == Language.RUSSIAN);
    }

    @Test
    void themeChosenMeanwhileLeavesTheLanguage() {
        GuiActionRunner.execute(
                () -> {
                    choose(Language.RUSSIAN);
                    robot.finder().findByName(frame, "look", JButton.class).doClick(0);
                    robot.finder().findByName("theme.dark", JMenuItem.class).doClick(0);
                    MenuSelectionManager.defaultManager().clearSelectedPath();
                });
        letAllEventsPass();
        assertEquals(Language.RUSSIAN, frame.language());
        assertEquals(LabTheme.DARK, frame.look().theme());
    }

    @Test
    void windowClosedMeanwhileLearnsNoLanguage() {
        GuiActionRunner.execute(
                () -> {
                    choose(Language.RUSSIAN);
                    frame.dispose();
                });
        letAllEventsPass();
        assertEquals(Language.ENGLISH, frame.language());
    }

    private void choose(Language language) {
        robot.finder()
                .findByName(frame, "language", JComboBox.class)
                .setSelectedIndex(language.ordinal());
    }

    /** Lets more events pass than a tab is made in. */
    private static void letAllEventsPass() {
        for (int k = 0; k < 99; k++) GuiActionRunner.execute(() -> {});
    }
}
