package rasterlab.app.clip;

import java.awt.Rectangle;
import java.awt.geom.Path2D;
import java.util.List;
import java.util.Optional;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.clip.scene.ClipPoint;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.polygon.SutherlandHodgman;
import rasterlab.engine.clip.segment.BranchlessLiangBarsky;

/** Lines and areas cut to the view by the engine's own methods, however far they reach. */
final class InView {
    /** View units around the view, so that no cut end is seen. */
    private static final double MARGIN = 40;

    /** The number of view units beyond which Java2D's own clipping loses precision. */
    private static final double FAR = 1e5;

    private final PlaneMap map;
    private final double left;
    private final double top;
    private final double right;
    private final double bottom;

    InView(PlaneMap map, Rectangle view) {
        this.map = map;
        left = view.getMinX() - MARGIN;
        top = view.getMinY() - MARGIN;
        right = view.getMaxX() + MARGIN;
        bottom = view.getMaxY() + MARGIN;
    }

    boolean holds(ClipPoint place) {
        double x = map.viewX(place.x());
        double y = map.viewY(place.y());
        return x >= left && x <= right && y >= top && y <= bottom;
    }

    /** The part of a line in view; places that are not finite are left out with their edges. */
    Path2D line(List<ClipPoint> points, boolean closed) {
        var path = new Path2D.Double();
        if (points.stream().allMatch(this::holds)) {
            join(path, points, closed);
            return path;
        }
        int edges = closed ? points.size() : points.size() - 1;
        for (int i = 0; i < edges; i++)
            edge(path, points.get(i), points.get((i + 1) % points.size()));
        return path;
    }

    private void join(Path2D path, List<ClipPoint> points, boolean closed) {
        for (int i = 0; i < points.size(); i++) {
            double x = map.viewX(points.get(i).x());
            double y = map.viewY(points.get(i).y());
            if (i == 0) path.moveTo(x, y);
            else path.lineTo(x, y);
        }
        if (closed) path.closePath();
    }

    private void edge(Path2D path, ClipPoint from, ClipPoint to) {
        double x0 = map.viewX(from.x());
        double y0 = map.viewY(from.y());
        double x1 = map.viewX(to.x());
        double y1 = map.viewY(to.y());
        if (!Double.isFinite(x0 + y0 + x1 + y1)) return;
        new BranchlessLiangBarsky()
                .clip(
                        left,
                        top,
                        right,
                        bottom,
                        x0,
                        y0,
                        x1,
                        y1,
                        (ax, ay, bx, by) -> {
                            path.moveTo(ax, ay);
                            path.lineTo(bx, by);
                        });
    }

    /** The inside of a closed line; nothing of one that reaches far and crosses itself. */
    Optional<Path2D> area(List<ClipPoint> corners) {
        if (corners.size() < 3 || !corners.stream().allMatch(ClipPoint::isFinite))
            return Optional.empty();
        var path = new Path2D.Double(Path2D.WIND_EVEN_ODD);
        if (corners.stream().allMatch(this::isNear)) {
            join(path, corners, true);
            return Optional.of(path);
        }
        var view = new double[2 * corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            view[2 * i] = map.viewX(corners.get(i).x());
            view[2 * i + 1] = map.viewY(corners.get(i).y());
        }
        try {
            new SutherlandHodgman()
                    .clip(
                            PolygonInWindow.rectangle(left, top, right, bottom),
                            view,
                            piece -> append(path, piece));
            return Optional.of(path);
        } catch (IllegalArgumentException crossing) {
            return Optional.empty();
        }
    }

    private boolean isNear(ClipPoint place) {
        return Math.abs(map.viewX(place.x())) <= FAR && Math.abs(map.viewY(place.y())) <= FAR;
    }

    private static void append(Path2D path, double[] view) {
        path.moveTo(view[0], view[1]);
        for (int i = 2; i < view.length; i += 2) path.lineTo(view[i], view[i + 1]);
        path.closePath();
    }
}
