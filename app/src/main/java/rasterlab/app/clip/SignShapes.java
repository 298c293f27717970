package rasterlab.app.clip;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import rasterlab.app.canvas.StageColors;

/** The shapes of signs on the stage and of their keys in the inspector. */
final class SignShapes {
    private static final double SIZE = 12;

    private SignShapes() {}

    /**
     * @param x view, as y
     * @param angle of an arrow's way in radians, clockwise from the right
     */
    static void paint(
            Graphics2D g,
            ClipMark.SignShape sign,
            double x,
            double y,
            double angle,
            StageColors colors) {
        var place = AffineTransform.getTranslateInstance(x, y);
        place.rotate(angle);
        Shape shape = place.createTransformedShape(outline(sign));
        boolean filled = sign == ClipMark.SignShape.ENTERING || sign == ClipMark.SignShape.TESTED;
        g.setStroke(new BasicStroke(5f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(colors.ground());
        g.draw(shape);
        g.fill(shape);
        g.setStroke(new BasicStroke(2.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.setColor(colors.focus());
        if (filled) g.fill(shape);
        g.draw(shape);
        if (sign == ClipMark.SignShape.EYE)
            g.fill(place.createTransformedShape(new Ellipse2D.Double(-3.5, -3.5, 7, 7)));
    }

    private static Shape outline(ClipMark.SignShape sign) {
        return switch (sign) {
            case ENTERING, LEAVING -> arrow();
            case TESTED -> new Ellipse2D.Double(-5, -5, 10, 10);
            case EYE -> lens();
        };
    }

    /** An arrow with its point where the border is passed. */
    private static Path2D arrow() {
        var arrow = new Path2D.Double();
        arrow.moveTo(SIZE * 0.35, 0);
        arrow.lineTo(-SIZE, SIZE * 0.5);
        arrow.lineTo(-SIZE, -SIZE * 0.5);
        arrow.closePath();
        return arrow;
    }

    private static Path2D lens() {
        var lens = new Path2D.Double();
        lens.moveTo(-12, 0);
        lens.quadTo(0, -13, 12, 0);
        lens.quadTo(0, 13, -12, 0);
        lens.closePath();
        return lens;
    }
}
