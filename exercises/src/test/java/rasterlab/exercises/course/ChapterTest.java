package rasterlab.exercises.course;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rasterlab.engine.Topics;
import rasterlab.exercises.Exercise;
import rasterlab.exercises.catalogue.Catalogue;

class ChapterTest {
    private static final List<Exercise> ALL = Catalogue.builtIn().all();

    @Test
    void everyExerciseStandsOnceUnderItsTopicWhateverTheCataloguesOrder() {
        var shuffled = new ArrayList<>(ALL);
        Collections.shuffle(shuffled, new Random(5));
        var found = new ArrayList<String>();
        for (Chapter chapter : Chapter.of(shuffled))
            for (Exercise one : chapter.exercises()) {
                assertEquals(chapter.topic(), one.topic(), one.id());
                found.add(one.id());
            }
        assertEquals(
                ALL.stream().map(Exercise::id).sorted().toList(), found.stream().sorted().toList());
    }

    @Test
    void topicsStandInTheCoursesOrder() {
        List<String> order = Topics.names();
        List<Integer> places =
                Chapter.of(ALL).stream().map(one -> order.indexOf(one.topic())).toList();
        assertEquals(places.stream().sorted().toList(), places);
    }

    @Test
    void exercisesToWriteComeBeforeThoseToBreakAndThoseBeforeThoseToPredict() {
        List<String> line = Chapter.of(ALL).get(0).exercises().stream().map(Exercise::id).toList();
        assertEquals(
                List.of("line-bresenham", "window-segment", "break-line", "predict-line"), line);
    }

    @Test
    void kindsKeepTheirOrderWhateverTheCataloguesOrder() {
        var reversed = new ArrayList<>(ALL);
        Collections.reverse(reversed);
        for (Chapter chapter : Chapter.of(reversed)) {
            List<Exercise.TaskKind> forms =
                    chapter.exercises().stream().map(Exercise::form).toList();
            assertEquals(forms.stream().sorted().toList(), forms, chapter.topic());
        }
    }

    @Test
    void everyTopicAndItsLabHasATitleOfItsOwnInRussian() {
        for (String topic : Topics.names()) {
            var chapter = new Chapter(topic, List.of());
            assertNotEquals(chapter.title("en"), chapter.title("ru"), topic);
            assertNotEquals(chapter.labTitle("en"), chapter.labTitle("ru"), topic);
        }
    }

    @Test
    void topicWithoutExercisesHasNoHeading() {
        assertEquals(
                Optional.empty(),
                Chapter.of(List.of(ALL.get(0))).stream()
                        .filter(one -> one.exercises().isEmpty())
                        .findFirst());
    }
}
