package rasterlab.app.shell.tab;

import java.awt.Component;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.event.KeyEvent;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;

/**
 * Keys that belong to the window, whatever in it has the keyboard: a table or a text scrolls by
 * some of them. A dialog's keys are its own.
 */
public final class WindowKeys implements KeyEventDispatcher, AutoCloseable {
    private final JComponent content;
    private final Map<KeyStroke, Runnable> actions = new HashMap<>();
    private final Map<KeyStroke, Predicate<Component>> tries = new HashMap<>();

    /**
     * @param content of the window
     */
    public WindowKeys(JComponent content) {
        this.content = content;
    }

    public void bind(KeyStroke key, Runnable action) {
        actions.put(key, action);
    }

    /**
     * @param tried given what has the keyboard, says whether it took the key from there
     */
    void bindWhere(KeyStroke key, Predicate<Component> tried) {
        tries.put(key, tried);
    }

    /** Hears keys until it is closed. */
    public void listen() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(this);
    }

    @Override
    public void close() {
        KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(this);
    }

    @Override
    public boolean dispatchKeyEvent(KeyEvent e) {
        KeyStroke key = KeyStroke.getKeyStrokeForEvent(e);
        if (tries.containsKey(key) && content.isShowing() && isOurs())
            return tries.get(key).test(e.getComponent());
        Optional<Runnable> action = Optional.ofNullable(actions.get(key));
        if (action.isEmpty() || !content.isShowing() || !isOurs()) return false;
        MenuSelectionManager.defaultManager().clearSelectedPath();
        action.get().run();
        return true;
    }

    private boolean isOurs() {
        return SwingUtilities.getWindowAncestor(content)
                == KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusedWindow();
    }
}
