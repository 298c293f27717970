package rasterlab.app.line;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import rasterlab.app.canvas.MethodColours;
import rasterlab.app.canvas.PixelGrid;
import rasterlab.app.canvas.StageColours;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelMark;

/** Draws one state of the line lab onto a zoomed pixel grid. */
final class LinePainter {
    /** Beyond this many view units Java2D's own clipping loses precision. */
    private static final double FAR = 1e5;

    private final Graphics2D g;
    private final PixelGrid grid;
    private final StageColours colours;

    LinePainter(Graphics2D g, PixelGrid grid, StageColours colours) {
        this.g = g;
        this.grid = grid;
        this.colours = colours;
    }

    void paint(LineLabState state) {
        paintPixels(state.drawing(), state.step());
        state.other().ifPresent(other -> paintOther(other, state));
        paintMarks(state);
        paintExactLine(state.choice().segment());
        if (state.step() > 0) paintCurrent(state.drawing(), state.step());
    }

    private void paintPixels(LineDrawing drawing, int step) {
        Color fill = MethodColours.of(drawing.method());
        Color edge = MethodColours.edgeOn(colours.ground(), fill);
        double gap = grid.cell() >= 6 ? 1 : 0;
        for (int i = 1; i <= step; i++) {
            Rectangle2D square = square(drawing.x(i), drawing.y(i), gap);
            if (!g.hitClip(
                    (int) square.getX() - 1,
                    (int) square.getY() - 1,
                    (int) square.getWidth() + 3,
                    (int) square.getHeight() + 3)) continue;
            g.setColor(fill);
            g.fill(square);
            if (gap == 0) continue;
            g.setColor(edge);
            g.setStroke(new BasicStroke(1f));
            g.draw(square);
        }
    }

    /** The second method's pixels as smaller squares inside the first one's. */
    private void paintOther(LineDrawing other, LineLabState state) {
        Color fill = MethodColours.of(other.method());
        Color edge = MethodColours.inkOn(fill);
        int step = state.finished() ? other.pixels() : Math.min(state.step(), other.pixels());
        double inset = grid.cell() * 0.28;
        for (int i = 1; i <= step; i++) {
            Rectangle2D square = square(other.x(i), other.y(i), inset);
            g.setColor(fill);
            g.fill(square);
            if (grid.cell() < 8) continue;
            g.setColor(edge);
            g.setStroke(new BasicStroke(1f));
            g.draw(square);
        }
    }

    private void paintMarks(LineLabState state) {
        LineMarks marks = LineMarks.of(state);
        marks.missing((x, y) -> mark(PixelMark.MISSING, x, y));
        marks.extra((x, y) -> mark(PixelMark.EXTRA, x, y));
    }

    private void mark(PixelMark mark, int pixelX, int pixelY) {
        double size = Math.max(7, grid.cell());
        mark.paint(g, grid.viewX(pixelX) - size / 2, grid.viewY(pixelY) - size / 2, size);
    }

    private void paintExactLine(Segment segment) {
        var line =
                new Line2D.Double(
                        grid.viewX(segment.x0()),
                        grid.viewY(segment.y0()),
                        grid.viewX(segment.x1()),
                        grid.viewY(segment.y1()));
        shorten(line);
        g.setColor(colours.ground());
        g.setStroke(new BasicStroke(3.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(line);
        g.setColor(colours.ink());
        g.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(line);
    }

    /** Brings an end that is far outside the view nearer, along the line. */
    private static void shorten(Line2D.Double line) {
        double length = Math.hypot(line.x2 - line.x1, line.y2 - line.y1);
        if (length <= FAR) return;
        double dx = (line.x2 - line.x1) / length;
        double dy = (line.y2 - line.y1) / length;
        // The view is near (0, 0): keep the stretch around the line's point nearest to that.
        double near = Math.max(0, Math.min(length, -(line.x1 * dx + line.y1 * dy)));
        double from = Math.max(0, near - FAR);
        double to = Math.min(length, near + FAR);
        line.setLine(
                line.x1 + dx * from, line.y1 + dy * from, line.x1 + dx * to, line.y1 + dy * to);
    }

    /** A frame around the pixel that the last step lit. */
    private void paintCurrent(LineDrawing drawing, int step) {
        if (grid.cell() < 6) return;
        g.setColor(colours.ink());
        g.setStroke(new BasicStroke(2f));
        g.draw(square(drawing.x(step), drawing.y(step), 0));
    }

    private Rectangle2D square(int pixelX, int pixelY, double inset) {
        double size = Math.max(1, grid.cell() - 2 * inset);
        return new Rectangle2D.Double(
                grid.viewX(pixelX) - size / 2, grid.viewY(pixelY) - size / 2, size, size);
    }
}
