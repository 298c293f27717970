package rasterlab.app.line;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JLabel;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.line.trace.LineMode;
import rasterlab.engine.line.LineTopic;

class FigureInspectorTest {
    private final List<Throwable> failures = new ArrayList<>();

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("figures")
    void nameOfTheRadiiIs(LineMode mode, Language language, String called) {
        try (var model = new LineLabModel(new LineTopic(), Runnable::run, failures::add)) {
            var inspector = new FigureInspector(model, Texts.of("line", language));
            for (LineMode each : List.of(LineMode.ELLIPSE, LineMode.CIRCLE, mode)) {
                model.figures().chooseMode(each);
                inspector.refresh();
            }
            List<String> labels =
                    Stream.of(inspector.column().getComponents())
                            .filter(each -> "radii".equals(each.getName()))
                            .map(each -> ((JLabel) each).getText())
                            .toList();
            assertEquals(List.of(called), labels);
        }
        assertEquals(List.of(), failures);
    }

    static Stream<Arguments> figures() {
        return Stream.of(
                argumentSet(
                        "the radius of a circle is called radii",
                        LineMode.CIRCLE,
                        Language.RUSSIAN,
                        "Радиус"),
                argumentSet(
                        "the radii of an ellipse are called a radius",
                        LineMode.ELLIPSE,
                        Language.RUSSIAN,
                        "Радиусы"),
                argumentSet(
                        "an English circle has radii",
                        LineMode.CIRCLE,
                        Language.ENGLISH,
                        "Radius"));
    }
}
