package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Container;
import java.util.Optional;

/**
 * Finds a component again after the panels were made anew. Each tab names its own parts, so only
 * the tab that is shown is searched.
 */
final class FocusByName {
    private FocusByName() {}

    /** Asks for the focus, and says whether there is a component of that name to have it. */
    static boolean request(Container root, String name) {
        Optional<Component> found = find(root, name);
        found.ifPresent(Component::requestFocusInWindow);
        return found.isPresent();
    }

    static Optional<Component> find(Container root, String name) {
        for (Component child : root.getComponents()) {
            if (!child.isVisible()) continue;
            if (name.equals(child.getName())) return Optional.of(child);
            if (child instanceof Container inner) {
                Optional<Component> found = find(inner, name);
                if (found.isPresent()) return found;
            }
        }
        return Optional.empty();
    }
}
