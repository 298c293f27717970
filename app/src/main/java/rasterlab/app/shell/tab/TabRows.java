package rasterlab.app.shell.tab;

import com.formdev.flatlaf.ui.FlatTabbedPaneUI;
import com.formdev.flatlaf.ui.FlatUIUtils;
import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import java.util.Arrays;
import java.util.List;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;

/**
 * Titles of tabs in as many rows as they need, each in its place whichever is chosen: the first row
 * above the second. What stands before and behind the titles is as high as all rows.
 */
final class TabRows extends FlatTabbedPaneUI {
    /** Share of the line's colour in the ground of a chosen title in rows. */
    private static final double CHOSEN = 0.4;

    @Override
    protected LayoutManager createLayoutManager() {
        return new FromAbove();
    }

    @Override
    protected boolean shouldRotateTabRuns(int tabPlacement) {
        return false;
    }

    /** The offset up and down, as {@link FromAbove} turns the rows about. */
    @Override
    protected int getTabRunOffset(int tabPlacement, int tabCount, int tabIndex, boolean forward) {
        return -super.getTabRunOffset(tabPlacement, tabCount, tabIndex, !forward);
    }

    /**
     * Paints no line under a chosen title in rows, where it would seem to lie over a title of the
     * next row; a frame tells there that the keys move among the titles.
     */
    @Override
    protected void paintTabSelection(
            Graphics g, int tabPlacement, int tabIndex, int x, int y, int w, int h) {
        if (runCount < 2) super.paintTabSelection(g, tabPlacement, tabIndex, x, y, w, h);
        else if (FlatUIUtils.isPermanentFocusOwner(tabPane))
            frame((Graphics2D) g.create(x, y, w, h), w, h);
    }

    private static void frame(Graphics2D g, int width, int height) {
        g.setColor(StageColors.now().focus());
        g.setStroke(new BasicStroke(UIScale.scale(2f)));
        int inset = UIScale.scale(1);
        g.drawRect(inset, inset, width - 2 * inset, height - 2 * inset);
        g.dispose();
    }

    /** The title's ground, by which the chosen one is told in rows. */
    @Override
    protected Color getTabBackground(int tabPlacement, int tabIndex, boolean isSelected) {
        Color usual = super.getTabBackground(tabPlacement, tabIndex, isSelected);
        return isSelected && runCount > 1
                ? MethodColors.mix(tabPane.getBackground(), underlineColor, CHOSEN)
                : usual;
    }

    private final class FromAbove extends FlatTabbedPaneLayout {
        /** Swing puts the first row next to what the tabs show. */
        @Override
        protected void calculateTabRects(int tabPlacement, int tabCount) {
            super.calculateTabRects(tabPlacement, tabCount);
            List<Rectangle> titles = Arrays.asList(rects).subList(0, tabCount);
            int first = titles.stream().mapToInt(title -> title.y).min().orElse(0);
            int last = titles.stream().mapToInt(title -> title.y).max().orElse(0);
            for (Rectangle title : titles) title.y = first + last - title.y;
        }

        @Override
        public void layoutContainer(Container parent) {
            super.layoutContainer(parent);
            for (String end : List.of("leading", "trailing"))
                if (tabPane.getClientProperty("JTabbedPane." + end + "Component")
                        instanceof Component part) heighten(part.getParent());
        }

        private void heighten(Container end) {
            end.setSize(
                    end.getWidth(),
                    calculateTabAreaHeight(tabPane.getTabPlacement(), runCount, maxTabHeight));
            end.validate();
        }
    }
}
