package rasterlab.app.polygon;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import javax.accessibility.AccessibleRole;
import javax.swing.UIManager;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.outcome.Runs;

/** How many places wait on a method's stack, step after step, and the present step. */
final class WaitingChart extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private final transient Texts texts;
    private transient Runs runs = new Runs();
    private Color color = Color.GRAY;
    private int step;

    WaitingChart(Texts texts) {
        super(AccessibleRole.ICON);
        this.texts = texts;
        setName("waitingChart");
    }

    /**
     * @param present as {@link PolygonLabState#step}
     */
    void show(Runs shown, String method, int present) {
        runs = shown;
        color = PolygonColors.OWN.of(method);
        step = Math.min(present, shown.size());
        getAccessibleContext()
                .setAccessibleName(texts.text("waiting.most", runs.mostWaiting(), runs.size()));
        setToolTipText(texts.text("waiting.hint"));
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(200), UIScale.scale(84));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        StageColors colors = StageColors.now();
        g.setColor(colors.ground());
        g.fillRect(0, 0, getWidth() - 1, getHeight() - 1);
        g.setFont(UIManager.getFont("small.font"));
        FontMetrics metrics = g.getFontMetrics();
        int top = metrics.getHeight() + 4;
        paintCurve(g, top, colors);
        g.setColor(colors.ink());
        String most = texts.text("waiting.most", runs.mostWaiting(), runs.size());
        g.drawString(most, 6, metrics.getAscent() + 3);
        g.setColor(UIManager.getColor("Component.borderColor"));
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        g.dispose();
    }

    private void paintCurve(Graphics2D g, int top, StageColors colors) {
        if (runs.size() == 0) return;
        double height = getHeight() - top - 5;
        double most = Math.max(1, runs.mostWaiting());
        double bottom = top + height;
        var curve = new Path2D.Double();
        curve.moveTo(1, bottom);
        // A column that stands for many steps shows the one with the most waiting places.
        int wide = getWidth() - 2;
        for (int column = 0; column < wide; column++) {
            int from = (int) ((long) column * runs.size() / wide);
            int to = Math.max(from + 1, (int) ((column + 1L) * runs.size() / wide));
            int waiting = 0;
            for (int run = from; run < to; run++) waiting = Math.max(waiting, runs.waiting(run));
            curve.lineTo(1 + column, bottom - height * waiting / most);
            curve.lineTo(2 + column, bottom - height * waiting / most);
        }
        curve.lineTo(1 + wide, bottom);
        g.setColor(MethodColors.mix(colors.ground(), color, 0.35));
        g.fill(curve);
        g.setColor(MethodColors.edgeOn(colors.ground(), color));
        g.setStroke(new BasicStroke(1.4f));
        g.draw(curve);
        double x = 1 + (double) wide * step / runs.size();
        g.setColor(colors.focus());
        g.setStroke(new BasicStroke(2));
        g.draw(new Line2D.Double(x, top, x, bottom));
    }
}
