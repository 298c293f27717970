package rasterlab.app.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.EventQueue;
import java.util.Optional;
import javax.swing.JButton;
import javax.swing.JSlider;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rasterlab.app.canvas.Parts;
import rasterlab.app.canvas.player.StepPlayer;
import rasterlab.app.canvas.work.ModelThread;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.mine.OwnMethods;
import rasterlab.engine.raster.Raster;

/** Wrong pixels of a scene that the timeline turns. */
@Timeout(300)
class TurntableTest {
    private final ModelThread thread = new ModelThread();
    private final VisibilityLabModel model =
            new VisibilityLabModel(
                    new OwnMethods(),
                    (request, cancelled) -> new Raster(request.width(), request.height()),
                    thread,
                    failure -> {
                        throw new AssertionError(failure);
                    });
    private final DrawingSteps steps = new DrawingSteps(model);
    private final StepPlayer player =
            new StepPlayer(Texts.of("canvas", Language.ENGLISH), steps, () -> "");

    @BeforeEach
    void turnAway() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    model.resize(10, 10);
                    model.turn(0.5, 0);
                    player.refresh();
                });
        assertTrue(counted().isEmpty());
    }

    @AfterEach
    void close() throws Exception {
        EventQueue.invokeAndWait(player::stop);
        model.close();
    }

    private Optional<Compared> counted() {
        thread.settle(model::settle);
        return model.state().difference();
    }

    private <T extends Component> T part(Class<T> type, String name) {
        return Parts.of(player)
                .filter(each -> name.equals(each.getName()))
                .findFirst()
                .map(type::cast)
                .orElseThrow();
    }

    @ParameterizedTest(name = "nothing is counted after a single step: {0}")
    @ValueSource(strings = {"toStart", "back", "forward", "toEnd"})
    void singleStepIsCounted(String button) throws Exception {
        int before = steps.step();
        EventQueue.invokeAndWait(part(JButton.class, "player." + button)::doClick);
        assertNotEquals(before, steps.step());
        assertTrue(counted().isPresent());
    }

    @Test
    @DisplayName("each step is counted while it plays, or none where it stops")
    void playingIsCountedWhereItStops() throws Exception {
        EventQueue.invokeAndWait(
                () -> {
                    player.togglePlaying();
                    steps.goTo(70);
                    steps.goTo(71);
                });
        assertTrue(counted().isEmpty());
        EventQueue.invokeAndWait(player::togglePlaying);
        assertTrue(counted().isPresent());
    }

    @Test
    @DisplayName("each place is counted while the slider is held, or none where it is let go")
    void sliderIsCountedWhereItIsLetGo() throws Exception {
        JSlider position = part(JSlider.class, "player.position");
        EventQueue.invokeAndWait(
                () -> {
                    position.setValueIsAdjusting(true);
                    position.setValue(120);
                });
        assertEquals(120, steps.step());
        assertTrue(counted().isEmpty());
        EventQueue.invokeAndWait(() -> position.setValueIsAdjusting(false));
        assertTrue(counted().isPresent());
    }
}
