package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rasterlab.app.exercise.outcome.CaseResult;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Notice;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.language.Language;
import rasterlab.app.language.Texts;
import rasterlab.app.server.Account;
import rasterlab.app.server.FakeServer;

/** Handing in, to a server that behaves well and to others. */
@Tag("slow")
@Timeout(300)
class SubmittingTest {
    static final String SUBMIT = "POST /api/v1/exercises/line-bresenham/submissions";
    static final String RESULT = "GET /api/v1/submissions/s1";
    private static final String EVENTS = RESULT + "/events";
    private static final String CASE =
            "{\"name\":\"ties\",\"visibility\":\"open\",\"verdict\":\"wrong\",\"points\":0,\"of\":4,"
                    + "\"message\":\"pixel (1, 2) is missing\",\"pictures\":[],\"scene\":null}";
    static final String DONE =
            "{\"id\":\"s1\",\"attempt\":3,\"state\":\"done\",\"position\":0,\"verdict\":\"wrong\","
                    + "\"points\":{\"accuracy\":8,\"stability\":1,\"speed\":0,\"total\":9,\"of\":100},"
                    + "\"cases\":["
                    + CASE
                    + "],\"diagnostics\":[],\"isolation\":\"bubblewrap\"}";
    private static final String POSITION =
            "event: position\ndata: {\"position\":2,\"state\":\"queued\"}\n\n";

    /** A time longer than it takes to ask; each test that waits for it to pass takes so long. */
    private static final Duration SHORT = Duration.ofSeconds(3);

    @TempDir Path folder;

    static FakeServer server() throws IOException {
        String judged = "event: case\nid: 0\ndata: " + CASE + "\n\n";
        String all = POSITION + judged + "event: done\ndata: " + DONE + "\n\n";
        return new FakeServer()
                .on("POST /api/v1/join", 201, "{\"student\":\"x\",\"token\":\"secret\"}")
                .on(SUBMIT, 202, "{\"id\":\"s1\",\"state\":\"queued\",\"position\":2}")
                .on(RESULT, 200, DONE)
                .on(EVENTS, exchange -> events(exchange, all));
    }

    private static void events(HttpExchange exchange, String text) throws IOException {
        FakeServer.send(exchange, 200, "text/event-stream", text);
    }

    private Trial joined(FakeServer server) throws InterruptedException {
        var trial = new Trial(folder);
        trial.model.enrolment().join(server.address(), "CODE", "Ann");
        trial.awaitEnd();
        return trial;
    }

    /** One that has joined at leisure, and soon gives up to wait for an answer. */
    private Trial hasty(FakeServer server) throws InterruptedException {
        joined(server).close();
        var trial = new Trial(folder, SHORT);
        trial.await("the account is known", state -> state.account().isPresent());
        return trial;
    }

    @Test
    void followsASubmissionToItsResult() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            List<BackgroundWork.Phase> phases = new ArrayList<>();
            trial.model.listen(state -> phases.add(state.work().phase()));
            trial.model.submit();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals(3, outcome.attempt());
            assertEquals(9, outcome.points().total());
            assertEquals("pixel (1, 2) is missing", outcome.cases().get(0).message().english());
            assertTrue(phases.contains(BackgroundWork.Phase.WAITING), phases.toString());
            assertTrue(phases.contains(BackgroundWork.Phase.GRADING), phases.toString());
        }
    }

    @Test
    @DisplayName("a result of an exercise that has changed since passes for one of the present one")
    void anEarlierRevisionIsTakenOver() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            for (boolean current : List.of(true, false)) {
                String told = "{\"revision\":\"r0\",\"current\":" + current + ",";
                server.on(RESULT, 200, DONE.replaceFirst("[{]", told));
                trial.model.submit();
                assertEquals(!current, trial.awaitEnd().outcome().orElseThrow().earlier());
            }
        }
    }

    @Test
    @DisplayName("what is said of a hidden case is said of another one in Russian")
    void hiddenCasesAreToldApartInEachLanguage() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            server.on(
                    RESULT,
                    exchange -> {
                        String language = exchange.getRequestURI().getQuery();
                        String two = hidden("first " + language) + "," + hidden("next " + language);
                        FakeServer.send(exchange, 200, "application/json", DONE.replace(CASE, two));
                    });
            trial.model.submit();
            List<CaseResult> cases = trial.awaitEnd().outcome().orElseThrow().cases();
            assertEquals(
                    List.of("hidden 1", "hidden 2"), cases.stream().map(CaseResult::name).toList());
            assertEquals(new LocalizedText("next lang=en", "next lang=ru"), cases.get(1).message());
        }
    }

    @Test
    @DisplayName("a case that was not run has no result")
    void casesThatWereNotRunAreCalledSo() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            String notRun =
                    CASE.replace(
                            "\"verdict\":\"wrong\"", "\"verdict\":\"no_result\",\"run\":false");
            server.on(RESULT, 200, DONE.replace(CASE, notRun));
            trial.model.submit();
            CaseResult one = trial.awaitEnd().outcome().orElseThrow().cases().get(0);
            assertEquals("not_run", one.verdict());
        }
    }

    private static String hidden(String message) {
        return CASE.replace("ties", "hidden").replace("pixel (1, 2) is missing", message);
    }

    @Test
    void accountIsThereAgain() throws Exception {
        try (var server = server()) {
            try (var trial = joined(server)) {
                assertEquals("joined", trial.state().notice().key());
            }
            try (var again = new Trial(folder)) {
                Account account = again.state().account().orElseThrow();
                assertEquals(server.address(), account.toString());
                assertEquals("Ann", account.student());
            }
        }
    }

    @Test
    void serverThatIsDownIsTold() throws Exception {
        try (var trial = new Trial(folder)) {
            String nobody;
            try (var server = server()) {
                nobody = server.address();
            }
            trial.model.type("typed");
            trial.model.enrolment().join(nobody, "CODE", "Ann");
            var state = trial.awaitEnd();
            assertEquals(Notice.of("join.down", nobody), state.notice());
            assertEquals("typed", state.source());
        }
    }

    @Test
    void serverThatIsSlowIsTold() throws Exception {
        var end = new CountDownLatch(1);
        try (var server = server();
                var trial = hasty(server)) {
            server.on(SUBMIT, exchange -> hold(end));
            trial.model.submit();
            assertEquals("server.slow", trial.awaitEnd().notice().key());
            end.countDown();
        }
    }

    @Test
    @DisplayName("joining that takes too long is told as a submission")
    void slowJoiningIsToldAsSuch() throws Exception {
        var end = new CountDownLatch(1);
        try (var server = server();
                var trial = new Trial(folder, SHORT)) {
            server.on("POST /api/v1/join", exchange -> hold(end));
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            Notice notice = trial.awaitEnd().notice();
            end.countDown();
            assertEquals(Notice.of("join.slow", server.address()), notice);
            String english = notice.in(Texts.of("exercise", Language.ENGLISH));
            assertTrue(
                    english.endsWith("Joining the course was not finished; try again."), english);
            String russian = notice.in(Texts.of("exercise", Language.RUSSIAN));
            assertTrue(
                    russian.endsWith("Запись на курс не завершена; попробуйте ещё раз."), russian);
        }
    }

    @Test
    @DisplayName("a token that the server does not know takes the place of one that it does")
    void accountStaysWhereATokenIsNotKnown() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            Account before = trial.model.state().account().orElseThrow();
            server.on("GET /api/v1/exercises", 401, "{\"detail\":\"no\"}");
            trial.model.enrolment().signIn(server.address(), "made up");
            assertEquals("join.token", trial.awaitEnd().notice().key());
            assertEquals(Optional.of(before), trial.model.state().account());
            server.on("GET /api/v1/exercises", 200, "[]");
            trial.model.enrolment().signIn(server.address(), "ключ");
            assertEquals("join.token", trial.awaitEnd().notice().key());
            trial.model.enrolment().signIn(server.address(), " known ");
            assertEquals("joined", trial.awaitEnd().notice().key());
            assertEquals("known", trial.model.state().account().orElseThrow().token());
        }
    }

    @ParameterizedTest(name = "{2} is refused, but it is told at another field: {0}, {1}")
    @CsvSource({
        "404, unknown-course, CODE, join.code",
        "422, bad-name, NAME, join.name",
        "401, not-signed-in, TOKEN, join.token",
        "404, '', ADDRESS, server.refused"
    })
    void refusalIsToldAtItsField(int status, String code, JoinAnswer.JoinField field, String key)
            throws Exception {
        try (var server = server();
                var trial = new Trial(folder)) {
            String problem = "{\"type\":\"urn:rasterlab:problem:" + code + "\",\"detail\":\"no\"}";
            server.on("POST /api/v1/join", status, problem);
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            JoinAnswer answer = trial.awaitEnd().joining();
            assertEquals(field, answer.field());
            assertEquals(key, answer.problem().key());
            server.on("POST /api/v1/join", 201, "{\"student\":\"x\",\"token\":\"secret\"}");
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            assertEquals(JoinAnswer.JOINED, trial.awaitEnd().joining());
            trial.model.enrolment().askForCourse();
            assertEquals(JoinAnswer.NONE, trial.state().joining(), "another form closes at once");
        }
    }

    @Test
    void silentEventsAreTold() throws Exception {
        var end = new CountDownLatch(1);
        try (var server = server();
                var trial = hasty(server)) {
            server.on(EVENTS, exchange -> begunOnly(exchange, end));
            trial.model.submit();
            assertEquals("server.slow", trial.awaitEnd().notice().key());
            end.countDown();
        }
    }

    @Test
    void refusalIsToldInTheServersWords() throws Exception {
        try (var server = server();
                var trial = joined(server)) {
            server.on(SUBMIT, 413, "{\"detail\":\"the body may have at most 3 bytes\"}");
            trial.model.submit();
            Notice notice = trial.awaitEnd().notice();
            assertEquals("server.refused", notice.key());
            assertTrue(notice.arguments().contains("the body may have at most 3 bytes"));
            server.on(SUBMIT, 401, "{\"detail\":\"no\"}");
            trial.model.submit();
            assertEquals("server.token", trial.awaitEnd().notice().key());
        }
    }

    @Test
    void somethingElseThanAGradingServerIsTold() throws Exception {
        try (var server = server();
                var trial = new Trial(folder)) {
            server.on(
                    "POST /api/v1/join",
                    exchange -> FakeServer.send(exchange, 200, "text/html", "<html>hello"));
            trial.model.enrolment().join(server.address(), "CODE", "Ann");
            assertEquals("join.failed", trial.awaitEnd().notice().key());
        }
    }

    @Test
    void eventsThatBreakOffAreTakenUpAgain() throws Exception {
        var connections = new AtomicInteger();
        try (var server = server();
                var trial = joined(server)) {
            server.on(
                    RESULT,
                    200,
                    DONE.replace(
                            "\"verdict\":\"wrong\",\"points\":{", "\"verdict\":null,\"points\":{"));
            server.on(
                    EVENTS,
                    exchange -> {
                        if (connections.incrementAndGet() == 1) {
                            events(exchange, POSITION);
                            return;
                        }
                        server.on(RESULT, 200, DONE);
                        events(exchange, "event: done\ndata: " + DONE + "\n\n");
                    });
            trial.model.submit();
            assertEquals("wrong", trial.awaitEnd().outcome().orElseThrow().verdict());
            assertEquals(2, connections.get());
        }
    }

    @Test
    void cancelledFollowingIsTakenUpBySubmittingAgain() throws Exception {
        var end = new CountDownLatch(1);
        try (var server = server();
                var trial = joined(server)) {
            server.on(EVENTS, exchange -> begunOnly(exchange, end));
            trial.model.submit();
            trial.await("it waits", state -> state.work().phase() == BackgroundWork.Phase.WAITING);
            trial.model.cancel();
            assertEquals("cancelled.handedIn", trial.state().notice().key());
            end.countDown();
            server.on(EVENTS, exchange -> events(exchange, "event: done\ndata: {}\n\n"));
            trial.model.submit();
            trial.awaitEnd();
            trial.model.submit();
            trial.awaitEnd();
            List<String> keys =
                    server.asked.stream()
                            .filter(one -> one.path().endsWith("/submissions"))
                            .map(FakeServer.ReceivedRequest::key)
                            .toList();
            assertEquals(keys.get(0), keys.get(1), "the same submission");
            assertTrue(!keys.get(1).equals(keys.get(2)), "after its result, a new one");
        }
    }

    @Test
    void nothingIsSentWithoutAnAccount() {
        try (var trial = new Trial(folder)) {
            trial.model.submit();
            assertEquals("noAccount", trial.state().notice().key());
        }
    }

    @Test
    void wrongAddressIsToldWithoutCalling() {
        try (var trial = new Trial(folder)) {
            trial.state();
            trial.model.enrolment().join("ftp://x", "CODE", "Ann");
            assertEquals(Notice.of("server.address", "ftp://x"), trial.state().notice());
        }
    }

    @Test
    void accountThatCannotBeKeptStillServes() throws Exception {
        Files.createDirectories(folder.resolve("grader.properties").resolve("in the way"));
        try (var server = server();
                var trial = joined(server)) {
            assertEquals("account.unsaved", trial.state().notice().key());
            trial.model.submit();
            assertEquals("wrong", trial.awaitEnd().outcome().orElseThrow().verdict());
        }
    }

    private static void hold(CountDownLatch end) {
        try {
            end.await();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Sends the first event and nothing more. */
    private static void begunOnly(HttpExchange exchange, CountDownLatch end) throws IOException {
        exchange.getResponseHeaders().set("Content-Type", "text/event-stream");
        exchange.sendResponseHeaders(200, 0);
        exchange.getResponseBody().write(POSITION.getBytes(StandardCharsets.UTF_8));
        exchange.getResponseBody().flush();
        hold(end);
        exchange.close();
    }
}
