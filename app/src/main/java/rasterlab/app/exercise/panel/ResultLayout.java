package rasterlab.app.exercise.panel;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Insets;
import java.awt.LayoutManager;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import rasterlab.app.canvas.lab.LargeType;

/**
 * The cases with the chosen one's reason and pictures beside them, or below them where the cases'
 * names take the width, in large type also where they leave none for the verdicts. Verdicts decide
 * nothing: a check moves no place.
 */
final class ResultLayout implements LayoutManager {
    private static final int GAP = 12;

    /** The least width of reason and pictures beside the cases, in sizes of the type. */
    private static final int BESIDE = 18;

    /** That least width in large type, which is smaller already than that of labels. */
    private static final int BESIDE_LARGE = 15;

    /** The height from which on the cases can stand above the pictures, in sizes of the type. */
    private static final int ABOVE = 16;

    /**
     * That height in large type, beside which half a row more counts for less than all verdicts.
     */
    private static final int ABOVE_LARGE = 11;

    /** Reason and buttons below the cases have so many tenths of the width. */
    private static final int WORDS = 4;

    private static final int WORDS_MOST = 6;

    /** The picture below the words has at least so much height, in sizes of the type. */
    private static final int PICTURE = 10;

    /** Rows of the cases that are seen at least, with their head. */
    private static final int ROWS = 4;

    private final CaseTable table;
    private final JScrollPane cases;
    private final Container words;
    private final Component picture;
    private final Component guide;

    /**
     * @param table in the type by which the parts are measured
     * @param cases what scrolls the table
     * @param words the chosen case's reason, and the buttons
     * @param guide stands in place of words and picture while it is visible
     */
    ResultLayout(
            CaseTable table,
            JScrollPane cases,
            Container words,
            Component picture,
            Component guide) {
        this.table = table;
        this.cases = cases;
        this.words = words;
        this.picture = picture;
        this.guide = guide;
    }

    @Override
    public void layoutContainer(Container parent) {
        int size = table.getFont().getSize();
        int width = parent.getWidth();
        int height = parent.getHeight();
        int gap = UIScale.scale(GAP);
        int bar = UIScale.scale(UIManager.getInt("ScrollBar.width")) + 2;
        int needed = table.needed() + bar;
        int most = width - gap - (LargeType.now() ? BESIDE_LARGE : BESIDE) * size;
        boolean tight = LargeType.now() ? needed > most : table.least() + bar > most;
        if (tight && height >= (LargeType.now() ? ABOVE_LARGE : ABOVE) * size) {
            int left = widthOfWords(width - gap, height - gap - ROWS * table.getRowHeight());
            int top = Math.min((height - gap) / 2, height - gap - heightOfWords(left));
            top = Math.max(top, ROWS * table.getRowHeight());
            cases.setBounds(0, 0, width, wholeRows(top));
            guide.setBounds(0, top + gap, width, height - top - gap);
            words.setBounds(0, top + gap, left, height - top - gap);
            picture.setBounds(left + gap, top + gap, width - left - gap, height - top - gap);
            return;
        }
        int left = Math.max(width / 2, Math.min(needed, most));
        int right = width - left - gap;
        cases.setBounds(0, 0, left, wholeRows(height));
        guide.setBounds(left + gap, 0, right, height);
        int lines = Math.min(heightOfWords(right), Math.max(height / 2, height - PICTURE * size));
        words.setBounds(left + gap, 0, right, lines);
        picture.setBounds(left + gap, lines + gap / 2, right, height - lines - gap / 2);
    }

    /** The largest height up to {@code height} at which the lower edge cuts no row. */
    private int wholeRows(int height) {
        Insets border = cases.getInsets();
        int head = table.getTableHeader().getPreferredSize().height;
        int around = border.top + border.bottom + head;
        int rows = (height - around) / table.getRowHeight();
        boolean all = rows >= table.getRowCount();
        return all || rows < 1 ? height : around + rows * table.getRowHeight();
    }

    /** The width of words, more than usual only where they would be cut at that height. */
    private int widthOfWords(int width, int most) {
        int tenths = WORDS;
        while (tenths < WORDS_MOST && heightOfWords(width * tenths / 10) > most) tenths++;
        return width * tenths / 10;
    }

    /** The height of the words wrapped to that width. */
    private int heightOfWords(int width) {
        for (int round = 0; round < 2; round++) {
            words.setSize(width, Short.MAX_VALUE);
            words.invalidate();
            layOut(words);
        }
        return words.getPreferredSize().height;
    }

    private static void layOut(Container parent) {
        parent.doLayout();
        for (Component each : parent.getComponents())
            if (each instanceof Container inner) layOut(inner);
    }

    @Override
    public Dimension preferredLayoutSize(Container parent) {
        return new Dimension(table.needed(), 0);
    }

    @Override
    public Dimension minimumLayoutSize(Container parent) {
        return new Dimension();
    }

    @Override
    public void addLayoutComponent(String name, Component component) {}

    @Override
    public void removeLayoutComponent(Component component) {}
}
