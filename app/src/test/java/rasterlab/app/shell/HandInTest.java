package rasterlab.app.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.card.TopicCard;
import rasterlab.app.rooms.LabRooms;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.Exercise.Form;
import rasterlab.exercises.catalogue.Catalogue;

/** Inputs for 'break it', handed in from the labs. */
class HandInTest {
    private final LabModels models = LabModels.first(answer -> {}, HandInTest::fail);
    private final LabOpening opening =
            new LabOpening(models, work -> {}, Runnable::run, HandInTest::fail);
    private final List<String> told = new ArrayList<>();

    private static void fail(Throwable failure) {
        throw new AssertionError(failure);
    }

    @AfterEach
    void close() {
        models.close();
    }

    @Test
    void labsOfTheseTopicsHandIn() {
        Set<String> topics = new TreeSet<>();
        for (TopicCard<?> card : LabRooms.cards())
            if (opening.handsIn(card.topic())) topics.add(card.topic());
        assertEquals(
                new TreeSet<>(
                        Set.of(
                                "line",
                                "circle",
                                "ellipse",
                                "fill",
                                "polygon-fill",
                                "point-in-triangle",
                                "point-in-polygon",
                                "triangulate",
                                "clip-segment",
                                "clip-polygon",
                                "clip-volume",
                                "curve",
                                "spline-function")),
                topics);
    }

    @ParameterizedTest(name = "another input of {0} is handed in than is shown")
    @CsvSource(
            delimiter = '|',
            value = {
                "line | {\"from\":[1,2],\"to\":[-3,4]}",
                "circle | {\"center\":[2,-3],\"radius\":4}",
                "ellipse | {\"center\":[2,-3],\"rx\":5,\"ry\":4}",
                "polygon-fill | {\"polygon\":[[2,2],[8,2],[8,8],[2,8]],\"rule\":\"evenodd\",\"size\":[12,12]}",
                "point-in-triangle | {\"triangle\":[[0,0],[4,0],[2,5]],\"points\":[[1,1]]}",
                "point-in-polygon | {\"polygon\":[[0,0],[4,0],[2,5]],\"points\":[[1,1]]}",
                "triangulate | {\"polygon\":[[0,0],[4,0],[4,4],[0,5]]}",
                "clip-segment | {\"window\":[0,0,9,8],\"segments\":[[-1,2,5,6]]}",
                "clip-polygon | {\"window\":[0,0,9,8],\"polygon\":[[-1,2],[5,6],[3,-2]]}"
            })
    void inputThatIsShownIsHandedIn(String topic, String json) throws Exception {
        Exercise exercise = breaking(topic);
        opening.tellHandingInTo((tab, one) -> told.add(one.id()));
        opening.showToHandIn(exercise.id(), topic, json);
        assertEquals(List.of(exercise.id()), told);
        assertEquals(
                new JsonMapper().readTree(json),
                new JsonMapper().readTree(opening.written(topic).orElseThrow()));
    }

    @Test
    void inputOfAnotherModeOfTheLabIsNotHandedIn() {
        opening.showToHandIn("break-circle", "circle", "{\"center\":[2,-3],\"radius\":4}");
        assertEquals(Optional.empty(), opening.written("ellipse"));
        assertEquals(Optional.empty(), opening.written("line"));
        assertFalse(opening.handIn(breaking("ellipse")));
    }

    @Test
    void handingInShowsTheExerciseAndTriesTheInput() {
        List<String> tabs = new ArrayList<>();
        opening.showTabsBy(tabs::add);
        opening.showToHandIn("break-circle", "circle", "{\"center\":[2,-3],\"radius\":4}");
        assertTrue(opening.handIn(breaking("circle")));
        assertEquals(List.of("line", "exercises"), tabs);
    }

    private static Exercise breaking(String topic) {
        return Catalogue.builtIn().all().stream()
                .filter(one -> one.form() == Form.BREAK && one.topic().equals(topic))
                .findFirst()
                .orElseThrow();
    }
}
