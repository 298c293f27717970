package rasterlab.app.exercise;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.sun.net.httpserver.HttpExchange;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rasterlab.app.exercise.outcome.LocalizedText;
import rasterlab.app.exercise.outcome.Outcome;
import rasterlab.app.exercise.outcome.ResultPicture;
import rasterlab.app.server.FakeServer;
import rasterlab.exercises.score.SpeedFigures;

/** Pictures, reasons and figures of what was handed in, as a server gives them. */
@Tag("slow")
@Timeout(300)
class SubmittedPicturesTest {
    @TempDir Path folder;

    private Trial joined(FakeServer server) throws InterruptedException {
        var trial = new Trial(folder);
        trial.model.enrolment().join(server.address(), "CODE", "Ann");
        trial.awaitEnd();
        return trial;
    }

    @Test
    @DisplayName("a picture of another kind is left out, or its text is in one language")
    void everyPictureIsTakenOverWithItsTexts() throws Exception {
        try (var server = SubmittingTest.server();
                var trial = joined(server)) {
            String url = "/api/v1/submissions/s1/cases/ties/";
            for (String kind : List.of("difference", "input"))
                server.on("GET " + url + kind + ".png", 200, kind);
            server.on(
                    "GET " + url + "input.png",
                    exchange -> {
                        boolean asked = exchange.getRequestURI().getQuery() != null;
                        FakeServer.send(
                                exchange, 200, "image/png", asked ? "input in Russian" : "input");
                    });
            server.on(SubmittingTest.RESULT, exchange -> drawn(exchange, "input", url));
            trial.model.submit();
            List<ResultPicture> pictures =
                    trial.awaitEnd().outcome().orElseThrow().cases().get(0).pictures();
            assertEquals(
                    List.of("difference #-", "input a dot|точка"),
                    pictures.stream().map(SubmittedPicturesTest::described).toList());
            for (ResultPicture one : pictures) assertEquals(one.kind(), content(one, "en"));
            assertEquals(
                    List.of("difference", "input in Russian"),
                    pictures.stream().map(one -> content(one, "ru")).toList());
        }
    }

    private static String content(ResultPicture one, String language) {
        return new String(one.file().in(language), StandardCharsets.UTF_8);
    }

    private static String described(ResultPicture one) {
        LocalizedText text = one.text();
        boolean same = text.english().equals(text.russian());
        return one.kind() + " " + text.english() + (same ? "" : "|" + text.russian());
    }

    private static void drawn(HttpExchange exchange, String kind, String url) throws IOException {
        boolean english = exchange.getRequestURI().getQuery().equals("lang=en");
        String list =
                """
                [{"kind": "difference", "url": "%sdifference.png", "text": "#-", "part": null},
                 {"kind": "%s", "url": "%sinput.png%s", "text": "%s", "part": null}]"""
                        .formatted(
                                url,
                                kind,
                                url,
                                english ? "" : "?lang=ru",
                                english ? "a dot" : "точка");
        String told = SubmittingTest.DONE.replace("\"pictures\":[]", "\"pictures\":" + list);
        FakeServer.send(exchange, 200, "application/json", told);
    }

    @Test
    @DisplayName("a kind that no server of ours gives is shown in the window as it is")
    void aKindThatIsNoNameIsRefused() throws Exception {
        try (var server = SubmittingTest.server();
                var trial = joined(server)) {
            server.on(SubmittingTest.RESULT, exchange -> drawn(exchange, "<html>x", "/api/v1/"));
            server.on("GET /api/v1/difference.png", 200, "x");
            trial.model.submit();
            assertEquals(Optional.empty(), trial.awaitEnd().outcome());
        }
    }

    @Test
    @DisplayName("what the deadline opened, or the point on the chart, is lost on the way")
    void whatTheServerTellsBesideTheVerdictIsTakenOver() throws Exception {
        try (var server = SubmittingTest.server();
                var trial = joined(server)) {
            String speed =
                    "{\"ratio\":1.25,\"nanos\":2.5,\"reference\":2,\"error\":null,\"fullUpTo\":1.5,"
                            + "\"noneAbove\":8,\"item\":\"pixel\",\"errorUnit\":\"pixels\","
                            + "\"methods\":[{\"name\":\"dda\",\"ratio\":3,\"error\":0.5}]}";
            String done =
                    SubmittingTest.DONE.replace(
                            "\"scene\":null", "\"scene\":null,\"why\":\"it is rare\"");
            server.on(
                    SubmittingTest.RESULT,
                    200,
                    done.replaceFirst("[{]", "{\"speed\":" + speed + ","));
            trial.model.submit();
            Outcome outcome = trial.awaitEnd().outcome().orElseThrow();
            assertEquals(
                    new LocalizedText(
                            "pixel (1, 2) is missing\nWhy this case is there: it is rare.",
                            "pixel (1, 2) is missing\nЗачем этот тест: it is rare."),
                    outcome.cases().get(0).message());
            assertEquals(
                    new SpeedFigures(
                            2.5,
                            2,
                            Double.POSITIVE_INFINITY,
                            List.of(new SpeedFigures.MethodSpeed("dda", 3, 0.5))),
                    outcome.speed().orElseThrow().figures());
        }
    }
}
