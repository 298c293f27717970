package rasterlab.app.canvas;

import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import javax.swing.AbstractAction;
import javax.swing.JComponent;
import javax.swing.KeyStroke;

/** Binds keys to actions; a character typed with Ctrl belongs to the window. */
public final class KeyBinding {
    private KeyBinding() {}

    /** Binds a key while the component itself has the focus. */
    public static void whenFocused(JComponent component, KeyStroke key, Runnable action) {
        bind(component, JComponent.WHEN_FOCUSED, key, action);
    }

    /**
     * Binds a key while the component or one inside it has the focus and does not use the key
     * itself.
     */
    public static void within(JComponent component, KeyStroke key, Runnable action) {
        bind(component, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT, key, action);
    }

    private static void bind(JComponent component, int when, KeyStroke key, Runnable action) {
        component.getInputMap(when).put(key, key.toString());
        component
                .getActionMap()
                .put(
                        key.toString(),
                        new AbstractAction() {
                            private static final long serialVersionUID = 1L;

                            @Override
                            public void actionPerformed(ActionEvent e) {
                                if (!typedWithControl(key, e.getModifiers())) action.run();
                            }
                        });
    }

    /** A typed key stroke fits with every modifier; AltGr is Ctrl with Alt on some systems. */
    private static boolean typedWithControl(KeyStroke key, int modifiers) {
        return key.getKeyEventType() == KeyEvent.KEY_TYPED
                && (modifiers & ActionEvent.CTRL_MASK) != 0
                && (modifiers & ActionEvent.ALT_MASK) == 0;
    }
}
