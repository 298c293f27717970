package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import rasterlab.app.clip.ClipMode;
import rasterlab.app.spline.SplineMode;
import rasterlab.engine.Topics;
import rasterlab.engine.line.Segment;
import rasterlab.engine.raster.PixelWindow;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Topic;

class LabOpeningTest {
    private final LabModels models =
            LabModels.first(
                    failure -> {
                        throw new AssertionError(failure);
                    });
    private final LabOpening opening = new LabOpening(models);
    private final List<String> tabs = new ArrayList<>();

    @AfterEach
    void close() {
        models.close();
    }

    private LabOpening shown() {
        opening.showTabsBy(tabs::add);
        return opening;
    }

    @Test
    void everyHazardOfATopicWithATabIsShownByEveryMethod() {
        shown();
        for (Topic<?, ?, ?> topic : Topics.all()) {
            if (!opening.showsHazards(topic.name())) continue;
            for (Hazard<?> hazard : topic.hazards())
                for (var method : topic.methods())
                    opening.showHazard(topic.name(), hazard.name(), method.name());
        }
        assertTrue(tabs.containsAll(List.of("line", "clip", "spline")), tabs.toString());
    }

    @Test
    void hazardOfLinesIsShownWithItsMethod() {
        shown().showHazard("line", "leftward", "naive-textbook");
        assertEquals("naive-textbook", models.line().state().choice().method());
        Segment segment = models.line().state().choice().segment();
        assertTrue(segment.x1() < segment.x0(), segment.toString());
        assertEquals(List.of("line"), tabs);
    }

    @Test
    void hazardIsShownInItsMode() {
        shown().showHazard("clip-polygon", "comb", "weiler-atherton");
        assertEquals(ClipMode.POLYGON, models.clip().state().choice().scene().mode());
        opening.showHazard("spline-function", spline(), "monotone");
        assertEquals(SplineMode.FUNCTION, models.spline().mode());
        assertEquals(List.of("clip", "spline"), tabs);
    }

    private String spline() {
        return models.spline().function().hazards().get(0).name();
    }

    @Test
    void inputOfLinesIsReadWithItsWindow() {
        shown().showInput(
                        "line", "{\"from\":[1,2],\"to\":[-3,4],\"window\":[0,0,9,9]}", "bresenham");
        assertEquals(
                new Segment(1, 2, -3, 4).in(new PixelWindow(0, 0, 9, 9)),
                models.line().state().choice().segment());
    }

    @Test
    void brokenInputIsRefusedWithItsPlaceAndNoTabIsShown() {
        var refused =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> shown().showInput("line", "{\"from\":[1,2],\"to\":[3]}", ""));
        assertTrue(refused.getMessage().contains("'to'"), refused.getMessage());
        assertEquals(List.of(), tabs);
    }

    @Test
    void topicWithoutATabIsRefused() {
        assertFalse(opening.showsInputs("matrix"));
        assertThrows(
                IllegalArgumentException.class, () -> shown().showInput("matrix", "{}", "formula"));
    }
}
