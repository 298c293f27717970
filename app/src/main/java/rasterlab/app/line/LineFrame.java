package rasterlab.app.line;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.DevicePixels;
import rasterlab.app.canvas.EdgeArrow;
import rasterlab.app.canvas.PictureType;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.Rulers;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.StageNote;
import rasterlab.app.canvas.ZoomedGrid;
import rasterlab.contract.Pixels;
import rasterlab.engine.line.Segment;

/**
 * One picture of the stage: all that painting it needs, so that any thread may.
 *
 * @param step pixels of the first drawing lit so far
 * @param width of the stage in view units
 * @param height of the stage in view units
 * @param scale device dots per view unit
 * @param font of a label
 * @param note a sentence over the picture, "" for none
 * @param zoom bounds of the buttons over it
 * @param locale of the ends' coordinates
 */
record LineFrame(
        LineDrawings drawings,
        int step,
        ZoomedGrid grid,
        int width,
        int height,
        double scale,
        StageColors colors,
        Font font,
        String note,
        Rectangle zoom,
        Locale locale) {
    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    BufferedImage painted(BooleanSupplier cancelled) {
        return DevicePixels.painted(width, height, scale, g -> paint(g, cancelled));
    }

    /**
     * @param g in view units
     * @throws CancellationException soon after {@code cancelled} says true
     */
    void paint(Graphics2D g, BooleanSupplier cancelled) {
        DevicePixels.smooth(g);
        var rulers = new Rulers(grid, new Dimension(width, height), colors, font);
        rulers.paintGrid(g);
        new LinePainter(g, grid, colors, cancelled).paint(drawings, step);
        g.setFont(font.deriveFont(Font.BOLD));
        StageNote said = note(note, new Dimension(width, height), font);
        paintLetters(g, said.below());
        rulers.paintMargins(g);
        said.paint(g, colors);
    }

    /** A sentence over the picture, beside the rulers. */
    static StageNote note(String said, Dimension stage, Font label) {
        return new StageNote(said, Rulers.inside(stage), label);
    }

    /**
     * The square around an end; of an end out of sight, at the edge, clear of the buttons.
     *
     * @param sight what rulers and the note leave of the stage
     * @param zoom bounds of the buttons
     */
    static Rectangle around(
            End end, Segment segment, ZoomedGrid grid, Rectangle sight, Rectangle zoom) {
        int size = (int) Math.max(PictureType.scaled(26), Math.min(60, grid.cell() * 1.5 + 6));
        return EdgeArrow.place(middle(end, segment, grid), size, sight, zoom);
    }

    /** Where the middle of an end's pixel lies, in sight or not. */
    static Point2D middle(End end, Segment segment, ZoomedGrid grid) {
        return new Point2D.Double(grid.viewX(end.x(segment)), grid.viewY(end.y(segment)));
    }

    /** Writes the ends' letters and coordinates. */
    private void paintLetters(Graphics2D g, Rectangle sight) {
        FontMetrics metrics = g.getFontMetrics();
        List<Rectangle> places = labels(metrics, sight);
        for (End end : End.values()) {
            Rectangle place = places.get(end.ordinal());
            Plates.plate(
                    g,
                    label(end, drawings.choice().segment(), locale),
                    place.x + 4,
                    place.y + 1 + metrics.getAscent(),
                    Plates.nearlyOpaque(colors.ground()),
                    colors.ink());
        }
    }

    /**
     * Where the ends' labels lie.
     *
     * @param sight what rulers and the note leave of the stage
     */
    List<Rectangle> labels(FontMetrics metrics, Rectangle sight) {
        Segment segment = drawings.choice().segment();
        var within = new Rectangle(sight.x + 3, sight.y + 4, sight.width - 8, sight.height - 11);
        List<Rectangle2D> seen = marked();
        seen.add(zoom);
        for (End end : End.values()) seen.add(around(end, segment, grid, sight, zoom));
        var places = new ArrayList<Rectangle>();
        for (End end : End.values()) {
            Rectangle place =
                    EndLabels.place(
                            metrics.stringWidth(label(end, segment, locale)) + 8,
                            metrics.getHeight() + 1,
                            marked(end, segment, sight),
                            (end == End.A) == (segment.y0() <= segment.y1()),
                            within,
                            seen);
            seen.add(place);
            places.add(place);
        }
        return places;
    }

    /** An end's ring, and its pixel where that is larger. */
    private Rectangle marked(End end, Segment segment, Rectangle sight) {
        Rectangle ring = around(end, segment, grid, sight, zoom);
        double x = grid.viewX(end.x(segment));
        double y = grid.viewY(end.y(segment));
        double cell = grid.cell();
        return ring.contains(x, y)
                ? new Rectangle2D.Double(x - cell / 2, y - cell / 2, cell, cell)
                        .createUnion(ring)
                        .getBounds()
                : ring;
    }

    static String label(End end, Segment segment, Locale locale) {
        return end + " " + Shown.point(end.x(segment), end.y(segment), locale);
    }

    /** The squares of the pixels in sight that are lit or bear a mark. */
    private List<Rectangle2D> marked() {
        var stage = new Rectangle(width, height);
        var marked = new ArrayList<Rectangle2D>();
        double size = Math.max(7, grid.cell());
        Pixels square =
                (x, y) -> {
                    var each =
                            new Rectangle2D.Double(
                                    grid.viewX(x) - size / 2, grid.viewY(y) - size / 2, size, size);
                    if (stage.intersects(each)) marked.add(each);
                };
        lit(drawings.drawing(), square);
        drawings.other().ifPresent(other -> lit(other, square));
        drawings.drawing().marks().missing(step, square);
        drawings.drawing().marks().extra(step, square);
        return marked;
    }

    private void lit(LineDrawing drawing, Pixels square) {
        int last = Math.min(step, drawing.pixels());
        for (int i = 1; i <= last; i++) square.plot(drawing.x(i), drawing.y(i));
    }
}
