package rasterlab.app.canvas.widget;

import java.awt.Component;
import java.awt.Window;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.SwingUtilities;

/**
 * Buttons that begin work, and the one that gives it up. While work runs only the latter can be
 * pressed; it has the keyboard where one of the others had it, which has it again afterwards. Else
 * Swing would hand the keyboard on to whatever button comes next.
 */
public final class RunButtons {
    private final List<JButton> begin;
    private final JButton cancel;
    private final Runnable elsewhere;
    private Optional<JButton> pressed = Optional.empty();

    /** The one that began the last work, which may have ended since. */
    private Optional<JButton> last = Optional.empty();

    /**
     * @param elsewhere gives the keyboard to the picture or the text, when the button to give work
     *     up had it and no other button began the work
     */
    public RunButtons(List<JButton> begin, JButton cancel, Runnable elsewhere) {
        this.begin = List.copyOf(begin);
        this.cancel = cancel;
        this.elsewhere = elsewhere;
        cancel.setEnabled(false);
    }

    /** Lets only those be pressed that do something now. On the event thread. */
    public void refresh(boolean running) {
        if (running == cancel.isEnabled()) return;
        if (running) begin(owner());
        else end(owner());
    }

    /**
     * The button that is clicked, to which the keyboard may still be on its way; else what has it,
     * also while a dialog is just being closed, from which it comes back.
     */
    private Optional<Component> owner() {
        return Stream.concat(begin.stream(), Stream.of(cancel))
                .filter(button -> button.getModel().isArmed())
                .map(Component.class::cast)
                .findFirst()
                .or(
                        () ->
                                Optional.ofNullable(SwingUtilities.getWindowAncestor(cancel))
                                        .map(Window::getMostRecentFocusOwner));
    }

    private void begin(Optional<Component> owner) {
        pressed =
                begin.stream()
                        .filter(button -> owner.filter(button::equals).isPresent())
                        .findFirst();
        last = pressed;
        cancel.setEnabled(true);
        begin.forEach(button -> button.setEnabled(false));
        // This comes after disabling: each disabled button passes the keyboard on.
        if (pressed.isPresent()) cancel.requestFocusInWindow();
    }

    /**
     * Moves the keyboard to the button that was used last, for one who comes back to try the same
     * again.
     */
    public void focus() {
        last.ifPresentOrElse(JButton::requestFocusInWindow, elsewhere);
    }

    private void end(Optional<Component> owner) {
        begin.forEach(button -> button.setEnabled(true));
        cancel.setEnabled(false);
        boolean stayed =
                owner.filter(one -> one == cancel || Optional.of(one).equals(pressed)).isPresent();
        if (stayed) pressed.ifPresentOrElse(JButton::requestFocusInWindow, elsewhere);
        pressed = Optional.empty();
    }
}
