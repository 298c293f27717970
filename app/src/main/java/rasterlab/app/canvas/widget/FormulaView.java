package rasterlab.app.canvas.widget;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.accessibility.AccessibleRole;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;

/**
 * Formulas with live numbers below each other, matrices in the textbook's layout. A line that is
 * too long for the component is written smaller.
 */
public final class FormulaView extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final float SMALLEST = 0.6f;

    private transient List<Formula> lines = List.of();

    public FormulaView(String name) {
        super(AccessibleRole.LABEL);
        setName(name);
    }

    public void show(List<Formula> formulas) {
        if (formulas.equals(lines)) return;
        lines = List.copyOf(formulas);
        String said = lines.stream().map(Formula::plainText).collect(Collectors.joining("\n"));
        getAccessibleContext().setAccessibleName(said);
        revalidate();
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        int height = 0;
        int width = 0;
        for (Formula line : lines) {
            FontMetrics metrics = getFontMetrics(base());
            width = Math.max(width, width(line, metrics));
            height += height(line, metrics) + gap();
        }
        return new Dimension(width, height);
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(0, getPreferredSize().height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setColor(UIManager.getColor("Label.foreground"));
        g.setStroke(new BasicStroke(UIScale.scale(1.2f)));
        int y = 0;
        for (Formula line : lines) {
            int full = height(line, getFontMetrics(base()));
            g.setFont(fitting(line));
            paint(g, line, y, full);
            y += full + gap();
        }
        g.dispose();
    }

    private static Font base() {
        return UIManager.getFont("Label.font");
    }

    private Font fitting(Formula line) {
        Font font = base();
        int needed = width(line, getFontMetrics(font));
        if (needed <= getWidth()) return font;
        float share = Math.max(SMALLEST, 0.98f * getWidth() / needed);
        return font.deriveFont(font.getSize2D() * share);
    }

    private static void paint(Graphics2D g, Formula line, int top, int height) {
        FontMetrics metrics = g.getFontMetrics();
        int x = 0;
        for (Formula.FormulaPart part : line.parts()) {
            if (part instanceof Formula.Matrix matrix) {
                int tall = height(matrix, metrics);
                paint(g, matrix, x, top + (height - tall) / 2);
            } else {
                int base = top + (height - metrics.getHeight()) / 2 + metrics.getAscent();
                g.drawString(part.plainText(), x, base);
            }
            x += width(part, metrics) + space(metrics);
        }
    }

    private static void paint(Graphics2D g, Formula.Matrix matrix, int left, int top) {
        FontMetrics metrics = g.getFontMetrics();
        int above = heads(matrix, metrics);
        int tall = height(matrix, metrics) - above;
        int wide = width(matrix, metrics);
        int hook = bracket(metrics) / 2;
        bracket(g, left, top + above, tall, hook);
        bracket(g, left + wide - 1, top + above, tall, -hook);
        int right = left + bracket(metrics);
        for (int column = 0; column < matrix.columns(); column++) {
            right += columnWidth(matrix, column, metrics);
            int base = top + metrics.getAscent() + 1;
            if (above > 0) {
                String head = matrix.heads().get(column);
                g.drawString(head, right - metrics.stringWidth(head), base - 1);
            }
            base += above;
            for (List<String> row : matrix.cells()) {
                String cell = row.get(column);
                g.drawString(cell, right - metrics.stringWidth(cell), base);
                base += metrics.getHeight();
            }
            right += 2 * space(metrics);
        }
    }

    private static void bracket(Graphics2D g, int x, int top, int tall, int hook) {
        g.drawPolyline(
                new int[] {x + hook, x, x, x + hook},
                new int[] {top, top, top + tall - 1, top + tall - 1},
                4);
    }

    private static int width(Formula line, FontMetrics metrics) {
        int width = 0;
        for (Formula.FormulaPart part : line.parts())
            width += width(part, metrics) + space(metrics);
        return width;
    }

    private static int width(Formula.FormulaPart part, FontMetrics metrics) {
        if (!(part instanceof Formula.Matrix matrix)) return metrics.stringWidth(part.plainText());
        int width = 2 * bracket(metrics) + (matrix.columns() - 1) * 2 * space(metrics);
        for (int column = 0; column < matrix.columns(); column++)
            width += columnWidth(matrix, column, metrics);
        return width;
    }

    private static int columnWidth(Formula.Matrix matrix, int column, FontMetrics metrics) {
        return Stream.concat(Stream.of(matrix.heads()), matrix.cells().stream())
                .filter(row -> !row.isEmpty())
                .mapToInt(row -> metrics.stringWidth(row.get(column)))
                .max()
                .orElse(0);
    }

    private static int height(Formula line, FontMetrics metrics) {
        return line.parts().stream()
                .mapToInt(
                        part ->
                                part instanceof Formula.Matrix matrix
                                        ? height(matrix, metrics)
                                        : metrics.getHeight())
                .max()
                .orElse(0);
    }

    private static int height(Formula.Matrix matrix, FontMetrics metrics) {
        return heads(matrix, metrics) + matrix.cells().size() * metrics.getHeight() + 2;
    }

    /** Height of the heads above the brackets. */
    private static int heads(Formula.Matrix matrix, FontMetrics metrics) {
        return matrix.heads().isEmpty() ? 0 : metrics.getHeight();
    }

    private static int space(FontMetrics metrics) {
        return metrics.charWidth(' ') + 1;
    }

    private static int bracket(FontMetrics metrics) {
        return metrics.charWidth('0');
    }

    private static int gap() {
        return UIScale.scale(6);
    }
}
