package rasterlab.app.course;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import net.miginfocom.swing.MigLayout;

/**
 * A table of chapters, each with its title above a line for each exercise. Where the width allows,
 * chapters stand side by side, in the course's order from left to right, in columns that are
 * aligned. It fits the width that there is: a long title is shortened, and nothing has to be
 * scrolled sideways.
 */
final class ChapterTable extends JPanel implements Scrollable {
    private static final long serialVersionUID = 1L;

    /** Number of cells of an exercise: title, kind, minutes, state and deadline. */
    private static final int CELLS = 5;

    private static final int GAP = 16;
    private static final int BLOCK_GAP = 40;
    private static final int INSETS = 26;
    private static final int INDENT = 10;
    private static final int HEAD_GAP = 14;

    /**
     * One line of a chapter.
     *
     * @param cells one for each column; the last one takes the columns that are left
     * @param head whether it belongs to the chapter's title
     */
    record ChapterRow(List<JComponent> cells, boolean head) {}

    private final transient MigLayout grid = new MigLayout("insets 4 10 12 16, gap " + GAP + " 1");
    private final transient List<List<JComponent>> headings = new ArrayList<>();
    private final transient List<List<ChapterRow>> chapters = new ArrayList<>();
    private final int most;
    private int abreast;

    /**
     * @param most how many chapters can stand side by side
     */
    ChapterTable(int most) {
        setLayout(grid);
        this.most = most;
    }

    /** Adds the headings of one more chapter that stands beside the others. */
    void addHeadings(List<JComponent> cells) {
        headings.add(List.copyOf(cells));
        cells.forEach(this::add);
    }

    void addChapter(List<ChapterRow> lines) {
        chapters.add(List.copyOf(lines));
        lines.forEach(line -> line.cells().forEach(this::add));
    }

    private void arrange(int width) {
        int next = Math.max(1, Math.min(most, (width - INSETS + BLOCK_GAP) / block()));
        if (next == abreast) return;
        abreast = next;
        grid.setColumnConstraints(columns());
        for (int i = 0; i < headings.size(); i++)
            for (JComponent each : headings.get(i)) each.setVisible(i < next);
        for (int i = 0; i < headings.size(); i++)
            place(new ChapterRow(headings.get(i), true), Math.min(i, next - 1), 0);
        int top = 1;
        for (int first = 0; first < chapters.size(); first += next) {
            var row = chapters.subList(first, Math.min(first + next, chapters.size()));
            for (int block = 0; block < row.size(); block++)
                for (int i = 0; i < row.get(block).size(); i++)
                    place(row.get(block).get(i), block, top + i);
            top += row.stream().mapToInt(List::size).max().orElseThrow();
        }
    }

    /** The columns of all blocks; the last one takes the width that is left. */
    private String columns() {
        if (most == 1) return "[grow,fill][][][][]";
        String block = "[fill][][][]";
        return (block + "[]" + BLOCK_GAP).repeat(abreast - 1) + block + "[grow]";
    }

    private void place(ChapterRow line, int block, int row) {
        int last = line.cells().size() - 1;
        for (int i = 0; i <= last; i++) {
            int span = i == last ? CELLS - last : 1;
            var how = new StringBuilder("hidemode 3, wmin 0");
            how.append(", cell ").append(block * CELLS + i).append(' ').append(row);
            how.append(' ').append(span).append(" 1");
            if (line.head() && row > 0 && line.cells().get(0) instanceof JLabel)
                how.append(", gaptop ").append(HEAD_GAP);
            if (line.head() && line.cells().get(i) instanceof JButton) how.append(", growx 0");
            if (!line.head() && i == 0) how.append(", gapleft ").append(INDENT);
            grid.setComponentConstraints(line.cells().get(i), how.toString());
        }
    }

    /** Width of a chapter with the gap to the next one, in pixels. */
    private int block() {
        int[] widest = new int[CELLS];
        for (List<ChapterRow> lines : chapters)
            for (ChapterRow line : lines)
                if (line.cells().size() == CELLS)
                    for (int i = 0; i < CELLS; i++)
                        widest[i] =
                                Math.max(widest[i], line.cells().get(i).getPreferredSize().width);
        return IntStream.of(widest).sum() + INDENT + GAP * (CELLS - 1) + BLOCK_GAP;
    }

    @Override
    public Dimension getPreferredSize() {
        arrange(getParent() instanceof JViewport seen ? seen.getWidth() : getWidth());
        return super.getPreferredSize();
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle seen, int orientation, int direction) {
        return 24;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle seen, int orientation, int direction) {
        return seen.height;
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return false;
    }
}
