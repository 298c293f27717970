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

    static void request(Container root, String name) {
        find(root, name).ifPresent(Component::requestFocusInWindow);
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
