package rasterlab.app.canvas.lab;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.JComponent;
import rasterlab.app.canvas.widget.FlowRows;

/**
 * A title and chips in rows that wrap at the container's width. Chips beyond two rows are hidden;
 * the last component then stands for them.
 */
final class ChipRows implements LayoutManager {
    /** More would take too much of the stage's height. */
    private static final int MOST_ROWS = 2;

    private final int gap;
    private final JComponent more;
    private final Dimension moreSize;
    private final IntConsumer onLeftOut;

    /**
     * @param gap view units between components and between rows
     * @param more the container's last component
     * @param moreSize its size, whatever it says
     * @param onLeftOut told how many chips {@code more} stands for when they are laid out
     */
    ChipRows(int gap, JComponent more, Dimension moreSize, IntConsumer onLeftOut) {
        this.gap = gap;
        this.more = more;
        this.moreSize = moreSize;
        this.onLeftOut = onLeftOut;
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        int width = parent.getWidth() > 0 ? parent.getWidth() : Integer.MAX_VALUE;
        return flow(shown(parent, width), width, false);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        List<Component> shown = shown(parent, parent.getWidth());
        onLeftOut.accept(parent.getComponentCount() - shown.size());
        for (Component each : parent.getComponents()) each.setVisible(shown.contains(each));
        flow(shown, parent.getWidth(), true);
    }

    /** All chips, or as many as there is room for, and what stands for the others. */
    private List<Component> shown(Container parent, int width) {
        List<Component> chips = new ArrayList<>(List.of(parent.getComponents()));
        chips.remove(more);
        int room = room(chips);
        if (flow(chips, width, false).height <= room) return chips;
        for (int kept = chips.size() - 1; kept > 0; kept--) {
            List<Component> some = new ArrayList<>(chips.subList(0, kept));
            some.add(more);
            if (flow(some, width, false).height <= room) return some;
        }
        return chips;
    }

    private int room(List<Component> chips) {
        int row = chips.stream().mapToInt(chip -> chip.getPreferredSize().height).max().orElse(0);
        return MOST_ROWS * (row + gap) - gap;
    }

    private Dimension flow(List<Component> components, int width, boolean place) {
        return FlowRows.flow(
                components,
                each -> each == more ? moreSize : each.getPreferredSize(),
                gap,
                width,
                place);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}
}
