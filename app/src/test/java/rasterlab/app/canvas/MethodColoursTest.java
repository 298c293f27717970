package rasterlab.app.canvas;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.HashSet;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.study.MethodLook;
import rasterlab.engine.clip.polygon.PolygonClipTopic;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.clip.volume.VolumeClipTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.PixelMark;
import rasterlab.engine.study.Method;

class MethodColoursTest {
    /** What colour-blind people can tell apart. */
    private static final int MOST_COLOURS = 11;

    static List<String> lineMethods() {
        return new LineTopic().methods().stream().map(Method::name).toList();
    }

    static Stream<List<String>> topics() {
        return Stream.concat(
                Stream.of(lineMethods(), Renderer.visibilities()),
                Stream.of(new SegmentClipTopic(), new PolygonClipTopic(), new VolumeClipTopic())
                        .map(topic -> topic.methods().stream().map(Method::name).toList()));
    }

    static Stream<String> methods() {
        return topics().flatMap(List::stream);
    }

    @Test
    void givesNoTwoMethodsOfATopicTheSameColour() {
        for (List<String> topic : topics().filter(all -> all.size() <= MOST_COLOURS).toList())
            assertEquals(
                    topic.size(),
                    new HashSet<>(topic.stream().map(MethodColours::of).toList()).size(),
                    topic.toString());
    }

    @Test
    void methodsDifferInGreyByMarkOrLine() {
        for (List<String> topic : topics().toList())
            assertEquals(
                    topic.size(),
                    MethodLook.of(topic).values().stream()
                            .map(look -> List.of(look.marker(), look.stroke()))
                            .distinct()
                            .count(),
                    topic.toString());
    }

    @Test
    void methodsForHiddenSurfacesAllHaveColoursOfTheirOwn() {
        List<String> names = Renderer.visibilities();
        assertEquals(names.size(), new HashSet<>(MethodColours.among(names).values()).size());
        for (String name : names)
            assertEquals(MethodColours.of(name), MethodColours.among(names).get(name), name);
    }

    @ParameterizedTest(name = "pixels of {0} drown in the stage")
    @MethodSource("methods")
    void edgesStandOutFromBothStages(String method) {
        for (StageColours stage : List.of(StageColours.LIGHT, StageColours.DARK)) {
            Color edge = MethodColours.edgeOn(stage.ground(), MethodColours.of(method));
            assertTrue(MethodColours.contrast(edge, stage.ground()) >= 3, method + " " + edge);
        }
    }

    @ParameterizedTest(name = "{0} looks like a wrong pixel")
    @MethodSource("methods")
    void keepsTheColourOfWrongPixelsFree(String method) {
        assertNotEquals(PixelMark.COLOUR, MethodColours.of(method));
    }

    @Test
    void measuresContrastFromOneToTwentyOne() {
        assertEquals(21, MethodColours.contrast(Color.BLACK, Color.WHITE), 1e-9);
        assertEquals(1, MethodColours.contrast(Color.RED, Color.RED), 1e-9);
    }

    @Test
    void readsInkOnEveryStage() {
        for (StageColours stage : List.of(StageColours.LIGHT, StageColours.DARK)) {
            assertTrue(MethodColours.contrast(stage.ink(), stage.ground()) >= 7);
            assertTrue(MethodColours.contrast(stage.ink(), stage.margin()) >= 7);
        }
    }

    @Test
    @DisplayName("words in a method's colour are too dark on a dark ground, or too pale")
    void wordsInAMethodsColourAreRead() {
        for (StageColours stage :
                List.of(StageColours.LIGHT, StageColours.DARK, StageColours.PROJECTOR))
            for (String method : List.of("clip-first-textbook", "midpoint", "wu", "bresenham")) {
                Color words = MethodColours.textOn(stage.ground(), MethodColours.of(method));
                double contrast = MethodColours.contrast(words, stage.ground());
                assertTrue(contrast >= 4.5, method + " on " + stage.ground() + ": " + contrast);
            }
    }
}
