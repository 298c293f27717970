package rasterlab.app.line;

import java.util.List;
import java.util.Locale;
import rasterlab.app.canvas.Shown;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.FigureDrawing;
import rasterlab.app.line.figure.FigureState;
import rasterlab.app.line.figure.PenFigure;
import rasterlab.app.line.figure.SlopeFigure;
import rasterlab.app.line.trace.RasterPoint;

/** The live numbers of a state as the inspector writes them. */
public final class FigureReadings {
    private static final String NONE = "–";

    private final FigureState state;
    private final FigureDrawing drawing;
    private final Texts texts;

    public FigureReadings(FigureState state, Texts texts) {
        this.state = state;
        this.texts = texts;
        drawing = state.drawing();
    }

    private Locale locale() {
        return texts.locale();
    }

    /** The pixel lit last, and where it is from the centre. */
    String pixel() {
        if (state.step() == 0) return NONE;
        int x = drawing.pixels().x(state.step() - 1);
        int y = drawing.pixels().y(state.step() - 1);
        return Shown.point(x, y, locale());
    }

    /** Columns and rows of that pixel from the centre. */
    String offset() {
        if (state.step() == 0) return NONE;
        RasterPoint offset = fromCenter();
        return "u = "
                + Shown.number(offset.x(), locale())
                + ", v = "
                + Shown.number(offset.y(), locale());
    }

    private RasterPoint fromCenter() {
        var arc = (ArcFigure) state.drawn().figure();
        double x = drawing.pixels().x(state.step() - 1);
        double y = drawing.pixels().y(state.step() - 1);
        return new RasterPoint(Math.abs(x - arc.centerX()), Math.abs(y - arc.centerY()));
    }

    /**
     * The value that decides the pixel after that one, or after its mirror image across the
     * diagonal.
     */
    String decision() {
        if (state.step() == 0 || state.finished()) return NONE;
        RasterPoint offset = fromCenter();
        Double own = drawing.decisions().get(offset);
        if (own == null) own = drawing.decisions().get(new RasterPoint(offset.y(), offset.x()));
        return own == null ? NONE : Shown.number(own, locale());
    }

    /** Whether the pixels were held against the exact figure. */
    private boolean compared() {
        return drawing.judged() && drawing.ending().answered();
    }

    public String missing() {
        if (!compared()) return NONE;
        return state.finished()
                ? texts.text("pixels", drawing.deviation().missing())
                : texts.text("missing.later");
    }

    /** Counts those extra among the pixels that are lit so far. */
    public String extra() {
        if (!compared()) return NONE;
        return texts.text("pixels", drawing.extra().among(state.step()));
    }

    /** Counts those of the extra ones that had been lit before. */
    String again() {
        return texts.text("pixels", drawing.extra().againAmong(state.step()));
    }

    /** Whether the method lights some pixel again, in all its steps. */
    boolean repeats() {
        return compared() && drawing.extra().againAmong(drawing.steps()) > 0;
    }

    public String worst() {
        if (!compared()) return NONE;
        if (!state.finished()) return texts.text("missing.later");
        return texts.text("worst.pixels", Shown.number(drawing.deviation().worst(), locale()));
    }

    /** How many pixels only one of two methods lights; "" where no two are compared. */
    public String apart() {
        return LineReadings.apart(state.drawings().apart(), state.finished(), texts);
    }

    /** The second method beside the exact figure in one line; "" when none is compared. */
    public String other() {
        return state.other().map(this::other).orElse("");
    }

    private String other(FigureDrawing second) {
        if (!second.brightness().isEmpty()) return light(second.brightness());
        if (!second.judged() || !second.ending().answered()) return NONE;
        if (!state.finished()) {
            int step = Math.min(state.step(), second.steps());
            return texts.text("other.later", second.extra().among(step));
        }
        return texts.text("other.wrong", second.deviation().missing(), second.deviation().extra());
    }

    /** The angle of the line that is looked at. */
    String angle() {
        return state.scene().figure() instanceof SlopeFigure slope ? slope.degrees() + "°" : NONE;
    }

    /** Light for a pixel of length at that angle, by the chosen method. */
    String light() {
        return drawing.brightness().isEmpty() ? NONE : light(drawing.brightness());
    }

    private String light(List<Double> brightness) {
        var slope = (SlopeFigure) state.drawn().figure();
        double light = brightness.get(slope.degrees());
        return Double.isNaN(light) ? NONE : Shown.number(light, 3, locale());
    }

    /** How long a pen's line is, in pixels. */
    String length() {
        return state.scene().figure() instanceof PenFigure pen
                ? texts.text("worst.pixels", Shown.number(pen.length(), 1, locale()))
                : NONE;
    }

    /** How many pixels the pen lights. */
    String lit() {
        return state.scene().figure() instanceof PenFigure pen
                ? texts.text("pixels", pen.lit())
                : NONE;
    }

    /** The ratio of brightness between the brightest and the darkest slope. */
    String spread() {
        if (drawing.brightness().isEmpty()) return NONE;
        double least =
                drawing.brightness().stream()
                        .mapToDouble(d -> d)
                        .filter(d -> !Double.isNaN(d))
                        .min()
                        .orElse(0);
        double most =
                drawing.brightness().stream()
                        .mapToDouble(d -> d)
                        .filter(d -> !Double.isNaN(d))
                        .max()
                        .orElse(0);
        return Shown.number(least, 3, locale()) + "…" + Shown.number(most, 3, locale());
    }

    /** Light of a line with one full pixel in each column or row. */
    String full() {
        return state.scene().figure() instanceof SlopeFigure slope
                ? Shown.number(SlopeFigure.ofFullPixels(slope.degrees()), 3, locale())
                : NONE;
    }
}
