package rasterlab.app.line.figure;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;

/** Chooses what the stage shows of a figure when the user has not zoomed. */
final class FigureFraming {
    private FigureFraming() {}

    /** Whether some of the figure is in sight: of a circle or an ellipse, some of its curve. */
    static boolean isSeen(DrawnFigure figure, Rectangle2D sight) {
        Rectangle2D all = of(figure);
        if (!(figure instanceof ArcFigure)) return all.intersects(sight);
        var curve = new Ellipse2D.Double(all.getX(), all.getY(), all.getWidth(), all.getHeight());
        return curve.intersects(sight) && !curve.contains(sight);
    }

    static Rectangle2D of(DrawnFigure figure) {
        if (figure instanceof ArcFigure arc) {
            double wide = Math.max(1, Math.abs((double) arc.radiusX()) + 0.5);
            double tall = Math.max(1, Math.abs((double) arc.radiusY()) + 0.5);
            return new Rectangle2D.Double(
                    arc.centerX() - wide, arc.centerY() - tall, 2 * wide, 2 * tall);
        }
        if (figure instanceof SlopeFigure)
            return new Rectangle2D.Double(0, 0, SlopeFigure.STEEPEST, BrightnessPicture.TOP);
        return new Rectangle2D.Double(3, 2, PenFigure.WIDTH - 7.0, PenFigure.HEIGHT - 5.0);
    }
}
