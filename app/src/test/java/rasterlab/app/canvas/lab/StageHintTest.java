package rasterlab.app.canvas.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Rectangle;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JPanel;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.work.History;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;

class StageHintTest {
    private final JPanel stage = new JPanel();
    private final History<String> history = new History<>(() -> "now", before -> {});
    private final StageGuide guide =
            new StageGuide(stage, Texts.of("canvas", Language.ENGLISH), Optional.of(history));

    @BeforeEach
    void first() {
        guide.setSize(700, 400);
        guide.hint("one", "Drag A or B");
        guide.doLayout();
    }

    private Component hint() {
        return Stream.of(guide.getComponents())
                .filter(part -> "stage.hint".equals(part.getName()))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void saysWhatToDoUntilSomethingWasDone() {
        assertTrue(hint().isVisible());
        guide.done();
        assertFalse(hint().isVisible());
        guide.hint("one", "Drag A or B");
        assertFalse(hint().isVisible(), "said again");
    }

    @Test
    void panelThatIsMadeAnewDoesNotSayItAgain() {
        guide.done();
        var again = new StageGuide(new JPanel(), Texts.of("canvas", Language.RUSSIAN), known());
        again.hint("one", "Перетащите A или B");
        assertFalse(again.getComponent(0).isVisible());
    }

    private Optional<History<?>> known() {
        return Optional.of(history);
    }

    @Test
    void anotherStageHasItsOwn() {
        guide.done();
        guide.hint("two", "Drag P");
        assertTrue(hint().isVisible());
    }

    @Test
    @DisplayName("the picture moves when the sentence goes, or the mouse does not reach it")
    void liesOnTheStageAndTakesNothingFromIt() {
        Rectangle before = stage.getBounds();
        Rectangle place = hint().getBounds();
        assertTrue(before.contains(place), place.toString());
        assertFalse(hint().contains(5, 5));
        guide.done();
        guide.doLayout();
        assertEquals(before, stage.getBounds());
    }

    @Test
    void changeOfTheLabAndStepOfThePlayerAreSomething() {
        var actions = new Actions(Texts.of("canvas", Language.ENGLISH));
        actions.addUndo(history);
        actions.whenChanged(guide::done);
        actions.refreshUndo();
        assertTrue(hint().isVisible(), "nothing was done");
        history.remember();
        actions.refreshUndo();
        assertFalse(hint().isVisible());
    }
}
