package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.language.Language;
import rasterlab.app.practice.PracticeCards;

class HelpTextTest {
    static Stream<String> tabs() {
        return LabTabs.NAMES.stream();
    }

    @ParameterizedTest(name = "help does not say what can be done in {0}")
    @MethodSource("tabs")
    void everyTabHasItsWays(String tab) {
        for (Language language : Language.values()) {
            HelpText help = HelpText.of(tab, "", language);
            assertTrue(help.sections().get(0).ways().size() >= 4, help.toString());
            for (HelpText.Section section : help.sections())
                for (HelpText.HelpEntry way : section.ways()) {
                    assertFalse(way.by().isBlank());
                    assertFalse(way.does().isBlank());
                }
        }
    }

    @Test
    void bothLanguagesHaveTheSameRows() {
        for (String tab : LabTabs.NAMES)
            assertEquals(sizes(HelpText.of(tab, "", Language.ENGLISH)), sizes(of(tab)), tab);
    }

    private static HelpText of(String tab) {
        return HelpText.of(tab, "", Language.RUSSIAN);
    }

    private static List<Integer> sizes(HelpText help) {
        return help.sections().stream().map(section -> section.ways().size()).toList();
    }

    @ParameterizedTest(name = "help speaks of a lamp that is not there: {0}")
    @ValueSource(strings = {"light.colours", "coordinates.rows"})
    void stageWithoutALampHasWaysOfItsOwn(String stage) {
        for (Language language : Language.values()) {
            HelpText.Section ways = HelpText.of("light", stage, language).sections().get(0);
            assertTrue(ways.ways().size() >= 4, ways.toString());
            assertFalse(
                    ways.toString().matches("(?s).*(light source|источник).*"), ways.toString());
            String lit = HelpText.of("light", "light", language).toString();
            assertTrue(lit.matches("(?s).*(light source|источник).*"), lit);
        }
    }

    @Test
    void questionsHaveHelpOfTheirOwnWithoutThePlayersKeys() {
        for (Language language : Language.values()) {
            HelpText help = HelpText.of("line", PracticeCards.HELP, language);
            assertTrue(help.sections().get(0).ways().size() >= 8, help.toString());
            String said = help.toString();
            for (String key : List.of("Enter", "Esc", "+, −, 0"))
                assertTrue(said.contains(key), said);
            assertFalse(said.contains("Page Up, Page Down"), said);
        }
    }

    @Test
    @DisplayName("help leaves out a key of the player")
    void everyKeyOfThePlayerIsNamed() {
        String said = HelpText.of("line", "line.segment", Language.ENGLISH).toString();
        for (KeyStroke key : StepPlayer.keys()) {
            String name = java.awt.event.KeyEvent.getKeyText(key.getKeyCode());
            assertTrue(said.contains(name), name + " in " + said);
        }
    }
}
