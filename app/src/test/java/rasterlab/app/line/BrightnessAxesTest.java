package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.figure.FigureLabModel;
import rasterlab.app.line.figure.FigureStage;
import rasterlab.app.line.trace.LineMode;
import rasterlab.app.shell.OffscreenPainter;

class BrightnessAxesTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    @ParameterizedTest(name = "nothing says what the brightness chart''s axes are: {0}")
    @CsvSource(
            delimiter = '|',
            value = {
                "ENGLISH | angle to the rows, degrees | light per pixel of length",
                "RUSSIAN | угол к строкам, градусы | свет на пиксель длины"
            })
    void bothAxesOfTheBrightnessAreNamed(Language language, String degrees, String light)
            throws Exception {
        try (var model = new FigureLabModel(EventQueue::invokeLater, failures::add)) {
            model.chooseMode(LineMode.BRIGHTNESS);
            model.settle();
            EventQueue.invokeAndWait(() -> {});
            try (var stage = new FigureStage(model, Texts.of("line", language), failures::add)) {
                OffscreenPainter.paint(stage, 900, 600);
                String svg = stage.svg().document();
                for (String name : List.of(degrees, light))
                    assertTrue(svg.contains(">" + name + "</text"), svg);
            }
        }
        assertEquals(List.of(), failures);
    }
}
