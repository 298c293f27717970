package rasterlab.app.exercise.panel;

import java.awt.CardLayout;
import java.awt.Dimension;
import java.awt.Font;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.SpeedPicture;
import rasterlab.app.language.Texts;
import rasterlab.app.study.front.SpeedChart;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.published.PublishedSpeed;
import rasterlab.exercises.scene.MethodCase;
import rasterlab.exercises.scene.SceneFile;
import rasterlab.exercises.score.CaseReport;

/** The outcome of a source: verdict, points, every case with its reason and pictures. */
public final class ResultPane extends JPanel {
    private static final long serialVersionUID = 1L;

    private static final Predicate<CaseResult> CASE_OF_SPEED =
            one -> one.name().equals(CaseReport.SPEED);

    private final transient Texts texts;
    private final transient OpenInLab lab;
    private final transient Consumer<String> bring;
    private final ResultHead head;
    private final CardLayout cards = new CardLayout();
    private final JPanel answer = new JPanel(cards);
    private final JPanel cases;
    private final CaseTable table;
    private final RemarkList remarks;
    private final JTextArea reason = Controls.words("reason");
    private final JTextArea guide = Controls.words("guide");
    private final JScrollPane guideScroll = new JScrollPane(guide);
    private final JLabel viewLabel;
    private final NameChooser view;
    private final JPanel words = new JPanel();
    private final CaseCanvas picture;
    private final JButton open;
    private final transient SavedExercisePanes kept;
    private transient Optional<Outcome> shown = Optional.empty();

    /** The program's point on the topic's chart, where speed was measured. */
    private transient Optional<SpeedPicture> chart = Optional.empty();

    private Exercise.TaskKind form = Exercise.TaskKind.WRITE;

    /** The exercise that is shown; "" before one is. */
    private String exercise = "";

    /** Names of its cases that tell a counterexample in words of their own. */
    private transient Set<String> telling = Set.of();

    /**
     * @param kept which case was chosen in an earlier pane; takes what is chosen here
     * @param bring lets the labs run a source as a program for the exercise
     * @param toLine told the remark whose line the user wants to see
     * @param cancel gives up what runs
     */
    public ResultPane(
            Texts texts,
            SavedExercisePanes kept,
            OpenInLab lab,
            Consumer<String> bring,
            Consumer<Outcome.Remark> toLine,
            Runnable cancel,
            Consumer<Throwable> onFailure) {
        super(new MigLayout("insets 0, gap 0 6, wrap 1", "[grow,fill]", "[][grow,fill]"));
        this.texts = texts;
        this.kept = kept;
        this.lab = lab;
        this.bring = bring;
        table = new CaseTable(texts, this::chosen);
        remarks = new RemarkList(texts, toLine);
        picture = new CaseCanvas(texts, onFailure);
        view = new NameChooser("view", picture.views(), picture::nameOf, picture::choose);
        viewLabel = Controls.label("view", texts, view);
        KeyBinding.within(this, KeyStroke.getKeyStroke("B"), this::blink);
        open = Controls.button("open", texts, () -> openChosen(onFailure));
        reason.getAccessibleContext().setAccessibleName(texts.text("reason"));
        guide.getAccessibleContext().setAccessibleName(texts.text("guide.name"));
        guideScroll.setBorder(null);
        guideScroll.setName("guide.scroll");
        head = new ResultHead(texts, cancel);
        add(head, "wmin 0");
        cases = cases();
        answer.add(cases, "cases");
        var list = new JScrollPane(remarks);
        list.setName("remarks.scroll");
        answer.add(list, "remarks");
        add(answer, "grow, wmin 0, hmin 0");
    }

    private JPanel cases() {
        JScrollPane scroll = table.scrolled();
        scroll.setName("cases.scroll");
        words.setLayout(
                new MigLayout("insets 0, gap 0 6, wrap 1", "[grow,fill]", "[shrink 200][]"));
        var reasons = new JScrollPane(reason);
        reasons.setBorder(null);
        reasons.setName("reason.scroll");
        var controls = new JPanel(new FlowRows(6));
        controls.add(viewLabel);
        controls.add(view);
        controls.add(open);
        FlowRows.keepWrapped(controls);
        words.add(reasons, "wmin 0, hmin 0");
        words.add(controls, "wmin 0");
        var all = new JPanel(new ResultLayout(table, scroll, words, picture, guideScroll));
        all.add(scroll);
        all.add(words);
        all.add(picture);
        all.add(guideScroll);
        return all;
    }

    /**
     * Lays the parts out in the type of the pane's size, by which they are measured from the head
     * on.
     */
    @Override
    public void doLayout() {
        wear(ResultType.in(getSize()));
        offerToGiveUp();
        super.doLayout();
    }

    /** The label lies in the middle of its row of buttons. */
    private void wear(Font type) {
        if (type.equals(table.getFont()) && viewLabel.isPreferredSizeSet()) return;
        head.wear(type);
        List.of(table, reason, viewLabel, view, open, picture).forEach(part -> part.setFont(type));
        viewLabel.setPreferredSize(null);
        viewLabel.setPreferredSize(
                new Dimension(viewLabel.getPreferredSize().width, view.getPreferredSize().height));
    }

    private void showGuide(Exercise.TaskKind form) {
        guide.setText(
                texts.text(form == Exercise.TaskKind.WRITE ? "guide" : "guide." + form.code()));
        guide.setCaretPosition(0);
    }

    /**
     * @param untried what is shown before there is a result
     */
    public void show(ExerciseState state, List<CaseResult> untried) {
        boolean running = !state.work().cases().isEmpty();
        // The last one stays until the next one's cases come.
        Optional<Outcome> outcome = running ? Optional.empty() : state.outcome();
        boolean another = !state.exercise().id().equals(exercise);
        boolean other = another || !outcome.equals(shown);
        boolean begins = !another && outcome.isEmpty();
        if (another) showGuide(state.exercise().form());
        form = state.exercise().form();
        exercise = state.exercise().id();
        telling = telling(state.exercise());
        if (other)
            chart = outcome.flatMap(Outcome::speed).map(s -> chart(state.exercise().topic(), s));
        shown = outcome;
        Optional<String> chosen = toChoose(begins);
        List<CaseResult> judged = outcome.map(Outcome::cases).orElse(state.work().cases());
        table.show(
                merged(judged, untried),
                name -> state.exercise().caseTitle(name, texts.locale().getLanguage()));
        remarks.show(outcome.map(Outcome::remarks).orElse(List.of()));
        guide(outcome.isEmpty() && !state.work().running());
        cases.revalidate();
        cards.show(answer, tellsOfSource(state, outcome) ? "remarks" : "cases");
        head.show(state, outcome);
        offerToGiveUp();
        if (other) {
            chosen.ifPresent(table::choose);
            if (outcome.isPresent()) table.chooseAny();
            table.scrollToChosen();
        }
        showChosen();
    }

    /**
     * Whether remarks are all that there is. While another text is tried, its lines are not those
     * that they speak of.
     */
    private static boolean tellsOfSource(ExerciseState state, Optional<Outcome> outcome) {
        return outcome.filter(one -> one.cases().isEmpty() && !one.remarks().isEmpty()).isPresent()
                && (state.upToDate() || !state.work().running());
    }

    /**
     * @param begins whether the chosen case stays so, as a check of the same exercise begins
     */
    private Optional<String> toChoose(boolean begins) {
        return table.chosen()
                .filter(one -> begins)
                .map(CaseResult::name)
                .or(() -> kept.chosenCase(exercise, shown))
                .or(() -> shown.flatMap(Outcome::mostTelling).map(CaseResult::name));
    }

    /**
     * @param nothing whether there is nothing yet to be said of any case
     */
    private void guide(boolean nothing) {
        guideScroll.setVisible(nothing);
        words.setVisible(!nothing);
        picture.setVisible(!nothing);
    }

    /** The judged cases first, then those that were not. */
    private static List<CaseResult> merged(List<CaseResult> judged, List<CaseResult> untried) {
        var all = new ArrayList<>(judged);
        for (CaseResult one : untried)
            if (judged.stream().noneMatch(other -> other.name().equals(one.name()))) all.add(one);
        return all;
    }

    private void offerToGiveUp() {
        boolean alone = getParent() instanceof JTabbedPane;
        if (head.offerToGiveUp(alone)) table.requestFocusInWindow();
    }

    /** Gives the keyboard to the button that gives up what runs, where it is in sight. */
    void focusGiveUp() {
        head.focusGiveUp();
    }

    private void chosen() {
        table.chosen().ifPresent(one -> kept.chooseCase(exercise, shown, one.name()));
        showChosen();
    }

    /** Lets expected and actual picture blink, or stops that. */
    private void blink() {
        picture.toggleBlink();
        view.offer(picture.views(), picture.view());
    }

    private void showChosen() {
        Optional<CaseResult> chosen = table.chosen();
        String said = chosen.map(one -> one.message().in(texts.language())).orElse("");
        boolean smallest =
                shown.flatMap(Outcome::smallestCounterexample)
                        .filter(one -> chosen.filter(one::equals).isPresent())
                        .filter(one -> !telling.contains(one.name()))
                        .isPresent();
        String words = smallest ? texts.text("smallest", said) : said;
        String rule = chosen.map(one -> one.rule().in(texts.language())).orElse("");
        String told = words.isEmpty() ? hint(chosen) : words;
        reason.setText(rule.isEmpty() ? told : told + "\n" + rule);
        reason.setCaretPosition(0);
        chart.filter(one -> chosen.filter(CASE_OF_SPEED).isPresent())
                .ifPresentOrElse(
                        picture::show,
                        () -> picture.show(chosen.map(CaseResult::pictures).orElse(List.of())));
        view.offer(picture.views(), picture.view());
        view.setEnabled(chosen.filter(one -> !one.pictures().isEmpty()).isPresent());
        Optional<MethodCase> scene = chosen.flatMap(ResultPane::scene);
        Optional<String> obstacle = scene.flatMap(this::obstacle);
        open.setEnabled(scene.isPresent() && obstacle.isEmpty());
        open.setToolTipText(obstacle.orElse(texts.text("open.hint")));
    }

    private static Set<String> telling(Exercise exercise) {
        return exercise.cases().stream()
                .filter(one -> one.property().isPresent())
                .map(Exercise.Case::name)
                .collect(Collectors.toSet());
    }

    private SpeedPicture chart(String topic, PublishedSpeed speed) {
        return new SpeedPicture(new SpeedChart(topic, speed, texts.language()));
    }

    private String hint(Optional<CaseResult> chosen) {
        if (chosen.isEmpty()) return texts.text("hint.choose");
        if (chosen.get().verdict().isEmpty())
            return texts.text(head.works() ? "hint.notYet" : "hint.untried");
        if (chosen.get().right()) return texts.text("hint.right");
        return texts.text("hint.noPicture");
    }

    /** The case's input, where it has one that a lab can be given. */
    private static Optional<MethodCase> scene(CaseResult one) {
        if (one.scene().isEmpty()) return Optional.empty();
        return SceneFile.read(one.scene()) instanceof MethodCase found
                ? Optional.of(found)
                : Optional.empty();
    }

    private Optional<String> obstacle(MethodCase one) {
        return lab.obstacleToInputs(one.topic())
                .map(why -> why.in(Texts.of("canvas", texts.language()), one.topic()));
    }

    private void openChosen(Consumer<Throwable> onFailure) {
        MethodCase scene = table.chosen().flatMap(ResultPane::scene).orElseThrow();
        try {
            show(scene);
        } catch (IllegalArgumentException e) {
            onFailure.accept(e);
        }
    }

    /** Has the tried program run there, where a lab can; else what it did is shown as recorded. */
    private void show(MethodCase scene) {
        String right = scene.method().orElse("");
        boolean runs =
                form == Exercise.TaskKind.WRITE && lab.obstacleToOwn(scene.topic()).isEmpty();
        if (runs && shown.isPresent()) {
            bring.accept(shown.get().source());
            lab.showOwn(scene.topic(), scene.input(), right);
        } else {
            lab.showInput(scene.topic(), scene.input(), right, scene.plotted());
        }
    }

    /** Stops what blinks. */
    public void close() {
        picture.close();
    }
}
