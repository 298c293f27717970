package rasterlab.app.light.panel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.light.LightLabModel;
import rasterlab.app.shell.OffscreenPainter;

class LightStageTest {
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();

    @ParameterizedTest(name = "an axis of the profile has no name: {0}")
    @CsvSource({
        "ENGLISH, brightness, along the line from A to B",
        "RUSSIAN, яркость, вдоль отрезка от A до B"
    })
    void bothAxesOfTheProfileAreNamed(Language language, String up, String along) throws Exception {
        try (var model = new LightLabModel(EventQueue::invokeLater, failures::add)) {
            var stage = new LightStage(model, Texts.of("light", language));
            OffscreenPainter.paint(stage, 900, 600);
            String svg = stage.svg().document();
            for (String name : List.of(up, along))
                assertTrue(svg.contains(">" + name + "</text"), name);
        }
        assertEquals(List.of(), failures);
    }
}
