package rasterlab.app.exercise.panel;

import java.awt.BorderLayout;
import java.awt.EventQueue;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.canvas.KeyBinding;
import rasterlab.app.canvas.lab.LabPanel;
import rasterlab.app.canvas.lab.LargeType;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.widget.NameChooser;
import rasterlab.app.canvas.work.Settling;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.HintView;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.VerdictLook;
import rasterlab.app.exercise.sheet.SheetFold;
import rasterlab.app.exercise.statement.StatementPane;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.exercises.Exercise;

/** The exercises as the window shows them, in one language. */
public final class ExercisePanel extends LabPanel implements Settling {
    private static final long serialVersionUID = 1L;

    private final transient ExerciseLabModel model;
    private final transient WindowEditor kept;
    private final transient OpenInLab lab;
    private final transient Consumer<Throwable> onFailure;
    private final transient Texts texts;
    private final NameChooser exercise;
    private final StatementPane statement;
    private SourceEditor editor;
    private WindowEditor.EditorPlace place;
    private EditorBar bar;
    private SheetFold sheet;
    private HintRow hints;
    private final JTextArea notice = Controls.words("notice");
    private final JTextArea unsaved = Controls.words("unsaved");
    private ResultPane result;
    private ExercisePanes rooms;
    private transient CourseMapPlace map;
    private transient Optional<JPanel> head = Optional.empty();
    private boolean running;
    private Notice said = Notice.NONE;
    private transient Runnable end = () -> {};

    /**
     * @param kept outlives the panel
     * @param lab shows a case in its topic's tab
     * @param onFailure told what a control could not do, on any thread
     */
    public ExercisePanel(
            ExerciseLabModel model,
            WindowEditor kept,
            OpenInLab lab,
            Language language,
            Consumer<Throwable> onFailure) {
        this.model = model;
        this.kept = kept;
        this.lab = lab;
        this.onFailure = onFailure;
        setName("exercises");
        texts = Texts.of("exercise", language);
        exercise = new NameChooser("exercise", ids(), this::title, model::choose);
        statement = new StatementPane(texts.text("statement"), model.formulas, onFailure);
    }

    @Override
    public List<Runnable> parts() {
        return List.of(this::placeEditor, this::addBar, this::addResult, this::putTogether);
    }

    private void placeEditor() {
        editor = kept.of(model);
        place = new WindowEditor.EditorPlace(editor, texts);
        end = place::close;
    }

    private void addBar() {
        bar = new EditorBar(model, kept, editor, lab, texts, onFailure);
    }

    private void addResult() {
        result =
                new ResultPane(
                        texts,
                        kept.rooms(),
                        lab,
                        model::bringToLabs,
                        this::goTo,
                        model::cancel,
                        onFailure);
    }

    private void putTogether() {
        notice.getAccessibleContext().setAccessibleName(texts.text("notice"));
        unsaved.getAccessibleContext().setAccessibleName(texts.text("notice"));
        unsaved.setForeground(VerdictLook.color("wrong", getBackground()));
        if (LargeType.now()) head = Optional.of(chooser("8 10 4 10"));
        result.setBorder(BorderFactory.createEmptyBorder(6, 10, 8, 10));
        rooms = new ExercisePanes(texts, kept.rooms(), task(), work(), result);
        map = new CourseMapPlace(model, kept, lab, texts.language(), this::turn);
        turn();
        keys();
        Runnable noState = model.listen(state -> refresh());
        end =
                () -> {
                    noState.run();
                    map.close();
                    place.close();
                    result.close();
                };
        if (model.state().outcome().isPresent() && kept.rooms().chosen().isEmpty())
            rooms.show(ExercisePanes.Room.RESULT);
    }

    /** Shows the exercise, or the map of the course. */
    private void turn() {
        removeAll();
        Optional<JPanel> course = map.shown();
        if (course.isPresent()) {
            add(course.get());
        } else {
            head.ifPresent(above -> add(above, BorderLayout.NORTH));
            add(rooms);
        }
        revalidate();
        repaint();
        focusPicture();
    }

    private void goTo(Outcome.Remark remark) {
        rooms.show(ExercisePanes.Room.PROGRAM);
        unfold(true);
        editor.goTo(remark.line(), remark.column());
    }

    /** Does what a first panel would take long for, and needs no panel; on any other thread. */
    public static void prepare(ExerciseLabModel model) {
        StatementPane.prepare(model.exercises().get(0), model.formulas);
        SourceEditor.prepare();
    }

    private List<String> ids() {
        return model.exercises().stream().map(Exercise::id).toList();
    }

    private String title(String id) {
        return model.exercises().stream()
                .filter(one -> one.id().equals(id))
                .map(one -> one.title(texts.locale().getLanguage()))
                .findFirst()
                .orElse(id);
    }

    private void keys() {
        editor.bind(KeyStroke.getKeyStroke("ctrl ENTER"), model::check);
        editor.bind(KeyStroke.getKeyStroke("ctrl shift Z"), editor::redo);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ctrl ENTER"), model::check);
        KeyBinding.within(this, KeyStroke.getKeyStroke("ESCAPE"), model::cancel);
    }

    private JPanel task() {
        hints = new HintRow(texts, model::takeHint);
        var scroll = new JScrollPane(statement);
        scroll.setName("statement.scroll");
        var task =
                new JPanel(
                        new MigLayout(
                                "insets 8 10 8 6, gap 8 8, wrap 1, hidemode 3",
                                "[grow,fill]",
                                LargeType.now() ? "[grow,fill][]" : "[][grow,fill][]"));
        if (!LargeType.now()) task.add(chooser("0"), "wmin 0");
        task.add(scroll, "grow, wmin 0, hmin 0");
        task.add(hints, "wmin 0");
        return task;
    }

    /**
     * The list of exercises beside its label above the statement, in large type above all, where it
     * has room; the map's button is below it where a title needs the width.
     */
    private JPanel chooser(String insets) {
        var row = new JPanel(new MigLayout("insets " + insets + ", gap 8", "[][grow,fill][]"));
        row.add(Controls.label("exercise", texts, exercise));
        row.add(exercise, "wmin 0");
        row.add(
                Controls.button("map", texts, () -> map.open()),
                LargeType.now() ? "" : "newline, skip, growx 0, gaptop 4");
        return row;
    }

    private JPanel work() {
        var work =
                new JPanel(
                        new MigLayout(
                                "insets 8 6 4 10, gap 0 6, wrap 1, hidemode 3", "[grow,fill]"));
        sheet = new SheetFold(texts, bar::toLab, this::unfold);
        work.add(bar, "wmin 0");
        work.add(sheet, "wmin 0");
        // Not a row's number: what is hidden takes none.
        work.add(place, "wmin 0, hmin 0, grow, push");
        work.add(notice, "wmin 0");
        work.add(unsaved, "wmin 0");
        return work;
    }

    /** Shows the document of a sheet, or folds it away. */
    private void unfold(boolean seen) {
        kept.showSheet(seen);
        fold();
        if (seen) editor.focus();
    }

    /** The document of a sheet is seen where it was unfolded, a text to write always. */
    private void fold() {
        boolean steps = model.state().exercise().form() == Exercise.TaskKind.PREDICT;
        sheet.setVisible(steps);
        sheet.tell(kept.isSheetSeen());
        place.setVisible(!steps || kept.isSheetSeen());
        revalidate();
    }

    /** Gives the keyboard to the editor, or to the way to the lab where the editor is folded. */
    @Override
    public void focusPicture() {
        if (map.shown().isPresent()) map.focus();
        else if (place.isVisible()) editor.focus();
        else sheet.focus();
    }

    /** Waits until nothing is checked; a server may never answer. */
    @Override
    public void settle() throws InterruptedException {
        var resting = new CountDownLatch(1);
        var listening = new AtomicReference<Runnable>();
        Consumer<ExerciseState> tellRest =
                state -> {
                    if (state.work().phase() != BackgroundWork.Phase.CHECKING) resting.countDown();
                };
        EventQueue.invokeLater(
                () -> {
                    listening.set(model.listen(tellRest));
                    tellRest.accept(model.state());
                });
        try {
            resting.await();
        } finally {
            EventQueue.invokeLater(() -> listening.get().run());
        }
    }

    /** Stops listening; work that runs goes on in the model. */
    @Override
    public void close() {
        end.run();
    }

    @Override
    public void refresh() {
        ExerciseState state = model.state();
        exercise.offer(ids(), state.exercise().id());
        HintView shown = model.hints();
        statement.show(state.exercise(), texts.locale().getLanguage(), hintText(shown));
        hints.show(shown, model.hintDesk().asking(), model.hintDesk().notice());
        editor.show(state.exercise().id(), state.exercise().form(), state.source());
        editor.remark(state.upToDate() ? state.outcome().orElseThrow().remarks() : List.of());
        bar.refresh();
        fold();
        say(notice, state.joins() ? Notice.of("joining") : state.notice());
        say(unsaved, state.unsaved());
        result.show(state, model.untried());
        turn(state);
    }

    /** The hints that were shown, as parts of the statement. */
    private String hintText(HintView view) {
        var told = new StringBuilder();
        for (int i = 0; i < view.shown().size(); i++)
            told.append("\n## ")
                    .append(texts.text("hint.step", i + 1, view.steps()))
                    .append("\n\n")
                    .append(view.shown().get(i).in(texts.language()))
                    .append('\n');
        return told.toString();
    }

    /** Turns to the result of what begins, and to the words above which it was asked for. */
    private void turn(ExerciseState state) {
        if (state.work().running() && !running && !state.joins()) {
            rooms.show(ExercisePanes.Room.RESULT);
            result.focusGiveUp();
        }
        boolean told = !state.notice().isEmpty() && !state.notice().equals(said);
        // This runs after the hidden room has passed the keyboard on.
        if (told && rooms.show(ExercisePanes.Room.PROGRAM)) EventQueue.invokeLater(bar::focus);
        running = state.work().running();
        said = state.notice();
    }

    private void say(JTextArea place, Notice said) {
        place.setText(said.in(texts));
        place.setVisible(!said.isEmpty());
    }
}
