package rasterlab.app.spline.curve;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Optional;
import javax.accessibility.AccessibleRole;
import rasterlab.app.canvas.SelfDrawn;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.spline.curve.SpanForm;

/** The blending functions of a span over u in [0, 1], with a dot on each at the present u. */
public final class BlendingChart extends SelfDrawn {
    private static final long serialVersionUID = 1L;

    private static final int SAMPLES = 64;
    private static final List<Color> COLORS =
            List.of(
                    MethodColors.BLUE,
                    MethodColors.ORANGE,
                    MethodColors.GREEN,
                    MethodColors.PURPLE,
                    MethodColors.SKY_BLUE);

    private transient Optional<SpanForm> form = Optional.empty();

    public BlendingChart(String said) {
        super(AccessibleRole.CANVAS);
        setName("blending");
        getAccessibleContext().setAccessibleName(said);
        setToolTipText(said);
    }

    public void show(SpanForm next) {
        form = Optional.of(next);
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(UIScale.scale(300), UIScale.scale(96));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        var g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        StageColors colors = StageColors.now();
        g.setColor(colors.ground());
        g.fillRect(0, 0, getWidth(), getHeight());
        g.setColor(colors.axis());
        g.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
        form.ifPresent(each -> paint(g, each, colors));
        g.dispose();
    }

    private void paint(Graphics2D g, SpanForm shown, StageColors colors) {
        double low = lowest(shown);
        double high = Math.max(1, highest(shown));
        var axes = new Axes(low, high, getWidth(), getHeight());
        g.setColor(colors.grid());
        g.draw(new Line2D.Double(0, axes.y(1), getWidth(), axes.y(1)));
        g.setColor(colors.axis());
        g.draw(new Line2D.Double(0, axes.y(0), getWidth(), axes.y(0)));
        g.draw(new Line2D.Double(axes.x(shown.u()), 0, axes.x(shown.u()), getHeight()));
        for (int i = 0; i < shown.weights().length; i++) {
            Color color = MethodColors.edgeOn(colors.ground(), COLORS.get(i % COLORS.size()));
            var path = new Path2D.Double();
            for (int k = 0; k <= SAMPLES; k++) {
                double u = (double) k / SAMPLES;
                double y = axes.y(shown.weightsAt(u)[i]);
                if (k == 0) path.moveTo(axes.x(u), y);
                else path.lineTo(axes.x(u), y);
            }
            g.setColor(color);
            g.setStroke(new BasicStroke(1.8f));
            g.draw(path);
            double x = axes.x(shown.u());
            double y = axes.y(shown.weights()[i]);
            g.fill(new Ellipse2D.Double(x - 4, y - 4, 8, 8));
        }
    }

    private static double lowest(SpanForm form) {
        double least = 0;
        for (int k = 0; k <= SAMPLES; k++)
            for (double each : form.weightsAt((double) k / SAMPLES)) least = Math.min(least, each);
        return least;
    }

    private static double highest(SpanForm form) {
        double most = 0;
        for (int k = 0; k <= SAMPLES; k++)
            for (double each : form.weightsAt((double) k / SAMPLES)) most = Math.max(most, each);
        return most;
    }

    /** Maps u and weight to the component, with a margin around. */
    private record Axes(double low, double high, int width, int height) {
        private static final double MARGIN = 8;

        double x(double u) {
            return MARGIN + u * (width - 2 * MARGIN);
        }

        double y(double weight) {
            return height - MARGIN - (weight - low) / (high - low) * (height - 2 * MARGIN);
        }
    }
}
