package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.FlatClientProperties;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JOptionPane;
import javax.swing.JPanel;
import javax.swing.UIManager;
import rasterlab.app.canvas.file.Copying;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.widget.FlowRows;
import rasterlab.app.canvas.widget.RunButtons;
import rasterlab.app.exercise.BackgroundWork;
import rasterlab.app.exercise.Beginning;
import rasterlab.app.exercise.DraftFile;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.exercise.ExerciseState;
import rasterlab.app.exercise.HandedInput;
import rasterlab.app.exercise.OtherTexts;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.language.Texts;
import rasterlab.app.server.Account;
import rasterlab.app.server.CourseServer;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.predicting.HandedAnswers;

/** The buttons above the editor: try, hand in, begin anew, undo. */
final class EditorBar extends JPanel {
    private static final long serialVersionUID = 1L;

    /**
     * The gap, as small as the buttons' margins, so that all stand in one row of a usual window.
     */
    private static final int GAP = 4;

    private final transient ExerciseLabModel model;
    private final transient WindowEditor kept;
    private final transient SourceEditor editor;
    private final transient OpenInLab lab;
    private final transient Texts texts;
    private final transient RunButtons running;
    private final JButton late;
    private final JButton undo;
    private final JButton redo;
    private final JButton draft;
    private final JButton copy;
    private final JButton inLab;

    /**
     * @param kept outlives the bar
     * @param lab runs the program in its topic's tab
     * @param onFailure told what a button could not do
     */
    EditorBar(
            ExerciseLabModel model,
            WindowEditor kept,
            SourceEditor editor,
            OpenInLab lab,
            Texts texts,
            Consumer<Throwable> onFailure) {
        super(new FlowRows(GAP));
        this.model = model;
        this.kept = kept;
        this.editor = editor;
        this.lab = lab;
        this.texts = texts;
        var check = button("check", texts, model::check);
        var submit = button("submit", texts, this::submit);
        var server = button("server", texts, this::askServer);
        var cancel = button("cancel", texts, model::cancel);
        late = button("submitLate", texts, () -> model.submit(true));
        running = new RunButtons(List.of(check, submit, late, server), cancel, editor::focus);
        undo = button("undo", texts, editor::undo);
        redo = button("redo", texts, editor::redo);
        draft = button("draft", texts, this::takeDraft);
        add(check);
        add(submit);
        add(late);
        add(server);
        add(cancel);
        inLab = button("inLab", texts, () -> showInLab(onFailure));
        add(inLab);
        add(button("starter", texts, this::restoreStarter));
        add(undo);
        add(redo);
        copy =
                button(
                        "copyCommand",
                        texts,
                        () -> model.command().ifPresent(line -> copy(line, onFailure)));
        add(copy);
        add(typeSize());
        add(draft);
        FlowRows.keepWrapped(this);
        grow(0);
    }

    private static JButton button(String key, Texts texts, Runnable action) {
        JButton button = Controls.button(key, texts, action);
        button.putClientProperty(FlatClientProperties.STYLE, "margin: 2,4,2,4");
        return button;
    }

    /**
     * Runs the text as it is in the tab of its topic, on the input that is shown there; an input is
     * shown there itself.
     */
    private void showInLab(Consumer<Throwable> onFailure) {
        ExerciseState state = model.state();
        try {
            if (state.exercise().form() == Exercise.TaskKind.PREDICT) {
                answerSteps(state.exercise(), state.source());
                return;
            }
            if (state.exercise().form() == Exercise.TaskKind.BREAK) {
                String input = HandedInput.last(state.source());
                lab.showToHandIn(state.exercise().id(), state.exercise().topic(), input);
                return;
            }
            model.bringToLabs(state.source());
            lab.showOwn(state.exercise().topic(), "", "");
        } catch (IllegalArgumentException e) {
            onFailure.accept(e);
        }
    }

    /** Goes on with the sheet in the tab of its topic. */
    private void answerSteps(Exercise exercise, String source) {
        Beginning beginning = model.beginning();
        model.begin(
                BackgroundWork.of(BackgroundWork.Phase.READING),
                tell -> {
                    HandedAnswers begun = beginning.sheet(source);
                    return () -> lab.answerSteps(exercise.id(), begun);
                },
                beginning.refused(model::tell));
    }

    /** Goes on in the lab, as its button does. */
    void toLab() {
        inLab.doClick();
    }

    private void offerLab(Exercise exercise) {
        inLab.setVisible(isOffered(exercise));
        if (exercise.form() != Exercise.TaskKind.WRITE) {
            inLab.setEnabled(true);
            boolean breaks = exercise.form() == Exercise.TaskKind.BREAK;
            inLab.setToolTipText(texts.text(breaks ? "inLab.break" : "inLab.predict"));
            return;
        }
        Optional<String> obstacle =
                lab.obstacleToOwn(exercise.topic())
                        .map(why -> why.in(Texts.of("canvas", texts.language()), exercise.topic()));
        inLab.setEnabled(obstacle.isEmpty());
        inLab.setToolTipText(obstacle.orElse(texts.text("inLab.hint")));
    }

    private boolean isOffered(Exercise exercise) {
        return switch (exercise.form()) {
            case WRITE -> true;
            case BREAK -> lab.handsIn(exercise.topic());
            case PREDICT -> lab.asksSteps(exercise.topic());
        };
    }

    /** Both buttons for the type's size, in one row whatever the width. */
    private JPanel typeSize() {
        var size = new JPanel(new FlowRows(GAP));
        size.add(button("smaller", texts, () -> grow(-1)));
        size.add(button("larger", texts, () -> grow(1)));
        return size;
    }

    /** Makes the type larger or smaller beside that of the window. */
    private void grow(int steps) {
        model.growType(steps);
        editor.setPoints(UIManager.getFont("Label.font").getSize() + model.kept().typeSteps());
    }

    void refresh() {
        ExerciseState state = model.state();
        running.refresh(state.work().running());
        late.setVisible(state.notice().key().startsWith(CourseServer.LATE));
        copy.setEnabled(model.command().isPresent());
        offerLab(state.exercise());
        undo.setEnabled(editor.canUndo());
        redo.setEnabled(editor.canRedo());
        List<DraftFile.Other> others = state.otherDrafts();
        draft.setVisible(!others.isEmpty());
        if (!others.isEmpty()) draft.setToolTipText(texts.text("draft.hint", when(others.get(0))));
    }

    /** Gives the keyboard to what began the last work. */
    void focus() {
        running.focus();
    }

    private String when(DraftFile.Other draft) {
        return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.SHORT)
                .withLocale(texts.locale())
                .withZone(ZoneId.systemDefault())
                .format(draft.changed());
    }

    private void takeDraft() {
        List<DraftFile.Other> others = model.state().otherDrafts();
        if (!others.isEmpty()) new OtherTexts(model).take(others.get(0));
    }

    /** Asks before it replaces a text that the user has written. */
    private void restoreStarter() {
        ExerciseState state = model.state();
        if (!state.source().equals(state.exercise().starter()) && !mayReplace()) return;
        model.restoreStarter();
        editor.focus();
    }

    private boolean mayReplace() {
        String[] answers = {texts.text("starter.replace"), texts.text("starter.keep")};
        return JOptionPane.showOptionDialog(
                        JOptionPane.getFrameForComponent(this),
                        texts.text("starter.question"),
                        texts.text("starter.title"),
                        JOptionPane.OK_CANCEL_OPTION,
                        JOptionPane.QUESTION_MESSAGE,
                        null,
                        answers,
                        answers[1])
                == JOptionPane.OK_OPTION;
    }

    private void copy(String command, Consumer<Throwable> onFailure) {
        Copying.toSystem().text(command, () -> model.tell(Notice.of("copied")), onFailure);
    }

    private void submit() {
        if (model.state().account().isEmpty()) askServer();
        else model.submit();
    }

    private void askServer() {
        Optional<Account> joined = model.state().account();
        var form = new JoinForm(texts, joined, kept.typed().orElse(JoinForm.Typed.first(joined)));
        form.ask(this, model);
        kept.type(form.typed());
    }
}
