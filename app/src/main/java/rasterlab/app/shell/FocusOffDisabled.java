package rasterlab.app.shell;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.KeyboardFocusManager;
import java.awt.Window;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.beans.PropertyChangeListener;
import javax.swing.SwingUtilities;

/**
 * Hands the keyboard on from a button of a window that a short click disabled before the keyboard
 * came to it: Swing hands it on only from a component that has it when it is disabled.
 */
final class FocusOffDisabled extends WindowAdapter {
    private static final String OWNER = "permanentFocusOwner";

    private final Window window;
    private final PropertyChangeListener owners =
            change -> {
                if (change.getNewValue() instanceof Component owner && isHeldInVain(owner))
                    EventQueue.invokeLater(() -> handOn(owner));
            };

    private FocusOffDisabled(Window window) {
        this.window = window;
    }

    /** Watches a window from now on until it is closed. On the event thread. */
    static void in(Window window) {
        var keyboard = new FocusOffDisabled(window);
        manager().addPropertyChangeListener(OWNER, keyboard.owners);
        window.addWindowListener(keyboard);
    }

    @Override
    public void windowClosed(WindowEvent closed) {
        manager().removePropertyChangeListener(OWNER, owners);
    }

    private boolean isHeldInVain(Component owner) {
        return !owner.isEnabled() && SwingUtilities.isDescendingFrom(owner, window);
    }

    /** Hands the keyboard on, unless another place for it was asked for meanwhile. */
    private void handOn(Component owner) {
        if (owner.isFocusOwner() && isHeldInVain(owner)) owner.transferFocus();
    }

    private static KeyboardFocusManager manager() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager();
    }
}
