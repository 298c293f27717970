package rasterlab.app.canvas.player;

import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;

/**
 * Buttons, position and speed of a player in one row, or in as many as they need: the second
 * component gets what room is left in its row.
 */
final class PlayerRows implements LayoutManager {
    private static final int BETWEEN_ROWS = 4;

    private final int gap;

    /**
     * @param gap view units between components
     */
    PlayerRows(int gap) {
        this.gap = gap;
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        int room = parent.getWidth() > 0 ? parent.getWidth() : Integer.MAX_VALUE;
        int width = 0;
        int height = -BETWEEN_ROWS;
        for (List<Component> row : rows(parent, room)) {
            width = Math.max(width, row.stream().mapToInt(this::least).sum() - gap);
            height += height(row) + BETWEEN_ROWS;
        }
        return new Dimension(width, Math.max(0, height));
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension(0, preferredLayoutSize(parent).height);
    }

    @Override
    public void layoutContainer(Container parent) {
        int y = 0;
        for (List<Component> row : rows(parent, parent.getWidth())) {
            int tall = height(row);
            int rest = parent.getWidth() + gap - row.stream().mapToInt(this::least).sum();
            int x = 0;
            for (Component each : row) {
                boolean stretched = each == parent.getComponent(1);
                int wide = least(each) - gap + (stretched ? Math.max(0, rest) : 0);
                each.setBounds(x, y, wide, tall);
                x += wide + gap;
            }
            y += tall + BETWEEN_ROWS;
        }
    }

    private List<List<Component>> rows(Container parent, int room) {
        var rows = new ArrayList<List<Component>>();
        int used = Integer.MAX_VALUE;
        for (Component each : parent.getComponents()) {
            if (used > room - least(each) + gap) {
                rows.add(new ArrayList<>());
                used = 0;
            }
            rows.get(rows.size() - 1).add(each);
            used += least(each);
        }
        return rows;
    }

    /** The least width of a component with the gap behind it. */
    private int least(Component component) {
        return component.getMinimumSize().width + gap;
    }

    private static int height(List<Component> row) {
        return row.stream().mapToInt(each -> each.getPreferredSize().height).max().orElse(0);
    }

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}
}
