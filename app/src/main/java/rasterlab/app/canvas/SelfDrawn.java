package rasterlab.app.canvas;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import javax.accessibility.AccessibleContext;
import javax.accessibility.AccessibleRole;
import javax.swing.JComponent;

/** A component that draws itself and still tells assistive technology what it is. */
public abstract class SelfDrawn extends JComponent {
    private static final long serialVersionUID = 1L;

    private final AccessibleRole role;

    protected SelfDrawn(AccessibleRole role) {
        this.role = role;
    }

    /** Whether it has the keyboard and should say so, which no copied picture does. */
    protected final boolean showsFocus() {
        return isFocusOwner() && !isPaintingForPrint();
    }

    /** Draws anew whenever the keyboard comes or goes. */
    protected final void repaintOnFocus() {
        addFocusListener(
                new FocusAdapter() {
                    @Override
                    public void focusGained(FocusEvent e) {
                        repaint();
                    }

                    @Override
                    public void focusLost(FocusEvent e) {
                        repaint();
                    }
                });
    }

    /** Draws a frame at the edges, where it {@linkplain #showsFocus() has the keyboard}. */
    protected final void frameFocus(Graphics2D g) {
        if (!showsFocus()) return;
        g.setColor(StageColors.now().focus());
        g.setStroke(new BasicStroke(2));
        g.drawRect(1, 1, getWidth() - 2, getHeight() - 2);
    }

    @Override
    public AccessibleContext getAccessibleContext() {
        if (accessibleContext == null)
            accessibleContext =
                    new AccessibleJComponent() {
                        private static final long serialVersionUID = 1L;

                        @Override
                        public AccessibleRole getAccessibleRole() {
                            return role;
                        }
                    };
        return accessibleContext;
    }
}
