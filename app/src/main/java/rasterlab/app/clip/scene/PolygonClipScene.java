package rasterlab.app.clip.scene;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rasterlab.engine.clip.polygon.PolygonInWindow;
import rasterlab.engine.clip.segment.ClipWindow;

/** A polygon, the subject, clipped by a window. */
public record PolygonClipScene(
        ShownWindow window, List<ClipPoint> subject, String method, String comparison)
        implements ClipScene {
    /** Corners the lab can show at once. */
    static final int MOST = 40;

    public PolygonClipScene {
        subject = List.copyOf(subject);
    }

    /** A subject with three teeth in the window: three pieces are left. */
    public static PolygonClipScene first() {
        double[] comb = {
            -3.5, 0.3, 5, 0.8, 8.5, 2, -1.2, 1.6, -1.2, 2.8, 6.5, 3.2, 11.2, 4.4, -1.2, 4, -1.2, 5,
            4.5, 5.2, 7.6, 7.6, -3.5, 7.2
        };
        return new PolygonClipScene(
                ShownWindow.of(new ClipWindow(0, 0, 10, 6)),
                PlaneFigures.points(comb),
                "sutherland-hodgman",
                "");
    }

    public PolygonClipScene showing(PolygonInWindow input) {
        return new PolygonClipScene(
                ShownWindow.of(input.window()),
                PlaneFigures.points(input.subject()),
                method,
                comparison);
    }

    public PolygonClipScene shaped(boolean upright) {
        return with(window.shaped(upright));
    }

    @Override
    public ClipMode mode() {
        return ClipMode.POLYGON;
    }

    @Override
    public PolygonClipScene withMethod(String other) {
        return new PolygonClipScene(window, subject, other, comparison);
    }

    @Override
    public PolygonClipScene withComparison(String other) {
        return new PolygonClipScene(window, subject, method, other);
    }

    private PolygonClipScene with(ShownWindow other) {
        return new PolygonClipScene(other, subject, method, comparison);
    }

    private PolygonClipScene with(List<ClipPoint> other) {
        return new PolygonClipScene(window, other, method, comparison);
    }

    @Override
    public Map<ClipGrip, ClipPoint> grips() {
        var grips = new LinkedHashMap<ClipGrip, ClipPoint>();
        for (int i = 0; i < subject.size(); i++) grips.put(ClipGrip.corner(i), subject.get(i));
        for (int i = 0; i < window.corners().size(); i++)
            grips.put(ClipGrip.window(i), window.corners().get(i));
        return grips;
    }

    @Override
    public PolygonClipScene moved(ClipGrip grip, ClipPoint to) {
        return grip.kind() == ClipGrip.ClipGripKind.WINDOW
                ? with(window.moved(grip.index(), to))
                : with(Lists.replaced(subject, grip.index(), to));
    }

    @Override
    public PolygonClipScene grown(ClipGrip beside) {
        if (beside.kind() == ClipGrip.ClipGripKind.WINDOW)
            return with(window.grown(beside.index()));
        return subject.size() >= MOST ? this : with(PlaneFigures.grown(subject, beside.index()));
    }

    @Override
    public PolygonClipScene without(ClipGrip grip) {
        if (grip.kind() == ClipGrip.ClipGripKind.WINDOW) return with(window.without(grip.index()));
        return subject.size() <= 3 ? this : with(Lists.removed(subject, grip.index()));
    }
}
