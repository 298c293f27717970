package rasterlab.app.precision;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import org.knowm.xchart.internal.chartpart.Annotation;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.chart.ChartLook;
import rasterlab.app.language.Texts;

/** Explains the marks and lines, and from where on a distance is longer than the depth itself. */
final class PrecisionNotes extends Annotation {
    private static final Font FONT = new Font(Font.SANS_SERIF, Font.PLAIN, 14);
    private static final int LINE = 20;
    private static final int MARGIN = 10;

    private final Texts texts;
    private final ChartLook paper;
    private final double bottom;
    private final double top;

    /**
     * @param bottom end of the distance axis
     * @param top its other end
     */
    PrecisionNotes(Texts texts, ChartLook paper, double bottom, double top) {
        super(false);
        this.texts = texts;
        this.paper = paper;
        this.bottom = bottom;
        this.top = top;
    }

    @Override
    public void paint(Graphics2D graphics) {
        int x = getXAxisScreenValueForMin();
        int highest = getYAxisScreenValue(top);
        int whole = getYAxisScreenValue(1);
        Color band = MethodColors.VERMILLION;
        graphics.setColor(new Color(band.getRed(), band.getGreen(), band.getBlue(), 30));
        graphics.fillRect(x, highest, getXAxisScreenValueForMax() - x, whole - highest);
        graphics.setFont(FONT);
        graphics.setColor(paper.note());
        // The note stands above the lines, which level off in the band's lower half.
        int ascent = graphics.getFontMetrics().getAscent();
        graphics.drawString(texts.text("whole"), x + MARGIN, highest + ascent + 2);
        int right = getXAxisScreenValueForMax() - MARGIN;
        int y = getYAxisScreenValue(bottom) - MARGIN;
        note(graphics, texts.text("line"), right, y);
        note(graphics, texts.text("mark"), right, y - LINE);
    }

    private static void note(Graphics2D graphics, String text, int right, int y) {
        graphics.drawString(text, right - graphics.getFontMetrics().stringWidth(text), y);
    }
}
