package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.shell.OffscreenPainter;

/** Hazards above a stage: those without room go into the menu, and none is lost. */
class ChipsTest {
    private static final int COUNT = 24;

    private final List<String> clicked = new ArrayList<>();

    private LabLayout lab(Chips chips) {
        for (int i = 0; i < COUNT; i++) {
            String name = "hazard" + i;
            chips.add(name, "a hazard " + i, "", () -> clicked.add(name));
        }
        return new LabLayout(
                chips,
                new JLabel("stage"),
                new Inspector(Texts.of("line", Language.ENGLISH)),
                new JPanel(),
                new JLabel("timeline"));
    }

    private static Chips chips() {
        return new Chips(Texts.of("line", Language.ENGLISH), "hazards");
    }

    private static List<String> shown(Chips chips) {
        return Stream.of(chips.getComponents())
                .filter(Component::isVisible)
                .map(Component::getName)
                .toList();
    }

    @Test
    void leaveTheStageItsHeightInASmallWindow() throws Exception {
        Chips chips = chips();
        LabLayout lab = lab(chips);
        OffscreenPainter.paint(lab, 700, 400);
        assertTrue(chips.getHeight() <= 400 / 4, "high by " + chips.getHeight());
        List<String> shown = shown(chips);
        assertEquals("chips.more", shown.get(shown.size() - 1));
        for (Component each : chips.getComponents())
            if (each.isVisible())
                assertTrue(each.getX() + each.getWidth() <= chips.getWidth(), each.getName());
    }

    @Test
    void takeTwoRowsAtMostInAHighWindowToo() throws Exception {
        Chips chips = chips();
        OffscreenPainter.paint(lab(chips), 1280, 1200);
        long rows =
                Stream.of(chips.getComponents())
                        .filter(each -> each.isVisible() && each instanceof JButton)
                        .map(Component::getY)
                        .distinct()
                        .count();
        assertEquals(2, rows);
        assertTrue(shown(chips).contains("chips.more"), "nothing is left out");
    }

    @Test
    void areAllInSightWhereThereIsRoom() throws Exception {
        Chips chips = chips();
        OffscreenPainter.paint(lab(chips), 2000, 1200);
        assertEquals(1 + COUNT, shown(chips).size());
        assertTrue(!shown(chips).contains("chips.more"), "stands for nothing");
    }

    @Test
    void comeBackWhenTheWindowGrows() throws Exception {
        Chips chips = chips();
        LabLayout lab = lab(chips);
        OffscreenPainter.paint(lab, 700, 400);
        OffscreenPainter.paint(lab, 2000, 1200);
        assertEquals(1 + COUNT, shown(chips).size());
    }

    @Test
    void menuHasExactlyThoseThatAreNotShown() throws Exception {
        Chips chips = chips();
        OffscreenPainter.paint(lab(chips), 700, 400);
        List<String> shown = shown(chips);
        EventQueue.invokeAndWait(
                () -> {
                    for (Component each : chips.menu().getComponents())
                        ((javax.swing.AbstractButton) each).doClick(0);
                });
        assertEquals(COUNT, clicked.size() + shown.size() - 2);
        for (String each : clicked) assertTrue(!shown.contains("chip." + each), each);
        long buttons = Stream.of(chips.getComponents()).filter(JButton.class::isInstance).count();
        assertEquals(COUNT + 1, buttons);
    }
}
