package rasterlab.app.shell.tab;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import rasterlab.app.canvas.lab.LabLayout;

/**
 * The layout of what has a lab in it, in parts that can be done in events of their own: first the
 * outer containers and the lab's own layout, then each of the lab's columns, then what is left.
 */
public final class LayoutParts {
    private LayoutParts() {}

    /**
     * @param whole has its size, and is shown or about to be, when the parts are done
     */
    public static List<Runnable> of(Container whole) {
        var parts = new ArrayList<Runnable>();
        parts.add(() -> layOutOuter(whole));
        addColumns(whole, parts);
        parts.add(whole::validate);
        return parts;
    }

    private static void layOutOuter(Container container) {
        container.doLayout();
        if (container instanceof LabLayout) return;
        for (Component each : container.getComponents())
            if (each instanceof Container inner && inner.isVisible()) layOutOuter(inner);
    }

    private static void addColumns(Container container, List<Runnable> parts) {
        for (Component each : container.getComponents())
            if (container instanceof LabLayout) parts.add(each::validate);
            else if (each instanceof Container inner) addColumns(inner, parts);
    }
}
