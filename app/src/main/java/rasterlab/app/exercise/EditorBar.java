package rasterlab.app.exercise;

import com.formdev.flatlaf.FlatClientProperties;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.time.format.FormatStyle;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.UIManager;
import rasterlab.app.canvas.Copying;
import rasterlab.app.canvas.FlowRows;
import rasterlab.app.language.Texts;

/** The buttons above the editor: try, hand in, begin anew, undo. */
final class EditorBar extends JPanel {
    private static final long serialVersionUID = 1L;

    /** Small, like the buttons' margins, so that all stand in one row of a usual window. */
    private static final int GAP = 4;

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
    private final JButton copy;

    /**
     * @param onFailure told when there is no clipboard
     */
    EditorBar(
            ExerciseLabModel model,
            SourceEditor editor,
            Texts texts,
            Consumer<Throwable> onFailure) {
        super(new FlowRows(GAP));
        this.model = model;
        this.editor = editor;
        this.texts = texts;
        check = button("check", texts, model::check);
        submit = button("submit", texts, this::submit);
        server = button("server", texts, this::askServer);
        cancel = button("cancel", texts, model::cancel);
        undo = button("undo", texts, editor::undo);
        redo = button("redo", texts, editor::redo);
        draft = button("draft", texts, this::takeDraft);
        add(check);
        add(submit);
        add(server);
        add(cancel);
        add(button("starter", texts, model::restoreStarter));
        add(undo);
        add(redo);
        copy =
                button(
                        "copyCommand",
                        texts,
                        () -> model.command().ifPresent(line -> Copying.text(line, onFailure)));
        add(copy);
        add(typeSize());
        add(draft);
        FlowRows.keepWrapped(this);
        grow(0);
    }

    private static JButton button(String key, Texts texts, Runnable action) {
        JButton button = Controls.button(key, texts, action);
        button.putClientProperty(FlatClientProperties.STYLE, "margin: 2,5,2,5");
        return button;
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
        boolean running = state.work().running();
        check.setEnabled(!running);
        submit.setEnabled(!running);
        server.setEnabled(!running);
        cancel.setEnabled(running);
        copy.setEnabled(model.command().isPresent());
        undo.setEnabled(editor.canUndo());
        redo.setEnabled(editor.canRedo());
        List<DraftFile.Other> others = state.otherDrafts();
        draft.setVisible(!others.isEmpty());
        if (!others.isEmpty()) draft.setToolTipText(texts.text("draft.hint", when(others.get(0))));
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
