package rasterlab.app.spline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import rasterlab.app.canvas.PlaneAxes;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.Shown;
import rasterlab.app.canvas.StageColours;
import rasterlab.app.canvas.SvgPicture;
import rasterlab.engine.spline.Overshoot;

class FunctionPictureTest {
    private static final Pattern NUMBER =
            Pattern.compile("<text[^>]*? y=\"(\\d+)\"[^>]*>([+−])([\\d.]+)<");

    /** From the curve to the far end of a pointer, in view units. */
    private static final int POINTER = 18;

    @Test
    @DisplayName("in a low window numbers of overshoots cover their pointers and the knots")
    void numbersStandBeyondTheirPointers() {
        List<Throwable> failures = new ArrayList<>();
        try (var model = new FunctionLabModel(Runnable::run, failures::add)) {
            assertEquals(0, beyondPointers(model, 100));
            assertTrue(beyondPointers(model, 600) > 2, "numbers of a high window");
        }
        assertEquals(List.of(), failures);
    }

    /** How many numbers there are. */
    private static int beyondPointers(FunctionLabModel model, int height) {
        FunctionLabState state = model.state();
        Extent all = model.everything();
        var view = new Rectangle(0, 0, 600, height);
        var world = new Rectangle2D.Double(all.x(), all.y(), all.width(), all.height());
        PlaneMap map = PlaneMap.fitting(world, view, PlaneAxes.GRAPH);
        var picture =
                new FunctionPicture(
                        state.drawings(), state.taken(), state.at(), List.of(), Locale.ROOT);
        String svg =
                SvgPicture.of(
                                view.width,
                                view.height,
                                g -> {
                                    g.setClip(view);
                                    picture.paint(g, map, StageColours.LIGHT, () -> false);
                                })
                        .document();
        List<MatchResult> numbers = NUMBER.matcher(svg).results().toList();
        for (MatchResult number : numbers) {
            double baseline = Double.parseDouble(number.group(1));
            boolean above = number.group(2).equals("+");
            double curve = map.viewY(named(state, number.group(3)).y());
            assertTrue(
                    above ? baseline <= curve - POINTER : baseline >= curve + POINTER,
                    number.group() + " beside " + curve);
        }
        return numbers.size();
    }

    private static Overshoot named(FunctionLabState state, String number) {
        return state.drawings().drawing().overshoots().stream()
                .filter(each -> Shown.number(each.by(), 3, Locale.ROOT).equals(number))
                .findFirst()
                .orElseThrow();
    }
}
