package rasterlab.app.light.panel;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightFrame;

/** Brightness along the line by the three shadings, and what the eye makes of it. */
final class ProfilePainter {
    private static final int BESIDE = 8;
    private static final int RIGHT = 14;

    /** The most by which the eye's report overshoots. */
    private static final double LEAST = -0.15;

    private static final double MOST = 1.15;

    private static final double LEVELS = 0.25;

    private final Graphics2D g;
    private final Texts texts;
    private final LightFrame.DrawnFrame drawn;
    private final StageColors colors = StageColors.now();

    ProfilePainter(Graphics2D g, Texts texts, LightFrame.DrawnFrame drawn) {
        this.g = g;
        this.texts = texts;
        this.drawn = drawn;
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
        g.setRenderingHint(
                RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    }

    void paint(int width, int height) {
        g.setColor(colors.ground());
        g.fillRect(0, 0, width, height);
        FontMetrics metrics = g.getFontMetrics();
        Rectangle2D.Double box = box(width, height, metrics, texts.locale());
        Legend legend = legend();
        List<Rectangle> named =
                legend.places(metrics, (int) box.x, BESIDE, Math.max(1, (int) box.getMaxX()));
        int wrapped = named.get(named.size() - 1).y - named.get(0).y;
        box.setRect(box.x, box.y + wrapped, box.width, box.height - wrapped);
        if (box.width < 10 || box.height < 10) return;
        axes(box);
        nameBrightness(box);
        boolean mach = drawn.choice().mach();
        for (int i = 0; i < drawn.pictures().size(); i++) {
            LightFrame.ShadedPicture picture = drawn.pictures().get(i);
            Color color = MethodColors.edgeOn(colors.ground(), LightPainter.COLORS.get(i));
            if (mach) curve(picture.reported(), box, color, true);
            curve(picture.brightness(), box, color, false);
        }
        legend.paint(g, named, colors.ink());
    }

    /** Where the curves lie: what is written around it has the room that its type needs. */
    static Rectangle2D.Double box(int width, int height, FontMetrics metrics, Locale locale) {
        int top = metrics.getHeight() + 12;
        int bottom = metrics.getHeight() + 6;
        int left = nameRoom(metrics) + BESIDE;
        for (double level = 0; level <= 1; level += LEVELS)
            left =
                    Math.max(
                            left,
                            nameRoom(metrics)
                                    + metrics.stringWidth(level(level, locale))
                                    + 2 * BESIDE);
        return new Rectangle2D.Double(left, top, width - left - RIGHT, height - top - bottom);
    }

    /** Left of the levels, for a name written upwards. */
    private static int nameRoom(FontMetrics metrics) {
        return metrics.getHeight();
    }

    /**
     * Writes "brightness" upwards along the levels; left out where it is longer than they are high.
     */
    private void nameBrightness(Rectangle2D box) {
        FontMetrics metrics = g.getFontMetrics();
        String name = texts.text("brightness");
        int wide = metrics.stringWidth(name);
        if (wide > box.getHeight()) return;
        var upwards = (Graphics2D) g.create();
        upwards.setColor(colors.ink());
        upwards.translate(BESIDE / 2 + metrics.getAscent(), box.getCenterY() + wide / 2.0);
        upwards.rotate(-Math.PI / 2);
        upwards.drawString(name, 0, 0);
        upwards.dispose();
    }

    private static String level(double level, Locale locale) {
        return Shown.number(level, 2, locale);
    }

    private double y(double brightness, Rectangle2D box) {
        double share = (brightness - LEAST) / (MOST - LEAST);
        return box.getMaxY() - box.getHeight() * Math.max(0, Math.min(1, share));
    }

    private void axes(Rectangle2D box) {
        FontMetrics metrics = g.getFontMetrics();
        g.setStroke(new BasicStroke(1f));
        double apart = LEVELS;
        while (y(0, box) - y(apart, box) < metrics.getHeight() && apart < 1) apart *= 2;
        for (double level = 0; level <= 1; level += apart) {
            double y = y(level, box);
            g.setColor(level == 0 ? colors.axis() : colors.grid());
            g.draw(new Line2D.Double(box.getX(), y, box.getMaxX(), y));
            g.setColor(colors.ink());
            String text = level(level, texts.locale());
            g.drawString(
                    text,
                    (float) (box.getX() - BESIDE - metrics.stringWidth(text)),
                    (float) (y + metrics.getAscent() / 2.0 - 1));
        }
        g.setColor(colors.ink());
        int base = (int) box.getMaxY() + metrics.getAscent() + 3;
        g.drawString("A", (int) box.getX(), base);
        g.drawString("B", (int) box.getMaxX() - metrics.stringWidth("B"), base);
        String along = texts.text("profile.along");
        if (metrics.stringWidth(along) + 3 * metrics.stringWidth("A") > box.getWidth()) return;
        g.drawString(along, (int) (box.getCenterX() - metrics.stringWidth(along) / 2.0), base);
    }

    private void curve(double[] values, Rectangle2D box, Color color, boolean dashed) {
        var path = new Path2D.Double();
        for (int i = 0; i < values.length; i++) {
            double x = box.getX() + box.getWidth() * i / (values.length - 1);
            if (i == 0) path.moveTo(x, y(values[i], box));
            else path.lineTo(x, y(values[i], box));
        }
        g.setStroke(Legend.stroke(dashed));
        g.setColor(color);
        g.draw(path);
    }

    private Legend legend() {
        var entries = new ArrayList<Legend.Entry>();
        for (int i = 0; i < drawn.pictures().size(); i++) {
            LightFrame.ShadedPicture picture = drawn.pictures().get(i);
            if (picture.brightness().length == 0) continue;
            Color color = MethodColors.edgeOn(colors.ground(), LightPainter.COLORS.get(i));
            entries.add(new Legend.Entry(texts.text("shading." + picture.name()), color, false));
        }
        if (drawn.choice().mach())
            entries.add(new Legend.Entry(texts.text("profile.eye"), colors.ink(), true));
        return new Legend(entries);
    }
}
