package rasterlab.app.canvas;

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
