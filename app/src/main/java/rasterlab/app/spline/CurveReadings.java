package rasterlab.app.spline;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.language.Texts;
import rasterlab.app.spline.curve.Joint;
import rasterlab.app.spline.curve.JointText;
import rasterlab.engine.spline.curve.CurvePlace;

/** The live numbers of a state as the inspector and the stage write them. */
final class CurveReadings {
    /** Labels of more points than so many would cover each other. */
    private static final int MOST_LABELS = 16;

    /** The labels as the textbook counts them: P2 and P3 are what a Bézier curve would have. */
    private static final List<String> HERMITE_LABELS = List.of("P1", "P4", "R1/3", "R4/3");

    private static final int MOST_JOINTS = 6;

    private final CurveLabState state;
    private final Texts texts;

    CurveReadings(CurveLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
    }

    String segments() {
        CurveDrawing drawing = state.drawing();
        if (drawing.points().isEmpty()) return "–";
        return drawing.splits() == 0
                ? texts.text("segments.count", drawing.segments())
                : texts.text("segments.halved", drawing.segments(), drawing.splits());
    }

    /** How far the polyline or the points are off, and what is allowed. */
    String error() {
        return error(state.drawing());
    }

    private String error(CurveDrawing drawing) {
        if (Double.isNaN(drawing.errorPixels())) return "–";
        return texts.text(
                drawing.right() ? "error.within" : "error.beyond",
                pixels(drawing.errorPixels()),
                pixels(drawing.allowedPixels()));
    }

    /** The second method's polyline in one line; "" when none is compared. */
    String other() {
        return state.drawings()
                .other()
                .map(
                        other ->
                                other.points().isEmpty()
                                        ? "–"
                                        : texts.text(
                                                "other.drew",
                                                other.segments(),
                                                pixels(other.errorPixels())))
                .orElse("");
    }

    String decision() {
        List<CurveDrawing.Corner> points = state.drawing().points();
        if (points.isEmpty()) return "–";
        double decision = points.get(state.step()).decision();
        return Double.isNaN(decision) ? "–" : number(decision);
    }

    String joints() {
        List<Joint> joints = state.drawings().joints();
        String kinds =
                joints.stream()
                        .limit(MOST_JOINTS)
                        .map(joint -> JointText.of(joint.kind()))
                        .collect(Collectors.joining("  "));
        return joints.size() > MOST_JOINTS ? kinds + " …" : kinds;
    }

    String span() {
        int spans = state.drawings().choice().curves().get(0).spans();
        int index = state.at().curve() * spans + state.at().place().span() + 1;
        int all = state.drawings().choice().curves().size() * spans;
        return texts.text("span.of", index, all, number(state.at().place().u()));
    }

    String point() {
        return Shown.point(state.at().place().x(), state.at().place().y(), locale());
    }

    String derivative() {
        return Shown.point(state.at().place().dx(), state.at().place().dy(), locale());
    }

    /** κ and the radius of the circle that bends as much. */
    String curvature() {
        CurvePlace place = state.at().place();
        double curvature = place.curvature();
        if (Double.isNaN(curvature)) return texts.text("curvature.none");
        if (curvature == 0) return texts.text("curvature.straight");
        return texts.text(
                "curvature.radius",
                Shown.number(curvature, 5, locale()),
                Shown.number(1 / Math.abs(curvature), 1, locale()));
    }

    String t() {
        return Shown.number(state.t(), 3, locale());
    }

    String flatness() {
        return texts.text("pixels", number(state.choice().sampling().flatness()));
    }

    /** A sentence over the stage where the picture alone would mislead; "" where it does not. */
    String note() {
        CurveDrawing drawing = state.drawing();
        return switch (drawing.ending()) {
            case ENDED -> "";
            case CUT -> texts.text("note.cut", drawing.method(), CurveDrawing.LIMIT);
            case REFUSED ->
                    OwnWords.refusal(drawing.method(), drawing.message(), texts.language())
                            .orElseGet(
                                    () ->
                                            texts.text(
                                                    "note.refused",
                                                    drawing.method(),
                                                    VerdictDetail.translated(
                                                            texts.language(), drawing.message())));
            case CRASHED -> texts.text("note.crashed", drawing.method(), drawing.message());
        };
    }

    /** The handles with their names. */
    List<PlanePoint> points() {
        List<Place> handles = state.choice().handles();
        return IntStream.range(0, handles.size())
                .mapToObj(i -> point(i, handles.get(i), handles.size()))
                .toList();
    }

    private PlanePoint point(int i, Place place, int count) {
        boolean hermite = state.choice().form() == CurveForm.HERMITE;
        boolean handle = state.choice().form() == CurveForm.PIECES && i % 3 != 0;
        String label = hermite ? HERMITE_LABELS.get(i) : "P" + (i + 1);
        String said =
                texts.text(
                        "handle",
                        label,
                        Shown.number(place.x(), locale()),
                        Shown.number(place.y(), locale()));
        return new PlanePoint(
                "point." + i,
                place.x(),
                place.y(),
                handle || hermite && i >= 2
                        ? PlanePoint.HandleShape.DIAMOND
                        : PlanePoint.HandleShape.CIRCLE,
                count <= MOST_LABELS ? label : "",
                said);
    }

    private String pixels(double value) {
        return Shown.number(value, 3, locale());
    }

    private String number(double value) {
        return Shown.number(value, 3, locale());
    }

    private Locale locale() {
        return texts.locale();
    }
}
