package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.swing.JButton;
import javax.swing.JTextArea;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.panel.HintRow;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.server.FakeServer;
import rasterlab.exercises.Exercise;

/** Hints come step by step: from the server with their cost, without one for practice. */
@Tag("slow")
@Timeout(300)
class HintsTest {
    private static final String HINTS = "/api/v1/exercises/line-bresenham/hints";

    @TempDir Path folder;

    private static FakeServer server(int taken) throws IOException {
        return showing(SubmittingTest.server(), taken);
    }

    /** Has shown so many hints, whose cost is ten times their number. */
    private static FakeServer showing(FakeServer server, int taken) {
        var texts = new StringBuilder();
        for (int step = 1; step <= taken; step++)
            texts.append(step > 1 ? "," : "")
                    .append(
                            "{\"step\":%1$d,\"cost\":%1$d0,\"text\":\"look %1$d\"}"
                                    .formatted(step));
        String next = taken < 3 ? "{\"step\":%1$d,\"cost\":%1$d0}".formatted(taken + 1) : "null";
        String json = "{\"steps\":3,\"taken\":[" + texts + "],\"next\":" + next + "}";
        return server.on("GET " + HINTS, 200, json)
                .on(
                        "POST " + HINTS,
                        exchange -> {
                            showing(server, taken + 1);
                            FakeServer.send(exchange, 201, "application/json", json);
                        });
    }

    private Trial joined(FakeServer server) throws InterruptedException {
        var trial = new Trial(folder);
        trial.model.enrolment().join(server.address(), "CODE", "Ann");
        trial.awaitEnd();
        return trial;
    }

    private static void press(Trial trial) throws InterruptedException {
        trial.model.takeHint();
        trial.await("the server answers", state -> !trial.model.hintDesk().asking());
    }

    private static String button(Trial trial, Language language) {
        return part(trial, language, JButton.class).getText();
    }

    private static String words(Trial trial) {
        return part(trial, Language.ENGLISH, JTextArea.class).getText();
    }

    private static <T> T part(Trial trial, Language language, Class<T> type) {
        var row = new HintRow(Texts.of("exercise", language), () -> {});
        row.show(
                trial.model.hints(),
                trial.model.hintDesk().asking(),
                trial.model.hintDesk().notice());
        for (var part : row.getComponents()) if (type.isInstance(part)) return type.cast(part);
        throw new AssertionError("no " + type);
    }

    private static List<String> shown(Trial trial) {
        return trial.model.hints().shown().stream().map(LocalizedText::english).toList();
    }

    @Test
    @DisplayName("without a course hints are not shown in order, or not said to be practice")
    void practiceIsNotCounted() {
        try (var trial = new Trial(folder)) {
            Exercise exercise = trial.state().exercise();
            assertEquals(List.of(), shown(trial));
            assertEquals("Hint 1 of 3 (not counted)", button(trial, Language.ENGLISH));
            assertTrue(words(trial).startsWith("Practice: hints are not counted"), words(trial));
            trial.model.takeHint();
            trial.model.takeHint();
            assertEquals(
                    exercise.hints().subList(0, 2).stream().map(one -> one.text("en")).toList(),
                    shown(trial));
            assertEquals("Подсказка 3 из 3 (не в счёт)", button(trial, Language.RUSSIAN));
            trial.model.choose("circle");
            assertEquals(List.of(), shown(trial));
            trial.model.choose(exercise.id());
            trial.model.takeHint();
            trial.model.takeHint();
            assertEquals(3, shown(trial).size());
        }
    }

    @Test
    @DisplayName(
            "a hint is taken before its cost is said, or what was taken elsewhere is not shown")
    void theServerSaysTheCostFirst() throws Exception {
        try (var server = server(1);
                var trial = joined(server)) {
            assertEquals("Hints…", button(trial, Language.ENGLISH));
            press(trial);
            assertEquals(List.of("look 1"), shown(trial));
            assertTrue(server.asked.stream().noneMatch(one -> one.path().equals(HINTS)));
            assertEquals("Hint 2 of 3 (costs 20 points)", button(trial, Language.ENGLISH));
            assertEquals("Подсказка 2 из 3 (баллов: −20)", button(trial, Language.RUSSIAN));
            press(trial);
            assertEquals(List.of("look 1", "look 2"), shown(trial));
            press(trial);
            assertEquals(3, shown(trial).size());
            assertEquals("All hints are shown, below the statement.", words(trial));
            List<String> keys =
                    server.asked.stream()
                            .filter(one -> one.path().equals(HINTS))
                            .map(FakeServer.ReceivedRequest::key)
                            .toList();
            assertEquals(2, keys.size());
            assertNotEquals(keys.get(0), keys.get(1), "the second hint is asked for as the first");
        }
    }

    @Test
    @DisplayName("a hint whose text was lost on the way is asked for as another one")
    void aLostAnswerIsAskedForAgain() throws Exception {
        try (var server = server(0);
                var trial = joined(server)) {
            press(trial);
            server.on("POST " + HINTS, 201, "{}")
                    .on("GET " + HINTS, 503, "{\"detail\":\"not now\"}");
            press(trial);
            assertTrue(words(trial).contains("not now"), words(trial));
            assertEquals(List.of(), shown(trial));
            showing(server, 1).on("POST " + HINTS, 201, "{}");
            press(trial);
            assertEquals(List.of("look 1"), shown(trial));
            List<String> keys =
                    server.asked.stream()
                            .filter(one -> one.path().equals(HINTS))
                            .map(FakeServer.ReceivedRequest::key)
                            .distinct()
                            .toList();
            assertEquals(1, keys.size());
        }
    }

    @Test
    @DisplayName("it is not said why there is no hint")
    void complaintsAreSaid() throws Exception {
        try (var server = server(0);
                var trial = joined(server)) {
            press(trial);
            server.on("POST " + HINTS, 409, problem("no-more-hints"));
            press(trial);
            assertTrue(words(trial).startsWith("There are no more hints"), words(trial));
            server.on("POST " + HINTS, 404, problem("unknown-exercise"));
            press(trial);
            assertTrue(words(trial).contains("has no such exercise"), words(trial));
            server.on("POST " + HINTS, 401, problem("not-signed-in"));
            press(trial);
            assertTrue(words(trial).contains("does not know the token"), words(trial));
            trial.model.choose("circle");
            assertTrue(words(trial).startsWith("The server tells"), words(trial));
        }
    }

    private static String problem(String code) {
        return "{\"type\":\"urn:rasterlab:problem:" + code + "\",\"detail\":\"no\"}";
    }

    @Test
    @DisplayName("the window shows more points than the server counts")
    void theResultHasLessPoints() throws Exception {
        String paid = SubmittingTest.DONE.replace("\"total\":9", "\"hints\":2,\"total\":7");
        try (var server = server(0).on(SubmittingTest.RESULT, 200, paid);
                var trial = joined(server)) {
            trial.model.submit();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals(2, outcome.hints());
            assertEquals(7, outcome.total());
        }
    }
}
