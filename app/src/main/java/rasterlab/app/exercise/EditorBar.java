package rasterlab.app.exercise;

import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JProgressBar;
import net.miginfocom.swing.MigLayout;
import rasterlab.app.language.Texts;

/** The buttons above the editor: try, hand in, begin anew, undo. */
final class EditorBar extends JPanel {
    private static final long serialVersionUID = 1L;

    private final transient ExerciseLabModel model;
    private final transient SourceEditor editor;
    private final transient Texts texts;
    private final JButton check;
    private final JButton submit;
    private final JButton server;
    private final JButton cancel;
    private final JButton undo;
    private final JButton redo;
    private final JButton draft;
    private final JProgressBar progress = new JProgressBar();
    private int points;

    /**
     * @param points of the editor's text at first
     */
    EditorBar(ExerciseLabModel model, SourceEditor editor, Texts texts, int points) {
        super(new MigLayout("insets 0, gap 6 6, hidemode 3", "[][][][][grow,fill]"));
        this.model = model;
        this.editor = editor;
        this.texts = texts;
        this.points = points;
        check = Controls.button("check", texts, model::check);
        submit = Controls.button("submit", texts, this::submit);
        server = Controls.button("server", texts, this::askServer);
        cancel = Controls.button("cancel", texts, model::cancel);
        undo = Controls.button("undo", texts, editor::undo);
        redo = Controls.button("redo", texts, editor::redo);
        draft = Controls.button("draft", texts, this::takeDraft);
        check.putClientProperty("JButton.buttonType", "default");
        progress.setName("progress");
        progress.setStringPainted(true);
        progress.getAccessibleContext().setAccessibleName(texts.text("progress"));
        add(check);
        add(submit);
        add(server);
        add(cancel);
        add(progress, "wmin 40, hmin 20, wrap");
        add(tools(), "span, growx, wmin 0");
        editor.setPoints(points);
    }

    private JPanel tools() {
        var tools = new JPanel(new MigLayout("insets 0, gap 6, hidemode 3", "[][][][][][]"));
        tools.add(Controls.button("starter", texts, model::restoreStarter));
        tools.add(undo);
        tools.add(redo);
        tools.add(Controls.button("smaller", texts, () -> size(points - 1)));
        tools.add(Controls.button("larger", texts, () -> size(points + 1)));
        tools.add(draft);
        return tools;
    }

    /**
     * @param next held to what can be read
     */
    void size(int next) {
        points = Math.max(8, Math.min(40, next));
        editor.setPoints(points);
    }

    void refresh() {
        ExerciseState state = model.state();
        boolean running = state.work().running();
        check.setEnabled(!running);
        submit.setEnabled(!running);
        server.setEnabled(!running);
        cancel.setEnabled(running);
        undo.setEnabled(editor.canUndo());
        redo.setEnabled(editor.canRedo());
        progress.setVisible(running);
        if (running) show(state.work());
        List<DraftFile.Other> others = state.otherDrafts();
        draft.setVisible(!others.isEmpty());
        if (!others.isEmpty()) draft.setToolTipText(texts.text("draft.hint", when(others.get(0))));
    }

    private void show(Work work) {
        progress.setIndeterminate(work.of() == 0);
        progress.setMaximum(Math.max(1, work.of()));
        progress.setValue(work.done());
        String phase = work.phase().name().toLowerCase(java.util.Locale.ROOT);
        progress.setString(texts.text("phase." + phase, work.done(), work.of()));
    }

    private String when(DraftFile.Other draft) {
        return DateTimeFormatter.ofLocalizedDateTime(FormatStyle.SHORT)
                .withLocale(texts.locale())
                .withZone(ZoneId.systemDefault())
                .format(draft.changed());
    }

    private void takeDraft() {
        List<DraftFile.Other> others = model.state().otherDrafts();
        if (!others.isEmpty()) model.takeDraft(others.get(0));
    }

    private void submit() {
        if (model.state().account().isEmpty()) askServer();
        else model.submit();
    }

    private void askServer() {
        new JoinForm(texts, model.state().account()).ask(this, model);
    }
}
