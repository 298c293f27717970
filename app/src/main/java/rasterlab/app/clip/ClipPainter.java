package rasterlab.app.clip;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.font.GlyphVector;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.engine.raster.PixelMark;

/** Draws what {@link ClipMark} stands for. */
final class ClipPainter {
    /** Region codes are so many times as large as labels: the first for which there is room. */
    private static final float[] LARGER = {1.5f, 1.2f, 1};

    private static final double MARK = 17;

    /** Where a wrong line bears its marks, as shares of its length. */
    private static final double[] MARKED = {0.2, 0.5, 0.8};

    private static final double[] MIDDLE = {0.5};

    /** View units from which a wrong line bears more than one mark. */
    private static final double ROOMY = 80;

    private static final int TRANSLUCENT = 60;

    private final Graphics2D g;
    private final PlaneMap map;
    private final StageColors colors;
    private final Color first;
    private final Color second;
    private final InView inView;
    private final List<Rectangle> labels;
    private final SignWordPlaces words;

    /**
     * @param other name of a second method, "" for none
     * @param labels where no region's code and no sign's words may stand
     */
    ClipPainter(
            Graphics2D g,
            PlaneMap map,
            StageColors colors,
            String method,
            String other,
            List<Rectangle> labels) {
        this.g = g;
        this.map = map;
        this.colors = colors;
        first = ClipColors.OWN.of(method);
        second = ClipColors.OWN.of(other);
        this.labels = labels;
        inView = new InView(map, g.getClipBounds());
        words = new SignWordPlaces(g.getClipBounds(), labels);
    }

    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    void paint(List<ClipMark> drawn, BooleanSupplier cancelled) {
        List<Line2D> segments = segments(drawn, inView, ClipMark.MarkMeaning.GIVEN);
        for (ClipMark each : drawn) {
            if (cancelled.getAsBoolean())
                throw new CancellationException("a newer frame is asked for");
            if (each instanceof ClipMark.MarkedArea area) paint(area);
            else if (each instanceof ClipMark.MarkedLine line) paint(line);
            else if (each instanceof ClipMark.Region region) paint(region, segments);
            else if (each instanceof ClipMark.MarkedSign sign) paint(sign);
        }
    }

    private void paint(ClipMark.MarkedArea area) {
        g.setColor(ground(area.ink()));
        inView.area(area.corners()).ifPresent(g::fill);
    }

    private Color ground(ClipMark.MarkMeaning ink) {
        return switch (ink) {
            case WINDOW -> colors.margin();
            case TESTED -> translucent(colors.focus());
            case LEFT, STEP -> translucent(first);
            default -> translucent(colors.axis());
        };
    }

    private static Color translucent(Color color) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), TRANSLUCENT);
    }

    private void paint(ClipMark.MarkedLine line) {
        Path2D path = inView.line(line.points(), line.closed());
        switch (line.ink()) {
            case WINDOW -> stroke(path, colors.ink(), 2f);
            case HIDDEN -> dashed(path, colors.axis(), 1.4f, 5);
            case HELP -> dashed(path, colors.axis(), 1f, 3);
            case GIVEN -> stroke(path, MethodColors.mix(colors.axis(), colors.ink(), 0.25), 1.6f);
            case LEFT -> edged(path, first, 5f);
            case STEP -> edged(path, first, 3f);
            case TESTED -> stroke(path, colors.focus(), 2.6f);
            case MISSING -> wrong(path, line, MethodColors.VERMILLION, PixelMark.MISSING);
            case EXTRA -> wrong(path, line, MethodColors.VERMILLION, PixelMark.EXTRA);
            case ONLY_FIRST -> wrong(path, line, first, PixelMark.EXTRA);
            case ONLY_SECOND -> wrong(path, line, second, PixelMark.MISSING);
        }
    }

    private void stroke(Path2D path, Color color, float width) {
        g.setColor(color);
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(path);
    }

    private void dashed(Path2D path, Color color, float width, float dash) {
        g.setColor(color);
        g.setStroke(
                new BasicStroke(
                        width,
                        BasicStroke.CAP_BUTT,
                        BasicStroke.JOIN_ROUND,
                        10f,
                        new float[] {dash, dash},
                        0));
        g.draw(path);
    }

    /** Draws a path with an edge that is seen on the ground, whatever the colour. */
    private void edged(Path2D path, Color color, float width) {
        stroke(path, MethodColors.edgeOn(colors.ground(), color), width + 1.5f);
        stroke(path, color, width);
    }

    /** Draws missing parts dashed with rings, and parts that are too much whole with crosses. */
    private void wrong(Path2D path, ClipMark.MarkedLine line, Color color, PixelMark mark) {
        if (mark == PixelMark.MISSING) {
            stroke(path, colors.ground(), 5f);
            dashed(path, color, 3.2f, 7);
        } else stroke(path, color, 2.4f);
        ClipPoint from = line.points().get(0);
        ClipPoint to = line.points().get(line.points().size() - 1);
        double right = map.viewX(to.x()) - map.viewX(from.x());
        double down = map.viewY(to.y()) - map.viewY(from.y());
        boolean roomy = Math.hypot(right, down) >= ROOMY;
        for (double share : roomy ? MARKED : MIDDLE) {
            double x = map.viewX(from.x()) + share * right;
            double y = map.viewY(from.y()) + share * down;
            mark.paint(g, x - MARK / 2, y - MARK / 2, MARK);
        }
    }

    /** Lines of that ink, such as what is to be clipped, where they are seen, in view units. */
    static List<Line2D> segments(List<ClipMark> drawn, InView inView, ClipMark.MarkMeaning ink) {
        var segments = new ArrayList<Line2D>();
        for (ClipMark each : drawn)
            if (each instanceof ClipMark.MarkedLine line && line.ink() == ink)
                add(segments, inView.line(line.points(), line.closed()));
        return segments;
    }

    private static void add(List<Line2D> segments, Path2D path) {
        var at = new double[6];
        var begin = new Point2D.Double();
        var from = new Point2D.Double();
        for (PathIterator i = path.getPathIterator(null); !i.isDone(); i.next()) {
            int kind = i.currentSegment(at);
            var to = kind == PathIterator.SEG_CLOSE ? begin : new Point2D.Double(at[0], at[1]);
            if (kind == PathIterator.SEG_MOVETO) begin = to;
            else segments.add(new Line2D.Double(from, to));
            from = to;
        }
    }

    /**
     * Colour of a region's code: less than the ink, yet to be read on the ground and in the window.
     */
    static Color code(StageColors colors) {
        return MethodColors.mix(colors.axis(), colors.ink(), 0.5);
    }

    /** Paints a region behind everything else. */
    private void paint(ClipMark.Region region, List<Line2D> segments) {
        Rectangle view = g.getClipBounds();
        double left = Math.max(view.getMinX(), map.viewX(region.xmin()));
        double right = Math.min(view.getMaxX(), map.viewX(region.xmax()));
        double top = Math.max(view.getMinY(), map.viewY(region.ymax()));
        double bottom = Math.min(view.getMaxY(), map.viewY(region.ymin()));
        var seen = new Rectangle2D.Double(left, top, right - left, bottom - top);
        var places = new CodePlace(seen, labels, segments);
        Font label = g.getFont();
        g.setColor(code(colors));
        for (float larger : LARGER) {
            Font font = label.deriveFont(label.getSize2D() * larger);
            GlyphVector code = font.createGlyphVector(g.getFontRenderContext(), region.words());
            Rectangle2D box = code.getVisualBounds();
            Optional<Rectangle2D> place = places.of(box.getWidth(), box.getHeight());
            if (place.isEmpty()) continue;
            g.setFont(font);
            g.drawString(
                    region.words(),
                    (float) (place.get().getX() - box.getX()),
                    (float) (place.get().getY() - box.getY()));
            g.setFont(label);
            return;
        }
    }

    private void paint(ClipMark.MarkedSign sign) {
        if (!inView.holds(sign.at())) return;
        double x = map.viewX(sign.at().x());
        double y = map.viewY(sign.at().y());
        SignShapes.paint(
                g,
                sign.shape(),
                x,
                y,
                Math.atan2(-sign.dy() * Math.abs(map.scaleY()), sign.dx() * map.scaleX()),
                colors);
        if (sign.words().isEmpty()) return;
        FontMetrics metrics = g.getFontMetrics();
        Rectangle place = words.take(x, y, metrics.stringWidth(sign.words()), metrics.getHeight());
        plate(sign.words(), place.x, place.y + metrics.getAscent());
    }

    private void plate(String said, int x, int y) {
        Color ground = colors.ground();
        Plates.plate(
                g,
                said,
                x,
                y,
                new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), 215),
                colors.ink());
    }
}
