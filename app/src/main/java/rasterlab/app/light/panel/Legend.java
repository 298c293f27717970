package rasterlab.app.light.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.util.ArrayList;
import java.util.List;

/** The legend above a chart: in one row, or in as many as the width asks for. */
record Legend(List<Entry> entries) {
    /** View units from the beginning of a curve's sample to its name. */
    private static final int TO_NAME = 28;

    /** View units from the end of a name to the next sample. */
    private static final int APART = 12;

    private static final int SAMPLE = 22;

    /** View units above the first row. */
    private static final int ABOVE = 5;

    /**
     * @param dashed how the curve is drawn
     */
    record Entry(String name, Color color, boolean dashed) {}

    Legend {
        entries = List.copyOf(entries);
    }

    /**
     * The entries' places.
     *
     * @param left where a row begins, if all entries have room behind it
     * @param least where a row begins else
     * @param right where a row ends
     */
    List<Rectangle> places(FontMetrics metrics, int left, int least, int right) {
        int all = entries.stream().mapToInt(each -> wide(each, metrics) + APART).sum() - APART;
        int from = Math.max(least, Math.min(left, right - all));
        var at = new Point(from, ABOVE);
        var places = new ArrayList<Rectangle>();
        for (Entry each : entries) {
            int wide = wide(each, metrics);
            if (at.x > from && at.x + wide > right)
                at.setLocation(from, at.y + metrics.getHeight());
            places.add(new Rectangle(at.x, at.y, wide, metrics.getHeight()));
            at.x += wide + APART;
        }
        return places;
    }

    private static int wide(Entry entry, FontMetrics metrics) {
        return TO_NAME + metrics.stringWidth(entry.name());
    }

    /**
     * @param places as {@link #places} gives them
     */
    void paint(Graphics2D g, List<Rectangle> places, Color ink) {
        for (int i = 0; i < entries.size(); i++) {
            int x = places.get(i).x;
            int base = places.get(i).y + g.getFontMetrics().getAscent();
            g.setStroke(stroke(entries.get(i).dashed()));
            g.setColor(entries.get(i).color());
            g.draw(new Line2D.Double(x, base - 5, x + SAMPLE, base - 5));
            g.setColor(ink);
            g.drawString(entries.get(i).name(), x + TO_NAME, base);
        }
    }

    /** Stroke of a curve and of its sample. */
    static BasicStroke stroke(boolean dashed) {
        return dashed
                ? new BasicStroke(1.2f, 1, 1, 10f, new float[] {5f, 4f}, 0f)
                : new BasicStroke(2.2f, 1, 1);
    }
}
