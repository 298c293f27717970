package rasterlab.app.canvas.lab;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.util.List;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.Wrapping;
import rasterlab.app.canvas.work.History;

/**
 * A sentence on a stage that says what to do there, until something was done: it lies over the
 * lower edge of the picture, which keeps its size when the sentence goes, and lets the mouse
 * through.
 */
final class StageHint extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final int PAD = 8;

    /** View units on the right, where the buttons are; on the left is the read-out. */
    private static final int ASIDE = 104;

    private static final int ABOVE_EDGE = 8;

    private final transient Optional<History<?>> history;
    private String key = "";
    private String sentence = "";
    private transient List<String> lines = List.of();

    /**
     * @param history remembers where something was done; empty where the lab itself knows
     */
    StageHint(Optional<History<?>> history) {
        super(AccessibleRole.LABEL);
        this.history = history;
        setName("stage.hint");
        setVisible(false);
    }

    /**
     * @param stage the same name for the same stage in every language
     */
    void show(String stage, String said) {
        key = stage;
        sentence = said;
        getAccessibleContext().setAccessibleName(said);
        refresh();
    }

    /** Something was done on the stage whose sentence is shown. */
    void done() {
        history.ifPresent(each -> each.tried(key));
        refresh();
    }

    private void refresh() {
        boolean tried = history.filter(each -> each.isTried(key)).isPresent();
        setVisible(!sentence.isEmpty() && !tried);
    }

    /** Lies at the lower edge of that part of its parent. */
    void place(Rectangle stage) {
        FontMetrics metrics = getFontMetrics(getFont());
        int most = Math.max(120, stage.width - 2 * ASIDE - 2 * PAD);
        lines = Wrapping.lines(sentence, most, metrics::stringWidth);
        int wide = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0) + 2 * PAD;
        int high = lines.size() * metrics.getHeight() + PAD;
        setBounds(
                stage.x + stage.width - ASIDE - wide,
                stage.y + stage.height - high - ABOVE_EDGE,
                wide,
                high);
    }

    @Override
    public boolean contains(int x, int y) {
        return false;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(0, 0);
    }

    /** Paints on the screen only, in no copied picture. */
    @Override
    public void paint(Graphics g) {
        if (!isPaintingForPrint()) super.paint(g);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        StageColors colors = StageColors.now();
        g.setColor(colors.margin());
        g.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, 10, 10);
        g.setColor(colors.focus());
        g.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, 10, 10);
        g.setColor(colors.ink());
        FontMetrics metrics = g.getFontMetrics(getFont());
        g.setFont(getFont());
        int y = PAD / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, (getWidth() - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
        g.dispose();
    }
}
