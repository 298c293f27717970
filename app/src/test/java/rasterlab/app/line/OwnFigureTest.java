package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.ArcPicture;
import rasterlab.app.line.figure.FigureDrawing;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.figure.RightFigure;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.raster.PixelSet;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

/** A program of the user's own that draws circles or ellipses. */
@Tag("slow")
class OwnFigureTest {
    @ParameterizedTest
    @CsvSource({"circle, CIRCLE", "ellipse, ELLIPSE"})
    void theModelSolutionIsRightAndStepped(String id, LineMode mode) throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named(id);
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        try (var own = new OwnMethods();
                var model = new FigureLabModel(own, Runnable::run, failures::add)) {
            own.bring(exercise, exercise.evidence().model().orElseThrow());
            model.chooseMode(mode);
            model.chooseMethod(OwnMethods.NAME);
            model.settle();
            FigureDrawing drawing = model.state().drawing();
            assertEquals(OwnMethods.NAME, drawing.method());
            assertTrue(RightFigure.is(drawing), drawing.message());
            assertEquals(drawing.pixels().size(), model.last());
            assertEquals(List.of(), failures);
        }
    }

    @Test
    void aRightPixelThatIsLitTwiceIsCountedAndMarked() throws InterruptedException {
        Exercise exercise = Catalogue.builtIn().named("circle");
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        try (var own = new OwnMethods();
                var model = new FigureLabModel(own, Runnable::run, failures::add)) {
            own.bring(
                    exercise,
                    """
                    public class Mine implements rasterlab.contract.CircleRasterizer {
                        public void draw(int x, int y, int r, rasterlab.contract.Pixels out) {
                            for (int i = 0; i < 2; i++) out.plot(x + r, y);
                            out.plot(x - r, y);
                        }
                    }
                    """);
            model.chooseMode(LineMode.CIRCLE);
            model.chooseMethod(OwnMethods.NAME);
            model.settle();
            var readings = new FigureReadings(model.state(), Texts.of("line", Language.ENGLISH));
            assertTrue(readings.repeats());
            assertEquals("1 pixel", readings.again());
            assertEquals(0, model.state().drawing().difference().extra().size());
            var arc = (ArcFigure) model.state().scene().figure();
            assertTrue(isMarked(model, arc.centerX() + arc.radiusX(), arc.centerY(), 3));
            assertFalse(isMarked(model, arc.centerX() - arc.radiusX(), arc.centerY(), 3));
            assertFalse(isMarked(model, arc.centerX() + arc.radiusX(), arc.centerY(), 1));
            assertEquals(List.of(), failures);
        }
    }

    /** Whether something of a mark's colour is seen in a pixel after so many steps. */
    private static boolean isMarked(FigureLabModel model, int x, int y, int step) {
        var arc = (ArcFigure) model.state().scene().figure();
        var map = new PlaneMap(200 - 20 * x, 200 - 20 * y, 20, 20);
        var image = new BufferedImage(400, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, 400, 400);
        new ArcPicture(arc, model.state().drawing(), step, PixelSet.EMPTY)
                .paint(g, map, StageColors.LIGHT, () -> false);
        g.dispose();
        return IntStream.range(190 * 400, 210 * 400)
                .filter(at -> at % 400 >= 190 && at % 400 < 210)
                .anyMatch(at -> image.getRGB(at % 400, at / 400) == PixelMark.ARGB);
    }
}
