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
