package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.canvas.Parts;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.lab.StageGuide;
import rasterlab.app.canvas.work.History;
import rasterlab.app.card.TopicCard;
import rasterlab.app.card.TopicInput;
import rasterlab.app.language.Language;
import rasterlab.app.line.LineRoom;
import rasterlab.app.practice.PracticeCards;
import rasterlab.app.rooms.LabRooms;
import rasterlab.app.shell.labs.LabModels;
import rasterlab.app.shell.settings.LabLook;
import rasterlab.app.shell.settings.LabTheme;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.study.Hazard;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.TaskKind;
import rasterlab.exercises.catalogue.Catalogue;
import rasterlab.exercises.predicting.HandedAnswers;
import rasterlab.exercises.predicting.Question;
import rasterlab.exercises.predicting.Sheet;
import rasterlab.exercises.predicting.SheetText;

/** The mode "which is next?" in the tabs of the labs. */
class WhichIsNextTest {
    private final ConcurrentLinkedQueue<Throwable> failures = new ConcurrentLinkedQueue<>();
    private LabModels models;
    private LabTabs tabs;

    @BeforeEach
    void makeTabs() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    LabTheme.LIGHT.install();
                    models = LabModels.first(failures::add);
                    tabs = LabTabs.create(models, Language.RUSSIAN, failures::add);
                });
    }

    @AfterEach
    void close() throws InterruptedException {
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.close();
                    models.close();
                });
        assertTrue(failures.isEmpty(), failures::toString);
    }

    static Stream<String> topics() {
        return Catalogue.builtIn().ids().stream()
                .filter(id -> id.startsWith("predict-"))
                .map(id -> Catalogue.builtIn().named(id))
                .filter(one -> one.form() == TaskKind.PREDICT)
                .map(one -> one.topic());
    }

    /** A method that tells the lab's topic apart from another one of the same pictures. */
    private static final Map<String, String> METHODS =
            Map.of("visible-faces", "convex-segment", "hidden-surfaces", "scanline");

    /** Shows one of the topic's hazards, so that the lab is about the topic. */
    private static <M> void show(TopicCard<M> card, LabModels models) {
        Hazard<?> hazard = Topics.named(card.topic()).hazards().get(0);
        card.way()
                .show()
                .show(
                        models.of(card.lab()),
                        new TopicInput(card.topic(), hazard.name(), hazard.input()),
                        METHODS.getOrDefault(card.topic(), ""));
    }

    @ParameterizedTest(name = "the lab of {0} does not ask for its steps")
    @MethodSource("topics")
    void everyTopicWithQuestionsIsAskedForInItsLab(String topic) throws InterruptedException {
        TopicCard<?> card = LabRooms.card(topic);
        var title = new AtomicReference<String>();
        OffscreenPainter.onEventThread(
                () -> {
                    LabPanel lab = tabs.named(card.lab().name()).panel();
                    show(card, models);
                    press(lab, "questions");
                });
        settle(card.lab().name());
        OffscreenPainter.onEventThread(
                () ->
                        title.set(
                                find(
                                                tabs.named(card.lab().name()).panel(),
                                                "practice.title",
                                                JLabel.class)
                                        .getText()));
        assertEquals(Catalogue.builtIn().named("predict-" + topic).title().get("ru"), title.get());
    }

    private static void press(Container in, String name) {
        AbstractButton button = find(in, name, AbstractButton.class);
        assertTrue(button.isEnabled(), name);
        button.doClick();
    }

    /** The visible component of that name. */
    private static <C extends Component> C find(Container in, String name, Class<C> type) {
        return search(in, name).map(type::cast).orElseThrow(() -> new AssertionError(name));
    }

    private static Optional<Component> search(Container in, String name) {
        return Parts.shown(in).filter(each -> name.equals(each.getName())).findFirst();
    }

    private void settle(String tab) throws InterruptedException {
        OffscreenPainter.paint(tabs.named(tab).panel(), 1200, 760);
    }

    private LabPanel line() {
        return tabs.named("line").panel();
    }

    /** The questions that the line's lab asks, by the seed that it shows. */
    private Question question(int at) {
        long seed = Long.parseLong(find(line(), "practice.seed", JTextField.class).getText());
        return Sheet.of(
                        "line",
                        Catalogue.builtIn().named("predict-line").predicting().orElseThrow(),
                        seed)
                .questions()
                .get(at);
    }

    private void enterLine() throws InterruptedException {
        OffscreenPainter.onEventThread(() -> press(line(), "questions"));
        settle("line");
    }

    private String text(String name) {
        Component found = find(line(), name, Component.class);
        return found instanceof JLabel label ? label.getText() : ((JTextComponent) found).getText();
    }

    private void inLine(Consumer<LabPanel> work) throws InterruptedException {
        OffscreenPainter.onEventThread(() -> work.accept(line()));
        settle("line");
    }

    private static void type(LabPanel lab, String field, int value) {
        find(lab, "practice." + field, JTextField.class).setText("" + value);
    }

    private static void act(JComponent component, String key) {
        for (Component at = component; at instanceof JComponent each; at = at.getParent())
            for (int when :
                    new int[] {
                        JComponent.WHEN_FOCUSED, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT
                    }) {
                Object name = each.getInputMap(when).get(KeyStroke.getKeyStroke(key));
                if (name == null || each.getActionMap().get(name) == null) continue;
                each.getActionMap()
                        .get(name)
                        .actionPerformed(new java.awt.event.ActionEvent(each, 0, ""));
                return;
            }
        throw new AssertionError("nothing hears " + key);
    }

    @Test
    void aWrongAnswerIsToldAtOnceWithTheDecisionValue() throws InterruptedException {
        enterLine();
        Question asked = question(0);
        inLine(
                lab -> {
                    type(lab, "x", asked.right().get("x").intValue() + 2);
                    type(lab, "y", asked.right().get("y").intValue());
                    press(lab, "practice.answer");
                });
        assertEquals("✗ Неверно", text("practice.verdict"));
        String why = text("practice.why").replace('−', '-');
        assertTrue(why.contains("F(M)"), why);
        assertTrue(why.contains("здесь " + asked.reason().orElseThrow()), why);
        assertEquals("Верно: 0 из 1", text("practice.score"));
        assertEquals("Шаг 2 из 16", text("practice.position"));
    }

    @Test
    void arrowKeysAndEnterAnswerAPixel() throws InterruptedException {
        enterLine();
        Question asked = question(0);
        inLine(
                lab -> {
                    var stage = find(lab, "practice.stage", JComponent.class);
                    var before = asked.before().get(0);
                    go(
                            stage,
                            asked.right().get("x").intValue() - before.get("x").intValue(),
                            "RIGHT",
                            "LEFT");
                    go(
                            stage,
                            asked.right().get("y").intValue() - before.get("y").intValue(),
                            "DOWN",
                            "UP");
                    act(stage, "ENTER");
                });
        assertEquals("✓ Верно", text("practice.verdict"));
        assertEquals("Верно: 1 из 1", text("practice.score"));
    }

    private static void go(JComponent stage, int steps, String on, String back) {
        for (int i = 0; i < Math.abs(steps); i++) act(stage, steps > 0 ? on : back);
    }

    @Test
    void aClickOnAPixelAnswers() throws InterruptedException {
        enterLine();
        inLine(
                lab -> {
                    var stage = find(lab, "practice.stage", JComponent.class);
                    for (int kind : List.of(MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED))
                        stage.dispatchEvent(
                                new MouseEvent(
                                        stage, kind, 0, 0, 300, 300, 1, false, MouseEvent.BUTTON1));
                });
        assertEquals("Шаг 2 из 16", text("practice.position"));
        assertTrue(text("practice.score").endsWith("из 1"), text("practice.score"));
    }

    @Test
    void whatIsMissingIsAskedForAndCountsAsNoAnswer() throws InterruptedException {
        enterLine();
        inLine(
                lab -> {
                    type(lab, "x", 1);
                    press(lab, "practice.answer");
                });
        assertEquals("Укажите значение: y.", text("practice.why"));
        assertEquals("Верно: 0 из 0", text("practice.score"));
    }

    @Test
    void leavingShowsTheLabAsItWasWithItsUndo() throws InterruptedException {
        History<?> history = models.of(new LineRoom()).history();
        OffscreenPainter.onEventThread(
                () -> {
                    models.of(new LineRoom()).show(new Segment(0, 0, 9, 4));
                    models.of(new LineRoom()).show(new Segment(1, 1, 9, 4));
                    history.undo();
                });
        long changes = history.changes();
        enterLine();
        inLine(lab -> press(lab, "practice.newData"));
        inLine(lab -> act(find(lab, "practice.stage", JComponent.class), "ESCAPE"));
        assertTrue(search(line(), "practice.stage").isEmpty(), "the mode is left");
        assertTrue(search(line(), "questions").isPresent(), "the lab is seen");
        assertEquals(new Segment(0, 0, 9, 4), models.of(new LineRoom()).state().choice().segment());
        assertEquals(changes, history.changes());
        assertTrue(history.undoable());
        assertTrue(history.redoable());
    }

    @Test
    void theStripToHandInAnInputIsNotSeenOverTheQuestions() throws InterruptedException {
        var content = new AtomicReference<LabContent>();
        OffscreenPainter.onEventThread(
                () -> {
                    var look = LabLook.first(Language.RUSSIAN);
                    content.set(new LabContent(tabs, "line", look, chosen -> {}, chosen -> {}));
                    tabs.opening().showToHandIn("break-line", "line", "");
                });
        assertTrue(search(content.get(), "handIn.strip").isPresent(), "the strip is there");
        enterLine();
        assertTrue(search(content.get(), "handIn.strip").isEmpty(), "over the questions");
        inLine(lab -> act(find(lab, "practice.stage", JComponent.class), "ESCAPE"));
        assertTrue(search(content.get(), "handIn.strip").isPresent(), "the lab is back");
    }

    @Test
    void f1TellsOfTheQuestionsWhileTheyAreAsked() throws InterruptedException {
        assertEquals("line.segment", StageGuide.stageSeenIn(line()));
        enterLine();
        assertEquals(PracticeCards.HELP, StageGuide.stageSeenIn(line()));
    }

    @Test
    void aSheetIsAnsweredInItsLabAndHandedInWhenOpenStepsWereTold() throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named("predict-line");
        HandedAnswers begun = HandedAnswers.of(exercise, SheetText.open(exercise, 5));
        List<String> shown = new ArrayList<>();
        OffscreenPainter.onEventThread(
                () -> {
                    tabs.opening().showTabsBy(shown::add);
                    tabs.opening().answerSteps(exercise.id(), begun);
                });
        assertEquals(List.of("line"), shown);
        settle("line");
        inLine(
                lab -> {
                    type(lab, "x", 90);
                    type(lab, "y", 90);
                    press(lab, "practice.answer");
                });
        assertEquals("✗ Неверно", text("practice.verdict"));
        assertTrue(search(line(), "practice.newData").isEmpty(), "the data are given");
        assertEquals("Ответов: 1 из 16", text("practice.score"));
        assertEquals("Шаг 2 из 16", text("practice.position"));
        inLine(lab -> press(lab, "practice.before"));
        assertTrue(text("practice.why").contains("90"), text("practice.why"));
        inLine(lab -> press(lab, "practice.handIn"));
        assertEquals(List.of("line"), shown);
        assertTrue(text("practice.why").startsWith("Шагов без ответа: 15."), text("practice.why"));
        inLine(lab -> press(lab, "practice.handIn"));
        assertEquals(List.of("line", "exercises"), shown);
        assertTrue(search(line(), "practice.stage").isEmpty(), "the lab is seen again");
    }

    static Stream<Consumer<OpenInLab>> openings() {
        String segment = "{\"from\": [1, 2], \"to\": [9, 4]}";
        String hazard = Topics.named("line").hazards().get(0).name();
        return Stream.of(
                lab -> lab.showToHandIn("break-line", "line", segment),
                lab -> lab.showToHandIn("break-line", "line", ""),
                lab -> lab.showInput("line", segment, "", Optional.empty()),
                lab -> lab.showOwn("line", segment, ""),
                lab -> lab.showHazard("line", hazard, ""));
    }

    @ParameterizedTest(name = "what is opened in a lab stands behind the questions ({index})")
    @MethodSource("openings")
    void whatIsOpenedInTheLabIsSeen(Consumer<OpenInLab> opening) throws InterruptedException {
        enterLine();
        inLine(lab -> opening.accept(tabs.opening()));
        assertTrue(search(line(), "practice.stage").isEmpty(), "the questions are left");
        assertTrue(search(line(), "questions").isPresent(), "the lab is seen");
    }

    @Test
    void theModeGoesOnInAnotherLanguage() throws InterruptedException {
        enterLine();
        inLine(lab -> act(find(lab, "practice.stage", JComponent.class), "ENTER"));
        String seed = text("practice.seed");
        LabTabs russian = tabs;
        OffscreenPainter.onEventThread(
                () -> {
                    tabs = LabTabs.create(models, Language.ENGLISH, failures::add);
                    russian.close();
                    line();
                });
        settle("line");
        assertEquals(seed, text("practice.seed"));
        assertEquals("Step 2 of 16", text("practice.position"));
        assertFalse(search(line(), "questions").isPresent());
    }
}
