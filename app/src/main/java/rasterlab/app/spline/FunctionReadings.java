package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Function;
import java.util.stream.DoubleStream;
import rasterlab.app.canvas.PlanePoint;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.language.Texts;
import rasterlab.contract.SplineEnds;

/** The live numbers of a state as the inspector and the stage write them. */
final class FunctionReadings {
    private static final int MOST_LABELS = 16;

    /** Rows of coefficients that are shown. */
    private static final int MOST_PIECES = 12;

    private final FunctionLabState state;
    private final Texts texts;

    FunctionReadings(FunctionLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
    }

    /** How many coefficients are looked for, and by what equations. */
    String unknowns() {
        int pieces = state.choice().knots().size() - 1;
        return pieces < 1 ? "–" : texts.text("unknowns.count", 4 * pieces, 4 * pieces - 2);
    }

    String phase() {
        return state.taken().map(this::phase).orElse("–");
    }

    private String phase(FunctionDrawing.FunctionStep step) {
        return step.answer()
                .map(one -> texts.text("phase.value", number(one.x())))
                .orElseGet(() -> texts.text("phase." + step.phase(), step.index()));
    }

    String decision() {
        return state.taken()
                .map(
                        step ->
                                step.answer()
                                        .map(this::answer)
                                        .orElseGet(() -> number(step.decision())))
                .orElse("–");
    }

    /** The label's key of {@link #decision}. */
    String decides() {
        return state.taken().flatMap(FunctionDrawing.FunctionStep::answer).isPresent()
                ? "answer"
                : "decision";
    }

    private String answer(FunctionDrawing.FunctionAnswer one) {
        return one.wrong()
                ? texts.text("answer.wrong", number(one.value()), number(one.right()))
                : texts.text("answer.right", number(one.value()));
    }

    String overshoot() {
        return overshoot(state.drawing());
    }

    /** The second method's overshoot; "" when none is compared. */
    String other() {
        return state.drawings().other().map(this::overshoot).orElse("");
    }

    private String overshoot(FunctionDrawing drawing) {
        if (drawing.coefficients().isEmpty()) return "–";
        if (drawing.overshoots().isEmpty()) return texts.text("overshoot.none");
        return texts.text(
                "overshoot.worst", number(drawing.worstOvershoot()), drawing.overshoots().size());
    }

    String error() {
        double error = state.drawing().error();
        return Double.isNaN(error) ? "–" : texts.text("error.share", number(error));
    }

    String at() {
        return at(place -> number(place.x()));
    }

    String value() {
        return at(place -> number(place.y()));
    }

    String piece() {
        return at(place -> texts.text("piece.s", place.piece(), number(place.s())));
    }

    String slope() {
        return at(place -> number(place.slope()));
    }

    String second() {
        return at(place -> number(place.second()));
    }

    private String at(Function<FunctionAt, String> reading) {
        return state.at().map(reading).orElse("–");
    }

    /** a, b, c and d of each piece. */
    List<Formula> coefficients() {
        List<double[]> pieces = state.drawing().coefficients();
        if (pieces.isEmpty()) return List.of(Formula.of(new Formula.FormulaWords("–")));
        var rows = new ArrayList<List<String>>();
        for (double[] piece : pieces.subList(0, Math.min(MOST_PIECES, pieces.size())))
            rows.add(DoubleStream.of(piece).mapToObj(this::number).toList());
        var formulas = new ArrayList<Formula>();
        formulas.add(
                Formula.of(
                        new Formula.FormulaWords("S(x) = a + b·s + c·s² + d·s³,  s = x − x[i]")));
        formulas.add(Formula.of(new Formula.Matrix(List.of("a", "b", "c", "d"), rows)));
        if (pieces.size() > MOST_PIECES) formulas.add(Formula.of(new Formula.FormulaWords("…")));
        return formulas;
    }

    /** A sentence over the stage where the picture alone would mislead; "" where it does not. */
    String note() {
        FunctionDrawing drawing = state.drawing();
        return switch (drawing.ending()) {
            case ENDED -> "";
            case REFUSED ->
                    OwnWords.refusal(drawing.method(), drawing.message(), texts.language())
                            .orElseGet(
                                    () ->
                                            texts.text(
                                                    "note.refusedKnots",
                                                    drawing.method(),
                                                    VerdictDetail.translated(
                                                            texts.language(), drawing.message())));
            case UNDRAWABLE ->
                    texts.text(
                            "note.undrawable",
                            drawing.method(),
                            VerdictDetail.translated(texts.language(), drawing.message()));
            case CRASHED -> texts.text("note.crashed", drawing.method(), drawing.message());
        };
    }

    /** The knots' handles, then those of the end slopes where there are any. */
    List<PlanePoint> points(FunctionLabModel model) {
        List<Place> knots = state.choice().knots();
        var points = new ArrayList<PlanePoint>();
        for (int i = 0; i < knots.size(); i++)
            if (isPlace(knots.get(i))) points.add(knot(i, knots));
        if (state.choice().ends().kind() != SplineEnds.Kind.SLOPES) return points;
        points.add(slope("left", model.slopeHandle(true), state.choice().ends().left()));
        points.add(slope("right", model.slopeHandle(false), state.choice().ends().right()));
        return points;
    }

    private static boolean isPlace(Place knot) {
        return Double.isFinite(knot.x()) && Double.isFinite(knot.y());
    }

    private PlanePoint knot(int i, List<Place> knots) {
        Place knot = knots.get(i);
        return new PlanePoint(
                "point." + i,
                knot.x(),
                knot.y(),
                PlanePoint.HandleShape.CIRCLE,
                knots.size() <= MOST_LABELS ? String.valueOf(i) : "",
                texts.text("knot", i, number(knot.x()), number(knot.y())));
    }

    private PlanePoint slope(String side, Place place, double slope) {
        return new PlanePoint(
                "slope." + side,
                place.x(),
                place.y(),
                PlanePoint.HandleShape.DIAMOND,
                "",
                texts.text("slope." + side + ".handle", number(slope)));
    }

    private String number(double value) {
        return Shown.number(value, 4, locale());
    }

    private Locale locale() {
        return texts.locale();
    }
}
