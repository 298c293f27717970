package rasterlab.app.spline;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.app.canvas.PathLines;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.Plates;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.method.MethodColors;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.spline.function.Overshoot;

/**
 * Functions through knots, where they overshoot, and what the last step dealt with.
 *
 * @param taken the step taken last
 * @param answers those told so far by a method without steps of its own
 * @param at where the function is read, if there is one
 * @param slopes from each end knot to its slope's handle, where the ends have slopes
 * @param labels places of handles and labels, where no numbers stand
 */
record FunctionPicture(
        FunctionDrawings drawings,
        Optional<FunctionDrawing.FunctionStep> taken,
        List<FunctionDrawing.FunctionAnswer> answers,
        Optional<FunctionAt> at,
        List<Place> slopes,
        Locale locale,
        List<Rectangle> labels)
        implements PlanePicture {
    /** View units across an answer's mark. */
    private static final double MARK = 16;

    /** View units across the newest answer. */
    private static final double DOT = 12;

    /** View units from which on nothing is in sight. */
    private static final double BEYOND = 1e5;

    @Override
    public PlanePicture leaving(List<Rectangle> others) {
        return new FunctionPicture(drawings, taken, answers, at, slopes, locale, others);
    }

    @Override
    public void paint(Graphics2D g, PlaneMap map, StageColors colors, BooleanSupplier cancelled) {
        paintKnotColumns(g, map, colors);
        paintStep(g, map, colors);
        paintOvershoots(g, map, drawings.drawing());
        if (cancelled.getAsBoolean()) throw new CancellationException("a newer frame is asked for");
        drawings.other().ifPresent(other -> paintGraph(g, map, colors, other, 2.5f));
        paintGraph(g, map, colors, drawings.drawing(), 3.5f);
        paintSlopes(g, map, colors);
        paintAnswers(g, map, colors);
        at.ifPresent(place -> paintReading(g, map, colors, place));
        nameOvershoots(g, map, colors, drawings.drawing());
    }

    @Override
    public List<Line2D> lines(PlaneMap map, Rectangle view) {
        var lines = new ArrayList<>(PathLines.of(path(map, drawings.drawing()), view));
        drawings.other().ifPresent(other -> lines.addAll(PathLines.of(path(map, other), view)));
        return lines;
    }

    private void paintKnotColumns(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setColor(colors.axis());
        g.setStroke(dashed());
        for (Place knot : drawings.choice().knots()) {
            double x = map.viewX(knot.x());
            if (Math.abs(x) < 1e5) g.draw(new Line2D.Double(x, -10, x, 10_000));
        }
    }

    private static BasicStroke dashed() {
        return new BasicStroke(
                1f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 1f, new float[] {2f, 5f}, 0f);
    }

    /** Paints a band behind the knot or the piece that the last step dealt with. */
    private void paintStep(Graphics2D g, PlaneMap map, StageColors colors) {
        List<Place> knots = drawings.choice().knots();
        if (taken.isEmpty()) return;
        FunctionDrawing.FunctionStep step = taken.get();
        int from = step.knot() < 0 ? step.index() : step.knot();
        int to = step.knot() < 0 ? step.index() + 1 : step.knot();
        if (to >= knots.size()) return;
        double left = map.viewX(knots.get(from).x());
        double right = map.viewX(knots.get(to).x());
        double more = step.knot() < 0 ? 0 : 9;
        Color focus = colors.focus();
        g.setColor(new Color(focus.getRed(), focus.getGreen(), focus.getBlue(), 45));
        if (right - left < 1e5)
            g.fill(new Rectangle2D.Double(left - more, 0, right - left + 2 * more, 10_000));
    }

    private static void paintGraph(
            Graphics2D g, PlaneMap map, StageColors colors, FunctionDrawing drawing, float width) {
        Path2D path = path(map, drawing);
        if (path.getCurrentPoint() == null) return;
        g.setColor(MethodColors.edgeOn(colors.ground(), SplineColors.OWN.of(drawing.method())));
        g.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(path);
    }

    private static Path2D path(PlaneMap map, FunctionDrawing drawing) {
        var path = new Path2D.Double();
        for (Place place : drawing.graph()) to(path, map.viewX(place.x()), map.viewY(place.y()));
        return path;
    }

    /** Paints the area between the graph and the knot's value that it passes. */
    private static void paintOvershoots(Graphics2D g, PlaneMap map, FunctionDrawing drawing) {
        Color wrong = MethodColors.VERMILLION;
        g.setColor(new Color(wrong.getRed(), wrong.getGreen(), wrong.getBlue(), 120));
        for (Overshoot each : drawing.overshoots()) {
            boolean above = each.y() > each.beyond();
            var area = new Path2D.Double();
            double base = map.viewY(each.beyond());
            for (Place place : drawing.graphOf(each.piece())) {
                double outside = above ? place.y() - each.beyond() : each.beyond() - place.y();
                double y = outside > 0 ? map.viewY(place.y()) : base;
                if (area.getCurrentPoint() == null) area.moveTo(map.viewX(place.x()), base);
                area.lineTo(map.viewX(place.x()), y);
            }
            if (area.getCurrentPoint() == null) continue;
            area.lineTo(area.getCurrentPoint().getX(), base);
            area.closePath();
            g.fill(area);
        }
    }

    /** Draws a pointer at the farthest place outside, with how far that is. */
    private void nameOvershoots(
            Graphics2D g, PlaneMap map, StageColors colors, FunctionDrawing drawing) {
        g.setFont(g.getFont().deriveFont(Font.BOLD));
        var plates = new PointedPlates(g, colors, labels);
        for (Overshoot each : drawing.overshoots()) {
            boolean above = each.y() > each.beyond();
            double x = map.viewX(each.x());
            double y = map.viewY(each.y());
            int size = 7;
            int away = above ? -6 : 6;
            var pointer = new Path2D.Double();
            pointer.moveTo(x, y + away);
            pointer.lineTo(x - size, y + away * 3);
            pointer.lineTo(x + size, y + away * 3);
            pointer.closePath();
            g.setColor(MethodColors.VERMILLION);
            g.fill(pointer);
            double share = each.by() / Math.max(1e-300, drawing.worstOvershoot());
            if (share < 0.3) continue;
            String by = (above ? "+" : "−") + Shown.number(each.by(), 3, locale);
            int left = (int) Math.round(x) - g.getFontMetrics().stringWidth(by) / 2;
            plates.draw(by, left, y + away * 3, above);
        }
    }

    /**
     * Words beside pointers, none of them over another, a label or the pointers; one without room
     * is left out.
     */
    private static final class PointedPlates {
        private static final int APART = 5;

        private final Graphics2D g;
        private final StageColors colors;
        private final FontMetrics metrics;
        private final List<Rectangle> taken;

        PointedPlates(Graphics2D g, StageColors colors, List<Rectangle> labels) {
            this.g = g;
            this.colors = colors;
            metrics = g.getFontMetrics();
            taken = new ArrayList<>(labels);
        }

        void draw(String words, int left, double pointer, boolean above) {
            Rectangle sight = g.getClipBounds();
            int highest = sight.y + metrics.getAscent();
            int lowest = sight.y + sight.height - metrics.getDescent();
            int base = (int) Math.round(pointer + (above ? -APART : APART + metrics.getAscent()));
            if (base < highest || base > lowest) return;
            var place =
                    new Rectangle(
                            left - APART,
                            base - metrics.getAscent(),
                            metrics.stringWidth(words) + 2 * APART,
                            metrics.getHeight());
            if (taken.stream().anyMatch(place::intersects)) return;
            taken.add(place);
            Plates.plate(g, words, left, base, colors.ground(), colors.ink());
        }
    }

    private void paintSlopes(Graphics2D g, PlaneMap map, StageColors colors) {
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.6f));
        for (int i = 0; i + 1 < slopes.size(); i += 2)
            g.draw(
                    new Line2D.Double(
                            map.viewX(slopes.get(i).x()),
                            map.viewY(slopes.get(i).y()),
                            map.viewX(slopes.get(i + 1).x()),
                            map.viewY(slopes.get(i + 1).y())));
    }

    /**
     * Paints a cross at each wrong answer; at the newest answer a dot, and a ring where it belongs.
     */
    private void paintAnswers(Graphics2D g, PlaneMap map, StageColors colors) {
        for (FunctionDrawing.FunctionAnswer each : answers)
            if (each.wrong()) mark(g, map, PixelMark.EXTRA, each.x(), each.value());
        if (answers.isEmpty()) return;
        FunctionDrawing.FunctionAnswer newest = answers.get(answers.size() - 1);
        if (newest.wrong()) {
            mark(g, map, PixelMark.MISSING, newest.x(), newest.right());
            return;
        }
        double x = map.viewX(newest.x());
        double y = map.viewY(newest.value());
        g.setColor(colors.focus());
        g.fill(new Ellipse2D.Double(x - DOT / 2, y - DOT / 2, DOT, DOT));
    }

    private static void mark(Graphics2D g, PlaneMap map, PixelMark mark, double x, double y) {
        if (!Double.isFinite(y) || Math.abs(map.viewY(y)) > BEYOND) return;
        mark.paint(g, map.viewX(x) - MARK / 2, map.viewY(y) - MARK / 2, MARK);
    }

    /** Paints the point at which the function is read, and its tangent. */
    private static void paintReading(
            Graphics2D g, PlaneMap map, StageColors colors, FunctionAt place) {
        double x = map.viewX(place.x());
        double y = map.viewY(place.y());
        double run = map.scaleX();
        double rise = map.scaleY() * place.slope();
        double length = Math.hypot(run, rise);
        double dx = 70 * run / length;
        double dy = 70 * rise / length;
        g.setColor(colors.ink());
        g.setStroke(new BasicStroke(1.4f));
        g.draw(new Line2D.Double(x - dx, y - dy, x + dx, y + dy));
        var dot = new Ellipse2D.Double(x - 5.5, y - 5.5, 11, 11);
        g.setColor(MethodColors.VERMILLION);
        g.fill(dot);
        g.setColor(colors.ink());
        g.draw(dot);
    }

    private static void to(Path2D path, double viewX, double viewY) {
        if (path.getCurrentPoint() == null) path.moveTo(viewX, viewY);
        else path.lineTo(viewX, viewY);
    }
}
