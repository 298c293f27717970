package rasterlab.app.canvas.widget;

import javax.swing.JTextArea;
import javax.swing.text.DefaultCaret;

/** A sentence that is as high as the column's width makes it. */
public final class WrappedText extends JTextArea {
    private static final long serialVersionUID = 1L;

    public WrappedText(String name) {
        setName(name);
        setEditable(false);
        setFocusable(false);
        setOpaque(false);
        setLineWrap(true);
        setWrapStyleWord(true);
        setBorder(null);
        if (getCaret() instanceof DefaultCaret caret)
            caret.setUpdatePolicy(DefaultCaret.NEVER_UPDATE);
    }

    /** Shows a text unless it is shown already. */
    public void show(String text) {
        if (!text.equals(getText())) setText(text);
        getAccessibleContext().setAccessibleName(text);
    }
}
