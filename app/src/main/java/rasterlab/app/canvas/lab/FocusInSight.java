package rasterlab.app.canvas.lab;

import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.event.FocusEvent;
import java.beans.PropertyChangeEvent;
import java.beans.PropertyChangeListener;
import javax.swing.JComponent;
import javax.swing.SwingUtilities;

/**
 * Scrolls a column to the control in it that gets the keyboard, other than by a click, which must
 * not move what is under the pointer.
 */
final class FocusInSight implements PropertyChangeListener {
    private static final String OWNER = "permanentFocusOwner";

    private final JComponent column;

    FocusInSight(JComponent column) {
        this.column = column;
    }

    void start() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager()
                .addPropertyChangeListener(OWNER, this);
    }

    void stop() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager()
                .removePropertyChangeListener(OWNER, this);
    }

    @Override
    public void propertyChange(PropertyChangeEvent change) {
        if (change.getNewValue() instanceof JComponent owner
                && SwingUtilities.isDescendingFrom(owner, column)
                && !isClick())
            column.scrollRectToVisible(
                    SwingUtilities.convertRectangle(owner.getParent(), owner.getBounds(), column));
    }

    private static boolean isClick() {
        return EventQueue.getCurrentEvent() instanceof FocusEvent gained
                && gained.getCause() == FocusEvent.Cause.MOUSE_EVENT;
    }
}
