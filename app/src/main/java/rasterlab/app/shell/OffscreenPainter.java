package rasterlab.app.shell;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.image.BufferedImage;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import rasterlab.app.canvas.work.Settling;

/** Paints components without a window, with or without a display. */
public final class OffscreenPainter {
    /**
     * The number of times that all is painted: pictures drawn in the background may then be painted
     * in the background.
     */
    private static final int ROUNDS = 2;

    private OffscreenPainter() {}

    /**
     * Lays the component out at that size, waits for pictures it makes in the background, and
     * paints it. Not on the event thread.
     *
     * @param width view units, at least 1
     * @param height view units, at least 1
     */
    public static BufferedImage paint(JComponent component, int width, int height)
            throws InterruptedException {
        var image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        onEventThread(() -> headTables(component));
        for (int i = 0; i < ROUNDS; i++) {
            onEventThread(() -> layOut(component, width, height));
            for (Settling settling : settling(component)) settling.settle();
        }
        onEventThread(
                () -> {
                    layOut(component, width, height);
                    var g = image.createGraphics();
                    component.paint(g);
                    g.dispose();
                });
        return image;
    }

    /** Tables put their column names above themselves only when their window is shown. */
    private static void headTables(Container container) {
        if (container instanceof JScrollPane scroll
                && scroll.getViewport().getView() instanceof JTable table)
            scroll.setColumnHeaderView(table.getTableHeader());
        for (Component child : container.getComponents())
            if (child instanceof Container inner) headTables(inner);
    }

    private static void layOut(JComponent component, int width, int height) {
        component.setSize(width, height);
        SettledLayout.of(component);
    }

    private static List<Settling> settling(Container container) {
        var found = new ArrayList<Settling>();
        if (!container.isVisible()) return found;
        if (container instanceof Settling settling) found.add(settling);
        for (Component child : container.getComponents())
            if (child instanceof Container inner) found.addAll(settling(inner));
        return found;
    }

    /** Runs on the event thread and waits; what it throws is thrown here. */
    public static void onEventThread(Runnable work) throws InterruptedException {
        try {
            EventQueue.invokeAndWait(work);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof RuntimeException cause) throw cause;
            if (e.getCause() instanceof Error cause) throw cause;
            throw new AssertionError("a Runnable throws no checked exception", e);
        }
    }
}
