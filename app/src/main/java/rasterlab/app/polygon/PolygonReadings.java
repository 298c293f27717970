package rasterlab.app.polygon;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.method.OwnWords;
import rasterlab.app.canvas.widget.Formula;
import rasterlab.app.canvas.widget.Formula.FormulaWords;
import rasterlab.app.canvas.widget.Formula.Matrix;
import rasterlab.app.language.Texts;
import rasterlab.app.polygon.figure.CutFigure;
import rasterlab.app.polygon.figure.Grip;
import rasterlab.app.polygon.figure.InsideFigure;
import rasterlab.app.polygon.figure.PolygonMode;
import rasterlab.app.polygon.figure.PolygonPoint;
import rasterlab.app.polygon.figure.PolygonScene;
import rasterlab.app.polygon.outcome.CutAnswer;
import rasterlab.app.polygon.outcome.CutAnswer.CutTriangle;
import rasterlab.app.polygon.outcome.CutAnswer.TriangleFault;
import rasterlab.app.polygon.outcome.InsideAnswer;
import rasterlab.app.polygon.outcome.InsideAnswer.AskedSide;
import rasterlab.app.polygon.outcome.MethodOutcome;
import rasterlab.app.polygon.outcome.PixelAnswer;
import rasterlab.app.polygon.outcome.Runs;
import rasterlab.engine.polygon.scan.RowCrossing;

/** The live numbers of a state as the inspector writes them. */
final class PolygonReadings {
    private static final String NONE = "–";
    private static final String LETTERS = "ABC";

    private final PolygonLabState state;
    private final PolygonScene scene;
    private final MethodOutcome outcome;
    private final Texts texts;

    PolygonReadings(PolygonLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
        scene = state.results().scene();
        outcome = state.results().outcome();
    }

    /** The name of a point of the figure. */
    static String named(PolygonMode mode, Grip grip, Texts texts) {
        return texts.text(
                "grip." + grip.kind().name().toLowerCase(Locale.ROOT), corner(mode, grip.index()));
    }

    /** The label beside it. */
    static String label(PolygonMode mode, Grip grip) {
        return switch (grip.kind()) {
            case CORNER -> corner(mode, grip.index());
            case POINT -> "P";
            case SEED -> "S";
            case PEN -> "";
        };
    }

    private static String corner(PolygonMode mode, int corner) {
        return mode == PolygonMode.TRIANGLE
                ? LETTERS.substring(corner % 3, corner % 3 + 1)
                : String.valueOf(corner);
    }

    private Optional<AskedSide> side() {
        return state.onAStep()
                        && outcome.answer() instanceof InsideAnswer answer
                        && !answer.pointwise()
                ? Optional.of(answer.sides().get(state.step() - 1))
                : Optional.empty();
    }

    /** The answer for the step's point of a method that tells no sides. */
    private Optional<JudgedPoint> judged() {
        if (!state.onAStep()
                || !(outcome.answer() instanceof InsideAnswer answer)
                || !answer.pointwise()) return Optional.empty();
        return Optional.of(new JudgedPoint(answer, state.step() - 1));
    }

    /** The label's key of {@link #decision}. */
    String decides() {
        return judged().isPresent() ? "answer" : "decision";
    }

    private record JudgedPoint(InsideAnswer answer, int number) {}

    private Optional<CutTriangle> cut() {
        return state.onAStep() && outcome.answer() instanceof CutAnswer answer
                ? Optional.of(answer.cuts().get(state.step() - 1))
                : Optional.empty();
    }

    /** The subject of the step. */
    String tested() {
        if (!state.onAStep())
            return state.finished()
                    ? texts.text("step.result", outcome.steps())
                    : texts.text("step.none");
        if (side().isPresent()) return tested(side().get());
        if (judged().isPresent()) return tested(judged().get());
        if (cut().isPresent())
            return texts.text("step.cut", cut().get().a(), cut().get().b(), cut().get().c());
        Runs runs = ((PixelAnswer) outcome.answer()).runs();
        int run = state.step() - 1;
        return texts.text("step.run", runs.y(run), runs.from(run), runs.to(run) - 1);
    }

    private String tested(JudgedPoint point) {
        PolygonPoint at = ((InsideFigure) scene.figure()).points().get(point.number());
        return texts.text(
                "step.point",
                point.number() + 1,
                point.answer().inside().size(),
                Shown.number(at.x(), texts.locale()),
                Shown.number(at.y(), texts.locale()));
    }

    private String tested(AskedSide side) {
        String from = corner(scene.mode(), side.from());
        if (side.from() == side.to()) return texts.text("step.corner", from);
        return texts.text("step.side", from, corner(scene.mode(), side.to()));
    }

    /** The value that decides the step, or the verdict on its point. */
    String decision() {
        if (side().isPresent()) return value(side().get().value(), texts.locale());
        if (judged().isPresent()) return verdict(judged().get().answer(), judged().get().number());
        if (cut().isPresent()) {
            PolygonPoint a = ((CutFigure) scene.figure()).corners().get(cut().get().a());
            PolygonPoint c = ((CutFigure) scene.figure()).corners().get(cut().get().c());
            double dx = c.x() - a.x();
            double dy = c.y() - a.y();
            return "|ac|² = " + Shown.number(dx * dx + dy * dy, texts.locale());
        }
        if (!state.onAStep() || !(outcome.answer() instanceof PixelAnswer answer)) return NONE;
        int waiting = answer.runs().waiting(state.step() - 1);
        return texts.text("waiting." + scene.mode().code(), waiting);
    }

    /**
     * A zero whose sign bit is set is shown with its sign: methods that look at that bit differ.
     */
    static String value(double value, Locale locale) {
        boolean negativeZero = value == 0 && Math.copySign(1, value) < 0;
        return negativeZero ? "−0" : Shown.number(value, locale);
    }

    /** The verdicts on the first point, by the method and exactly. */
    String verdict() {
        if (!(outcome.answer() instanceof InsideAnswer answer)) return NONE;
        return verdict(answer, 0);
    }

    private String verdict(InsideAnswer answer, int point) {
        String exact = texts.text(answer.exact().get(point) ? "inside" : "outside");
        if (answer.inside().isEmpty()) return texts.text("verdict.refused", exact);
        String said = texts.text(answer.inside().get(point) ? "inside" : "outside");
        return said.equals(exact)
                ? texts.text("verdict.right", said)
                : texts.text("verdict.wrong", said, exact);
    }

    /** How many turns of three corners were computed, or pixels read and written. */
    String work() {
        if (outcome.answer() instanceof CutAnswer answer) {
            int made = Math.min(state.step(), answer.steps());
            return made == 0 ? NONE : texts.text("turns", answer.cuts().get(made - 1).turns());
        }
        if (!(outcome.answer() instanceof PixelAnswer answer)) return NONE;
        boolean counted = scene.mode() == PolygonMode.SEED && answer.reads() > 0;
        return counted
                ? texts.text("reads", answer.reads(), answer.writes())
                : texts.text("writes", answer.writes());
    }

    String missing() {
        return count(outcome.deviation().missing());
    }

    String extra() {
        return count(outcome.deviation().extra());
    }

    /** How many triangles are wrong by themselves, and in which way. */
    String faulty() {
        if (!(outcome.answer() instanceof CutAnswer answer) || answer.steps() == 0) return NONE;
        if (!state.finished()) return texts.text("known.later");
        var kinds = new ArrayList<String>();
        for (TriangleFault fault : TriangleFault.values()) {
            long count = answer.cuts().stream().filter(cut -> cut.fault() == fault).count();
            if (fault != TriangleFault.NONE && count > 0)
                kinds.add(texts.text("faulty." + fault.name().toLowerCase(Locale.ROOT), count));
        }
        return kinds.isEmpty()
                ? texts.text("faulty.count", 0, answer.steps())
                : String.join(", ", kinds);
    }

    private String count(long items) {
        if (outcome.ending() != MethodOutcome.MethodEnding.ENDED) return NONE;
        if (!state.finished()) return texts.text("known.later");
        if (outcome.answer() instanceof InsideAnswer answer)
            return judged("items.at", "items.points", items, answer);
        return texts.text("items." + scene.mode().code(), items);
    }

    /** These count the figure's points; the picture tells about all others. */
    private String judged(String ofOne, String ofMore, long wrong, InsideAnswer answer) {
        int points = answer.exact().size();
        return points == 1 ? texts.text(ofOne, wrong) : texts.text(ofMore, wrong, points);
    }

    String worst() {
        if (outcome.ending() != MethodOutcome.MethodEnding.ENDED) return NONE;
        if (!state.finished()) return texts.text("known.later");
        return texts.text(
                "worst." + scene.mode().code(),
                Shown.number(outcome.deviation().worst(), texts.locale()),
                outcome.deviation().worst());
    }

    /** The second method beside the exact answer in one line; "" when none is compared. */
    String other() {
        return state.results().other().map(this::other).orElse("");
    }

    private String other(MethodOutcome second) {
        if (second.ending() != MethodOutcome.MethodEnding.ENDED)
            return OwnWords.without(
                    second.method(),
                    texts.text("ending." + second.ending().name().toLowerCase(Locale.ROOT)),
                    texts.language());
        if (!state.finished()) return texts.text("known.later");
        if (second.answer() instanceof InsideAnswer answer)
            return judged(
                    "other.judged",
                    "other.points",
                    second.deviation().missing() + second.deviation().extra(),
                    answer);
        return texts.text("other.wrong", second.deviation().missing(), second.deviation().extra());
    }

    String selected() {
        return named(state.choice().mode(), state.selected(), texts);
    }

    /** The formulas of the step, with its numbers. */
    List<Formula> formulas() {
        if (side().isPresent() && outcome.method().startsWith("sign-"))
            return List.of(determinant(side().get()));
        if (cut().isPresent()) return List.of(doubledArea(cut().get()));
        if (!state.onAStep() || !(outcome.answer() instanceof PixelAnswer answer)) return List.of();
        int row = answer.runs().y(state.step() - 1);
        List<RowCrossing> crossings = answer.crossings().getOrDefault(row, List.of());
        return crossings.isEmpty() ? List.of() : List.of(table(crossings));
    }

    private Formula determinant(AskedSide side) {
        var figure = (InsideFigure) scene.figure();
        PolygonPoint p = figure.corners().get(side.from());
        PolygonPoint q = figure.corners().get(side.to());
        PolygonPoint at = figure.points().get(0);
        return Formula.of(
                new FormulaWords("det"),
                new Matrix(
                        List.of(
                                numbers(q.x() - p.x(), q.y() - p.y()),
                                numbers(at.x() - p.x(), at.y() - p.y()))),
                new FormulaWords("= " + value(side.value(), texts.locale())));
    }

    private Formula doubledArea(CutTriangle cut) {
        List<PolygonPoint> corners = ((CutFigure) scene.figure()).corners();
        PolygonPoint a = corners.get(cut.a());
        PolygonPoint b = corners.get(cut.b());
        PolygonPoint c = corners.get(cut.c());
        double ux = b.x() - a.x();
        double uy = b.y() - a.y();
        double vx = c.x() - a.x();
        double vy = c.y() - a.y();
        return Formula.of(
                new FormulaWords("D = det"),
                new Matrix(List.of(numbers(ux, uy), numbers(vx, vy))),
                new FormulaWords("= " + Shown.number(ux * vy - uy * vx, texts.locale())));
    }

    private List<String> numbers(double one, double other) {
        return List.of(Shown.number(one, texts.locale()), Shown.number(other, texts.locale()));
    }

    /** The row's edges: where each crosses, from which column on it counts, what it adds. */
    private Formula table(List<RowCrossing> crossings) {
        var rows = new ArrayList<List<String>>();
        rows.add(List.of("X", texts.text("table.column"), "±1", "Σ"));
        int sum = 0;
        for (RowCrossing each : crossings) {
            sum += each.winding();
            rows.add(
                    List.of(
                            Shown.number(each.x(), 3, texts.locale()),
                            String.valueOf(each.column()),
                            signed(each.winding()),
                            signed(sum)));
        }
        return Formula.of(new Matrix(rows));
    }

    private static String signed(int number) {
        return number > 0 ? "+" + number : number == 0 ? "0" : "−" + -number;
    }
}
