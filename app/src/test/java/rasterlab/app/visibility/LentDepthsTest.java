package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.app.visibility.scene.StageView;
import rasterlab.engine.pipeline.Renderer;

/** The depths of one method while another is chosen. */
@Timeout(300)
class LentDepthsTest {
    private final ModelThread thread = new ModelThread();
    private final List<Throwable> failures = new CopyOnWriteArrayList<>();
    private final VisibilityLabModel model =
            new VisibilityLabModel(new OwnMethods(), new Renderer()::render, thread, failures::add);

    @AfterEach
    void close() {
        model.close();
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(
            name = "{0}: an empty list of steps stands there, or none with the method''s own")
    @CsvSource({"painter, false", "z16, true"})
    void listOfStepsIsThereWithTheMethodsOwnDepths(String method, boolean there) {
        model.resize(60, 40);
        model.watchSteps(true);
        model.choose(choice -> choice.withVisibility(method).withView(StageView.DEPTHS));
        thread.settle(model::settle);
        Texts texts = Texts.of("visibility", Language.ENGLISH);
        var saving = new SceneSaving(model, texts, (title, scene, way, done) -> {});
        var inspector = new VisibilityInspector(model, texts, saving);
        inspector.sections().forEach(Runnable::run);
        inspector.refresh();
        boolean shown =
                Stream.of(inspector.column().getComponents())
                        .filter(part -> "steps.scroll".equals(part.getName()))
                        .anyMatch(Component::isVisible);
        assertEquals(there, shown);
    }

    @Test
    @DisplayName("a painter's steps are told over another method's depths")
    void stepsAreThoseOfTheMethodWhoseDepthsAreShown() {
        model.resize(60, 40);
        model.watchSteps(true);
        thread.settle(model::settle);
        model.goTo(3);
        model.choose(choice -> choice.withView(StageView.DEPTHS));
        thread.settle(model::settle);
        assertEquals("zfloat", model.state().picture().orElseThrow().lent().orElseThrow());
        assertTrue(model.state().drawn().isEmpty(), "the painter's steps");
        var readings = new VisibilityReadings(model, Texts.of("visibility", Language.ENGLISH));
        assertEquals("none: another method’s depths", readings.work().get(0));
        model.choose(choice -> choice.withView(StageView.COLORS));
        thread.settle(model::settle);
        assertTrue(model.state().picture().orElseThrow().lent().isEmpty());
        assertEquals(3, new DrawingSteps(model).step(), "the step was lost");
        model.choose(choice -> choice.withVisibility("z16").withView(StageView.DEPTHS));
        thread.settle(model::settle);
        assertTrue(model.state().picture().orElseThrow().lent().isEmpty());
        assertTrue(model.lastStep() > 0, "steps of a method with depths of its own");
    }
}
