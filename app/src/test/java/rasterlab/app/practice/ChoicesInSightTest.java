package rasterlab.app.practice;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;

/** The buttons and fields beside the picture, laid out as a window of 1280×800 does it. */
class ChoicesInSightTest {
    private static final int WIDTH = 1280;
    private static final int HEIGHT = 738;

    /** A change of a width may ask for another height, and that for a third. */
    private static final int ROUNDS = 4;

    private final ConcurrentLinkedQueue<Runnable> events = new ConcurrentLinkedQueue<>();
    private final ConcurrentLinkedQueue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private final PracticeModel model =
            new PracticeModel(new PracticeExercises(), () -> 7, events::add, failures::add);
    private JPanel frame;
    private PracticePanel panel;

    /** Is laid out as what a window holds, and lies nowhere on a screen. */
    private static final class NoWindow extends JPanel {
        private static final long serialVersionUID = 1L;

        NoWindow() {
            super(new BorderLayout());
        }

        @Override
        public boolean isShowing() {
            return false;
        }
    }

    @AfterEach
    void endThread() {
        model.close();
        assertTrue(failures.isEmpty(), failures::toString);
    }

    static Stream<String> topics() {
        return Catalogue.builtIn().ids().stream()
                .filter(id -> id.startsWith("predict-"))
                .map(Catalogue.builtIn()::named)
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(Exercise::topic);
    }

    private void enter(String topic, Language language) throws Exception {
        model.enter(topic);
        model.settle();
        for (Runnable event = events.poll(); event != null; event = events.poll()) event.run();
        EventQueue.invokeAndWait(
                () -> {
                    LabTheme.LIGHT.install();
                    panel = new PracticePanel(model, language);
                    frame = new NoWindow();
                    frame.add(panel);
                    frame.setSize(WIDTH, HEIGHT);
                    frame.addNotify();
                    panel.refresh();
                });
    }

    /** Lays out as a window does: what is invalid, and again what its listeners made so. */
    private void layOut() throws Exception {
        for (int i = 0; i < ROUNDS; i++) EventQueue.invokeAndWait(frame::validate);
    }

    @ParameterizedTest(name = "{0}: a choice lies outside the column")
    @MethodSource("topics")
    void everyChoiceIsSeenWhole(String topic) throws Exception {
        Set<String> hidden = new LinkedHashSet<>();
        for (Language language : Language.values()) {
            enter(topic, language);
            int size = model.state().asked().orElseThrow().size();
            for (int i = 0; i < size; i++) {
                layOut();
                for (JToggleButton each : shown(panel, JToggleButton.class))
                    if (!each.getVisibleRect().equals(new Rectangle(each.getSize())))
                        hidden.add(language + ": " + each.getName() + " '" + each.getText() + "'");
                EventQueue.invokeAndWait(this::answerRightly);
            }
        }
        assertEquals(Set.of(), hidden);
    }

    private void answerRightly() {
        if (model.state().isAsking()) model.answer(model.state().question().right(), 0);
        if (model.state().resting() && !model.state().isThrough()) model.next();
        panel.refresh();
    }

    private static <C extends Component> List<C> shown(Container in, Class<C> type) {
        var found = new ArrayList<C>();
        for (Component each : in.getComponents()) {
            if (!each.isVisible()) continue;
            if (type.isInstance(each)) found.add(type.cast(each));
            if (each instanceof Container inner) found.addAll(shown(inner, type));
        }
        return found;
    }

    @Test
    void aDigitTypedIntoAFieldPressesNoChoice() throws Exception {
        enter("clip-segment", Language.RUSSIAN);
        layOut();
        EventQueue.invokeAndWait(
                () -> {
                    JTextField code = field("practice.decision");
                    press(code, '1', KeyEvent.VK_1);
                    press(code, '2', KeyEvent.VK_NUMPAD2);
                    assertEquals("12", code.getText());
                    assertFalse(
                            shown(panel, JToggleButton.class).stream()
                                    .anyMatch(JToggleButton::isSelected));
                });
    }

    @Test
    void aDigitPressesItsChoiceWhereNothingIsWritten() throws Exception {
        enter("clip-segment", Language.RUSSIAN);
        layOut();
        EventQueue.invokeAndWait(
                () -> {
                    List<JToggleButton> choices = shown(panel, JToggleButton.class);
                    press(choices.get(0), '2', KeyEvent.VK_2);
                    assertTrue(choices.get(1).isSelected());
                    press(choices.get(0), '3', KeyEvent.VK_NUMPAD3);
                    assertTrue(choices.get(2).isSelected());
                });
    }

    @Test
    void aDigitPressesItsChoiceWhileTheStepsHaveTheKeyboard() throws Exception {
        enter("clip-segment", Language.RUSSIAN);
        layOut();
        EventQueue.invokeAndWait(
                () -> {
                    JTextArea walk =
                            shown(panel, JTextArea.class).stream()
                                    .filter(each -> "practice.walk".equals(each.getName()))
                                    .findFirst()
                                    .orElseThrow();
                    press(walk, '2', KeyEvent.VK_2);
                    assertTrue(shown(panel, JToggleButton.class).get(1).isSelected());
                });
    }

    @Test
    void zeroOverThePictureIsAnAnswerWhereOneIsCalledSo() throws Exception {
        enter("triangulate", Language.RUSSIAN);
        layOut();
        int given = model.state().given();
        EventQueue.invokeAndWait(
                () -> {
                    JComponent stage =
                            shown(panel, JComponent.class).stream()
                                    .filter(each -> "practice.stage".equals(each.getName()))
                                    .findFirst()
                                    .orElseThrow();
                    press(stage, '0', KeyEvent.VK_0);
                });
        assertEquals(given + 1, model.state().given());
    }

    private JTextField field(String name) {
        return shown(panel, JTextField.class).stream()
                .filter(each -> name.equals(each.getName()))
                .findFirst()
                .orElseThrow();
    }

    /** Sends a key to the component that has the focus. */
    private static void press(JComponent focused, char letter, int code) {
        SwingUtilities.processKeyBindings(
                new KeyEvent(focused, KeyEvent.KEY_PRESSED, 0, 0, code, letter));
        SwingUtilities.processKeyBindings(
                new KeyEvent(focused, KeyEvent.KEY_TYPED, 0, 0, KeyEvent.VK_UNDEFINED, letter));
    }
}
