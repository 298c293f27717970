package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.PlanePicture;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.engine.spline.function.Overshoot;

class FunctionPictureTest {
    private static final Pattern NUMBER =
            Pattern.compile("<text[^>]*? y=\"(\\d+)\"[^>]*>([+−])([\\d.]+)<");

    /** The length from the curve to the far end of a pointer, in view units. */
    private static final int POINTER = 18;

    private static final int WIDTH = 600;

    private final List<Throwable> failures = new ArrayList<>();
    private final FunctionLabModel model = new FunctionLabModel(Runnable::run, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("in a low window numbers of overshoots cover their pointers and the knots")
    void numbersStandBeyondTheirPointers() {
        for (int height : List.of(100, 200, 600))
            for (MatchResult number : numbers(height, List.of())) {
                double baseline = Double.parseDouble(number.group(1));
                double curve = map(height).viewY(named(number.group(3)).y());
                boolean above = number.group(2).equals("+");
                assertTrue(
                        above ? baseline <= curve - POINTER : baseline >= curve + POINTER,
                        number.group() + " beside " + curve);
            }
    }

    @Test
    @DisplayName("a number of an overshoot is written over the name of a knot")
    void numbersLeaveTheLabels() {
        int all = numbers(600, List.of()).size();
        assertTrue(all > 1, all + " numbers");
        Overshoot one = named(numbers(600, List.of()).get(0).group(3));
        int x = (int) map(600).viewX(one.x());
        assertEquals(all - 1, numbers(600, List.of(new Rectangle(x, 0, 1, 600))).size());
    }

    @Test
    @DisplayName("the name of a knot is written over the graph")
    void labelsKeepOffBothGraphs() {
        FunctionDrawings drawings = model.state().drawings();
        List<Line2D> lines = picture(List.of()).lines(map(600), new Rectangle(0, 0, WIDTH, 600));
        for (FunctionDrawing each : List.of(drawings.drawing(), drawings.other().orElseThrow()))
            for (Place place : each.graph())
                assertTrue(
                        lines.stream().anyMatch(line -> line.ptSegDist(seen(place)) < 1),
                        each.method() + " at " + place);
    }

    private Point2D seen(Place place) {
        return new Point2D.Double(map(600).viewX(place.x()), map(600).viewY(place.y()));
    }

    private PlaneMap map(int height) {
        Extent all = model.everything();
        var world = new Rectangle2D.Double(all.x(), all.y(), all.width(), all.height());
        return PlaneMap.fitting(world, new Rectangle(0, 0, WIDTH, height), PlaneAxes.GRAPH);
    }

    /** Baseline, sign and digits of each number in the picture. */
    private List<MatchResult> numbers(int height, List<Rectangle> labels) {
        PlanePicture picture = picture(labels);
        String svg =
                SvgPicture.of(
                                WIDTH,
                                height,
                                g -> {
                                    g.setClip(0, 0, WIDTH, height);
                                    picture.paint(g, map(height), StageColors.LIGHT, () -> false);
                                })
                        .document();
        return NUMBER.matcher(svg).results().toList();
    }

    private PlanePicture picture(List<Rectangle> labels) {
        FunctionLabState state = model.state();
        return new FunctionPicture(
                        state.drawings(),
                        state.taken(),
                        state.answers(),
                        state.at(),
                        List.of(),
                        Locale.ROOT,
                        List.of())
                .leaving(labels);
    }

    private Overshoot named(String number) {
        return model.state().drawings().drawing().overshoots().stream()
                .filter(each -> Shown.number(each.by(), 3, Locale.ROOT).equals(number))
                .findFirst()
                .orElseThrow();
    }
}
