package rasterlab.app.shell.tab;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Toolkit;
import java.awt.event.AWTEventListener;
import java.awt.event.FocusEvent;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.KeyStroke;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import rasterlab.app.canvas.player.StepPlayer;

/**
 * The keys of the player that is seen, wherever the keyboard is: a chip or a list that was clicked
 * does not take them away.
 *
 * <p>They stay with a text that can be changed, with an open list or menu, and with a control that
 * was reached by the Tab key and uses the key itself, so that the keyboard alone can press it.
 */
public final class PlayerKeys implements AWTEventListener, AutoCloseable {
    private static final Set<FocusEvent.Cause> BY_TAB =
            Set.of(
                    FocusEvent.Cause.TRAVERSAL,
                    FocusEvent.Cause.TRAVERSAL_FORWARD,
                    FocusEvent.Cause.TRAVERSAL_BACKWARD,
                    FocusEvent.Cause.TRAVERSAL_UP,
                    FocusEvent.Cause.TRAVERSAL_DOWN);

    private final Supplier<Optional<StepPlayer>> player;
    private boolean byTab;

    /**
     * @param player the one that is seen; empty where there is none
     */
    public PlayerKeys(Supplier<Optional<StepPlayer>> player) {
        this.player = player;
    }

    /** Gives the window the keys. */
    public void bind(WindowKeys keys) {
        for (KeyStroke key : StepPlayer.keys()) keys.bindWhere(key, focus -> press(key, focus));
    }

    /** Hears how controls come to the keyboard until it is closed. */
    public void listen() {
        Toolkit.getDefaultToolkit().addAWTEventListener(this, AWTEvent.FOCUS_EVENT_MASK);
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(this);
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        if (event instanceof FocusEvent focus
                && focus.getID() == FocusEvent.FOCUS_GAINED
                && !focus.isTemporary()) byTab = BY_TAB.contains(focus.getCause());
    }

    /**
     * @return whether a player took it
     */
    private boolean press(KeyStroke key, Component focus) {
        if (isTaken(key, focus, byTab)) return false;
        Optional<StepPlayer> seen = player.get();
        seen.ifPresent(each -> each.press(key));
        return seen.isPresent();
    }

    /**
     * Whether the key belongs to what has the keyboard.
     *
     * @param byTab whether it was reached by the Tab key
     */
    static boolean isTaken(KeyStroke key, Component focus, boolean byTab) {
        if (focus instanceof JTextComponent text && text.isEditable()) return true;
        if (MenuSelectionManager.defaultManager().getSelectedPath().length > 0) return true;
        if (list(focus).filter(JComboBox::isPopupVisible).isPresent()) return true;
        return byTab && focus instanceof JComponent control && uses(control, key);
    }

    private static Optional<JComboBox<?>> list(Component focus) {
        if (focus instanceof JComboBox<?> list) return Optional.of(list);
        return Optional.ofNullable(
                (JComboBox<?>) SwingUtilities.getAncestorOfClass(JComboBox.class, focus));
    }

    /** A slider moves and a button is pressed by keys of the control itself. */
    private static boolean uses(JComponent control, KeyStroke key) {
        return List.of(JComponent.WHEN_FOCUSED, JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
                .stream()
                .anyMatch(when -> control.getInputMap(when).get(key) != null);
    }
}
