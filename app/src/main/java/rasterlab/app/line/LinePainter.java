package rasterlab.app.line;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.ZoomedGrid;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.SingleMethodMark;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelDifference;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.raster.PixelWindow;

/** Draws what the methods drew onto a zoomed pixel grid. */
final class LinePainter {
    private final Graphics2D g;
    private final ZoomedGrid grid;
    private final StageColors colors;
    private final BooleanSupplier cancelled;

    /**
     * @param cancelled asked at each pixel
     */
    LinePainter(Graphics2D g, ZoomedGrid grid, StageColors colors, BooleanSupplier cancelled) {
        this.g = g;
        this.grid = grid;
        this.colors = colors;
        this.cancelled = cancelled;
    }

    /**
     * @param step pixels of the first drawing lit so far
     * @throws CancellationException soon after {@code cancelled} says true
     */
    void paint(LineDrawings drawings, int step) {
        LineDrawing drawing = drawings.drawing();
        boolean finished = step == drawing.pixels();
        paintPixels(drawing, step);
        drawings.other()
                .ifPresent(
                        other ->
                                paintOther(
                                        other,
                                        finished
                                                ? other.pixels()
                                                : Math.min(step, other.pixels())));
        drawing.marks().missing(step, (x, y) -> mark(PixelMark.MISSING, x, y));
        drawing.marks().extra(step, (x, y) -> mark(PixelMark.EXTRA, x, y));
        if (finished) drawings.apart().ifPresent(this::paintApart);
        paintExactLine(drawings.choice().segment());
        if (!drawings.choice().segment().isWhole())
            paintWindow(drawings.choice().segment().window());
        if (step > 0) paintCurrent(drawing, step);
    }

    /** Draws a thin frame around the pixels of the window. */
    private void paintWindow(PixelWindow window) {
        double left = grid.viewX(window.xmin() - 0.5);
        double top = grid.viewY(window.ymin() - 0.5);
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.2f));
        g.draw(
                new Rectangle2D.Double(
                        left, top, grid.cell() * window.width(), grid.cell() * window.height()));
    }

    private void requireUse() {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer frame is asked for");
    }

    /** Coverage is opacity, of a colour that stands out from the ground where it is whole. */
    private void paintCoverage(LineDrawing drawing, int step, double inset) {
        Color whole = MethodColors.edgeOn(colors.ground(), LineColors.OWN.of(drawing.method()));
        for (PixelCoverage.Shade shade : drawing.coverage().orElseThrow().drawn().shades()) {
            if (shade.step() > step) return;
            requireUse();
            g.setColor(new Color(whole.getRed(), whole.getGreen(), whole.getBlue(), shade.level()));
            g.fill(square(shade.x(), shade.y(), inset));
        }
    }

    private void paintPixels(LineDrawing drawing, int step) {
        if (drawing.coverage().isPresent()) {
            paintCoverage(drawing, step, grid.cell() >= 6 ? 1 : 0);
            return;
        }
        Color fill = LineColors.OWN.of(drawing.method());
        Color edge = MethodColors.edgeOn(colors.ground(), fill);
        double gap = grid.cell() >= 6 ? 1 : 0;
        for (int i = 1; i <= step; i++) {
            requireUse();
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

    /** Draws the second method's pixels as smaller squares inside the first one's. */
    private void paintOther(LineDrawing other, int step) {
        if (other.coverage().isPresent()) {
            paintCoverage(other, step, grid.cell() * 0.28);
            return;
        }
        Color fill = LineColors.OWN.of(other.method());
        Color edge = MethodColors.inkOn(fill);
        double inset = grid.cell() * 0.28;
        for (int i = 1; i <= step; i++) {
            requireUse();
            Rectangle2D square = square(other.x(i), other.y(i), inset);
            g.setColor(fill);
            g.fill(square);
            if (grid.cell() < 8) continue;
            g.setColor(edge);
            g.setStroke(new BasicStroke(1f));
            g.draw(square);
        }
    }

    private void mark(PixelMark mark, int pixelX, int pixelY) {
        requireUse();
        double size = Math.max(7, grid.cell());
        mark.paint(g, grid.viewX(pixelX) - size / 2, grid.viewY(pixelY) - size / 2, size);
    }

    /** Marks the pixels that only one of the two methods lights, or lights more. */
    private void paintApart(PixelDifference apart) {
        for (PixelSet alone : List.of(apart.extra(), apart.missing()))
            for (int i = 0; i < alone.size(); i++) {
                requireUse();
                SingleMethodMark.paint(g, colors, square(alone.x(i), alone.y(i), 0));
            }
    }

    private void paintExactLine(Segment segment) {
        Line2D line = grid.line(segment.x0(), segment.y0(), segment.x1(), segment.y1());
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(3.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(line);
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.6f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(line);
    }

    /** Draws a frame around each pixel that the last step lit. */
    private void paintCurrent(LineDrawing drawing, int step) {
        if (grid.cell() < 6) return;
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(2f));
        for (PixelCoverage.Shade shade : drawing.shades(step))
            g.draw(square(shade.x(), shade.y(), 0));
    }

    private Rectangle2D square(int pixelX, int pixelY, double inset) {
        double size = Math.max(1, grid.cell() - 2 * inset);
        return new Rectangle2D.Double(
                grid.viewX(pixelX) - size / 2, grid.viewY(pixelY) - size / 2, size, size);
    }
}
