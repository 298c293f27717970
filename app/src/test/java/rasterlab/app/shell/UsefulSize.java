package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import javax.accessibility.AccessibleRole;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.JViewport;

/** Whether pictures are large enough to be seen, and nothing lies beyond its place. */
final class UsefulSize {
    /** The least side of a picture, in view units: a fifth of the smallest window's height. */
    private static final int LEAST = 120;

    /** The most by which sizes rounded one by one are larger than their rounded sum. */
    private static final int ROUNDING = 6;

    private UsefulSize() {}

    /** The components of a laid out tab that are too small to be of use, or cannot be reached. */
    static List<String> faults(Container tab) {
        var faults = new ArrayList<String>();
        look(tab, faults);
        return faults;
    }

    private static void look(Container container, List<String> faults) {
        for (Component child : container.getComponents()) {
            if (!child.isVisible()) continue;
            String it = child.getClass().getSimpleName() + " " + child.getName();
            if (isPicture(child) && Math.min(child.getWidth(), child.getHeight()) < LEAST)
                faults.add(it + " is " + child.getWidth() + "×" + child.getHeight());
            if (child instanceof JScrollPane scroll && scroll.getViewport().getView() != null)
                scrolled(scroll, it, faults);
            if (!isPicture(child) && child instanceof Container inner) look(inner, faults);
            if (!(container instanceof JViewport) && !(container instanceof JTable))
                within(child, it, faults);
        }
    }

    /**
     * Whether a component is a large picture: in an inspector they are as small as their numbers.
     */
    private static boolean isPicture(Component child) {
        for (Container each = child.getParent(); each != null; each = each.getParent())
            if (each instanceof JViewport) return false;
        return child.getAccessibleContext() != null
                && child.getAccessibleContext().getAccessibleRole() == AccessibleRole.CANVAS;
    }

    /** A component wider than its place needs a bar to be reached. */
    private static void scrolled(JScrollPane scroll, String it, List<String> faults) {
        int wide = scroll.getViewport().getView().getWidth();
        int room = scroll.getViewport().getWidth();
        if (wide > room + ROUNDING && !scroll.getHorizontalScrollBar().isVisible())
            faults.add(it + " shows " + room + " of " + wide);
    }

    private static void within(Component child, String it, List<String> faults) {
        int right = child.getX() + child.getWidth() - child.getParent().getWidth();
        int below = child.getY() + child.getHeight() - child.getParent().getHeight();
        if (child.getParent().getWidth() > 0 && Math.max(right, below) > ROUNDING)
            faults.add(it + " is beyond its place by " + right + ", " + below);
    }
}
