package rasterlab.app.exercise.panel;

import java.awt.event.ActionEvent;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.text.BadLocationException;
import javax.swing.text.JTextComponent;
import org.fife.ui.rsyntaxtextarea.RSyntaxTextAreaEditorKit;

/**
 * Types a closing brace over the one that the editor has put around a selection, as it does with
 * other brackets; there would be one too many otherwise.
 */
final class ClosingBrace extends AbstractAction {
    private static final long serialVersionUID = 1L;
    private static final String NAME = RSyntaxTextAreaEditorKit.rstaCloseCurlyBraceAction;

    private final transient Action usual;

    private ClosingBrace(Action usual) {
        this.usual = usual;
    }

    /** Takes the place of the editor's own way to type a closing brace. */
    static void in(JTextComponent editor) {
        editor.getActionMap().put(NAME, new ClosingBrace(editor.getActionMap().get(NAME)));
    }

    @Override
    public void actionPerformed(ActionEvent typed) {
        var editor = (JTextComponent) typed.getSource();
        if (isBefore(editor)) editor.setCaretPosition(editor.getCaretPosition() + 1);
        else usual.actionPerformed(typed);
    }

    private static boolean isBefore(JTextComponent editor) {
        int at = editor.getCaretPosition();
        if (editor.getSelectionStart() != editor.getSelectionEnd()) return false;
        if (at == editor.getDocument().getLength()) return false;
        try {
            return editor.getText(at, 1).equals("}");
        } catch (BadLocationException e) {
            throw new IllegalStateException("the caret is beyond the text", e);
        }
    }
}
