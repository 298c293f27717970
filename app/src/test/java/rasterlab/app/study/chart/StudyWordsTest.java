package rasterlab.app.study.chart;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;
import rasterlab.engine.study.Topic;

class StudyWordsTest {
    @ParameterizedTest(name = "a topic's item or unit has no words in {0}")
    @EnumSource
    void everyTopicsItemAndUnitHaveWords(Language language) {
        Texts texts = Texts.of("study", language);
        List<String> missing =
                Topics.all().stream().flatMap(topic -> missing(topic, texts).stream()).toList();
        assertEquals(List.of(), missing);
    }

    private static List<String> missing(Topic<?, ?, ?> topic, Texts shared) {
        Texts own = Texts.ofTopic(topic.name(), shared.language());
        var missing = new ArrayList<String>();
        if (!own.has("item")) missing.add(StudyWords.itemKey(topic.item()));
        if (!own.has("unit")) missing.add(StudyWords.unitKey(topic.errorUnit()));
        missing.removeIf(shared::has);
        return missing;
    }

    @ParameterizedTest(name = "before the first method a colon is left: {0}")
    @CsvSource({"ENGLISH, 0 of 7, '1 of 7: midpoint'", "RUSSIAN, 0 из 7, '1 из 7: midpoint'"})
    void progressNamesWhatWasFinishedLastIfAnythingWas(
            Language language, String first, String second) {
        var words = new StudyWords(language);
        StudyWork begun = StudyWork.begun(StudyWork.Kind.STUDY, 7);
        assertEquals(first, words.progress(begun, ""));
        var next = new StudyWork(StudyWork.Kind.STUDY, 1, 7, "midpoint", "");
        assertEquals(second, words.progress(next, "midpoint"));
    }
}
