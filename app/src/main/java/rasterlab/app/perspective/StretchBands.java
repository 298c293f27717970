package rasterlab.app.perspective;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;

/** Where γ runs away and where it begins to, as bands with their names; and γ = 1, its limit. */
final class StretchBands extends Annotation {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);

    private final Texts texts;
    private final double highest;

    /**
     * @param highest upper end of the γ axis
     */
    StretchBands(Texts texts, double highest) {
        super(false);
        this.texts = texts;
        this.highest = highest;
    }

    @Override
    public void paint(Graphics2D graphics) {
        graphics.setFont(FONT);
        graphics.setStroke(new BasicStroke(1f));
        band(graphics, 0, Stretch.RUNS_AWAY, 60);
        band(graphics, Stretch.RUNS_AWAY.end(), Stretch.EDGE, 25);
        int limit = getYAxisScreenValue(1);
        graphics.setColor(Color.DARK_GRAY);
        graphics.setStroke(
                new BasicStroke(
                        1f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_MITER, 1f, new float[] {6}, 0));
        graphics.drawLine(getXAxisScreenValueForMin(), limit, getXAxisScreenValueForMax(), limit);
        graphics.drawString(
                texts.text("limit"), getXAxisScreenValue(Stretch.EDGE.end()) + 10, limit + 18);
    }

    /** The bands' names stand one below the other, since they are wider than their bands. */
    private void band(Graphics2D graphics, double from, Stretch stretch, int alpha) {
        Color color = MethodColors.VERMILLION;
        int left = getXAxisScreenValue(from);
        int right = getXAxisScreenValue(stretch.end());
        int top = getYAxisScreenValue(highest);
        graphics.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha));
        graphics.fillRect(left, top, right - left, getYAxisScreenValue(0) - top);
        graphics.setColor(Color.DARK_GRAY);
        int y = top + 30 * (stretch.ordinal() + 1);
        int text = getXAxisScreenValue(Stretch.EDGE.end()) + 10;
        graphics.drawString(texts.text(stretch.code()), text, y);
        graphics.drawLine((left + right) / 2, y - 5, text - 5, y - 5);
    }
}
