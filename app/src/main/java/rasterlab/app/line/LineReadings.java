package rasterlab.app.line;

import java.text.NumberFormat;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Collectors;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.engine.raster.PixelDifference;

/** The live numbers of a state as the inspector writes them. */
final class LineReadings {
    private static final String NONE = "–";

    private final LineLabState state;
    private final Texts texts;

    LineReadings(LineLabState state, Texts texts) {
        this.state = state;
        this.texts = texts;
    }

    String pixel() {
        if (state.step() == 0) return NONE;
        return drawing().shades(state.step()).stream()
                .map(shade -> Shown.point(shade.x(), shade.y(), texts.locale()))
                .collect(Collectors.joining(", "));
    }

    /** How much the step covered of each of its pixels. */
    String coverage() {
        if (state.step() == 0) return NONE;
        return texts.text(
                "coverage.levels",
                drawing().shades(state.step()).stream()
                        .map(shade -> Integer.toString(shade.level()))
                        .collect(Collectors.joining(", ")));
    }

    /** The decision variable and which pixel it is about. */
    String decision() {
        var decisions = drawing().trace().decisions();
        if (state.step() == 0 || decisions.isEmpty()) return NONE;
        double value = decisions.get(state.step() - 1);
        return switch (drawing().trace().decides()) {
            case THIS_PIXEL -> texts.text("decides.this", number(value));
            case NEXT_PIXEL -> state.finished() ? NONE : texts.text("decides.next", number(value));
        };
    }

    private String number(double value) {
        if (!Double.isFinite(value)) return Double.toString(value);
        NumberFormat format = NumberFormat.getInstance(texts.locale());
        format.setMaximumFractionDigits(4);
        return format.format(value).replace('-', '−');
    }

    /** Where the next step goes. */
    String decided() {
        if (state.step() == 0) return NONE;
        if (state.finished()) return texts.text("decided.end");
        long dx = (long) drawing().x(state.step() + 1) - drawing().x(state.step());
        long dy = (long) drawing().y(state.step() + 1) - drawing().y(state.step());
        if (dx == 0) return "y " + signed(dy);
        if (dy == 0) return "x " + signed(dx);
        return "x " + signed(dx) + ", y " + signed(dy);
    }

    private static boolean answered(LineDrawing drawing) {
        return drawing.trace().ending().answered();
    }

    String missing() {
        if (!answered(drawing())) return NONE;
        if (!state.finished()) return texts.text("missing.later");
        return texts.text("pixels", drawing().marks().missingCount(state.step()));
    }

    String extra() {
        if (!answered(drawing())) return NONE;
        return texts.text("pixels", drawing().marks().extraCount(state.step()));
    }

    String worst() {
        return worst(drawing());
    }

    /** How many pixels only one of two methods lights; "" where no two are compared. */
    String apart() {
        return apart(state.drawings().apart(), state.finished(), texts);
    }

    /**
     * @param finished whether all pixels are lit, before which none can be missed
     */
    static String apart(Optional<PixelDifference> methods, boolean finished, Texts texts) {
        if (methods.isEmpty()) return "";
        if (!finished) return texts.text("missing.later");
        int extra = methods.get().extra().size();
        int missing = methods.get().missing().size();
        return texts.text("apart.pixels", extra + missing, extra, missing);
    }

    /**
     * The wrong pixels of a second method or of a program in one line, while it steps those that
     * can be told so far; "" when there is none.
     */
    String other() {
        return state.other().map(this::other).orElse("");
    }

    private String other(LineDrawing other) {
        if (!answered(other)) return NONE;
        if (state.finished()) return wrong(other.difference());
        int step = Math.min(state.step(), other.pixels());
        return texts.text("other.later", other.marks().extraCount(step));
    }

    /** Counts what is wrong; only the first pixels of a program that was cut are compared. */
    private String wrong(PixelDifference difference) {
        int missing = difference.missing().size();
        int extra = difference.extra().size();
        OptionalInt first =
                state.drawings().tried().map(TrialSegment::first).orElse(OptionalInt.empty());
        return first.isEmpty()
                ? texts.text("other.wrong", missing, extra)
                : texts.text("tried.wrong", missing, extra, first.getAsInt());
    }

    private String worst(LineDrawing drawing) {
        if (drawing.pixels() == 0 || !answered(drawing)) return NONE;
        if (!state.finished()) return texts.text("missing.later");
        if (drawing.coverage().isPresent())
            return texts.text("worst.levels", drawing.coverage().get().worst());
        NumberFormat format = NumberFormat.getInstance(texts.locale());
        format.setMaximumFractionDigits(3);
        return texts.text("worst.pixels", format.format(drawing.deviation().worst()));
    }

    private LineDrawing drawing() {
        return state.drawing();
    }

    private static String signed(long step) {
        return (step < 0 ? "− " : "+ ") + Math.abs(step);
    }
}
