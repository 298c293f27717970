package rasterlab.app.line.figure;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.line.trace.RasterPoint;
import rasterlab.engine.raster.Raster;

/** The pixels that a pen lights along a line. */
record PenPicture(PenFigure figure) implements PlanePicture {
    private static final double GRID = 5;

    @Override
    public double leastTick() {
        return 1;
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        Raster raster = figure.picture(colors.ground().getRGB(), MethodColors.BLUE.getRGB());
        double left = map.viewX(-0.5);
        double top = map.viewY(-0.5);
        double right = map.viewX(PenFigure.WIDTH - 0.5);
        double bottom = map.viewY(PenFigure.HEIGHT - 0.5);
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(
                raster.image(),
                (int) Math.round(left),
                (int) Math.round(top),
                (int) Math.round(right - left),
                (int) Math.round(bottom - top),
                null);
        if (map.scaleX() >= GRID) {
            Color line = colors.grid();
            g.setColor(new Color(line.getRed(), line.getGreen(), line.getBlue(), 150));
            for (int x = 1; x < PenFigure.WIDTH; x++)
                g.draw(new Line2D.Double(map.viewX(x - 0.5), top, map.viewX(x - 0.5), bottom));
            for (int y = 1; y < PenFigure.HEIGHT; y++)
                g.draw(new Line2D.Double(left, map.viewY(y - 0.5), right, map.viewY(y - 0.5)));
        }
        g.setColor(colors.axis());
        g.drawRect((int) left, (int) top, (int) (right - left), (int) (bottom - top));
        paintLine(g, map, colors);
    }

    private void paintLine(Graphics2D g, PlaneMap map, StageColors colors) {
        var path = new Path2D.Double();
        for (RasterPoint point : figure.points()) {
            double x = map.viewX(point.x());
            double y = map.viewY(point.y());
            if (path.getCurrentPoint() == null) path.moveTo(x, y);
            else path.lineTo(x, y);
        }
        g.setColor(colors.ground());
        g.setStroke(new BasicStroke(3));
        g.draw(path);
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.2f));
        g.draw(path);
    }
}
