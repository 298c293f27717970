package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.Topics;

class StudyWordsTest {
    @ParameterizedTest(name = "a topic's item or unit has no words in {0}")
    @EnumSource
    void everyTopicsItemAndUnitHaveWords(Language language) {
        Texts texts = Texts.of("study", language);
        List<String> missing =
                Topics.all().stream()
                        .flatMap(
                                topic ->
                                        List.of(
                                                StudyWords.itemKey(topic.item()),
                                                StudyWords.unitKey(topic.errorUnit()))
                                                .stream())
                        .filter(key -> !texts.has(key))
                        .toList();
        assertEquals(List.of(), missing);
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
