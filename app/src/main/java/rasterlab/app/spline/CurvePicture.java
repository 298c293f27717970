package rasterlab.app.spline;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PathLines;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.app.spline.curve.CurvatureComb;
import rasterlab.app.spline.curve.CurveAt;
import rasterlab.app.spline.curve.Joint;
import rasterlab.app.spline.curve.JointText;
import rasterlab.engine.spline.curve.ControlHull;
import rasterlab.engine.spline.curve.PointStep;
import rasterlab.engine.spline.exact.Polyline;

/**
 * Curves, what the methods drew of them, and what happens at t.
 *
 * @param step the last point of the polyline that is drawn in full colour
 */
record CurvePicture(CurveDrawings drawings, CurveAt at, int step) implements PlanePicture {
    private static final BasicStroke THIN = stroke(1f);
    private static final BasicStroke EXACT = stroke(1.5f);
    private static final BasicStroke THICK = stroke(5f);
    private static final BasicStroke DASHED =
            new BasicStroke(
                    1.2f,
                    BasicStroke.CAP_BUTT,
                    BasicStroke.JOIN_ROUND,
                    1f,
                    new float[] {5f, 4f},
                    0f);

    /** More corners than so many would cover the curve. */
    private static final int MOST_CORNERS = 400;

    private static final int MOST_SQUARES = 100;

    private static BasicStroke stroke(float width) {
        return new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        CurveOverlays overlays = drawings.choice().overlays();
        if (overlays.hull()) paintHull(g, map, colors);
        paintPolygon(g, map, colors);
        if (overlays.comb()) paintComb(g, map, colors);
        requireUse(cancelled);
        drawings.other().ifPresent(other -> paintOther(g, map, colors, other));
        paintPolyline(g, map, colors, drawings.drawing());
        requireUse(cancelled);
        paintExact(g, map, colors);
        if (overlays.construction()) paintConstruction(g, map, colors);
        paintPoint(g, map, colors);
        paintJoints(g, map, colors);
    }

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        var lines = new ArrayList<>(PathLines.of(polygon(map), view));
        for (Polyline curve : drawings.exact()) lines.addAll(PathLines.of(path(curve, map), view));
        return lines;
    }

    private static void requireUse(BooleanSupplier cancelled) {
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer frame is asked for");
    }

    /** Paints the hull around the Bézier points of the span that t lies in. */
    private void paintHull(Graphics2D g, PlaneMap map, StageColors colors) {
        PointStep points = at.construction().get(0);
        var hull = new Path2D.Double();
        for (int corner : ControlHull.of(points.x(), points.y()))
            to(hull, map.viewX(points.x()[corner]), map.viewY(points.y()[corner]));
        hull.closePath();
        g.setColor(faded(colors.axis(), 45));
        g.fill(hull);
        g.setColor(colors.axis());
        g.setStroke(THIN);
        g.draw(hull);
    }

    private void paintPolygon(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setColor(colors.axis());
        g.setStroke(DASHED);
        Path2D polygon = polygon(map);
        if (polygon.getCurrentPoint() != null) g.draw(polygon);
    }

    /** The lines between the control points; of Hermite's form the two derivatives. */
    private Path2D polygon(PlaneMap map) {
        List<Place> handles = drawings.choice().handles();
        boolean hermite = drawings.choice().form() == CurveForm.HERMITE;
        var polygon = new Path2D.Double();
        for (int i = 0; i < handles.size(); i++) {
            Place from = handles.get(hermite ? i & 1 : i);
            if (hermite && i >= 2) polygon.moveTo(map.viewX(from.x()), map.viewY(from.y()));
            if (!hermite || i >= 2)
                to(polygon, map.viewX(handles.get(i).x()), map.viewY(handles.get(i).y()));
        }
        return polygon;
    }

    private void paintComb(Graphics2D g, PlaneMap map, StageColors colors) {
        Color color = MethodColors.edgeOn(colors.ground(), MethodColors.PURPLE);
        var teeth = new Path2D.Double();
        var edge = new Path2D.Double();
        for (CurvatureComb.Tooth tooth : drawings.comb().teeth()) {
            double outX = map.viewX(tooth.outX());
            double outY = map.viewY(tooth.outY());
            teeth.moveTo(map.viewX(tooth.x()), map.viewY(tooth.y()));
            teeth.lineTo(outX, outY);
            if (tooth.first()) edge.moveTo(outX, outY);
            else to(edge, outX, outY);
        }
        g.setStroke(THIN);
        g.setColor(faded(color, 110));
        g.draw(teeth);
        g.setColor(color);
        g.draw(edge);
    }

    /** Paints it pale as a whole, in full colour as far as the steps have come. */
    private void paintPolyline(
            Graphics2D g, PlaneMap map, StageColors colors, CurveDrawing drawing) {
        List<CurveDrawing.Corner> corners = drawing.points();
        Color color = SplineColors.OWN.of(drawing.method());
        g.setStroke(THICK);
        g.setColor(MethodColors.mix(color, colors.ground(), 0.55));
        g.draw(path(corners, map));
        g.setColor(color);
        g.draw(path(corners.subList(0, Math.min(step + 1, corners.size())), map));
        if (corners.size() > MOST_CORNERS) return;
        for (int i = 0; i < corners.size(); i++) {
            Color fill = i <= step ? color : MethodColors.mix(color, colors.ground(), 0.55);
            dot(g, map, corners.get(i).x(), corners.get(i).y(), 4, fill, colors);
        }
    }

    private void paintOther(Graphics2D g, PlaneMap map, StageColors colors, CurveDrawing drawing) {
        Color color = MethodColors.edgeOn(colors.ground(), SplineColors.OWN.of(drawing.method()));
        g.setStroke(stroke(2.5f));
        g.setColor(color);
        g.draw(path(drawing.points(), map));
        if (drawing.points().size() > MOST_SQUARES) return;
        for (CurveDrawing.Corner corner : drawing.points()) {
            var square =
                    new Rectangle2D.Double(
                            map.viewX(corner.x()) - 4, map.viewY(corner.y()) - 4, 8, 8);
            g.setStroke(stroke(1.5f));
            g.draw(square);
        }
    }

    private void paintExact(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setColor(colors.ink());
        g.setStroke(EXACT);
        for (Polyline curve : drawings.exact()) {
            Path2D path = path(curve, map);
            if (path.getCurrentPoint() != null) g.draw(path);
        }
    }

    private static Path2D path(Polyline curve, PlaneMap map) {
        var path = new Path2D.Double();
        for (int i = 0; i < curve.size(); i++)
            to(path, map.viewX(curve.x(i)), map.viewY(curve.y(i)));
        return path;
    }

    /** Paints De Casteljau's triangle, each row darker than the one above. */
    private void paintConstruction(Graphics2D g, PlaneMap map, StageColors colors) {
        Color color = MethodColors.edgeOn(colors.ground(), MethodColors.GREEN);
        List<PointStep> rows = at.construction();
        for (int row = 0; row < rows.size() - 1; row++) {
            PointStep points = rows.get(row);
            double share =
                    rows.size() <= 2 ? 0 : 0.45 * (rows.size() - 2 - row) / (rows.size() - 2);
            Color shade = MethodColors.mix(color, colors.ground(), share);
            var path = new Path2D.Double();
            for (int i = 0; i < points.x().length; i++)
                to(path, map.viewX(points.x()[i]), map.viewY(points.y()[i]));
            g.setColor(shade);
            g.setStroke(stroke(1.8f));
            g.draw(path);
            if (row > 0 && rows.size() <= 12)
                for (int i = 0; i < points.x().length; i++)
                    dot(g, map, points.x()[i], points.y()[i], 3.5, shade, colors);
        }
    }

    private void paintPoint(Graphics2D g, PlaneMap map, StageColors colors) {
        double x = at.place().x();
        double y = at.place().y();
        dot(g, map, x, y, 6, MethodColors.VERMILLION, colors);
    }

    /** Draws beside the joints what they are. */
    private void paintJoints(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        FontMetrics metrics = g.getFontMetrics();
        for (Joint joint : drawings.joints()) {
            String kind = JointText.of(joint.kind());
            double x = map.viewX(joint.x());
            double y = map.viewY(joint.y());
            if (!(Math.abs(x) < 1e5 && Math.abs(y) < 1e5)) continue;
            Plates.plate(
                    g,
                    kind,
                    (int) Math.round(x) - metrics.stringWidth(kind) / 2,
                    (int) Math.round(y) + metrics.getAscent() + 16,
                    colors.margin(),
                    colors.ink());
            dot(g, map, joint.x(), joint.y(), 4, colors.ground(), colors);
        }
    }

    private static Path2D path(List<CurveDrawing.Corner> corners, PlaneMap map) {
        var path = new Path2D.Double();
        path.moveTo(-10, -10);
        boolean first = true;
        for (CurveDrawing.Corner corner : corners) {
            double x = map.viewX(corner.x());
            double y = map.viewY(corner.y());
            if (first) path.moveTo(x, y);
            else path.lineTo(x, y);
            first = false;
        }
        return path;
    }

    /** Moves there first, then draws lines there. */
    private static void to(Path2D path, double viewX, double viewY) {
        if (path.getCurrentPoint() == null) path.moveTo(viewX, viewY);
        else path.lineTo(viewX, viewY);
    }

    private static void dot(
            Graphics2D g,
            PlaneMap map,
            double x,
            double y,
            double radius,
            Color fill,
            StageColors colors) {
        double left = map.viewX(x) - radius;
        double top = map.viewY(y) - radius;
        Shape dot = new Ellipse2D.Double(left, top, 2 * radius, 2 * radius);
        g.setColor(fill);
        g.fill(dot);
        g.setColor(colors.ink());
        g.setStroke(THIN);
        g.draw(dot);
    }

    private static Color faded(Color color, int alpha) {
        return new Color(color.getRed(), color.getGreen(), color.getBlue(), alpha);
    }
}
