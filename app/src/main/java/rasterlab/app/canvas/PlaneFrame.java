package rasterlab.app.canvas;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/**
 * One picture of a plane: all that painting it needs, so that any thread may.
 *
 * @param width of the stage in view units
 * @param height of the stage in view units
 * @param covered by buttons over the picture, in view units
 * @param scale device dots per view unit
 * @param font of a label
 * @param note a sentence over the picture, "" for none
 */
record PlaneFrame(
        PlanePicture picture,
        List<PlanePoint> points,
        String note,
        PlaneMap map,
        int width,
        int height,
        Rectangle covered,
        double scale,
        StageColors colors,
        Font font,
        Locale locale) {
    private static final double DOT = 3.5;

    /** The distance between a point and its label, for the ring around the point. */
    private static final int AWAY = 15;

    /** The distances between a point's ring and its label, the best first. */
    private static final int[] FARTHER = {0, 14};

    /** The distances to choose from where pixels may have to be left clear. */
    private static final int[] OFF_PIXELS = {0, 14, 28, 42, 56, 70};

    /** Half of the width of a thick line, and a little more. */
    private static final int THICK = 4;

    /** Side of a handle's square. */
    private static final int HANDLE = 22;

    /** The distance from a point to the outer edge of its ring. */
    private static final double RING = 10.5;

    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    BufferedImage painted(BooleanSupplier cancelled) {
        return DevicePixels.painted(width, height, scale, g -> paint(g, cancelled));
    }

    void paint(Graphics2D g, BooleanSupplier cancelled) {
        DevicePixels.smooth(g);
        var rulers =
                new PlaneRulers(
                        map,
                        new Dimension(width, height),
                        colors,
                        font,
                        locale,
                        picture.leastTick());
        if (picture.ruled()) rulers.paintGrid(g);
        else paintGround(g);
        var inner = (Graphics2D) g.create();
        inner.setFont(font);
        if (picture.ruled())
            inner.clipRect(
                    Rulers.left(), Rulers.top(), width - Rulers.left(), height - Rulers.top());
        else inner.clipRect(0, 0, width, height);
        List<Placed> placed = placed();
        List<Label> labels = labels(inner, placed);
        picture.leaving(taken(placed, labels)).paint(inner, map, colors, cancelled);
        paintPoints(inner, labels);
        note(picture, note, new Dimension(width, height), font).paint(inner, colors);
        inner.dispose();
        g.setStroke(new BasicStroke(1f));
        if (picture.ruled()) rulers.paintMargins(g);
    }

    /** A sentence over a picture, beside its rulers if it has any. */
    static StageNote note(PlanePicture picture, String said, Dimension stage, Font label) {
        return new StageNote(said, inside(picture, stage), label);
    }

    private static Rectangle inside(PlanePicture picture, Dimension stage) {
        return picture.ruled() ? Rulers.inside(stage) : new Rectangle(stage);
    }

    private void paintGround(Graphics2D g) {
        g.setColor(colors.ground());
        g.fillRect(0, 0, width, height);
    }

    /**
     * The squares of the points' handles, each around its point; of one out of sight or under the
     * note, at the edge, clear of the buttons.
     */
    List<Rectangle> handles() {
        Rectangle sight = note(picture, note, new Dimension(width, height), font).below();
        return points.stream().map(point -> handle(point, sight)).toList();
    }

    private Rectangle handle(PlanePoint point, Rectangle sight) {
        return EdgeArrow.place(view(point), PictureType.scaled(HANDLE), sight, covered);
    }

    private Point2D view(PlanePoint point) {
        return new Point2D.Double(map.viewX(point.x()), map.viewY(point.y()));
    }

    /** Where each point lies from its handle if it is out of sight: an angle as of an arrow. */
    List<OptionalDouble> directions() {
        Rectangle sight = note(picture, note, new Dimension(width, height), font).below();
        return points.stream()
                .map(point -> EdgeArrow.towards(view(point), handle(point, sight), sight, covered))
                .toList();
    }

    /**
     * A point with the middle of its handle, which is the point itself unless that is moved aside.
     */
    private record Placed(PlanePoint point, double x, double y) {
        Rectangle ring() {
            return new Rectangle(
                    (int) (x - away()), (int) (y - away()), (int) (2 * away()), (int) (2 * away()));
        }
    }

    private List<Placed> placed() {
        List<Rectangle> handles = handles();
        return IntStream.range(0, points.size())
                .mapToObj(
                        i -> {
                            PlanePoint point = points.get(i);
                            Rectangle handle = handles.get(i);
                            return new Placed(
                                    point,
                                    at(map.viewX(point.x()), handle.getCenterX()),
                                    at(map.viewY(point.y()), handle.getCenterY()));
                        })
                .toList();
    }

    private static double at(double point, double handle) {
        return Math.abs(handle - point) <= 1 ? point : handle;
    }

    /** The area that labels leave clear where there is room. */
    private record KeptClear(List<Line2D> lines, List<Rectangle2D> pixels) {
        KeptClear near(Rectangle around) {
            return new KeptClear(
                    lines.stream().filter(around::intersectsLine).toList(),
                    pixels.stream().filter(around::intersects).toList());
        }
    }

    /** A point's label, where its plate lies. */
    private record Label(String text, Rectangle place) {}

    private List<Label> labels(Graphics2D g, List<Placed> placed) {
        FontMetrics metrics = g.getFontMetrics(font.deriveFont(Font.BOLD));
        double middleX = points.stream().mapToDouble(p -> map.viewX(p.x())).average().orElse(0);
        double middleY = points.stream().mapToDouble(p -> map.viewY(p.y())).average().orElse(0);
        var stage = new Rectangle(width, height);
        boolean labelled = points.stream().anyMatch(point -> !point.label().isEmpty());
        var kept =
                new KeptClear(
                        picture.lines(map, stage),
                        labelled ? picture.pixels(map, stage) : List.of());
        var labels = new ArrayList<Label>();
        for (Placed each : placed) {
            if (each.point.label().isEmpty()) continue;
            Label wanted = label(each, metrics, middleX, middleY);
            Optional<Label> free = free(each, wanted, placed, labels, kept);
            if (inSight(each.point)) labels.add(free.orElse(wanted));
            else free.ifPresent(labels::add);
        }
        return labels;
    }

    /**
     * The label where it lies over no point's ring, no label before it and no button: where it
     * should be, or else at another side of its point. Of such places the first that covers the
     * least of the pixels, then the fewest lines; empty if there is none.
     */
    private Optional<Label> free(
            Placed point, Label wanted, List<Placed> points, List<Label> before, KeptClear kept) {
        List<Rectangle> taken =
                Stream.of(
                                before.stream().map(Label::place),
                                points.stream().filter(other -> other != point).map(Placed::ring),
                                Stream.of(covered))
                        .flatMap(places -> places)
                        .toList();
        Rectangle inside = inside(picture, new Dimension(width, height));
        Rectangle ring = point.ring();
        int[] gaps = kept.pixels.isEmpty() ? FARTHER : OFF_PIXELS;
        Rectangle around =
                grown(ring, gaps[gaps.length - 1] + wanted.place.width + THICK)
                        .union(grown(wanted.place, THICK));
        KeptClear near = kept.near(around);
        Stream<Rectangle> places =
                IntStream.of(gaps)
                        .boxed()
                        .flatMap(farther -> sides(grown(ring, farther), wanted.place));
        return Stream.concat(Stream.of(wanted.place), places)
                .filter(inside::contains)
                .filter(place -> taken.stream().noneMatch(place::intersects))
                .filter(place -> !onItsRing(point, place))
                .min(
                        Comparator.comparingDouble(
                                        (Rectangle place) -> CoveredArea.of(place, near.pixels))
                                .thenComparingLong(place -> covered(near.lines, place)))
                .map(place -> new Label(wanted.text, place));
    }

    /** How many lines a label touches. */
    private static long covered(List<Line2D> lines, Rectangle label) {
        return lines.stream().filter(grown(label, THICK)::intersectsLine).count();
    }

    private static Rectangle grown(Rectangle box, int by) {
        var grown = new Rectangle(box);
        grown.grow(by, by);
        return grown;
    }

    private static boolean onItsRing(Placed point, Rectangle label) {
        double radius = PictureType.scaled((float) RING);
        return new Ellipse2D.Double(point.x - radius, point.y - radius, 2 * radius, 2 * radius)
                .intersects(label);
    }

    /** Places of that size above, below and beside a ring, then off its corners. */
    private static Stream<Rectangle> sides(Rectangle ring, Rectangle size) {
        int left = ring.x - size.width;
        int right = ring.x + ring.width;
        int across = (int) ring.getCenterX() - size.width / 2;
        int above = ring.y - size.height;
        int below = ring.y + ring.height;
        int along = (int) ring.getCenterY() - size.height / 2;
        return Stream.of(
                        new Point(across, above),
                        new Point(across, below),
                        new Point(right, along),
                        new Point(left, along),
                        new Point(right, above),
                        new Point(left, above),
                        new Point(right, below),
                        new Point(left, below))
                .map(corner -> new Rectangle(corner, size.getSize()));
    }

    private static double away() {
        return PictureType.scaled(AWAY);
    }

    /** The places of labels, of the rings around points and of buttons. */
    private List<Rectangle> taken(List<Placed> placed, List<Label> labels) {
        Stream<Rectangle> rings = placed.stream().map(Placed::ring);
        return Stream.of(labels.stream().map(Label::place), rings, Stream.of(covered))
                .flatMap(places -> places)
                .filter(place -> !place.isEmpty())
                .toList();
    }

    private boolean inSight(PlanePoint point) {
        double x = map.viewX(point.x());
        double y = map.viewY(point.y());
        return x > -100 && x < width + 100 && y > -100 && y < height + 100;
    }

    private void paintPoints(Graphics2D g, List<Label> labels) {
        g.setFont(font.deriveFont(Font.BOLD));
        for (PlanePoint point : points)
            if (inSight(point)) dot(g, map.viewX(point.x()), map.viewY(point.y()));
        Color ground = colors.ground();
        var plate = new Color(ground.getRed(), ground.getGreen(), ground.getBlue(), 190);
        for (Label label : labels)
            Plates.plate(
                    g,
                    label.text,
                    label.place.x + 4,
                    label.place.y + 1 + g.getFontMetrics().getAscent(),
                    plate,
                    colors.ink());
    }

    private void dot(Graphics2D g, double x, double y) {
        g.setColor(colors.ink());
        g.fill(new Ellipse2D.Double(x - DOT, y - DOT, 2 * DOT, 2 * DOT));
    }

    /** The label beside its point, on the side away from the middle of all points. */
    private Label label(Placed placed, FontMetrics metrics, double middleX, double middleY) {
        PlanePoint point = placed.point;
        double x = placed.x;
        double y = placed.y;
        double dx = x - middleX;
        double dy = y - middleY;
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        int wide = metrics.stringWidth(point.label());
        double away =
                Math.min(
                        (away() + wide / 2.0) / Math.abs(dx / length),
                        (away() + metrics.getAscent() / 2.0) / Math.abs(dy / length));
        double left = x + dx / length * away - wide / 2.0;
        double fitting = Math.max(Rulers.left() + 6, Math.min(width - wide - 8, left));
        // A label that the stage's edge pushes back to its point stands above it.
        double base =
                Math.abs(fitting - left) > away() / 2
                        ? y - away()
                        : y + dy / length * away + metrics.getAscent() / 2.0 - 1;
        int top = Rulers.top() + metrics.getAscent() + 4;
        int baseline = (int) Math.max(top, Math.min(height - 8, base));
        return new Label(
                point.label(),
                new Rectangle(
                        (int) fitting - 4,
                        baseline - metrics.getAscent() - 1,
                        wide + 8,
                        metrics.getHeight() + 1));
    }
}
