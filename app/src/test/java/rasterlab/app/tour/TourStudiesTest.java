package rasterlab.app.tour;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.study.Study;
import rasterlab.engine.study.StudySettings;
import rasterlab.engine.transform.matrix.MatrixTopic;

class TourStudiesTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("steps")
    void topicIsMeasuredOnceAndThenSaidToBeShownAgain(Language language, List<String> steps) {
        var log = new ArrayList<String>();
        var studies =
                new TourStudies(StudySettings.shortest(), Texts.of("tour", language), log::add);
        Study first = studies.of(new MatrixTopic());
        assertEquals("matrix", first.topic());
        assertSame(first, studies.of(new MatrixTopic()));
        assertEquals(steps, log);
    }

    static Stream<Arguments> steps() {
        return Stream.of(
                argumentSet(
                        "a study that is shown again is said to be measured",
                        Language.ENGLISH,
                        List.of(
                                "measuring topic matrix",
                                "showing the study of topic matrix again")),
                argumentSet(
                        "the same in Russian",
                        Language.RUSSIAN,
                        List.of(
                                "измеряется тема matrix",
                                "ещё раз показывается исследование темы matrix")));
    }
}
