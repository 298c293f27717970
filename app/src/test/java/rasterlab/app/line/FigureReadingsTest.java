package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static rasterlab.engine.study.Verdict.Kind.CRASHED;
import static rasterlab.engine.study.Verdict.Kind.ENDLESS;
import static rasterlab.engine.study.Verdict.Kind.REFUSED;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.PlaneMap;
import rasterlab.app.canvas.StageColors;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.ArcFigure;
import rasterlab.app.line.figure.ArcPicture;
import rasterlab.app.line.figure.FigureDrawing;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.raster.PixelSet;
import rasterlab.engine.study.Hazard;

@Timeout(300)
class FigureReadingsTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final FigureLabModel model = new FigureLabModel(thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    private FigureDrawing drawing() {
        thread.settle(model::settle);
        return model.state().drawing();
    }

    @ParameterizedTest(name = "an answer that never came has numbers: {0}")
    @EnumSource(names = {"CIRCLE", "ELLIPSE"})
    void nothingIsToldOfAnAnswerThatNeverCame(LineMode mode) {
        var read = new HashSet<String>();
        var kinds = EnumSet.of(REFUSED, ENDLESS, CRASHED);
        for (Hazard<?> hazard : model.hazards(mode))
            for (String method : model.methods(mode)) {
                if (!kinds.remove(hazard.recorded().get(method))) continue;
                model.chooseMode(mode);
                model.chooseMethod(method);
                model.compareWith(method);
                model.show(mode, hazard.name());
                drawing();
                var readings =
                        new FigureReadings(model.state(), Texts.of("line", Language.ENGLISH));
                read.addAll(
                        List.of(
                                readings.missing(),
                                readings.extra(),
                                readings.worst(),
                                readings.other()));
            }
        assertEquals(Set.of("–"), read);
    }

    @ParameterizedTest(name = "the last step decides about a next pixel: {0}")
    @EnumSource(names = {"CIRCLE", "ELLIPSE"})
    void lastStepDecidesNothing(LineMode mode) {
        model.chooseMode(mode);
        model.chooseMethod("midpoint");
        drawing();
        Texts texts = Texts.of("line", Language.ENGLISH);
        model.goTo(model.last() - 1);
        assertNotEquals("–", new FigureReadings(model.state(), texts).decision());
        model.goTo(model.last());
        assertEquals("–", new FigureReadings(model.state(), texts).decision());
    }

    @Test
    @DisplayName("the frame of the current pixel has nearly the colour of pixels")
    void currentPixelStandsOut() {
        model.chooseMethod("midpoint");
        FigureDrawing drawn = drawing();
        var map = new PlaneMap(200, 200, 10, -10);
        int step = drawn.steps() / 2;
        var image = new BufferedImage(400, 400, BufferedImage.TYPE_INT_RGB);
        Graphics2D g = image.createGraphics();
        g.setClip(0, 0, 400, 400);
        new ArcPicture((ArcFigure) model.state().scene().figure(), drawn, step, PixelSet.EMPTY)
                .paint(g, map, StageColors.LIGHT, () -> false);
        g.dispose();
        double left = map.viewX(drawn.pixels().x(step - 1)) - 5;
        double top = map.viewY(drawn.pixels().y(step - 1)) - 5;
        assertEquals(StageColors.LIGHT.ink().getRGB(), image.getRGB((int) left, (int) top));
    }
}
