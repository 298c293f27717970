package rasterlab.app.line.figure;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.line.trace.LineColors;
import rasterlab.app.line.trace.SingleMethodMark;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelSet;

/**
 * The pixels of a circle or an ellipse over the exact curve.
 *
 * @param step pixels lit so far
 * @param alone pixels that the method beside it does not light
 */
public record ArcPicture(ArcFigure arc, FigureDrawing drawing, int step, PixelSet alone)
        implements PlanePicture {
    /** The view units a pixel from which on pixels have edges and marks. */
    private static final double ROOMY = 5;

    private static final int BETWEEN_CHECKS = 5000;

    @Override
    public double leastTick() {
        return 1;
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        Color color = LineColors.OWN.of(drawing.method());
        Color edge =
                MethodColors.mix(MethodColors.edgeOn(colors.ground(), color), colors.ink(), 0.4);
        Rectangle view = g.getClipBounds();
        double size = Math.max(1, map.scaleX());
        for (int i = 0; i < step; i++) {
            if (i % BETWEEN_CHECKS == 0 && cancelled.getAsBoolean())
                throw new CancellationException("a newer frame is asked for");
            Rectangle2D pixel = pixel(map, drawing.pixels().x(i), drawing.pixels().y(i), size);
            if (!view.intersects(pixel)) continue;
            g.setColor(color);
            g.fill(pixel);
            if (size < ROOMY) continue;
            g.setColor(edge);
            g.setStroke(new BasicStroke(1));
            g.draw(pixel);
        }
        paintCurve(g, map, colors);
        marks(g, map, drawing.difference().extra(), PixelMark.EXTRA, size);
        if (step == drawing.steps())
            marks(g, map, drawing.difference().missing(), PixelMark.MISSING, size);
        again(g, map, size);
        alone(g, map, colors, size);
        if (step > 0 && step < drawing.steps()) {
            g.setColor(colors.ink());
            g.setStroke(new BasicStroke(2.5f));
            g.draw(pixel(map, drawing.pixels().x(step - 1), drawing.pixels().y(step - 1), size));
        }
    }

    private static Rectangle2D pixel(PlaneMap map, int x, int y, double size) {
        return new Rectangle2D.Double(map.viewX(x) - size / 2, map.viewY(y) - size / 2, size, size);
    }

    private void paintCurve(Graphics2D g, PlaneMap map, StageColors colors) {
        if (arc.radiusX() < 0 || arc.radiusY() < 0) return;
        var curve =
                new Ellipse2D.Double(
                        map.viewX((double) arc.centerX() - arc.radiusX()),
                        map.viewY((double) arc.centerY() - arc.radiusY()),
                        2.0 * arc.radiusX() * map.scaleX(),
                        2.0 * arc.radiusY() * map.scaleY());
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(3.2f));
        g.draw(curve);
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.4f));
        g.draw(curve);
    }

    private void alone(Graphics2D g, PlaneMap map, StageColors colors, double size) {
        for (int i = 0; i < alone.size(); i++) {
            Rectangle2D pixel = pixel(map, alone.x(i), alone.y(i), size);
            if (g.getClipBounds().intersects(pixel)) SingleMethodMark.paint(g, colors, pixel);
        }
    }

    /** Marks the pixels that were lit twice or more up to this step, be they right or wrong. */
    private void again(Graphics2D g, PlaneMap map, double size) {
        for (int i = 0; i < drawing.extra().againAmong(step); i++) {
            int at = drawing.extra().again(i);
            Rectangle2D pixel = pixel(map, drawing.pixels().x(at), drawing.pixels().y(at), size);
            if (!g.getClipBounds().intersects(pixel)) continue;
            if (size >= ROOMY) {
                PixelMark.AGAIN.paint(g, pixel.getX(), pixel.getY(), size);
                continue;
            }
            g.setColor(MethodColors.VERMILLION);
            g.fill(pixel);
        }
    }

    private void marks(Graphics2D g, PlaneMap map, PixelSet wrong, PixelMark mark, double size) {
        for (int i = 0; i < wrong.size(); i++) {
            if (mark == PixelMark.EXTRA && !isLit(wrong.x(i), wrong.y(i))) continue;
            Rectangle2D pixel = pixel(map, wrong.x(i), wrong.y(i), size);
            if (!g.getClipBounds().intersects(pixel)) continue;
            g.setColor(MethodColors.VERMILLION);
            if (size < ROOMY) g.fill(pixel);
            else mark.paint(g, pixel.getX(), pixel.getY(), size);
        }
    }

    private boolean isLit(int x, int y) {
        if (step == drawing.steps()) return true;
        for (int i = 0; i < step; i++)
            if (drawing.pixels().x(i) == x && drawing.pixels().y(i) == y) return true;
        return false;
    }
}
