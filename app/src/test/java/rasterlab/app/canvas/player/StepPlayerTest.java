package rasterlab.app.canvas.player;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.HashSet;
import java.util.Set;
import java.util.function.IntFunction;
import javax.swing.JButton;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.Parts;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class StepPlayerTest {
    private static final int LAST = 12;

    /** Steps that turn round, or do not. */
    private static final class Counted implements Steps {
        private final boolean round;
        private int step;

        Counted(boolean round) {
            this.round = round;
        }

        @Override
        public int first() {
            return 0;
        }

        @Override
        public int last() {
            return LAST;
        }

        @Override
        public int step() {
            return step;
        }

        @Override
        public void goTo(int next) {
            step = within(next);
        }

        @Override
        public boolean turnsRound() {
            return round;
        }
    }

    private static StepPlayer player(Counted steps, IntFunction<String> reading) {
        return new StepPlayer(
                Texts.of("canvas", Language.ENGLISH), steps, () -> reading.apply(steps.step));
    }

    private static Component part(StepPlayer player, String name) {
        return Parts.of(player)
                .filter(each -> ("player." + name).equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    @DisplayName("single steps of what turns round end where the turn ends")
    void singleStepsGoRound() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var steps = new Counted(true);
                    StepPlayer player = player(steps, String::valueOf);
                    ((JButton) part(player, "back")).doClick(0);
                    assertEquals(LAST, steps.step);
                    player.refresh();
                    assertFalse(part(player, "toEnd").isEnabled());
                    ((JButton) part(player, "forward")).doClick(0);
                    assertEquals(0, steps.step);
                });
    }

    @Test
    @DisplayName("steps that have an end go round it")
    void stepsWithAnEndStopThere() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var steps = new Counted(false);
                    StepPlayer player = player(steps, String::valueOf);
                    assertFalse(part(player, "back").isEnabled());
                    assertTrue(part(player, "forward").isEnabled());
                    assertEquals(0, steps.after(-1));
                    steps.goTo(LAST);
                    player.refresh();
                    assertFalse(part(player, "forward").isEnabled());
                    assertEquals(LAST, steps.after(1));
                });
    }

    @Test
    @DisplayName("the slider gets shorter when the count gets a digit more or becomes a word")
    void sliderKeepsItsLength() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    var steps = new Counted(false);
                    StepPlayer player =
                            player(steps, at -> at == LAST ? "all that came out" : at + " / 11");
                    player.reserve("all that came out");
                    assertEquals(1, widths(player, steps).size());
                    assertEquals(1, widths(player(steps, at -> at + " / 12"), steps).size());
                });
    }

    /** Widths of what stands beside the slider. */
    private static Set<Integer> widths(StepPlayer player, Steps steps) {
        var widths = new HashSet<Integer>();
        for (int step = 0; step <= LAST; step++) {
            steps.goTo(step);
            player.refresh();
            widths.add(part(player, "count").getMinimumSize().width);
        }
        return widths;
    }
}
