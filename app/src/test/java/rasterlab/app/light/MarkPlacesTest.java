package rasterlab.app.light;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Point2D;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.light.panel.LightGrip;
import rasterlab.app.light.panel.LightGrips;
import rasterlab.app.light.panel.StagePlan;

/** Line and point that were marked in a picture whose size changes. */
@Timeout(300)
class MarkPlacesTest {
    /** World units that half a pixel of the smallest picture stands for, on a slanted face. */
    private static final double PIXEL = 3;

    private static final int USUAL = 300;

    private final ModelThread thread = new ModelThread();
    private final LightLabModel model =
            new LightLabModel(
                    thread,
                    failure -> {
                        throw new AssertionError(failure);
                    });

    @AfterEach
    void close() {
        model.close();
    }

    @ParameterizedTest(name = "a lamp at the edge of a picture of {0}×{1} is cut off")
    @CsvSource({"300, 500", "220, 140", "90, 200"})
    void lampsAreWhollyInThePicture(int width, int height) {
        LightFrame.DrawnFrame drawn = drawn(width, height);
        var box = new Rectangle(width, height);
        for (double[] to : new double[][] {{-1, -1}, {2, 2}}) {
            double[] far =
                    drawn.places()
                            .toWorld(
                                    to[0] * drawn.width(),
                                    to[1] * drawn.height(),
                                    LightGrips.pixel(drawn, model.state().choice().lamp())[2]);
            model.choose(choice -> choice.withLamp(choice.lamp().moved(far[0], far[1], far[2])));
            Point2D at =
                    LightGrips.at(
                            new LightGrip(
                                    LightGrip.LightGripKind.LAMP,
                                    model.state().choice().selected()),
                            drawn,
                            model.state().choice(),
                            box);
            var whole = new Rectangle((int) at.getX() - 15, (int) at.getY() - 15, 30, 30);
            assertTrue(box.contains(whole), at.toString());
        }
    }

    @ParameterizedTest(name = "the point slips on the body in a picture of {0}×{1}")
    @CsvSource({"300, 500", "600, 300", "420, 210", "220, 700"})
    void pointStaysOnItsPlaceOfTheBody(int width, int height) {
        assertArrayEquals(marked(USUAL, USUAL), marked(width, height), PIXEL);
    }

    private double[] marked(int width, int height) {
        return drawn(width, height).point().orElseThrow().position();
    }

    private LightFrame.DrawnFrame drawn(int width, int height) {
        model.resize(width, height);
        thread.settle(model::settle);
        return model.state().drawn().orElseThrow();
    }

    @Test
    void gripLiesWhereItWasDragged() {
        var grips = new LightGrips(model);
        var plan = new StagePlan(3 * USUAL, USUAL, 10);
        Rectangle box = plan.picture(0);
        LightFrame.DrawnFrame drawn = drawn(box.width, box.height);
        for (LightGrip.LightGripKind kind :
                List.of(
                        LightGrip.LightGripKind.FROM,
                        LightGrip.LightGripKind.TO,
                        LightGrip.LightGripKind.POINT)) {
            var grip = new LightGrip(kind, 0);
            for (var place : List.of(new Point(40, 9), new Point(201, 120), new Point(0, 0))) {
                grips.drag(grip, place, plan);
                Point2D at = LightGrips.at(grip, drawn, model.state().choice(), box);
                assertEquals(0, at.distance(place), 1e-9, kind + " at " + at);
            }
        }
    }

    @Test
    void markBesideThePictureIsShownAtItsEdge() {
        var wide = new MarkPlaces(800, 200);
        var narrow = new MarkPlaces(200, 800);
        assertEquals(200, narrow.x(wide.markX(800)));
        assertEquals(0, narrow.x(wide.markX(0)));
        assertEquals(0, wide.y(narrow.markY(0)));
    }
}
