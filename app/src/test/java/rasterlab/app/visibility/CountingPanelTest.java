package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.engine.pipeline.Renderer;

class CountingPanelTest {
    @ParameterizedTest(name = "a wait for {1} is told as one for another chart: {0}")
    @CsvSource({
        "ENGLISH, GROWTH, Counting the methods’ work…",
        "ENGLISH, PRECISION, Measuring what depth buffers tell apart…",
        "RUSSIAN, GROWTH, Считаем работу методов…",
        "RUSSIAN, PRECISION, Измеряем точность буферов глубины…"
    })
    void eachChartSaysWhatIsCounted(Language language, StageView view, String said) {
        var renderer = new Renderer();
        try (var model =
                new VisibilityLabModel(
                        new OwnMethods(), renderer::render, Runnable::run, failure -> {})) {
            var panel = new CountingPanel(model, Texts.of("visibility", language));
            assertFalse(panel.isVisible(), "before a chart is asked for");
            panel.refresh(view);
            assertTrue(panel.isVisible());
            assertEquals(said, part(panel, JLabel.class).getText());
            var bar = part(panel, JProgressBar.class);
            assertEquals(said, bar.getAccessibleContext().getAccessibleName());
        }
    }

    private static <T> T part(CountingPanel panel, Class<T> kind) {
        return Stream.of(panel.getComponents())
                .filter(kind::isInstance)
                .map(kind::cast)
                .findFirst()
                .orElseThrow();
    }
}
