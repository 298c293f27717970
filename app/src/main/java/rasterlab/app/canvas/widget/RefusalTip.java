package rasterlab.app.canvas.widget;

import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JToolTip;
import javax.swing.Popup;
import javax.swing.PopupFactory;

/** Why a field's text is refused, beside the field as long as it has the keyboard. */
final class RefusalTip {
    /** Pixels between the field and the reason, for the red frame. */
    private static final int APART = 4;

    private final JComponent field;
    private String reason = "";
    private Optional<Popup> shown = Optional.empty();

    RefusalTip(JComponent field) {
        this.field = field;
        field.addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        show();
                    }

                    @Override
                    public void focusLost(FocusEvent e) {
                        hide();
                    }
                });
        field.addHierarchyListener(
                e -> {
                    if (!field.isShowing()) hide();
                });
    }

    /**
     * @param next "" where nothing is refused
     */
    void tell(String next) {
        if (next.equals(reason)) return;
        reason = next;
        show();
    }

    private void show() {
        hide();
        if (reason.isEmpty() || !field.isFocusOwner()) return;
        JToolTip tip = field.createToolTip();
        tip.setName("refusal");
        tip.setTipText(reason);
        Point place = place(tip.getPreferredSize());
        Popup popup = PopupFactory.getSharedInstance().getPopup(field, tip, place.x, place.y);
        shown = Optional.of(popup);
        popup.show();
    }

    /** The place below the field, or above it where the screen ends. */
    private Point place(Dimension tip) {
        Point at = field.getLocationOnScreen();
        Rectangle screen = field.getGraphicsConfiguration().getBounds();
        int x = Math.max(screen.x, Math.min(at.x, screen.x + screen.width - tip.width));
        int below = at.y + field.getHeight() + APART;
        boolean fits = below + tip.height <= screen.y + screen.height;
        return new Point(x, fits ? below : at.y - APART - tip.height);
    }

    private void hide() {
        shown.ifPresent(Popup::hide);
        shown = Optional.empty();
    }
}
