package rasterlab.app.canvas.widget;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JComponent;

/** Rows from left to right that wrap at the container's width and ask for the height they need. */
public final class FlowRows implements LayoutManager {
    private final int gap;
    private final boolean middle;

    /**
     * @param gap view units between components and between rows
     */
    public FlowRows(int gap) {
        this(gap, false);
    }

    private FlowRows(int gap, boolean middle) {
        this.gap = gap;
        this.middle = middle;
    }

    /** Rows whose components, such as words beside buttons, stand in their middle. */
    public static FlowRows inTheMiddle(int gap) {
        return new FlowRows(gap, true);
    }

    /** Lays the container's surroundings out again whenever its width changes. */
    public static void keepWrapped(JComponent container) {
        container.addComponentListener(
                new ComponentAdapter() {
                    @Override
                    public void componentResized(ComponentEvent e) {
                        container.revalidate();
                    }
                });
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return flow(parent, parent.getWidth() > 0 ? parent.getWidth() : Integer.MAX_VALUE, false);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        flow(parent, parent.getWidth(), true);
        if (!middle) return;
        Stream.of(parent.getComponents())
                .filter(Component::isVisible)
                .collect(Collectors.groupingBy(Component::getY))
                .values()
                .forEach(FlowRows::center);
    }

    private static void center(List<Component> row) {
        int high = row.stream().mapToInt(Component::getHeight).max().orElseThrow();
        for (Component each : row)
            each.setLocation(each.getX(), each.getY() + (high - each.getHeight()) / 2);
    }

    private Dimension flow(Container parent, int width, boolean place) {
        List<Component> shown =
                Stream.of(parent.getComponents()).filter(Component::isVisible).toList();
        return flow(shown, Component::getPreferredSize, gap, width, place);
    }

    /**
     * The size of rows that are at most so wide, where one component is not wider.
     *
     * @param place whether the components get their places
     */
    public static Dimension flow(
            List<Component> components,
            Function<Component, Dimension> sizes,
            int gap,
            int width,
            boolean place) {
        int x = 0;
        int y = 0;
        int rowHeight = 0;
        int widest = 0;
        for (Component each : components) {
            Dimension size = sizes.apply(each);
            if (x > 0 && x + size.width > width) {
                y += rowHeight + gap;
                x = 0;
                rowHeight = 0;
            }
            if (place) each.setBounds(x, y, size.width, size.height);
            x += size.width + gap;
            rowHeight = Math.max(rowHeight, size.height);
            widest = Math.max(widest, x - gap);
        }
        return new Dimension(widest, y + rowHeight);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}
}
