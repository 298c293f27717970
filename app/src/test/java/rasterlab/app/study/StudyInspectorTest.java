package rasterlab.app.study;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rasterlab.app.canvas.lab.NotShown;
import rasterlab.app.canvas.lab.OpenInLab;
import rasterlab.app.canvas.method.VerdictDetail;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.engine.clip.segment.SegmentClipTopic;
import rasterlab.engine.line.LineTopic;
import rasterlab.engine.raster.Plotted;
import rasterlab.engine.study.HazardTrial;
import rasterlab.exercises.predicting.HandedAnswers;

@Timeout(300)
class StudyInspectorTest {
    private static final OpenInLab NOWHERE =
            new OpenInLab() {
                @Override
                public Optional<NotShown> obstacleTo(String topic, String hazard) {
                    return Optional.of(NotShown.NO_TAB);
                }

                @Override
                public void showHazard(String topic, String hazard, String method) {}

                @Override
                public boolean handsIn(String topic) {
                    return false;
                }

                @Override
                public boolean asksSteps(String topic) {
                    return false;
                }

                @Override
                public void answerSteps(String exercise, HandedAnswers begun) {}

                @Override
                public void showToHandIn(String exercise, String topic, String json) {}

                @Override
                public Optional<NotShown> obstacleToOwn(String topic) {
                    return Optional.of(NotShown.NO_OWN);
                }

                @Override
                public void showOwn(String topic, String json, String beside) {}

                @Override
                public Optional<NotShown> obstacleToInputs(String topic) {
                    return Optional.of(NotShown.NO_TAB);
                }

                @Override
                public void showInput(
                        String topic, String json, String method, Optional<Plotted> drawn) {}
            };

    @ParameterizedTest(name = "nothing says what the signs of the chosen cell''s table mean: {0}")
    @EnumSource
    void meaningOfTheSignsStays(Language language) {
        List<Throwable> failures = new ArrayList<>();
        Texts texts = Texts.of("study", language);
        try (var model =
                new StudyLabModel(List.of(new LineTopic()), Runnable::run, failures::add)) {
            var inspector = new StudyInspector(model, texts, NOWHERE, () -> {});
            model.show(StudyView.HAZARDS);
            inspector.refresh();
            assertExplained(shown(inspector));
            model.choose("steep", "bresenham");
            inspector.refresh();
            assertExplained(shown(inspector));
            model.show(StudyView.CHART);
            inspector.refresh();
            assertFalse(shown(inspector).contains("✗"), "signs beside the chart");
        }
        assertEquals(List.of(), failures);
    }

    @ParameterizedTest(name = "the method that is explained has no name: {0}")
    @EnumSource
    void methodIsExplainedBelowItsName(Language language) {
        List<Throwable> failures = new ArrayList<>();
        Texts texts = Texts.of("study", language);
        try (var model =
                new StudyLabModel(List.of(new LineTopic()), Runnable::run, failures::add)) {
            var inspector = new StudyInspector(model, texts, NOWHERE, () -> {});
            model.show(StudyView.HAZARDS);
            model.choose("steep", "midpoint");
            inspector.refresh();
            String shown = shown(inspector);
            assertTrue(shown.matches("(?s).*<b>[^<]*</b>\\s+midpoint\\s.*"), shown);
        }
        assertEquals(List.of(), failures);
    }

    @Test
    @DisplayName("a refusal or a deviation is told in English beside its cell")
    void detailIsSaidInTheWindowsLanguage() throws Exception {
        List<Throwable> failures = new CopyOnWriteArrayList<>();
        var tried = new CountDownLatch(1);
        try (var model =
                new StudyLabModel(List.of(new SegmentClipTopic()), Runnable::run, failures::add)) {
            model.listen(
                    state -> {
                        if (!state.work().running() && !state.cells().isEmpty()) tried.countDown();
                    });
            model.tryHazards();
            tried.await();
            var inspector =
                    new StudyInspector(
                            model, Texts.of("study", Language.RUSSIAN), NOWHERE, () -> {});
            model.show(StudyView.HAZARDS);
            for (HazardTrial.VerdictCell cell : model.state().cells()) {
                String detail = cell.verdict().detail();
                model.choose(cell.hazard(), cell.method());
                inspector.refresh();
                String shown = shown(inspector);
                assertTrue(
                        shown.contains(VerdictDetail.translated(Language.RUSSIAN, detail)), shown);
            }
        }
        assertEquals(List.of(), failures);
    }

    @Test
    void signOfAVerdictIsNotThatOfNoValue() {
        for (VerdictSign sign : VerdictSign.values()) assertNotEquals("–", sign.sign());
    }

    private static void assertExplained(String shown) {
        for (VerdictSign sign : VerdictSign.values())
            assertTrue(shown.contains(sign.sign() + " "), sign + " is not in: " + shown);
    }

    private static String shown(StudyInspector inspector) {
        return String.join("\n", texts(inspector.column()).toList());
    }

    private static Stream<String> texts(Component place) {
        if (!place.isVisible()) return Stream.empty();
        if (place instanceof JTextComponent words) return Stream.of(words.getText());
        return place instanceof Container all
                ? Stream.of(all.getComponents()).flatMap(StudyInspectorTest::texts)
                : Stream.empty();
    }
}
