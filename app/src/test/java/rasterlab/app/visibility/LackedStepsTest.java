package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.pipeline.Renderer;

/** The timeline of a method that draws the picture as a whole. */
@Timeout(300)
class LackedStepsTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), new Renderer()::render, thread, failures::add);
    private final Texts texts = Texts.of("visibility", Language.ENGLISH);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(
            name = "{0} offers steps that it has not, or has steps that it does not offer")
    @CsvSource({"plain, false", "raycast, false", "painter, true", "zfloat, true"})
    void stepsAreOfferedWhereThereAreSome(String method, boolean there) {
        model.resize(60, 40);
        model.watchSteps(true);
        model.choose(choice -> choice.withVisibility(method).withDrawing(true));
        thread.settle(model::settle);
        var readings = new VisibilityReadings(model, texts);
        assertEquals(there, !readings.timeline().equals("no steps"), readings.timeline());
        assertEquals(there, !readings.work().get(0).equals("none; try painter or zfloat"), method);
        assertEquals(there, model.lastStep() > 0, "steps of " + method);
        assertEquals(there, shown("steps.scroll"), "list of steps of " + method);
        assertTrue(there || model.state().drawn().isEmpty(), "what " + method + " drew");
    }

    private boolean shown(String name) {
        var saving = new SceneSaving(model, texts, (title, scene, way, done) -> {});
        var inspector = new VisibilityInspector(model, texts, saving);
        inspector.sections().forEach(Runnable::run);
        inspector.refresh();
        return Stream.of(inspector.column().getComponents())
                .filter(part -> name.equals(part.getName()))
                .anyMatch(Component::isVisible);
    }
}
