package rasterlab.app.exercise.panel;

import java.awt.BorderLayout;
import java.util.Optional;
import javax.swing.JPanel;
import rasterlab.app.exercise.ExerciseLabModel;
import rasterlab.app.language.Texts;

/**
 * The one editor of a window, how the rooms around it were left, and what was typed for a course.
 * The panels of its languages and themes wear it in turn, so that caret, selection, scroll and what
 * can be undone outlive each of them. On the event thread.
 */
public final class WindowEditor {
    private final SavedExercisePanes rooms = new SavedExercisePanes();
    private Optional<SourceEditor> made = Optional.empty();
    private Optional<JoinForm.Typed> typed = Optional.empty();
    private boolean onMap;
    private boolean sheetSeen;

    public SavedExercisePanes rooms() {
        return rooms;
    }

    /** The text that was typed last for a course; empty before anything was. */
    Optional<JoinForm.Typed> typed() {
        return typed;
    }

    void type(JoinForm.Typed forACourse) {
        typed = Optional.of(forACourse);
    }

    /** Whether the map of the course is shown, and not an exercise. */
    boolean isOnMap() {
        return onMap;
    }

    void turnToMap(boolean shown) {
        onMap = shown;
    }

    /** Whether the document of a sheet is shown, and not only the way to its lab. */
    boolean isSheetSeen() {
        return sheetSeen;
    }

    void showSheet(boolean seen) {
        sheetSeen = seen;
    }

    SourceEditor of(ExerciseLabModel model) {
        if (made.isEmpty()) made = Optional.of(new SourceEditor(model::type));
        return made.get();
    }

    /** Where a panel has the editor, which is elsewhere until the panel before is closed. */
    static final class EditorPlace extends JPanel {
        private static final long serialVersionUID = 1L;

        private final SourceEditor editor;
        private final transient Texts texts;

        EditorPlace(SourceEditor editor, Texts texts) {
            super(new BorderLayout());
            this.editor = editor;
            this.texts = texts;
            if (editor.getParent() == null) take();
        }

        /** A panel that is made while the one before is still seen takes the editor at last. */
        @Override
        public void addNotify() {
            if (editor.getParent() != this) take();
            super.addNotify();
        }

        private void take() {
            editor.wear(texts);
            add(editor);
        }

        void close() {
            if (editor.getParent() != this) return;
            editor.close();
            remove(editor);
        }
    }
}
