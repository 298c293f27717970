package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Lays out components that no window holds, and again those in which something has moved: what
 * depends on a width (wrapped chips and texts) may then want another height.
 */
final class SettledLayout {
    /** Parts that depend on their width rest after so many passes, and others would never. */
    private static final int PASSES = 4;

    private final Map<Container, Dimension> laidOutAt = new IdentityHashMap<>();
    private final Set<Container> unsettled = Collections.newSetFromMap(new IdentityHashMap<>());

    private SettledLayout() {}

    /** The component has its size already. */
    static void of(Container container) {
        var layout = new SettledLayout();
        int passes = 1;
        while (layout.movesParts(container) && passes < PASSES) passes++;
    }

    /** Lays out what is new, resized or unsettled; whether anything in it has moved. */
    private boolean movesParts(Container container) {
        boolean moved = false;
        boolean resized = !container.getSize().equals(laidOutAt.get(container));
        if (unsettled.remove(container) || resized) {
            List<Rectangle> before = places(container);
            container.invalidate();
            container.doLayout();
            laidOutAt.put(container, container.getSize());
            moved = !before.equals(places(container));
        }
        for (Component child : container.getComponents())
            if (child instanceof Container inner) moved |= movesParts(inner);
        if (moved) unsettled.add(container);
        return moved;
    }

    private static List<Rectangle> places(Container container) {
        return Stream.of(container.getComponents()).map(Component::getBounds).toList();
    }
}
